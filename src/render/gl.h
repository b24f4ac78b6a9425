#pragma once

#include <GL/glew.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace drape {

/// The only way to OpenGL in this folder: makes a call and counts it, `gl(glClear, GL_COLOR_BUFFER_BIT)`.
/// Drawing goes through `draw_...`, which count vertices too.
class Gl {
public:
    template <class Result, class... Parameters>
    Result operator()(Result (*function)(Parameters...), std::type_identity_t<Parameters>... arguments) {
        ++calls_;
        return function(arguments...);
    }

    void draw_arrays(GLenum mode, int count, int instances = 1) {
        vertices_ += std::int64_t{count} * instances;
        (*this)(glDrawArraysInstanced, mode, 0, count, instances);
    }

    /// @param start byte at which the 32-bit indices start in the vertex array's index buffer
    void draw_elements(GLenum mode, int count, std::size_t start = 0, int instances = 1) {
        vertices_ += std::int64_t{count} * instances;
        (*this)(glDrawElementsInstanced, mode, count, GL_UNSIGNED_INT, offset(start), instances);
    }

    /// Draws with 16-bit indices, as Dear ImGui makes them.
    void draw_short_elements(int count, std::size_t start, int base_vertex) {
        vertices_ += count;
        (*this)(glDrawElementsBaseVertex, GL_TRIANGLES, count, GL_UNSIGNED_SHORT, offset(start), base_vertex);
    }

    /// A byte offset in the shape in which OpenGL takes it.
    static void* offset(std::size_t bytes) { return reinterpret_cast<void*>(bytes); }

    void restart_count() { calls_ = vertices_ = 0; }
    [[nodiscard]] std::int64_t calls() const { return calls_; }
    [[nodiscard]] std::int64_t vertices() const { return vertices_; }

private:
    std::int64_t calls_ = 0;
    std::int64_t vertices_ = 0;
};

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

/// A vertex attribute: floats, whole numbers that become floats, or bytes that stand for [0, 1].
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

    /// Tells the vertex array that is bound that the vertices start at a byte of the buffer that is bound.
    void set(Gl& gl, std::size_t start) const {
        for (const auto& [location, components, type] : attributes) {
            const bool is_byte = type == GL_UNSIGNED_BYTE;
            gl(glEnableVertexAttribArray, location);
            if (per_instance) gl(glVertexAttribDivisor, location, 1);
            gl(glVertexAttribPointer, location, components, type, is_byte, static_cast<GLsizei>(stride),
               Gl::offset(start));
            start += static_cast<std::size_t>(components) * (is_byte ? 1 : sizeof(float));
        }
    }
};

/// Fills a buffer, which stays bound, with what does not change from frame to frame.
template <class T>
void fill_static(Gl& gl, GLenum target, const Buffer& buffer, const std::vector<T>& data) {
    gl(glBindBuffer, target, buffer.name());
    gl(glBufferData, target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
}

/// A vertex and a fragment shader, linked. Its block `Frame` is bound to point 0; `shadow_map` reads texture unit 0,
/// `atlas` unit 1, `studio_picture` unit 2 and `shadow_depths` unit 3.
class Program {
public:
    /// @param name of `shaders/NAME.vert` and `shaders/NAME.frag`
    /// @throws RunError with the compiler's log
    Program(Gl& gl, const std::string& name) : Program(gl, name, name) {}

    /// @param vertex, fragment the names of both files
    Program(Gl& gl, const std::string& vertex, const std::string& fragment);
    ~Program() { gl_(glDeleteProgram, name_); }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const { gl_(glUseProgram, name_); }

private:
    Gl& gl_;
    GLuint name_;
};

}  // namespace drape
