#pragma once

#include <span>
#include <vector>

#include "drape/scene/settings.h"
#include "drape/sim/cloth.h"

namespace drape {

/// Leads the pins that `[[pins]]` of a scene moves, each group along its shift and its turns.
///
/// Within a substep a pin has the one velocity that takes it to where it is to be at the end: it is pinned for the
/// integrator, whose springs, dampers and contacts see that velocity. A pin that is elsewhere, because a hand has had
/// it, or contact has held it back, goes back to its way no faster than a hand would lead it.
class MovingPins {
public:
    /// Takes the groups of the settings.
    void use(const Settings& settings);

    /// Leaves its pins where they are, at rest.
    void let_go(std::span<Cloth> cloths);

    /// Gives pins the velocities of the substep, but for one that the hand holds, and counts the work of that.
    /// @param time at the start of the substep [s]
    /// @return whether any of them moves
    bool lead(std::span<Cloth> cloths, Real time, Real h);

    /// Counts the work that they have done in the step since `lead`.
    void count_work(std::span<Cloth> cloths, Real h) const;

private:
    struct Group {
        PinSettings settings;
        std::vector<int> particles;
        std::vector<Vec3> arms;  ///< from the middle to where each starts [m]
        Vec3 middle;             ///< [m]
        bool moves = false;      ///< within this substep
        double power = 0;        ///< at its start [W]
    };

    static bool lead(Group& group, Cloth& cloth, Real time, Real h);

    std::vector<Group> groups_;
};

}  // namespace drape
