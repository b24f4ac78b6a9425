#pragma once

#include <memory>
#include <vector>

#include "drape/bounds/broad_phase.h"
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
};

/// A hung cloth of 1 m and a ball on its way through the middle of it, from a quarter of a metre before they meet.
/// @param speed of the ball [m/s]
/// @param step of the run, of which the end is a multiple [s]
ContactScene hung_cloth_and_ball(double speed, double step);

/// A simulation without all that contact does not need: step, build, query, exact test, response, in the order of
/// `Simulation` and to the same bits, but that it does not divide steps in contact and tests their ends alone.
class ContactTrial {
public:
    ContactTrial(const ContactScene& scene, Real step);

    /// Moves ball and cloth by one step and finds what then touches.
    void advance(BroadPhase& hierarchy);

    /// Answers what was found.
    void respond();

    [[nodiscard]] const Grid& grid() const { return model_.grid; }
    [[nodiscard]] const Points& positions() const { return state_.x; }
    [[nodiscard]] const Ball& ball() const { return ball_; }
    [[nodiscard]] const std::vector<Contact>& contacts() const { return contacts_; }
    [[nodiscard]] std::span<const StoppedNode> stopped() const { return candidates_.stopped; }

    /// Whether the ball's centre is farther on its way than the particle that was nearest to it at the start.
    [[nodiscard]] bool has_passed() const;

private:
    [[nodiscard]] ClothInContact in_contact() { return {model_, before_, state_, contacts_}; }

    ResponseParameters response_;
    Kernels kernels_;
    Real h_;
    ClothModel model_;
    ClothState state_;
    Points before_;  ///< positions at the start of the step
    Ball ball_;
    int aim_;  ///< the particle nearest to the ball's way
    std::unique_ptr<Integrator> integrator_;
    Candidates candidates_;
    std::vector<Contact> contacts_;
    WarmStart<Contact> warm_start_;
};

/// What one run saw.
struct ContactHistory {
    std::vector<std::vector<int>> touched;  ///< triangles in contact, ascending, step by step
    double entered = 0;                     ///< largest depth of any triangle before the response [m]
    double left = 0;                        ///< and after it [m]
    double false_contacts = 0;              ///< nodes taken for contacts in which nothing touches, a step
    bool passed = false;                    ///< at the end
};

/// Runs a scene to its end. A contact of a node at which a limited search has ended counts for all triangles within. A
/// contact with the back of the ball does not count: the cloth is on the wrong side there.
ContactHistory watch_contacts(const ContactScene& scene, const BroadPhaseParameters& search, Real step);

/// The same with a hierarchy of the caller's.
ContactHistory watch_contacts(const ContactScene& scene, BroadPhase& hierarchy, Real step);

/// What a run has of its contacts wrong.
struct ContactErrors {
    double missed_contacts = 0;  ///< part of the triangles, step by step, that the reference touched within the step,
                                 ///< and the run not at its end
    double missed_steps = 0;     ///< part of the steps within which the reference touched, and the run not at all
    bool passed = false;         ///< the ball has gone through the cloth, and that of the reference has not
};

/// @param reference with `finer` steps for each of the run's; it must have touched
ContactErrors compare_contacts(const ContactHistory& run, const ContactHistory& reference, int finer);

}  // namespace drape
