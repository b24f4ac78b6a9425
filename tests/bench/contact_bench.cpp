// The contacts of a sheet that is draped over a ball, from all its cells, by both kernels, and those of as many
// particles with the ground.

#include <benchmark/benchmark.h>

#include <string>

#include "bench/draped_sheet.h"
#include "drape/contact/detection.h"

namespace {

using drape::bench::DrapedSheet;

void ball_contacts(benchmark::State& state, int side, drape::Kernels kernels) {
    const DrapedSheet sheet(side);
    std::vector<drape::CellRun> cells;
    drape::list_all_cells(sheet.grid, cells);
    std::vector<drape::ContactRow> contacts;
    for (auto _ : state) {
        contacts.clear();
        drape::find_contacts({sheet.grid, sheet.x, sheet.x}, sheet.ball, {}, cells, contacts, kernels);
    }
    state.counters["contacts"] = static_cast<double>(contacts.size());
}

void ground_contacts(benchmark::State& state, int side) {
    const DrapedSheet sheet(side);
    drape::Points x = sheet.x;
    std::vector<drape::ContactRow> contacts;
    const drape::Real height = sheet.ball.radius * drape::Real(0.85);  // under the cap
    x.col(1) = -x.col(1);
    std::vector<drape::CellRun> cells;
    drape::list_all_cells(sheet.grid, cells);
    for (auto _ : state) {
        contacts.clear();
        drape::find_ground_contacts({sheet.grid, x, x}, -height, {}, cells, contacts);
    }
    state.counters["contacts"] = static_cast<double>(contacts.size());
}

void register_all() {
    for (const int side : {30, 128, 512}) {
        const auto add = [side](const std::string& name, auto run) {
            benchmark::RegisterBenchmark((name + "/side:" + std::to_string(side)).c_str(), run)
                ->Unit(benchmark::kMicrosecond);
        };
        for (const auto kernels : {drape::Kernels::Plain, drape::Kernels::Vector}) {
            add("ball_contacts/" + drape::names_of<drape::Kernels>()[static_cast<std::size_t>(kernels)],
                [=](benchmark::State& state) { ball_contacts(state, side, kernels); });
        }
        add("ground_contacts", [side](benchmark::State& state) { ground_contacts(state, side); });
    }
}

const bool registered = (register_all(), true);

}  // namespace
