#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drape/sim/contact_stage.h"
#include "lab/experiment/row.h"

namespace drape {

/// Cloths, and a ball or none that goes its way at constant velocity whatever it meets.
struct ContactScene {
    Settings settings;                   ///< of the cloths and the ball, the step left open
    double end = 0;                      ///< of a run [s]
    std::optional<Vec3> gravity = {};    ///< if it is not that of the settings [m/s^2]
    std::vector<ClothState> start = {};  ///< of the cloths; empty: they start at rest

    /// The same under other settings: "contact.leaf_cells=4".
    [[nodiscard]] ContactScene with(const std::vector<std::string>& assignments) const;
};

/// A hung cloth of 1 m and a ball on its way through the middle of it, from a quarter of a metre before they meet.
/// @param speed of the ball [m/s]
/// @param step of the run, of which the end is a multiple [s]
ContactScene hung_cloth_and_ball(double speed, double step);

/// A simulation without all that contact does not need: the integrator and the contact stage of `Simulation`, to the
/// same bits, but that it does not divide steps.
class ContactTrial {
public:
    ContactTrial(const ContactScene& scene, Real step);

    /// Moves ball and cloths by one step and finds what then touches.
    void advance() { advance(h_); }

    /// Answers what was found.
    ResponseReport respond();

    /// The triangles that touch the front of the ball, ascending: of the cells that the search has found, and all of a
    /// node at which it has ended and that is taken for a contact. At the back of the ball the cloth is on the wrong
    /// side.
    [[nodiscard]] std::vector<int> touched_triangles() const;

    [[nodiscard]] const Grid& grid() const { return cloths_[0].model.grid; }
    [[nodiscard]] const ClothState& state(std::size_t cloth = 0) const { return cloths_[cloth].state; }
    [[nodiscard]] const Ball& ball() const { return balls_[0]; }
    [[nodiscard]] std::span<const StoppedNode> stopped() const { return cloths_[0].search.candidates(0).stopped; }

    /// Of a cloth [kg m/s].
    [[nodiscard]] Vec3 momentum(std::size_t cloth = 0) const;

    /// Whether the ball's centre is farther on its way than the particle that was nearest to it at the start.
    [[nodiscard]] bool has_passed() const;

protected:
    /// By a step of another length [s].
    void advance(Real h);

    Settings settings_;
    Real h_;
    std::vector<Cloth> cloths_;
    std::vector<Ball> balls_;
    ContactStage stage_;
    StepReport report_;
    Points unpushed_;  ///< of the first cloth, where the integrator has left it [m]

private:
    [[nodiscard]] bool touches_front(int triangle) const;

    int aim_ = 0;  ///< the particle nearest to the ball's way
};

/// What one run saw.
struct ContactHistory {
    std::vector<std::vector<int>> touched;  ///< triangles in contact, ascending, step by step
    double entered = 0;                     ///< largest depth of any triangle before the response [m]
    double left = 0;                        ///< and after it [m]
    double false_contacts = 0;              ///< nodes taken for contacts in which nothing touches, a step
    bool passed = false;                    ///< at the end
    Vec3 momentum = Vec3::Zero();           ///< of the cloth, at the end [kg m/s]
};

/// Runs a scene to its end.
ContactHistory watch_contacts(const ContactScene& scene, Real step);

/// What a run has of its contacts wrong, in cells of a row of the experiment `contact`.
/// @param reference with `finer` steps for each of the run's; it must have touched
/// @return `missed_contacts`, part of the triangles, step by step, that the reference touched within the step, and the
///         run has not found; `missed_steps`, part of the steps within which the reference touched, and the run not at
///         all; `momentum_error` of the cloth at the end, part of the reference's; and "1" as `passed` if the ball has
///         gone through the cloth, and that of the reference has not
Row compare_contacts(const ContactHistory& run, const ContactHistory& reference, int finer);

}  // namespace drape
