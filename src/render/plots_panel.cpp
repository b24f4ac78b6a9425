#include "panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace drape {

namespace {

// @cite okabe2008
constexpr ImU32 orange = IM_COL32(230, 159, 0, 255), sky = IM_COL32(86, 180, 233, 255),
                green = IM_COL32(0, 190, 140, 255), yellow = IM_COL32(240, 228, 66, 255);

constexpr std::array<ImU32, plot_curves.size()> curve_colours{orange, sky, green,  yellow, orange, sky,
                                                              orange, sky, orange, sky,    orange};

std::string short_number(double value) { return format(std::abs(value) < 1000 ? "%.3g" : "%.0f", value); }

}  // namespace

float plots_panel(const PlotHistory& history, const OverlayPage& page) {
    const float size = ImGui::GetFontSize(), margin = page.margin, height = plots_rows * size;
    const float width = (page.width - margin * static_cast<float>(plots.size() + 1)) / static_cast<float>(plots.size());
    const std::size_t count = history.size();
    if (width < 6 * size || count == 0) return 0;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const double end = history.time(count - 1), span = history.span();
    std::array<ImVec2, PlotHistory::most> points;
    const std::size_t oldest = history.oldest_shown();
    for (std::size_t p = 0; p < plots.size(); ++p) {
        const Plot& plot = plots[p];
        const ImVec2 corner{margin + static_cast<float>(p) * (width + margin), page.height - height - margin};
        draw_panel({corner.x, corner.y, corner.x + width, corner.y + height});

        // What the axis has room for
        double low = 0, high = plot.scale;
        for (std::size_t k = oldest; k < count; ++k) {
            for (std::size_t c = plot.first; c < plot.end; ++c) {
                low = std::min(low, static_cast<double>(history.value(k, c)));
                high = std::max(high, static_cast<double>(history.value(k, c)));
            }
        }
        const float left = corner.x + 0.6f * size, right = corner.x + width - 0.6f * size;
        const float top = corner.y + 2.7f * size, bottom = corner.y + height - 1.6f * size;
        const auto level = [&](double value) {
            return bottom - static_cast<float>((value - low) / (high - low)) * (bottom - top);
        };
        list.AddLine({left, level(0)}, {right, level(0)}, ink::groove);
        list.AddLine({left, top}, {right, top}, ink::groove);
        if (plot.has_limit) list.AddLine({left, level(1)}, {right, level(1)}, ink::bad);

        for (std::size_t c = plot.first; c < plot.end; ++c) {
            for (std::size_t k = oldest; k < count; ++k) {
                const auto back = static_cast<float>((end - history.time(k)) / span);
                points[k - oldest] = {right - back * (right - left), level(history.value(k, c))};
            }
            list.AddPolyline(points.data(), static_cast<int>(count - oldest), curve_colours[c], ImDrawFlags_None,
                             curve_width());
        }

        // Title, present value of the first curve, axis and legend
        text_at({left, corner.y + 0.2f * size}, ink::text, plot.title);
        text_before({right, corner.y + 0.2f * size}, curve_colours[plot.first],
                    short_number(static_cast<double>(history.value(count - 1, plot.first))));
        text_at({left, top + 0.25f * size}, ink::quiet, short_number(high));
        float along = left;
        for (std::size_t c = plot.first; c < plot.end; ++c) {
            const float label_width = text_width(plot_curves[c].label);
            if (along + label_width > right) break;
            text_at({along, corner.y + 1.4f * size}, curve_colours[c], plot_curves[c].label);
            along += label_width + 0.6f * size;
        }
        text_at({left, bottom + 0.1f * size}, ink::quiet, short_number(-span) + " s");
        text_before({right, bottom + 0.1f * size}, ink::quiet, "now");
    }
    return height + margin;
}

}  // namespace drape
