// The state in a snapshot, after the lines that name its scene: read, gone on from, written, read again.

#include "drape/sim/snapshot.h"

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "fuzz/small_run.h"
#include "fuzz/target.h"

using namespace drape;

namespace {

std::string snapshot_of(Simulation& simulation) {
    std::ostringstream out;
    write_snapshot(out, simulation);
    return out.str();
}

/// Small cloths: under balls, with themselves, and beside solids without a ground.
struct Scene {
    const char* name;
    std::vector<std::string> changes;
};

std::string head_of(const Scene& scene) {
    Settings settings = load_scene(scene.name);
    for (const std::string& change : scene.changes) assign(settings, change);
    Simulation simulation(scene.name, std::move(settings));
    const std::string text = snapshot_of(simulation);
    return text.substr(0, text.find('\n', text.find("\nsettings ") + 1) + 1);
}

std::vector<std::string> heads() {
    const Scene scenes[] = {{"three_balls", {"cloth.particles=3,3", "solver.ledger=true", "solver.integrator=bdf2"}},
                            {"fold", {"cloth.particles=3,3"}},
                            {"table", {"cloth.particles=3,3", "ground.solid=false"}}};
    std::vector<std::string> heads;
    for (const Scene& scene : scenes) heads.push_back(head_of(scene));
    return heads;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // The first character says which
    static const std::vector<std::string> known = heads();
    if (size == 0) return 0;
    std::istringstream in(known[data[0] % known.size()] + std::string(fuzz::text_of(data + 1, size - 1)));
    std::optional<Simulation> simulation;
    if (!fuzz::accepts([&] { simulation = read_snapshot(in, "fuzz.snapshot"); })) return 0;
    const std::string text = snapshot_of(*simulation);
    std::istringstream written(text);
    Simulation again = read_snapshot(written, "again.snapshot");
    fuzz::require(snapshot_of(again) == text, "a snapshot that was written reads the same");
    fuzz::accepts([&] {
        fuzz::step_a_little(*simulation);
        simulation->apply(command::Reset{});
        fuzz::step_a_little(*simulation);
    });
    return 0;
}
