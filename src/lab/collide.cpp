#include "commands.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <vector>

#include "drape/base/command_line.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"
#include "drape/contact/detection.h"
#include "drape/scene/setting_table.h"

namespace drape {
namespace {

constexpr double largest_coordinate = 1e12;  // m

struct CollideOptions {
    std::string grid, positions, ball;
    std::vector<std::string> assignments;
};

/// Reads "1,2,3" into exactly `count` finite numbers.
/// @param where starts the error
/// @throws InputError
std::vector<double> parse_numbers(const std::string& text, std::size_t count, const std::string& where) {
    const auto numbers = parse_reals(text);
    const auto fits = [](double x) { return x >= -largest_coordinate && x <= largest_coordinate; };
    if (numbers && numbers->size() == count && std::ranges::all_of(*numbers, fits)) return *numbers;
    throw InputError(fmt::format("{}{}: allowed {} numbers with commas between, each of size at most {}", where,
                                 shortened(text), count, real_text(largest_coordinate)));
}

Grid parse_grid(const std::string& text) {
    const auto size = parse_integers(text, 'x');
    if (!size || std::min(size->first, size->second) < 2 || std::max(size->first, size->second) > 4096) {
        throw InputError("--grid " + shortened(text) + ": allowed NXxNY, each 2 to 4096");
    }
    return {static_cast<int>(size->first), static_cast<int>(size->second)};
}

Ball parse_ball(const std::string& text) {
    const auto values = parse_numbers(text, 4, "--ball ");
    if (!(values[3] >= 0)) throw InputError("--ball " + shortened(text) + ": allowed a radius of at least 0");
    const auto at = [&](std::size_t i) { return static_cast<Real>(values[i]); };
    return {.centre = {at(0), at(1), at(2)}, .radius = at(3)};
}

void collide(const CollideOptions& options) {
    Settings settings;
    settings.contact.thickness = 0;
    assign_all(settings, options.assignments);
    const Grid grid = parse_grid(options.grid);
    const Ball ball = parse_ball(options.ball);
    InputFile file(options.positions);
    const Points x = read_positions(file, options.positions, grid);

    const auto broad_phase = make_broad_phase(broad_phase_of(settings), grid);
    Candidates found;
    std::vector<int> triangles;
    broad_phase->build(x);
    const TraversalStats stats = broad_phase->query(grown(ball, settings.contact.thickness), found);
    find_touched_triangles(grid, x, ball, settings.contact.thickness, found.cells, triangles, settings.solver.kernels);

    std::sort(triangles.begin(), triangles.end());
    std::cout << fmt::format("{}{}", fmt::join(triangles, "\n"), triangles.empty() ? "" : "\n") << std::flush;
    std::cerr << "nodes=" << stats.nodes << " visited=" << stats.visited << " volume_tests=" << stats.volume_tests
              << " leaves=" << stats.leaves << " candidates=" << stats.candidates << " touched=" << triangles.size();
    if (stats.stopped > 0) {
        std::cerr << " stopped=" << stats.stopped << "\ncollide: the search was limited and has ended at "
                  << stats.stopped << " nodes: triangles within them are not listed";
    }
    std::cerr << "\n";
}

}  // namespace

Points read_positions(std::istream& in, const std::string& file, const Grid& grid) {
    NumberedLines lines{.in = in, .file = file, .longest = 4096, .may_be_cut_off = true};
    Points x(grid.particles(), 3);
    int row = 0;
    for (; lines.next(); ++row) {
        if (row == grid.particles()) lines.fail(fmt::format("more rows than the grid's {} particles", row));
        const auto values = parse_numbers(lines.line, 3, lines.place() + ": ");
        for (int axis = 0; axis < 3; ++axis) x(row, axis) = static_cast<Real>(values[static_cast<std::size_t>(axis)]);
    }
    if (row < grid.particles()) {
        throw InputError(fmt::format("{}: {} rows: the grid has {} particles", file, row, grid.particles()));
    }
    return x;
}

void add_collide(CommandLine& line) {
    auto options = std::make_shared<CollideOptions>();
    CommandLine& command = line.command(
        "collide",
        "Prints the triangles whose distance to the ball's centre is at most its radius (plus thickness, 0 "
        "unless set)",
        [options] { collide(*options); });
    command.option("--grid", options->grid, "columns and rows of particles", {"NXxNY", true});
    command.option("--positions", options->positions, "one x,y,z a line, in particle order [m]", {"FILE.csv", true});
    command.option("--ball", options->ball, "centre and radius [m]", {"x,y,z,r", true});
    command.option(
        "--set", options->assignments,
        "volume, update, sphere_fit, leaf_cells, thickness; search_level, search_tests: nodes at which a search "
        "ends are counted, and what they hold is not listed",
        {"name=value"});
}

}  // namespace drape
