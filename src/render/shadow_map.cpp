#include "shadow_map.h"

namespace drape {

namespace {

void set_sampler(Gl& gl, GLuint unit, const Sampler& sampler, GLint filter) {
    const auto set = [&](GLenum parameter, GLint value) { gl(glSamplerParameteri, sampler.name(), parameter, value); };
    set(GL_TEXTURE_MIN_FILTER, filter);
    set(GL_TEXTURE_MAG_FILTER, filter);
    set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    set(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    gl(glBindSampler, unit, sampler.name());
}

}  // namespace

ShadowMap::ShadowMap(Gl& gl) : gl_(gl), depth_(gl), smooth_(gl), plain_(gl), framebuffer_(gl) {
    const GLenum target = GL_TEXTURE_2D;
    for (const GLenum unit : {GL_TEXTURE3, GL_TEXTURE0}) {
        gl(glActiveTexture, unit);
        gl(glBindTexture, target, depth_.name());
    }
    gl(glTexImage2D, target, 0, GLint{GL_DEPTH_COMPONENT24}, texels, texels, 0, GLenum{GL_DEPTH_COMPONENT},
       GLenum{GL_UNSIGNED_INT}, static_cast<const void*>(nullptr));
    gl(glTexParameteri, target, GLenum{GL_TEXTURE_MIN_FILTER}, GLint{GL_NEAREST});
    set_sampler(gl, 0, smooth_, GL_LINEAR);
    set_sampler(gl, 3, plain_, GL_NEAREST);

    gl(glBindFramebuffer, GLenum{GL_FRAMEBUFFER}, framebuffer_.name());
    gl(glFramebufferTexture2D, GLenum{GL_FRAMEBUFFER}, GLenum{GL_DEPTH_ATTACHMENT}, target, depth_.name(), 0);
    gl(glDrawBuffer, GLenum{GL_NONE});
    gl(glReadBuffer, GLenum{GL_NONE});
}

void ShadowMap::begin() {
    gl_(glBindFramebuffer, GLenum{GL_FRAMEBUFFER}, framebuffer_.name());
    gl_(glViewport, 0, 0, texels, texels);
    gl_(glClear, GLbitfield{GL_DEPTH_BUFFER_BIT});
}

}  // namespace drape
