#include "stream_buffer.h"

#include <algorithm>

namespace drape {

namespace {
constexpr std::size_t alignment = 256;  // the largest that OpenGL 3.3 may ask of a uniform block
}

StreamBuffer::StreamBuffer(Gl& gl) : gl_(gl), buffer_(gl) { bind_vertices(); }

bool StreamBuffer::arrange() {
    bool grown = staging_.empty();
    for (std::size_t i = 0; i < regions; ++i) {
        if (needs_[i] <= capacities_[i]) continue;
        capacities_[i] = std::max(needs_[i], capacities_[i] + capacities_[i] / 2);
        grown = true;
    }
    if (!grown) return false;

    std::size_t end = 0;
    for (std::size_t i = 0; i < regions; ++i) {
        places_[i] = end;
        end = (end + capacities_[i] + alignment - 1) / alignment * alignment;
    }
    staging_.resize(end);
    bind_vertices();
    gl_(glBindBufferRange, GLenum{GL_UNIFORM_BUFFER}, 0u, buffer_.name(), GLintptr{0},
        static_cast<GLsizeiptr>(needs_[index(Region::Frame)]));
    return true;
}

void StreamBuffer::upload() {
    // The last region that is in use ends the upload
    std::size_t end = 0;
    for (std::size_t i = 0; i < regions; ++i) {
        if (needs_[i] > 0) end = places_[i] + needs_[i];
    }
    bind_vertices();
    gl_(glBufferData, GLenum{GL_ARRAY_BUFFER}, static_cast<GLsizeiptr>(end), static_cast<const void*>(staging_.data()),
        GLenum{GL_STREAM_DRAW});
}

}  // namespace drape
