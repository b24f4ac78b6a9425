#include "fuzz/mutation.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "fuzz/target.h"

namespace drape::fuzz {
namespace {

constexpr std::size_t most_changes = 6;

constexpr const char* extreme_numbers =
    "0 -0 1 -1 2 1e-320 5e-324 1e308 1e309 -1e308 nan inf -inf 0x10 1e-30 1e12 2147483647 2147483648 4294967296 "
    "-2 9223372036854775807 0.1 1e-9 9223372036854775808 18446744073709551616 1_000 1e6 999999 0,5 "
    "1.0000000000000002 4096 4097";

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream words(text);
    return {std::istream_iterator<std::string>(words), {}};
}

bool in_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == 'e' || c == '-' || c == '+'; }

}  // namespace

Mutation::Mutation(std::vector<std::string> seeds, std::vector<std::string> dictionary, unsigned long seed,
                   std::size_t longest)
    : Chance(seed),
      seeds_(std::move(seeds)),
      dictionary_(std::move(dictionary)),
      numbers_(words_of(extreme_numbers)),
      longest_(longest) {
    require(!seeds_.empty(), "there is an input to start from");
    if (dictionary_.empty()) dictionary_ = numbers_;
}

const std::string& Mutation::next() {
    input_ = one_of(seeds_);
    for (std::size_t changes = 1 + below(most_changes); changes > 0; --changes) change_once();
    if (input_.size() > longest_) input_.resize(longest_);
    return input_;
}

void Mutation::change_once() {
    const std::size_t at = position(), size = input_.size();
    const std::size_t length = std::min(below(16) == 0 ? below(size + 1) : below(8), size - at);
    switch (below(10)) {
        case 0:
            if (at < size) input_[at] = static_cast<char>(input_[at] ^ (1 << below(8)));
            break;
        case 1:
            if (at < size) input_[at] = static_cast<char>(below(256));
            break;
        case 2:
            input_.insert(at, 1 + below(4), static_cast<char>(below(256)));
            break;
        case 3:
            input_.erase(at, length);
            break;
        case 4:
            input_.insert(position(), input_.substr(at, length));
            break;
        case 5:
            splice();
            break;
        case 6:
            input_.insert(at, one_of(dictionary_));
            break;
        case 7:
            input_.replace(at, length, one_of(dictionary_));
            break;
        default:
            replace_number();
    }
}

/// The beginning of this input and the end of another, or a piece of the other in the midst.
void Mutation::splice() {
    const std::string& other = one_of(seeds_);
    const std::size_t from = below(other.size() + 1);
    if (below(2) == 0) {
        input_ = input_.substr(0, position()) + other.substr(from);
    } else {
        input_.insert(position(), other, from, below(64));
    }
}

void Mutation::replace_number() {
    std::size_t begin = position();
    const auto first = std::find_if(input_.begin() + static_cast<std::ptrdiff_t>(begin), input_.end(), in_number);
    if (first == input_.end()) return;
    begin = static_cast<std::size_t>(first - input_.begin());
    const auto last = std::find_if_not(first, input_.end(), in_number);
    input_.replace(begin, static_cast<std::size_t>(last - first), one_of(numbers_));
}

std::vector<std::string> dictionary_words(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t open = line.find('"'), close = line.rfind('"');
        if (line.starts_with('#') || open == close) continue;
        std::string word;
        for (std::size_t i = open + 1; i < close; ++i) {
            if (line[i] == '\\' && line[i + 1] == 'x') {
                word += static_cast<char>(std::stoi(line.substr(i + 2, 2), nullptr, 16));
                i += 3;
            } else {
                if (line[i] == '\\') ++i;
                word += line[i];
            }
        }
        words.push_back(word);
    }
    return words;
}

}  // namespace drape::fuzz
