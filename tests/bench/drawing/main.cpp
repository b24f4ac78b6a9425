// Says what a picture costs, in processor time: Drape's own code, which is drawn into a context that does nothing, and
// with Mesa's llvmpipe. Ways to draw take turns, picture by picture of the first second of `drop`, again and again.
// usage: bench_drawing [PICTURES]

#include <GL/glew.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "capture/gl_context.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/run_program.h"
#include "drape/render/camera.h"
#include "drape/render/renderer.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/session/comparison.h"
#include "drape/session/search_timer.h"
#include "drape/session/session.h"
#include "silent_context.h"

namespace drape {
namespace {

constexpr int width = 1280, height = 720;
constexpr double frame = 1.0 / 60, run_length = 1;  // s

/// A row of the table.
struct Way {
    const char* name;
    const char* changes;
    bool turns = false;  ///< the view
};

constexpr Way ways[] = {
    {"cloth and ball", "view.panel=off,view.grid=false"},
    {"with the grid on the ground", "view.panel=off"},
    {"cloth and ball (the view turns)", "view.panel=off,view.grid=false", true},
    {"with the grid on the ground (the view turns)", "view.panel=off", true},
    {"with the compact panel", "view.panel=compact"},
    {"with full panel and plots and hierarchy", "view.panel=full,view.plots=true,view.bounds=true,view.level=30"},
    {"with the settings panel too",
     "view.panel=full,view.plots=true,view.bounds=true,view.level=30,view.controls=true"},
};

double processor_time() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One way to draw, with what its pictures took.
class Drawing {
public:
    Drawing(const Way& way, const Settings& scene) : settings_(scene), camera_(scene.view), turns_(way.turns) {
        for (const std::string& change : split_assignments(way.changes)) assign(settings_, change);
        renderer_.resize(width, height);
        renderer_.panels().set_scene(scene);
    }

    void draw(FrameView view, const std::function<void()>& finish) {
        view.settings = &settings_;
        if (turns_) camera_.apply(command::Orbit{0.01, 0}, view);
        const double before = processor_time();
        if (settings_.view.panel != PanelSize::Off) view.search = search_timer_.look(view);
        renderer_.draw(view, camera_, {});
        renderer_.present(false);
        finish();
        milliseconds_.push_back(1e3 * (processor_time() - before));
    }

    [[nodiscard]] const std::vector<double>& milliseconds() const { return milliseconds_; }
    [[nodiscard]] double calls() const { return renderer_.report().gl_calls; }

private:
    Settings settings_;
    Camera camera_;
    bool turns_;
    Renderer renderer_;
    SearchTimer search_timer_;
    std::vector<double> milliseconds_;
};

/// What the ways took, one by one.
struct Costs {
    std::vector<std::vector<double>> milliseconds;
    std::vector<double> calls;
};

Costs draw_all(const GlContext& context, int pictures) {
    load_gl_functions(context);
    const auto gl_finish = reinterpret_cast<void (*)()>(context.function("glFinish"));
    const Settings scene = load_scene("drop");
    std::vector<std::unique_ptr<Drawing>> drawings;
    for (const Way& way : ways) drawings.push_back(std::make_unique<Drawing>(way, scene));
    Session session(Simulation("drop", scene));
    constexpr int warming = 10;  // pictures, before any counts
    int frames = 0;
    for (int picture = 0; picture < pictures + warming; ++picture) {
        // Each after a frame's steps, as in the window, and as often after another as before it
        for (const auto& drawing : drawings) {
            if (session.simulation().report().time > run_length) session.send(command::Reset{});
            session.run_until(++frames * frame);
            drawing->draw(session.view(), gl_finish);
        }
        std::ranges::reverse(drawings);
    }
    if ((pictures + warming) % 2 != 0) std::ranges::reverse(drawings);
    Costs costs;
    for (const auto& drawing : drawings) {
        const std::vector<double>& all = drawing->milliseconds();
        costs.milliseconds.emplace_back(all.begin() + warming, all.end());
        costs.calls.push_back(drawing->calls());
    }
    return costs;
}

// "q1,median,q3"
std::string quartiles(std::vector<double> values) {
    std::ranges::sort(values);
    const auto at = [&](double part) { return values[static_cast<std::size_t>(part * double(values.size() - 1))]; };
    return real_text(at(0.25), 3) + "," + real_text(at(0.5), 3) + "," + real_text(at(0.75), 3);
}

std::vector<double> differences(const std::vector<double>& with, const std::vector<double>& without) {
    std::vector<double> found(with.size());
    std::ranges::transform(with, without, found.begin(), std::minus<>());
    return found;
}

int run(int argc, char** argv) {
    const auto pictures = argc > 1 ? parse_integer(argv[1]) : 200;
    if (!pictures || *pictures < 1 || *pictures > 100'000) {
        throw InputError("PICTURES = '" + shortened(argv[1]) + "': allowed 1 to 100000");
    }
    const Costs own = draw_all({{}, silent_function}, static_cast<int>(*pictures));
    const Costs all = draw_all(make_context(), static_cast<int>(*pictures));
    std::cout << "what,calls,own_q1_ms,own_ms,own_q3_ms,all_q1_ms,all_ms,all_q3_ms\n";
    for (std::size_t w = 0; w < std::size(ways); ++w) {
        std::cout << ways[w].name << ',' << all.calls[w] << ',' << quartiles(own.milliseconds[w]) << ','
                  << quartiles(all.milliseconds[w]) << '\n';
    }
    for (const std::size_t with : {1, 3}) {
        const std::size_t without = with - 1;
        std::cout << "the grid alone" << (ways[with].turns ? " (the view turns)," : ",")
                  << all.calls[with] - all.calls[without] << ','
                  << quartiles(differences(own.milliseconds[with], own.milliseconds[without])) << ','
                  << quartiles(differences(all.milliseconds[with], all.milliseconds[without])) << '\n';
    }
    return Done;
}

}  // namespace
}  // namespace drape

int main(int argc, char** argv) { return drape::run_program("bench_drawing", argc, argv, drape::run); }
