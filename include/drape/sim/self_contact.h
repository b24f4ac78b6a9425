#pragma once

#include <span>
#include <vector>

#include "drape/contact/motion_bounds.h"
#include "drape/contact/warm_start.h"
#include "drape/sim/self_search.h"
#include "drape/sim/settings.h"

namespace drape {

/// Contact of the cloths with themselves and with each other, stage by stage: search, response, fail-safe. It does
/// nothing, and costs nothing, where a scene has not asked for it.
class SelfContact {
public:
    /// Starts from nothing with these cloths.
    void use(const Settings& settings, std::span<const ClothModel* const> models);

    [[nodiscard]] bool on() const { return on_; }

    /// Positions have been set from outside.
    void forget() { search_.forget(); }

    /// Takes the pushes of the substep before for a warm start.
    void take_pushes(const ResponseParameters& parameters, Real h, Real gravity,
                     std::span<const ClothInContact> cloths);
    [[nodiscard]] const WarmStart<PairContact>& warm_start() const { return warm_start_; }

    /// Finds what may touch within the substep, after the integrator's step and the warm start.
    SelfSearchReport find(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                          std::span<const Ball> balls);

    /// Those found, and after the response those that were answered.
    [[nodiscard]] std::span<PairContact> contacts() { return contacts_; }
    [[nodiscard]] std::span<const PairContact> contacts() const { return contacts_; }

    /// Whether anything is so near that it has been looked at.
    [[nodiscard]] bool is_near() const { return !search_.pairs().empty(); }

    /// After the response: holds back what could have crossed.
    BoundedMotion hold_back(std::span<const ClothInContact> cloths) const;

private:
    bool on_ = false;
    SelfSearch search_;
    MotionBounds bounds_;
    WarmStart<PairContact> warm_start_;
    std::vector<PairContact> contacts_;
    std::vector<int> particles_;  ///< of each cloth
};

}  // namespace drape
