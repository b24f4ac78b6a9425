// Drape's quadtrees, one a cloth, traversed in pairs down to cells; with the test for folds, or
// without. SelfSearch asks that test about cells that do not touch alone, and has another one for those that do.

#include <optional>

#include "contact/cell_pairs.h"
#include "drape/bounds/fold_test.h"
#include "pair_method.h"

namespace drape::peers {
namespace {

class OurPairs final : public PairMethod {
public:
    OurPairs(std::string name, VolumeKind volume, bool folds)
        : PairMethod(std::move(name), volume == VolumeKind::Aabb && !folds ? Sought::Boxes : Sought::Near),
          parameters_{.volume = volume, .update = UpdateKind::Merge, .leaf_cells = 2},
          with_folds_(folds) {}

    void start(const Sheets& sheets, const SheetFrame& frame) override {
        sheets_ = &sheets;
        const auto particles = static_cast<std::size_t>(frame.x.rows());
        // Boxes in which nothing is lost to rounding
        reaches_.assign(particles, sheets.thickness * Real(0.5000001));
        for (std::size_t c = 0; c < sheets.grids.size(); ++c) {
            trees_.push_back(make_broad_phase(parameters_, sheets.grids[c]));
            folds_.emplace_back(sheets.grids[c], sheets.spacings[c][0], sheets.spacings[c][1], parameters_.leaf_cells);
        }
        cells_.resize(trees_.size());
        update(frame);
    }

    void update(const SheetFrame& frame) override {
        frame_ = &frame;
        for (std::size_t c = 0; c < trees_.size(); ++c) {
            const Points& x = frame.of_cloths[c];
            trees_[c]->build(x);
            if (with_folds_) folds_[c].build(x);
            cells_[c].build(sheets_->grids[c], x, std::span(reaches_).first(static_cast<std::size_t>(x.rows())));
        }
        make_boxes(*sheets_, frame.x, boxes_);
    }

    void query(std::vector<TrianglePair>& found) override {
        for (std::size_t a = 0; a < trees_.size(); ++a) {
            for (std::size_t b = a; b < trees_.size(); ++b) find_between(a, b, found);
        }
    }

private:
    [[nodiscard]] BoxedCloth boxed(std::size_t c) const {
        return {{static_cast<int>(c), sheets_->grids[c], frame_->of_cloths[c]}, cells_[c]};
    }

    void find_between(std::size_t a, std::size_t b, std::vector<TrianglePair>& found) {
        // Boxes that overlap once grown are up to this far from each other, from corner to corner
        const Real margin = sought() == Sought::Boxes ? std::sqrt(Real(3)) * sheets_->thickness : sheets_->thickness;
        trees_[a]->query(*trees_[b], margin, a == b && with_folds_ ? &folds_[a] : nullptr, leaves_);
        for_each_pair_of_cells(boxed(a), boxed(b), leaves_, [&](int one, int two) {
            if (a == b && one == two) return;
            for (int i = 0; i < 2; ++i) {
                for (int k = 0; k < 2; ++k) look_at(triangle(a, one, i), triangle(b, two, k), found);
            }
        });
    }

    [[nodiscard]] int triangle(std::size_t cloth, int cell, int which) const {
        return sheets_->first_triangles[cloth] + 2 * cell + which;
    }

    void look_at(int first, int second, std::vector<TrianglePair>& found) const {
        const Aabb &one = boxes_[static_cast<std::size_t>(first)], &two = boxes_[static_cast<std::size_t>(second)];
        if (!meet(one, two, sheets_->thickness) || sheets_->share_particle(first, second)) return;
        found.push_back(in_order(first, second));
    }

    BroadPhaseParameters parameters_;
    bool with_folds_;
    const Sheets* sheets_ = nullptr;
    const SheetFrame* frame_ = nullptr;
    std::vector<std::unique_ptr<BroadPhase>> trees_;
    std::vector<FoldTest> folds_;
    std::vector<CellBoxes> cells_;
    std::vector<Real> reaches_;
    std::vector<Aabb> boxes_;  ///< of all triangles
    std::vector<LeafPair> leaves_;
};

}  // namespace

void add_our_pairs(PairMethods& methods) {
    methods.push_back(std::make_unique<OurPairs>("Drape aabb", VolumeKind::Aabb, false));
    methods.push_back(std::make_unique<OurPairs>("Drape aabb and folds", VolumeKind::Aabb, true));
    methods.push_back(std::make_unique<OurPairs>("Drape sphere and folds", VolumeKind::Sphere, true));
    methods.push_back(std::make_unique<OurPairs>("Drape kdop18 and folds", VolumeKind::Kdop18, true));
}

}  // namespace drape::peers
