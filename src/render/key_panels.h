#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "drape/render/renderer.h"
#include "panel_boxes.h"

namespace drape {

/// Widths of keys and of their texts beside them; both are wrapped where they are too long [pixel].
struct KeyColumns {
    float keys = 0, gap = 0, texts = 0;
    [[nodiscard]] float width() const { return keys + gap + texts; }
};

/// How the lines of a panel stand beside and below one another.
struct KeyLayout {
    KeyColumns widths;                ///< of each column
    std::vector<std::size_t> starts;  ///< the first line of each column
    float row = 0;                    ///< height of a line [pixel]
    float height = 0;                 ///< of the highest column [pixel]
    bool whole = true;                ///< there is room for all of it

    /// Of the panel, its margins included [pixel].
    [[nodiscard]] ImVec2 size(float margin) const;
};

/// All lines in the present font, below one another.
/// @param width that the panel may have, its margins included [pixel]
/// @param row height of a line [pixel]
KeyLayout one_column(std::span<const KeyHelp> lines, float width, float row, float margin);

/// The same in two columns, or as many as there is room for; else in one that is not whole, where they would be too
/// high, or too narrow to read.
/// @param width, height of the room for the panel, its margins included [pixel]
KeyLayout lay_out_help(std::span<const KeyHelp> lines, float width, float height, float margin);

/// Makes the panel in the present window of Dear ImGui, cut where it is higher than its box.
void key_panel(std::span<const KeyHelp> lines, const KeyLayout& layout, const PanelBox& box, float margin);

}  // namespace drape
