#include "positions.h"

#include <fmt/core.h>

#include <algorithm>

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

constexpr double largest_coordinate = 1e12;  // m
constexpr std::size_t longest_position_line = 4096;

}  // namespace

std::vector<double> parse_numbers(const std::string& text, std::size_t count, const std::string& where) {
    const auto numbers = parse_reals(text);
    const auto fits = [](double x) { return x >= -largest_coordinate && x <= largest_coordinate; };
    if (numbers && numbers->size() == count && std::ranges::all_of(*numbers, fits)) return *numbers;
    throw InputError(fmt::format("{}{}: allowed {} numbers with commas between, each of size at most {}", where,
                                 shortened(text), count, real_text(largest_coordinate)));
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
        const LineEnd end = read_line(in, line, longest_position_line);
        if (end == LineEnd::None) break;
        const std::string where = fmt::format("{}:{}: ", file, number);
        if (end == LineEnd::TooLong) {
            throw InputError(fmt::format("{}the line is longer than {} bytes", where, longest_position_line));
        }
        if (row == grid.particles()) {
            throw InputError(fmt::format("{}more rows than the grid's {} particles", where, grid.particles()));
        }
        const auto values = parse_numbers(line, 3, where);
        for (int axis = 0; axis < 3; ++axis) x(row, axis) = static_cast<Real>(values[static_cast<std::size_t>(axis)]);
        ++row;
    }
    if (row < grid.particles()) {
        throw InputError(fmt::format("{}: {} rows: the grid has {} particles", file, row, grid.particles()));
    }
    return x;
}

}  // namespace drape
