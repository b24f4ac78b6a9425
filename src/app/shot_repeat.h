#pragma once

#include <optional>
#include <vector>

#include "drape/sim/simulation.h"

namespace drape {

/// Shows the beginning of a scene once more in slow motion, where what it is about takes a moment (`view.repeat`).
class ShotRepeat {
public:
    /// What is to be done now: after the shot the scene begins again, slowly, and after that it goes on as before.
    /// @param simulation between two steps
    [[nodiscard]] std::vector<Command> due(const Simulation& simulation);

    /// Takes notice of a command that was carried out: a scene that begins again has its repeat ahead, and who moves
    /// something sees what follows from that.
    void follow(const Command& command);

    /// Nothing is shown again before the next scene: a replay has what was.
    void end() { shot_ = Shot::Over; }

private:
    enum class Shot { First, Slow, Over };
    Shot shot_ = Shot::First;
    bool resets_ = false;          ///< the next reset is that of the repeat
    std::optional<double> speed_;  ///< to go back to
};

}  // namespace drape
