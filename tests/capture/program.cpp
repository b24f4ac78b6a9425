#include "program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

namespace drape::test {

namespace {

namespace fs = std::filesystem;

pid_t start(const std::string& name, const std::vector<std::string>& arguments,
            const std::vector<std::string>& environment, const std::string& out, const std::string& err) {
    const std::string program = std::string(DRAPE_PROGRAMS) + "/" + name;
    std::vector<std::string> words{"/usr/bin/env"};
    words.insert(words.end(), environment.begin(), environment.end());
    words.push_back(program);
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    execv(pointers[0], pointers.data());
    _exit(127);
}

int wait_for(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The child stays to be waited for.
bool has_ended(pid_t child) {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == child;
}

}  // namespace

Outcome run_program(const std::string& name, const std::vector<std::string>& arguments,
                    const std::vector<std::string>& environment) {
    const TestFolder folder;
    Outcome outcome;
    outcome.exit_code = wait_for(start(name, arguments, environment, folder / "out", folder / "err"));
    outcome.out = text_of(folder / "out");
    outcome.err = text_of(folder / "err");
    return outcome;
}

Outcome interrupt_program(const std::string& name, const std::vector<std::string>& arguments, const fs::path& file,
                          int signal) {
    const TestFolder folder;
    const pid_t child = start(name, arguments, {}, folder / "out", folder / "err");
    while (!fs::exists(file) && !has_ended(child)) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    kill(child, signal);
    Outcome outcome;
    outcome.exit_code = wait_for(child);
    outcome.out = text_of(folder / "out");
    outcome.err = text_of(folder / "err");
    return outcome;
}

TestFolder::TestFolder() {
    std::string name = (fs::temp_directory_path() / "drape-test-XXXXXX").string();
    if (mkdtemp(name.data())) path_ = name;
}

TestFolder::~TestFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::vector<std::string> TestFolder::names(const std::string& folder) const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(path_ / folder)) all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
}

std::string text_of(const fs::path& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

}  // namespace drape::test
