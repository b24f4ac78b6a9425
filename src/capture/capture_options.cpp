#include "capture.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/render/video_pipe.h"
#include "drape/scene/setting_table.h"

namespace drape {

namespace {

constexpr int most_frames = 1'000'000;
constexpr double lowest_fps = 1e-3, highest_fps = 1e5;

int whole_number(const std::string& option, const std::string& text, int most) {
    const auto number = parse_integer(text);
    if (!number || *number < 1 || *number > most) {
        throw InputError(option + " " + shortened(text) + ": allowed 1 to " + std::to_string(most));
    }
    return static_cast<int>(*number);
}

double frame_rate(const std::string& text) {
    const auto number = parse_real(text);
    if (!number || !(*number >= lowest_fps && *number <= highest_fps)) {
        throw InputError("--fps " + shortened(text) + ": allowed " + real_text(lowest_fps) +
                         " <= fps <= " + real_text(highest_fps));
    }
    return *number;
}

}  // namespace

std::optional<CaptureOptions> read_capture_options(int argc, char** argv) {
    CaptureOptions options;
    std::string frames, fps, size = "1280x720", every = "1", context = "auto";
    const auto contexts = names_of<ContextKind>();
    CommandLine line("drape-capture", "Draws a scene into numbered pictures, with no display.");
    add_start_options(line, options.start);
    line.option("--versus", options.start.versus, "compare the scene with itself under other settings",
                {"name=value,..."});
    line.option("--frames", frames, "number of frames; frame k shows the time k/fps after the start", {"N"});
    line.flag("--tour", options.tour, "draw a picture of each stop of the tour instead of a scene's frames");
    line.option("--fps", fps, "frames per simulated second; 60 / view.speed if not given", {"RATE"});
    line.option("--size", size, "of the pictures; 1280x720 if not given", {"WxH"});
    line.option("--out", options.out, "write frame_0001.png ... into this folder", {"DIR"});
    line.flag("--again", options.again, "replace the frames of an earlier run in that folder");
    line.option("--every", every, "draw frames K, 2K, 3K ... only", {"K"});
    line.option("--video", options.video, "make a video too, with ffmpeg", {"FILE.mp4"});
    line.option("--stats", options.stats, "write a row of figures for each drawn frame; its first line has the units",
                {"FILE.csv"});
    line.option("--state", options.state, "write every particle and ball at the end", {"FILE.csv"});
    line.flag("--overlay", options.overlay, "draw the stats panel, as the window does");
    line.option("--context", context, "what draws: osmesa, egl, or auto, which is egl only where osmesa is missing",
                {"NAME", false, {contexts.begin(), contexts.end()}});
    line.footer([] { return "Settings:\n" + settings_help(); });
    if (!line.parse(argc, argv)) return std::nullopt;

    const bool writes_more = !options.video.empty() || !options.stats.empty() || !options.state.empty() ||
                             !options.start.save.empty() || options.start.hash;
    options.size = parse_size(size);
    options.context = *value_named<ContextKind>(context);
    if (options.tour) {
        if (options.out.empty()) throw InputError("--tour needs --out DIR, for its pictures");
        if (!options.start.empty() || !frames.empty() || writes_more)
            throw InputError("--tour goes with --out, --size, --again, --overlay and --context only", line.help_hint());
        return options;
    }
    if (frames.empty()) throw InputError("--frames is required", line.help_hint());
    check_video_name("--video", options.video);
    options.frames = whole_number("--frames", frames, most_frames);
    options.every = whole_number("--every", every, options.frames);
    if (!fps.empty()) options.fps = frame_rate(fps);
    if (options.out.empty() && !writes_more) {
        throw InputError("nothing to write: say --out DIR, or one of --video, --stats, --state, --save and --hash");
    }
    return options;
}

}  // namespace drape
