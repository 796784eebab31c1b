// SPDX-License-Identifier: MIT
#include "spear/session.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <limits>

#include <fmt/format.h>
#include <unistd.h>

#include "session_impl.hpp"
#include "spear/aliases.hpp"
#include "spear/log.hpp"
#include "spear/version.hpp"
#include "trace_process.hpp"

namespace spear {

const std::vector<EntryPointRow>& entry_point_rows() {
    static const auto* const rows = [] {
        auto* table = new std::vector<EntryPointRow>;
        AllEntryPoints::for_each([&](auto entry_point) {
            using E = decltype(entry_point);
            table->push_back({E::name, E::runs_on, E::signature()});
        });
        return table;
    }();
    return *rows;
}

namespace {

std::string default_client_name() { return fmt::format("{} (process {})", program_invocation_short_name, ::getpid()); }

/// ", scene apartment" of the engine at an address, for messages; empty if it does not say soon.
std::string scene_at(const std::string& address) {
    spear_description description{};
    spear_wire_error error{};
    return spear_describe(address.c_str(), 300, &description, &error) == 0 && description.scene[0] != 0
               ? fmt::format(", scene {}", description.scene)
               : std::string();
}

std::uint32_t to_wire(Milliseconds time) {
    return static_cast<std::uint32_t>(
        std::clamp<Milliseconds::rep>(time.count(), 0, std::numeric_limits<std::uint32_t>::max() - 1));
}

} // namespace

// Connection

Session::Impl::Impl() : serial([] {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}()) {}

Session::Session(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Session::~Session() { close(); }

std::shared_ptr<Session> Session::connect(const SessionOptions& options) {
    auto impl = std::make_unique<Impl>();
    impl->deadline_ms = options.deadline.count();

    std::vector<const char*> signatures;
    for (const EntryPointRow& row : entry_point_rows()) {
        signatures.push_back(row.signature.c_str());
    }
    const std::string client_name = options.client_name.empty() ? default_client_name() : options.client_name;
    const std::string own_version(version);

    std::string address = options.address;
    if (address.empty()) { // the only engine of this user that runs
        using Found = std::vector<std::pair<std::string, std::uint64_t>>;
        Found found;
        spear_list_engines(nullptr, &found, [](void* user, const char* engine_address, std::uint64_t process_id) {
            static_cast<Found*>(user)->emplace_back(engine_address, process_id);
        });
        if (found.empty()) {
            throw_error(ErrorCode::EngineNotRunning,
                "No engine of this user runs. Start one with `spear engine` or spear::launch, or give an address.",
                "connect");
        }
        if (found.size() > 1) {
            std::string list;
            for (const auto& [engine_address, process_id] : found) {
                list += fmt::format("\n  {} (process {}{})", engine_address, process_id, scene_at(engine_address));
            }
            throw_error(ErrorCode::AmbiguousName,
                fmt::format("{} engines run; give the address of one of them:{}", found.size(), list), "connect");
        }
        address = found.front().first;
    }

    spear_client_options wire{};
    wire.address = address.c_str();
    wire.token = reinterpret_cast<const std::uint8_t*>(options.token.data());
    wire.token_size = options.token.size();
    wire.spear_version = own_version.c_str();
    wire.client_name = client_name.c_str();
    wire.lease_ms = options.no_lease ? std::uint32_t{SPEAR_LEASE_OFF} : to_wire(options.lease);
    wire.connect_timeout_ms = std::max(1u, to_wire(options.connect_timeout));
    wire.max_message_bytes = limits::max_message_bytes;
    wire.entry_points = signatures.data();
    wire.entry_point_count = signatures.size();
    wire.no_channel = !options.channel;
    wire.no_spin = !options.spin;
    const spear_client_callbacks callbacks{impl.get(), &Impl::on_answers, &Impl::on_lost, &Impl::on_attend};
    spear_wire_error error{};
    spear_client* const client = spear_client_connect(&wire, &callbacks, &error);
    if (!client) {
        throw_error(static_cast<ErrorCode>(error.code), error.message, "connect");
    }
    impl->address = address;
    impl->session_id = spear_client_session(client);
    {
        const std::lock_guard lock(impl->mutex);
        impl->client = client;
        impl->has_channel = spear_client_has_channel(client) != 0;
    }
    std::shared_ptr<Session> session(new Session(std::move(impl)));
    detail::trace_session_connected(session);
    return session;
}

void Session::close() noexcept {
    try {
        Impl& impl = *impl_;
        impl.abandon();
        detail::trace_session_closes(*this);
        spear_client* client = nullptr;
        {
            Impl::Lock lock(impl.mutex);
            if (impl.is_closed) {
                return;
            }
            impl.is_closed = true;
            impl.loss_explainer = nullptr;
            impl.lose({ErrorCode::Disconnected,
                fmt::format("The session with the engine at {} was closed.", impl.address), {}, {}, {}});
            impl.changed.wait(lock, [&] { return impl.calls_outside == 0; });
            client = std::exchange(impl.client, nullptr);
        }
        spear_client_close(client);
        for (const ErrorInfo& failure : take_failures()) {
            log_message(LogLevel::warning, fmt::format("a fire-and-forget operation had failed: {}: {}",
                                               error_name(failure.code), failure.message));
        }
    } catch (const std::exception& exception) {
        log_message(LogLevel::error, std::string("a session could not be closed: ") + exception.what());
    }
}

bool Session::is_open() const noexcept {
    const std::lock_guard lock(impl_->mutex);
    return !impl_->lost;
}

std::uint64_t Session::id() const noexcept { return impl_->session_id; }
const std::string& Session::address() const noexcept { return impl_->address; }
bool Session::uses_channel() const noexcept { return impl_->has_channel; }
Milliseconds Session::deadline() const noexcept { return impl_->deadline(); }
void Session::set_deadline(Milliseconds deadline) noexcept { impl_->deadline_ms = deadline.count(); }

Session::Status Session::status(Milliseconds timeout) {
    Impl::Lock lock(impl_->mutex);
    return impl_->status(lock, timeout);
}

Session::Statistics Session::statistics(std::optional<Milliseconds> timeout) {
    Impl::Lock lock(impl_->mutex);
    return impl_->statistics(lock, timeout.value_or(deadline()));
}

void Session::set_loss_explainer(LossExplainer explainer) {
    const std::lock_guard lock(impl_->mutex);
    impl_->loss_explainer = std::move(explainer);
}

// Blocks

void Session::open_block(BlockKind kind) { impl_->open(kind); }
void Session::close_block(BlockKind kind, bool single_step) { impl_->close(kind, single_step); }
void Session::abandon_transaction() noexcept { impl_->abandon(); }

std::optional<BlockKind> Session::open_block_of_this_thread() const noexcept {
    const std::lock_guard lock(impl_->mutex);
    return impl_->is_block_open() && impl_->is_owner() ? std::optional(impl_->open_kind()) : std::nullopt;
}

bool Session::is_transaction_open() const noexcept {
    const std::lock_guard lock(impl_->mutex);
    return impl_->phase != Impl::Phase::idle;
}

void Session::flush() { impl_->flush(); }

std::vector<ErrorInfo> Session::take_failures() {
    const std::lock_guard lock(impl_->mutex);
    impl_->take_answers();
    std::vector<ErrorInfo> taken;
    for (const Failure& failure : std::exchange(impl_->failures, {})) {
        taken.push_back(*failure.error);
    }
    return taken;
}

// Types

TypeTables Session::types() const noexcept { return {&impl_->announcer.table(), &impl_->server_types}; }

TypeId Session::number_of(const TypeInfo& info) {
    const std::lock_guard lock(impl_->mutex);
    const TypeTable& table = impl_->announcer.table();
    if (table.next() - table.first() >= limits::max_announcements) {
        throw_error(
            ErrorCode::LimitExceeded, fmt::format("This session has announced {} types, call shapes and property "
                                                  "paths, which is the limit (limits::max_announcements).",
                                          limits::max_announcements));
    }
    return impl_->announcer.number_of(info);
}

namespace {

/// The key of a shape, built in a buffer that each thread keeps: naming a function again costs no allocation.
std::string& shape_key(std::string_view kind, std::string_view name, std::span<const std::string_view> argument_names) {
    thread_local std::string key;
    key.assign(kind).append(name);
    for (const std::string_view argument : argument_names) {
        key.push_back('\0');
        key.append(argument);
    }
    return key;
}

} // namespace

template <typename F>
ShapeId Session::Impl::shape(Session& session, const std::string& key, F&& make) {
    {
        const std::lock_guard lock(mutex);
        if (const auto found = shapes.find(key); found != shapes.end()) {
            return {found->second};
        }
    }
    const TypeId number = session.number_of(make());
    const std::lock_guard lock(mutex);
    shapes.emplace(key, number);
    return {number};
}

namespace {

/// The shapes that a thread has used lately, found by where their names lie and compared by what they say: naming a
/// function again takes neither lock nor hash.
struct RecentShape {
    std::uint64_t session = 0; // its serial number
    TypeId shape = types::null;
    std::uint16_t size = 0;
    std::array<char, 78> key{}; // the function's name, then a zero and a name for each argument
};
constinit thread_local std::array<RecentShape, 64> recent_shapes{};

RecentShape& recent_shape(std::string_view function, std::size_t arguments) {
    return recent_shapes[(reinterpret_cast<std::uintptr_t>(function.data()) / 4 + function.size() + arguments * 7) % 64];
}

bool says(const RecentShape& recent, std::string_view function, std::span<const std::string_view> argument_names) {
    std::string_view rest(recent.key.data(), recent.size);
    if (!rest.starts_with(function)) {
        return false;
    }
    rest.remove_prefix(function.size());
    for (const std::string_view argument : argument_names) {
        if (rest.size() <= argument.size() || rest.front() != '\0' || rest.substr(1, argument.size()) != argument) {
            return false;
        }
        rest.remove_prefix(1 + argument.size());
    }
    return rest.empty();
}

void remember(RecentShape& recent, std::uint64_t session, std::string_view function,
    std::span<const std::string_view> argument_names, TypeId shape) {
    std::size_t size = function.size();
    for (const std::string_view argument : argument_names) {
        size += 1 + argument.size();
    }
    if (size > recent.key.size()) {
        return;
    }
    char* at = std::ranges::copy(function, recent.key.begin()).out;
    for (const std::string_view argument : argument_names) {
        *at++ = '\0';
        at = std::ranges::copy(argument, at).out;
    }
    recent.session = session;
    recent.shape = shape;
    recent.size = static_cast<std::uint16_t>(size);
}

} // namespace

ShapeId Session::call_shape(std::string_view function, std::span<const std::string_view> argument_names) {
    RecentShape& recent = recent_shape(function, argument_names.size());
    if (recent.session == impl_->serial && says(recent, function, argument_names)) {
        return {recent.shape};
    }
    const ShapeId shape = impl_->shape(*this, shape_key("call ", function, argument_names), [&] {
        TypeInfo info;
        info.kind = TypeKind::call_shape;
        info.name = resolve_function_alias(function);
        if (info.name != function) {
            info.path = function; // tried first, see aliases.hpp
        }
        for (const std::string_view argument : argument_names) {
            info.fields.push_back({std::string(argument), types::any});
        }
        return info;
    });
    remember(recent, impl_->serial, function, argument_names, shape.number);
    return shape;
}

ShapeId Session::path_shape(std::string_view path) {
    return impl_->shape(*this, shape_key("path ", path, {}), [&] {
        TypeInfo info;
        info.kind = TypeKind::path_shape;
        info.name = path;
        return info;
    });
}

std::string Session::Impl::describe(std::uint16_t entry_point, TypeId shape) const {
    if (const TypeInfo* info = announcer.table().find(shape)) {
        return info->name;
    }
    const auto& rows = entry_point_rows();
    return entry_point < rows.size() ? std::string(rows[entry_point].name) : "an operation";
}

std::string Session::describe_operation(std::uint16_t entry_point, TypeId shape) const {
    return impl_->describe(entry_point, shape);
}

namespace detail {

std::shared_ptr<Session> session_of_context(void* user) {
    return user ? static_cast<Session*>(user)->shared_from_this() : nullptr;
}

void throw_result_error(CodecError error, const RawResult& result, Session& session, std::string_view wanted) {
    const std::string name = session.describe_operation(result.entry_point, result.shape);
    if (error == CodecError::malformed) {
        throw_error(
            ErrorCode::MalformedMessage, fmt::format("The result of {} is not a value of this protocol.", name), name);
    }
    const Value value = Value::decode(result.view, session.value_context());
    throw_error(error == CodecError::out_of_range ? ErrorCode::OutOfRange : ErrorCode::WrongType,
        fmt::format("The result of {} is of type {} and {} {}: {}. Ask for another type, or for a spear::Value.", name,
            value.type_name(), error == CodecError::out_of_range ? "is outside the range of" : "cannot be read as",
            wanted, to_string(value)),
        name, {}, std::string(wanted));
}

} // namespace detail
} // namespace spear
