#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "drape/base/input_error.h"

/// What a fuzz target is: given any bytes it returns 0, and nothing but `InputError` may come out of what it calls.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace drape::fuzz {

/// The bytes of an input as text.
inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Ends the process as a crash does, so that the fuzzer keeps the input; unlike an assertion it is in every build.
inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "fuzz: not so: %s\n", what);
    std::abort();
}

/// Whether `read` accepts its input; what it refuses, it must refuse by an `InputError` of one or two lines.
template <class Read>
bool accepts(Read read) {
    try {
        read();
        return true;
    } catch (const InputError& error) {
        const std::string_view message = error.what();
        require(!message.empty(), "a refusal says why");
        require(std::ranges::count(message, '\n') <= 1, "a refusal has one line or two");
        return false;
    }
}

}  // namespace drape::fuzz
