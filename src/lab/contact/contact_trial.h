#pragma once

#include <memory>
#include <vector>

#include "drape/bounds/broad_phase.h"
#include "drape/contact/contact_rows.h"
#include "drape/contact/impact.h"
#include "drape/contact/warm_start.h"
#include "drape/integrate/integrator.h"
#include "drape/model/cloth_model.h"

namespace drape {

/// A cloth, and a ball that goes its way at constant velocity whatever it meets.
struct ContactScene {
    ClothParameters cloth;
    Ball ball;       ///< where it starts; it moves
    double end = 0;  ///< of a run [s]
    IntegratorParameters integrator;
    ResponseParameters response;
    Vec3 gravity = standard_gravity();  ///< [m/s^2]
};

/// How a run finds what touches.
struct Detection {
    BroadPhaseParameters search;
    bool continuous = false;  ///< on the whole way of a step, not at its end alone
};

/// A hung cloth of 1 m and a ball on its way through the middle of it, from a quarter of a metre before they meet.
/// @param speed of the ball [m/s]
/// @param step of the run, of which the end is a multiple [s]
ContactScene hung_cloth_and_ball(double speed, double step);

/// A simulation without all that contact does not need: step, build, query, exact test, response, in the order of
/// `Simulation` and to the same bits, but that it does not divide steps in contact.
class ContactTrial {
public:
    /// @param continuous the whole way of every step is tested
    ContactTrial(const ContactScene& scene, Real step, bool continuous = false);

    /// Moves ball and cloth by one step and finds what then touches.
    /// @param hierarchy is used by `respond` too
    void advance(BroadPhase& hierarchy);

    /// Answers what was found, and what that has caused.
    ResponseReport respond();

    /// The triangles that touch the front of the ball, ascending: of the cells that the search has found, and all of a
    /// node at which it has ended and that is taken for a contact. At the back of the ball the cloth is on the wrong
    /// side.
    [[nodiscard]] std::vector<int> touched_triangles() const;

    [[nodiscard]] const ClothModel& model() const { return model_; }
    [[nodiscard]] const Grid& grid() const { return model_.grid; }
    [[nodiscard]] const Points& positions() const { return state_.x; }
    [[nodiscard]] const Points& velocities() const { return state_.v; }
    [[nodiscard]] const Ball& ball() const { return ball_; }
    [[nodiscard]] std::span<const StoppedNode> stopped() const { return candidates_.stopped; }

    /// Whether the ball's centre is farther on its way than the particle that was nearest to it at the start.
    [[nodiscard]] bool has_passed() const;

private:
    [[nodiscard]] ClothInContact in_contact() { return {model_, before_, state_, contacts_}; }
    void find();
    void find_on_ball();
    ResponseReport answer();

    ResponseParameters response_;
    bool continuous_;
    Kernels kernels_;
    Real h_;
    ClothModel model_;
    ClothState state_;
    Points before_;  ///< positions at the start of the step
    Ball ball_;
    int aim_;  ///< the particle nearest to the ball's way
    std::unique_ptr<Integrator> integrator_;
    Candidates candidates_;
    ContactRows rows_;
    std::vector<TriangleImpact> impacts_;
    BroadPhase* hierarchy_ = nullptr;  ///< of the last step
    std::vector<Contact> contacts_, first_contacts_;
    bool passing_ = false;  ///< something has come past the ball's middle
    WarmStart<Contact> warm_start_;
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
ContactHistory watch_contacts(const ContactScene& scene, const Detection& detection, Real step);

/// The same with a hierarchy of the caller's.
ContactHistory watch_contacts(const ContactScene& scene, BroadPhase& hierarchy, bool continuous, Real step);

/// What a run has of its contacts wrong.
struct ContactErrors {
    double missed_contacts = 0;  ///< part of the triangles, step by step, that the reference touched within the step,
                                 ///< and the run has not found
    double missed_steps = 0;     ///< part of the steps within which the reference touched, and the run not at all
    double momentum = 0;         ///< of the cloth at the end: its difference from the reference's, over that
    bool passed = false;         ///< the ball has gone through the cloth, and that of the reference has not
};

/// @param reference with `finer` steps for each of the run's; it must have touched
ContactErrors compare_contacts(const ContactHistory& run, const ContactHistory& reference, int finer);

}  // namespace drape
