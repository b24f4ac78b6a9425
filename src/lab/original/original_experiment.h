#pragma once

#include <array>
#include <filesystem>

#include "lab/experiment/experiment.h"
#include "original_frames.h"

namespace drape {

/// The five tests of the dissertation that the original was written for: a hierarchy of spheres against one of boxes,
/// on the original's scene.
Experiment original_experiment();

/// The five tests side by side, and build and search apart.
std::vector<Chart> original_charts(const std::vector<TableRow>& rows);

/// The rows of one case: spheres and boxes in turn, without and with bounds in the picture.
/// @param program that draws; where there is none, what it would have told stays empty
/// @param draws receives whether there was one
std::vector<TableRow> original_rows(const OriginalPlan& plan, const std::filesystem::path& program, bool& draws);

/// Whether both halves of the dissertation's conclusion hold: spheres are more expensive to build, and faster to
/// search.
/// @param sphere,aabb medians
std::string original_verdict(const OriginalSearch& sphere, const OriginalSearch& aabb);

/// One of the five tests.
struct OriginalTest {
    const char* name;    ///< with its unit
    std::size_t column;  ///< of the table
    double factor;       ///< from the table's unit to that of the name
    double published;    ///< of the dissertation's prototype, in the unit of the name
    int digits;
};

/// The columns of its table, by name.
namespace original_column {
enum : std::size_t {
    Volume,
    BoundsDrawn,
    Execution,
    ExecutionLower,
    ExecutionUpper,
    Rate,
    GlCalls,
    Cpu,
    Vertices,
    Build,
    Search,
    Exact,
    Candidates,
    SingleBuild,
    SingleSearch,
    SingleExact,
    SingleCandidates
};
}

/// `published` are the figures that the dissertation gives for its own prototype.
inline constexpr std::array<OriginalTest, 5> original_tests{
    {{"execution time of a frame [ms]", original_column::Execution, 1e3, 235.258, 4},
     {"frame rate [1/s]", original_column::Rate, 1, 22, 3},
     {"OpenGL calls a frame", original_column::GlCalls, 1, 15'000, 6},
     {"CPU use [%]", original_column::Cpu, 100, 34, 3},
     {"vertices a frame", original_column::Vertices, 1, 42'000, 6}}};

/// Quartiles over the cases of what a way has in a column; nothing where no case has it.
std::optional<Quartiles> original_figure(const std::vector<TableRow>& rows, const OriginalWay& way, std::size_t column);

/// Quartiles over all rows of a volume: drawing makes no difference to build and search, which are timed without.
/// @pre the volume has rows
Quartiles original_search_figure(const std::vector<TableRow>& rows, const std::string& volume, std::size_t column);

/// The ways in which the scene is run, in the order of table and chart.
const std::vector<OriginalWay>& original_ways();

}  // namespace drape
