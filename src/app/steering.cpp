#include "steering.h"

#include <limits>

#include "keys.h"

namespace drape {

namespace {

constexpr double nudge_time = 0.5;  // s

Vec3 direction_of(const Entry& entry) { return std::get<command::Steer>(parse_command(entry.command)).direction; }

}  // namespace

void Steering::press(const std::string& key, const Entry& entry) {
    release(key);
    held_.push_back({without_shift(key), direction_of(entry), std::numeric_limits<double>::infinity(), false});
}

void Steering::release(const std::string& key) {
    const std::string name = without_shift(key);
    std::erase_if(held_, [&](const Held& held) { return held.key == name && held.used; });
    for (Held& held : held_) {
        if (held.key == name) held.left = 0;
    }
}

void Steering::nudge(const Entry& entry) { held_.push_back({"", direction_of(entry), nudge_time, false}); }

void Steering::advance(double elapsed) {
    for (Held& held : held_) held.left -= elapsed;
    std::erase_if(held_, [](const Held& held) { return held.used && held.left <= 0; });
}

std::optional<command::Steer> Steering::update(const Camera& camera) {
    Vec3 seen = Vec3::Zero();
    for (Held& held : held_) {
        seen += held.direction;
        held.used = true;
    }
    Vec3 direction = seen.x() * camera.right() + seen.y() * Vec3::UnitY() + seen.z() * camera.ahead();
    if (direction.norm() > Real(1e-6)) {
        direction.normalize();
    } else {
        direction.setZero();
    }
    if (direction == given_) return std::nullopt;
    given_ = direction;
    return command::Steer{direction};
}

}  // namespace drape
