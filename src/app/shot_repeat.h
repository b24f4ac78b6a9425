#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "drape/base/numbers.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"

namespace drape {

/// Shows the beginning of a scene once more in slow motion, where what it is about takes a moment (`view.repeat`).
class ShotRepeat {
public:
    /// What is to be done now: after the shot the scene begins again, slowly, and after that it goes on as before. A
    /// scene that was later than its shot when it was first seen is left alone.
    /// @param simulation between two steps
    [[nodiscard]] std::vector<Command> due(const Simulation& simulation) {
        constexpr double slower = 10;
        const ViewSettings& view = simulation.settings().view;
        const double time = simulation.report().time;
        if (simulation.paused() || simulation.report().status != Status::Ok) return {};
        if (shot_ == Shot::Ahead) shot_ = time < view.repeat ? Shot::First : Shot::Over;
        if (shot_ == Shot::First && time >= view.repeat) {
            if (view.repeat == 0) return end(), std::vector<Command>{};
            end_ = view.repeat;
            speed_ = view.speed;
            resets_ = true;
            const double slow = std::max(view.speed / slower, find_setting("view.speed").range.low);
            return {command::Set{"view.speed=" + real_text(slow)}, command::Reset{}};
        }
        if (shot_ == Shot::Slow && time >= end_) end();
        if (shot_ != Shot::Over || !speed_) return {};
        return {command::Set{"view.speed=" + real_text(*std::exchange(speed_, std::nullopt))}};
    }

    /// Takes notice of a command that was carried out: a scene that begins again has its repeat ahead; who moves
    /// something sees what follows from that, and who sets the speed keeps it.
    void follow(const Command& command) {
        if (changes_scene(command)) {
            *this = {};
        } else if (begins_again(command)) {
            if (std::exchange(resets_, false)) {
                shot_ = Shot::Slow;
            } else if (shot_ == Shot::Over) {
                shot_ = Shot::Ahead;
            }
        } else if (const auto setting = setting_of(command); !setting.empty()) {
            if (setting == "view.repeat" && shot_ == Shot::Over) shot_ = Shot::Ahead;
            if (setting != "view.speed" || shot_ != Shot::Slow) return;
            speed_.reset();
            end();
        } else if (changes_motion(command)) {
            end();
        }
    }

    /// Nothing is shown again before the next scene: a replay has what was.
    void end() { shot_ = Shot::Over; }

private:
    enum class Shot { Ahead, First, Slow, Over };
    Shot shot_ = Shot::Ahead;
    double end_ = 0;               ///< of the slow shot [s]
    bool resets_ = false;          ///< the next reset is that of the repeat
    std::optional<double> speed_;  ///< to go back to
};

}  // namespace drape
