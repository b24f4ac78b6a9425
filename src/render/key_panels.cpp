#include "panels.h"

#include <imgui.h>

#include <algorithm>

namespace drape {

namespace {

constexpr float most_keys = 0.4f;      // of a column, for the keys
constexpr float least_column = 22;     // that is readable [font size]
constexpr float unwrapped = 1e6f;      // wider than any text [pixel]
constexpr float columns_apart = 2;     // [margin]
constexpr float above_heading = 0.4f;  // that is free [row]

KeyColumns columns_of(std::span<const KeyHelp> lines, float most_width) {
    KeyColumns columns{.gap = ImGui::GetFontSize()};
    for (const KeyHelp& line : lines) {
        columns.keys = std::max(columns.keys, text_width(line.key));
        columns.texts = std::max(columns.texts, text_width(line.text));
    }
    if (columns.width() <= most_width) return columns;
    columns.keys = std::min(columns.keys, most_keys * most_width);
    columns.texts = std::min(columns.texts, most_width - columns.keys - columns.gap);
    return columns;
}

float text_height(const std::string& text, float width) {
    return ImGui::CalcTextSize(text.c_str(), nullptr, false, width + 1).y;
}

float line_height(const KeyHelp& line, const KeyColumns& columns, float row) {
    if (line.is_heading()) return above_heading * row + row;
    const float text = std::max(text_height(line.key, columns.keys), text_height(line.text, columns.texts));
    return std::max(row, text + row - ImGui::GetTextLineHeight());
}

float height_of(std::span<const KeyHelp> lines, const KeyColumns& columns, float row) {
    float height = 0;
    for (const KeyHelp& line : lines) height += line_height(line, columns, row);
    return height;
}

void wrapped_text(ImVec2 corner, float width, ImU32 colour, const std::string& text) {
    ImGui::PushTextWrapPos(corner.x + width + 1);
    text_at(corner, colour, text);
    ImGui::PopTextWrapPos();
}

void draw_lines(std::span<const KeyHelp> lines, ImVec2 corner, const KeyColumns& columns, float row) {
    for (const KeyHelp& line : lines) {
        if (line.is_heading()) {
            text_at({corner.x, corner.y + above_heading * row}, ink::quiet, line.text);
        } else {
            wrapped_text(corner, columns.keys, ink::wait, line.key);
            wrapped_text({corner.x + columns.keys + columns.gap, corner.y}, columns.texts, ink::text, line.text);
        }
        corner.y += line_height(line, columns, row);
    }
}

// A group that begins here, of which a column has all; else one line
std::span<const KeyHelp> kept_together(std::span<const KeyHelp> lines) {
    std::size_t count = 1;
    while (lines[0].is_heading() && count < lines.size() && !lines[count].is_heading()) ++count;
    return lines.first(count);
}

// Columns that are no higher than this, but for a group or a line that is higher by itself
KeyLayout filled_columns(std::span<const KeyHelp> lines, const KeyColumns& widths, float row, float height) {
    KeyLayout layout{widths, {0}, row, 0};
    float filled = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const float together = height_of(kept_together(lines.subspan(k)), widths, row);
        if (filled > 0 && filled + together > height) layout.starts.push_back(k), filled = 0;
        filled += line_height(lines[k], widths, row);
        layout.height = std::max(layout.height, filled);
    }
    return layout;
}

// As even as they can be
KeyLayout even_columns(std::span<const KeyHelp> lines, const KeyColumns& widths, float row, std::size_t count) {
    float height = height_of(lines, widths, row) / static_cast<float>(count);
    for (;; height += row) {
        KeyLayout layout = filled_columns(lines, widths, row, height + 0.5f);
        if (layout.starts.size() <= count) return layout;
    }
}

}  // namespace

ImVec2 KeyLayout::size(float margin) const {
    const auto columns = static_cast<float>(starts.size());
    return {columns * widths.width() + ((columns - 1) * columns_apart + 2) * margin, height + 2 * margin};
}

KeyLayout one_column(std::span<const KeyHelp> lines, float width, float row, float margin) {
    return even_columns(lines, columns_of(lines, width - 2 * margin), row, 1);
}

KeyLayout lay_out_help(std::span<const KeyHelp> lines, float width, float height, float margin) {
    const float widest = columns_of(lines, unwrapped).width();
    for (const std::size_t count : {2u, 1u, 3u}) {
        const auto columns = static_cast<float>(count);
        const float each = (width - 2 * margin - (columns - 1) * columns_apart * margin) / columns;
        if (each < std::min(widest, least_column * ImGui::GetFontSize())) continue;
        const KeyColumns widths = columns_of(lines, each);
        // Closer lines where they would not all fit
        for (const float row : {ImGui::GetTextLineHeightWithSpacing(), ImGui::GetTextLineHeight()}) {
            KeyLayout layout = even_columns(lines, widths, row, count);
            if (layout.height + 2 * margin <= height) return layout;
        }
    }
    KeyLayout cut = one_column(lines, width, ImGui::GetTextLineHeight(), margin);
    cut.whole = false;
    return cut;
}

void key_panel(std::span<const KeyHelp> lines, const KeyLayout& layout, const PanelBox& box, float margin) {
    draw_panel(box);
    ImGui::PushClipRect({box.left, box.top}, {box.right, box.bottom}, true);
    ImVec2 corner{box.left + margin, box.top + margin};
    for (std::size_t c = 0; c < layout.starts.size(); ++c) {
        const std::size_t first = layout.starts[c];
        const std::size_t end = c + 1 < layout.starts.size() ? layout.starts[c + 1] : lines.size();
        draw_lines(lines.subspan(first, end - first), corner, layout.widths, layout.row);
        corner.x += layout.widths.width() + columns_apart * margin;
    }
    ImGui::PopClipRect();
}

}  // namespace drape
