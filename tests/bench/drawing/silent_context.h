#pragma once

#include "capture/gl_context.h"

namespace drape {

/// An OpenGL 3.3 context that does nothing: what is drawn into it costs Drape's own code, and no driver.
class SilentContext : public GlContext {
public:
    [[nodiscard]] Function function(const char* name) const override;
};

}  // namespace drape
