#pragma once

#include <memory>
#include <span>
#include <vector>

#include "drape/contact/contact.h"
#include "drape/contact/solid.h"

namespace drape {

/// Finds where a cloth touches solids. A contact is a plane: that of the surface next to a particle, or to the point of
/// a triangle, or of an edge, that is deepest.
class SolidSearch {
public:
    /// The contacts of the candidate cells with one solid, appended: each particle, each edge and each triangle at most
    /// once, triangles ascending.
    /// @param x n x 3 [m]
    /// @param number of the solid
    /// @param cells ascending
    void find(const Grid& grid, const Points& x, const Solid& solid, int number, Real thickness,
              std::span<const CellRun> cells, std::vector<Contact>& contacts);

    /// The same for the whole substep: what has passed the solid within it, and what is nearer to another of its sides
    /// than to the one at which they met, has the plane at which they met. That is found by conservative advancement:
    /// the way to be gone is at least the distance. Of one triangle, such contacts come last. @cite mirtich1996
    /// @param before at the start of the substep, n x 3 [m]
    void find_swept(const Grid& grid, const Points& before, const Points& x, const Solid& solid, int number,
                    Real thickness, std::span<const CellRun> cells, std::vector<Contact>& contacts);

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

    void look_at_particles(const Grid& grid, const Points& x, const Solid& solid, int number, Real thickness,
                           std::span<const CellRun> cells);

    std::vector<Known> known_;              ///< of each solid
    std::vector<SurfaceDistance> surface_;  ///< of the particles of the cells; of far ones a bound, and no normal
    std::vector<CellRun> particles_;        ///< of the cells
};

}  // namespace drape
