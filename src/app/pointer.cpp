#include "pointer.h"

#include <cmath>

namespace drape {

namespace {

constexpr double full_drag = 4.0;     // rad: a drag over the height of the picture
constexpr double wheel_factor = 0.9;  // of the distance, a notch

}  // namespace

std::vector<Command> Pointer::press(Button button, Modifiers held, int x, int y, const Sight& sight) {
    if (doing_ != Doing::Nothing) return {};
    button_ = button;
    from_x_ = x_ = x;
    from_y_ = y_ = y;
    if (button == Button::Middle || held.shift) {
        doing_ = Doing::Panning;
        return {};
    }
    const Pick pick = pick_particle(sight.view, sight.camera.ray(x, y, sight.width, sight.height));
    if (pick.particle < 0) {
        doing_ = Doing::Orbiting;
        return {};
    }
    if (held.control) return {command::Pin{pick.cloth, pick.particle}};
    doing_ = Doing::Pulling;
    hand_ = pick.point;
    return {command::Grab{pick.cloth, pick.particle}};
}

std::vector<Command> Pointer::release(Button button, const Sight& sight) {
    if (doing_ == Doing::Nothing || button != button_) return {};
    std::vector<Command> commands = flush(sight);
    if (doing_ == Doing::Pulling) commands.emplace_back(command::Release{});
    doing_ = Doing::Nothing;
    return commands;
}

std::vector<Command> Pointer::flush(const Sight& sight) {
    if (!moved() || sight.width < 1 || sight.height < 1) return {};
    const double across = double(x_ - from_x_) / sight.height;
    const double down = double(y_ - from_y_) / sight.height;
    from_x_ = x_;
    from_y_ = y_;
    switch (doing_) {
        case Doing::Orbiting:
            return {command::Orbit{-full_drag * across, full_drag * down}};
        case Doing::Panning:
            return {command::Pan{-across, down}};
        case Doing::Pulling:
            hand_ = sight.camera.on_facing_plane(sight.camera.ray(x_, y_, sight.width, sight.height), hand_);
            return {command::Drag{hand_}};
        case Doing::Nothing:
            break;
    }
    return {};
}

Command Pointer::wheel(int notches) { return command::Zoom{std::pow(wheel_factor, notches)}; }

}  // namespace drape
