#pragma once

#include <optional>
#include <vector>

#include "drape/sim/simulation.h"

namespace drape {

/// Shows the beginning of a scene once more in slow motion, where what it is about takes a moment (`view.repeat`).
class ShotRepeat {
public:
    /// What is to be done now: after the shot the scene begins again, slowly, and after that it goes on as before. A
    /// scene that was later than its shot when it was first seen is left alone.
    /// @param simulation between two steps
    [[nodiscard]] std::vector<Command> due(const Simulation& simulation);

    /// Takes notice of a command that was carried out: a scene that begins again has its repeat ahead; who moves
    /// something sees what follows from that, and who sets the speed keeps it.
    void follow(const Command& command);

    /// Nothing is shown again before the next scene: a replay has what was.
    void end() { shot_ = Shot::Over; }

private:
    enum class Shot { Ahead, First, Slow, Over };
    Shot shot_ = Shot::Ahead;
    double end_ = 0;               ///< of the slow shot [s]
    bool resets_ = false;          ///< the next reset is that of the repeat
    std::optional<double> speed_;  ///< to go back to
};

}  // namespace drape
