#pragma once

#include <span>
#include <vector>

#include "drape/base/snapshot_text.h"
#include "drape/contact/impact_zones.h"
#include "drape/scene/settings.h"
#include "drape/sim/self_search.h"

namespace drape {

/// Contact of the cloths with themselves and with each other, stage by stage: search, response, fail-safe. It does
/// nothing, and costs nothing, where a scene has not asked for it.
class SelfContact {
public:
    /// Starts from nothing with these cloths.
    /// @param x their positions [m]
    void use(const Settings& settings, std::span<const ClothModel* const> models, std::span<const Points* const> x);

    /// Goes on with another hierarchy, which finds the same.
    void use_hierarchy(const Settings& settings, std::span<const ClothModel* const> models);

    /// Goes on with another number of threads, which find the same.
    void share(int threads) { search_.share(threads); }

    [[nodiscard]] bool on() const { return on_; }

    /// What was found at the start; pairs are looked for anew.
    void exchange(SnapshotText& text) { text.line("cloth_at_start", crossings_at_start_, coincident_at_start_); }

    /// Positions have been set from outside.
    void forget() { search_.forget(); }

    /// Finds what may touch within the substep, after the integrator's step and the warm start.
    /// @param rows receives it, after what is there
    void find(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
              std::vector<ContactRow>& rows);

    /// Whether anything is so near that it has been looked at.
    [[nodiscard]] bool is_near() const { return !search_.pairs().empty(); }

    /// After the response: whether features would meet within the substep, for all that it has done.
    bool would_cross(std::span<const ClothInContact> cloths);

    /// If so, holds them back.
    /// @return how many particles
    std::int64_t prevent_crossing(std::span<const ClothInContact> cloths);

    /// How many times cloth crossed cloth at the start: what keeps the sides of cloths cannot part these.
    [[nodiscard]] std::int64_t crossings_at_start() const { return crossings_at_start_; }

    /// In how many places cloth touched cloth at distance 0 then: these are parted.
    [[nodiscard]] std::int64_t coincident_at_start() const { return coincident_at_start_; }

    /// What the search of this substep has cost.
    [[nodiscard]] const SelfSearchReport& report() const { return report_; }

private:
    bool on_ = false;
    SelfSearch search_;
    SelfSearchReport report_;
    std::int64_t crossings_at_start_ = 0, coincident_at_start_ = 0;
    ImpactZones zones_;
};

}  // namespace drape
