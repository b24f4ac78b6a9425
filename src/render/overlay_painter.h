#pragma once

#include <imgui.h>

#include <algorithm>
#include <cstddef>

#include "drape/base/assert.h"
#include "gl.h"
#include "picture_target.h"
#include "stream_buffer.h"

namespace drape {

/// Draws Dear ImGui's draw data. Its font texture stays bound to unit 1.
class OverlayPainter {
public:
    /// @pre Dear ImGui's context is there and its fonts are added
    OverlayPainter(Gl& gl, StreamBuffer& stream)
        : gl_(gl),
          array_(gl, stream, Region::OverlayVertices,
                 {sizeof(ImDrawVert), {{0, 2}, {1, 2}, {2, 4, GL_UNSIGNED_BYTE}}}) {  // pos, uv, col
        DRAPE_ASSERT(ImGui::GetCurrentContext() != nullptr && !ImGui::GetIO().Fonts->Fonts.empty());
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        gl(glActiveTexture, GL_TEXTURE1);
        gl(glBindTexture, GL_TEXTURE_2D, atlas_.name());
        gl(glPixelStorei, GL_UNPACK_ALIGNMENT, 1);
        gl(glTexImage2D, GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, pixels);
        gl(glTexParameteri, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        gl(glTexParameteri, GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        ImGui::GetIO().Fonts->ClearTexData();

        array_.bind();
        stream.bind_indices();
    }

    /// @param shown whether there is draw data in this frame
    void fill(bool shown, StreamBuffer& stream) {
        shown_ = shown;
        const ImDrawData none, &data = shown ? *ImGui::GetDrawData() : none;
        stream.room<ImDrawVert>(Region::OverlayVertices, static_cast<std::size_t>(data.TotalVtxCount));
        auto* index = stream.room<ImDrawIdx>(Region::OverlayIndices, static_cast<std::size_t>(data.TotalIdxCount));
        auto* vertex = stream.data<ImDrawVert>(Region::OverlayVertices);
        for (int i = 0; i < data.CmdListsCount; ++i) {
            const ImDrawList& list = *data.CmdLists[i];
            vertex = std::copy_n(list.VtxBuffer.Data, list.VtxBuffer.Size, vertex);
            index = std::copy_n(list.IdxBuffer.Data, list.IdxBuffer.Size, index);
        }
    }

    /// Over the resolved picture; blending is on.
    void draw(const StreamBuffer& stream) {
        if (!shown_) return;
        const ImDrawData& data = *ImGui::GetDrawData();
        program_.use();
        array_.bind();
        gl_(glEnable, GL_SCISSOR_TEST);
        int first_vertex = 0;
        std::size_t first_index = stream.start(Region::OverlayIndices);
        for (int i = 0; i < data.CmdListsCount; ++i) {
            const ImDrawList& list = *data.CmdLists[i];
            for (const ImDrawCmd& command : list.CmdBuffer) {
                const PictureBox scissor = scissor_of(command.ClipRect, data.DisplaySize);
                if (command.ElemCount == 0 || scissor.width == 0 || scissor.height == 0) continue;
                gl_(glScissor, scissor.left, scissor.low, scissor.width, scissor.height);
                gl_.draw_short_elements(static_cast<int>(command.ElemCount),
                                        first_index + command.IdxOffset * sizeof(ImDrawIdx),
                                        first_vertex + static_cast<int>(command.VtxOffset));
            }
            first_vertex += list.VtxBuffer.Size;
            first_index += static_cast<std::size_t>(list.IdxBuffer.Size) * sizeof(ImDrawIdx);
        }
        gl_(glDisable, GL_SCISSOR_TEST);
    }

private:
    static PictureBox scissor_of(const ImVec4& clip, const ImVec2& display) {
        const float left = std::clamp(clip.x, 0.0f, display.x), right = std::clamp(clip.z, left, display.x);
        const float top = std::clamp(clip.y, 0.0f, display.y), bottom = std::clamp(clip.w, top, display.y);
        return {static_cast<int>(left), static_cast<int>(display.y - bottom), static_cast<int>(right - left),
                static_cast<int>(bottom - top)};
    }

    Gl& gl_;
    Program program_{gl_, "overlay"};
    StreamArray array_;
    Texture atlas_{gl_};
    bool shown_ = false;
};

}  // namespace drape
