#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "notches.h"
#include "scene_needs.h"

namespace drape {

/// Is told each attempt, with what became of it: "kept", "cheapest so far", or why it was rejected.
using Trail = std::function<void(const Attempt&, const std::string& outcome)>;

/// What a search has come to.
struct SearchResult {
    std::optional<Attempt> cheapest;
    std::optional<Attempt> nearest;  ///< that does not qualify; what to tell where none does
};

/// Looks for the cheapest configuration that shows what the scene needs.
///
/// First the model: with everything computed closely, particles, bend springs and drag are taken away notch by notch as
/// far as the needs allow. Then the method: for each of these models, the least first, each integrator's longest step
/// that qualifies, as long as it is not more expensive than the cheapest so far. Then every knob once more, until one
/// notch less on any that has an order breaks a need. Last, how contacts are looked for: by cost alone, unless the
/// search has a limit, for then that changes the motion too. A scene that does not state an error has no full model: it
/// is taken as it is, and only notches are taken away.
SearchResult search(const Needs& needs, const Trail& trail);

/// The free knobs with an order of which a scene that qualifies has a notch more than it needs; none if it is minimal.
std::vector<Knob> spare_notches(const Needs& needs, const Trail& trail);

}  // namespace drape
