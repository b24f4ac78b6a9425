#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <vector>

#include "display.h"
#include "drape/base/child_program.h"
#include "drape/base/numbers.h"
#include "drape/base/resources.h"
#include "drape/base/run_program.h"
#include "drape/base/stop_signals.h"
#include "drape/session/tour.h"
#include "options.h"
#include "window.h"

namespace drape {
namespace {

/// Says in one line why there is no window, and becomes `drape-capture` of the same scene.
/// @throws RunError if that program is not beside this one
[[noreturn]] void capture_instead(const Options& options, const std::string& reason) {
    const std::size_t frames = options.tour ? tour_stops().size() : 120;
    const std::string program = (program_folder() / "drape-capture").string();
    const std::string out = std::filesystem::absolute("drape-frames").string();
    const std::string size = size_text(options.size.value_or(PictureSize{}));
    std::vector<std::string> words{program};
    if (options.tour) {
        words.emplace_back("--tour");
    } else {
        if (!options.start.scene.empty()) words.push_back(options.start.scene);
        for (const std::string& setting : options.start.assignments) words.insert(words.end(), {"--set", setting});
        if (!options.start.versus.empty()) words.insert(words.end(), {"--versus", options.start.versus});
        if (!options.start.replay.empty()) words.insert(words.end(), {"--replay", options.start.replay});
        if (!options.start.load.empty()) words.insert(words.end(), {"--load", options.start.load});
        if (!options.start.save.empty()) words.insert(words.end(), {"--save", options.start.save});
        if (options.start.hash) words.emplace_back("--hash");
        words.insert(words.end(), {"--frames", std::to_string(frames)});
    }
    words.insert(words.end(), {"--size", size, "--out", out, "--again"});

    tell("drape: " + reason + "; drawing " + std::to_string(frames) + " pictures into " + out + " instead" +
         (std::filesystem::exists(out) ? ", in place of those that are there" : "") +
         (options.record.empty() ? "" : " (nothing is recorded)") +
         (options.tour && options.start.hash ? " (a tour has no hash)" : ""));
    become_program(std::move(words));
}

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
        tell(std::string("drape: ") + text.data());
    } catch (const std::exception& error) {
        tell(std::string("drape: ") + error.what());
    }
    std::exit(1);
}

int run(int argc, char** argv) {
    const std::optional<Options> options = read_options(argc, argv);
    if (!options) return Done;
    const StopSignals signals;
    Start start = make_start(options->start);
    check_written(options->start, start, {{"--record", options->record}, {"--save", options->start.save}});
    const std::shared_ptr<void> display = open_display();
    if (!display) capture_instead(*options, "there is no display");
    Progress progress{*options};
    glutInitErrorFuncUcall(on_glut_error, &progress);
    int no_words = 1;
    glutInit(&no_words, argv);

    Session session = make_session(std::move(start), options->record);
    // Whoever held the ball or the cloth then holds it no longer
    if (!options->start.load.empty()) {
        for (const Command& command : session.simulation().commands_to_let_go()) session.send(command);
    }
    if (const std::string notice = session.record_notice(); !notice.empty()) tell("drape: " + notice);
    const std::string warning = session.simulation().step_warning();
    if (!warning.empty()) tell("warning: " + warning);
    Window window(session, *options, signals);
    progress.window_open = true;
    const int code = window.run();
    session.close();
    save_snapshot(options->start.save, session.simulation());
    if (options->start.hash) std::cout << hash_text(session.simulation().hash()) << "\n";
    return code == Done && session.replay_differs() ? Failed : code;
}

}  // namespace
}  // namespace drape

int main(int argc, char** argv) { return drape::run_program("drape", argc, argv, drape::run); }
