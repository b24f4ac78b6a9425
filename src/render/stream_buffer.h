#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
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
    explicit StreamBuffer(Gl& gl) : gl_(gl), buffer_(gl) {
        for (std::size_t i = 0; i < regions; ++i) make_room(static_cast<Region>(i), usual[i]);
        bind_vertices();
        upload();
        gl(glBindBufferRange, GL_UNIFORM_BUFFER, 0, buffer_.name(), 0,
           static_cast<GLsizeiptr>(usual[index(Region::Frame)]));
    }

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

    void upload() {
        std::size_t end = capacities_[index(Region::Frame)];
        for (std::size_t i = 0; i < regions; ++i) {
            if (sizes_[i] > 0) end = std::max(end, starts_[i] + sizes_[i]);
        }
        gl_(glBufferData, GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(end), staging_.data(), GL_STREAM_DRAW);
    }

    /// Binds the buffer as the indices of the vertex array that is bound.
    void bind_indices() { gl_(glBindBuffer, GL_ELEMENT_ARRAY_BUFFER, buffer_.name()); }

    /// Binds the buffer as the vertices that attributes are set from.
    void bind_vertices() { gl_(glBindBuffer, GL_ARRAY_BUFFER, buffer_.name()); }

private:
    static constexpr std::size_t regions = static_cast<std::size_t>(Region::Count);
    static constexpr std::size_t alignment = 256;  // the largest that OpenGL 3.3 may ask of a uniform block

    // Room from the start: for a cloth of 30 x 30 with its outline, and whatever a usual frame has of the rest [byte]
    static constexpr std::array<std::size_t, regions> usual{1024,      256,       4096,      208 * 1024, 80 * 1024,
                                                            64 * 1024, 64 * 1024, 64 * 1024, 256 * 1024, 64 * 1024};

    static std::size_t aligned(std::size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }
    static std::size_t index(Region region) { return static_cast<std::size_t>(region); }

    void make_room(Region region, std::size_t bytes) {
        const std::size_t i = index(region);
        sizes_[i] = bytes;
        if (bytes <= capacities_[i]) return;
        capacities_[i] = aligned(std::max(bytes, capacities_[i] + capacities_[i] / 2));
        starts_[i] = staging_.size();
        staging_.resize(starts_[i] + capacities_[i]);
    }

    Gl& gl_;
    Buffer buffer_;
    std::array<std::size_t, regions> sizes_{}, capacities_{}, starts_{};
    std::vector<std::byte> staging_;
};

/// A vertex array whose attributes lie in one region of the stream.
class StreamArray {
public:
    StreamArray(Gl& gl, const StreamBuffer& stream, Region region, VertexLayout layout)
        : gl_(gl), stream_(stream), array_(gl), region_(region), layout_(std::move(layout)) {
        bind();
    }

    /// Binds it, where the region is by now.
    void bind() {
        gl_(glBindVertexArray, array_.name());
        if (stream_.start(region_) == start_) return;
        start_ = stream_.start(region_);
        layout_.set(gl_, start_);
    }

private:
    Gl& gl_;
    const StreamBuffer& stream_;
    VertexArray array_;
    Region region_;
    VertexLayout layout_;
    std::size_t start_ = std::numeric_limits<std::size_t>::max();  ///< where the attributes were last set; nowhere yet
};

}  // namespace drape
