#include "panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace drape {

namespace {

// Of the curves of a plot: orange, sky, green, yellow. @cite okabe2008
constexpr std::array<ImU32, 4> curve_colours{IM_COL32(230, 159, 0, 255), IM_COL32(86, 180, 233, 255),
                                             IM_COL32(0, 190, 140, 255), IM_COL32(240, 228, 66, 255)};

static_assert(std::ranges::all_of(plots,
                                  [](const Plot& plot) { return plot.end - plot.first <= curve_colours.size(); }));

std::string short_number(double value) { return format(std::abs(value) < 1000 ? "%.3g" : "%.0f", value); }

// What the bar says of where the run stands
std::string line_of(const Timeline& timeline, bool paused) {
    const double megabytes = timeline.bytes / 1e6;
    if (timeline.replay) {
        // What lies ahead may change the time step: nobody knows yet how long it takes
        return format("Replay: %.2f s, step %lld of %lld", timeline.passed,
                      static_cast<long long>(timeline.now - timeline.replay_from),
                      static_cast<long long>(timeline.newest - timeline.replay_from));
    }
    if (timeline.is_too_large()) return "This scene is too large to go back in";
    if (timeline.is_live()) {
        return format("Now; the comma key steps back, %.2f s are kept (%.0f MB)", timeline.kept, megabytes);
    }
    return format("%.4f s back of %.2f s (%.0f MB); %s", timeline.back, timeline.kept, megabytes,
                  paused ? "Space plays from here" : "played again");
}

}  // namespace

float plots_panel(const PlotHistory& history, const OverlayPage& page) {
    const float size = ImGui::GetFontSize(), margin = page.margin, height = plots_rows * size;
    const float width = (page.width - margin * static_cast<float>(plots.size() + 1)) / static_cast<float>(plots.size());
    const std::vector<PlotHistory::Moment> moments = history.shown();
    if (width < 6 * size || moments.empty()) return 0;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PlotHistory::Moment& now = moments.back();
    const double span = history.span();
    std::vector<ImVec2> points;
    for (std::size_t p = 0; p < plots.size(); ++p) {
        const Plot& plot = plots[p];
        const ImVec2 corner{margin + static_cast<float>(p) * (width + margin), page.height - height - margin};
        draw_panel({corner.x, corner.y, corner.x + width, corner.y + height});

        // What the axis has room for
        double low = 0, high = plot.scale;
        for (const PlotHistory::Moment& moment : moments) {
            for (std::size_t c = plot.first; c < plot.end; ++c) {
                low = std::min(low, static_cast<double>(moment.values[c]));
                high = std::max(high, static_cast<double>(moment.values[c]));
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
            points.clear();
            for (const PlotHistory::Moment& moment : moments) {
                const auto back = static_cast<float>((now.time - moment.time) / span);
                points.emplace_back(right - back * (right - left), level(moment.values[c]));
            }
            draw_curve(points, curve_colours[c - plot.first]);
        }

        // Title, present value of the first curve, axis and legend
        text_at({left, corner.y + 0.2f * size}, ink::text, plot.title);
        text_before({right, corner.y + 0.2f * size}, curve_colours[0],
                    short_number(static_cast<double>(now.values[plot.first])));
        float along = left;
        for (std::size_t c = plot.first; c < plot.end; ++c) {
            const float label_width = text_width(plot_curves[c].label);
            if (along + label_width > right) break;
            text_at({along, corner.y + 1.4f * size}, curve_colours[c - plot.first], plot_curves[c].label);
            along += label_width + 0.6f * size;
        }
        if (plot.has_limit && along + text_width("limit") <= right)
            text_at({along, corner.y + 1.4f * size}, ink::bad, "limit");
        text_at({left, bottom + 0.1f * size}, ink::quiet, short_number(-span) + " s");
        text_before({right, bottom + 0.1f * size}, ink::quiet, "now");
        const std::string axis = short_number(low) + " to " + short_number(high);
        text_at({(left + right - text_width(axis)) / 2, bottom + 0.1f * size}, ink::quiet, axis);
    }
    return height + margin;
}

PanelBox timeline_panel(const FrameView& view, const OverlayPage& page, std::optional<double>& wanted) {
    const Timeline& timeline = view.timeline;
    const bool is_due = timeline.has_bar && (view.paused || timeline.replay || !timeline.is_live());
    const bool too_large = timeline.is_too_large();
    if ((timeline.newest <= timeline.oldest && !too_large) || !is_due) return {};
    const float size = ImGui::GetFontSize(), pad = 0.5f * size;
    const float width = std::min(page.width - 2 * page.margin, 56 * size);
    const float left = (page.width - width) / 2, bottom = page.height - page.margin;
    const PanelBox box{left, bottom - (too_large ? 1.8f : 2.9f) * size, left + width, bottom};
    const bool shown = begin_window(box, "timeline", ImGuiWindowFlags_NoDecoration, 0);
    text_at({box.left + pad, box.top + 0.3f * size}, timeline.is_live() ? ink::text : ink::wait,
            line_of(timeline, view.paused));
    if (shown && !too_large) {
        const float from = box.left + pad, to = box.right - pad;
        const float middle = box.top + 2.2f * size;
        const double kept = std::max(timeline.kept, 1e-9);
        const auto place = [&](double back) { return to - static_cast<float>(back / kept) * (to - from); };
        // As wide as its knob at the ends is
        ImGui::SetCursorScreenPos({from - pad, box.top + 1.6f * size});
        ImGui::InvisibleButton("bar", {to - from + 2 * pad, 1.2f * size});
        if (ImGui::IsItemActive()) {
            const double back = kept * std::clamp((to - ImGui::GetIO().MousePos.x) / (to - from), 0.0f, 1.0f);
            if (back != timeline.back) wanted = back;
        }
        // Back from the newest step, at most 20
        const double apart = std::pow(10, std::ceil(std::log10(kept / 20)));
        text_before({to, box.top + 0.3f * size}, ink::quiet, format("ticks: %g s", apart));
        ImDrawList& list = *ImGui::GetWindowDrawList();
        for (double back = 0; back <= kept; back += apart) {
            list.AddLine({place(back), middle}, {place(back), middle + 0.5f * size}, ink::quiet);
        }
        const float now = place(timeline.back);
        list.AddRectFilled({from, middle - 0.15f * size}, {to, middle + 0.15f * size}, ink::lit, 2);
        list.AddRectFilled({from, middle - 0.15f * size}, {now, middle + 0.15f * size}, ink::bar, 2);
        list.AddCircleFilled({now, middle}, 0.45f * size, ink::text);
    }
    end_window();
    return box;
}

}  // namespace drape
