#include "shadow_map.h"

namespace drape {

ShadowMap::ShadowMap(Gl& gl) : gl_(gl), depth_(gl), framebuffer_(gl) {
    const GLenum target = GL_TEXTURE_2D;
    gl(glActiveTexture, GLenum{GL_TEXTURE0});
    gl(glBindTexture, target, depth_.name());
    gl(glTexImage2D, target, 0, GLint{GL_DEPTH_COMPONENT24}, texels, texels, 0, GLenum{GL_DEPTH_COMPONENT},
       GLenum{GL_UNSIGNED_INT}, static_cast<const void*>(nullptr));
    gl(glTexParameteri, target, GLenum{GL_TEXTURE_MIN_FILTER}, GLint{GL_LINEAR});
    gl(glTexParameteri, target, GLenum{GL_TEXTURE_MAG_FILTER}, GLint{GL_LINEAR});
    gl(glTexParameteri, target, GLenum{GL_TEXTURE_WRAP_S}, GLint{GL_CLAMP_TO_EDGE});
    gl(glTexParameteri, target, GLenum{GL_TEXTURE_WRAP_T}, GLint{GL_CLAMP_TO_EDGE});
    gl(glTexParameteri, target, GLenum{GL_TEXTURE_COMPARE_MODE}, GLint{GL_COMPARE_REF_TO_TEXTURE});
    gl(glTexParameteri, target, GLenum{GL_TEXTURE_COMPARE_FUNC}, GLint{GL_LEQUAL});

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
