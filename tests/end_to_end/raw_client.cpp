// SPDX-License-Identifier: MIT
#include "raw_client.hpp"

#include "spear/version.hpp"

namespace end_to_end {

namespace {

std::vector<std::byte> copy(const spear_bytes& bytes) {
    const auto* data = reinterpret_cast<const std::byte*>(bytes.data);
    return {data, data + bytes.size};
}

spear_bytes view(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

template <typename F>
void for_each_answer(const std::vector<std::byte>& answers, F&& f) {
    spear::Decoder in(answers);
    while (in.ok() && in.remaining() != 0) {
        const auto number = in.get<std::uint64_t>();
        const auto state = in.get<spear::AnswerState>();
        f(number, state, in.get_raw(in.get<std::uint32_t>()));
    }
    CHECK(in.ok());
}

} // namespace

std::map<std::uint64_t, std::vector<std::byte>> RawClient::Reply::values() const {
    std::map<std::uint64_t, std::vector<std::byte>> found;
    for_each_answer(answers, [&](std::uint64_t number, spear::AnswerState state, std::span<const std::byte> bytes) {
        if (state == spear::AnswerState::succeeded)
            found[number] = {bytes.begin(), bytes.end()};
    });
    return found;
}

std::map<std::uint64_t, spear::ErrorInfo> RawClient::Reply::errors() const {
    std::map<std::uint64_t, spear::ErrorInfo> found;
    for_each_answer(answers, [&](std::uint64_t number, spear::AnswerState state, std::span<const std::byte> bytes) {
        if (state == spear::AnswerState::succeeded)
            return;
        spear::Decoder in(bytes);
        found[number] = spear::decode_error(in);
    });
    return found;
}

std::vector<std::string> RawClient::all_signatures() {
    std::vector<std::string> signatures;
    spear::AllEntryPoints::for_each(
        [&](auto entry_point) { signatures.push_back(decltype(entry_point)::signature()); });
    return signatures;
}

RawClient::RawClient(const std::vector<std::string>& entry_points, std::uint32_t lease_ms, spear::Instance& of) {
    std::vector<const char*> pointers;
    for (const std::string& one : entry_points) {
        pointers.push_back(one.c_str());
    }
    const std::string version(spear::version);
    spear_client_options options{};
    options.address = of.process()->address().c_str();
    options.spear_version = version.c_str();
    options.client_name = "a raw client";
    options.lease_ms = lease_ms;
    options.connect_timeout_ms = 60'000;
    options.max_message_bytes = spear::limits::max_message_bytes;
    options.entry_points = pointers.data();
    options.entry_point_count = pointers.size();
    const spear_client_callbacks callbacks{this, &on_answers, &on_lost, nullptr};
    client_ = spear_client_connect(&options, &callbacks, &connect_error_);
}

RawClient::~RawClient() { close(); }

void RawClient::close() {
    if (client_) {
        spear_client_close(client_);
        client_ = nullptr;
    }
}

std::uint64_t RawClient::submit(const Batch& batch) {
    spear_batch message{};
    message.transaction = batch.transaction;
    message.block = batch.block;
    message.closes = batch.closes;
    message.abort = batch.abort;
    message.single_step = batch.single_step;
    message.types = view(batch.types);
    message.operations = view(batch.operations);
    message.releases = batch.releases.data();
    message.release_count = batch.releases.size();
    const std::uint64_t request = ++last_request_;
    (void)spear_client_submit(client_, request, &message);
    return request;
}

std::optional<RawClient::Reply> RawClient::wait(std::uint64_t request, spear::Milliseconds timeout) {
    std::unique_lock lock(mutex_);
    const auto done = [&] { return lost_ || replies_.count(request) != 0; };
    if (client_ && spear_client_has_channel(client_)) {
        const auto ends = std::chrono::steady_clock::now() + timeout;
        for (take(); !done() && std::chrono::steady_clock::now() < ends; take()) {
            const std::uint32_t wakes = spear_client_wakes(client_);
            lock.unlock();
            spear_client_wait(client_, wakes, 10'000);
            lock.lock();
        }
    } else {
        changed_.wait_for(lock, timeout, done);
    }
    const auto at = replies_.find(request);
    return at != replies_.end() ? std::optional(at->second) : std::nullopt;
}

bool RawClient::lost() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, 60s, [&] { return lost_; });
}

void RawClient::take() {
    std::uint64_t request = 0;
    spear_answers answers{};
    while (spear_client_take(client_, &request, &answers) == 1) {
        add(request, answers);
    }
}

void RawClient::add(std::uint64_t request, const spear_answers& answers) {
    replies_[request] = {answers.has_error != 0, static_cast<spear::ErrorCode>(answers.error_code),
        answers.error_message ? answers.error_message : "", copy(answers.types), copy(answers.answers), answers.frame};
}

void RawClient::on_answers(void* user, std::uint64_t request, const spear_answers* answers) {
    auto& self = *static_cast<RawClient*>(user);
    const std::lock_guard lock(self.mutex_);
    self.add(request, *answers);
    self.changed_.notify_all();
}

void RawClient::on_lost(void* user, const spear_wire_error*) {
    auto& self = *static_cast<RawClient*>(user);
    const std::lock_guard lock(self.mutex_);
    if (self.client_ && spear_client_has_channel(self.client_)) {
        self.take();
    }
    self.lost_ = true;
    self.changed_.notify_all();
}

RawClient::Batch closing(std::uint64_t transaction, std::uint8_t block) {
    RawClient::Batch batch;
    batch.transaction = transaction;
    batch.block = block;
    batch.closes = true;
    return batch;
}

void add_find_class(RawClient::Batch& batch, std::uint64_t number, std::string_view name) {
    RawClient::add(
        batch, spear::unreal_service::find_class, number, [&](spear::Encoder& out) { put_text(out, name); });
}

void announce(RawClient::Batch& batch, spear::TypeId number, const spear::TypeInfo& info) {
    spear::Encoder out;
    spear::encode_announcement(out, number, info);
    batch.types.insert(batch.types.end(), out.buffer.begin(), out.buffer.end());
}

std::optional<spear::ErrorInfo> error_of(RawClient& client, std::uint64_t transaction, RawClient::Batch batch) {
    batch.transaction = transaction;
    batch.block = begin;
    batch.closes = true;
    const auto reply = client.exchange(batch);
    (void)client.exchange(closing(transaction, end));
    if (!reply || reply->errors().empty())
        return std::nullopt;
    return reply->errors().begin()->second;
}

} // namespace end_to_end
