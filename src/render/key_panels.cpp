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

// Widths of keys and of their texts beside them; both are wrapped where they are too long [pixel]
struct KeyColumns {
    float keys = 0, gap = 0, texts = 0;
    [[nodiscard]] float width() const { return keys + gap + texts; }
};

// How the lines of a panel stand beside and below one another
struct KeyLayout {
    KeyColumns widths;                // of each column
    std::vector<std::size_t> starts;  // the first line of each column
    float row;                        // height of a line [pixel]
    float height = 0;                 // of the highest column [pixel]

    // Of the panel, its margins included [pixel]
    [[nodiscard]] ImVec2 size(float margin) const {
        const auto columns = static_cast<float>(starts.size());
        return {columns * widths.width() + ((columns - 1) * columns_apart + 2) * margin, height + 2 * margin};
    }
};

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

float line_height(const KeyHelp& line, const KeyColumns& columns, float row) {
    if (line.is_heading()) return above_heading * row + row;
    const float key = wrapped_size(line.key, columns.keys + 1).y, text = wrapped_size(line.text, columns.texts + 1).y;
    return std::max(row, std::max(key, text) + row - ImGui::GetTextLineHeight());
}

float height_of(std::span<const KeyHelp> lines, const KeyColumns& columns, float row) {
    float height = 0;
    for (const KeyHelp& line : lines) height += line_height(line, columns, row);
    return height;
}

void draw_lines(std::span<const KeyHelp> lines, ImVec2 corner, const KeyColumns& columns, float row) {
    for (const KeyHelp& line : lines) {
        if (line.is_heading()) {
            text_at({corner.x, corner.y + above_heading * row}, ink::quiet, line.text);
        } else {
            wrapped_text(corner, columns.keys + 1, ink::wait, line.key);
            wrapped_text({corner.x + columns.keys + columns.gap, corner.y}, columns.texts + 1, ink::text, line.text);
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
    KeyLayout layout{widths, {0}, row};
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

// Of the panel the width, and of a line the height, margins included
KeyLayout one_column(std::span<const KeyHelp> lines, float width, float row, float margin) {
    return even_columns(lines, columns_of(lines, width - 2 * margin), row, 1);
}

// In two columns, or as many as there is room for; nothing where they would be too high, or too narrow to read
std::optional<KeyLayout> lay_out_help(std::span<const KeyHelp> lines, float width, float height, float margin) {
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
    return std::nullopt;
}

// Cut where it is higher than its box
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

}  // namespace

bool help_panel(std::span<const KeyHelp> lines, std::span<const PanelFont> fonts, const OverlayPage& page,
                bool beside) {
    const float margin = page.margin, right = page.width - margin, width = right - margin;
    const float width_beside = width - figures_columns * fonts.back().size - 3 * margin;
    for (std::size_t font = fonts.size() - 1;; --font) {
        fonts[font].push();
        const auto within = [&](float w) { return lay_out_help(lines, w, page.height - 2 * margin, margin); };
        std::optional<KeyLayout> layout = beside ? within(width_beside) : std::nullopt;
        const bool fits_beside = layout.has_value();
        if (!layout) layout = within(width);
        // Nothing is left that would help: cut
        if (!layout && font == 0) layout = one_column(lines, width, ImGui::GetTextLineHeight(), margin);
        if (layout) {
            const ImVec2 size = layout->size(margin);
            const float bottom = std::min(margin + size.y, page.height - margin);
            key_panel(lines, *layout, {right - size.x, margin, right, bottom}, margin);
        }
        ImGui::PopFont();
        if (layout) return fits_beside;
    }
}

void hint_panel(std::span<const KeyHelp> lines, std::span<const PanelFont> fonts, const OverlayPage& page,
                const std::vector<PanelBox>& others) {
    for (std::size_t font = fonts.size(); font-- > 0;) {
        fonts[font].push();
        const float row = ImGui::GetTextLineHeightWithSpacing();
        const auto within = [&](float width) { return one_column(lines, width, row, page.margin); };
        const auto size_within = [&](float width) { return within(width).size(page.margin); };
        const float least = std::min(size_within(unwrapped).x, hint_columns * ImGui::GetFontSize());
        const std::optional<PanelBox> box = free_place(page, others, size_within, least, false);
        if (box) key_panel(lines, within(box->right - box->left + 0.5f), *box, page.margin);
        ImGui::PopFont();
        if (box) return;
    }
}

}  // namespace drape
