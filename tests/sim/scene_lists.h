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

}  // namespace drape
