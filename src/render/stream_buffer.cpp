#include "stream_buffer.h"

#include <algorithm>
#include <utility>

namespace drape {

namespace {

constexpr std::size_t alignment = 256;  // the largest that OpenGL 3.3 may ask of a uniform block

// Room from the start: for a cloth of 30 x 30 with its outline, and whatever a usual frame has of the rest [byte]
constexpr std::array<std::size_t, static_cast<std::size_t>(Region::Count)> usual{
    1024, 256, 4096, 128 * 1024, 80 * 1024, 64 * 1024, 64 * 1024, 64 * 1024, 256 * 1024, 64 * 1024};

std::size_t aligned(std::size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }

}  // namespace

StreamBuffer::StreamBuffer(Gl& gl) : gl_(gl), buffer_(gl) {
    for (std::size_t i = 0; i < regions; ++i) make_room(static_cast<Region>(i), usual[i]);
    bind_vertices();
    upload();
    gl(glBindBufferRange, GL_UNIFORM_BUFFER, 0, buffer_.name(), 0,
       static_cast<GLsizeiptr>(usual[index(Region::Frame)]));
}

void StreamBuffer::make_room(Region region, std::size_t bytes) {
    const std::size_t i = index(region);
    sizes_[i] = bytes;
    if (bytes <= capacities_[i]) return;
    capacities_[i] = aligned(std::max(bytes, capacities_[i] + capacities_[i] / 2));
    starts_[i] = staging_.size();
    staging_.resize(starts_[i] + capacities_[i]);
}

void StreamBuffer::upload() {
    std::size_t end = capacities_[index(Region::Frame)];
    for (std::size_t i = 0; i < regions; ++i) {
        if (sizes_[i] > 0) end = std::max(end, starts_[i] + sizes_[i]);
    }
    gl_(glBufferData, GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(end), staging_.data(), GL_STREAM_DRAW);
}

StreamArray::StreamArray(Gl& gl, const StreamBuffer& stream, Region region, VertexLayout layout)
    : gl_(gl), stream_(stream), array_(gl), region_(region), layout_(std::move(layout)), start_(stream.start(region)) {
    bind();
    layout_.enable(gl);
    layout_.set(gl, start_);
}

void StreamArray::bind() {
    gl_(glBindVertexArray, array_.name());
    if (stream_.start(region_) == start_) return;
    start_ = stream_.start(region_);
    layout_.set(gl_, start_);
}

}  // namespace drape
