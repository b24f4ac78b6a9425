#include "drape/sim/self_search.h"

#include <algorithm>

#include "drape/bounds/leaf_copies.h"

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
    kernels_ = parameters.kernels;
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

SelfSearchReport SelfSearch::find(std::span<const ClothInContact> cloths, Real thickness) {
    SelfSearchReport report;
    Real moves = 0, since_list = 0;
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        moves = std::max(moves, largest_displacement(cloths[c].state.x, cloths[c].before, kernels_));
        if (margin_ == 0) continue;
        since_list = std::max(since_list, largest_displacement(cloths[c].before, surfaces_[c].kept, kernels_));
    }
    // Two particles may come towards each other
    near_margin_ = thickness + 2 * response_allowance * moves;
    report.kept_list = margin_ - 2 * since_list >= near_margin_;
    if (!report.kept_list) {
        margin_ = near_margin_ + 2 * substeps_ahead * moves + thickness_ahead * thickness;
        make_list(cloths, report);
        since_list = 0;
    }
    near_.clear();
    for (const NearPair& listed : list_) {
        if (listed.distance - 2 * since_list >= near_margin_) continue;
        NearPair pair = listed;
        if (report.kept_list) locate(at(cloths, pair.features.cloths[0]), at(cloths, pair.features.cloths[1]), pair);
        if (pair.distance < near_margin_) near_.push_back(pair);
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
    list_.clear();
    const int count = static_cast<int>(cloths.size());
    for (int first = 0; first < count; ++first) {
        for (int second = first; second < count; ++second) search(cloths, first, second, report);
    }
    std::ranges::sort(list_, {}, &NearPair::features);
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
    report.cells += find_near_pairs({at_one, one.boxes}, {at_two, two.boxes}, margin_, leaves_, list_);
}

}  // namespace drape
