#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "drape/bounds/broad_phase.h"
#include "drape/contact/body.h"
#include "drape/contact/contact_row.h"
#include "drape/model/ball.h"
#include "drape/model/cloth_model.h"
#include "drape/scene/settings.h"
#include "drape/sim/step_report.h"

namespace drape {

/// A cloth as it is drawn.
struct ClothView {
    const ClothModel& model;                ///< grid, springs and pins
    const Points& x;                        ///< n x 3 [m]
    const Points& previous;                 ///< one step before
    std::span<const ContactRow> contacts;   ///< with bodies
    const BroadPhase* hierarchy = nullptr;  ///< as last searched; never null
    const Points* v = nullptr;              ///< n x 3 [m/s]; null: at rest
    int grabbed = -1;                       ///< the particle that the hand holds; -1: none
    std::span<const int> pair_cells = {};   ///< that touch cloth, as `FrameView::pair_search`
};

/// Where a session stands between the steps that it can go back to and those it knows already.
struct Timeline {
    std::int64_t start = 0;   ///< where the run has begun, as far as it is kept: it can go back to there, too
    std::int64_t oldest = 0;  ///< that it can go back to
    std::int64_t now = 0;
    std::int64_t newest = 0;       ///< of the run so far, or of the recording that is replayed
    double passed = 0;             ///< since the session or its replay began, resets included, sleep left out [s]
    double back = 0;               ///< from the present step to the newest; in a replay, as if no time step changed [s]
    double kept = 0;               ///< from the oldest to the newest; likewise [s]
    double bytes = 0;              ///< of memory that the past takes, about
    bool replay = false;           ///< what lies ahead comes from a recording
    std::int64_t replay_from = 0;  ///< step at which it began
    bool is_computed = true;       ///< the present step; else what is shown is one on the way there
    bool has_bar = true;           ///< the bar of time is drawn, where there is a past

    [[nodiscard]] bool is_live() const { return now == newest; }

    /// Nothing is kept, for not even two moments would fit into the memory that the past may take.
    [[nodiscard]] bool is_too_large() const { return bytes == 0 && newest > 0 && newest == oldest; }
};

struct ComparisonView;
struct UnstableMode;

/// What a search costs with the hierarchy and without it: of all cloths for all balls, and for cloth that is near cloth
/// where that is searched for.
struct SearchTimes {
    double hierarchy = 0;    ///< build, traversal and test of the candidates [s]
    double brute_force = 0;  ///< test of every cell, and of every pair of cells [s]
    double tests = 0, tests_of_brute_force = 0;
    [[nodiscard]] double tests_saved() const { return 1 - tests / tests_of_brute_force; }
    [[nodiscard]] double speed_up() const { return brute_force / hierarchy; }
    [[nodiscard]] bool saves_time() const { return speed_up() > 1; }
};

/// What the renderer needs of a moment; all of it belongs to the simulation and its session, and lasts until their next
/// change.
struct FrameView {
    std::span<const ClothView> cloths;
    std::span<const Ball> balls;
    std::span<const Ball> previous_balls;  ///< one step before
    std::span<const Solid> solids;
    std::span<const Solid> previous_solids;  ///< one step before
    Real blend = 1;                          ///< the picture shows previous + blend (now - previous)
    const Settings* settings = nullptr;
    const StepReport* report = nullptr;
    double longest_step = 0;  ///< `Simulation::longest_step` [s]
    std::string_view scene;   ///< name or path
    bool paused = false;
    bool held = false;                           ///< the hand holds a particle or a ball
    int steered_ball = -1;                       ///< in the hand, or of several the one that the keys lead; -1: none
    Timeline timeline = {};                      ///< of the session; where there is none to be shown, nothing
    const ComparisonView* comparison = nullptr;  ///< with another simulation; null: none
    TraversalStats pair_search = {};             ///< of cloth against cloth, shown where there is no ball
    const UnstableMode* mode = nullptr;          ///< in which a run that has diverged swings; null: none
    const SearchTimes* search = nullptr;         ///< a measurement of about now; null: none was made
    bool prefer_speed = false;                   ///< to be drawn fast, where `view.quality` leaves it open
};

/// Whether nothing in a view moves until something is done to it: a window draws it now and then.
inline bool is_at_rest(const FrameView& view) {
    return view.paused || (view.report->asleep && view.comparison == nullptr);
}

/// Whether a view is drawn fast.
inline bool is_fast(const FrameView& view) {
    const PictureQuality quality = view.settings->view.quality;
    return quality == PictureQuality::Fast || (quality == PictureQuality::Auto && view.prefer_speed);
}

}  // namespace drape
