#include "child_program.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "drape/base/input_error.h"

extern char** environ;

namespace drape {
namespace {

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

/// What the child does between its start and its program.
class StartingPlace {
public:
    explicit StartingPlace(const std::filesystem::path& folder) {
        posix_spawn_file_actions_init(&actions_);
        if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    }
    ~StartingPlace() { posix_spawn_file_actions_destroy(&actions_); }
    StartingPlace(const StartingPlace&) = delete;
    StartingPlace& operator=(const StartingPlace&) = delete;

    [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

}  // namespace

std::optional<int> run_child(std::vector<std::string> words, const std::filesystem::path& folder) {
    const std::string program = find_program(words.front());
    if (program.empty()) return std::nullopt;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const StartingPlace place(folder);
    pid_t process = -1;
    const int error = posix_spawn(&process, program.c_str(), place.actions(), nullptr, arguments.data(), environ);
    if (error != 0) throw RunError(words[0] + " cannot be started: " + std::strerror(error));
    int status = 0;
    while (waitpid(process, &status, 0) < 0) {
        if (errno != EINTR) throw RunError(words[0] + " is lost: " + std::strerror(errno));
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace drape
