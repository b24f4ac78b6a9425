#pragma once

#include <string>

#include "drape/render/camera.h"
#include "drape/sim/frame_view.h"

namespace drape {

/// Hears the errors of the current context from now on, each with the call that makes it. The window was asked for
/// with GLUT_DEBUG.
/// @param first_error receives that which OpenGL reports first; it outlives the context
/// @throws RunError if this OpenGL does not report them
void listen_for_errors(std::string& first_error);

/// Looks for what no picture may have: errors of OpenGL, and positions or views that are not finite.
/// @param gl_error as from `listen_for_errors`
/// @throws RunError that names a fault
/// @par Cost a pass over the positions
void check_frame(const std::string& gl_error, const FrameView& view, const Camera& camera);

}  // namespace drape
