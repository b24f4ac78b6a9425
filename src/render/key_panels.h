#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "drape/render/renderer.h"

struct ImVec2;

namespace drape {

/// Widths of keys and of their texts beside them; both are wrapped where they are too long [pixel].
struct KeyColumns {
    float keys = 0, gap = 0, texts = 0;
    [[nodiscard]] float width() const { return keys + gap + texts; }
};

/// The size of a panel of keys and their texts in the present font.
/// @param most_width of the panel, its margins included [pixel]
/// @param row height of a line [pixel]
ImVec2 key_panel_size(std::span<const KeyHelp> lines, float most_width, float row, float margin);

/// Makes such a panel in the present window of Dear ImGui.
void key_panel(std::span<const KeyHelp> lines, ImVec2 corner, ImVec2 size, float row, float margin);

/// How the lines of the help panel stand beside and below one another.
struct HelpLayout {
    KeyColumns widths;                ///< of each column
    std::vector<std::size_t> starts;  ///< the first line of each column
    float row = 0;                    ///< height of a line [pixel]
    float height = 0;                 ///< of the highest column [pixel]
    bool whole = true;                ///< there is room for all of it
};

/// A layout of all lines in the present font, in two columns, or as many as there is room for; else one that is not
/// whole, where they would be too high, or too narrow to read.
/// @param width, height of the room for the panel, its margins included [pixel]
HelpLayout lay_out_help(std::span<const KeyHelp> lines, float width, float height, float margin);

/// Makes the help panel at the right of its room, cut where it is higher.
/// @param right edge, and height of the room [pixel]
void help_panel(std::span<const KeyHelp> lines, const HelpLayout& layout, float right, float height, float margin);

}  // namespace drape
