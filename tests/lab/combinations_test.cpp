#include <gmock/gmock.h>

#include <set>

#include "drape/scene/setting_table.h"
#include "lab/combinations/combination.h"

namespace drape {
namespace {

constexpr double seconds = 1;  // `drape-lab combinations` has two
constexpr std::size_t responses = enum_count<ResponseKind>, combinations = 2 * responses * enum_count<IntegratorKind>;

Settings combination(std::size_t number) {
    return combination_of(static_cast<IntegratorKind>(number / 2 / responses),
                          static_cast<ResponseKind>(number / 2 % responses), number % 2 == 1);
}

/// Four of the combinations at a time.
class Combinations : public testing::TestWithParam<std::size_t> {};

const auto name_of_pair = [](const auto& param) {
    const Settings first = combination(param.param);
    return name_of(first.solver.integrator) + "_" + name_of(first.contact.response);
};
INSTANTIATE_TEST_SUITE_P(Long, Combinations, testing::Values(std::size_t{0}, std::size_t{42}), name_of_pair);
INSTANTIATE_TEST_SUITE_P(Nightly, Combinations, testing::Range<std::size_t>(0, combinations, 2), name_of_pair);

TEST_P(Combinations, StayWithinBoundsAndHaveTheBitsOfBruteForce) {
    for (const std::size_t number : {GetParam(), GetParam() + 1}) {
        const Settings by_tree = with_sampled_tree(combination(number));
        const CombinationRun run = run_combination(combination(number), seconds);
        // The last of the flaws: the cloth comes to rest later
        EXPECT_THAT(run.row.word("flaw"), testing::AnyOf("none", "speed")) << number;
        EXPECT_EQ(run.hash, run_combination(by_tree, seconds).hash)
            << name_of(by_tree.contact.volume) << ", " << name_of(by_tree.contact.update);
    }
}

TEST(CombinationSample, HasEveryTwoValuesTogether) {
    std::set<std::vector<int>> pairs;
    std::vector<std::size_t> counts{10, 4, 2, 7, 5};
    for (std::size_t k = 0; k < combinations; ++k) {
        const Settings tree = with_sampled_tree(combination(k));
        const std::vector<int> values{static_cast<int>(tree.solver.integrator), static_cast<int>(tree.contact.response),
                                      static_cast<int>(tree.contact.continuous), static_cast<int>(tree.contact.volume),
                                      static_cast<int>(tree.contact.update)};
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
}

// Planted faults

TEST(CombinationRun, HasOtherBitsOrAFlawWhereSomethingIsWrong) {
    const Settings projection = combination(8), penalty = combination(10);  // by symplectic Euler
    const auto run = [](Settings settings, const std::vector<std::string>& changes) {
        assign_all(settings, changes);
        return run_combination(settings, seconds);
    };
    EXPECT_NE(run(projection, {"contact.volume=aabb", "contact.update=merge", "search_tests=3"}).hash,
              run(projection, {}).hash);
    const auto flaw = [&run](const Settings& settings, const std::vector<std::string>& changes) {
        return run(settings, changes).row.word("flaw");
    };
    EXPECT_EQ(flaw(projection, {"solver.dt=2e-2"}), "diverged");
    EXPECT_EQ(flaw(projection, {"ball.position=5,5,5", "ground.solid=false"}), "no_contact");
    EXPECT_EQ(flaw(penalty, {"contact.stiffness=10"}), "penetration");
    EXPECT_EQ(flaw(projection, {"cloth.drag=0", "contact.friction=0", "restitution=1", "dt=1e-3"}), "speed");
}

}  // namespace
}  // namespace drape
