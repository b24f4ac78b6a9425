#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "drape/render/camera.h"
#include "drape/render/entries.h"
#include "keys.h"

namespace drape {

/// Turns held keys into where the ball goes, relative to the viewer.
class Steering {
public:
    /// A key of an entry goes down or up. The key's letter counts, not Shift or Control, which may be let go first. A
    /// key that is let go before `update` has seen it counts once.
    void press(const std::string& key, const Entry& entry) {
        release(key);
        held_.push_back({without_modifiers(key), direction_of(entry), std::numeric_limits<double>::infinity(), false});
    }

    void release(const std::string& key) {
        for (Held& held : held_) {
            if (held.key == without_modifiers(key)) held.left = 0;
        }
    }

    /// The menu's way: as if the entry's key were held for half a second.
    void nudge(const Entry& entry) { held_.push_back({"", direction_of(entry), nudge_time, false}); }

    /// Every key goes up, as when the window loses the keyboard.
    void release_all() { held_.clear(); }

    /// The simulation no longer knows what was given, as after a reset: it is given again.
    void forget_given() { given_.setZero(); }

    [[nodiscard]] bool active() const { return !held_.empty(); }

    /// Lets time pass for nudges.
    void advance(double elapsed) {
        for (Held& held : held_) held.left -= elapsed;
        std::erase_if(held_, [](const Held& held) { return held.used && held.left <= 0; });
    }

    /// The command to give now, if the direction is not the one that was last given. Length 1, or 0 to let go.
    std::optional<command::Steer> update(const Camera& camera) {
        Vec3 seen = Vec3::Zero();
        for (Held& held : held_) {
            seen += held.direction;
            held.used = true;
        }
        const Vec3 sum = seen.x() * camera.right() + seen.y() * Vec3::UnitY() + seen.z() * camera.ahead();
        const Vec3 direction = sum.norm() > Real(1e-6) ? Vec3(sum.normalized()) : Vec3::Zero();
        if (direction == given_) return std::nullopt;
        given_ = direction;
        return command::Steer{direction};
    }

private:
    static Vec3 direction_of(const Entry& entry) {
        return std::get<command::Steer>(parse_command(entry.command)).direction;
    }

    static constexpr double nudge_time = 0.5;  ///< [s]

    struct Held {
        std::string key;  ///< empty for a nudge
        Vec3 direction;   ///< right, up, ahead
        double left;      ///< time that a nudge still lasts; 0 of a key that was let go [s]
        bool used;        ///< `update` has seen it
    };

    std::vector<Held> held_;
    Vec3 given_ = Vec3::Zero();
};

}  // namespace drape
