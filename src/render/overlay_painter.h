#pragma once

#include "gl_objects.h"
#include "program.h"
#include "stream_buffer.h"

namespace drape {

/// Draws Dear ImGui's draw data. Its font texture stays bound to unit 1.
class OverlayPainter {
public:
    /// @pre Dear ImGui's context is there and its fonts are added
    OverlayPainter(Gl& gl, StreamBuffer& stream);

    /// @param shown whether there is draw data in this frame
    void fill(bool shown, StreamBuffer& stream);

    /// Over the resolved picture; blending is on.
    void draw(const StreamBuffer& stream);

private:
    Gl& gl_;
    Program program_;
    StreamArray array_;
    Texture atlas_;
    bool shown_ = false;
};

}  // namespace drape
