// SPDX-License-Identifier: MIT
// Addresses as users write them, what is said of wrong ones, tokens, and the list of engines that run. The other end is
// the real wire library without an engine.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <arpa/inet.h>
#include <doctest/doctest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "spear/spear.hpp"
#include "spear_wire.h"

using namespace spear;
using namespace std::chrono_literals;

namespace {

/// A folder of its own, removed at the end.
struct Folder {
    std::filesystem::path path;
    Folder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "spear-address-XXXXXX").string();
        path = ::mkdtemp(pattern.data());
    }
    ~Folder() { std::filesystem::remove_all(path); }
};

/// A server that admits everybody who may come; null if it could not listen, and then `error` says why.
struct Server {
    spear_server* server = nullptr;
    spear_wire_error error{};

    explicit Server(const std::string& address, const std::string& token = {}, const std::string& registry = {}) {
        spear_server_callbacks callbacks{};
        callbacks.connect = [](void*, const spear_hello*, spear_wire_error*) { return 1; };
        callbacks.disconnect = [](void*, std::uint64_t, const char*) {};
        callbacks.submit = [](void*, std::uint64_t, std::uint64_t, const spear_batch*) {};
        callbacks.status = [](void*, std::uint64_t, spear_status*) {};
        callbacks.describe = [](void*, spear_description* description) { description->frame = 42; };
        spear_server_options options{};
        options.address = address.c_str();
        options.token = reinterpret_cast<const std::uint8_t*>(token.data());
        options.token_size = token.size();
        options.spear_version = version.data();
        options.registry_directory = registry.empty() ? "/nonexistent" : registry.c_str();
        server = spear_server_start(&options, &callbacks, &error);
    }
    ~Server() {
        if (server)
            spear_server_stop(server);
    }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    std::string address() const { return spear_server_address(server); }
    std::string port() const { return address().substr(address().rfind(':') + 1); }
    std::string text() const { return error.message; }
};

std::string why_not(const std::string& address, const std::string& token = {}) {
    try {
        Session::connect({.address = address, .token = token});
    } catch (const Error& error) {
        return std::string(error.name()) + ": " + error.what();
    }
    return "connected";
}

bool has(const std::string& text, std::string_view part) {
    INFO(text);
    const bool found = text.find(part) != std::string::npos;
    CHECK(found);
    return found;
}

/// Whether this machine has ::1; containers may be without.
bool has_ipv6_loopback() {
    const int probe = ::socket(AF_INET6, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in6 where{};
    where.sin6_family = AF_INET6;
    where.sin6_addr = in6addr_loopback;
    const bool works = probe >= 0 && ::bind(probe, reinterpret_cast<const sockaddr*>(&where), sizeof(where)) == 0;
    if (probe >= 0)
        ::close(probe);
    return works;
}

/// Longer than the name of a host may be: known to be wrong without asking a name server, which may be slow.
const std::string no_host(70, 'x');

std::vector<std::string> listed(const std::filesystem::path& folder) {
    std::vector<std::string> addresses;
    spear_list_engines(folder.c_str(), &addresses, [](void* user, const char* address, std::uint64_t) {
        static_cast<std::vector<std::string>*>(user)->emplace_back(address);
    });
    return addresses;
}

} // namespace

TEST_CASE("addresses in every spelling reach the same server") {
    const Folder folder;
    const Server by_path("unix:" + (folder.path / "a.sock").string());
    REQUIRE(by_path.server);
    CHECK(Session::connect({.address = by_path.address()})->is_open());
    CHECK(Session::connect({.address = "unix://" + (folder.path / "a.sock").string()})->is_open());

    const Server by_port("tcp://127.0.0.1:0");
    REQUIRE(by_port.server);
    CHECK(by_port.port() != "0");
    for (const char* const spelling : {"tcp://127.0.0.1:", "tcp:127.0.0.1:", "tcp://localhost:"})
        CHECK(Session::connect({.address = spelling + by_port.port()})->is_open());
}

TEST_CASE("IPv6 loopback") {
    if (!has_ipv6_loopback())
        return;
    const Server server("tcp://[::1]:0");
    INFO(server.text());
    REQUIRE(server.server);
    CHECK(server.address() == "tcp://[::1]:" + server.port());
    CHECK(Session::connect({.address = server.address()})->is_open());
    has(Server(server.address()).text(), "is in use");
}

TEST_CASE("what is no address is refused with what would be one") {
    for (const auto& [text, part] : std::vector<std::pair<std::string, std::string>>{
             {"http://localhost:1", "neither unix: nor tcp:"},
             {"unix:", "the path is empty"},
             {"unix:/" + std::string(200, 'x'), "longer than"},
             {"tcp://localhost", "the port is missing"},
             {"tcp://:5", "the host is empty"},
             {"tcp://localhost:", "the port is not a number"},
             {"tcp://localhost:65536", "the port is not a number from 0 to 65535"},
             {"tcp://localhost:-1", "the port is not a number"},
             {"tcp://localhost:5x", "the port is not a number"},
             {"tcp://::1:5005", "stands in brackets"},
             {"tcp://127.0.0.1:0", "no port to connect to"},
         }) {
        const std::string error = why_not(text);
        has(error, "ConnectionError: '" + text + "'");
        has(error, part);
    }
    const std::string error = why_not("tcp://" + no_host + ":5005");
    has(error, "EngineNotRunning");
    has(error, "the host '" + no_host + "' is not known");
}

TEST_CASE("a server that cannot listen says why") {
    const Server first("tcp://127.0.0.1:0");
    REQUIRE(first.server);
    has(Server(first.address()).text(), "port " + first.port() + " is in use");
    has(Server("tcp://" + no_host + ":0", "token").text(), "is not known");
    has(Server("tcp://192.0.2.1:0", "token").text(),
        "none of this machine's addresses"); // an address for documentation
    const Folder folder;
    std::ofstream(folder.path / "file") << "no socket";
    has(Server("unix:" + (folder.path / "file").string()).text(), "no socket");
    const Server socket("unix:" + (folder.path / "b.sock").string());
    has(Server(socket.address()).text(), "another engine serves there");
    has(Server("unix:" + (folder.path / "none" / "c.sock").string()).text(), "No such file or directory");
}

TEST_CASE("what other machines can reach needs a token") {
    has(Server("tcp://0.0.0.0:0").text(), "needs a token");
    has(Server("tcp://127.0.0.1.example.com:0").text(), "needs a token"); // a name that only looks like loopback
    const Server open("tcp://0.0.0.0:0", "secret");
    INFO(open.text());
    REQUIRE(open.server);
    const std::string address = "tcp://127.0.0.1:" + open.port();
    CHECK(why_not(address, "secret") == "connected");
    for (const char* const wrong : {"", "secre", "secrets", "Secret"})
        has(why_not(address, wrong), "Unauthorized");
    CHECK(spear_address_is_local("unix:/a") == 1);
    CHECK(spear_address_is_local("tcp://127.1.2.3:4") == 1);
    CHECK(spear_address_is_local("tcp://0.0.0.0:4") == 0);
    CHECK(spear_address_is_local("tcp://[::]:4") == 0);
}

TEST_CASE("running engines are listed whatever they listen at; entries of killed ones are cleaned") {
    const Folder folder;
    const auto entry = [&](const std::string& name, const std::string& text) {
        std::ofstream(folder.path / name) << text;
        return folder.path / name;
    };
    const auto dead = entry("engine-999999999.json", R"({"address":"unix:/dead","pid":999999999})");
    // This process's number, begun at another time: an engine had the number before.
    const auto reused = entry(
        "engine-reused.json", R"({"address":"unix:/reused","pid":)" + std::to_string(::getpid()) + R"(,"started":1})");
    entry("engine-broken.json", "{");
    {
        const Server server("tcp://127.0.0.1:0", {}, folder.path.string());
        REQUIRE(server.server);
        CHECK(listed(folder.path) == std::vector{server.address()});
        CHECK_FALSE(std::filesystem::exists(dead));
        CHECK_FALSE(std::filesystem::exists(reused));
        spear_description description{};
        spear_wire_error error{};
        CHECK(spear_describe(server.address().c_str(), 5000, &description, &error) == 0);
        CHECK(description.frame == 42);
    }
    CHECK(listed(folder.path).empty());
}
