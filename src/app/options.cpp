#include "options.h"

#include "drape/base/program.h"
#include "drape/render/entries.h"
#include "drape/sim/scene.h"
#include "drape/sim/setting_table.h"

namespace drape {

namespace {

std::string key_help() {
    std::string text = "Keys and mouse:\n";
    for (const KeyHelp& line : help_lines(make_entries(scene_names()))) {
        text += "  " + line.key + std::string(line.key.size() < 27 ? 28 - line.key.size() : 1, ' ') + line.text + "\n";
    }
    return text;
}

}  // namespace

std::optional<Options> read_options(int argc, char** argv) {
    Options options;
    std::string size, scale;
    CLI::App app("A cloth, a ball and a hierarchy of bounding spheres, in a window.", "drape");
    app.add_option("scene", options.start.scene, "name of a shipped scene, or a TOML file")->type_name("SCENE");
    app.add_option("--set", options.start.assignments, "change settings")->type_name("name=value");
    app.add_option("--versus", options.start.versus, "compare the scene with itself under other settings")
        ->type_name("name=value,...");
    app.add_option("--record", options.record, "write every command to a file")->type_name("FILE");
    app.add_option("--replay", options.start.replay, "play a recording")->type_name("FILE");
    app.add_option("--size", size, "of the window; 1280x720 if not given")->type_name("WxH");
    app.add_option("--scale", scale, "text size factor; 1 if not given")->type_name("FACTOR");
    app.add_flag("--tour", options.tour, "begin with the tour: twelve scenes, with what to see in each");
    app.add_flag("--check", options.check, "end with exit code 1 at an OpenGL error or a position that is not finite");
    app.add_flag("--hash", options.hash, "print the hash of the last state");
    app.footer([] { return key_help() + "\nSettings:\n" + settings_help(); });
    if (!parse_command_line(app, argc, argv)) return std::nullopt;
    const StartOptions& start = options.start;
    if (options.tour &&
        !(start.scene.empty() && start.assignments.empty() && start.replay.empty() && start.versus.empty())) {
        throw InputError("--tour has scenes and settings of its own: leave out SCENE, --set, --versus and --replay",
                         help_hint(app));
    }
    if (!scale.empty()) options.start.assignments.push_back("view.text_scale=" + scale);
    if (!size.empty()) options.size = parse_size(size);
    return options;
}

}  // namespace drape
