#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/desktop.h"
#include "support/process.h"

namespace drape::test {

/// `drape` in a window on a desktop of its own. What it was told is read from its recording.
class WindowTest : public testing::Test {
protected:
    WindowTest();
    ~WindowTest() override;

    /// Starts `drape` with a recording, a hash at the end and a small window, and waits until it draws.
    void start(const std::vector<std::string>& arguments);

    /// The commands of the recording so far, without their steps.
    [[nodiscard]] std::vector<std::string> commands() const;

    /// Waits until the recording has a command that starts with this.
    [[nodiscard]] bool recorded(const std::string& command, std::size_t after = 0) const;

    /// Whether it has one by now.
    [[nodiscard]] bool recorded_now(const std::string& command, std::size_t after = 0) const;

    /// The number of the recording's last step.
    [[nodiscard]] long long last_step() const;

    /// Quits by key. @return the hash that `drape` printed
    std::string quit();

    /// A file in the test's folder.
    [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }

    /// The numbered lines of the recording so far: step and command.
    [[nodiscard]] std::vector<std::pair<long long, std::string>> numbered_lines() const;

    std::filesystem::path folder_;
    Desktop desktop_;
    std::optional<Process> drape_;
    std::string window_;
};

/// The path of one of the programs.
std::string program(const std::string& name);

}  // namespace drape::test
