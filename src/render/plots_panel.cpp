#include "plots_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <span>

#include "overlay_style.h"

namespace drape {

namespace {

constexpr double history = 10;  // s of wall time

/// One curve of a plot.
struct Curve {
    const char* label;
    ImU32 colour;
    double (*read)(const StepReport&);
};

/// Curves with one axis in common.
struct Plot {
    const char* title;  // with its unit
    std::size_t first, end;
    double scale;    // least height of the axis
    bool has_limit;  // 1 is marked
};

// @cite okabe2008
constexpr ImU32 orange = IM_COL32(230, 159, 0, 255), sky = IM_COL32(86, 180, 233, 255),
                green = IM_COL32(0, 190, 140, 255), yellow = IM_COL32(240, 228, 66, 255);

constexpr double micro = 1e6;

constexpr std::array<Curve, 11> all_curves{{
    {"integrate", orange, [](const StepReport& r) { return micro * r.times.step; }},
    {"BVH", sky, [](const StepReport& r) { return micro * (r.times.build + r.times.traverse); }},
    {"narrow", green, [](const StepReport& r) { return micro * (r.times.narrow + r.times.pairs); }},
    {"response", yellow, [](const StepReport& r) { return micro * r.times.respond; }},
    {"total", orange, [](const StepReport& r) { return r.energy.total(); }},
    {"kinetic", sky, [](const StepReport& r) { return r.energy.kinetic; }},
    {"candidates", orange, [](const StepReport& r) { return static_cast<double>(r.traversal.candidates); }},
    {"contacts", sky, [](const StepReport& r) { return static_cast<double>(r.contacts); }},
    {"all", orange, [](const StepReport& r) { return static_cast<double>(r.traversal.nodes); }},
    {"tested", sky, [](const StepReport& r) { return static_cast<double>(r.traversal.volume_tests); }},
    {"dt / limit", orange, [](const StepReport& r) { return std::min(r.step_limit_ratio, 10.0); }},
}};

constexpr std::array<Plot, 5> plots{{
    {"Time a step [us]", 0, 4, 1, false},
    {"Energy [J]", 4, 6, 1e-6, false},
    {"Contacts", 6, 8, 1, false},
    {"Nodes", 8, 10, 1, false},
    {"Time step", 10, 11, 1.05, true},
}};

std::array<char, 24> short_number(double value) {
    std::array<char, 24> text{};
    std::snprintf(text.data(), text.size(), std::abs(value) < 1000 ? "%.3g" : "%.0f", value);
    return text;
}

}  // namespace

void PlotsPanel::keep(const FrameView& view) {
    const StepReport& report = *view.report;
    span_ = history * view.settings->view.speed;
    if (count_ > 0) {
        const double last = moment(count_ - 1).time;
        if (report.time < last) first_ = count_ = 0;
        if (count_ > 0 && report.time < last + span_ / most) return;
    }
    if (count_ == most) {
        first_ = (first_ + 1) % most;
        --count_;
    }
    Moment& now = moments_[(first_ + count_++) % most];
    now.time = report.time;
    for (std::size_t c = 0; c < all_curves.size(); ++c) {
        const double value = all_curves[c].read(report);
        now.values[c] = std::isnan(value) ? 0 : static_cast<float>(std::clamp(value, -1e30, 1e30));
    }
}

float PlotsPanel::draw(const OverlayPage& page) const {
    const float size = ImGui::GetFontSize(), margin = page.margin, height = rows * size;
    const float width = (page.width - margin * static_cast<float>(plots.size() + 1)) / static_cast<float>(plots.size());
    if (width < 6 * size || count_ == 0) return 0;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const double end = moment(count_ - 1).time;
    std::array<ImVec2, most> points;
    std::size_t oldest = 0;
    while (end - moment(oldest).time > span_) ++oldest;
    for (std::size_t p = 0; p < plots.size(); ++p) {
        const Plot& plot = plots[p];
        const ImVec2 corner{margin + static_cast<float>(p) * (width + margin), page.height - height - margin};
        draw_panel(corner, {width, height});

        // What the axis has room for
        double low = 0, high = plot.scale;
        for (std::size_t k = oldest; k < count_; ++k) {
            for (std::size_t c = plot.first; c < plot.end; ++c) {
                low = std::min(low, static_cast<double>(moment(k).values[c]));
                high = std::max(high, static_cast<double>(moment(k).values[c]));
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
            for (std::size_t k = oldest; k < count_; ++k) {
                const auto back = static_cast<float>((end - moment(k).time) / span_);
                points[k - oldest] = {right - back * (right - left), level(moment(k).values[c])};
            }
            list.AddPolyline(points.data(), static_cast<int>(count_ - oldest), all_curves[c].colour, ImDrawFlags_None,
                             1.5f);
        }

        // Title, axis and legend
        text_at({left, corner.y + 0.2f * size}, ink::text, plot.title);
        const std::array<char, 24> most_text = short_number(high), span_text = short_number(-span_);
        const float number_width = ImGui::CalcTextSize(most_text.data()).x;
        text_at({right - number_width, corner.y + 0.2f * size}, ink::quiet, most_text.data());
        float along = left;
        for (std::size_t c = plot.first; c < plot.end; ++c) {
            const float label_width = ImGui::CalcTextSize(all_curves[c].label).x;
            if (along + label_width > right) break;
            text_at({along, corner.y + 1.4f * size}, all_curves[c].colour, all_curves[c].label);
            along += label_width + 0.6f * size;
        }
        const float now_width = ImGui::CalcTextSize("now").x;
        text_at({left, bottom + 0.1f * size}, ink::quiet, (std::string(span_text.data()) + " s").c_str());
        text_at({right - now_width, bottom + 0.1f * size}, ink::quiet, "now");
    }
    return height + margin;
}

}  // namespace drape
