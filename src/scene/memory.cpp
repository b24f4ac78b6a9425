#include "drape/scene/memory.h"

#include "drape/base/memory_limit.h"
#include "drape/integrate/integrator.h"

namespace drape {
namespace {

/// A particle with its state, its part of the hierarchy, and the room that lists have for two contacts a triangle.
constexpr double bytes_of_particle = 2700;

/// And with the pairs of features near it where cloth lies on cloth.
constexpr double bytes_in_pairs = 13000;

}  // namespace

double memory_needed(const Settings& settings) {
    double bytes = 0;
    for (const ClothParameters& cloth : settings.cloths) {
        const Grid& grid = cloth.particles;
        bytes += (bytes_of_particle + (settings.contact.self ? bytes_in_pairs : 0)) * grid.particles() +
                 bytes_of_method(settings.solver, grid);
    }
    return bytes;
}

std::string memory_text(const Settings& settings) {
    long long particles = 0;
    for (const ClothParameters& cloth : settings.cloths) particles += cloth.particles.particles();
    return std::to_string(particles) + " particles with " + std::string(name_of(settings.solver.integrator)) +
           " need about " + bytes_text(memory_needed(settings));
}

}  // namespace drape
