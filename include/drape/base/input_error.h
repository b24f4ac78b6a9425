#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace drape {

/// Bad input: a file, an option or a command that Drape cannot accept. Only each program's `main` catches it (exit 2).
/// The message is one line that names the file and line (or the option), the value and what is accepted: what it quotes
/// is made harmless by `one_line`. A hint may follow on a second one.
class InputError : public std::runtime_error {
public:
    explicit InputError(const std::string& message, const std::string& hint = {});
};

/// The program could not do what it was asked to (output not writable, no context): exit 1.
class RunError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A text as one line that a terminal shows as it is: control characters are written as in C ("\\n", "\\x1b"). Of a
/// text far longer than a message, the middle is left out.
std::string one_line(std::string_view text);

/// The beginning of a value that a message quotes; one that is longer than a hundred bytes ends in "...".
std::string shortened(std::string_view value);

/// ": did you mean 'x'?" with the entry of `names` that has the smallest edit distance to `name`; `otherwise` where
/// that is more than 3, or a third of the name, rounded up.
/// @par Cost O(|names| * |name|^2)
std::string did_you_mean(std::string_view name, std::span<const std::string> names, std::string_view otherwise = "");

/// "'a', 'b' or 'c'": `names` as a sentence lists them.
std::string listed(std::span<const std::string> names);

}  // namespace drape
