#pragma once

#include <string>
#include <vector>

#include "drape/sim/scene.h"

namespace drape {

/// The shipped scenes that are made to fail, or the others.
inline std::vector<std::string> scenes_that_fail(bool fail) {
    std::vector<std::string> names;
    for (const std::string& name : scene_names()) {
        if (name.starts_with("fails_") == fail) names.push_back(name);
    }
    return names;
}

/// How much a step of a scene costs: cloth on cloth and on meshes takes long, and so do many particles.
enum class Cost { Small, Costly, Large };
inline Cost cost_of(const Settings& settings) {
    if (settings.cloths[0].particles.particles() > 10'000) return Cost::Large;
    return settings.contact.self || !settings.solids.empty() ? Cost::Costly : Cost::Small;
}

}  // namespace drape
