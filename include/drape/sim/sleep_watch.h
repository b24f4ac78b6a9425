#pragma once

#include <span>
#include <vector>

#include "drape/sim/cloth.h"
#include "drape/sim/rest_watch.h"

namespace drape {

/// Watches over all cloths of a scene whether it may fall asleep.
class SleepWatch {
public:
    /// The watch begins again with the next look.
    void restart();

    /// One step more.
    /// @param time simulated [s]
    /// @param speed of the slowest motion that keeps a scene awake [m/s]
    /// @return true if every particle has stayed for `RestWatch::duration`
    bool look(std::span<const Cloth> cloths, double time, Real speed);

private:
    std::vector<RestWatch> watches_;  ///< of each cloth
};

}  // namespace drape
