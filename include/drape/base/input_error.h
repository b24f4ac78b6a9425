#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace drape {

/// Bad input: a file, an option or a command that Drape cannot accept. Only each program's `main` catches it (exit 2).
/// The message is one or two lines that name the place, the value and what is accepted.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The program could not do what it was asked to (output not writable, no context): exit 1.
class RunError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The entry of `names` with the smallest edit distance to `name`; empty if `names` is empty.
/// @par Cost O(|names| * |name|^2)
std::string nearest_name(std::string_view name, std::span<const std::string> names);

/// "'a', 'b' or 'c'": `names` as a sentence lists them.
std::string listed(std::span<const std::string> names);

}  // namespace drape
