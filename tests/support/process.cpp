#include "support/process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace drape::test {

namespace {

void redirect(const std::filesystem::path& file, int descriptor) {
    const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(opened, descriptor);
    close(opened);
}

int code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 256 + WTERMSIG(status); }

}  // namespace

Process::Process(const std::vector<std::string>& words, const std::map<std::string, std::string>& environment,
                 const std::filesystem::path& folder)
    : folder_(folder) {
    std::vector<std::string> copies = words;
    std::vector<char*> arguments;
    for (std::string& word : copies) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    id_ = fork();
    if (id_ != 0) return;
    std::signal(SIGHUP, SIG_DFL);  // whatever the tests run under
    for (const auto& [name, value] : environment) {
        if (value.empty()) {
            unsetenv(name.c_str());
        } else {
            setenv(name.c_str(), value.c_str(), 1);
        }
    }
    redirect("/dev/null", STDIN_FILENO);
    redirect(folder / "stdout.txt", STDOUT_FILENO);
    redirect(folder / "stderr.txt", STDERR_FILENO);
    if (chdir(folder.c_str()) == 0) execvp(arguments.front(), arguments.data());
    _exit(127);
}

Process::~Process() {
    if (!running()) return;
    send(SIGTERM);
    if (wait(5)) return;
    send(SIGKILL);
    wait(5);
}

void Process::send(int signal) const {
    if (!status_) kill(id_, signal);
}

bool Process::running() { return !wait(0); }

std::optional<int> Process::wait(double seconds) {
    eventually(
        [&] {
            int status = 0;
            if (!status_ && waitpid(id_, &status, WNOHANG) == id_) status_ = code_of(status);
            return status_.has_value();
        },
        seconds);
    return status_;
}

int Process::wait_to_end() {
    int status = 0;
    if (!status_ && waitpid(id_, &status, 0) == id_) status_ = code_of(status);
    return status_.value_or(-1);
}

std::string Process::standard_output() const { return read_file(folder_ / "stdout.txt"); }

std::string Process::standard_error() const { return read_file(folder_ / "stderr.txt"); }

double Process::processor_time() const {
    // Fields 14 and 15, counted after the name in brackets, which may hold spaces.
    const std::string text = read_file("/proc/" + std::to_string(id_) + "/stat");
    std::istringstream fields(text.substr(text.rfind(')') + 1));
    std::string field;
    for (int n = 3; n < 14; ++n) fields >> field;
    double user = 0, system = 0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

long long Process::sleeps() const {
    const std::string text = read_file("/proc/" + std::to_string(id_) + "/status"),
                      title = "\nvoluntary_ctxt_switches:";
    const std::size_t found = text.find(title);
    return found == std::string::npos ? 0 : std::atoll(text.c_str() + found + title.size());
}

std::string read_file(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    if (!std::filesystem::is_directory(folder)) return names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

void sleep_for(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

}  // namespace drape::test
