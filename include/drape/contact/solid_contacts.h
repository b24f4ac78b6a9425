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

/// The contacts of the free balls with solids, appended: at most one of each ball with each solid, where the ball is
/// deepest in it, or, if it has passed it within the substep or come to another side, where it has met it. That is
/// found by conservative advancement on the ball's way, as the solid sees it. @cite mirtich1996
/// @par Cost O(balls solids) distances
void find_ball_contacts(std::span<const Ball> balls, std::span<const Solid> solids, std::vector<BallContact>& contacts);

/// Stops a ball that nothing pushes at the surfaces of solids that it meets within the substep, and lets it slide along
/// them; back at its start, without velocity, if they leave it no room.
/// @param start of its path; what stops it may have shortened `moved` [m]
/// @param gap to leave [m]
/// @param h the substep [s]
/// @return whether it had to
bool stay_outside(std::span<const Solid> solids, const Vec3& start, Real gap, Real h, Ball& ball);

/// Whether a ball's path through the substep takes it into no solid deeper than it was at the start, or would be if it
/// stayed there, whichever is deeper.
/// @pre it has moved
/// @param gap as above [m]
[[nodiscard]] bool penetrates_no_deeper(std::span<const Solid> solids, Real gap, const Ball& ball);

}  // namespace drape
