#include "drape/sim/start.h"

#include <utility>

#include "drape/base/input_error.h"
#include "drape/sim/scene.h"
#include "drape/sim/setting_table.h"

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

}  // namespace

Start make_start(StartOptions options) {
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
    } catch (const InputError& error) {
        if (recorded > 0) blame(options.replay, [&] { check(of_recording); });
        throw InputError(std::string("--set: ") + error.what());
    }
    start.versus = std::move(options.versus);
    return start;
}

std::vector<NamedFile> input_files(const StartOptions& options, const Start& start) {
    constexpr auto read = NamedFile::Use::Read;
    return {{"SCENE", scene_file(start.scene), read},
            {"--replay", options.replay, read},
            {"start =", start.settings.start, read}};
}

Session make_session(Start start, const std::string& record) {
    Session session(Simulation(std::move(start.scene), std::move(start.settings)));
    if (!record.empty()) session.record(record, start.assignments);
    if (!start.versus.empty()) blame("--versus", [&] { session.send(command::Compare{start.versus}); });
    if (start.replay) session.replay(std::move(*start.replay));
    return session;
}

}  // namespace drape
