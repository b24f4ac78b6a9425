#include "shot_repeat.h"

#include <algorithm>
#include <utility>

#include "drape/base/numbers.h"
#include "drape/scene/setting_table.h"

namespace drape {

std::vector<Command> ShotRepeat::due(const Simulation& simulation) {
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

void ShotRepeat::follow(const Command& command) {
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

}  // namespace drape
