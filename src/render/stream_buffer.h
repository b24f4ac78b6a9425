#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "gl.h"

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
/// Every part asks for room and writes, then `upload`, then arrays follow regions that moved as they are bound.
class StreamBuffer {
public:
    /// Has room for a usual scene from the start, so that vertex arrays seldom have to follow.
    explicit StreamBuffer(Gl& gl);

    /// Makes room for all that a region has in this frame: where it grows beyond its capacity it moves to the end, and
    /// what `room` and `data` gave before is no longer valid.
    /// @return where it is written
    template <class T>
    T* room(Region region, std::size_t count) {
        make_room(region, count * sizeof(T));
        return data<T>(region);
    }

    /// Where a region was written.
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

    void make_room(Region region, std::size_t bytes);

    Gl& gl_;
    Buffer buffer_;
    std::array<std::size_t, regions> sizes_{}, capacities_{}, starts_{};
    std::vector<std::byte> staging_;
};

/// A vertex array whose attributes lie in one region of the stream.
class StreamArray {
public:
    StreamArray(Gl& gl, const StreamBuffer& stream, Region region, VertexLayout layout);

    /// Binds it, where the region is by now.
    void bind();

private:
    Gl& gl_;
    const StreamBuffer& stream_;
    VertexArray array_;
    Region region_;
    VertexLayout layout_;
    std::size_t start_;
};

}  // namespace drape
