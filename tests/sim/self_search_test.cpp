// The search of cloth against itself finds what its definition says, while a list of pairs serves for many substeps.

#include "drape/sim/self_search.h"

#include <gtest/gtest.h>

#include <random>

#include "drape/contact/near_pairs.h"
#include "drape/model/cloth_model.h"

namespace drape {
namespace {

constexpr Real kept_apart = Real(0.008);

/// A sheet in the middle of being folded over: a roll passes through it, while it falls, turns and shakes; every other
/// one is so narrow that each particle is near some of its neighbours.
class RollingSheet {
public:
    RollingSheet(const Grid& grid, unsigned seed) : random_(seed) {
        std::uniform_real_distribution<Real> unit(-1, 1);
        parameters_.particles = grid;
        fall_ = {unit(random_), unit(random_) - 2, unit(random_)};
        along_ = Real(0.5) + Real(0.3) * unit(random_);
        speed_ = unit(random_), spin_ = 2 * unit(random_);
        shake_ = Real(2e-4) * std::abs(unit(random_));
        narrow_ = seed % 2 == 0 ? 1 : Real(0.35);
    }

    [[nodiscard]] const ClothParameters& parameters() const { return parameters_; }

    /// @param t s
    Points at(Real t) {
        std::uniform_real_distribution<Real> unit(-1, 1);
        const Real fold = along_ + speed_ * t, radius = Real(0.03), half_turn = 3 * radius;
        Points x = make_rest_state(parameters_).x;
        x.col(2) *= narrow_;
        const Eigen::AngleAxis<Real> turn(spin_ * t, Vec3(Real(0.6), 0, Real(0.8)));
        for (Eigen::Index p = 0; p < x.rows(); ++p) {
            const Real beyond = x(p, 0) - fold;
            const Real angle = std::clamp(beyond / radius, Real(0), Real(3));
            if (beyond > 0) {
                x(p, 0) = fold + radius * std::sin(angle) - std::max(beyond - half_turn, Real(0)) * Real(0.99);
                x(p, 1) += radius * (1 - std::cos(angle)) - std::max(beyond - half_turn, Real(0)) * Real(0.14);
            }
            const Vec3 noise(unit(random_), unit(random_), unit(random_));
            x.row(p) = (turn * Vec3(x.row(p)) + fall_ * t + shake_ * noise).transpose();
        }
        return x;
    }

private:
    std::mt19937 random_;
    ClothParameters parameters_;
    Vec3 fall_;
    Real along_, speed_, spin_, shake_, narrow_;
};

/// All pairs of features that are as near as both reach at the start of a substep, from all pairs of cells; none comes
/// nearer within it than they reach.
std::vector<FeaturePair> all_within_reach(const SelfSearch& search, const Grid& grid, const Points& x,
                                          const Points& now) {
    const std::vector<Real> far(static_cast<std::size_t>(grid.particles()), Real(0.05));
    CellBoxes boxes;
    boxes.build(grid, x, far);
    const BoxedCloth cloth{{0, grid, x}, boxes, far};
    const LeafPair all{all_cells(grid), all_cells(grid)};
    std::vector<NearPair> near;
    find_near_pairs(cloth, cloth, {&all, 1}, near);
    std::vector<FeaturePair> within;
    for (const NearPair& pair : near) {
        const Real reach = search.reach_of(pair);
        EXPECT_LT(reach, Real(0.1));
        if (pair.distance < reach) within.push_back(pair.features);
        NearPair then = pair;
        locate({0, grid, now}, {0, grid, now}, then);
        EXPECT_GT(then.distance, pair.distance - (reach - kept_apart) - Real(1e-6));
    }
    std::ranges::sort(within);
    return within;
}

TEST(SelfSearch, FindsWhatIsWithinReachWhileItsListServes) {
    std::int64_t local = 0, not_local = 0, lists = 0, substeps = 0;
    for (unsigned seed = 0; seed < 16; ++seed) {
        RollingSheet sheet({21, 19}, seed);
        const ClothModel model = make_cloth_model(sheet.parameters());
        const ClothModel* const models[] = {&model};
        SelfSearch search;
        search.use({.volume = seed % 2 == 0 ? VolumeKind::Sphere : VolumeKind::Aabb,
                    .leaf_cells = seed % 3 == 0 ? 9 : 4,
                    .kernels = seed % 4 == 0 ? Kernels::Plain : Kernels::Vector},
                   models);
        const Real h = seed % 5 == 0 ? Real(4e-3) : Real(5e-4);
        Points before = sheet.at(0);
        for (int step = 1; step <= 25; ++step) {
            ClothState state{sheet.at(h * static_cast<Real>(step)), Points::Zero(before.rows(), 3)};
            std::vector<Contact> none;
            const ClothInContact cloths[] = {{model, before, state, none}};
            const SelfSearchReport report = search.find(cloths, kept_apart);
            ASSERT_FALSE(report.gave_up);
            std::vector<FeaturePair> found;
            for (const NearPair& pair : search.pairs()) {
                found.push_back(pair.features);
                ++(pair.local ? local : not_local);
            }
            if (step % 4 == 1) {
                ASSERT_EQ(found, all_within_reach(search, model.grid, before, state.x))
                    << "sheet " << seed << ", step " << step;
            }
            lists += report.traversal.volume_tests > 0;
            ++substeps;
            before = state.x;
        }
    }
    EXPECT_GT(local, 1000);
    EXPECT_GT(not_local, 1000);
    EXPECT_LT(3 * lists, substeps) << "a list is to serve for more than one substep";
}

}  // namespace
}  // namespace drape
