#pragma once

#include <optional>
#include <string>
#include <vector>

namespace drape {

/// Runs another program to its end. What it prints goes where this program's own does.
/// @param words the program, by its path or as PATH finds it, and its arguments
/// @return its exit code, or 128 + the signal that ended it; nothing if there is no such program
/// @throws RunError if it cannot be started for another reason
std::optional<int> run_child(std::vector<std::string> words);

}  // namespace drape
