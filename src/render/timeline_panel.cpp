#include "panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace drape {

namespace {

// What the bar says of where the run stands
std::string line_of(const Timeline& timeline) {
    const double megabytes = timeline.bytes / 1e6;
    if (timeline.replay) {
        // What lies ahead may change the time step: nobody knows yet how long it takes
        return format("Replay: %.2f s, step %lld of %lld", timeline.passed, static_cast<long long>(timeline.now),
                      static_cast<long long>(timeline.newest));
    }
    if (timeline.is_live()) {
        return format("Now; the comma key steps back, %.2f s are kept (%.0f MB)", timeline.kept, megabytes);
    }
    return format("%.3f s back of %.2f s (%.0f MB); Space plays from here", timeline.back, timeline.kept, megabytes);
}

}  // namespace

bool is_timeline_due(const FrameView& view) {
    const Timeline& timeline = view.timeline;
    return timeline.newest > timeline.oldest && (view.paused || timeline.replay || !timeline.is_live());
}

PanelBox timeline_place(const OverlayPage& page) {
    const float size = ImGui::GetFontSize(), width = std::min(page.width - 2 * page.margin, 56 * size);
    const float left = (page.width - width) / 2, bottom = page.height - page.margin;
    return {left, bottom - 2.9f * size, left + width, bottom};
}

std::optional<std::int64_t> timeline_panel(const Timeline& timeline, const PanelBox& box) {
    const float size = ImGui::GetFontSize(), pad = 0.5f * size;
    std::optional<std::int64_t> wanted;
    if (begin_window(box, "timeline", ImGuiWindowFlags_NoDecoration, 0)) {
        text_at({box.left + pad, box.top + 0.3f * size}, timeline.is_live() ? ink::text : ink::wait, line_of(timeline));

        const float from = box.left + pad, to = box.right - pad;
        const float middle = box.top + 2.2f * size;
        const auto span = static_cast<double>(timeline.newest - timeline.oldest);
        ImGui::SetCursorScreenPos({from, box.top + 1.6f * size});
        ImGui::InvisibleButton("bar", {to - from, 1.2f * size});
        if (ImGui::IsItemActive()) {
            const double part = std::clamp((ImGui::GetIO().MousePos.x - from) / (to - from), 0.0f, 1.0f);
            const auto step = timeline.oldest + static_cast<std::int64_t>(std::lround(part * span));
            if (step != timeline.now) wanted = step;
        }
        // Back from the newest step, at most 20; the bar is one of steps
        const double apart = std::pow(10, std::ceil(std::log10(std::max(timeline.kept, 1e-9) / 20)));
        if (timeline.even) text_before({to, box.top + 0.3f * size}, ink::quiet, format("ticks: %g s", apart));
        ImDrawList& list = *ImGui::GetWindowDrawList();
        for (double back = 0; timeline.even && back <= timeline.kept; back += apart) {
            const float tick = to - static_cast<float>(back / std::max(timeline.kept, 1e-9)) * (to - from);
            list.AddLine({tick, middle}, {tick, middle + 0.5f * size}, ink::quiet);
        }
        const auto passed = static_cast<float>(static_cast<double>(timeline.now - timeline.oldest) / span);
        const float now = from + passed * (to - from);
        list.AddRectFilled({from, middle - 0.15f * size}, {to, middle + 0.15f * size}, ink::lit, 2);
        list.AddRectFilled({from, middle - 0.15f * size}, {now, middle + 0.15f * size}, ink::bar, 2);
        list.AddCircleFilled({now, middle}, 0.45f * size, ink::text);
    }
    end_window();
    return wanted;
}

}  // namespace drape
