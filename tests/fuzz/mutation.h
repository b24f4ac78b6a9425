#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "support/random_user.h"

namespace drape::fuzz {

/// Makes new inputs of old ones: bytes flipped, put in, taken out and repeated, parts of two inputs joined, words of a
/// dictionary put in, numbers made extreme. The same seed makes the same inputs.
class Mutation : test::Chance {
public:
    /// @param seeds at least one, which may be empty
    /// @param longest of an input that is made [bytes]
    Mutation(std::vector<std::string> seeds, std::vector<std::string> dictionary, unsigned long seed,
             std::size_t longest);

    /// The next input.
    const std::string& next();

private:
    std::size_t position() { return below(input_.size() + 1); }
    const std::string& one_of(const std::vector<std::string>& texts) { return texts[below(texts.size())]; }
    void change_once();
    void splice();
    void replace_number();

    std::vector<std::string> seeds_, dictionary_, numbers_;
    std::size_t longest_;
    std::string input_;
};

/// The words of a dictionary as libFuzzer writes them: a line each in double quotes, with \xNN, \\ and \" in it.
std::vector<std::string> dictionary_words(const std::string& text);

}  // namespace drape::fuzz
