#pragma once

#include <functional>
#include <vector>

#include "drape/base/kernels.h"
#include "drape/base/workers.h"
#include "drape/model/cloth_model.h"

namespace drape {

namespace kernels {
struct ForceScratch;
}  // namespace kernels

/// The forces on a run of neighbours in a row of particles, while they are in the cache.
struct ForceRun {
    Eigen::Index first, count;  ///< the particles
    const Real* force;          ///< their forces [N], by coordinate
    Eigen::Index stride;        ///< from the first force of one coordinate to that of the next
    const ClothModel* model;

    /// The run's rows of an n x 3 array.
    [[nodiscard]] auto of(const Points& points) const { return points.middleRows(first, count).array(); }
    [[nodiscard]] auto of(Points& points) const { return points.middleRows(first, count).array(); }

    [[nodiscard]] auto forces() const {
        using Forces = Eigen::Array<Real, Eigen::Dynamic, 3>;
        return Eigen::Map<const Forces, 0, Eigen::OuterStride<>>(force, count, 3, Eigen::OuterStride<>(stride));
    }

    /// a = f/m, and zero for pinned particles [m/s^2].
    [[nodiscard]] auto accelerations() const { return forces().colwise() * model->inverse_mass.segment(first, count); }
};

/// Evaluates all forces on a cloth, for every method of integration.
///
/// With vector kernels it is one sweep over the cloth, on one or more threads, which hands the forces over run by run,
/// so that what is made of them is made before they leave the cache. Each particle's forces are added up in one order,
/// wherever runs begin and end: the bits do not depend on the number of threads. The plain way is `compute_forces`, and
/// one run of the whole cloth.
class ForceSweep {
public:
    ForceSweep(const Grid& grid, Kernels kernels, int threads = 1);
    ~ForceSweep();

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

    /// All forces at once.
    /// @param f n x 3 [N], overwritten
    void compute(const ClothModel& model, const Points& x, const Points& v, Points& f) {
        (*this)(model, x, v, [&f](const ForceRun& run) { run.of(f) = run.forces(); });
    }

private:
    void sweep(const ClothModel& model, const Points& x, const Points& v,
               const std::function<void(const ForceRun&)>& use);

    Grid grid_;
    Kernels kernels_;
    Points forces_;  ///< the wind's alone with vector kernels, which find the others on the way
    Workers workers_;
    std::vector<kernels::ForceScratch> parts_;  ///< one a thread; none if plain
};

}  // namespace drape
