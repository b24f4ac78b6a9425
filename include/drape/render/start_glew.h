#pragma once

namespace drape {

/// Finds the functions of the OpenGL context that is current. GLX may be missing, as under Wayland or EGL.
/// @throws RunError that says why they were not found
void start_glew();

}  // namespace drape
