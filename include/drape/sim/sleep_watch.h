#pragma once

#include <span>
#include <vector>

#include "drape/sim/cloth.h"

namespace drape {

/// Watches whether the particles of a cloth have stayed for a while. Not their speed at a moment, which a swing at its
/// turning point does not have either, but how far any of them has come since the watch began: half a second later a
/// swing has left its position, and so has what creeps at the given speed, but a quiver has not.
class RestWatch {
public:
    /// How long particles have to stay [s].
    static constexpr double duration = 0.5;

    /// The watch begins again with the next look.
    void restart() { watching_ = false; }

    /// What it goes on from.
    /// @param particles that it watches
    void exchange(SnapshotText& text, Eigen::Index particles);

    /// One step more; a particle that has gone farther than `distance` makes the watch begin again.
    /// @param time simulated [s]
    /// @param distance how far a particle may go within `duration` [m]
    /// @return true if every particle has stayed for all of it
    /// @par Cost O(particles), one pass; allocates at the first look only
    bool look(const Points& x, double time, Real distance);

private:
    bool watching_ = false;
    double since_ = 0;
    Points start_;  ///< when the watch began
};

/// Watches over all cloths and free balls of a scene whether it may fall asleep.
class SleepWatch {
public:
    /// The watch begins again with the next look.
    void restart();

    /// What it goes on from.
    void exchange(SnapshotText& text, std::span<const Cloth> cloths, std::size_t balls);

    /// One step more.
    /// @param time simulated [s]
    /// @param speed of the slowest motion that keeps a scene awake [m/s]
    /// @return true if every particle and every ball has stayed, and no free ball has turned faster, for
    /// `RestWatch::duration`
    bool look(std::span<const Cloth> cloths, std::span<const Ball> balls, double time, Real speed);

private:
    bool balls_rest(std::span<const Ball> balls, double time, Real speed);

    std::vector<RestWatch> watches_;  ///< of each cloth
    RestWatch ball_watch_;
    Points centres_;  ///< of the balls
};

}  // namespace drape
