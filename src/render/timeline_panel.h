#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "drape/sim/frame_view.h"
#include "panel_boxes.h"

namespace drape {

/// The bar of time at the bottom, with Dear ImGui's widgets: where the run stands between the oldest step that is kept
/// and the newest, or in the recording that is replayed. A drag on it asks for another step.
class TimelinePanel {
public:
    /// Whether there is anything to show: the run stands still, or is in its past, or is a replay.
    static bool is_due(const Timeline& timeline, bool paused);

    /// What it takes at the bottom of a page [pixel].
    static float height(const OverlayPage& page);

    /// Makes the panel of a frame.
    void draw(const Timeline& timeline, const OverlayPage& page);

    /// The step that the user has asked for since the last call.
    [[nodiscard]] std::optional<std::int64_t> take_wanted() { return std::exchange(wanted_, std::nullopt); }

    PanelWindow window;  ///< without a width where it is not shown

private:
    std::optional<std::int64_t> wanted_;
};

}  // namespace drape
