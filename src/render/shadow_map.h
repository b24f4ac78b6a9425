#pragma once

#include "gl.h"

namespace drape {

/// The depths as seen from the light, for shadows. Its texture stays bound to unit 0, where depths are compared and
/// smoothed between texels, and to unit 3, where they are read as they are.
class ShadowMap {
public:
    static constexpr int texels = 320;  ///< along each side

    explicit ShadowMap(Gl& gl) : gl_(gl) {
        const GLenum target = GL_TEXTURE_2D;
        for (const GLenum unit : {GLenum{GL_TEXTURE3}, GLenum{GL_TEXTURE0}}) {
            gl(glActiveTexture, unit);
            gl(glBindTexture, target, depth_.name());
        }
        gl(glTexImage2D, target, 0, GL_DEPTH_COMPONENT24, texels, texels, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
           nullptr);
        gl(glTexParameteri, target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        set_sampler(0, smooth_, GL_LINEAR, GL_COMPARE_REF_TO_TEXTURE);
        set_sampler(3, plain_, GL_NEAREST, GL_NONE);

        gl(glBindFramebuffer, GL_FRAMEBUFFER, framebuffer_.name());
        gl(glFramebufferTexture2D, GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, target, depth_.name(), 0);
        gl(glDrawBuffer, GL_NONE);
        gl(glReadBuffer, GL_NONE);
    }

    /// Starts the shadow's pass: what follows casts.
    void begin() {
        gl_(glBindFramebuffer, GL_FRAMEBUFFER, framebuffer_.name());
        gl_(glViewport, 0, 0, texels, texels);
        gl_(glClear, GL_DEPTH_BUFFER_BIT);
    }

private:
    void set_sampler(GLuint unit, const Sampler& sampler, GLint filter, GLint compare) {
        const auto set = [&](GLenum parameter, GLint value) {
            gl_(glSamplerParameteri, sampler.name(), parameter, value);
        };
        set(GL_TEXTURE_MIN_FILTER, filter);
        set(GL_TEXTURE_MAG_FILTER, filter);
        set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        set(GL_TEXTURE_COMPARE_MODE, compare);
        set(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
        gl_(glBindSampler, unit, sampler.name());
    }

    Gl& gl_;
    Texture depth_{gl_};
    Sampler smooth_{gl_}, plain_{gl_};
    Framebuffer framebuffer_{gl_};
};

}  // namespace drape
