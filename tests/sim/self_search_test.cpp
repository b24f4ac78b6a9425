// The search of cloth against itself finds what its definition says, while a list of pairs serves for many substeps.

#include "drape/sim/self_search.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
/// nearer within it than they reach, less what is to be kept between them.
/// @param kept [m]
std::vector<FeaturePair> all_within_reach(const SelfSearch& search, const Grid& grid, const Points& x,
                                          const Points& now, Real kept) {
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
        EXPECT_GT(then.distance, pair.distance - (reach - kept) - Real(1e-6));
    }
    std::ranges::sort(within);
    return within;
}

/// A sheet that is searched for a while, substep by substep.
class Search {
public:
    explicit Search(unsigned seed)
        : sheet_({21, 19}, seed),
          model_(make_cloth_model(sheet_.parameters())),
          step_(seed % 5 == 0 ? Real(4e-3) : Real(5e-4)),
          before_(sheet_.at(0)) {
        search_.use(
            {.volume = seed % 2 == 0 ? VolumeKind::Sphere : VolumeKind::Aabb, .leaf_cells = seed % 3 == 0 ? 9 : 4},
            cloths());
    }

    /// The next substep. @return whether it made a list
    bool find() {
        if (state_.x.rows() > 0) before_ = state_.x;
        state_ = {sheet_.at(step_ * static_cast<Real>(++steps_)), Points::Zero(before_.rows(), 3)};
        return search_.find(cloths(), kept_apart).traversal.volume_tests > 0;
    }

    /// After a push, as a response gives it. @return whether it made a list
    bool extend_after(int particle, const Vec3& push) {
        state_.x.row(particle) += push.transpose();
        const auto tests = search_.report().traversal.volume_tests;
        const bool has_to = search_.extend(cloths());
        EXPECT_FALSE(search_.extend(cloths())) << "nothing has been pushed since";
        EXPECT_TRUE(has_to || search_.report().traversal.volume_tests == tests);
        return search_.report().traversal.volume_tests > tests;
    }

    void expect_definition(std::int64_t& pairs, Real kept) const {
        EXPECT_FALSE(search_.report().gave_up);
        std::vector<FeaturePair> found;
        for (const NearPair& pair : search_.pairs()) found.push_back(pair.features);
        pairs += static_cast<std::int64_t>(found.size());
        EXPECT_EQ(found, all_within_reach(search_, model_.grid, before_, state_.x, kept)) << "step " << steps_;
    }

private:
    std::array<ClothInContact, 1> cloths() { return {{{model_, before_, state_}}}; }

    RollingSheet sheet_;
    ClothModel model_;
    Real step_;
    Points before_;
    ClothState state_;
    SelfSearch search_;
    int steps_ = 0;
};

TEST(LongSelfSearch, FindsWhatIsWithinReachWhileItsListServes) {
    std::int64_t pairs = 0;
    int lists = 0;
    for (unsigned seed = 0; seed < 8; ++seed) {
        SCOPED_TRACE(seed);
        Search search(seed);
        for (int step = 0; step < 25; ++step) {
            lists += search.find();
            if (step % 8 == 0) search.expect_definition(pairs, kept_apart);
        }
    }
    EXPECT_GT(pairs, 500);
    EXPECT_LT(3 * lists, 8 * 25) << "a list is to serve for more than one substep";
}

TEST(SelfSearch, FindsWhatAPushBringsWithinReach) {
    std::int64_t pairs = 0;
    int lists = 0;
    for (unsigned seed = 0; seed < 4; ++seed) {
        SCOPED_TRACE(seed);
        Search search(seed);
        for (int step = 0; step < 24; ++step) {
            search.find();
            const int particle = static_cast<int>(37 * seed) % 300 + step;
            const bool made = search.extend_after(particle, Vec3(0, step % 2 == 0 ? Real(0.003) : Real(0.03), 0));
            lists += made;
            // A list is made with room for more of the same
            if (made && step % 2 == 1) {
                EXPECT_FALSE(search.extend_after(particle, Vec3(0, Real(0.005), 0))) << "step " << step;
            }
            if (step % 12 < 2) search.expect_definition(pairs, kept_apart / 2);
        }
    }
    EXPECT_GT(pairs, 230);
    EXPECT_GT(lists, 22);
}

}  // namespace
}  // namespace drape
