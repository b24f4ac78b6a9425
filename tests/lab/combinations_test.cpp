#include <gmock/gmock.h>

#include <set>

#include "lab/combinations/combination.h"
#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::table_of;
using testing::AnyOf;
using testing::HasSubstr;

constexpr double seconds = 1;  // `drape-lab combinations` has two

/// Four of the combinations at a time.
class Combinations : public testing::TestWithParam<std::size_t> {};

const auto name_of_pair = [](const auto& param) {
    const Combination first = all_combinations()[param.param];
    return name_of(first.integrator) + "_" + name_of(first.response);
};
INSTANTIATE_TEST_SUITE_P(Long, Combinations, testing::Values(std::size_t{0}, std::size_t{42}), name_of_pair);
INSTANTIATE_TEST_SUITE_P(Nightly, Combinations, testing::Range<std::size_t>(0, 80, 2), name_of_pair);

TEST_P(Combinations, StayWithinBoundsAndHaveTheBitsOfBruteForce) {
    for (const std::size_t number : {GetParam(), GetParam() + 1}) {
        const Combination combination = all_combinations()[number];
        const SearchTree tree = sampled_tree(number);
        const CombinationRun run = run_combination(combination, tree, seconds);
        // The last of the flaws: the cloth comes to rest later
        EXPECT_THAT(flaw_of(run), AnyOf("none", "speed"))
            << run.penetration << " m, " << run.energy_gain << " m, " << run.speed
            << " m/s, continuous: " << combination.continuous;
        EXPECT_EQ(run.hash, run_combination(combination, {}, seconds).hash)
            << name_of(tree.volume) << ", " << name_of(tree.update);
    }
}

TEST(CombinationSample, HasEveryTwoValuesTogether) {
    std::set<std::vector<int>> pairs;
    std::vector<std::size_t> counts{10, 4, 2, 7, 5};
    const std::vector<Combination> all = all_combinations();
    ASSERT_EQ(all.size(), 80u);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const SearchTree tree = sampled_tree(k);
        const std::vector<int> values{static_cast<int>(all[k].integrator), static_cast<int>(all[k].response),
                                      all[k].continuous ? 1 : 0, static_cast<int>(tree.volume),
                                      static_cast<int>(tree.update)};
        for (int a = 0; a < 5; ++a) {
            for (int b = 0; b < a; ++b)
                pairs.insert({a, b, values[static_cast<std::size_t>(a)], values[static_cast<std::size_t>(b)]});
        }
    }
    std::size_t expected = 0;
    for (std::size_t a = 0; a < 5; ++a) {
        for (std::size_t b = 0; b < a; ++b) expected += counts[a] * counts[b];
    }
    EXPECT_EQ(pairs.size(), expected);
    EXPECT_EQ(all_trees().size(), 35u);
}

// Planted faults

TEST(CombinationRun, HasOtherBitsOrAFlawWhereSomethingIsWrong) {
    const auto run = [](ResponseKind response, const SearchTree& tree, const std::vector<std::string>& changes) {
        return run_combination({IntegratorKind::SymplecticEuler, response, false}, tree, seconds, changes);
    };
    EXPECT_NE(run(ResponseKind::Projection, {VolumeKind::Aabb, UpdateKind::Merge}, {"search_tests=3"}).hash,
              run(ResponseKind::Projection, {}, {}).hash);
    const auto flaw = [&run](ResponseKind response, const std::vector<std::string>& changes) {
        return flaw_of(run(response, {}, changes));
    };
    EXPECT_EQ(flaw(ResponseKind::Projection, {"solver.dt=2e-2"}), "diverged");
    EXPECT_EQ(flaw(ResponseKind::Projection, {"ball.position=5,5,5", "ground.solid=false"}), "no_contact");
    EXPECT_EQ(flaw(ResponseKind::Penalty, {"contact.stiffness=10"}), "penetration");
    EXPECT_EQ(flaw(ResponseKind::Projection, {"cloth.drag=0", "contact.friction=0", "restitution=1", "dt=1e-3"}),
              "speed");
    EXPECT_EQ(flaw_of({.touched = 1, .energy_gain = 0.06}), "energy");
}

TEST(LabCombinations, WritesARowACombination) {
    const LabFolder folder;
    const LabRun run = folder.run({"combinations", "--quick", "--cases", "9-10", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("symplectic_euler: 2 rows, trees 1, step_s 0.0005, "));
    const auto rows = table_of(folder, "out/combinations.csv");
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_THAT(rows[1], HasSubstr("9,symplectic_euler,projection,discrete,1,0.0005,"));
    EXPECT_THAT(rows[2], HasSubstr(",none"));
}

}  // namespace
}  // namespace drape
