// The hierarchy on a large cloth of which a ball touches a tenth: a sheet in waves that the ball cuts, and one draped
// over the ball, so closely that most of it is near. `per_triangle` is of all
// triangles of the cloth. Ratios are to be taken within one run: against `read_pass`, which only reads the positions,
// and against `brute_force`, which tests every cell with the same vectorised test as the tree's candidates.

#include <benchmark/benchmark.h>

#include <string>

#include "bench/draped_sheet.h"
#include "drape/bounds/cloth_quadtree.h"
#include "drape/contact/detection.h"

namespace {

using drape::BroadPhaseParameters;
using drape::bench::CutSheet;
using drape::bench::DrapedSheet;

void per_triangle(benchmark::State& state, const drape::Grid& grid) {
    state.counters["per_triangle"] =
        benchmark::Counter(static_cast<double>(grid.triangles()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Smallest and largest coordinates: what reading the positions costs.
void read_pass(benchmark::State& state, int side) {
    const DrapedSheet sheet(side);
    const int n = sheet.grid.particles();
    const drape::Patch all{sheet.x.col(0).data(), sheet.x.col(1).data(), sheet.x.col(2).data(), n, 1, n};
    for (auto _ : state) benchmark::DoNotOptimize(drape::fits_of<drape::Aabb>({}).patch(all));
    per_triangle(state, sheet.grid);
}

void build(benchmark::State& state, int side, const BroadPhaseParameters& parameters) {
    const DrapedSheet sheet(side);
    const auto tree = drape::make_broad_phase(parameters, sheet.grid);
    for (auto _ : state) tree->build(sheet.x);
    per_triangle(state, sheet.grid);
}

/// Down to the touched triangles.
template <class Sheet>
void query(benchmark::State& state, int side, const BroadPhaseParameters& parameters, bool with_build) {
    const Sheet sheet(side);
    const auto tree = drape::make_broad_phase(parameters, sheet.grid);
    drape::Candidates found;
    std::vector<int> triangles;
    tree->build(sheet.x);
    drape::TraversalStats stats;
    for (auto _ : state) {
        if (with_build) tree->build(sheet.x);
        stats = tree->query(sheet.ball, found);
        drape::find_touched_triangles(sheet.grid, sheet.x, sheet.ball, 0, found.cells, triangles,
                                      drape::Kernels::Vector);
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
        add("read_pass" + size, [side](benchmark::State& state) { read_pass(state, side); });
        add("brute_force/cut" + size, [side](benchmark::State& state) {
            query<CutSheet>(state, side, {.volume = drape::VolumeKind::Brute}, false);
        });
        add("brute_force/draped" + size, [side](benchmark::State& state) {
            query<DrapedSheet>(state, side, {.volume = drape::VolumeKind::Brute}, false);
        });
        for (std::size_t v = 0; v + 1 < drape::names_of<drape::VolumeKind>().size(); ++v) {
            for (const int leaf : {4, 7, 8, 11, 15, 16, 23, 31}) {
                const std::string volume =
                    drape::names_of<drape::VolumeKind>()[v] + size + "/leaf:" + std::to_string(leaf);
                for (std::size_t u = 0; u < drape::names_of<drape::UpdateKind>().size(); ++u) {
                    const BroadPhaseParameters parameters{.volume = static_cast<drape::VolumeKind>(v),
                                                          .update = static_cast<drape::UpdateKind>(u),
                                                          .leaf_cells = leaf};
                    add(drape::names_of<drape::UpdateKind>()[u] + "/" + volume,
                        [=](benchmark::State& state) { build(state, side, parameters); });
                }
                const BroadPhaseParameters merged{.volume = static_cast<drape::VolumeKind>(v),
                                                  .update = drape::UpdateKind::Merge,
                                                  .leaf_cells = leaf};
                for (const bool build : {false, true}) {
                    const std::string what = build ? "merge_query" : "query";
                    add(what + "/cut/" + volume,
                        [=](benchmark::State& state) { query<CutSheet>(state, side, merged, build); });
                    add(what + "/draped/" + volume,
                        [=](benchmark::State& state) { query<DrapedSheet>(state, side, merged, build); });
                }
            }
        }
    }
}

const bool registered = (register_all(), true);

}  // namespace
