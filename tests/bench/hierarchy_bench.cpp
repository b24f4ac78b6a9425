// The hierarchy on a large cloth in waves, of which a ball cuts a tenth out. `per_triangle` is of all triangles of the
// cloth. Ratios are to be taken within one run: against `brute_force`, which tests every cell with the same vectorised
// test as the tree's candidates.

#include <benchmark/benchmark.h>

#include <string>

#include "bench/cut_sheet.h"
#include "drape/bounds/cloth_quadtree.h"
#include "drape/contact/detection.h"

namespace drape::bench {
namespace {

void per_triangle(benchmark::State& state, const Grid& grid) {
    state.counters["per_triangle"] =
        benchmark::Counter(static_cast<double>(grid.triangles()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void build(benchmark::State& state, int side, const BroadPhaseParameters& parameters) {
    const CutSheet sheet(side);
    const auto tree = make_broad_phase(parameters, sheet.grid);
    for (auto _ : state) tree->build(sheet.x);
    per_triangle(state, sheet.grid);
}

/// Down to the touched triangles.
void query(benchmark::State& state, int side, const BroadPhaseParameters& parameters, bool with_build) {
    const CutSheet sheet(side);
    const auto tree = make_broad_phase(parameters, sheet.grid);
    Candidates found;
    std::vector<int> triangles;
    tree->build(sheet.x);
    TraversalStats stats;
    for (auto _ : state) {
        if (with_build) tree->build(sheet.x);
        stats = tree->query(sheet.ball, found);
        find_touched_triangles(sheet.grid, sheet.x, sheet.ball, 0, found.cells, triangles, Kernels::Vector);
    }
    state.counters["touched"] = static_cast<double>(triangles.size()) / sheet.grid.triangles();
    state.counters["candidates"] = static_cast<double>(stats.candidates) / sheet.grid.cells();
    state.counters["tests"] = static_cast<double>(stats.volume_tests);
    per_triangle(state, sheet.grid);
}

void register_all() {
    const auto add = [](const std::string& name, auto run) {
        benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMicrosecond);
    };
    for (const int side : {32, 128, 512, 1024}) {
        const std::string size = "/" + std::to_string(side);
        add("brute_force" + size,
            [side](benchmark::State& state) { query(state, side, {.volume = VolumeKind::Brute}, false); });
        for (std::size_t v = 0; v + 1 < names_of<VolumeKind>().size(); ++v) {
            for (const int leaf : {4, 7, 8, 11, 15, 16, 23, 31}) {
                const std::string volume = "/" + names_of<VolumeKind>()[v] + size + "/leaf:" + std::to_string(leaf);
                BroadPhaseParameters parameters{.volume = static_cast<VolumeKind>(v), .leaf_cells = leaf};
                for (std::size_t u = 0; u < names_of<UpdateKind>().size(); ++u) {
                    parameters.update = static_cast<UpdateKind>(u);
                    add(names_of<UpdateKind>()[u] + volume,
                        [=](benchmark::State& state) { build(state, side, parameters); });
                }
                parameters.update = UpdateKind::Merge;
                add("query" + volume, [=](benchmark::State& state) { query(state, side, parameters, false); });
                add("merge_query" + volume, [=](benchmark::State& state) { query(state, side, parameters, true); });
            }
        }
    }
}

const bool registered = (register_all(), true);

}  // namespace
}  // namespace drape::bench
