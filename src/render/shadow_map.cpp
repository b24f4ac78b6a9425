#include "shadow_map.h"

namespace drape {

namespace {

void set_sampler(Gl& gl, GLuint unit, const Sampler& sampler, GLint filter, GLint compare) {
    const auto set = [&](GLenum parameter, GLint value) { gl(glSamplerParameteri, sampler.name(), parameter, value); };
    set(GL_TEXTURE_MIN_FILTER, filter);
    set(GL_TEXTURE_MAG_FILTER, filter);
    set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    set(GL_TEXTURE_COMPARE_MODE, compare);
    set(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    gl(glBindSampler, unit, sampler.name());
}

}  // namespace

ShadowMap::ShadowMap(Gl& gl) : gl_(gl), depth_(gl), smooth_(gl), plain_(gl), framebuffer_(gl) {
    const GLenum target = GL_TEXTURE_2D;
    for (const GLenum unit : {GLenum{GL_TEXTURE3}, GLenum{GL_TEXTURE0}}) {
        gl(glActiveTexture, unit);
        gl(glBindTexture, target, depth_.name());
    }
    gl(glTexImage2D, target, 0, GL_DEPTH_COMPONENT24, texels, texels, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
    gl(glTexParameteri, target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    set_sampler(gl, 0, smooth_, GL_LINEAR, GL_COMPARE_REF_TO_TEXTURE);
    set_sampler(gl, 3, plain_, GL_NEAREST, GL_NONE);

    gl(glBindFramebuffer, GL_FRAMEBUFFER, framebuffer_.name());
    gl(glFramebufferTexture2D, GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, target, depth_.name(), 0);
    gl(glDrawBuffer, GL_NONE);
    gl(glReadBuffer, GL_NONE);
}

void ShadowMap::begin() {
    gl_(glBindFramebuffer, GL_FRAMEBUFFER, framebuffer_.name());
    gl_(glViewport, 0, 0, texels, texels);
    gl_(glClear, GL_DEPTH_BUFFER_BIT);
}

}  // namespace drape
