#pragma once

#include <algorithm>
#include <optional>

namespace drape {

/// Decides when the window draws fast (`PictureQuality`): on a slow display, while something moves. What stands still
/// is drawn in full.
class PicturePace {
public:
    /// A tick passed, in which the picture has to change or not.
    /// @param elapsed since the last tick [s]
    void follow(bool moves, double elapsed) { still_ = moves ? 0 : still_ + elapsed; }

    /// A picture was drawn, in this time [s].
    void drew(bool fast, double seconds) {
        drawn_fast_ = fast;
        if (fast != slow_) return;  // a full picture of what stands still says nothing of a display known as slow
        const bool speaks_for_change = slow_ ? seconds < shortest : seconds > longest;
        in_a_row_ = speaks_for_change ? in_a_row_ + 1 : 0;
        row_time_ = speaks_for_change ? row_time_ + seconds : 0;
        const bool changes = slow_ ? in_a_row_ >= wanted_quick_ : in_a_row_ >= min_slow && row_time_ >= max_lost;
        if (!changes) return;
        slow_ = !slow_;
        if (!slow_) wanted_quick_ *= 2;
        in_a_row_ = 0;
        row_time_ = 0;
    }

    /// Whether the next picture is to be drawn fast.
    [[nodiscard]] bool prefer_speed() const { return slow_ && still_ < patience; }

    /// Whether the last picture was drawn fast, and what it shows stands still by now.
    [[nodiscard]] bool unfinished() const { return drawn_fast_ && !prefer_speed(); }

    static constexpr double patience = 0.3;        ///< without motion, before a picture is drawn in full [s]
    static constexpr double longest = 1.0 / 25;    ///< that a full picture may take [s]
    static constexpr double max_lost = 0.2;        ///< on full pictures that take longer, one after the other [s]
    static constexpr int min_slow = 3;             ///< of them; the first pictures of a scene take longer than others
    static constexpr double shortest = 1.0 / 120;  ///< of a fast picture, if full ones are to be tried again [s]
    static constexpr int min_quick = 50;  ///< such pictures, one after the other; twice as many each further time

private:
    bool slow_ = false, drawn_fast_ = false;
    int wanted_quick_ = min_quick;
    int in_a_row_ = 0;     ///< pictures that speak for a change
    double row_time_ = 0;  ///< that they took [s]
    double still_ = 0;     ///< without motion [s]
};

/// The wall time that a scene gets: none before its first picture is shown, and small parts in its first second, so
/// that a slow display shows slowly how it begins.
class SceneClock {
public:
    /// A picture was shown. @return whether it is the first
    bool begin() {
        if (shown_for_) return false;
        shown_for_ = 0;
        return true;
    }

    /// @param elapsed since the last tick [s]
    /// @return what the scene gets of it [s]
    double pass(double elapsed) {
        if (!shown_for_) return 0;
        const double passed = *shown_for_ < opening ? std::min(elapsed, PicturePace::longest) : elapsed;
        *shown_for_ += passed;
        return passed;
    }

    static constexpr double opening = 1;  ///< of which nothing is left out [s]

private:
    std::optional<double> shown_for_;  ///< [s]
};

}  // namespace drape
