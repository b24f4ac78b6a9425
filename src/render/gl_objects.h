#pragma once

#include <utility>

#include "gl.h"

namespace drape {

enum class GlKind { Buffer, VertexArray, Texture, Sampler, Renderbuffer, Framebuffer };

/// Owns one OpenGL object. It must go before the context and the counter do.
template <GlKind kind>
class GlObject {
public:
    explicit GlObject(Gl& gl) : gl_(&gl) {
        if constexpr (kind == GlKind::Buffer) gl(glGenBuffers, 1, &name_);
        if constexpr (kind == GlKind::VertexArray) gl(glGenVertexArrays, 1, &name_);
        if constexpr (kind == GlKind::Texture) gl(glGenTextures, 1, &name_);
        if constexpr (kind == GlKind::Sampler) gl(glGenSamplers, 1, &name_);
        if constexpr (kind == GlKind::Renderbuffer) gl(glGenRenderbuffers, 1, &name_);
        if constexpr (kind == GlKind::Framebuffer) gl(glGenFramebuffers, 1, &name_);
    }

    ~GlObject() {
        if (name_ == 0) return;
        if constexpr (kind == GlKind::Buffer) (*gl_)(glDeleteBuffers, 1, &name_);
        if constexpr (kind == GlKind::VertexArray) (*gl_)(glDeleteVertexArrays, 1, &name_);
        if constexpr (kind == GlKind::Texture) (*gl_)(glDeleteTextures, 1, &name_);
        if constexpr (kind == GlKind::Sampler) (*gl_)(glDeleteSamplers, 1, &name_);
        if constexpr (kind == GlKind::Renderbuffer) (*gl_)(glDeleteRenderbuffers, 1, &name_);
        if constexpr (kind == GlKind::Framebuffer) (*gl_)(glDeleteFramebuffers, 1, &name_);
    }

    GlObject(GlObject&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        return *this;
    }

    [[nodiscard]] GLuint name() const { return name_; }

private:
    Gl* gl_;
    GLuint name_ = 0;
};

using Buffer = GlObject<GlKind::Buffer>;
using VertexArray = GlObject<GlKind::VertexArray>;
using Texture = GlObject<GlKind::Texture>;
using Sampler = GlObject<GlKind::Sampler>;
using Renderbuffer = GlObject<GlKind::Renderbuffer>;
using Framebuffer = GlObject<GlKind::Framebuffer>;

/// A vertex attribute of `components` floats in the buffer that is bound.
struct Attribute {
    GLuint location;
    int components;
    std::size_t stride;
    std::size_t start;
};

/// Tells the vertex array that is bound where an attribute starts in the buffer that is bound.
inline void place_attribute(Gl& gl, const Attribute& attribute) {
    gl(glVertexAttribPointer, attribute.location, attribute.components, GLenum{GL_FLOAT}, GLboolean{GL_FALSE},
       static_cast<GLsizei>(attribute.stride), Gl::offset(attribute.start));
}

/// Turns an attribute of the vertex array that is bound into an array; `place_attribute` says where it is.
inline void enable_attribute(Gl& gl, GLuint location, bool per_instance = false) {
    gl(glEnableVertexAttribArray, location);
    if (per_instance) gl(glVertexAttribDivisor, location, 1u);
}

}  // namespace drape
