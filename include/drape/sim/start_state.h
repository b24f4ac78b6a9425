#pragma once

#include <istream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drape/model/cloth_model.h"
#include "drape/sim/settings.h"

namespace drape {

/// Where a run starts that another one has left off.
struct StartState {
    double time = 0;                 ///< simulated [s]
    std::vector<ClothState> states;  ///< of each cloth
};

/// Reads the last moment of the file that the settings name, as `--state` has written it; nothing if they name none.
/// @throws InputError as `file:line: ...`, also where it does not fit the cloths
std::optional<StartState> find_start(const Settings& settings);

/// The same from a stream.
/// @param file names it in messages
/// @param grids of the cloths
StartState read_start(std::istream& in, const std::string& file, std::span<const Grid> grids);

}  // namespace drape
