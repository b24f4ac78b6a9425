#pragma once

#include <functional>
#include <vector>

#include "drape/base/workers.h"
#include "drape/model/cloth_model.h"

namespace drape {

namespace kernels {
struct Part;
class Scratch;
}  // namespace kernels

/// The forces on some neighbours in a row of particles, while they are in the cache.
struct ForceRun {
    Eigen::Index first, count;  ///< the particles
    const Real* force[3];       ///< count values each [N]
    const ClothModel* model;

    /// The run's part of an n x 3 array, of one axis.
    [[nodiscard]] auto of(const Points& points, int axis) const {
        return points.col(axis).segment(first, count).array();
    }
    [[nodiscard]] auto of(Points& points, int axis) const { return points.col(axis).segment(first, count).array(); }

    [[nodiscard]] auto forces(int axis) const {
        return Eigen::Map<const Eigen::Array<Real, Eigen::Dynamic, 1>>(force[axis], count);
    }

    /// a = f/m, and zero for pinned particles [m/s^2].
    [[nodiscard]] auto accelerations(int axis) const {
        return forces(axis) * model->inverse_mass.segment(first, count);
    }
};

/// Some numbers that lie in one line of the cache: what vectors are best loaded from.
struct alignas(64) CacheLine {
    static constexpr int numbers = 64 / sizeof(Real);
    Real values[numbers];
};

/// Evaluates all forces on a cloth in one sweep over it, on one or more threads, and hands them over run by run, so
/// that what is made of them is made before they leave the cache. Each particle's forces are added up in one order,
/// wherever runs begin and end: the bits do not depend on the number of threads.
class ForceSweep {
public:
    ForceSweep(const Grid& grid, int threads);

    /// Calls use(run) for runs that hold each particle once.
    /// @param x n x 3 [m]
    /// @param v n x 3 [m/s]
    /// @param use a function of `const ForceRun&`; called by several threads at a time, it may write what belongs to
    /// its run, of x and v too
    /// @par Cost O(n), no allocation
    template <class Use>
    void operator()(const ClothModel& model, const Points& x, const Points& v, Use use) {
        sweep(model, x, v, std::ref(use));
    }

private:
    void sweep(const ClothModel& model, const Points& x, const Points& v,
               const std::function<void(const ForceRun&)>& use);

    [[nodiscard]] kernels::Part part(int number) const;
    [[nodiscard]] kernels::Scratch scratch(int number);

    Grid grid_;
    Points wind_;
    std::vector<std::vector<CacheLine>> scratch_;  // one a part
    Workers workers_;
};

}  // namespace drape
