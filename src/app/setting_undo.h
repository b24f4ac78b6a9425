#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "drape/scene/setting_table.h"

namespace drape {

/// Changes of settings by the user, to take them back, the last first, and to make them again. One that is as it would
/// become, as after a way back in time, is passed over.
class SettingUndo {
public:
    using Assignments = std::vector<std::string>;

    /// What takes a change back, or makes it again; empty: none is left.
    struct Move {
        Assignments assignments;
        std::int64_t step;  ///< before which the change was made last
    };

    /// A setting was changed.
    /// @param step of the session before which that was
    /// @param name with the number of the ball if it is one of several
    /// @param press of the button that led to it, by its number: what one press does to one setting is one change; 0:
    /// no button did
    void changed(std::int64_t step, const std::string& name, Assignments before, Assignments after, int press) {
        if (before == after) return;
        changes_.resize(done_);
        const bool goes_on =
            press != 0 && !changes_.empty() && changes_.back().press == press && changes_.back().name == name;
        if (!goes_on) changes_.push_back({step, name, press, std::move(before), {}});
        changes_.back().after = std::move(after);
        done_ = changes_.size();
    }

    /// Whether there is one to take back.
    [[nodiscard]] bool any() const { return done_ > 0; }

    /// That of the last change that is not taken back, or of the last again that is.
    /// @param step of the session before which that is done
    Move next(bool again, const Settings& now, std::int64_t step) {
        while (again ? done_ < changes_.size() : done_ > 0) {
            Change& change = changes_[again ? done_++ : --done_];
            if (again) change.step = step;
            const Assignments& wanted = again ? change.after : change.before;
            if (assignments_of(now, change.name) != wanted) return {wanted, change.step};
        }
        return {};
    }

private:
    struct Change {
        std::int64_t step;
        std::string name;
        int press;
        Assignments before, after;
    };
    std::vector<Change> changes_;
    std::size_t done_ = 0;  ///< of these; the others are taken back
};

}  // namespace drape
