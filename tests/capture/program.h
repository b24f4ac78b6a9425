#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace drape::test {

/// What a program did.
struct Outcome {
    int exit_code = -1;  ///< 128 + n if signal n ended it
    std::string out;
    std::string err;
};

/// Runs one of our programs ("drape-capture") to its end.
/// @param environment "NAME=value" words that are added
Outcome run_program(const std::string& name, const std::vector<std::string>& arguments,
                    const std::vector<std::string>& environment = {});

/// Runs one of our programs and sends it a signal as soon as a file is there.
Outcome interrupt_program(const std::string& name, const std::vector<std::string>& arguments,
                          const std::filesystem::path& file, int signal);

/// A folder for one test, gone at its end.
class TestFolder {
public:
    TestFolder();
    ~TestFolder();
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    /// The names of the files in a folder of it, sorted.
    [[nodiscard]] std::vector<std::string> names(const std::string& folder) const;

private:
    std::filesystem::path path_;
};

std::string text_of(const std::filesystem::path& file);

}  // namespace drape::test
