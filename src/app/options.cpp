#include "options.h"

#include <algorithm>

#include "drape/render/entries.h"
#include "drape/scene/setting_table.h"

namespace drape {

namespace {

// Scenes share one line whichever they are, so help needs none of their files
std::string key_help() {
    const char* any_scene = "veil";
    std::string text = "Keys and mouse:\n";
    for (const KeyHelp& line : help_lines(make_entries({any_scene}), true)) {
        std::string left = line.is_heading() ? "  " + line.text + ":" : "    " + line.key;
        if (!line.is_heading()) left.resize(std::max<std::size_t>(left.size() + 1, 30), ' ');
        text += left + (line.is_heading() ? "" : line.text) + "\n";
    }
    return text;
}

}  // namespace

std::optional<Options> read_options(int argc, char** argv) {
    Options options;
    std::string size, scale;
    CommandLine line("drape", "A cloth, a ball and a hierarchy of bounding spheres, in a window.");
    add_start_options(line, options.start);
    line.option("--versus", options.start.versus, "compare the scene with itself under other settings",
                {"name=value,..."});
    line.option("--record", options.record, "write every command to a file", {"FILE"});
    line.option("--size", size,
                "of the window; as it was last if not given; 1280x720 at first, larger on a dense display", {"WxH"});
    line.option("--scale", scale, "text size factor; 1 if not given", {"FACTOR"});
    line.flag("--tour", options.tour, "begin with the tour, and what to see at each stop");
    line.flag("--check", options.check, "end with exit code 1 at an OpenGL error or a position that is not finite");
    line.footer([] { return key_help() + "\nSettings:\n" + settings_help(); });
    if (!line.parse(argc, argv)) return std::nullopt;
    if (options.tour && !options.start.empty()) {
        throw InputError(
            "--tour has scenes and settings of its own: leave out SCENE, --set, --versus, --replay and --load",
            line.help_hint());
    }
    if (!scale.empty()) options.start.assignments.push_back("view.text_scale=" + scale);
    if (!size.empty()) options.size = parse_size(size);
    return options;
}

}  // namespace drape
