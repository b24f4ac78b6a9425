#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drape/bounds/broad_phase.h"
#include "drape/bounds/separation.h"
#include "drape/contact/contact.h"
#include "drape/contact/search_audit.h"
#include "drape/integrate/integrator.h"
#include "drape/model/ball.h"
#include "drape/model/cloth_model.h"
#include "drape/sim/command.h"
#include "drape/sim/energy_watch.h"
#include "drape/sim/rest_watch.h"
#include "drape/sim/settings.h"
#include "drape/sim/start_state.h"
#include "drape/sim/step_report.h"

namespace drape {

/// A cloth with all that its steps need.
struct Cloth {
    ClothModel model;
    ClothState state;
    ClothState previous;  ///< one step before `state`
    std::unique_ptr<Integrator> integrator;
    std::unique_ptr<BroadPhase> broad_phase;
    bool tree_is_fresh = false;        ///< the broad phase was built from the present positions
    Separation separation;             ///< in which builds are left out
    TraversalStats traversal;          ///< of the last step that traversed
    Candidates candidates;             ///< of the last ball that was tested; cells ascending
    std::vector<Contact> contacts;     ///< of the last step that was awake
    std::optional<SearchAudit> audit;  ///< while the search is limited
    RestWatch rest;
    EnergyWatch energy_watch;
    std::optional<EnergyLedger> ledger;  ///< while it is kept
    bool touched = true;                 ///< state or model may have been changed since the last step
};

/// What the renderer needs of a moment; all of it belongs to the simulation and lasts until its next change.
struct FrameView {
    std::span<const Cloth> cloths;
    std::span<const Ball> balls;
    std::span<const Ball> previous_balls;  ///< one step before
    Real blend = 1;                        ///< the picture shows previous + blend (now - previous)
    const Settings* settings = nullptr;
    const StepReport* report = nullptr;
    std::string_view scene;  ///< name or path
    bool paused = false;
    bool held = false;  ///< the hand holds a particle
};

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

    /// One step of one or more substeps: step, build, traverse, narrow, respond, report. Does nothing once diverged,
    /// and nothing but count while asleep: once no particle has gone anywhere for a while, nothing moves until a
    /// command or a ball does.
    void step();

    /// @param blend in [0, 1], between the last two states
    [[nodiscard]] FrameView view(Real blend = 1);

    [[nodiscard]] const StepReport& report() const { return report_; }
    [[nodiscard]] const Settings& settings() const { return settings_; }
    [[nodiscard]] std::span<const Cloth> cloths() const { return cloths_; }
    [[nodiscard]] std::span<const Ball> balls() const { return balls_; }
    [[nodiscard]] const std::string& scene() const { return scene_; }
    [[nodiscard]] bool paused() const { return paused_; }

    /// What the user should know before the next step: that it is longer than the method can bear. Empty if nothing.
    [[nodiscard]] std::string step_warning() const;

    /// Why the run so far is not to be trusted, one line: steps that were not solved, energy that its method has made.
    /// Empty if nothing.
    [[nodiscard]] std::string run_warning() const;

    /// FNV-1a over the bits of every position and velocity of cloths and balls.
    [[nodiscard]] std::uint64_t hash() const;

    /// Steps that a `step` command asked for and that have not been made.
    [[nodiscard]] int steps_wanted() const { return steps_wanted_; }

private:
    struct Hand {
        int cloth;
        int particle;
        Vec3 target;
        bool was_pinned;
    };

    void carry_out(const Command& command);
    void configure(Settings settings);
    void restart();
    void predict_limit(int fewest_parts = 1);
    void watch_limit();
    void load(const std::string& scene);
    void grab(const command::Grab& command);
    void release();
    void move_hand(Real h);
    void count_hand_work(double power_before, Real h);
    [[nodiscard]] double present_hand_power() const;
    void substep(double time, Real h);
    void move_balls(double time, Real h);
    [[nodiscard]] bool ball_has_moved() const;
    void move_cloths(double time, Real h);
    void use_broad_phase(Cloth& cloth);
    void show_present_bounds();
    void build(Cloth& cloth);
    void find_contacts(Cloth& cloth, Real h);
    [[nodiscard]] bool nothing_touches(const Cloth& cloth) const;
    void collide(Cloth& cloth, Real h);
    void respond(Cloth& cloth, Real h);
    void check_cloths(Real h);
    [[nodiscard]] std::string solve_trouble() const;
    [[nodiscard]] std::string heat_trouble() const;
    void end_with(std::string trouble);
    void watch_rest();
    void wake();

    std::string scene_;
    Settings settings_;
    std::optional<StartState> start_;  ///< that the settings name
    std::vector<Cloth> cloths_;
    std::vector<Ball> balls_, previous_balls_;
    Vec3 steer_ = Vec3::Zero();
    std::optional<Hand> hand_;
    StepReport report_;
    std::int64_t counted_from_step_ = 0;  ///< since then dt has been what it is: no error adds up in the time
    double counted_from_time_ = 0;
    bool paused_ = false;
    int steps_wanted_ = 0;
};

}  // namespace drape
