#pragma once

#include <map>
#include <string>
#include <vector>

#include "support/process.h"
#include "support/scratch_folder.h"

namespace drape::test {

using Words = std::vector<std::string>;

/// What a program did.
struct Outcome {
    int exit_code = -1;  ///< 256 + n if signal n ended it
    std::string out, err;
};

/// A folder for one test, gone at its end.
class TestFolder : public ScratchFolder {
public:
    [[nodiscard]] std::string operator/(const std::string& name) const { return (path() / name).string(); }
    /// The names of the files in a folder of it, sorted.
    [[nodiscard]] Words names(const std::string& folder) const { return names_in(path() / folder); }
};

Words joined(Words words, const Words& more);

/// drape-capture, beside the test, in its folder; it finds programs there first.
class Running : public Process {
public:
    Running(const TestFolder& folder, const Words& words);
};

/// PATH of a program that finds others in this folder first.
std::map<std::string, std::string> path_from(const TestFolder& folder);

/// Gives the folder an `ffmpeg` that is this script.
void put_ffmpeg(const TestFolder& folder, const std::string& script);

/// Runs one of our programs ("drape-capture") to its end.
/// @param environment changes to the test's own
Outcome run_program(const std::string& name, const Words& arguments,
                    const std::map<std::string, std::string>& environment = {});

}  // namespace drape::test
