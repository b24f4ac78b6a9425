#pragma once

#include <optional>
#include <span>
#include <string>

#include "drape/model/ball.h"
#include "drape/scene/settings.h"
#include "drape/sim/cloth.h"
#include "drape/sim/command.h"

namespace drape {

/// How fast the hand pulls [m/s], and the time in which a particle closes a small gap, or a ball takes on most of the
/// hand's velocity [s].
inline constexpr Real hand_speed = 3, hand_lag = Real(0.03);

/// @throws InputError that starts with the command's name, if there is no such cloth or particle
void check_particle(const std::string& command, int cloth, int particle, std::span<const Cloth> cloths);

/// Whether the hand moves such a ball: not one on a path, or one that is still.
inline bool moves_by_hand(const BallSettings& ball) {
    return ball.motion == BallMotion::Keys || ball.motion == BallMotion::Free;
}

/// Takes a ball, or one particle of a cloth, and moves it to a target.
///
/// Its velocity closes the gap to the target within a fixed time, and is at most that of a hand. A ball takes it on
/// within `hand_lag` (see `move_ball`), and is in contact what it is without the hand: free, or a motor. A particle has
/// it at once, and is pinned for the integrator: every method and every step is stable with it. On a particle the force
/// has a bound. Where the springs would pull by more at the end of the step, with the neighbours moving on as they do,
/// it has the velocity at which they pull by just the bound: the hand lags, or gives way. So cloth that is pinned
/// elsewhere is drawn taut, and no farther. A particle that was pinned is moved in the same way. Contacts are stronger
/// than the hand: they push its particle as they push a free one.
class Hand {
public:
    /// @throws InputError if there is no such cloth or particle; the hand is as before then
    void grab(const command::Grab& command, std::span<Cloth> cloths);

    /// @throws InputError if there is no such ball; the hand is as before then
    void hold(const command::Hold& command, std::span<const Ball> balls, std::span<Cloth> cloths);

    /// @param target where the hand goes [m]
    void drag(const Vec3& target) { target_ = target; }

    /// Lets go; a particle that was pinned stays where it is.
    void release(std::span<Cloth> cloths);

    [[nodiscard]] bool holds() const { return grab_ || ball_ >= 0; }

    /// The ball that it holds; -1: none.
    [[nodiscard]] int ball() const { return ball_; }

    /// The velocity that takes a ball towards the target, of one that it holds [m/s].
    [[nodiscard]] std::optional<Vec3> velocity_of(std::size_t ball, const Vec3& centre, Real h) const;

    /// What it goes on from.
    /// @param cloths as the settings make them
    void exchange(SnapshotText& text, std::span<Cloth> cloths, std::size_t balls);

    /// Holds its particle in a model that was made again.
    void hold_in(std::size_t cloth, ClothModel& model);

    /// Gives the particle the velocity that takes it towards the target, and counts the work of that.
    void lead(std::span<Cloth> cloths, Real h);

    /// Counts the work that the hand has done in the step since `lead`.
    void count_work(std::span<Cloth> cloths, Real h) const;

private:
    struct Grab {
        std::size_t cloth;
        int particle;
        bool was_pinned;
        double power = 0;  ///< at the start of the step [W]
    };

    /// @return the velocity that closes the gap to the target within a time [s], no faster than a hand
    [[nodiscard]] Vec3 towards_target(const Vec3& here, Real lag) const;

    std::optional<Grab> grab_;
    int ball_ = -1;
    Vec3 target_ = Vec3::Zero();
};

}  // namespace drape
