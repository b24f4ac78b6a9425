#include "drape/session/tour.h"

#include <algorithm>

#include "sim/small_scene.h"

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

Simulation at_picture(const TourStop& stop) {
    Simulation simulation(std::string(stop.scene), settings_of(stop));
    run_until(simulation, stop.time);
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
    run_until(caught, stop.time);
    EXPECT_LT(caught.balls()[0].centre.z(), 0.5);
}

TEST(Tour, ItsNodesPruneWhatTheBallDoesNotTouch) {
    const Simulation nodes = at_picture(stop_called("What a tree prunes"));
    EXPECT_GT(nodes.report().contacts, 0);
    EXPECT_GT(nodes.report().traversal.pruned, 0);
}

}  // namespace
}  // namespace drape
