#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "gl_objects.h"

namespace drape {

/// What changes from frame to frame, in the order in which it lies in the one buffer.
enum class Region {
    Frame,
    Balls,
    Holders,
    Cloth,
    ClothIndices,
    Contacts,
    Spheres,
    Edges,
    OverlayVertices,
    OverlayIndices,
    Count
};

/// One buffer for all that changes from frame to frame, so that a frame needs one upload.
/// It stays bound to GL_ARRAY_BUFFER, for the upload and for `VertexLayout::set`.
/// First every part says what it needs, then `arrange`, then the parts follow regions that moved and write, then
/// `upload`.
class StreamBuffer {
public:
    /// Has room for a usual scene from the start, so that vertex arrays seldom have to follow.
    explicit StreamBuffer(Gl& gl);

    void need(Region region, std::size_t bytes) { needs_[index(region)] = bytes; }

    /// Makes room: a region that has grown beyond its capacity moves to the end.
    void arrange();

    /// Where a region is written.
    template <class T>
    T* data(Region region) {
        return reinterpret_cast<T*>(staging_.data() + start(region));
    }

    /// Where a region starts in the buffer, in bytes.
    [[nodiscard]] std::size_t start(Region region) const { return starts_[index(region)]; }

    void upload();

    /// Binds the buffer as the indices of the vertex array that is bound.
    void bind_indices() { gl_(glBindBuffer, GL_ELEMENT_ARRAY_BUFFER, buffer_.name()); }

    /// Binds the buffer as the vertices that attributes are set from.
    void bind_vertices() { gl_(glBindBuffer, GL_ARRAY_BUFFER, buffer_.name()); }

private:
    static constexpr std::size_t regions = static_cast<std::size_t>(Region::Count);
    static std::size_t index(Region region) { return static_cast<std::size_t>(region); }

    Gl& gl_;
    Buffer buffer_;
    std::array<std::size_t, regions> needs_{}, capacities_{}, starts_{};
    std::vector<std::byte> staging_;
};

/// A vertex array whose attributes lie in one region of the stream.
class StreamArray {
public:
    StreamArray(Gl& gl, const StreamBuffer& stream, Region region, VertexLayout layout);

    void bind() const { gl_(glBindVertexArray, array_.name()); }

    /// To be called after `StreamBuffer::arrange`.
    void follow(const StreamBuffer& stream);

private:
    Gl& gl_;
    VertexArray array_;
    Region region_;
    VertexLayout layout_;
    std::size_t start_;
};

}  // namespace drape
