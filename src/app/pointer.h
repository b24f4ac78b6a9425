#pragma once

#include <cmath>
#include <vector>

#include "drape/render/camera.h"
#include "drape/sim/command.h"
#include "drape/sim/hand.h"

namespace drape {

/// What the pointer looks at.
struct Sight {
    const FrameView& view;
    const Camera& camera;
    int width;  ///< of the picture, in pixels
    int height;
};

/// Turns the mouse into commands: the left button turns the view or pulls cloth or a ball, the middle one (or Shift and
/// left) moves the view, and Control and left pin and free a particle. Movements wait for `flush`, so that there is at
/// most one command a frame.
class Pointer {
public:
    enum class Button { Left, Middle };

    /// Keys that are held with a button.
    struct Modifiers {
        bool shift = false, control = false;
    };

    [[nodiscard]] std::vector<Command> press(Button button, Modifiers held, int x, int y, const Sight& sight) {
        if (doing_ != Doing::Nothing) return {};
        button_ = button;
        from_x_ = x_ = x;
        from_y_ = y_ = y;
        if (button == Button::Middle || held.shift) {
            doing_ = Doing::Panning;
            return {};
        }
        const Pick pick = pick_particle(sight.view, sight.camera.ray(x, y, sight.width, sight.height));
        // In a replay or in the past it would replace what followed, and balls are where people aim to turn the view
        const Timeline& timeline = sight.view.timeline;
        const bool takes_ball = pick.ball >= 0 && timeline.is_live() && !timeline.replay &&
                                moves_by_hand(sight.view.settings->balls[static_cast<std::size_t>(pick.ball)]);
        if (pick.particle < 0 && !takes_ball) {
            doing_ = Doing::Orbiting;
            orbits_from_ball_ = pick.ball >= 0;
            return {};
        }
        if (held.control && !takes_ball) return {command::Pin{pick.cloth, pick.particle}};
        doing_ = Doing::Pulling;
        hand_ = pick.point;
        to_centre_ = pick.to_centre;
        if (takes_ball) return {command::Hold{pick.ball}};
        return {command::Grab{pick.cloth, pick.particle}};
    }

    [[nodiscard]] std::vector<Command> release(Button button, const Sight& sight) {
        if (doing_ == Doing::Nothing || button != button_) return {};
        std::vector<Command> commands = flush(sight);
        if (doing_ == Doing::Pulling) commands.emplace_back(command::Release{});
        doing_ = Doing::Nothing;
        return commands;
    }

    void move(int x, int y) { x_ = x, y_ = y; }

    [[nodiscard]] std::vector<Command> flush(const Sight& sight) {
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
                return {command::Drag{hand_ + to_centre_}};
            case Doing::Nothing:
                break;
        }
        return {};
    }

    /// Whether anything waits for `flush`.
    [[nodiscard]] bool moved() const { return doing_ != Doing::Nothing && (x_ != from_x_ || y_ != from_y_); }

    /// Whether the view is turned although the button went down on a ball, which the hand does not move.
    [[nodiscard]] bool orbits_from_ball() const { return doing_ == Doing::Orbiting && orbits_from_ball_; }

    /// Whether something is being done.
    [[nodiscard]] bool busy() const { return doing_ != Doing::Nothing; }

    /// Ends what is being done without a command, as when the scene it was done in is gone.
    void forget() { doing_ = Doing::Nothing; }

    /// @param notches of the wheel, positive away from the user
    [[nodiscard]] static Command wheel(int notches) { return command::Zoom{std::pow(wheel_factor, notches)}; }

private:
    enum class Doing { Nothing, Orbiting, Panning, Pulling };

    static constexpr double full_drag = 4.0;     ///< a drag over the height of the picture [rad]
    static constexpr double wheel_factor = 0.9;  ///< of the distance, a notch

    Doing doing_ = Doing::Nothing;
    Button button_ = Button::Left;
    bool orbits_from_ball_ = false;
    int from_x_ = 0, from_y_ = 0;  ///< where the last command left off
    int x_ = 0, y_ = 0;
    Vec3 hand_ = Vec3::Zero();       ///< the point that is pulled
    Vec3 to_centre_ = Vec3::Zero();  ///< from there, of the ball that is pulled
};

}  // namespace drape
