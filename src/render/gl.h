#pragma once

#include <GL/glew.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

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

}  // namespace drape
