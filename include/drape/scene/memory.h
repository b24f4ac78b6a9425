#pragma once

#include <new>
#include <string>

#include "drape/base/input_error.h"
#include "drape/sim/settings.h"

namespace drape {

class Simulation;

/// About what a simulation takes at most [bytes]; pictures come on top.
struct MemoryNeed {
    double cloths = 0;  ///< states, contacts and hierarchies
    double method = 0;  ///< the integrators'

    [[nodiscard]] double total() const { return cloths + method; }
};

/// @pre the grids have at least 2 x 2 particles
MemoryNeed memory_needed(const Settings& settings);

/// About what a copy of a simulation takes, its integrators not counted [bytes].
double moment_bytes(const Simulation& simulation);

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
