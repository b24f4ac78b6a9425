#include "drape/sim/snapshot.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"
#include "drape/base/output_file.h"
#include "drape/base/snapshot_text.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"

namespace drape {
namespace {

/// The first lines, which name the scene.
void exchange_scene(SnapshotText& text, std::string& scene, std::vector<std::string>& changes, std::string& hash) {
    int version = 1;
    std::size_t size = sizeof(Real);
    text.line("drape-snapshot", within(version, 1, 1), within(size, sizeof(Real), sizeof(Real)));
    text.text("scene", scene);
    constexpr double max_changes = 10'000;
    text.entries("changes", changes, max_changes, [&](std::string& change) { text.text("set", change); });
    text.text("settings", hash);
}

/// What tells whether a scene is still the same, with the files that it names.
std::string hash_of(const Settings& settings) {
    std::uint64_t hash = fnv1a(scene_text(settings));
    if (!settings.start.empty()) hash = fnv1a(read_text(settings.start), hash);
    for (const SolidSettings& solid : settings.solids) {
        if (!solid.file.empty()) hash = fnv1a(read_text(solid.file), hash);
    }
    return hash_text(hash);
}

SnapshotHead read_head(SnapshotText& text) {
    SnapshotHead head;
    std::vector<std::string> changes;
    std::string hash;
    exchange_scene(text, head.scene, changes, hash);
    try {
        head.settings = load_scene(head.scene);
        for (const std::string& change : changes) assign(head.settings, change);
        check(head.settings);
    } catch (const InputError& error) {
        text.refuse(std::string("settings that can be made again: ") + error.what());
    }
    if (hash != hash_of(head.settings))
        text.refuse("the scene '" + head.scene + "' as it was, but it has changed since");
    return head;
}

}  // namespace

void write_snapshot(std::ostream& out, Simulation& simulation) {
    const StepReport& report = simulation.report();
    if (report.status != Status::Ok) throw RunError("no snapshot of a run that has ended: " + report.error);
    std::string scene = simulation.scene(), hash = hash_of(simulation.settings());
    std::vector<std::string> changes = changes_of(load_scene(scene), simulation.settings());
    SnapshotText text(out);
    exchange_scene(text, scene, changes, hash);
    simulation.exchange(text);
}

void write_snapshot(const std::string& file, Simulation& simulation) {
    OutputFile out(file);
    write_snapshot(out.stream(), simulation);
    out.close();
}

Simulation read_snapshot(std::istream& in, const std::string& file) {
    SnapshotText text(in, file);
    SnapshotHead head = read_head(text);
    Simulation simulation(std::move(head.scene), std::move(head.settings));
    simulation.exchange(text);
    return simulation;
}

Simulation read_snapshot(const std::string& file) {
    InputFile in(file, UINTMAX_MAX, InputKind::Regular);
    return read_snapshot(in, file);
}

SnapshotHead read_snapshot_head(const std::string& file) {
    InputFile in(file, UINTMAX_MAX, InputKind::Regular);
    SnapshotText text(in, file);
    return read_head(text);
}

}  // namespace drape
