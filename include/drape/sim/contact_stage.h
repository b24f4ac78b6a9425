#pragma once

#include <span>
#include <vector>

#include "drape/base/copied.h"
#include "drape/contact/response.h"
#include "drape/contact/warm_start.h"
#include "drape/scene/settings.h"
#include "drape/sim/cloth.h"
#include "drape/sim/self_search.h"
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

    /// A body has been put elsewhere: nothing that touched it does so any more.
    /// @param is_moved is_moved(body) of numbers: balls, then solids, then the ground
    template <class IsMoved>
    void forget_bodies(IsMoved is_moved) {
        std::erase_if(rows_, [&](const ContactRow& row) {
            return (row.body != no_body && is_moved(row.body)) ||
                   (row.first_body != no_body && is_moved(row.first_body));
        });
    }

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
    void solve(StepReport& report);

    /// Whether features of cloths would cross within the substep all the same.
    [[nodiscard]] bool would_cross();

    /// Holds them back if so: the fail-safe.
    void prevent_crossing(StepReport& report);

    /// Rolling resistance; enters what is only known now.
    void end();

    /// Whether bodies have touched in the last substep, or cloths were near.
    [[nodiscard]] bool is_near() const { return near_; }

    /// What the next substep goes on from. The pairs of cloth that are near are not part of it: they are searched for
    /// again, with the same result.
    /// @param has_ground a solid one
    void exchange(SnapshotText& text, const ContactBodies& bodies, bool has_ground);

    /// What has touched in the last substep, and the pairs of cloth that were near, in the order of `compare`.
    [[nodiscard]] std::span<const ContactRow> rows() const { return rows_; }

    /// Of it, one cloth and bodies.
    [[nodiscard]] std::span<const ContactRow> rows_of(std::size_t cloth) const;

    /// Nothing touches any more.
    void clear() { rows_.clear(); }

    [[nodiscard]] const SelfSearch& self() const { return self_; }

private:
    enum class Stage { Ended, Begun, WarmStarted, Found, Solved };

    /// What is known from `begin` to `end`, which no copy needs.
    struct Now : Substep {
        const Settings* settings = nullptr;
        ContactBodies moving;
        ResponseParameters response;
        std::vector<ClothInContact> cloths;
        std::vector<Body> bodies;  ///< balls, then solids, then the ground
    };

    void go_on(Stage from, Stage to);
    [[nodiscard]] MovingCloth motion_of(std::size_t cloth) const;
    void build(StepReport& report);
    void traverse(StepReport& report);
    void narrow(StepReport& report);
    template <class Give>
    void push(std::span<const ContactRow> rows, bool known, Give give);

    Stage stage_ = Stage::Ended;
    ScratchOnCopy<Now> now_;
    SelfSearch self_;
    std::vector<ContactRow> rows_;
    bool near_ = false;
    WarmStart warm_start_;
    ContactSolver solver_;
};

}  // namespace drape
