#pragma once

#include "drape/base/assert.h"
#include "drape/bounds/aabb.h"
#include "drape/bounds/dop_axes.h"

namespace drape {

/// What K / 2 slabs of fixed directions have in common: a box whose corners (K = 14), edges (18) or both (26) are cut
/// off. With K = 6 it is the box, and decides as `Aabb` does.
/// @cite klosowski1998
template <int K>
struct KDop {
    static_assert(K == 6 || K == 14 || K == 18 || K == 26);
    static constexpr std::size_t cuts = K / 2 - 3;  ///< slabs beside the box

    Aabb box;                      ///< the first three slabs
    std::array<Real, cuts> low{};  ///< of the others, in the order of `dop_numbers`, in units of their directions
    std::array<Real, cuts> high{};

    /// The slabs min n_k . x_p <= n_k . x <= max n_k . x_p for the K / 2 directions n_k.
    /// @par Cost O(particles of the patch), one pass
    static KDop fit(const Patch& patch) {
        std::array<Real, K / 2> least, most;
        least.fill(std::numeric_limits<Real>::infinity());
        most.fill(-std::numeric_limits<Real>::infinity());
        for_each_particle(patch, [&](const Vec3& p) {
            for (std::size_t k = 0; k < K / 2; ++k) {
                const Real projection = dop_projection(dop_numbers<K>[k], p);
                least[k] = std::min(least[k], projection);
                most[k] = std::max(most[k], projection);
            }
        });
        return from_extents(least, most);
    }

    /// From the smallest and largest projections of particles on the directions: the box to the bit, and cuts grown by
    /// the rounding of a projection: by some epsilons of the coordinates, which may be large where the patch is small.
    static KDop from_extents(const std::array<Real, K / 2>& least, const std::array<Real, K / 2>& most) {
        KDop dop;
        dop.box = {{least[0], least[1], least[2]}, {most[0], most[1], most[2]}};

        // Two sums, each to half an epsilon, and this one
        const Real largest = dop.box.low.cwiseAbs().cwiseMax(dop.box.high.cwiseAbs()).sum();
        const Real rounding = 2 * std::numeric_limits<Real>::epsilon() * largest;
        for (std::size_t k = 0; k < cuts; ++k) {
            dop.low[k] = least[k + 3] - rounding;
            dop.high[k] = most[k + 3] + rounding;
        }
        return dop;
    }

    /// The first particle.
    static KDop start(const Patch& patch) { return fit({patch.x, patch.y, patch.z, 1, 1, patch.stride}); }

    /// Grows by just as much as a point needs, and the rounding of its projections.
    void include(const Vec3& p) {
        box.include(p);
        const Real rounding = 2 * std::numeric_limits<Real>::epsilon() * p.cwiseAbs().sum();
        for (std::size_t k = 0; k < cuts; ++k) {
            const Real projection = dop_projection(dop_numbers<K>[k + 3], p);
            low[k] = std::min(low[k], projection - rounding);
            high[k] = std::max(high[k], projection + rounding);
        }
    }

    /// The smallest k-DOP about k-DOPs, to the bit. @pre one child or more
    static KDop merge(std::span<const KDop> children) {
        DRAPE_ASSERT(!children.empty());
        KDop all = children[0];
        for (const KDop& child : children.subspan(1)) {
            all.box.include(child.box);
            for (std::size_t k = 0; k < cuts; ++k) {
                all.low[k] = std::min(all.low[k], child.low[k]);
                all.high[k] = std::max(all.high[k], child.high[k]);
            }
        }
        return all;
    }

    /// By the distance of the ball's centre from the box and from each of the other slabs.
    [[nodiscard]] bool overlaps(const Ball& ball) const {
        if (!box.overlaps(ball)) return false;
        const Real rounding = 2 * std::numeric_limits<Real>::epsilon() * ball.centre.cwiseAbs().sum();
        for (std::size_t k = 0; k < cuts; ++k) {
            const int number = dop_numbers<K>[k + 3];
            const Real radius = ball.radius * (dop_length(number) * rounded_up) + rounding;
            const Real centre = dop_projection(number, ball.centre);
            if (low[k] - centre > radius || centre - high[k] > radius) return false;
        }
        return true;
    }

    /// By the gaps along all directions.
    [[nodiscard]] bool comes_within(const KDop& other, Real margin) const {
        if (!box.comes_within(other.box, margin)) return false;
        for (std::size_t k = 0; k < cuts; ++k) {
            const Real bound = margin * dop_length(dop_numbers<K>[k + 3]) * rounded_up;
            if (std::max(low[k] - other.high[k], other.low[k] - high[k]) > bound) return false;
        }
        return true;
    }

    /// The box's.
    [[nodiscard]] BoundingSphere sphere() const { return box.sphere(); }
};

static_assert(BoundingVolume<KDop<6>> && BoundingVolume<KDop<14>> && BoundingVolume<KDop<18>> &&
              BoundingVolume<KDop<26>>);

}  // namespace drape
