#include "shot_repeat.h"

#include <utility>

#include "drape/base/numbers.h"

namespace drape {

std::vector<Command> ShotRepeat::due(const Simulation& simulation) {
    constexpr double slower = 10;
    const ViewSettings& view = simulation.settings().view;
    const bool over = shot_ == Shot::Over || (view.repeat > 0 && simulation.report().time >= view.repeat);
    if (!over || simulation.paused()) return {};
    if (view.repeat > 0 && shot_ == Shot::First) {
        speed_ = view.speed;
        resets_ = true;
        return {command::Set{"view.speed=" + real_text(view.speed / slower)}, command::Reset{}};
    }
    shot_ = Shot::Over;
    if (!speed_) return {};
    return {command::Set{"view.speed=" + real_text(*std::exchange(speed_, std::nullopt))}};
}

void ShotRepeat::follow(const Command& command) {
    if (changes_scene(command)) {
        *this = {};
    } else if (begins_again(command)) {
        if (std::exchange(resets_, false)) {
            shot_ = Shot::Slow;
        } else if (shot_ == Shot::Over) {
            shot_ = Shot::First;
        }
    } else if (changes_motion(command)) {
        shot_ = Shot::Over;
    }
}

}  // namespace drape
