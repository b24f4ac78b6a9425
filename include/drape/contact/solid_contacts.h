#pragma once

#include <memory>
#include <span>
#include <vector>

#include "drape/contact/contact.h"
#include "drape/contact/solid.h"

namespace drape {

/// Finds where a cloth may touch solids within a substep. A contact is a plane: that of the surface next to a particle,
/// or to the point of a triangle, or of an edge, that is deepest.
class SolidSearch {
public:
    /// The contacts of the candidate cells with one solid, appended: each particle, each edge and each triangle at most
    /// once, triangles ascending.
    /// @param solid at the end of the substep
    /// @param number of the solid
    /// @param reach by how much solid and cloth may have come nearer to each other within the substep; then planes are
    /// those of its start, and move on with the solid, so that nothing passes; 0: those of its end [m]
    /// @param cells ascending
    void find(const Grid& grid, const ClothMotion& cloth, const Solid& solid, int number, Real thickness, Real reach,
              std::span<const CellRun> cells, std::vector<Contact>& contacts);

private:
    /// A distance that was measured, and where, seen from the solid: since then it has changed by no more than the way.
    struct Measured {
        Vec3 at = Vec3::Zero();
        Real distance = -1;  ///< near, before there is one
    };

    /// What is known of the particles beside one solid.
    struct Known {
        std::shared_ptr<const SolidShape> shape;
        std::vector<Measured> particles;
    };

    void look_at_particles(const Grid& grid, const Points& x, const Solid& solid, int number, Real near,
                           std::span<const CellRun> cells);

    std::vector<Known> known_;              ///< of each solid
    std::vector<SurfaceDistance> surface_;  ///< of the particles of the cells; of far ones a bound, and no normal
    std::vector<CellRun> particles_;        ///< of the cells
};

}  // namespace drape
