#pragma once

#include <span>
#include <vector>

#include "drape/base/copied.h"
#include "drape/contact/contact_rows.h"
#include "drape/contact/response.h"
#include "drape/sim/cloth.h"
#include "drape/sim/self_contact.h"
#include "drape/sim/settings.h"
#include "drape/sim/step_report.h"

namespace drape {

/// All that may touch within a substep.
struct ContactBodies {
    std::span<Cloth> cloths;
    std::span<Ball> balls;
    std::span<const Solid> solids;
};

/// A part of a step.
struct Substep {
    double time = 0;       ///< simulated, at its start [s]
    Real h = 0;            ///< [s]
    bool divided = false;  ///< one of several: it starts at `Cloth::before`, which `begin` sets, else at `previous`
};

/// Contact of cloths with balls, solids and the ground, with themselves and with each other, and of balls, in one
/// substep: `begin`, the integrators' steps, `warm_start`, `detect`, `solve`, `prevent_crossing`, `end`, in this order;
/// without `prevent_crossing` cloths may cross. What has moved on its own, balls and solids, has done so before
/// `begin`.
class ContactStage {
public:
    /// Starts from nothing with these cloths.
    void use(const Settings& settings, std::span<Cloth> cloths);

    /// Settings have changed, the cloths are the same.
    void configure(const Settings& settings, const Settings& before, std::span<Cloth> cloths);

    /// Positions have been set from outside.
    void forget() { self_.forget(); }

    /// Takes what was given in the substep before.
    /// @param settings, bodies stay where they are until `end`
    void begin(const Settings& settings, const ContactBodies& bodies, const Substep& now);

    /// Gives it to cloths and balls, as the start of what this substep needs.
    void warm_start();

    /// Finds what may touch: build, traversal and exact test for balls, solids, ground, and pairs of cloth.
    void detect(StepReport& report);

    /// What a limited search has got wrong, for the report alone: contacts that are none, and, after `solve`, depth
    /// that it has not seen.
    void audit_search(StepReport& report);
    void audit_response(StepReport& report);

    /// Gives what the contacts need, and enters the work of it.
    ResponseReport solve(StepReport& report);

    /// Whether features of cloths would cross on their way all the same.
    [[nodiscard]] bool would_cross();

    /// Holds them back if so: the fail-safe.
    void prevent_crossing(StepReport& report);

    /// Rolling resistance; enters what is only known now.
    void end();

    /// Whether anything touched in the last substep, or is near.
    [[nodiscard]] bool is_near() const { return !ball_contacts_.empty() || self_.is_near(); }

    [[nodiscard]] SelfContact& self() { return self_; }
    [[nodiscard]] const SelfContact& self() const { return self_; }

private:
    enum class Stage { Ended, Begun, Given, Found, Solved };

    /// What is known from `begin` to `end`, which no copy needs.
    struct Now : Substep {
        const Settings* settings = nullptr;
        ContactBodies bodies;
        ResponseParameters response;
        std::vector<ClothInContact> cloths;

        void clear() { *this = {}; }
    };

    void go_on(Stage from, Stage to);
    [[nodiscard]] const Points& start_of(const Cloth& cloth) const;
    [[nodiscard]] ClothMotion motion_of(const Cloth& cloth) const { return {start_of(cloth), cloth.state.x}; }
    void build(StepReport& report);
    void traverse(StepReport& report);
    void narrow(StepReport& report);
    void enter_pushes(Cloth& cloth, std::span<const Contact> contacts, double led_work, double& free_work);

    Stage stage_ = Stage::Ended;
    ScratchOnCopy<Now> now_;
    SelfContact self_;
    std::vector<BallContact> ball_contacts_;
    ScratchOnCopy<ContactRows> rows_;
};

}  // namespace drape
