#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>

#include <cstdarg>
#include <cstdio>
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

// What freeglut says when it cannot go on. It must not return to freeglut.
[[noreturn]] void on_glut_error(const char* format, va_list values, void* user) {
    char text[256];
    std::vsnprintf(text, sizeof text, format, values);
    try {
        capture_instead(*static_cast<const Options*>(user), text);
    } catch (const std::exception& error) {
        std::cerr << "drape: " << error.what() << "\n";
        std::exit(1);
    }
}

Session make_session(Options& options) {
    std::optional<Recording> replay;
    if (!options.replay.empty()) {
        replay = read_recording(options.replay);
        if (options.scene.empty()) options.scene = replay->scene;
        options.assignments.insert(options.assignments.begin(), replay->assignments.begin(), replay->assignments.end());
    }
    if (options.scene.empty()) options.scene = scene_names().front();
    Settings settings = load_scene(options.scene);
    for (const std::string& assignment : options.assignments) assign(settings, assignment);
    Session session(Simulation(options.scene, std::move(settings)));
    if (!options.record.empty()) session.record(options.record, options.assignments);
    if (replay) session.replay(std::move(*replay));
    return session;
}

int run(int argc, char** argv) {
    const std::optional<Options> read = read_options(argc, argv);
    if (!read) return 0;
    Options options = *read;
    // Bad input is told before anything opens.
    if (!display_present()) capture_instead(options, "there is no display");
    Session session = make_session(options);
    glutInitErrorFuncUcall(on_glut_error, const_cast<Options*>(&*read));
    int no_words = 1;
    glutInit(&no_words, argv);
    Window window(session, options.width, options.height);
    const int code = window.run();
    session.close();
    if (options.hash) std::cout << hash_text(session.simulation().hash()) << "\n";
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
