#include "drape/scene/memory.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <cstdlib>
#include <utility>

#include "sim/small_scene.h"
#include "support/address_space.h"
#include "support/allocations.h"
#include "support/input_errors.h"

namespace drape {
namespace {

Settings settings_of(const std::string& method, int side, const std::vector<std::string>& more = {}) {
    Settings settings = small_settings();
    settings.cloths[0].particles = {side, side};
    settings.solver.dt = Real(1e-5);
    assign(settings, "solver.integrator=" + method);
    assign_all(settings, more);
    return settings;
}

/// The most that making a simulation and some steps of it take, as counted [bytes].
double bytes_taken(const Settings& settings, int steps) {
    const long long before = test::bytes_held();
    test::forget_most_bytes_held();
    Simulation simulation("counted", settings);
    make_steps(simulation, steps);
    return static_cast<double>(test::most_bytes_held() - before);
}

/// Expects the estimate to be near what is taken.
void expect_near(const Settings& settings, const std::string& told, int steps = 3) {
    const double taken = bytes_taken(settings, steps);
    if (test::allocations() == 0) GTEST_SKIP() << "a sanitizer counts for itself";
    EXPECT_GT(memory_needed(settings), 0.6 * taken) << told << ", bytes taken: " << taken;
    EXPECT_LT(memory_needed(settings), 3 * taken) << told << ", bytes taken: " << taken;
}

TEST(Memory, IsEstimatedForEveryMethodVolumeAndSizeOfExactFactors) {
    for (const std::string& method : names_of<IntegratorKind>()) {
        for (const int side : {40, 150}) expect_near(settings_of(method, side), method + " " + std::to_string(side));
    }
    for (const int side : {16, 32, 72, 100}) {
        expect_near(settings_of("backward_euler", side, {"solver.hessian=exact"}), "exact " + std::to_string(side));
    }
    for (const std::string& volume : names_of<VolumeKind>()) {
        expect_near(settings_of("xpbd", 100, {"contact.leaf_cells=1", "contact.volume=" + volume}), volume);
    }
}

/// Three flat sheets that lie on each other, whose pairs some threads look through.
Settings lying_sheets(int side) {
    Settings settings = load_scene("stack");
    settings.balls.clear();
    Real height = Real(0.004);
    for (ClothParameters& cloth : settings.cloths) {
        cloth.particles = {side, side};
        cloth.place = {0, std::exchange(height, height + Real(0.0045)), 0};
        cloth.width = cloth.height = 1;
    }
    settings.contact.thickness = Real(0.004);
    settings.solver.dt = 1e-4;
    settings.solver.threads = 4;
    settings.solver.sleep_speed = 0;
    return settings;
}

TEST(Memory, IsEstimatedWhereClothLiesOnCloth) {
    for (const int side : {30, 60}) expect_near(lying_sheets(side), "stack " + std::to_string(side), 20);
}

#ifdef DRAPE_CAN_LIMIT_ADDRESS_SPACE
/// Exit code 0 if `work` ends in the error that says what needed how much.
template <class Work>
[[noreturn]] void exit_as_told(Work work) {
    try {
        work();
    } catch (const RunError& error) {
        std::_Exit(std::string(error.what()).starts_with("out of memory: 22500 particles with projective_dynamics need")
                       ? 0
                       : 1);
    }
    std::_Exit(2);
}

constexpr std::size_t too_little = 10'000'000;  // bytes

TEST(MemoryDeathTest, ThatRunsOutInAStepEndsTheRun) {
    const auto run = [] {
        Simulation simulation("large", settings_of("projective_dynamics", 150));
        test::limit_address_space(too_little);
        exit_as_told([&] { simulation.step(); });
    };
    EXPECT_EXIT(run(), ::testing::ExitedWithCode(0), "");
}

TEST(MemoryDeathTest, ThatRunsOutInMakingASceneEndsTheRun) {
    const auto run = [] {
        // Addresses without memory, so that the limit is far above the estimate
        constexpr std::size_t giga = 1'000'000'000;
        mmap(nullptr, giga, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        test::limit_address_space(too_little / 5);
        exit_as_told([&] { Simulation simulation("large", settings_of("projective_dynamics", 150)); });
    };
    EXPECT_EXIT(run(), ::testing::ExitedWithCode(0), "");
}

TEST(MemoryDeathTest, ThatTheProcessMayNotTakeIsRefusedBefore) {
    const auto run = [] {
        test::limit_address_space(too_little);
        const std::string error = test::input_error_of([] { check(settings_of("projective_dynamics", 1000)); });
        std::_Exit(error.find("(ulimit -v)") != error.npos ? 0 : 1);
    };
    EXPECT_EXIT(run(), ::testing::ExitedWithCode(0), "");
}
#endif

}  // namespace
}  // namespace drape
