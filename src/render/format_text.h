#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace drape {

/// What `std::printf` would print, of at most 199 bytes.
template <class... Values>
std::string format(const char* pattern, Values... values) {
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), pattern, values...);
    return text.data();
}

}  // namespace drape
