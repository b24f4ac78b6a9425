#include "drape/scene/memory.h"

#include <algorithm>

#include "drape/base/memory_limit.h"
#include "drape/bounds/node_view.h"
#include "drape/contact/near_pairs.h"
#include "drape/contact/response.h"
#include "drape/integrate/integrator.h"

namespace drape {
namespace {

/// Numbers a particle: its mass, the state and the one before; those of a ledger.
constexpr double particle_numbers = 1 + 12, ledger_numbers = 3;

/// Lists with room for two contacts a triangle, as the solver has: those of now, of before, and of these what has
/// parted.
constexpr double contact_lists = 3 * 2;

/// The search for the longest step: its vectors and Jacobian, on a piece of at most about so many particles.
constexpr double search_numbers = 42, searched_particles = 3000;

std::size_t bytes_of_volume(VolumeKind kind) {
    if (kind == VolumeKind::Brute) return 0;
    return with_volume(kind, []<class Volume>(std::type_identity<Volume>) { return sizeof(Volume); });
}

double hierarchy_bytes(const ContactSettings& contact, const Grid& grid) {
    const int side = contact.leaf_cells > 0 ? contact.leaf_cells : measured_leaf_cells(grid);
    const double nodes = 4.0 / 3 * grid.particles() / (static_cast<double>(side) * side);
    return nodes * static_cast<double>(sizeof(QuadtreeNode) + 2 * sizeof(int) + bytes_of_volume(contact.volume));
}

/// Of a pair of features: as it was found, as it is now, and what the list has of it. Of the room that lists double,
/// they use two thirds in the mean.
constexpr double bytes_of_pair = 1.5 * (2 * sizeof(NearPair) + sizeof(FeaturePair) + sizeof(int) + sizeof(Real));

/// Where cloths meet themselves and each other: a second hierarchy and the boxes of its cells, numbers of a particle,
/// and pairs of features, as many as where much of a cloth lies on cloth. Threads share their lists.
double self_contact_bytes(const ContactSettings& contact, const Grid& grid) {
    // Positions, reaches, and what the fail-safe has
    constexpr double pairs = 30, numbers_of_search = 3 + 5 + 6;
    if (!contact.self) return 0;
    const double of_particle = sizeof(Real) * numbers_of_search + sizeof(Aabb) + pairs * bytes_of_pair;
    return hierarchy_bytes(contact, grid) + grid.particles() * of_particle;
}

}  // namespace

double bytes_of_cloth(const ContactSettings& contact, const Grid& grid, double numbers) {
    return grid.particles() * static_cast<double>(sizeof(Real)) * numbers + hierarchy_bytes(contact, grid) +
           self_contact_bytes(contact, grid);
}

MemoryNeed memory_needed(const Settings& settings) {
    MemoryNeed need;
    for (const ClothParameters& cloth : settings.cloths) {
        const Grid& grid = cloth.particles;
        const double particles = grid.particles();
        const double numbers = particle_numbers + (settings.solver.ledger ? ledger_numbers : 0);
        need.cloths += bytes_of_cloth(settings.contact, grid, numbers) +
                       contact_lists * grid.triangles() * static_cast<double>(sizeof(ContactRow)) +
                       static_cast<double>(ContactSolver::bytes_for(2 * static_cast<std::size_t>(grid.triangles()))) +
                       std::min(particles, searched_particles) * sizeof(Real) * search_numbers;
        need.method += bytes_of_method(integrator_of(settings.solver), grid);
    }
    return need;
}

std::string memory_text(const Settings& settings) {
    long long particles = 0;
    for (const ClothParameters& cloth : settings.cloths) particles += cloth.particles.particles();
    const MemoryNeed need = memory_needed(settings);
    return std::to_string(particles) + " particles with " + std::string(name_of(settings.solver.integrator)) +
           " need about " + bytes_text(need.total()) + ", " + bytes_text(need.method) + " of it for the method";
}

}  // namespace drape
