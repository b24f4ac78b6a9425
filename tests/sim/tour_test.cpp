#include "drape/sim/tour.h"

#include <gmock/gmock.h>

#include <algorithm>

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

TEST(Tour, ItsRefitAndItsNodesPruneMoreThanTheyTest) {
    const Simulation nodes = at_picture(stop_called("What a tree prunes"));
    EXPECT_GT(nodes.report().contacts, 0);
    EXPECT_GT(nodes.report().traversal.pruned, 0);
}

}  // namespace
}  // namespace drape
