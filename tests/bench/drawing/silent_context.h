#pragma once

#include "capture/gl_context.h"

namespace drape {

/// The functions of an OpenGL 3.3 context that does nothing: what is drawn into it costs Drape's own code, and no
/// driver.
GlContext::Function silent_function(const char* name);

}  // namespace drape
