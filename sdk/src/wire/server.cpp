// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <unordered_map>
#include <vector>

#include <csignal>
#include <pthread.h>
#include <unistd.h>

#include <capnp/rpc-twoparty.h>
#include <kj/async-io.h>
#include <kj/debug.h>

#include "address.hpp"
#include "loop_queue.hpp"
#include "registry.hpp"
#include "server_channels.hpp"
#include "spear.capnp.h"
#include "spear/limits.hpp"
#include "spear_trace.h"
#include "spear_wire.h"

namespace spear::wire {
namespace {

using Text = std::string;

capnp::Data::Reader as_data(const std::vector<uint8_t>& bytes) {
    return capnp::Data::Reader(bytes.data(), bytes.size());
}
spear_bytes as_bytes(capnp::Data::Reader data) { return {data.begin(), data.size()}; }
template <std::size_t N>
kj::StringPtr as_text(const char (&buffer)[N]) {
    return kj::StringPtr(buffer, strnlen(buffer, N - 1));
}

/// Gives a batch to the engine's queue.
void deliver_batch(
    const spear_server_callbacks& callbacks, std::uint64_t session, std::uint64_t request, const spear_batch& batch) {
    const TraceSpan span(SPEAR_TRACE_RECEIVE, session, batch.transaction, batch.block);
    callbacks.submit(callbacks.user, session, request, &batch);
    trace_moment(SPEAR_TRACE_QUEUED, session, batch.transaction, batch.block);
}

/// Answers on their way from the game thread to the loop.
struct Reply {
    std::vector<uint8_t> types;
    std::vector<uint8_t> answers;
    std::uint64_t frame = 0;
    bool has_error = false;
    std::uint16_t error_code = 0;
    Text error_message;
};

class ServerLoop;
using ConnectContext = capnp::CallContext<protocol::Gateway::ConnectParams, protocol::Gateway::ConnectResults>;

/// One admitted client. Lives in ServerLoop::sessions_ until it ends; server thread only.
struct SessionState {
    using SubmitContext = capnp::CallContext<protocol::Session::SubmitParams, protocol::Session::SubmitResults>;
    struct Pending {
        SubmitContext context;
        kj::Own<kj::PromiseFulfiller<void>> done;
    };
    std::uint64_t id = 0;
    std::uint64_t connection = 0;
    std::uint32_t lease_ms = 0;
    kj::TimePoint last_sign = kj::origin<kj::TimePoint>();
    std::unordered_map<std::uint64_t, Pending> pending; // by request
    std::shared_ptr<ServerChannel> offered;             // until the client has answered
    bool has_channel = false;
    TrafficCounter received, sent; // by RPC
    std::vector<kj::Own<kj::PromiseFulfiller<void>>> told_of_end;
    kj::Promise<void> lease_watch = nullptr; // goes with the session, so that no timer outlives it
};

/// The capability that a client holds. It may outlive its session: then every call fails.
class SessionServer final : public protocol::Session::Server {
public:
    SessionServer(ServerLoop& loop, std::shared_ptr<const bool> loop_lives, std::uint64_t id)
        : loop_(loop), loop_lives_(std::move(loop_lives)), id_(id) {}
    ~SessionServer() noexcept(false);
    kj::Promise<void> submit(SubmitContext context) override;
    kj::Promise<void> renew(RenewContext context) override;
    kj::Promise<void> status(StatusContext context) override;
    kj::Promise<void> close(CloseContext context) override;
    kj::Promise<void> offerChannel(OfferChannelContext context) override;
    kj::Promise<void> openChannel(OpenChannelContext context) override;
    kj::Promise<void> ended(EndedContext context) override;

private:
    ServerLoop& loop_;
    std::shared_ptr<const bool> loop_lives_; // the event loop drops its last capabilities after ServerLoop
    std::uint64_t id_;
};

class GatewayServer final : public protocol::Gateway::Server {
public:
    GatewayServer(ServerLoop& loop, std::uint64_t connection) : loop_(loop), connection_(connection) {}
    kj::Promise<void> connect(ConnectContext context) override;
    kj::Promise<void> describe(DescribeContext context) override;

private:
    ServerLoop& loop_;
    std::uint64_t connection_;
};

struct Options {
    Address address;
    std::vector<uint8_t> token;
    Text spear_version;
    std::uint32_t default_lease_ms;
    std::size_t max_message_bytes;
    std::size_t max_sessions;
    bool channel;
};

/// Everything that lives on the server thread.
class ServerLoop : private kj::TaskSet::ErrorHandler {
public:
    ServerLoop(kj::AsyncIoContext& io, LoopQueue& queue, const Options& options,
        const spear_server_callbacks& callbacks, ServerChannels& channels, int listener)
        : io_(io), options_(options), callbacks_(callbacks), channels_(channels), tasks_(*this),
          listener_(io.lowLevelProvider->wrapListenSocketFd(
              listener, kj::LowLevelAsyncIoProvider::TAKE_OWNERSHIP | kj::LowLevelAsyncIoProvider::ALREADY_CLOEXEC |
                            kj::LowLevelAsyncIoProvider::ALREADY_NONBLOCK)) {
        auto stop = kj::newPromiseAndFulfiller<void>();
        stop_ = kj::mv(stop.fulfiller);
        stopped_ = kj::mv(stop.promise);
        tasks_.add(accept());
        tasks_.add(queue.run());
    }
    ~ServerLoop() noexcept(false) {
        *lives_ = false;
        while (!sessions_.empty()) {
            end_session(sessions_.begin()->first, "the server stops");
        }
    }

    void run() { stopped_.wait(io_.waitScope); }
    /// Answers that were given before still go out.
    void stop() {
        tasks_.add(kj::evalLast([this] { stop_->fulfill(); }));
    }

    // What sessions ask for.
    void connect(std::uint64_t connection, ConnectContext context);
    kj::Promise<void> submit(std::uint64_t id, SessionState::SubmitContext context);
    void status(std::uint64_t id, protocol::Status::Builder out);
    void describe(protocol::Description::Builder out);
    void sign_of_life(std::uint64_t id) { session(id).last_sign = io_.provider->getTimer().now(); }
    void reply(std::uint64_t id, std::uint64_t request, const Reply& reply);
    void end_session(std::uint64_t id, const char* reason);
    bool has_session(std::uint64_t id) const { return sessions_.count(id) != 0; }
    std::string offer_channel(std::uint64_t id);
    bool open_channel(std::uint64_t id, capnp::Data::Reader nonce, bool client_spins);
    kj::Promise<void> ended(std::uint64_t id);

private:
    struct Connection {
        kj::Own<kj::AsyncIoStream> stream;
        capnp::TwoPartyVatNetwork network;
        capnp::RpcSystem<capnp::rpc::twoparty::VatId> rpc;
        kj::Promise<void> watch = nullptr; // goes with the connection, so that no timer outlives it
        Connection(kj::Own<kj::AsyncIoStream> s, capnp::ReaderOptions reader, capnp::Capability::Client bootstrap)
            : stream(kj::mv(s)), network(*stream, capnp::rpc::twoparty::Side::SERVER, reader),
              rpc(capnp::makeRpcServer(network, kj::mv(bootstrap))) {}
    };

    SessionState& session(std::uint64_t id) {
        const auto at = sessions_.find(id);
        KJ_REQUIRE(at != sessions_.end(), "the session has ended");
        return at->second;
    }
    kj::Promise<void> accept();
    kj::Promise<void> watch_lease(std::uint64_t id);
    void drop_connection(std::uint64_t connection);
    void log(const Text& text) const {
        if (callbacks_.log) {
            callbacks_.log(callbacks_.user, text.c_str());
        }
    }
    kj::Promise<void> watch_connection(std::uint64_t connection);
    void taskFailed(kj::Exception&&) override {} // one client's broken connection is nobody else's concern

    const std::shared_ptr<bool> lives_ = std::make_shared<bool>(true);
    kj::AsyncIoContext& io_;
    const Options& options_;
    const spear_server_callbacks& callbacks_;
    ServerChannels& channels_;
    const kj::TimePoint started_ = io_.provider->getTimer().now();
    std::uint64_t next_connection_ = 1;
    std::uint64_t next_session_ = 1;
    std::uint64_t next_request_ = 1;
    std::map<std::uint64_t, SessionState> sessions_;
    std::map<std::uint64_t, kj::Own<Connection>> connections_;
    kj::Own<kj::PromiseFulfiller<void>> stop_;
    kj::Promise<void> stopped_ = nullptr;
    kj::TaskSet tasks_;
    kj::Own<kj::ConnectionReceiver> listener_;
};

kj::Promise<void> ServerLoop::accept() {
    return listener_->accept().then([this](kj::Own<kj::AsyncIoStream> stream) {
        const std::uint64_t number = next_connection_++;
        capnp::ReaderOptions reader;
        reader.traversalLimitInWords = options_.max_message_bytes / sizeof(capnp::word) + 4096;
        reader.nestingLimit = 16; // our messages are flat
        // Twice the sessions: a client that only describes, or is being refused, needs a connection too.
        if (connections_.size() < 2 * options_.max_sessions) {
            auto connection = kj::heap<Connection>(kj::mv(stream), reader, kj::heap<GatewayServer>(*this, number));
            tasks_.add(connection->network.onDisconnect().then([this, number] { drop_connection(number); },
                [this, number](kj::Exception&&) { drop_connection(number); }));
            connections_.emplace(number, kj::mv(connection));
            connections_.find(number)->second->watch = watch_connection(number).eagerlyEvaluate(nullptr);
        }
        return accept();
    });
}

/// A connection without a session is given up after some time: who connects and says nothing, or stops before it has
/// closed, takes no place from others.
kj::Promise<void> ServerLoop::watch_connection(std::uint64_t connection) {
    const std::uint32_t patience = std::max(4 * options_.default_lease_ms, 1000u);
    return io_.provider->getTimer()
        .afterDelay(patience * kj::MILLISECONDS)
        .then([this, connection]() -> kj::Promise<void> {
            const bool has_session = std::any_of(sessions_.begin(), sessions_.end(),
                [&](const auto& one) { return one.second.connection == connection; });
            if (connections_.count(connection) == 0) {
                return kj::READY_NOW;
            }
            if (has_session) {
                return watch_connection(connection);
            }
            drop_connection(connection);
            return kj::READY_NOW;
        });
}

void ServerLoop::drop_connection(std::uint64_t connection) {
    for (auto at = sessions_.begin(); at != sessions_.end();) {
        const auto [id, state] = std::pair<std::uint64_t, const SessionState&>(at->first, at->second);
        ++at;
        if (state.connection == connection) {
            end_session(id, "the connection was lost");
        }
    }
    // Not now: the call stack may run through the connection.
    tasks_.add(kj::evalLater([this, connection] { connections_.erase(connection); }));
}

void ServerLoop::connect(std::uint64_t connection, ConnectContext context) {
    const auto hello = context.getParams().getHello();
    auto results = context.getResults();
    auto welcome = results.initWelcome();
    welcome.setSpearVersion(options_.spear_version);
    welcome.setProtocolVersion(protocol::PROTOCOL_VERSION);
    const auto refuse = [&](ErrorCode code, const Text& message) {
        auto error = welcome.initError();
        error.setCode(static_cast<std::uint16_t>(code));
        error.setMessage(message);
    };
    if (hello.getProtocolVersion() != protocol::PROTOCOL_VERSION) {
        return refuse(ErrorCode::VersionMismatch,
            "The client (spear " + Text(hello.getSpearVersion().cStr()) + ") speaks protocol " +
                std::to_string(hello.getProtocolVersion()) + ", this engine's plugin (spear " + options_.spear_version +
                ") speaks protocol " + std::to_string(protocol::PROTOCOL_VERSION) +
                ". Install the same version on both sides.");
    }
    const auto token = hello.getToken();
    if (!options_.token.empty()) {
        // Compares every byte whatever they are, so that the time tells nothing.
        unsigned difference = token.size() != options_.token.size();
        for (std::size_t i = 0; i < token.size() && i < options_.token.size(); ++i) {
            difference |= static_cast<unsigned>(token[i] ^ options_.token[i]);
        }
        if (difference != 0) {
            return refuse(ErrorCode::Unauthorized,
                "The server refused the token. Give the token that the engine was started with.");
        }
    }
    if (sessions_.size() >= options_.max_sessions) {
        return refuse(ErrorCode::LimitExceeded,
            "The engine has its limit of " + std::to_string(options_.max_sessions) + " sessions.");
    }
    std::uint32_t lease = hello.getLeaseMs() == 0 ? options_.default_lease_ms : hello.getLeaseMs();
    if (lease != SPEAR_LEASE_OFF) {
        lease = lease < limits::min_lease_ms   ? limits::min_lease_ms
                : lease > limits::max_lease_ms ? limits::max_lease_ms
                                               : lease;
    }
    std::vector<Text> entry_points;
    for (const auto entry : hello.getEntryPoints()) {
        entry_points.emplace_back(entry.cStr());
    }
    std::vector<const char*> pointers;
    for (const Text& entry : entry_points) {
        pointers.push_back(entry.c_str());
    }
    const Text name = hello.getClientName().cStr();
    const std::uint64_t id = next_session_++;
    const spear_hello hello_out{id, name.c_str(), hello.getProcessId(), lease, pointers.data(), pointers.size()};
    spear_wire_error error{};
    if (!callbacks_.connect(callbacks_.user, &hello_out, &error)) {
        return refuse(static_cast<ErrorCode>(error.code), error.message);
    }
    SessionState& state = sessions_[id];
    state.id = id;
    state.connection = connection;
    state.lease_ms = lease;
    state.last_sign = io_.provider->getTimer().now();
    channels_.set_session_count(sessions_.size());
    if (lease != SPEAR_LEASE_OFF) {
        state.lease_watch = watch_lease(id).eagerlyEvaluate(nullptr);
    }
    welcome.setSessionId(id);
    welcome.setLeaseMs(lease);
    results.setSession(kj::heap<SessionServer>(*this, lives_, id));
}

kj::Promise<void> ServerLoop::watch_lease(std::uint64_t id) {
    const auto at = sessions_.find(id);
    if (at == sessions_.end()) {
        return kj::READY_NOW;
    }
    auto& timer = io_.provider->getTimer();
    const kj::TimePoint ends = at->second.last_sign + at->second.lease_ms * kj::MILLISECONDS;
    if (timer.now() >= ends) {
        // Not now: this runs in a promise that goes with the session.
        tasks_.add(kj::evalLater([this, id, connection = at->second.connection] {
            end_session(id, "the lease expired: the client gave no sign of life");
            drop_connection(connection);
        }));
        return kj::READY_NOW;
    }
    return timer.atTime(ends).then([this, id] { return watch_lease(id); });
}

kj::Promise<void> ServerLoop::submit(std::uint64_t id, SessionState::SubmitContext context) {
    SessionState& state = session(id);
    sign_of_life(id);
    KJ_REQUIRE(!state.has_channel, "this session submits through its shared memory channel");
    state.offered.reset();
    const auto batch = context.getParams().getBatch();
    std::vector<std::uint64_t> releases;
    for (const std::uint64_t number : batch.getReleases()) {
        releases.push_back(number);
    }
    spear_batch out{};
    out.transaction = batch.getTransaction();
    out.block = static_cast<uint8_t>(batch.getBlock());
    out.closes = batch.getCloses();
    out.abort = batch.getAbort();
    out.single_step = batch.getSingleStep();
    out.types = as_bytes(batch.getTypes());
    out.operations = as_bytes(batch.getOperations());
    out.releases = releases.data();
    out.release_count = releases.size();
    state.received.add(TrafficCounter::bytes_of(out));
    const std::uint64_t request = next_request_++;
    auto done = kj::newPromiseAndFulfiller<void>();
    state.pending.emplace(request, SessionState::Pending{context, kj::mv(done.fulfiller)});
    deliver_batch(callbacks_, id, request, out); // may reply at once: through the queue, so not before this returns
    context.releaseParams();
    return kj::mv(done.promise);
}

void ServerLoop::reply(std::uint64_t id, std::uint64_t request, const Reply& reply) {
    const auto at = sessions_.find(id);
    if (at == sessions_.end()) {
        return;
    }
    const auto pending = at->second.pending.find(request);
    if (pending == at->second.pending.end()) {
        return;
    }
    const TraceSpan span(SPEAR_TRACE_ANSWER, id, request);
    SessionState::Pending answered = kj::mv(pending->second);
    at->second.pending.erase(pending);
    const std::size_t words =
        (reply.types.size() + reply.answers.size() + reply.error_message.size()) / sizeof(capnp::word) + 32;
    auto answers = answered.context.getResults(capnp::MessageSize{words, 0}).initAnswers();
    answers.setTypes(as_data(reply.types));
    answers.setAnswers(as_data(reply.answers));
    answers.setFrame(reply.frame);
    if (reply.has_error) {
        auto error = answers.initError();
        error.setCode(reply.error_code);
        error.setMessage(reply.error_message);
    }
    at->second.sent.add(reply.types.size() + reply.answers.size());
    answered.done->fulfill();
}

void ServerLoop::status(std::uint64_t id, protocol::Status::Builder out) {
    sign_of_life(id);
    spear_status status{};
    callbacks_.status(callbacks_.user, id, &status);
    const SessionState& state = session(id);
    status.received = state.received.read();
    status.sent = state.sent.read();
    if (state.has_channel) {
        channels_.get_traffic(id, status.received, status.sent);
    }
    out.setBatchesReceived(status.received.messages);
    out.setBytesReceived(status.received.bytes);
    out.setAnswersSent(status.sent.messages);
    out.setBytesSent(status.sent.bytes);
    out.setKeptResults(status.kept_results);
    out.setState(static_cast<protocol::Status::State>(status.state));
    out.setFrame(status.frame);
    out.setFramesAgeMs(status.frames_age_ms);
    out.setHolder(as_text(status.holder));
    out.setDetail(as_text(status.detail));
}

void ServerLoop::describe(protocol::Description::Builder out) {
    spear_description description{};
    callbacks_.describe(callbacks_.user, &description);
    out.setSpearVersion(as_text(description.spear_version));
    out.setEngine(as_text(description.engine));
    out.setScene(as_text(description.scene));
    out.setProcessId(description.process_id);
    out.setProject(as_text(description.project));
    out.setFrame(description.frame);
    out.setUptimeMs(static_cast<std::uint64_t>((io_.provider->getTimer().now() - started_) / kj::MILLISECONDS));
    out.setSessions(static_cast<std::uint32_t>(sessions_.size()));
}

void ServerLoop::end_session(std::uint64_t id, const char* reason) {
    auto node = sessions_.extract(id);
    if (node.empty()) {
        return;
    }
    channels_.set_session_count(sessions_.size());
    if (node.mapped().has_channel) {
        channels_.remove(id);
    }
    for (auto& [request, pending] : node.mapped().pending) {
        pending.done->reject(KJ_EXCEPTION(DISCONNECTED, "the session has ended", reason));
    }
    for (auto& told : node.mapped().told_of_end) {
        told->reject(KJ_EXCEPTION(DISCONNECTED, "the session has ended", reason));
    }
    callbacks_.disconnect(callbacks_.user, id, reason);
}

std::string ServerLoop::offer_channel(std::uint64_t id) {
    SessionState& state = session(id);
    if (!options_.channel || state.has_channel || !state.pending.empty()) {
        return {};
    }
    std::string why;
    state.offered = channels_.offer(id, options_.max_message_bytes, why);
    if (!state.offered) {
        log("Session " + std::to_string(id) + " goes without its shared memory channel, by RPC: " + why);
    }
    return state.offered ? state.offered->name() : std::string();
}

bool ServerLoop::open_channel(std::uint64_t id, capnp::Data::Reader nonce, bool client_spins) {
    SessionState& state = session(id);
    const std::shared_ptr<ServerChannel> offered = std::move(state.offered);
    if (!offered || !state.pending.empty() || !offered->confirm(nonce.begin(), nonce.size(), client_spins)) {
        return false;
    }
    state.has_channel = true;
    channels_.add(offered);
    return true;
}

kj::Promise<void> ServerLoop::ended(std::uint64_t id) {
    auto told = kj::newPromiseAndFulfiller<void>();
    auto& waiting = session(id).told_of_end;
    KJ_REQUIRE(waiting.size() < 4, "asked too often");
    waiting.push_back(kj::mv(told.fulfiller));
    return kj::mv(told.promise);
}

SessionServer::~SessionServer() noexcept(false) {
    if (*loop_lives_) {
        loop_.end_session(id_, "the client let go of its session");
    }
}
kj::Promise<void> SessionServer::submit(SubmitContext context) { return loop_.submit(id_, context); }
kj::Promise<void> SessionServer::renew(RenewContext) {
    loop_.sign_of_life(id_);
    return kj::READY_NOW;
}
kj::Promise<void> SessionServer::status(StatusContext context) {
    KJ_REQUIRE(loop_.has_session(id_), "the session has ended");
    loop_.status(id_, context.getResults().initStatus());
    return kj::READY_NOW;
}
kj::Promise<void> SessionServer::close(CloseContext) {
    loop_.end_session(id_, "the client closed it");
    return kj::READY_NOW;
}
kj::Promise<void> SessionServer::offerChannel(OfferChannelContext context) {
    const std::string name = loop_.offer_channel(id_);
    context.getResults().setName(name);
    return kj::READY_NOW;
}
kj::Promise<void> SessionServer::openChannel(OpenChannelContext context) {
    const auto params = context.getParams();
    context.getResults().setOpened(loop_.open_channel(id_, params.getNonce(), params.getSpin()));
    return kj::READY_NOW;
}
kj::Promise<void> SessionServer::ended(EndedContext) { return loop_.ended(id_); }
kj::Promise<void> GatewayServer::connect(ConnectContext context) {
    loop_.connect(connection_, context);
    return kj::READY_NOW;
}
kj::Promise<void> GatewayServer::describe(DescribeContext context) {
    loop_.describe(context.getResults().initDescription());
    return kj::READY_NOW;
}

} // namespace
} // namespace spear::wire

using namespace spear;
using namespace spear::wire;

struct spear_server {
    Options options;
    spear_server_callbacks callbacks{};
    Text address;
    int listener = -1;
    std::unique_ptr<RegistryEntry> registered;
    std::mutex mutex;
    std::condition_variable started;
    bool running = false;       // under mutex: the loop accepts
    Text failure;               // under mutex: why the loop never ran
    LoopQueue* queue = nullptr; // set before `running`, cleared by the server thread under mutex
    ServerLoop* loop = nullptr; // server thread
    ServerChannels channels{
        ChannelEvents{[this](std::uint64_t session, std::uint64_t request, const spear_batch& batch) {
                          deliver_batch(callbacks, session, request, batch);
                      },
            [this](std::uint64_t session, const char* reason) { spear_server_drop(this, session, reason); }}};
    std::thread thread;

    void run() {
        // Signals are the engine's business.
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_BLOCK, &all, nullptr);
        pthread_setname_np(pthread_self(), "SpearServer");
        spear_trace_name_thread("server thread");
        Text reason;
        try {
            auto io = kj::setupAsyncIo();
            LoopQueue own_queue(*io.lowLevelProvider);
            {
                ServerLoop own_loop(io, own_queue, options, callbacks, channels, listener);
                loop = &own_loop;
                {
                    const std::lock_guard lock(mutex);
                    queue = &own_queue;
                    running = true;
                }
                started.notify_all();
                own_loop.run();
                own_queue.close();
                const std::lock_guard lock(mutex);
                queue = nullptr;
            }
            loop = nullptr;
        } catch (const kj::Exception& exception) {
            reason = exception.getDescription().cStr();
        } catch (const std::exception& exception) {
            reason = exception.what();
        }
        const std::lock_guard lock(mutex);
        queue = nullptr;
        failure = reason;
        started.notify_all();
    }
    void post(std::function<void()> work) {
        const std::lock_guard lock(mutex);
        if (queue) {
            queue->post(std::move(work));
        }
    }
};

extern "C" spear_server* spear_server_start(
    const spear_server_options* options, const spear_server_callbacks* callbacks, spear_wire_error* error) {
    try {
        auto server = std::make_unique<spear_server>();
        server->callbacks = *callbacks;
        Options& own = server->options;
        if (!parse_address(options->address ? options->address : "", own.address, error)) {
            return nullptr;
        }
        own.token.assign(options->token, options->token + options->token_size);
        own.spear_version = options->spear_version ? options->spear_version : "";
        own.default_lease_ms = options->default_lease_ms ? options->default_lease_ms : limits::default_lease_ms;
        own.max_message_bytes = options->max_message_bytes ? options->max_message_bytes : limits::max_message_bytes;
        own.max_sessions = options->max_sessions ? options->max_sessions : limits::max_sessions;
        own.channel = !options->no_channel && setting_is_on("SPEAR_CHANNEL");
        if (!own.address.is_local() && own.token.empty()) {
            fill_error(error, ErrorCode::Unauthorized,
                own.address.text() + " can be reached from other machines, so it needs a token: give one, or use a "
                                     "Unix socket or 127.0.0.1.");
            return nullptr;
        }
        server->listener = listen_at(own.address, error);
        if (server->listener < 0) {
            return nullptr;
        }
        if (!own.address.is_loopback && own.token.empty()) { // a "localhost" that is none
            ::close(server->listener);
            fill_error(error, ErrorCode::Unauthorized,
                own.address.text() + " can be reached from other machines, so it needs a token.");
            return nullptr;
        }
        server->address = own.address.text();
        (void)spear_remove_leftovers(options->registry_directory, 0, nullptr, nullptr);
        server->thread = std::thread([raw = server.get()] { raw->run(); });
        {
            std::unique_lock lock(server->mutex);
            server->started.wait(lock, [&] { return server->running || !server->failure.empty(); });
        }
        if (!server->running) {
            server->thread.join();
            fill_error(error, ErrorCode::InternalError, "The server thread did not start: " + server->failure);
            return nullptr;
        }
        server->registered = std::make_unique<RegistryEntry>(
            options->registry_directory ? options->registry_directory : "", server->address);
        return server.release();
    } catch (const std::exception& exception) {
        fill_error(error, ErrorCode::InternalError, exception.what());
    } catch (const kj::Exception& exception) {
        fill_error(error, ErrorCode::InternalError, exception.getDescription().cStr());
    }
    return nullptr;
}

extern "C" const char* spear_server_address(const spear_server* server) { return server->address.c_str(); }

extern "C" void spear_server_reply(
    spear_server* server, uint64_t session, uint64_t request, const spear_answers* answers) {
    const TraceSpan span(SPEAR_TRACE_ANSWER, session, request);
    try {
        if (server->channels.reply(session, request, *answers)) {
            return;
        }
        auto reply = std::make_shared<Reply>();
        reply->types.assign(answers->types.data, answers->types.data + answers->types.size);
        reply->answers.assign(answers->answers.data, answers->answers.data + answers->answers.size);
        reply->frame = answers->frame;
        reply->has_error = answers->has_error != 0;
        reply->error_code = answers->error_code;
        reply->error_message = answers->error_message ? answers->error_message : "";
        server->post([server, session, request, reply] {
            try {
                server->loop->reply(session, request, *reply);
            } catch (const kj::Exception&) { // the client went while we answered
            }
        });
    } catch (...) {
        spear_server_drop(server, session, "the engine had no memory for an answer");
    }
}

extern "C" void spear_server_drop(spear_server* server, uint64_t session, const char* reason) {
    try {
        server->post([server, session, text = Text(reason ? reason : "the server dropped it")] {
            server->loop->end_session(session, text.c_str());
        });
    } catch (...) { // no memory: the lease will end it
    }
}

extern "C" void spear_server_wait(spear_server* server, uint64_t session, uint32_t timeout_ms) {
    server->channels.wait(session, timeout_ms);
}
extern "C" int spear_server_wait_call(
    spear_server* server, uint64_t session, uint32_t timeout_ms, spear_call* call) {
    return server->channels.wait_call(session, timeout_ms, *call) ? 1 : 0;
}
extern "C" void spear_server_answer_call(spear_server* server, uint64_t session, const spear_call_answer* answer) {
    server->channels.answer_call(session, *answer);
}
extern "C" void spear_server_release(spear_server* server) { server->channels.release(); }
extern "C" void spear_server_poll(spear_server* server) { server->channels.poll(); }
extern "C" void spear_server_wake(spear_server* server) { server->channels.wake(); }

extern "C" void spear_server_stop(spear_server* server) {
    if (!server) {
        return;
    }
    server->registered.reset();
    server->post([server] { server->loop->stop(); });
    server->thread.join();
    if (server->options.address.kind == Address::Kind::unix_path) {
        ::unlink(server->options.address.path.c_str());
    }
    delete server;
}
