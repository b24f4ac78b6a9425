#pragma once

#include <istream>
#include <string>
#include <vector>

#include "drape/base/real.h"
#include "drape/model/grid.h"

namespace drape {

/// Reads "1,2,3" into exactly `count` finite numbers.
/// @param where starts the error
/// @throws InputError
std::vector<double> parse_numbers(const std::string& text, std::size_t count, const std::string& where);

/// Reads one x,y,z a line, in particle order.
/// @param file names it in messages
/// @throws InputError as `file:line: ...`
Points read_positions(std::istream& in, const std::string& file, const Grid& grid);

}  // namespace drape
