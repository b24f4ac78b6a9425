#include "positions.h"

#include <algorithm>

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"
#include "drape/base/read_line.h"

namespace drape {
namespace {

constexpr double largest_coordinate = 1e12;  // m
constexpr std::size_t longest_line = 4096;

}  // namespace

std::vector<double> parse_numbers(const std::string& text, std::size_t count, const std::string& where) {
    const auto numbers = parse_reals(text);
    const auto fits = [](double x) { return x >= -largest_coordinate && x <= largest_coordinate; };
    if (numbers && numbers->size() == count && std::ranges::all_of(*numbers, fits)) return *numbers;
    throw InputError(where + shortened(text) + ": allowed " + std::to_string(count) +
                     " numbers with commas between, each of size at most " + real_text(largest_coordinate));
}

Points read_positions(const std::string& file, const Grid& grid) {
    InputFile in(file);
    return read_positions(in, file, grid);
}

Points read_positions(std::istream& in, const std::string& file, const Grid& grid) {
    Points x(grid.particles(), 3);
    std::string line;
    int row = 0;
    for (int number = 1;; ++number) {
        const LineEnd end = read_line(in, line, longest_line);
        if (end == LineEnd::None) break;
        const std::string where = file + ":" + std::to_string(number) + ": ";
        if (end == LineEnd::TooLong) {
            throw InputError(where + "the line is longer than " + std::to_string(longest_line) + " bytes");
        }
        if (row == grid.particles()) {
            throw InputError(where + "more rows than the grid's " + std::to_string(grid.particles()) + " particles");
        }
        const auto values = parse_numbers(line, 3, where);
        for (int axis = 0; axis < 3; ++axis) x(row, axis) = static_cast<Real>(values[static_cast<std::size_t>(axis)]);
        ++row;
    }
    if (row < grid.particles()) {
        throw InputError(file + ": " + std::to_string(row) + " rows: the grid has " + std::to_string(grid.particles()) +
                         " particles");
    }
    return x;
}

}  // namespace drape
