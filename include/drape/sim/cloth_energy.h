#pragma once

#include <optional>
#include <span>
#include <vector>

#include "drape/contact/contact.h"
#include "drape/contact/response.h"
#include "drape/sim/energy_ledger.h"
#include "drape/sim/energy_watch.h"

namespace drape {

/// Where the energy of one cloth comes from and goes to, told event by event in the order of a substep: the watch that
/// every run has, and the ledger while one is kept.
class ClothEnergy {
public:
    /// Starts from the energy as it is, without a ledger.
    void restart(const ClothModel& model, const ClothState& state) { watch_.restart(model, state); }

    /// Begins a ledger, or drops it.
    void keep_ledger(bool keep, const ClothModel& model, const ClothState& state);

    /// State or model may have been changed from outside since the last substep.
    void touch() { touched_ = true; }

    /// Hand, ball or wind have put in at least this [J].
    void give(double work) { watch_.give(work); }

    /// Remembers the entries so far, and forgets those since.
    void mark();
    void return_to_mark();

    void before_integrator(const ClothModel& model, const ClothState& state);

    /// Enters what the integrator has done.
    /// @param least_pause substeps from one sum over the springs to the next, at least
    void after_integrator(const ClothModel& model, const ClothState& state, const MotionSums& sums, Real h,
                          int least_pause);

    /// Answers the contacts, and enters what that has done.
    ResponseReport respond(const ClothModel& model, const ResponseParameters& response, std::span<const Ball> balls,
                           Real h, std::vector<Contact>& contacts, ClothState& state);

    /// Velocities were set to zero by sleep.
    void stilled(const ClothModel& model, const ClothState& state);

    [[nodiscard]] const EnergyWatch& watch() const { return watch_; }

    /// Since the ledger began.
    [[nodiscard]] EnergyBalance balance() const { return ledger_ ? ledger_->balance() : EnergyBalance::unknown(); }

private:
    EnergyWatch watch_;
    std::optional<EnergyLedger> ledger_;
    bool touched_ = true;
};

}  // namespace drape
