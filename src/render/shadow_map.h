#pragma once

#include "gl_objects.h"

namespace drape {

/// The depths as seen from the light, for shadows. Its texture stays bound to unit 0, where depths are compared and
/// smoothed between texels, and to unit 3, where they are read as they are.
class ShadowMap {
public:
    static constexpr int texels = 320;  ///< along each side

    explicit ShadowMap(Gl& gl);

    /// Starts the shadow's pass: what follows casts.
    void begin();

private:
    Gl& gl_;
    Texture depth_;
    Sampler smooth_, plain_;
    Framebuffer framebuffer_;
};

}  // namespace drape
