#pragma once

#include <cstdint>
#include <string>

#include "drape/sim/simulation.h"

namespace drape {

/// What the user is told of balls that may have passed through the cloth unseen: each danger once, also where the user
/// has gone back to before it and plays it again.
class CrossingNews {
public:
    /// What is new; empty: nothing.
    [[nodiscard]] std::string take(const Simulation& simulation);

    /// The run begins again.
    void forget() { told_ = 0; }

    /// What came after the present moment is forgotten: dangers to come are new.
    void go_on_from(const Simulation& simulation) { told_ = simulation.report().crossing.starts; }

private:
    std::int64_t told_ = 0;  ///< dangers, counted from the start of the run
};

}  // namespace drape
