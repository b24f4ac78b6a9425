#include "app/window_fixture.h"

#include <unistd.h>

#include <algorithm>
#include <sstream>

namespace drape::test {

namespace fs = std::filesystem;

namespace {

// Those of values have a slash in their names
std::string test_name(const testing::TestInfo& test) {
    std::string name = test.name();
    std::ranges::replace(name, '/', '-');
    return name;
}

fs::path make_folder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const fs::path folder =
        fs::path(testing::TempDir()) / ("drape-" + test_name(*test) + "-" + std::to_string(getpid()));
    fs::create_directories(folder);
    return folder;
}

}  // namespace

std::string program(const std::string& name) { return std::string(DRAPE_PROGRAMS) + "/" + name; }

WindowTest::WindowTest() : folder_(make_folder()), desktop_(folder_) {}

WindowTest::~WindowTest() {
    drape_.reset();
    if (!HasFailure()) fs::remove_all(folder_);
}

void WindowTest::start(const std::vector<std::string>& arguments) {
    std::vector<std::string> words{program("drape"), "--record", file("session.txt"), "--hash", "--size", "640x480"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    drape_.emplace(words, std::map<std::string, std::string>{{"DISPLAY", desktop_.display()}}, folder_);
    window_ = desktop_.find_window();
    ASSERT_FALSE(window_.empty()) << drape_->standard_error();
}

std::vector<std::pair<long long, std::string>> WindowTest::numbered_lines() const {
    const std::string unfinished = file("session.txt.unfinished");
    std::istringstream recording(read_file(fs::exists(unfinished) ? unfinished : file("session.txt")));
    std::vector<std::pair<long long, std::string>> lines;
    for (std::string line; std::getline(recording, line);) {
        const std::size_t space = line.find(' ');
        if (line.empty() || space == 0 || line.find_first_not_of("0123456789") != space) continue;
        lines.emplace_back(std::stoll(line), space == std::string::npos ? "" : line.substr(space + 1));
    }
    return lines;
}

std::vector<std::string> WindowTest::commands() const {
    std::vector<std::string> commands;
    for (const auto& [step, command] : numbered_lines()) {
        if (!command.empty() && !command.starts_with("hash ") && command != "end") commands.push_back(command);
    }
    return commands;
}

bool WindowTest::recorded_now(const std::string& command, std::size_t after) const {
    const std::vector<std::string> all = commands();
    for (std::size_t c = after; c < all.size(); ++c) {
        if (all[c].starts_with(command)) return true;
    }
    return false;
}

bool WindowTest::recorded(const std::string& command, std::size_t after) const {
    return eventually([&] { return recorded_now(command, after); });
}

long long WindowTest::last_step() const {
    const auto lines = numbered_lines();
    return lines.empty() ? -1 : lines.back().first;
}

std::string WindowTest::quit() {
    desktop_.key("ctrl+q");
    EXPECT_EQ(drape_->wait(60), 0) << drape_->standard_error();
    return drape_->standard_output();
}

}  // namespace drape::test
