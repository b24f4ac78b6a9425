#pragma once

#include <istream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drape/model/ball.h"
#include "drape/model/cloth_model.h"
#include "drape/scene/settings.h"

namespace drape {

/// The columns of a ball in a file of states. Lines of balls are comments: "#" and a blank come before them.
constexpr std::string_view ball_columns = "t,ball,x,y,z,vx,vy,vz,turn_x,turn_y,turn_z,turn_w,spin_x,spin_y,spin_z";

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
