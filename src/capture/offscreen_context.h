#pragma once

#include <memory>

#include "gl_context.h"

namespace drape {

/// An OpenGL 3.3 core context without a display, current from construction to destruction, with GLEW initialised.
/// Pictures go into framebuffer objects; there is no default framebuffer to speak of. There may be one at a time.
class OffscreenContext {
public:
    /// @throws RunError if the system has no such context
    explicit OffscreenContext(ContextKind kind = ContextKind::Auto);

private:
    std::unique_ptr<GlContext> context_;
};

/// Leads every function of OpenGL that Drape calls to a context, which is current: those of OpenGL 1.1, which GLEW
/// takes from the library that it was built for, and all others, for which it asks GLX. There is one context at a time.
/// @throws RunError if the context does not have one of them
void load_gl_functions(const GlContext& context);

}  // namespace drape
