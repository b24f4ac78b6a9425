#pragma once

#include <new>
#include <string>

#include "drape/base/input_error.h"
#include "drape/scene/settings.h"

namespace drape {

/// About what a simulation takes, right within a factor of two or three [bytes]; pictures come on top.
double memory_needed(const Settings& settings);

/// "22500 particles with projective_dynamics need about 117 MB".
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
