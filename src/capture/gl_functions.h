#pragma once

#include "gl_context.h"

namespace drape {

/// Leads every function of OpenGL that Drape calls to a context, which is current: those of OpenGL 1.1, which GLEW
/// takes from the library that it was built for, and all others, for which it asks GLX. There is one context at a time.
/// @throws RunError if the context does not have one of them
void load_gl_functions(const GlContext& context);

}  // namespace drape
