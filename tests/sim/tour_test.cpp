#include "drape/sim/tour.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "drape/bounds/node_view.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

TEST(Tour, HasTwelveStopsThatRun) {
    EXPECT_EQ(tour_stops().size(), 12u);
    for (const TourStop& stop : tour_stops()) {
        Simulation simulation(std::string(stop.scene), settings_of(stop));
        simulation.step();
        EXPECT_EQ(simulation.report().status, Status::Ok) << stop.title;
    }
}

// The panel has one line for each of them.
TEST(Tour, SaysItShortly) {
    for (const TourStop& stop : tour_stops()) {
        for (const std::string_view line : {stop.look, stop.try_it}) {
            EXPECT_LE(line.size(), 110u) << line;
            EXPECT_THAT(std::string(line), testing::EndsWith(stop.look == line && line.ends_with('?') ? "?" : "."));
        }
    }
}

Simulation at_picture(const TourStop& stop) {
    Simulation simulation(std::string(stop.scene), settings_of(stop));
    while (simulation.report().time < stop.time && simulation.report().status == Status::Ok) simulation.step();
    return simulation;
}

const TourStop& stop_called(std::string_view title) {
    return *std::ranges::find(tour_stops(), title, &TourStop::title);
}

TEST(Tour, TunnelsWhereItSaysSoAndNotWhereItIsCured) {
    TourStop stop = stop_called("Tunnelling");
    const Simulation through = at_picture(stop);
    EXPECT_EQ(through.report().contacts, 0);
    EXPECT_GT(through.balls()[0].centre.z(), 0.5);
    Settings cured = settings_of(stop);
    cured.contact.continuous = Continuous::Auto;
    Simulation caught(std::string(stop.scene), cured);
    while (caught.report().time < stop.time) caught.step();
    EXPECT_LT(caught.balls()[0].centre.z(), 0.5);
}

std::vector<BoundingSphere> spheres_at(const Simulation& simulation, int level) {
    std::vector<NodeView> nodes;
    simulation.cloths()[0].search.hierarchy().nodes_at(level, nodes);
    std::vector<BoundingSphere> spheres;
    for (const NodeView& node : nodes) spheres.push_back(std::get<BoundingSphere>(node.volume));
    return spheres;
}

TEST(Tour, ItsRefitUpdatesParentsFromChildrenAndOnlyWhereClothHasMoved) {
    struct Seen {
        long unchanged, leaves;  // within a few steps
        Real root;               // radius [m]
    };
    const TourStop& stop = stop_called("Rebuild against refit");
    const auto seen_with = [&](const Settings& settings) {
        Simulation simulation(std::string(stop.scene), settings);
        while (simulation.report().time < stop.time) simulation.step();
        const int finest = simulation.cloths()[0].search.hierarchy().levels();
        const std::vector<BoundingSphere> before = spheres_at(simulation, finest);
        for (int step = 0; step < 5; ++step) simulation.step();
        const std::vector<BoundingSphere> after = spheres_at(simulation, finest);
        long unchanged = 0;
        for (std::size_t n = 0; n < before.size(); ++n) {
            unchanged += before[n].centre == after[n].centre && before[n].radius == after[n].radius ? 1 : 0;
        }
        return Seen{unchanged, static_cast<long>(before.size()), spheres_at(simulation, 0).front().radius};
    };
    const Seen refit = seen_with(settings_of(stop));
    EXPECT_GT(refit.unchanged, 0);
    EXPECT_LT(refit.unchanged, refit.leaves);
    Settings settings = settings_of(stop);
    settings.contact.update = UpdateKind::Rebuild;
    const Seen rebuild = seen_with(settings);
    EXPECT_EQ(rebuild.unchanged, 0);
    EXPECT_GT(refit.root, rebuild.root) << "around spheres, not particles";
}

TEST(Tour, ItsNodesPruneWhatTheBallDoesNotTouch) {
    const Simulation nodes = at_picture(stop_called("What a tree prunes"));
    EXPECT_GT(nodes.report().contacts, 0);
    EXPECT_GT(nodes.report().traversal.pruned, 0);
}

}  // namespace
}  // namespace drape
