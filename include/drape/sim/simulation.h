#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drape/base/copied.h"
#include "drape/scene/settings.h"
#include "drape/scene/start_state.h"
#include "drape/sim/cloth.h"
#include "drape/sim/command.h"
#include "drape/sim/contact_stage.h"
#include "drape/sim/frame_view.h"
#include "drape/sim/hand.h"
#include "drape/sim/moving_pins.h"
#include "drape/sim/sleep_watch.h"
#include "drape/sim/step_report.h"

namespace drape {

/// The cloths, the balls and the laws between them. Same settings and commands give the same bits.
class Simulation {
public:
    /// @param scene name or path, for `Reset` to find again and for display
    /// @param start of the cloths of these settings; where there is none, the one that the settings name
    /// @throws InputError if the settings do not fit together
    Simulation(std::string scene, Settings settings, std::optional<StartState> start = {});

    /// Carries out what concerns the simulation; camera, picture and quit pass by.
    /// @throws InputError if the command names something that does not exist; nothing is changed then
    void apply(const Command& command);

    /// Goes to another moment of its scene, to the bit, but as it is paused and seen now.
    void go_to(const Simulation& moment);

    /// Ends what the user is doing: the hand lets go, the keys leave the ball where it is.
    /// @return the commands that do it; none, if nothing is being done
    [[nodiscard]] std::vector<Command> commands_to_let_go() const;

    /// One step of one or more substeps. Does nothing once diverged, and nothing but count while asleep: once no
    /// particle has gone anywhere for a while, nothing moves until a command or a ball does.
    void step();

    /// What there is to draw, with the figures of the report that are not worth their cost in every step. The motion
    /// does not depend on it.
    /// @param blend in [0, 1], between the last two states
    [[nodiscard]] FrameView view(Real blend = 1);

    [[nodiscard]] const StepReport& report() const { return report_; }
    [[nodiscard]] const Settings& settings() const { return settings_; }
    [[nodiscard]] std::span<const Cloth> cloths() const { return cloths_; }

    /// What touched in the last step that was awake, and the pairs of cloth that were near.
    [[nodiscard]] std::span<const ContactRow> contacts() const { return contact_.rows(); }
    [[nodiscard]] std::span<const Ball> balls() const { return balls_; }
    [[nodiscard]] std::span<const Solid> solids() const { return solids_; }
    [[nodiscard]] const std::string& scene() const { return scene_; }
    [[nodiscard]] bool paused() const { return paused_; }

    /// The number of the ball that the user moves, drops and throws; 0 where there is none.
    [[nodiscard]] std::size_t users_ball() const { return users_ball_; }

    /// What the user should know before the next step: that it is longer than the limit of the method, or of the
    /// penalty; that cloth started crossed, or inside something. Empty if nothing.
    [[nodiscard]] std::string step_warning() const;

    /// The longest `solver.dt` that is stable undivided, by the limits of the method and of the penalty [s]. Infinity:
    /// no limit; 0: no step is stable, or none that may be set.
    [[nodiscard]] double longest_step() const;

    /// That cloth and a ball or a solid are so fast that one may pass through the other, while `contact.continuous`
    /// forbids to look, as of the last time that this began (`StepReport::crossing`). Empty if never.
    [[nodiscard]] std::string crossing_warning() const;

    /// Why the run so far is not to be trusted, one line: steps that were not solved, energy that its method has made.
    /// Empty if nothing.
    [[nodiscard]] std::string run_warning() const;

    /// FNV-1a over the bits of every position and velocity of cloths and balls.
    [[nodiscard]] std::uint64_t hash() const;

    /// All that the next step goes on from beside scene and settings, see `write_snapshot`; nothing is changed where it
    /// is written.
    /// @pre what is read has just begun
    void exchange(SnapshotText& text);

    /// Steps that a `step` command asked for and that have not been made.
    [[nodiscard]] int steps_wanted() const { return steps_wanted_; }

    /// The most substeps of a step that the limits ask for.
    static constexpr double max_substeps = 1000;

private:
    // The stages of a step, in their order
    void begin_step();
    void plan_step();
    void plan(int fewest);
    bool input(const Substep& now);
    bool integrate(const Substep& now);
    void limit_stretch();
    bool respond();
    void close_report();
    void rest();

    /// Looks at what the integrators have made of a substep of length h [s], enters it in each cloth's energy, and
    /// marks in the report what is in doubt.
    /// @return why the run must end, one line: a cloth has diverged or a step could not be made; under
    ///         `on_unstable = stop` also a doubt. Empty while it goes on
    std::string check_substep(Real h);

    /// Reports the largest excess over the stretch limits that shortening and contact have left at the end of a step.
    /// @par Cost one pass over two springs a particle; nothing without a limit
    void measure_stretch();

    /// How deep the deepest particle that is not pinned is in a ball, a solid or the ground [m]; 0 if none is deeper
    /// than the cloth is thick.
    /// @par Cost O(particles * (balls + solids))
    [[nodiscard]] Real deepest_particle() const;

    /// What is wrong with the step of a run that has diverged, as a sentence with a space after it; empty if nothing.
    [[nodiscard]] std::string limit_advice() const;

    /// That a step is longer than the method's limit, and that a substep is longer than the limit of the penalty at a
    /// particle of some cloth, in one line each; empty where it is not.
    [[nodiscard]] std::string step_limit_warning() const;
    [[nodiscard]] std::string penalty_limit_warning() const;

    [[nodiscard]] bool kinematic_body_has_moved() const;
    void end_with(std::string error);
    void fall_asleep();
    void wake();

    void carry_out(const Command& command);
    void restart();
    void go_on_from(Simulation&& other);
    void change_pin(const command::Pin& pin);
    void configure(Settings settings);

    /// The settings, with a shown level that is no further past the finest than one: from there, one less is finest.
    [[nodiscard]] Settings within_levels() const;
    [[nodiscard]] double counted_time() const;
    void exchange_users_ball(SnapshotText& text);
    void configure_cloth(std::size_t number, const Settings& before);
    void configure_balls(const Settings& before);
    void use_pins();
    void put_ball(std::size_t number, const Vec3& centre);
    void choose_ball();
    void move_ball_by(BallMotion motion);

    std::string scene_;
    Settings settings_;
    std::optional<StartState> start_;  ///< that the settings name
    std::vector<Cloth> cloths_;
    std::vector<Ball> balls_, previous_balls_;
    std::vector<Solid> solids_, previous_solids_;
    ContactStage contact_;
    Real depth_at_start_ = 0;  ///< of the deepest particle in what cloth should be outside of [m]
    Vec3 steer_ = Vec3::Zero();
    std::size_t users_ball_ = 0;                 ///< that the user leads, drops and throws
    std::optional<BallMotion> motion_by_scene_;  ///< of that ball, once the user has taken it over
    Hand hand_;
    MovingPins pins_;
    bool pins_have_moved_ = false;  ///< in this step
    SleepWatch sleep_;
    StepReport report_;
    int planned_substeps_ = 1;  ///< for the stability limit alone
    ScratchOnCopy<std::vector<ClothView>> shown_;
    ScratchOnCopy<std::vector<std::vector<int>>> pair_cells_;  ///< of each cloth that is shown
    std::int64_t counted_from_step_ = 0;  ///< since then dt has been what it is: no error adds up in the time
    double counted_from_time_ = 0;
    bool paused_ = false;
    int steps_wanted_ = 0;
};

}  // namespace drape
