// Drape's own hierarchies.

#include "ball_race.h"
#include "contact/pairs/cell_pairs.h"
#include "drape/bounds/broad_phase.h"
#include "drape/bounds/fold_test.h"
#include "drape/contact/detection.h"
#include "pair_race.h"

namespace drape::peers {
namespace {

class OurTree final : public BallMethod {
public:
    OurTree(std::string name, const Motion& motion, const BroadPhaseParameters& parameters)
        : BallMethod(std::move(name), motion), tree_(make_broad_phase(parameters, motion.grid)) {
        tree_->build(x_);
    }

    void update() override { tree_->build(x_); }

    void query() override {
        tree_->query(ball_, found_);
        find_touched_triangles(motion_.grid, x_, ball_, 0, found_.cells, touched_, Kernels::Vector);
    }

private:
    std::unique_ptr<BroadPhase> tree_;
    Candidates found_;
};

/// Quadtrees, one a cloth, traversed in pairs down to cells; with the test for folds, or without.
class OurPairs final : public PairMethod {
public:
    OurPairs(std::string name, const Sheets& sheets, VolumeKind volume, bool folds)
        : PairMethod(std::move(name), sheets, volume == VolumeKind::Aabb && !folds ? Sought::Boxes : Sought::Near),
          parameters_{.volume = volume, .update = UpdateKind::Merge, .leaf_cells = 2},
          with_folds_(folds),
          // Boxes in which nothing is lost to rounding
          reaches_(static_cast<std::size_t>(x_.rows()), sheets.thickness * Real(0.5000001)) {
        for (std::size_t c = 0; c < sheets.grids.size(); ++c) {
            trees_.push_back(make_broad_phase(parameters_, sheets.grids[c]));
            folds_.emplace_back(sheets.grids[c], sheets.spacings[c][0], sheets.spacings[c][1], parameters_.leaf_cells);
        }
        cells_.resize(trees_.size());
        update();
    }

    void update() override {
        for (std::size_t c = 0; c < trees_.size(); ++c) {
            const Points& x = of_cloths_[c];
            trees_[c]->build(x);
            if (with_folds_) folds_[c].build(x);
            cells_[c].build(sheets_.grids[c], x, std::span(reaches_).first(static_cast<std::size_t>(x.rows())));
        }
        make_boxes(sheets_, x_, boxes_);
    }

    void query() override {
        for (std::size_t a = 0; a < trees_.size(); ++a) {
            for (std::size_t b = a; b < trees_.size(); ++b) find_between(a, b);
        }
    }

private:
    [[nodiscard]] BoxedCloth boxed(std::size_t c) const {
        return {{static_cast<int>(c), sheets_.grids[c], of_cloths_[c]}, cells_[c]};
    }

    void find_between(std::size_t a, std::size_t b) {
        // Boxes that overlap once grown are up to this far from each other, from corner to corner
        const Real margin = sought_ == Sought::Boxes ? std::sqrt(Real(3)) * sheets_.thickness : sheets_.thickness;
        trees_[a]->query(*trees_[b], margin, a == b && with_folds_ ? &folds_[a] : nullptr, leaves_);
        for_each_pair_of_cells(boxed(a), boxed(b), leaves_, [&](int one, int two) {
            if (a == b && one == two) return;
            for (int i = 0; i < 2; ++i) {
                for (int k = 0; k < 2; ++k) look_at(triangle(a, one, i), triangle(b, two, k));
            }
        });
    }

    [[nodiscard]] int triangle(std::size_t cloth, int cell, int which) const {
        return sheets_.first_triangles[cloth] + 2 * cell + which;
    }

    void look_at(int first, int second) {
        const Aabb &one = boxes_[static_cast<std::size_t>(first)], &two = boxes_[static_cast<std::size_t>(second)];
        if (meet(one, two, sheets_.thickness)) keep(first, second);
    }

    BroadPhaseParameters parameters_;
    bool with_folds_;
    std::vector<Real> reaches_;
    std::vector<std::unique_ptr<BroadPhase>> trees_;
    std::vector<FoldTest> folds_;
    std::vector<CellBoxes> cells_;
    std::vector<Aabb> boxes_;  ///< of all triangles
    std::vector<LeafPair> leaves_;
};

}  // namespace

void add_ours(Runners& runners, const Motion& motion) {
    const auto add = [&](const std::string& how, VolumeKind volume, UpdateKind update) {
        const std::string name = "Drape " + names_of<VolumeKind>()[static_cast<std::size_t>(volume)] + how;
        runners.push_back(
            std::make_unique<OurTree>(name, motion, BroadPhaseParameters{.volume = volume, .update = update}));
    };
    add("", VolumeKind::Brute, UpdateKind::Rebuild);
    for (const UpdateKind update : {UpdateKind::Merge, UpdateKind::Rebuild}) {
        for (const VolumeKind volume : {VolumeKind::Sphere, VolumeKind::Aabb, VolumeKind::Kdop18, VolumeKind::Obb}) {
            add(" " + names_of<UpdateKind>()[static_cast<std::size_t>(update)], volume, update);
        }
    }
}

void add_ours(Runners& runners, const Sheets& sheets) {
    const auto add = [&](const std::string& name, VolumeKind volume, bool folds) {
        runners.push_back(std::make_unique<OurPairs>("Drape " + name, sheets, volume, folds));
    };
    add("aabb", VolumeKind::Aabb, false);
    add("aabb and folds", VolumeKind::Aabb, true);
    add("sphere and folds", VolumeKind::Sphere, true);
    add("kdop18 and folds", VolumeKind::Kdop18, true);
}

}  // namespace drape::peers
