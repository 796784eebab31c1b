// SPDX-License-Identifier: MIT
#include <atomic>
#include <condition_variable>
#include <cstring>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <csignal>
#include <pthread.h>
#include <unistd.h>

#include <capnp/rpc-twoparty.h>
#include <kj/async-io.h>
#include <kj/debug.h>

#include "address.hpp"
#include "client_channel.hpp"
#include "loop_queue.hpp"
#include "spear.capnp.h"
#include "spear/limits.hpp"
#include "spear_trace.h"
#include "spear_wire.h"

namespace spear::wire {
namespace {

using Text = std::string;

spear_bytes as_bytes(capnp::Data::Reader data) { return {data.begin(), data.size()}; }

template <std::size_t N>
void copy_text(char (&buffer)[N], capnp::Text::Reader text) {
    const std::size_t size = text.size() < N - 1 ? text.size() : N - 1;
    std::memcpy(buffer, text.begin(), size);
    buffer[size] = 0;
}

Text unknown_host_text(const Address& address) {
    return "No engine answers at " + address.text() + ": the host '" + address.host +
           "' is not known. Check its spelling, or give its number.";
}

Text describe_failure(const kj::Exception& exception) { return exception.getDescription().cStr(); }

struct Connection {
    kj::Own<kj::AsyncIoStream> stream;
    capnp::TwoPartyVatNetwork network;
    capnp::RpcSystem<capnp::rpc::twoparty::VatId> rpc;
    Connection(kj::Own<kj::AsyncIoStream> s, std::size_t max_message_bytes)
        : stream(kj::mv(s)), network(*stream, capnp::rpc::twoparty::Side::CLIENT, reader_options(max_message_bytes)),
          rpc(capnp::makeRpcClient(network)) {}

    static capnp::ReaderOptions reader_options(std::size_t max_message_bytes) {
        capnp::ReaderOptions options;
        options.traversalLimitInWords = max_message_bytes / sizeof(capnp::word) + 4096;
        return options;
    }
    protocol::Gateway::Client server() {
        capnp::MallocMessageBuilder message(16);
        auto id = message.initRoot<capnp::rpc::twoparty::VatId>();
        id.setSide(capnp::rpc::twoparty::Side::SERVER);
        return rpc.bootstrap(id).castAs<protocol::Gateway>();
    }
};

/// The address names a host that nobody knows.
struct UnknownHost {};

/// Connects within the deadline; throws UnknownHost, or kj::Exception, DISCONNECTED if nobody listens.
kj::Own<Connection> open_connection(
    kj::AsyncIoContext& io, const Address& address, kj::TimePoint deadline, std::size_t max_message_bytes) {
    auto& timer = io.provider->getTimer();
    kj::Own<kj::NetworkAddress> where;
    try {
        auto looked_up = io.provider->getNetwork().parseAddress(address.kj_text());
        where = timer.timeoutAt(deadline, kj::mv(looked_up)).wait(io.waitScope);
    } catch (const kj::Exception& exception) {
        if (exception.getType() == kj::Exception::Type::OVERLOADED) { // the deadline
            throw;
        }
        throw UnknownHost();
    }
    auto stream = timer.timeoutAt(deadline, where->connect()).wait(io.waitScope);
    return kj::heap<Connection>(kj::mv(stream), max_message_bytes);
}

bool require_port(const Address& address, spear_wire_error* error) {
    if (address.kind != Address::Kind::tcp || address.port != 0) {
        return true;
    }
    fill_error(error, ErrorCode::ConnectionError,
        "'" + address.text() +
            "' has no port to connect to: 0 lets an engine choose one. `spear engine list` says which it took.");
    return false;
}

struct Batch {
    std::uint64_t request;
    spear_batch head;
    std::vector<uint8_t> types;
    std::vector<uint8_t> operations;
    std::vector<std::uint64_t> releases;
};

} // namespace
} // namespace spear::wire

using namespace spear;
using namespace spear::wire;

struct spear_client final : private kj::TaskSet::ErrorHandler {
    // Set before the thread starts, constant afterwards.
    Address address;
    std::vector<uint8_t> token;
    Text spear_version, client_name;
    std::uint32_t wanted_lease_ms = 0;
    std::uint32_t connect_timeout_ms = 0;
    std::size_t max_message_bytes = 0;
    std::vector<Text> entry_points;
    spear_client_callbacks callbacks{};
    bool wants_channel = true;
    bool spins = true;
    std::unique_ptr<ClientChannel> channel; // set before `started`, constant afterwards

    std::mutex mutex;
    std::condition_variable changed;
    bool started = false;               // under mutex: connected, or failed
    std::atomic<bool> connected{false}; // changed under mutex
    spear_wire_error failure{};         // under mutex: why it did not connect
    LoopQueue* queue = nullptr;         // under mutex; null before and after the session
    std::uint64_t session_id = 0;       // written before `started`
    std::thread thread;

    // I/O thread only.
    kj::AsyncIoContext* io = nullptr;
    kj::Maybe<protocol::Session::Client> session;
    kj::Own<kj::PromiseFulfiller<void>> finish;
    kj::TaskSet* tasks = nullptr;
    std::uint32_t lease_ms = 0;
    bool ended = false;            // `lost` was told, or the session was closed
    bool flushes = false;          // a flush() of the channel is due
    TrafficCounter sent, received; // by RPC

    bool post(std::function<void()> work) {
        const std::lock_guard lock(mutex);
        return queue && queue->post(std::move(work));
    }
    void taskFailed(kj::Exception&& exception) override { lose(describe_failure(exception)); }

    void lose(const Text& reason) {
        if (ended) {
            return;
        }
        ended = true;
        {
            const std::lock_guard lock(mutex);
            connected = false;
        }
        spear_wire_error error{};
        fill_error(&error, ErrorCode::Disconnected,
            "The connection to the engine at " + address.text() + " was lost: " + reason);
        callbacks.lost(callbacks.user, &error);
        if (channel) {
            channel->wake();
        }
    }

    void report_start(ErrorCode code, const Text& message) {
        const std::lock_guard lock(mutex);
        fill_error(&failure, code, message);
        started = true;
        changed.notify_all();
    }

    /// The hello; true if the server said welcome.
    bool greet(kj::AsyncIoContext& context, Connection& connection, kj::TimePoint deadline) {
        auto request = connection.server().connectRequest();
        auto hello = request.initHello();
        hello.setProtocolVersion(protocol::PROTOCOL_VERSION);
        hello.setSpearVersion(spear_version);
        hello.setClientName(client_name);
        hello.setProcessId(static_cast<std::uint64_t>(::getpid()));
        hello.setToken(capnp::Data::Reader(token.data(), token.size()));
        hello.setLeaseMs(wanted_lease_ms);
        auto list = hello.initEntryPoints(static_cast<unsigned>(entry_points.size()));
        for (unsigned i = 0; i < list.size(); ++i) {
            list.set(i, entry_points[i]);
        }
        auto response = context.provider->getTimer().timeoutAt(deadline, request.send()).wait(context.waitScope);
        const auto welcome = response.getWelcome();
        if (welcome.hasError()) {
            report_start(static_cast<ErrorCode>(welcome.getError().getCode()), welcome.getError().getMessage().cStr());
            return false;
        }
        session_id = welcome.getSessionId();
        lease_ms = welcome.getLeaseMs();
        session = response.getSession();
        return true;
    }

    /// Asks for the shared memory channel. Without one, everything goes by RPC.
    void open_channel(kj::AsyncIoContext& context, kj::TimePoint deadline) {
        if (!wants_channel) {
            return;
        }
        auto& timer = context.provider->getTimer();
        auto offer = timer.timeoutAt(deadline, live_session().offerChannelRequest().send()).wait(context.waitScope);
        if (offer.getName().size() == 0) {
            return;
        }
        std::string why;
        auto region = ChannelRegion::open(offer.getName().cStr(), why); // not to be found on another machine
        auto request = live_session().openChannelRequest();
        if (region) {
            request.setNonce(capnp::Data::Reader(region->nonce(), channel_nonce_bytes));
        }
        request.setSpin(spins);
        if (timer.timeoutAt(deadline, request.send()).wait(context.waitScope).getOpened()) {
            channel = std::make_unique<ClientChannel>(std::move(region), max_message_bytes, spins);
        }
    }

    kj::Promise<void> attend() {
        const auto pause = channel->more_is_coming() ? 1 * kj::MILLISECONDS : 100 * kj::MILLISECONDS;
        return io->provider->getTimer().afterDelay(pause).then([this] {
            if (callbacks.attend && !ended) {
                callbacks.attend(callbacks.user);
            }
            return attend();
        });
    }

    /// What found no room in the ring goes as the engine makes room.
    void flush_channel() {
        if (ended || channel->flush()) {
            flushes = false;
            return;
        }
        tasks->add(io->provider->getTimer().afterDelay(200 * kj::MICROSECONDS).then([this] { flush_channel(); }));
    }

    protocol::Session::Client& live_session() { return KJ_REQUIRE_NONNULL(session); }

    kj::Promise<void> renew() {
        return io->provider->getTimer().afterDelay(lease_ms / 3 * kj::MILLISECONDS).then([this] {
            return live_session().renewRequest().send().ignoreResult().then([this] { return renew(); });
        });
    }

    void send(const Batch& batch) {
        if (ended) {
            return;
        }
        const std::size_t words =
            (batch.types.size() + batch.operations.size()) / sizeof(capnp::word) + batch.releases.size() + 64;
        auto request = live_session().submitRequest(capnp::MessageSize{words, 0});
        auto out = request.initBatch();
        out.setTransaction(batch.head.transaction);
        out.setBlock(static_cast<protocol::Block>(batch.head.block));
        out.setCloses(batch.head.closes);
        out.setAbort(batch.head.abort);
        out.setSingleStep(batch.head.single_step);
        out.setTypes(capnp::Data::Reader(batch.types.data(), batch.types.size()));
        out.setOperations(capnp::Data::Reader(batch.operations.data(), batch.operations.size()));
        if (!batch.releases.empty()) {
            out.setReleases(kj::arrayPtr(batch.releases.data(), batch.releases.size()));
        }
        sent.add(batch.types.size() + batch.operations.size() + batch.releases.size() * sizeof(std::uint64_t));
        tasks->add(request.send().then(
            [this, number = batch.request](auto&& response) { receive(number, response.getAnswers()); }));
    }

    void receive(std::uint64_t request, protocol::Answers::Reader answers) {
        if (ended) {
            return;
        }
        spear_answers out{};
        out.types = as_bytes(answers.getTypes());
        out.answers = as_bytes(answers.getAnswers());
        out.frame = answers.getFrame();
        out.has_error = answers.hasError();
        if (answers.hasError()) {
            out.error_code = answers.getError().getCode();
            out.error_message = answers.getError().getMessage().cStr();
        }
        received.add(TrafficCounter::bytes_of(out));
        callbacks.answers(callbacks.user, request, &out);
    }

    void run() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_BLOCK, &all, nullptr);
        pthread_setname_np(pthread_self(), "spear-io");
        spear_trace_name_thread("client I/O thread");
        try {
            auto context = kj::setupAsyncIo();
            io = &context;
            const kj::TimePoint deadline = context.provider->getTimer().now() + connect_timeout_ms * kj::MILLISECONDS;
            auto connection = open_connection(context, address, deadline, max_message_bytes);
            KJ_DEFER(session = nullptr); // before the connection it belongs to, also if no session comes of it
            if (!greet(context, *connection, deadline)) {
                return;
            }
            open_channel(context, deadline);
            serve(context, *connection);
        } catch (const UnknownHost&) {
            report_start(ErrorCode::EngineNotRunning, unknown_host_text(address));
        } catch (const kj::Exception& exception) {
            const bool timed_out = exception.getType() == kj::Exception::Type::OVERLOADED;
            report_start(ErrorCode::EngineNotRunning,
                "No engine answers at " + address.text() +
                    (timed_out ? " within " + std::to_string(connect_timeout_ms) + " ms"
                               : ": " + describe_failure(exception)) +
                    ". Start one with `spear engine`, or list those that run with `spear engine list`.");
            if (!ended && session_id != 0) {
                lose(describe_failure(exception));
            }
        } catch (const std::exception& exception) {
            report_start(ErrorCode::InternalError, exception.what());
        }
        const std::lock_guard lock(mutex);
        queue = nullptr;
        connected = false;
    }

    void serve(kj::AsyncIoContext& context, Connection& connection) {
        LoopQueue own_queue(*context.lowLevelProvider);
        auto done = kj::newPromiseAndFulfiller<void>();
        finish = kj::mv(done.fulfiller);
        {
            kj::TaskSet own_tasks(*this);
            tasks = &own_tasks;
            own_tasks.add(own_queue.run());
            own_tasks.add(connection.network.onDisconnect().then([this] { lose("the engine closed it"); }));
            if (lease_ms != SPEAR_LEASE_OFF) {
                own_tasks.add(renew());
            }
            if (channel) {
                own_tasks.add(attend());
            }
            own_tasks.add(live_session().endedRequest().send().ignoreResult()); // told at once, not at the next renewal
            {
                const std::lock_guard lock(mutex);
                queue = &own_queue;
                connected = true;
                started = true;
                changed.notify_all();
            }
            done.promise.wait(context.waitScope);
            own_queue.close();
            const std::lock_guard lock(mutex);
            queue = nullptr;
        }
    }
};

extern "C" spear_client* spear_client_connect(
    const spear_client_options* options, const spear_client_callbacks* callbacks, spear_wire_error* error) {
    try {
        auto client = std::make_unique<spear_client>();
        if (!parse_address(options->address ? options->address : "", client->address, error) ||
            !require_port(client->address, error)) {
            return nullptr;
        }
        client->token.assign(options->token, options->token + options->token_size);
        client->spear_version = options->spear_version ? options->spear_version : "";
        client->client_name = options->client_name ? options->client_name : "";
        client->wanted_lease_ms = options->lease_ms;
        client->connect_timeout_ms =
            options->connect_timeout_ms ? options->connect_timeout_ms : limits::default_deadline_ms;
        client->max_message_bytes = options->max_message_bytes ? options->max_message_bytes : limits::max_message_bytes;
        client->entry_points.assign(options->entry_points, options->entry_points + options->entry_point_count);
        client->callbacks = *callbacks;
        client->wants_channel = !options->no_channel && setting_is_on("SPEAR_CHANNEL");
        client->spins = !options->no_spin && setting_is_on("SPEAR_SPIN");
        client->thread = std::thread([raw = client.get()] { raw->run(); });
        bool stands = false;
        {
            std::unique_lock lock(client->mutex);
            client->changed.wait(lock, [&] { return client->started; });
            stands = client->queue != nullptr || client->connected;
        }
        if (stands) {
            return client.release();
        }
        client->thread.join();
        if (error) {
            *error = client->failure;
        }
    } catch (const std::exception& exception) {
        fill_error(error, ErrorCode::InternalError, exception.what());
    }
    return nullptr;
}

extern "C" uint64_t spear_client_session(const spear_client* client) { return client->session_id; }

extern "C" int spear_client_has_channel(const spear_client* client) { return client->channel != nullptr; }
extern "C" int spear_client_take(spear_client* client, uint64_t* request, spear_answers* answers) {
    try {
        return client->channel->take(*request, *answers);
    } catch (const std::exception&) { // no memory
        return -1;
    }
}
extern "C" void spear_client_wait(spear_client* client, uint32_t wakes, uint32_t timeout_us) {
    client->channel->wait(wakes, timeout_us);
}
extern "C" int spear_client_call(spear_client* client, const spear_call* call) {
    return client->connected.load(std::memory_order_relaxed) && client->channel->call(*call) ? 0 : 1;
}
extern "C" int spear_client_take_call(spear_client* client, int spin, spear_call_answer* answer) {
    return client->channel->take_call(spin != 0, *answer);
}
extern "C" uint32_t spear_client_wakes(const spear_client* client) {
    return client->channel ? client->channel->wakes() : 0;
}
extern "C" void spear_client_wake(spear_client* client) {
    if (client->channel) {
        client->channel->wake();
    }
}

extern "C" int spear_client_submit(spear_client* client, uint64_t request, const spear_batch* batch) {
    try {
        if (client->channel) {
            if (!client->connected) {
                return 1;
            }
            if (client->channel->submit(request, *batch)) {
                client->post([client] {
                    if (!std::exchange(client->flushes, true)) {
                        client->flush_channel();
                    }
                });
            }
            return 0;
        }
        auto copy = std::make_shared<Batch>();
        copy->request = request;
        copy->head = *batch;
        copy->types.assign(batch->types.data, batch->types.data + batch->types.size);
        copy->operations.assign(batch->operations.data, batch->operations.data + batch->operations.size);
        copy->releases.assign(batch->releases, batch->releases + batch->release_count);
        {
            const std::lock_guard lock(client->mutex);
            if (!client->connected) {
                return 1;
            }
        }
        return client->post([client, copy] {
            try {
                client->send(*copy);
            } catch (const kj::Exception& exception) {
                client->lose(describe_failure(exception));
            }
        })
                   ? 0
                   : 1;
    } catch (const std::exception&) {
        return 1;
    }
}

namespace {
/// An answer that two threads meet at; outlives whichever of them gives up first.
struct StatusMeeting {
    std::mutex mutex;
    std::condition_variable changed;
    bool answered = false;
    bool failed = false;
    Text reason;
    spear_status status{};

    void finish(bool has_failed, Text why) {
        const std::lock_guard lock(mutex);
        answered = true;
        failed = has_failed;
        reason = std::move(why);
        changed.notify_all();
    }
};
} // namespace

extern "C" int spear_client_status(
    spear_client* client, uint32_t timeout_ms, spear_status* status, spear_wire_error* error) {
    try {
        auto meeting = std::make_shared<StatusMeeting>();
        const bool posted = client->post([client, meeting] {
            if (client->ended) {
                meeting->finish(true, "the session is over");
                return;
            }
            client->tasks->add(client->live_session().statusRequest().send().then(
                [meeting](auto&& response) {
                    const auto in = response.getStatus();
                    meeting->status.state = static_cast<uint8_t>(in.getState());
                    meeting->status.frame = in.getFrame();
                    meeting->status.frames_age_ms = in.getFramesAgeMs();
                    meeting->status.received = {in.getBatchesReceived(), in.getBytesReceived()};
                    meeting->status.sent = {in.getAnswersSent(), in.getBytesSent()};
                    meeting->status.kept_results = in.getKeptResults();
                    copy_text(meeting->status.holder, in.getHolder());
                    copy_text(meeting->status.detail, in.getDetail());
                    meeting->finish(false, {});
                },
                [meeting](kj::Exception&& exception) { meeting->finish(true, describe_failure(exception)); }));
        });
        if (!posted) {
            fill_error(error, ErrorCode::Disconnected,
                "The session with the engine at " + client->address.text() + " is over.");
            return 1;
        }
        std::unique_lock lock(meeting->mutex);
        if (!meeting->changed.wait_for(
                lock, std::chrono::milliseconds(timeout_ms), [&] { return meeting->answered; })) {
            fill_error(error, ErrorCode::DeadlineExceeded,
                "The engine's server thread gave no status within " + std::to_string(timeout_ms) + " ms.");
            return 1;
        }
        if (meeting->failed) {
            fill_error(error, ErrorCode::Disconnected, meeting->reason);
            return 1;
        }
        *status = meeting->status;
        return 0;
    } catch (const std::exception& exception) {
        fill_error(error, ErrorCode::InternalError, exception.what());
        return 1;
    }
}

extern "C" void spear_client_traffic(const spear_client* client, spear_traffic* sent, spear_traffic* received) {
    *sent = client->channel ? client->channel->sent() : client->sent.read();
    *received = client->channel ? client->channel->received() : client->received.read();
}

extern "C" void spear_client_close(spear_client* client) {
    if (!client) {
        return;
    }
    client->post([client] {
        const bool was_live = !client->ended;
        client->ended = true;
        if (!was_live) {
            client->finish->fulfill();
            return;
        }
        // In good order if the server answers soon; a server that hangs is left.
        auto close = client->live_session().closeRequest().send().ignoreResult();
        client->tasks->add(client->io->provider->getTimer()
                .timeoutAfter(1 * kj::SECONDS, kj::mv(close))
                .then(
                    [client] { client->finish->fulfill(); }, [client](kj::Exception&&) { client->finish->fulfill(); }));
    });
    client->thread.join();
    delete client;
}

extern "C" int spear_describe(
    const char* address_text, uint32_t timeout_ms, spear_description* description, spear_wire_error* error) {
    Address address;
    if (!parse_address(address_text ? address_text : "", address, error) || !require_port(address, error)) {
        return 1;
    }
    // A thread of its own: the caller's may already run an event loop, and a thread has at most one.
    int result = 1;
    std::thread([&] {
        try {
            auto io = kj::setupAsyncIo();
            const kj::TimePoint deadline = io.provider->getTimer().now() + timeout_ms * kj::MILLISECONDS;
            auto connection = open_connection(io, address, deadline, 1 << 20);
            auto response = io.provider->getTimer()
                                .timeoutAt(deadline, connection->server().describeRequest().send())
                                .wait(io.waitScope);
            const auto in = response.getDescription();
            copy_text(description->spear_version, in.getSpearVersion());
            copy_text(description->engine, in.getEngine());
            copy_text(description->scene, in.getScene());
            description->process_id = in.getProcessId();
            description->sessions = in.getSessions();
            copy_text(description->project, in.getProject());
            description->frame = in.getFrame();
            description->uptime_ms = in.getUptimeMs();
            result = 0;
        } catch (const UnknownHost&) {
            fill_error(error, ErrorCode::EngineNotRunning, unknown_host_text(address));
        } catch (const kj::Exception& exception) {
            fill_error(error, ErrorCode::EngineNotRunning,
                "No engine answers at " + address.text() + ": " + describe_failure(exception));
        } catch (const std::exception& exception) {
            fill_error(error, ErrorCode::InternalError, exception.what());
        }
    }).join();
    return result;
}

extern "C" int spear_address_is_local(const char* text) {
    Address address;
    return !parse_address(text ? text : "", address, nullptr) || address.is_local();
}
