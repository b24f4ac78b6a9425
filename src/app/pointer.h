#pragma once

#include <vector>

#include "drape/render/camera.h"
#include "drape/sim/command.h"

namespace drape {

/// What the pointer looks at.
struct Sight {
    const FrameView& view;
    const Camera& camera;
    int width;  ///< of the picture, in pixels
    int height;
};

/// Turns the mouse into commands: the left button turns the view or pulls the cloth, the middle one (or Shift and left)
/// moves the view, and Control and left pin and free a particle. Movements wait for `flush`, so that there is at most
/// one command a frame.
class Pointer {
public:
    enum class Button { Left, Middle };

    /// Keys that are held with a button.
    struct Modifiers {
        bool shift = false, control = false;
    };

    [[nodiscard]] std::vector<Command> press(Button button, Modifiers held, int x, int y, const Sight& sight);
    [[nodiscard]] std::vector<Command> release(Button button, const Sight& sight);
    void move(int x, int y) { x_ = x, y_ = y; }
    [[nodiscard]] std::vector<Command> flush(const Sight& sight);

    /// Whether anything waits for `flush`.
    [[nodiscard]] bool moved() const { return doing_ != Doing::Nothing && (x_ != from_x_ || y_ != from_y_); }

    /// Whether something is being done.
    [[nodiscard]] bool busy() const { return doing_ != Doing::Nothing; }

    /// Ends what is being done without a command, as when the scene it was done in is gone.
    void forget() { doing_ = Doing::Nothing; }

    /// @param notches of the wheel, positive away from the user
    [[nodiscard]] static Command wheel(int notches);

private:
    enum class Doing { Nothing, Orbiting, Panning, Pulling };

    Doing doing_ = Doing::Nothing;
    Button button_ = Button::Left;
    int from_x_ = 0, from_y_ = 0;  ///< where the last command left off
    int x_ = 0, y_ = 0;
    Vec3 hand_ = Vec3::Zero();  ///< the point that is pulled
};

}  // namespace drape
