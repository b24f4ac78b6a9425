#pragma once

#include <vector>

#include "gl.h"

namespace drape {

/// Owns one OpenGL object, made and deleted by these functions. It must go before the context and the counter do.
template <auto& generate, auto& remove>
class GlObject {
public:
    explicit GlObject(Gl& gl) : gl_(gl) { gl(generate, 1, &name_); }
    ~GlObject() { gl_(remove, 1, &name_); }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;

    [[nodiscard]] GLuint name() const { return name_; }

private:
    Gl& gl_;
    GLuint name_ = 0;
};

using Buffer = GlObject<glGenBuffers, glDeleteBuffers>;
using VertexArray = GlObject<glGenVertexArrays, glDeleteVertexArrays>;
using Texture = GlObject<glGenTextures, glDeleteTextures>;
using Sampler = GlObject<glGenSamplers, glDeleteSamplers>;
using Renderbuffer = GlObject<glGenRenderbuffers, glDeleteRenderbuffers>;
using Framebuffer = GlObject<glGenFramebuffers, glDeleteFramebuffers>;

/// A vertex attribute: floats, or bytes that stand for [0, 1].
struct Attribute {
    GLuint location;
    int components;
    GLenum type = GL_FLOAT;
};

/// The vertices of a buffer, in each of which the attributes follow one another; they change with each vertex, or with
/// each instance.
struct VertexLayout {
    std::size_t stride;  ///< from vertex to vertex [byte]
    std::vector<Attribute> attributes;
    bool per_instance = false;

    /// Makes arrays of the attributes in the vertex array that is bound; `set` says where they are.
    void enable(Gl& gl) const {
        for (const Attribute& attribute : attributes) {
            gl(glEnableVertexAttribArray, attribute.location);
            if (per_instance) gl(glVertexAttribDivisor, attribute.location, 1);
        }
    }

    /// Tells the vertex array that is bound that the vertices start at a byte of the buffer that is bound.
    void set(Gl& gl, std::size_t start) const {
        for (const auto& [location, components, type] : attributes) {
            const bool is_float = type == GL_FLOAT;
            gl(glVertexAttribPointer, location, components, type, !is_float, static_cast<GLsizei>(stride),
               Gl::offset(start));
            start += static_cast<std::size_t>(components) * (is_float ? sizeof(float) : 1);
        }
    }
};

/// Fills a buffer, which stays bound, with what does not change from frame to frame.
template <class T>
void fill_static(Gl& gl, GLenum target, const Buffer& buffer, const std::vector<T>& data) {
    gl(glBindBuffer, target, buffer.name());
    gl(glBufferData, target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
}

}  // namespace drape
