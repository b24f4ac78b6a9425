#pragma once

#include <istream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drape/model/ball.h"
#include "drape/model/cloth_model.h"
#include "drape/sim/settings.h"

namespace drape {

/// Where a run starts that another one has left off.
struct StartState {
    double time = 0;                 ///< simulated [s]
    std::vector<ClothState> states;  ///< of each cloth
    std::vector<Ball> balls = {};    ///< centre, velocity, orientation and spin; none: they start as the scene has them
};

/// Reads the last moment of the file that the settings name, as `--state` has written it; nothing if they name none.
/// @throws InputError as `file:line: ...`, also where it does not fit the cloths
std::optional<StartState> find_start(const Settings& settings);

/// The same from a stream.
/// @param file names it in messages
/// @param grids of the cloths
/// @param balls of the scene; a file has all of them, or none
StartState read_start(std::istream& in, const std::string& file, std::span<const Grid> grids, std::size_t balls);

}  // namespace drape
