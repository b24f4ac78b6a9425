// Steps whose build was left out, in whole runs.

#include <gtest/gtest.h>

#include <random>

#include "drape/bounds/node_view.h"
#include "drape/sim/scene.h"
#include "sim/scene_lists.h"
#include "sim/small_scene.h"
#include "support/exact_distance.h"

namespace drape {
namespace {

bool touches_anything(const Simulation& simulation) {
    for (const Cloth& cloth : simulation.cloths()) {
        for (const Ball& ball : simulation.balls()) {
            const Real depth = deepest_triangle(cloth.model.grid, cloth.state.x, ball);
            if (depth > -simulation.settings().contact.thickness) return true;
        }
    }
    return false;
}

/// One step. @return true if the build of every cloth was left out
bool step_skips(Simulation& simulation) {
    const std::int64_t before = simulation.report().skipped_builds;
    simulation.step();
    return simulation.report().skipped_builds == before + static_cast<std::int64_t>(simulation.cloths().size());
}

class CoherentScene : public testing::TestWithParam<std::string> {};

TEST_P(CoherentScene, TouchesNothingInTheStepsThatItSkipsAndHasTheSameBits) {
    Settings settings = load_scene(GetParam());
    settings.contact.volume = VolumeKind::Aabb;  // closer about cloths that lie or hang flat
    Simulation coherent(GetParam(), settings);
    settings.contact.coherence = false;
    Simulation plain(GetParam(), settings);
    int skips = 0;
    const int steps = cost_of(settings) == Cost::Small ? 4000 : 500;
    for (int step = 0; step < steps; ++step) {
        plain.step();
        if (!step_skips(coherent)) continue;
        if (skips++ % 10 > 0) continue;
        ASSERT_FALSE(touches_anything(coherent)) << "step " << step;
    }
    EXPECT_EQ(coherent.hash(), plain.hash());
    EXPECT_EQ(plain.report().skipped_builds, 0);
    EXPECT_EQ(skips > 100, !coherent.balls().empty()) << skips;
}

INSTANTIATE_TEST_SUITE_P(Some, CoherentScene, testing::Values("two_corners", "bullet"),
                         [](const auto& scene) { return scene.param; });
INSTANTIATE_TEST_SUITE_P(Nightly, CoherentScene, testing::ValuesIn(scenes_that_fail(false)),
                         [](const auto& scene) { return scene.param; });

/// What may happen between two steps, chosen so that balls leap far and back.
std::string random_command(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto number = [&](double scale) { return std::to_string(scale * unit(random)); };
    const auto vector = [&](double scale) { return number(scale) + "," + number(scale) + "," + number(scale); };
    switch (random() % 16) {
        case 0:
        case 1:
        case 2:
            return "set ball.position=" + vector(2);
        case 3:
            return "set ball.velocity=" + vector(30);
        case 4:
            return "set ball.radius=" + std::to_string(0.05 + 0.4 * std::abs(unit(random)));
        case 5:
            return "set thickness=" + std::to_string(0.05 * std::abs(unit(random)));
        case 6:
            return "next contact.volume";
        case 7:
            return "next contact.update";
        case 8:
            return "set leaf_cells=" + std::to_string(1 + random() % 5);
        case 9:
            return "steer " + number(1) + " " + number(1) + " " + number(1);
        case 10:
            return "set wind.velocity=" + vector(20);
        case 11:
            return "next wind.on";
        case 12:
            return "next view.bounds";
        case 13:
            return "grab 0 " + std::to_string(random() % 80);
        case 14:
            return "drag " + number(1) + " " + number(1) + " " + number(1);
        default:
            return "release";
    }
}

TEST(Coherence, IsNeverWrongWhateverHappensToBallAndCloth) {
    int skips = 0, contacts = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        std::mt19937 random(seed);
        const std::string motion = "ball.motion=path", path = "ball.path=0,0,0.2,3,0.2,0,0.2,-2,0.7,0,0.2,3";
        const std::vector<std::string> assignments =
            seed % 3 == 2 ? std::vector{path, motion, std::string("contact.update=none")} : std::vector<std::string>{};
        Simulation coherent = small_simulation(assignments), plain = small_simulation(assignments);
        send(plain, "set coherence=false");
        for (int step = 0; step < 1500; ++step) {
            if (random() % 30 == 0) {
                const std::string command = random_command(random);
                send(coherent, command), send(plain, command);
            }
            plain.step();
            if (step % 7 == 0) static_cast<void>(coherent.view());
            const bool skipped = step_skips(coherent);
            skips += skipped ? 1 : 0;
            contacts += coherent.report().contacts > 0 ? 1 : 0;
            ASSERT_FALSE(skipped && touches_anything(coherent)) << "seed " << seed << ", step " << step;
        }
        ASSERT_EQ(coherent.report().status, Status::Ok) << coherent.report().trouble;
        EXPECT_EQ(coherent.hash(), plain.hash()) << "seed " << seed;
    }
    EXPECT_GT(skips, 3000);
    EXPECT_GT(contacts, 500);
}

TEST(Coherence, DoesNotTakeANewTreeForTheOneThatItHasAsked) {
    // One cell whose far side the hand brings near, and back once there is a new tree about what is left
    Simulation simulation = small_simulation({"cloth.particles=2,2", "cloth.pinned=0,1,2,3", "ball.position=0,-9,0"});
    const auto carry = [&](const std::string& particle, const std::string& place) {
        send(simulation, "grab 0 " + particle);
        send(simulation, "drag " + place);
        make_steps(simulation, 800);
        send(simulation, "release");
    };
    make_steps(simulation, 10);
    carry("2", "-0.5 0.6 0.01");
    carry("3", "0.5 0.6 0.01");
    send(simulation, "set leaf_cells=2");
    carry("2", "-0.5 0.6 1");
    carry("3", "0.5 0.6 1");
    EXPECT_GT(simulation.report().skipped_builds, 3000);
    send(simulation, "set ball.position=0,0.6,1.2");
    simulation.step();
    EXPECT_GT(simulation.report().contacts, 0);
}

TEST(Coherence, CountsTheBuildsThatAreLeftOutSinceTheStart) {
    Simulation simulation = small_simulation({"ball.position=0,-9,0"});
    make_steps(simulation, 100);
    EXPECT_GT(simulation.report().skipped_builds, 80);
    EXPECT_EQ(simulation.report().traversal.volume_tests, 1) << "the root is tested to prove it";
    send(simulation, "reset");
    EXPECT_EQ(simulation.report().skipped_builds, 0);
}

TEST(Coherence, HasTheSameBitsWhileBoundsAreShown) {
    for (const char* update : {"update=rebuild", "update=refit", "update=none", "search_level=1"}) {
        const std::string motion = "ball.motion=path", path = "ball.path=0,0,0.2,3,0.5,0,0.2,0.4,3,0,0.2,0.3";
        Simulation shown = small_simulation({path, motion, update, "view.bounds=true"});
        Simulation hidden = small_simulation({path, motion, update});
        for (int step = 0; step < 2000; ++step) {
            shown.step(), hidden.step();
            if (step % 3 == 0) static_cast<void>(shown.view());
        }
        EXPECT_GT(shown.report().contacts, 0) << update;
        EXPECT_EQ(shown.report().skipped_builds > 0, std::string(update) != "search_level=1") << update;
        EXPECT_EQ(shown.hash(), hidden.hash()) << update;
    }
}

/// The root as it is drawn, less the one that a build from the present positions gives.
Real staleness_of_shown_root(Simulation& simulation) {
    const ClothView cloth = simulation.view().cloths[0];
    std::vector<NodeView> shown, fresh;
    cloth.hierarchy->nodes_at(0, shown);
    const auto tree = make_broad_phase(broad_phase_of(simulation.settings()), cloth.model.grid);
    tree->build(cloth.x);
    tree->nodes_at(0, fresh);
    const auto centre = [](const NodeView& node) { return std::get<BoundingSphere>(node.volume).centre; };
    return (centre(shown[0]) - centre(fresh[0])).norm();
}

TEST(Coherence, ShowsBoundsOfThePresentAsSoonAsTheyAreAskedFor) {
    for (const char* ball : {"ball.position=0,-9,0", "ball.position=0,0.2,0.4"}) {
        Simulation simulation = small_simulation({ball});
        make_steps(simulation, 300);
        send(simulation, "pause");
        EXPECT_EQ(simulation.report().skipped_builds > 0, staleness_of_shown_root(simulation) > 0.01);
        send(simulation, "next view.bounds");
        EXPECT_LT(staleness_of_shown_root(simulation), 1e-3);
    }
}

TEST(Coherence, ShowsWhatAQueryDoesWithANewHierarchyAtOnce) {
    for (const char* change : {"set contact.sphere_fit=ritter", "set leaf_cells=3", "next update"}) {
        Simulation simulation = small_simulation({"view.bounds=true", "leaf_cells=2"});
        while (simulation.report().contacts == 0) simulation.step();
        send(simulation, "pause");
        send(simulation, change);
        std::vector<NodeView> shown;
        simulation.view().cloths[0].hierarchy->nodes_at(0, shown);
        EXPECT_EQ(shown[0].visit, NodeVisit::Entered) << change;
    }
}

TEST(Coherence, LeavesLimitedSearchesAlone) {
    Simulation simulation = small_simulation({"ball.position=0,-9,0", "search_level=1"});
    make_steps(simulation, 100);
    EXPECT_EQ(simulation.report().skipped_builds, 0);
}

}  // namespace
}  // namespace drape
