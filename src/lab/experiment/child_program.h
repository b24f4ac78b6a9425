#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace drape {

/// Runs another program to its end. What it prints goes where this program's own does.
/// @param words the program, by its path or as PATH finds it from here, and its arguments
/// @param folder that it runs in, if not in this program's. No program is looked for there
/// @return its exit code, or 128 + the signal that ended it; nothing if there is no such program
/// @throws RunError if it cannot be started for another reason
std::optional<int> run_child(std::vector<std::string> words, const std::filesystem::path& folder = {});

}  // namespace drape
