#include "drape/base/input_error.h"

#include <gtest/gtest.h>

#include <vector>

#include "drape/base/assert.h"

namespace drape {
namespace {

TEST(NearestName, HasTheFewestEdits) {
    const std::vector<std::string> names{"integrator", "dt", "on_unstable"};
    EXPECT_EQ(nearest_name("intergator", names), "integrator");
    EXPECT_EQ(nearest_name("Dt", names), "dt");
    EXPECT_EQ(nearest_name("", names), "dt");
    EXPECT_EQ(nearest_name("dt", {}), "");
}

TEST(NearestName, PrefersTheFirstOfEquallyNearOnes) {
    const std::vector<std::string> names{"cat", "bat"};
    EXPECT_EQ(nearest_name("hat", names), "cat");
}

TEST(NearestName, IsFoundForNamesOfAnyLength) {
    const std::vector<std::string> names{"rk4", "velocity_verlet"};
    EXPECT_EQ(nearest_name("velocity_verlet" + std::string(1'000'000, 'x'), names), "velocity_verlet");
}

TEST(ListedNames, ReadAsASentence) {
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed(std::vector<std::string>{"a"}), "'a'");
    EXPECT_EQ(listed(std::vector<std::string>{"a", "b"}), "'a' or 'b'");
    EXPECT_EQ(listed(std::vector<std::string>{"a", "b", "c"}), "'a', 'b' or 'c'");
}

TEST(BrokenAssertion, NamesConditionAndPlace) {
    EXPECT_DEATH(assertion_failed("x > 0", "cloth.cpp", 12), "cloth.cpp:12: this is a bug in Drape: expected x > 0");
}

}  // namespace
}  // namespace drape
