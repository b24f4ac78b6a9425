// Prints a hash of many sines: Drape's own, or those of the C library, which differ between processors. So a comparison
// of bits can be seen to catch what it is there to catch.

#include <bit>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <string_view>

#include "drape/base/exact_math.h"
#include "drape/base/numbers.h"

int main(int argc, char** argv) {
    const bool own = argc == 2 && std::string_view(argv[1]) == "own";
    std::uint64_t hash = 0;
    for (int i = 0; i < 200'000; ++i) {
        const double x = 2.1 * 3.125e-4 * i;
        hash = std::rotl(hash, 1) ^ std::bit_cast<std::uint64_t>(own ? drape::sine(x) : std::sin(x));
    }
    std::cout << drape::hash_text(hash) << "\n";
}
