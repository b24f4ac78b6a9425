#pragma once

#include <string>

#include "drape/render/camera.h"
#include "drape/sim/frame_view.h"

namespace drape {

/// Watches a window for what no picture may have: errors of OpenGL, and positions or views that are not finite.
class FrameCheck {
public:
    /// Asks for a context that reports its errors, as the next window's.
    FrameCheck();
    FrameCheck(const FrameCheck&) = delete;
    FrameCheck& operator=(const FrameCheck&) = delete;

    /// Hears the errors of the current context from now on, each with the call that makes it.
    /// @throws RunError if this OpenGL does not report them
    void listen();

    /// @throws RunError that names the first fault so far
    /// @par Cost a pass over the positions
    void check(const FrameView& view, const Camera& camera) const;

private:
    std::string error_;  ///< that OpenGL has reported first; empty: none
};

}  // namespace drape
