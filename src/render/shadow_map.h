#pragma once

#include "gl_objects.h"

namespace drape {

/// The depths as seen from the light, for shadows. Its texture stays bound to unit 0.
class ShadowMap {
public:
    static constexpr int texels = 320;  ///< along each side

    explicit ShadowMap(Gl& gl);

    /// Starts the shadow's pass: what follows casts.
    void begin();

private:
    Gl& gl_;
    Texture depth_;
    Framebuffer framebuffer_;
};

}  // namespace drape
