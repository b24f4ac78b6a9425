#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "display.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/sim/scene.h"
#include "drape/sim/session.h"
#include "drape/sim/setting_table.h"
#include "fallback.h"
#include "options.h"
#include "window.h"

namespace drape {

namespace {

// How far freeglut got, for the moment when it cannot go on.
struct Progress {
    const Options& options;
    bool window_open = false;
};

// What freeglut says when it cannot go on. It must not return to freeglut.
[[noreturn]] void on_glut_error(const char* format, va_list values, void* user) {
    const Progress& progress = *static_cast<const Progress*>(user);
    std::array<char, 256> text{};
    std::vsnprintf(text.data(), text.size(), format, values);
    try {
        if (!progress.window_open) capture_instead(progress.options, text.data());
        std::cerr << "drape: " << text.data() << "\n";
    } catch (const std::exception& error) {
        std::cerr << "drape: " << error.what() << "\n";
    }
    std::exit(1);
}

// What a run starts from, checked as far as it can be without opening or writing anything.
struct Start {
    Options options;
    Settings settings;
    std::optional<Recording> replay;
};

Start make_start(Options options) {
    Start start{std::move(options), {}, {}};
    Options& wanted = start.options;
    if (!wanted.replay.empty()) {
        start.replay = read_recording(wanted.replay);
        if (wanted.scene.empty()) wanted.scene = start.replay->scene;
        wanted.assignments.insert(wanted.assignments.begin(), start.replay->assignments.begin(),
                                  start.replay->assignments.end());
    }
    if (wanted.scene.empty()) wanted.scene = scene_names().front();
    start.settings = load_scene(wanted.scene);
    for (const std::string& assignment : wanted.assignments) assign(start.settings, assignment);
    check(start.settings);
    return start;
}

int run(int argc, char** argv) {
    const std::optional<Options> options = read_options(argc, argv);
    if (!options) return 0;
    Start start = make_start(*options);
    const DisplayProbe probe;
    if (!probe.present()) capture_instead(*options, "there is no display");
    Progress progress{*options};
    glutInitErrorFuncUcall(on_glut_error, &progress);
    int no_words = 1;
    glutInit(&no_words, argv);

    const Options& wanted = start.options;
    Session session(Simulation(wanted.scene, std::move(start.settings)));
    Window window(session, wanted.width, wanted.height);
    progress.window_open = true;
    if (!wanted.record.empty()) session.record(wanted.record, wanted.assignments);
    if (start.replay) session.replay(std::move(*start.replay));
    const int code = window.run();
    session.close();
    if (wanted.hash) std::cout << hash_text(session.simulation().hash()) << "\n";
    return code;
}

}  // namespace

}  // namespace drape

int main(int argc, char** argv) {
    try {
        return drape::run(argc, argv);
    } catch (const drape::InputError& error) {
        std::cerr << "drape: " << error.what() << "\n";
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "drape: " << error.what() << "\n";
        return 1;
    }
}
