#include "child_program.h"

#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>

#include "drape/base/input_error.h"

extern char** environ;

namespace drape {

std::optional<int> run_child(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t process = -1;
    const int error = posix_spawnp(&process, arguments[0], nullptr, nullptr, arguments.data(), environ);
    if (error == ENOENT) return std::nullopt;
    if (error != 0) throw RunError(words[0] + " cannot be started: " + std::strerror(error));
    int status = 0;
    while (waitpid(process, &status, 0) < 0) {
        if (errno != EINTR) throw RunError(words[0] + " is lost: " + std::strerror(errno));
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace drape
