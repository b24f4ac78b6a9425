#include "drape/session/tour.h"

#include <algorithm>

#include "sim/small_scene.h"

namespace drape {
namespace {

TEST(Tour, HasThirteenStopsThatRunAndCompareWhatTheySay) {
    EXPECT_EQ(tour_stops().size(), 13u);
    Session session(Simulation("hang", load_scene("hang")));
    for (const TourStop& stop : tour_stops()) {
        for (const Command& command : commands_of(stop)) session.send(command);
        session.run_until(session.time() + session.simulation().settings().solver.dt);
        EXPECT_EQ(session.simulation().report().status, Status::Ok) << stop.title;
        EXPECT_EQ(session.view().comparison != nullptr, !stop.versus.empty()) << stop.title;
    }
}

Simulation at_picture(const TourStop& stop, const std::string& cure = {}) {
    Simulation simulation("hang", load_scene("hang"));
    for (const Command& command : commands_of(stop)) simulation.apply(command);
    if (!cure.empty()) send(simulation, cure);
    run_until(simulation, stop.time);
    return simulation;
}

const TourStop& stop_called(std::string_view title) {
    return *std::ranges::find(tour_stops(), title, &TourStop::title);
}

TEST(Tour, TunnelsWhereItSaysSoAndNotWhereItIsCured) {
    const TourStop stop = stop_called("Tunnelling");
    const Simulation through = at_picture(stop);
    EXPECT_EQ(through.report().contacts, 0);
    EXPECT_GT(through.balls()[0].centre.z(), 0.5);
    EXPECT_LT(at_picture(stop, "set contact.continuous=auto").balls()[0].centre.z(), 0.5);
}

TEST(Tour, ShowsLastingContactWhereRefitAndRebuildAreCompared) {
    Session session(Simulation("hang", load_scene("hang")));
    for (const Command& command : commands_of(stop_called("Rebuild against refit"))) session.send(command);
    std::int64_t refitted = 0, rebuilt = 0;
    for (int k = 1; k <= 12; ++k) {
        session.run_until(0.2 * k);
        const StepReport &refit = session.simulation().report(), &rebuild = *session.view().comparison->other.report;
        EXPECT_GT(refit.contacts, 0) << session.time();
        EXPECT_EQ(refit.contacts, rebuild.contacts) << session.time();
        refitted += refit.traversal.volume_tests, rebuilt += rebuild.traversal.volume_tests;
    }
    EXPECT_GT(refitted, rebuilt);
}

TEST(Tour, ItsNodesPruneWhatTheBallDoesNotTouch) {
    const Simulation nodes = at_picture(stop_called("What a tree prunes"));
    EXPECT_GT(nodes.report().contacts, 0);
    EXPECT_GT(nodes.report().traversal.pruned, 0);
}

}  // namespace
}  // namespace drape
