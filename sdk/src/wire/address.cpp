// SPDX-License-Identifier: MIT
#include "address.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace spear::wire {

std::string Address::text() const {
    switch (kind) {
    case Kind::unix_path:
        return "unix:" + path;
    case Kind::unix_abstract:
        return "unix:@" + path;
    case Kind::tcp:
        break;
    }
    const bool is_v6 = host.find(':') != std::string::npos;
    return "tcp://" + (is_v6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

std::string Address::kj_text() const {
    switch (kind) {
    case Kind::unix_path:
        return "unix:" + path;
    case Kind::unix_abstract:
        return "unix-abstract:" + path;
    case Kind::tcp:
        break;
    }
    return text().substr(std::strlen("tcp://"));
}

bool Address::is_local() const {
    in_addr v4{};
    in6_addr v6{};
    if (kind != Kind::tcp || host == "localhost") {
        return true;
    }
    if (::inet_pton(AF_INET, host.c_str(), &v4) == 1) {
        return (ntohl(v4.s_addr) >> 24) == 127;
    }
    return ::inet_pton(AF_INET6, host.c_str(), &v6) == 1 && IN6_IS_ADDR_LOOPBACK(&v6);
}

void fill_error(spear_wire_error* error, ErrorCode code, std::string_view message) {
    if (error) {
        error->code = static_cast<std::uint16_t>(code);
        const std::size_t size = std::min(message.size(), sizeof(error->message) - 1);
        std::memcpy(error->message, message.data(), size);
        error->message[size] = 0;
    }
}

bool parse_address(std::string_view text, Address& address, spear_wire_error* error) {
    const auto refuse = [&](std::string_view why) {
        fill_error(error, ErrorCode::ConnectionError,
            "'" + std::string(text) + "' is no address: " + std::string(why) +
                ". Use unix:/path/to/socket or tcp://host:port.");
        return false;
    };
    if (text.rfind("unix:", 0) == 0) {
        std::string_view path = text.substr(5);
        if (path.rfind("///", 0) == 0) { // as a URL
            path.remove_prefix(2);
        }
        const bool is_abstract = !path.empty() && path[0] == '@';
        if (is_abstract) {
            path.remove_prefix(1);
        }
        if (path.empty()) {
            return refuse("the path is empty");
        }
        if (path.size() >= sizeof(sockaddr_un::sun_path) - 1) {
            return refuse(
                "the path is longer than the system's " + std::to_string(sizeof(sockaddr_un::sun_path) - 2) + " bytes");
        }
        address.kind = is_abstract ? Address::Kind::unix_abstract : Address::Kind::unix_path;
        address.path = std::string(path);
        return true;
    }
    if (text.rfind("tcp:", 0) == 0) {
        const std::string_view rest = text.substr(text.rfind("tcp://", 0) == 0 ? 6 : 4);
        const std::size_t colon = rest.rfind(':');
        if (colon == std::string_view::npos) {
            return refuse("the port is missing");
        }
        std::string_view host = rest.substr(0, colon);
        const std::string_view port = rest.substr(colon + 1);
        if (host.size() >= 2 && host.front() == '[' && host.back() == ']') {
            host = host.substr(1, host.size() - 2);
        } else if (host.find(':') != std::string_view::npos) {
            return refuse("an IPv6 host stands in brackets, as in tcp://[::1]:5005");
        }
        const auto [end, failure] = std::from_chars(port.data(), port.data() + port.size(), address.port);
        if (host.empty() || port.empty() || failure != std::errc() || end != port.data() + port.size()) {
            return refuse(host.empty() ? "the host is empty" : "the port is not a number from 0 to 65535");
        }
        address.kind = Address::Kind::tcp;
        address.host = std::string(host);
        return true;
    }
    return refuse("it starts with neither unix: nor tcp:");
}

namespace {

bool is_alive(const sockaddr* where, socklen_t size) {
    const int probe = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const bool alive = probe >= 0 && ::connect(probe, where, size) == 0;
    if (probe >= 0) {
        ::close(probe);
    }
    return alive;
}

int listen_unix(const Address& address, spear_wire_error* error) {
    sockaddr_un where{};
    where.sun_family = AF_UNIX;
    const bool is_abstract = address.kind == Address::Kind::unix_abstract;
    std::memcpy(where.sun_path + (is_abstract ? 1 : 0), address.path.data(), address.path.size());
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + address.path.size() + 1);
    const auto* generic = reinterpret_cast<const sockaddr*>(&where);
    const auto fail = [&](const char* what, int socket) {
        fill_error(error, ErrorCode::ConnectionError,
            "Cannot listen at " + address.text() + ": " + what + ": " + std::strerror(errno) + ".");
        if (socket >= 0) {
            ::close(socket);
        }
        return -1;
    };
    struct stat info{};
    if (!is_abstract && ::stat(address.path.c_str(), &info) == 0) {
        if (!S_ISSOCK(info.st_mode)) {
            errno = EEXIST;
            return fail("there is a file that is no socket", -1);
        }
        if (is_alive(generic, size)) {
            errno = EADDRINUSE;
            return fail("another engine serves there", -1);
        }
        ::unlink(address.path.c_str()); // left over from a process that was killed
    }
    const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (socket < 0) {
        return fail("socket", -1);
    }
    if (::bind(socket, generic, size) != 0) {
        return fail("bind", socket);
    }
    // Nobody can connect before listen(), so there is no moment with wider permissions.
    if (!is_abstract && ::chmod(address.path.c_str(), 0600) != 0) {
        return fail("chmod", socket);
    }
    if (::listen(socket, 64) != 0) {
        return fail("listen", socket);
    }
    return socket;
}

int listen_tcp(Address& address, spear_wire_error* error) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_NUMERICSERV;
    addrinfo* found = nullptr;
    const auto fail = [&](const std::string& why) {
        fill_error(error, ErrorCode::ConnectionError, "Cannot listen at " + address.text() + ": " + why + ".");
        return -1;
    };
    if (const int failure = ::getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &found);
        failure != 0) {
        return fail("the host '" + address.host + "' is not known: " + ::gai_strerror(failure));
    }
    int socket = -1;
    for (const addrinfo* at = found; at && socket < 0; at = at->ai_next) {
        socket = ::socket(at->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
        const int one = 1;
        if (socket >= 0) { // accepted connections inherit it: an answer never waits for more to send
            ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &one, sizeof(one));
        }
        if (socket >= 0 && (::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &one, sizeof(one)) != 0 ||
                               ::bind(socket, at->ai_addr, at->ai_addrlen) != 0 || ::listen(socket, 64) != 0)) {
            const int reason = errno;
            ::close(socket);
            socket = -1;
            errno = reason;
        }
    }
    ::freeaddrinfo(found);
    if (socket < 0) {
        return fail(errno == EADDRINUSE
                        ? "port " + std::to_string(address.port) +
                              " is in use: another engine or program listens there. Give another port, or 0 for any"
                    : errno == EADDRNOTAVAIL ? "the host '" + address.host + "' is none of this machine's addresses"
                    : errno == EACCES        ? "ports below 1024 are for the system"
                                             : std::strerror(errno));
    }
    sockaddr_storage bound{};
    socklen_t size = sizeof(bound);
    if (::getsockname(socket, reinterpret_cast<sockaddr*>(&bound), &size) == 0) {
        address.is_loopback = bound.ss_family == AF_INET6
                                  ? IN6_IS_ADDR_LOOPBACK(&reinterpret_cast<sockaddr_in6*>(&bound)->sin6_addr) != 0
                                  : ntohl(reinterpret_cast<sockaddr_in*>(&bound)->sin_addr.s_addr) >> 24 == 127;
        address.port = ntohs(bound.ss_family == AF_INET6 ? reinterpret_cast<sockaddr_in6*>(&bound)->sin6_port
                                                         : reinterpret_cast<sockaddr_in*>(&bound)->sin_port);
    }
    return socket;
}

} // namespace

int listen_at(Address& address, spear_wire_error* error) {
    return address.kind == Address::Kind::tcp ? listen_tcp(address, error) : listen_unix(address, error);
}

} // namespace spear::wire
