#include "positions.h"

#include <algorithm>

#include "drape/base/input_file.h"
#include "drape/base/numbers.h"
#include "line_reader.h"

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

Points read_positions(std::istream& in, const std::string& file, const Grid& grid) {
    Points x(grid.particles(), 3);
    LineReader reader(in, file, longest_position_line);
    int row = 0;
    for (; reader.next() != LineEnd::None; ++row) {
        if (row == grid.particles()) reader.fail("more rows than the grid's {} particles", grid.particles());
        const auto values = parse_numbers(reader.line(), 3, reader.where());
        for (int axis = 0; axis < 3; ++axis) x(row, axis) = static_cast<Real>(values[static_cast<std::size_t>(axis)]);
    }
    if (row < grid.particles()) {
        throw InputError(fmt::format("{}: {} rows: the grid has {} particles", file, row, grid.particles()));
    }
    return x;
}

}  // namespace drape
