#include "drape/sim/self_search.h"

#include <algorithm>

namespace drape {
namespace {

/// How much farther than the integrator has moved it a response may move a particle: what it moves farther is held
/// back.
constexpr Real response_allowance = Real(1.5);

/// For how many substeps like this one a list is to last, and how much of the thickness at rest.
constexpr Real substeps_ahead = 8, thickness_ahead = Real(0.5);

/// A cloth at the start of the substep.
ClothAt at(std::span<const ClothInContact> cloths, int number) {
    const ClothInContact& cloth = cloths[static_cast<std::size_t>(number)];
    return {number, cloth.model.grid, cloth.before};
}

}  // namespace

void SelfSearch::use(const BroadPhaseParameters& parameters, std::span<const ClothModel* const> models) {
    surfaces_.clear();
    for (const ClothModel* model : models) {
        surfaces_.push_back({make_broad_phase(parameters, model->grid),
                             FoldTest(model->grid, model->hx, model->hy, parameters.leaf_cells),
                             {},
                             false,
                             {}});
    }
    forget();
}

/// @return the longest way of a particle in the substep [m]
Real SelfSearch::find_reaches(std::span<const ClothInContact> cloths, Real thickness) {
    Real longest = 0;
    reaches_.clear();
    strayed_.clear();
    first_particle_.clear();
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        const Points &x = cloths[c].state.x, &before = cloths[c].before, &kept = surfaces_[c].kept;
        first_particle_.push_back(reaches_.size());
        for (Eigen::Index p = 0; p < x.rows(); ++p) {
            const Real way = (x.row(p) - before.row(p)).norm(), reach = thickness / 2 + response_allowance * way;
            longest = std::max(longest, way);
            reaches_.push_back(reach);
            strayed_.push_back(margin_ > 0 ? reach + (before.row(p) - kept.row(p)).norm() : reach);
        }
    }
    return longest;
}

/// Of the particles of both features, the largest numbers together.
Real SelfSearch::sum_of_largest(const FeaturePair& pair, std::span<const Real> of_particles) const {
    std::array<Real, 2> largest{};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto cloth = static_cast<std::size_t>(pair.cloth_of(k));
        const Real number = of_particles[first_particle_[cloth] + static_cast<std::size_t>(pair.particles[k])];
        largest[pair.feature_of(k)] = std::max(largest[pair.feature_of(k)], number);
    }
    return largest[0] + largest[1];
}

/// A pair that was farther apart than both features have strayed, and may yet reach, is not near.
SelfSearchReport SelfSearch::find(std::span<const ClothInContact> cloths, Real thickness) {
    SelfSearchReport report;
    const Real longest = find_reaches(cloths, thickness);
    report.kept_list = margin_ >= 2 * std::ranges::max(strayed_);
    if (!report.kept_list) {
        margin_ = 2 * std::ranges::max(reaches_) + 2 * substeps_ahead * longest + thickness_ahead * thickness;
        make_list(cloths, report);
        strayed_ = reaches_;
    }
    near_.clear();
    for (const auto& [features, triangle, distance] : list_) {
        if (distance >= sum_of_largest(features, strayed_)) continue;
        NearPair pair{features, triangle};
        locate(at(cloths, features.cloths[0]), at(cloths, features.cloths[1]), pair);
        if (pair.distance < reach_of(features)) near_.push_back(pair);
    }
    report.listed = static_cast<std::int64_t>(list_.size());
    return report;
}

void SelfSearch::make_list(std::span<const ClothInContact> cloths, SelfSearchReport& report) {
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        Surface& surface = surfaces_[c];
        surface.kept = cloths[c].before;
        surface.tree->build(surface.kept);
        surface.folds.build(surface.kept);
        surface.boxed = false;
    }
    near_.clear();
    const int count = static_cast<int>(cloths.size());
    for (int first = 0; first < count; ++first) {
        for (int second = first; second < count; ++second) search(cloths, first, second, report);
    }
    list_.clear();
    for (const NearPair& pair : near_) list_.push_back({pair.features, pair.triangle, pair.distance});
    std::ranges::sort(list_, {}, &Listed::features);
}

/// Boxes are built where anything comes near at all.
void SelfSearch::search(std::span<const ClothInContact> cloths, int first, int second, SelfSearchReport& report) {
    Surface &one = surfaces_[static_cast<std::size_t>(first)], &two = surfaces_[static_cast<std::size_t>(second)];
    report.traversal += one.tree->query(*two.tree, margin_, first == second ? &one.folds : nullptr, leaves_);
    if (leaves_.empty()) return;
    const ClothAt at_one = at(cloths, first), at_two = at(cloths, second);
    if (!one.boxed) one.boxes.build(at_one.grid, at_one.x);
    if (!two.boxed) two.boxes.build(at_two.grid, at_two.x);
    one.boxed = two.boxed = true;
    report.cells += find_near_pairs({at_one, one.boxes}, {at_two, two.boxes}, margin_, leaves_, near_);
}

}  // namespace drape
