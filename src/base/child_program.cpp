#include "drape/base/child_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <utility>

#include "drape/base/assert.h"
#include "drape/base/input_error.h"

extern char** environ;

namespace drape {
namespace {

std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// The whole path of a program; empty if there is none. PATH may name folders from here, which a program that starts
/// elsewhere would take for others.
std::string find_program(const std::string& name) {
    if (name.find('/') != std::string::npos) {
        return access(name.c_str(), F_OK) == 0 ? std::filesystem::absolute(name).string() : "";
    }
    const char* set = std::getenv("PATH");
    const std::string all = set != nullptr ? set : "/usr/local/bin:/usr/bin:/bin";
    for (std::size_t begin = 0; begin <= all.size();) {
        const std::size_t end = std::min(all.find(':', begin), all.size());
        const std::filesystem::path entry = all.substr(begin, end - begin);
        const auto file = std::filesystem::absolute(entry.empty() ? "." : entry) / name;
        std::error_code none;
        if (is_regular_file(file, none) && access(file.c_str(), X_OK) == 0) return file.string();
        begin = end + 1;
    }
    return "";
}

}  // namespace

ChildProgram::ChildProgram(std::vector<std::string> words, Input input, const std::filesystem::path& folder) {
    const std::string program = find_program(words.front());
    if (program.empty()) {
        error_ = ENOENT;
        return;
    }
    std::array<int, 2> ends{-1, -1};
    const bool fed = input == Input::Fed;
    if (fed && pipe2(ends.data(), O_CLOEXEC) != 0) {
        error_ = errno;
        return;
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (fed) posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    // It would inherit what is blocked here, and what this program ignores for itself
    sigset_t none, ours;
    sigemptyset(&none);
    sigemptyset(&ours);
    sigaddset(&ours, SIGPIPE);
    sigaddset(&ours, SIGXFSZ);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &ours);
    posix_spawnattr_setpgroup(&attributes, 0);
    const int flags = POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | (fed ? POSIX_SPAWN_SETPGROUP : 0);
    posix_spawnattr_setflags(&attributes, static_cast<short>(flags));
    const std::vector<char*> arguments = pointers_to(words);
    error_ = posix_spawn(&process_, program.c_str(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error_ != 0) process_ = -1;
    if (!fed) return;
    close(ends[0]);
    feed_ = ends[1];
    fcntl(feed_, F_SETFL, O_NONBLOCK);
    if (error_ != 0) end_feed();
}

ChildProgram::~ChildProgram() {
    end_feed();
    if (process_ >= 0) wait();
}

void ChildProgram::end_feed() {
    if (feed_ >= 0) close(std::exchange(feed_, -1));
}

std::optional<int> ChildProgram::look(bool blocking) {
    DRAPE_ASSERT(process_ >= 0);
    if (code_) return code_;
    int status = 0;
    pid_t ended = 0;
    do {
        ended = waitpid(process_, &status, blocking ? 0 : WNOHANG);
    } while (ended < 0 && errno == EINTR);
    if (ended < 0) throw RunError(std::string("a child program cannot be waited for: ") + std::strerror(errno));
    if (ended > 0) code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return code_;
}

int ChildProgram::wait() { return *look(true); }

std::optional<int> ChildProgram::wait(double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (!look(false) && Clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return code_;
}

void ChildProgram::kill() {
    DRAPE_ASSERT(process_ > 0);
    if (!code_) ::kill(process_, SIGKILL);
}

std::optional<int> run_child(std::vector<std::string> words, const std::filesystem::path& folder) {
    const std::string name = words[0];
    ChildProgram child(std::move(words), ChildProgram::Input::Shared, folder);
    if (child.error() == ENOENT) return std::nullopt;
    if (child.error() != 0) throw RunError(name + " cannot be started: " + std::strerror(child.error()));
    return child.wait();
}

void become_program(std::vector<std::string> words) {
    const std::vector<char*> arguments = pointers_to(words);
    execv(arguments[0], arguments.data());
    throw RunError("cannot run " + words[0] + ": " + std::strerror(errno));
}

}  // namespace drape
