// SPDX-License-Identifier: MIT
#include "spear/launch.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <mutex>
#include <random>
#include <thread>

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "spear/error.hpp"
#include "spear/log.hpp"
#include "spear_wire.h"

namespace spear {
namespace {

namespace fs = std::filesystem;

constexpr const char* engine_name = "spear-engine";

bool is_executable(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

/// The folder of the program or shared library that this code is linked into.
fs::path own_folder() {
    Dl_info info{};
    std::error_code error;
    if (::dladdr(reinterpret_cast<const void*>(&find_engine_executable), &info) != 0 && info.dli_fname &&
        *info.dli_fname) {
        const fs::path path = fs::canonical(info.dli_fname, error);
        if (!error)
            return path.parent_path();
    }
    const fs::path path = fs::read_symlink("/proc/self/exe", error);
    return error ? fs::path() : path.parent_path();
}

fs::path runtime_directory() {
    std::array<char, 512> buffer{};
    if (spear_runtime_directory(buffer.data(), buffer.size()) == 0) {
        throw_error(ErrorCode::LaunchFailed,
            "There is no private directory for the engine's socket: neither $XDG_RUNTIME_DIR nor /tmp can be used.",
            "launch");
    }
    return buffer.data();
}

std::string unique_name() {
    static std::atomic<unsigned> count{0};
    return fmt::format("engine-{}-{}", ::getpid(), ++count);
}

/// 256 random bits.
std::string random_token() {
    std::random_device random;
    std::string token;
    for (int i = 0; i < 8; ++i)
        token += fmt::format("{:08x}", random());
    return token;
}

/// Raises LaunchFailed.
void write_private(const fs::path& file, const std::string& text) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0600);
    const bool written =
        descriptor >= 0 && ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    const int error = errno;
    if (descriptor >= 0)
        ::close(descriptor);
    if (!written) {
        throw_error(ErrorCode::LaunchFailed,
            fmt::format(
                "The file {} for the engine's token cannot be written: {}.", file.string(), std::strerror(error)),
            "launch");
    }
}

std::string last_lines(const fs::path& file, std::size_t lines, std::size_t bytes = 8192) {
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    if (!in)
        return {};
    const auto size = static_cast<std::size_t>(in.tellg());
    const std::size_t start = size > bytes ? size - bytes : 0;
    in.seekg(static_cast<std::streamoff>(start));
    std::string text(size - start, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    std::size_t at = text.size();
    for (std::size_t n = 0; n < lines && at != std::string::npos && at != 0; ++n)
        at = text.rfind('\n', at - 1);
    return at == std::string::npos || at == 0 ? text : text.substr(at + 1);
}

std::string describe_status(int status) {
    if (WIFEXITED(status))
        return fmt::format("exit code {}", WEXITSTATUS(status));
    if (WIFSIGNALED(status))
        return fmt::format("signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
    return fmt::format("status {}", status);
}

std::vector<std::string> command_line(const LaunchOptions& options, const fs::path& executable,
    const std::string& address, const fs::path& token_file, const std::string& mark) {
    std::vector<std::string> line{executable.string()};
    const auto add = [&line](const char* option, std::string value) {
        line.emplace_back(option);
        line.push_back(std::move(value));
    };
    if (!options.scene.empty())
        add("--scene", options.scene);
    if (options.fps)
        add("--fps", fmt::format("{}", *options.fps));
    if (options.fixed_dt)
        add("--fixed-dt", fmt::format("{}", *options.fixed_dt));
    if (options.seed)
        add("--seed", fmt::format("{}", *options.seed));
    if (options.paused)
        line.emplace_back("--paused");
    line.insert(line.end(), options.arguments.begin(), options.arguments.end());
    line.push_back("-SpearAddress=" + address);
    line.emplace_back("-SpearMustListen"); // without, an engine that cannot listen there would run on
    line.push_back(mark);
    if (!token_file.empty())
        line.push_back("-SpearTokenFile=" + token_file.string());
    return line;
}

} // namespace

std::filesystem::path find_engine_executable() {
    std::string looked;
    const auto note = [&looked](const fs::path& path) { looked += "\n  " + path.string(); };
    if (const char* set = std::getenv("SPEAR_ENGINE"); set && *set) {
        if (is_executable(set))
            return set;
        throw_error(ErrorCode::LaunchFailed,
            fmt::format("The environment variable SPEAR_ENGINE names {}, which is no executable file.", set), "launch");
    }
    if (const fs::path folder = own_folder(); !folder.empty()) {
        for (const fs::path& candidate :
            {folder / engine_name, folder / "bin" / engine_name, folder.parent_path() / "bin" / engine_name}) {
            if (is_executable(candidate))
                return candidate.lexically_normal();
            note(candidate);
        }
    }
    if (const char* path = std::getenv("PATH")) {
        std::string_view rest(path);
        while (!rest.empty()) {
            const std::size_t end = rest.find(':');
            const fs::path folder(rest.substr(0, end));
            if (!folder.empty() && is_executable(folder / engine_name))
                return folder / engine_name;
            rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
        }
        looked += "\n  the folders of PATH";
    }
    throw_error(ErrorCode::LaunchFailed,
        fmt::format(
            "No {} was found. Set the environment variable SPEAR_ENGINE, or LaunchOptions::executable. Looked at:{}",
            engine_name, looked),
        "launch");
}

/// The process is started, and waited for, by a thread of its own: the kernel ends the child when the *thread* that
/// started it ends (PR_SET_PDEATHSIG), so that must not be a thread of the user's that happens to finish.
struct EngineProcess::Impl {
    std::string address;
    fs::path executable;
    fs::path log_file;
    fs::path socket_file; // made for this launch; removed at the end
    fs::path token_file;  // likewise
    std::string token;
    std::string mark; // an argument that no other engine has
    bool is_own_log = false;
    std::vector<std::string> arguments;

    mutable std::mutex mutex;
    mutable std::condition_variable changed;
    bool is_started = false; // or failed to
    int start_errno = 0;
    pid_t process_id = 0;
    bool has_ended = false;
    bool was_asked_to_end = false;
    mutable bool was_described = false; // an error has told how it ended
    int exit_status = 0;

    static void run(const std::shared_ptr<Impl>& self);
    void start(int log, std::vector<char*>& argv, int report);
};

/// Between fork and exec: only what is allowed after fork in a program with threads.
void EngineProcess::Impl::start(int log, std::vector<char*>& argv, int report) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    ::setpgid(0, 0); // Ctrl-C in the terminal is for the program, which then ends its engine in good order
    const int null = ::open("/dev/null", O_RDONLY);
    ::dup2(null, STDIN_FILENO);
    ::dup2(log, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
    ::execv(argv[0], argv.data());
    const int error = errno;
    [[maybe_unused]] const auto written = ::write(report, &error, sizeof error);
    ::_exit(127);
}

void EngineProcess::Impl::run(const std::shared_ptr<Impl>& self) {
    sigset_t all;
    sigfillset(&all);
    ::pthread_sigmask(SIG_BLOCK, &all, nullptr);
    ::pthread_setname_np(::pthread_self(), "spear-launch");

    std::vector<char*> argv;
    for (std::string& argument : self->arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    const auto finish_start = [&self](pid_t process_id, int error) {
        const std::lock_guard lock(self->mutex);
        self->process_id = process_id;
        self->start_errno = error;
        self->is_started = true;
        self->has_ended = error != 0;
        self->changed.notify_all();
    };
    const int log = ::open(self->log_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0600);
    if (log < 0)
        return finish_start(0, errno);
    int report[2];
    if (::pipe2(report, O_CLOEXEC) != 0) {
        const int error = errno;
        ::close(log);
        return finish_start(0, error);
    }
    const pid_t process_id = ::fork();
    if (process_id == 0) {
        self->start(log, argv, report[1]);
    }
    const int fork_error = process_id < 0 ? errno : 0;
    ::close(log);
    ::close(report[1]);
    int exec_error = 0;
    const auto got = fork_error == 0 ? ::read(report[0], &exec_error, sizeof exec_error) : 0;
    ::close(report[0]);
    const int error = fork_error != 0 ? fork_error : got == sizeof exec_error ? exec_error : 0;
    if (error == 0)
        finish_start(process_id, 0);
    siginfo_t info{};
    while (process_id > 0 && ::waitid(P_PID, static_cast<id_t>(process_id), &info, WEXITED | WNOWAIT) != 0 &&
           errno == EINTR) {}
    // Its number is free for others once it has been waited for: under the mutex, so that terminate() never signals a
    // stranger.
    std::unique_lock lock(self->mutex);
    int status = 0;
    if (process_id > 0)
        ::waitpid(process_id, &status, 0);
    if (error != 0) {
        lock.unlock();
        return finish_start(0, error);
    }
    self->exit_status = status;
    self->has_ended = true;
    self->changed.notify_all();
}

EngineProcess::EngineProcess(const LaunchOptions& options) : impl_(std::make_shared<Impl>()) {
    (void)spear_remove_leftovers(nullptr, 0, nullptr, nullptr);
    impl_->executable = options.executable.empty() ? find_engine_executable() : options.executable;
    const std::string name = unique_name();
    if (options.address.empty()) {
        fs::path socket = runtime_directory() / (name + ".sock");
        if (socket.string().size() > 100) { // a socket's path has at most 107 bytes
            socket = fs::temp_directory_path() / fmt::format("spear-{}-{}.sock", ::getuid(), name);
        }
        impl_->socket_file = socket;
        impl_->address = "unix:" + socket.string();
    } else {
        impl_->address = options.address;
    }
    impl_->is_own_log = options.log_file.empty();
    impl_->log_file = impl_->is_own_log ? runtime_directory() / (name + ".log") : options.log_file;
    impl_->token = options.token;
    if (impl_->token.empty() && !spear_address_is_local(impl_->address.c_str())) {
        impl_->token = random_token();
    }
    if (!impl_->token.empty()) { // in a file: a command line is for everybody to read
        impl_->token_file = runtime_directory() / (name + ".token");
        write_private(impl_->token_file, impl_->token);
    }
    impl_->mark = "-SpearLaunch=" + random_token().substr(0, 16);
    impl_->arguments = command_line(options, impl_->executable, impl_->address, impl_->token_file, impl_->mark);

    std::thread(Impl::run, impl_).detach();
    std::unique_lock lock(impl_->mutex);
    impl_->changed.wait(lock, [this] { return impl_->is_started; });
    if (impl_->start_errno != 0) {
        std::error_code ignored;
        if (impl_->is_own_log)
            fs::remove(impl_->log_file, ignored);
        throw_error(ErrorCode::LaunchFailed,
            fmt::format("{} could not be started: {}.", impl_->executable.string(), std::strerror(impl_->start_errno)),
            "launch");
    }
}

EngineProcess::~EngineProcess() {
    terminate();
    (void)spear_remove_leftovers(nullptr, 0, nullptr, nullptr); // what it could not remove itself, if it was killed
    std::error_code ignored;
    for (const fs::path* const file : {&impl_->socket_file, &impl_->token_file}) {
        if (!file->empty())
            fs::remove(*file, ignored);
    }
    const std::lock_guard lock(impl_->mutex);
    if (impl_->is_own_log) {
        const bool ended_well = WIFEXITED(impl_->exit_status) && WEXITSTATUS(impl_->exit_status) == 0;
        const bool was_killed_by_us = impl_->was_asked_to_end && WIFSIGNALED(impl_->exit_status);
        if (ended_well || was_killed_by_us) {
            fs::remove(impl_->log_file, ignored);
        } else if (!impl_->was_described) {
            log_message(LogLevel::warning, fmt::format("the engine ended with {}; its log is {}",
                                               describe_status(impl_->exit_status), impl_->log_file.string()));
        }
    }
}

const std::filesystem::path& EngineProcess::executable() const noexcept { return impl_->executable; }
const std::string& EngineProcess::address() const noexcept { return impl_->address; }
const std::string& EngineProcess::token() const noexcept { return impl_->token; }
std::int64_t EngineProcess::process_id() const noexcept { return impl_->process_id; }
const std::filesystem::path& EngineProcess::log_file() const noexcept { return impl_->log_file; }

bool EngineProcess::find_port() {
    if (!impl_->address.starts_with("tcp:") || !impl_->address.ends_with(":0"))
        return true;
    struct Wanted {
        std::uint64_t process_id;
        std::string address;
    } wanted{static_cast<std::uint64_t>(impl_->process_id), {}};
    spear_list_engines(nullptr, &wanted, [](void* user, const char* address, std::uint64_t process_id) {
        auto& looked_for = *static_cast<Wanted*>(user);
        if (process_id == looked_for.process_id)
            looked_for.address = address;
    });
    if (wanted.address.empty())
        return false;
    impl_->address = wanted.address;
    return true;
}

bool EngineProcess::has_command_line(std::string_view command_line) const {
    return command_line.find(impl_->mark) != std::string_view::npos;
}

bool EngineProcess::is_running() const noexcept {
    const std::lock_guard lock(impl_->mutex);
    return !impl_->has_ended;
}

bool EngineProcess::wait(Milliseconds timeout) const noexcept {
    std::unique_lock lock(impl_->mutex);
    return impl_->changed.wait_for(lock, timeout, [this] { return impl_->has_ended; });
}

void EngineProcess::terminate() noexcept {
    const auto end_with = [this](int signal, Milliseconds patience) {
        {
            const std::lock_guard lock(impl_->mutex);
            if (impl_->has_ended)
                return true;
            impl_->was_asked_to_end = true;
            ::kill(impl_->process_id, signal);
        }
        return wait(patience);
    };
    if (!end_with(SIGTERM, Milliseconds(5000))) {
        end_with(SIGKILL, Milliseconds(5000));
    }
}

std::optional<ErrorInfo> EngineProcess::describe_exit() const {
    const std::lock_guard lock(impl_->mutex);
    if (!impl_->has_ended)
        return {};
    impl_->was_described = true;
    const std::string log = last_lines(impl_->log_file, 12);
    return ErrorInfo{ErrorCode::EngineExited,
        fmt::format("The engine {} (process {}) has ended with {}. {}", impl_->executable.string(), impl_->process_id,
            describe_status(impl_->exit_status),
            log.empty() ? fmt::format("It wrote nothing to its log, {}.", impl_->log_file.string())
                        : fmt::format("The last lines of its log, {}:\n{}\n", impl_->log_file.string(), log)),
        {}, {}, {}};
}

} // namespace spear
