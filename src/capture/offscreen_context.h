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

}  // namespace drape
