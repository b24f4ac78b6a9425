#include <csignal>
#include <iostream>

#include "faults/fault.h"
#include "support/process.h"

namespace drape::faults {
namespace {

constexpr double longest_run = 600;  // s; what takes longer hangs, also on a machine that is busy

std::map<std::string, std::string> environment() {
    const std::string programs = DRAPE_PROGRAMS;
    return {{"CAPTURE", programs + "/drape-capture"}, {"LAB", programs + "/drape-lab"}};
}

Outcome outcome_of(test::Process& process) {
    const int code = process.wait(longest_run).value_or(-1);
    return {code, process.standard_output(), process.standard_error()};
}

}  // namespace

Trial::Trial(std::filesystem::path folder, unsigned long seed) : folder_(std::move(folder)), random_(seed) {
    std::filesystem::create_directories(folder_);
}

Outcome Trial::run(const std::string& line) const {
    test::Process process({"bash", "-c", line}, environment(), folder_);
    return outcome_of(process);
}

Outcome Trial::run_and_kill(const std::string& line, double seconds) const {
    test::Process process({"bash", "-c", "exec " + line}, environment(), folder_);
    test::sleep_for(seconds);
    process.send(SIGKILL);
    return outcome_of(process);
}

bool Trial::check(bool holds, const std::string& what, const Outcome& outcome) {
    ++tried_;
    if (holds) return true;
    ++failed_;
    std::cout << "FAILED: " << what << "\n  exit code " << outcome.code << "\n  " << outcome.err.substr(0, 400) << "\n";
    return false;
}

void Trial::skip(const std::string& why) { std::cout << "skipped: " << why << "\n"; }

std::string Trial::text(const std::string& name) const { return test::read_file(folder_ / name); }

void Trial::remove(const std::string& name) const { std::filesystem::remove_all(folder_ / name); }

double Trial::random() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

bool ended_cleanly(const Outcome& outcome) {
    return outcome.code == 0 || ((outcome.code == 1 || outcome.code == 2) && !outcome.err.empty());
}

}  // namespace drape::faults
