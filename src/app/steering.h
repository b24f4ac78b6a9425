#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drape/render/camera.h"
#include "drape/render/entries.h"

namespace drape {

/// Turns held keys into where the ball goes, relative to the viewer.
class Steering {
public:
    /// A key of an entry goes down or up. The key's letter counts, not Shift, which may be let go first. A key that is
    /// let go before `update` has seen it counts once.
    void press(const std::string& key, const Entry& entry);
    void release(const std::string& key);

    /// The menu's way: as if the entry's key were held for half a second.
    void nudge(const Entry& entry);

    /// Every key goes up, as when the window loses the keyboard.
    void release_all() { held_.clear(); }

    /// The simulation no longer knows what was given, as after a reset: it is given again.
    void forget_given() { given_.setZero(); }

    [[nodiscard]] bool active() const { return !held_.empty(); }

    /// Lets time pass for nudges.
    void advance(double elapsed);

    /// The command to give now, if the direction is not the one that was last given. Length 1, or 0 to let go.
    std::optional<command::Steer> update(const Camera& camera);

private:
    struct Held {
        std::string key;  ///< empty for a nudge
        Vec3 direction;   ///< right, up, ahead
        double left;      ///< time that a nudge still lasts [s]
        bool used;        ///< `update` has seen it
    };

    std::vector<Held> held_;
    Vec3 given_ = Vec3::Zero();
};

}  // namespace drape
