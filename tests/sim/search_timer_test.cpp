#include "drape/session/search_timer.h"

#include <gtest/gtest.h>

#include "sim/small_scene.h"

namespace drape {
namespace {

/// The small cloth while it lies against its ball.
Simulation touching_simulation(const std::vector<std::string>& assignments = {}) {
    Simulation simulation = small_simulation(assignments);
    for (int step = 0; step < 4096 && simulation.report().contacts < 3; ++step) simulation.step();
    EXPECT_GE(simulation.report().contacts, 3);
    return simulation;
}

TEST(SearchTimer, MeasuresBothWaysAndChangesNothing) {
    Simulation small = touching_simulation(), other = touching_simulation({"contact.volume=obb"});
    const Simulation undisturbed = small;
    for (Simulation* simulation : {&small, &other}) {
        const auto times = SearchTimer::measure(simulation->view(1));
        ASSERT_TRUE(times);
        EXPECT_GT(times->hierarchy, 0);
        EXPECT_GT(times->brute_force, 0);
    }
    EXPECT_EQ(small.hash(), undisturbed.hash());
}

TEST(SearchTimer, CountsClothOnClothWhereThatIsSearchedFor) {
    Simulation simulation = touching_simulation({"contact.self=true"});
    const auto with_pairs = SearchTimer::measure(simulation.view(1)).value();
    const double cells = simulation.cloths()[0].model.grid.cells();
    EXPECT_EQ(with_pairs.tests_of_brute_force, cells + cells * (cells + 1) / 2) << "of one ball, and of all pairs";
    EXPECT_GT(with_pairs.tests_saved(), 0);
    simulation.apply(parse_command("set contact.self=false"));
    const auto without = SearchTimer::measure(simulation.view(1)).value();
    EXPECT_EQ(without.tests_of_brute_force, cells);
}

TEST(SearchTimer, IsSteadyWhereNothingMovesAndForgetsOtherSettings) {
    SearchTimer timer;
    Simulation simulation = touching_simulation();
    const double once = timer.look(simulation.view(1))->speed_up();
    for (int look = 0; look < 3; ++look) EXPECT_EQ(timer.look(simulation.view(1))->speed_up(), once);
    simulation.apply(parse_command("set contact.self=true"));
    EXPECT_GT(timer.look(simulation.view(1))->tests_of_brute_force, simulation.cloths()[0].model.grid.cells());
}

TEST(SearchTimer, SaysNothingWhereThereIsNothingToCompare) {
    SearchTimer timer;
    for (const char* assignment :
         {"contact.volume=brute", "contact.update=refit", "contact.update=none", "contact.search_level=2"}) {
        Simulation simulation = small_simulation({assignment});
        EXPECT_FALSE(SearchTimer::measure(simulation.view(1))) << assignment;
        EXPECT_EQ(timer.look(simulation.view(1)), nullptr) << assignment;
    }
    Settings settings = small_settings();
    settings.balls.clear();
    Simulation without_ball("drop", std::move(settings));
    EXPECT_FALSE(SearchTimer::measure(without_ball.view(1)));
}

TEST(SearchTimer, FindsThatTheFirstSceneMakesFewOfTheTests) {
    Simulation simulation("veil", load_scene("veil"));
    make_steps(simulation, 1000);
    EXPECT_GT(SearchTimer::measure(simulation.view(1)).value().tests_saved(), 0.9);
}

TEST(SearchTimer, FindsThatTheLargeSceneTestsLessThanOneCellInThirty) {
    EXPECT_EQ(scene_names().at(8), "large") << "its key is 9 in the panel";
    Settings settings = load_scene("large");
    settings.balls[0].position = Vec3(0, Real(6.961), 0);  // within the thickness
    Simulation simulation("large", std::move(settings));
    make_steps(simulation, 10);
    const StepReport& report = simulation.report();
    ASSERT_GT(report.contacts, 0);
    const std::int64_t all = 255 * 255 * static_cast<std::int64_t>(simulation.balls().size());
    EXPECT_LT(30 * report.traversal.candidates, all);
    const auto times = SearchTimer::measure(simulation.view(1));
    EXPECT_TRUE(times);
}

}  // namespace
}  // namespace drape
