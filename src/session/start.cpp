#include "drape/session/start.h"

#include <utility>

#include "drape/base/input_error.h"
#include "drape/base/run_program.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/snapshot.h"

namespace drape {
namespace {

/// Does something whose mistakes are those of a place.
template <class Work>
void blame(const std::string& place, Work work) {
    try {
        work();
    } catch (const InputError& error) {
        throw InputError(place + ": " + error.what());
    } catch (const RunError& error) {
        throw RunError(place + ": " + error.what());
    }
}

/// From a snapshot, under other settings.
Start start_from_snapshot(StartOptions options) {
    if (!(options.scene.empty() && options.replay.empty() && options.versus.empty())) {
        throw InputError(
            "--load has a scene of its own, in the middle of a run: leave out SCENE, --replay and --versus");
    }
    SnapshotHead head = read_snapshot_head(options.load);
    // One by one, as they will be carried out
    for (const std::string& assignment : options.assignments) {
        const Settings before = head.settings;
        assign_all(head.settings, {&assignment, 1});
        blame("--set " + shortened(assignment), [&] { check(head.settings); });
        if (same_start(before, head.settings)) continue;
        throw InputError("--set " + shortened(assignment) +
                         ": allowed with --load only what does not begin the scene again");
    }
    return {.scene = std::move(head.scene),
            .assignments = std::move(options.assignments),
            .settings = std::move(head.settings),
            .replay = {},
            .load = std::move(options.load)};
}

}  // namespace

Start make_start(StartOptions options) {
    if (!options.load.empty()) return start_from_snapshot(std::move(options));
    Start start{.scene = std::move(options.scene), .assignments = {}, .settings = {}, .replay = {}};
    bool scene_given = !start.scene.empty();
    if (!options.replay.empty()) {
        start.replay = read_recording(options.replay);
        if (start.scene.empty()) start.scene = start.replay->scene;
        start.assignments = start.replay->assignments;
    }
    const std::size_t recorded = start.assignments.size();
    for (std::string& word : options.assignments) {
        const bool is_scene = !scene_given && word.find('=') == std::string::npos;
        if (is_scene) {
            start.scene = std::move(word);
            scene_given = true;
        } else {
            start.assignments.push_back(std::move(word));
        }
    }
    if (start.scene.empty()) start.scene = scene_names().front();
    start.settings = load_scene(start.scene);
    for (std::size_t k = 0; k < recorded; ++k) {
        blame(options.replay + ":" + std::to_string(Recording::first_assignment + k),
              [&] { assign(start.settings, start.assignments[k]); });
    }
    const Settings of_recording = start.settings;
    assign_all(start.settings, std::span(start.assignments).subspan(recorded));
    try {
        check(start.settings);
    } catch (const InputError&) {
        if (recorded > 0) blame(options.replay, [&] { check(of_recording); });
        blame("--set", [&] { check(start.settings); });
    }
    start.versus = std::move(options.versus);
    return start;
}

void check_written(const StartOptions& options, const Start& start, const std::vector<NamedFile>& written) {
    constexpr auto read = NamedFile::Use::Read;
    std::vector<NamedFile> files{{"SCENE", scene_file(start.scene), read},
                                 {"--replay", options.replay, read},
                                 {"--load", options.load, read},
                                 {"start =", start.settings.start, read}};
    files.insert(files.end(), written.begin(), written.end());
    check_apart(files);
}

Session make_session(Start start, const std::optional<std::string>& record) {
    const bool loads = !start.load.empty();
    Session session(loads ? read_snapshot(start.load) : Simulation(std::move(start.scene), std::move(start.settings)));
    const std::vector<std::string> changes = loads ? std::exchange(start.assignments, {}) : std::vector<std::string>();
    if (record) session.record(*record, start.assignments, start.load);
    for (const std::string& change : changes) session.send(command::Set{change});
    if (!start.versus.empty()) {
        blame("--versus", [&] { session.send(command::Compare{start.versus}); });
        // A colour that was asked for stays
        for (const std::string& change : start.assignments) {
            const Setting& setting = setting_meant_by(change.substr(0, change.find('=')));
            if (&setting == &find_setting("view.colour")) session.send(command::Set{change});
        }
    }
    if (start.replay) session.replay(std::move(*start.replay));
    return session;
}

void save_snapshot(const std::string& file, Simulation& simulation) {
    if (file.empty()) return;
    if (simulation.report().status == Status::Ok) return write_snapshot(file, simulation);
    tell("no snapshot is written of a run that has diverged");
}

}  // namespace drape
