#pragma once

#include <new>
#include <string>

#include "drape/base/input_error.h"
#include "drape/scene/settings.h"

namespace drape {

/// About what a simulation takes at most [bytes]; pictures come on top.
struct MemoryNeed {
    double cloths = 0;  ///< states, contacts and hierarchies
    double method = 0;  ///< the integrators'

    [[nodiscard]] double total() const { return cloths + method; }
};

/// @pre the grids have at least 2 x 2 particles
MemoryNeed memory_needed(const Settings& settings);

/// About what a cloth's states and its share of the searches take, kept with `numbers` for each particle [bytes].
double bytes_of_cloth(const ContactSettings& contact, const Grid& grid, double numbers);

/// "22500 particles with projective_dynamics need about 54 MB, 43 MB of it for the method".
std::string memory_text(const Settings& settings);

/// Does something that takes memory.
/// @throws RunError that says what needed how much, where there is too little of it
template <class Work>
void rethrow_bad_alloc(const Settings& settings, Work work) {
    try {
        work();
    } catch (const std::bad_alloc&) {
        throw RunError("out of memory: " + memory_text(settings));
    }
}

}  // namespace drape
