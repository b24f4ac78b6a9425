// The quadtree on a large cloth draped over a ball, a tenth of its triangles touched. `ns_per_triangle` is of all
// triangles of the cloth; `touched` is the share that the exact test finds.

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "drape/bounds/broad_phase.h"
#include "drape/contact/contact.h"

namespace {

using drape::Real;

/// A square sheet of side 1 over a ball: the cap follows the ball, the rest falls away in folds.
struct DrapedSheet {
    drape::Grid grid;
    drape::Points x;
    drape::Ball ball;

    explicit DrapedSheet(int side) : grid{side, side}, x(grid.particles(), 3) {
        ball.radius = Real(0.3);
        const Real cap = std::sqrt(Real(0.1) / std::numbers::pi_v<Real>);  // arc within which a tenth of the area lies
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                const Real u = static_cast<Real>(i) / static_cast<Real>(side - 1) - Real(0.5);
                const Real w = static_cast<Real>(j) / static_cast<Real>(side - 1) - Real(0.5);
                const Real arc = std::hypot(u, w), angle = arc / ball.radius, turn = std::atan2(w, u);
                const Real lift = arc < cap ? Real(0) : Real(0.2) * (arc - cap) * (Real(1.5) + std::sin(8 * turn));
                const Real r = ball.radius + lift;
                x.row(grid.particle(i, j)) << r * std::sin(angle) * std::cos(turn), r * std::cos(angle),
                    r * std::sin(angle) * std::sin(turn);
            }
        }
        ball.radius += Real(1e-4);
    }
};

void per_triangle(benchmark::State& state, const drape::Grid& grid) {
    state.counters["per_triangle"] =
        benchmark::Counter(static_cast<double>(grid.triangles()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void sphere_rebuild(benchmark::State& state) {
    const DrapedSheet sheet(static_cast<int>(state.range(0)));
    const auto tree = drape::make_broad_phase({}, sheet.grid);
    for (auto _ : state) tree->build(sheet.x);
    per_triangle(state, sheet.grid);
}

void sphere_query(benchmark::State& state) {
    const DrapedSheet sheet(static_cast<int>(state.range(0)));
    const auto tree = drape::make_broad_phase({}, sheet.grid);
    drape::Candidates found;
    std::vector<int> triangles;
    tree->build(sheet.x);
    for (auto _ : state) benchmark::DoNotOptimize(tree->query(sheet.ball, found));
    drape::find_touched_triangles(sheet.grid, sheet.x, sheet.ball, 0, found.cells, triangles);
    state.counters["touched"] = static_cast<double>(triangles.size()) / sheet.grid.triangles();
    state.counters["candidates"] = static_cast<double>(found.cells.size()) / sheet.grid.cells();
    per_triangle(state, sheet.grid);
}

/// The query and the exact test of its candidates: down to the touched triangles.
void sphere_query_exact(benchmark::State& state) {
    const DrapedSheet sheet(static_cast<int>(state.range(0)));
    const auto tree = drape::make_broad_phase({}, sheet.grid);
    drape::Candidates found;
    std::vector<int> triangles;
    tree->build(sheet.x);
    for (auto _ : state) {
        tree->query(sheet.ball, found);
        drape::find_touched_triangles(sheet.grid, sheet.x, sheet.ball, 0, found.cells, triangles);
    }
    per_triangle(state, sheet.grid);
}

}  // namespace

BENCHMARK(sphere_rebuild)->Arg(30)->Arg(128)->Arg(512)->Unit(benchmark::kMicrosecond);
BENCHMARK(sphere_query)->Arg(30)->Arg(128)->Arg(512)->Unit(benchmark::kMicrosecond);
BENCHMARK(sphere_query_exact)->Arg(30)->Arg(128)->Arg(512)->Unit(benchmark::kMicrosecond);
