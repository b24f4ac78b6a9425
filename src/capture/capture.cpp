#include "capture.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "drape/base/input_error.h"
#include "drape/base/memory_limit.h"
#include "drape/base/numbers.h"
#include "drape/base/output_file.h"
#include "drape/base/progress.h"
#include "drape/base/run_program.h"
#include "drape/render/entries.h"
#include "drape/render/renderer.h"
#include "drape/render/video_pipe.h"
#include "drape/scene/memory.h"
#include "drape/scene/scene.h"
#include "drape/session/failure.h"
#include "drape/session/session.h"
#include "drape/session/state_csv.h"
#include "drape/session/tour.h"
#include "frame_writer.h"
#include "gl_context.h"

namespace drape {

namespace {

/// To be called before there is a context: a drawing library that finds too little memory ends the whole program.
/// @param scene what a simulation takes on top [bytes]
/// @throws RunError that says what pictures need, where this machine, the process's control group or `ulimit -v` allows
///         less
void check_picture_memory(PictureSize size, double scene = 0) {
    // Measured with Mesa 22.3 and LLVM 15: addresses of program, libraries and what they compile, and of the stack and
    // the heap of each thread that draws, of which llvmpipe has at most 32; memory in use; both for a pixel
    constexpr double addresses = 600e6, of_thread = 72e6, most_threads = 32, in_use = 120e6, of_pixel = 60;
    const double threads = std::min(static_cast<double>(std::thread::hardware_concurrency()), most_threads);
    const double pixels = of_pixel * size.width * size.height + scene;
    const auto check = [](double need, double limit, std::string_view whose) {
        if (need <= limit) return;
        throw RunError("out of memory: pictures of this size and scene need about " + bytes_text(need) + ", and " +
                       bytes_text(limit) + " is " + std::string(whose));
    };
    const MemoryLimit limit = memory_limit();
    check(in_use + pixels, limit.bytes, limit.whose);
    if (const auto space = address_space_limit()) {
        check(addresses + threads * of_thread + pixels, *space, "what this process may take (ulimit -v)");
    }
}

/// A start none of whose files is to be written, and for whose pictures there is memory.
Start checked_start(const CaptureOptions& options) {
    Start start = make_start(options.start);
    const double simulations = options.start.versus.empty() ? 1 : 2;
    if (options.drawing()) check_picture_memory(options.size, simulations * memory_needed(start.settings));
    const std::vector<NamedFile> written{{"--video", options.video},
                                         {"--stats", options.stats},
                                         {"--state", options.state},
                                         {"--save", options.start.save}};
    check_written(options.start, start, written);
    for (const NamedFile& file : written) {
        if (options.out.empty() || file.path.empty() || !FrameWriter::is_frame(options.out, file.path)) continue;
        throw InputError(file.option + " " + file.path.string() + ": allowed any file but a frame of --out");
    }
    return start;
}

/// One run of `drape-capture`.
class Capture {
public:
    /// @param signals that end it between two steps
    Capture(CaptureOptions options, const StopSignals& signals)
        : signals_(signals),
          options_(std::move(options)),
          session_(make_session(checked_start(options_))),
          camera_(session_.simulation().settings().view),
          stats_(options_.stats),
          state_(options_.state),
          progress_(static_cast<std::size_t>(options_.frames / options_.every), "picture") {
        // A scene in slow motion has more frames, which a video shows as slowly as a window does
        constexpr double display_rate = 60;
        const double video_rate = options_.fps.value_or(display_rate) / options_.every;
        frame_rate_ = options_.fps.value_or(display_rate / session_.simulation().settings().view.speed);
        if (!options_.out.empty()) frames_.emplace(options_.out, options_.frames, options_.again);
        if (!options_.video.empty()) {
            video_.emplace(options_.video, options_.size, video_rate, signals_);
            if (!video_->error().empty() && !frames_) throw RunError(video_->error());
        }
        if (stats_.wanted()) {
            columns_.push_back({"frame", "", [this](const FrameView&) { return std::to_string(frame_); }});
            add_report_columns(columns_);
            for (const FrameField& field : frame_fields) {
                columns_.push_back({std::string(field.name), std::string(field.unit), [this, &field](const FrameView&) {
                                        return real_text(field.read(renderer_->report()));
                                    }});
            }
            add_ball_columns(columns_, session_.simulation().balls().size());
            write_stats_head(stats_.stream(), columns_);
        }
        if (options_.drawing()) {
            context_ = make_context(options_.context);
            renderer_ = std::make_unique<Renderer>();
            renderer_->resize(options_.size.width, options_.size.height);
            start_scene();
            // The panel shows what the frame before cost, and the first picture shall have one
            if (options_.overlay) draw();
        }
    }

    int run() {
        int exit_code = Done;
        // A loaded state may have been in danger before
        const Simulation& simulation = session_.simulation();
        for (const std::string& warning : {simulation.step_warning(), simulation.crossing_warning()}) {
            if (!warning.empty()) tell("warning: " + warning);
        }
        for (frame_ = 1; frame_ <= options_.frames && exit_code == Done; ++frame_) {
            const double time = session_.start_time() + frame_ / frame_rate_;
            const bool whole = session_.run_until(time, [this] { return signals_.arrived() != 0; });
            for (const News& news : session_.take_news()) {
                if (news.topic == News::Topic::Crossing) tell("warning: " + news.text);
            }
            if (diverged()) {
                fail();
                exit_code = Failed;
            } else if (whole && options_.drawing()) {
                follow_replay();
                if (frame_ % options_.every == 0) draw_frame();
            }
            if (const int signal = signals_.arrived()) exit_code = 128 + signal;
        }
        if (frames_) end_frames(exit_code == Done);
        finish();
        if ((!finish_video() || session_.replay_differs()) && exit_code == Done) exit_code = Failed;
        return exit_code;
    }

private:
    [[nodiscard]] bool diverged() { return session_.simulation().report().status == Status::Diverged; }

    void draw_frame() {
        draw();
        if (frames_ || video_) {
            const auto image = std::make_shared<Image>(renderer_->read_back());
            if (frames_) image->texts = picture_texts(session_.simulation());
            if (frames_) frames_->write(image, frame_);
            if (frames_) progress_.advance();
            if (video_) video_->write(*image);
        }
        if (stats_.wanted()) {
            write_stats_row(stats_.stream(), columns_, session_.view());
            stats_.flush();
        }
    }

    void start_scene() {
        const Simulation& simulation = session_.simulation();
        camera_ = Camera(simulation.settings().view);
        renderer_->panels().help = help_lines(make_entries(scene_names()), !simulation.balls().empty());
        renderer_->panels().set_scene(simulation.settings());
    }

    void follow_replay() {
        for (const Command& command : session_.take_view_commands()) {
            if (changes_scene(command)) {
                start_scene();
            } else {
                camera_.apply(command, session_.view());
            }
        }
    }

    void draw() {
        FrameView view = session_.view();
        std::optional<Settings> without_panel;
        if (!options_.overlay && view.settings->view.panel != PanelSize::Off) {
            without_panel.emplace(*view.settings).view.panel = PanelSize::Off;
            view.settings = &*without_panel;
        }
        std::vector<std::string> notices;
        if (options_.overlay) {
            if (!session_.replay_notice().empty()) notices.push_back(session_.replay_notice());
            for (std::string& line : state_notices(session_.simulation(), failure_)) notices.push_back(std::move(line));
        }
        renderer_->draw(view, camera_, notices);
    }

    // Its last good state is the last picture.
    void fail() {
        failure_ = tell_failure(session_.simulation(), options_.out);
        if (options_.drawing()) {
            follow_replay();
            draw_frame();
        }
        if (frames_) frames_->finish();
        progress_.clear();
        tell("drape-capture: " + session_.simulation().report().error +
             (frames_ ? "; " + frames_->last().string() + " shows the last good state" : ""));
        tell(failure_);
    }

    void end_frames(bool all) {
        frames_->finish();
        progress_.close(options_.out);
        if (all) return frames_->remove_older();
        if (frames_->older() == 0) return;
        tell("drape-capture: " + options_.out + " still has " + std::to_string(frames_->older()) +
             " frames of an earlier run");
    }

    void finish() {
        if (!session_.replay_notice().empty()) tell("drape-capture: " + session_.replay_notice());
        const std::string doubt = session_.simulation().run_warning();
        if (!doubt.empty() && !diverged()) tell("warning: " + doubt);
        if (state_.wanted()) {
            write_state_header(state_.stream(), session_.simulation());
            write_state(state_.stream(), session_.simulation());
        }
        state_.close();
        stats_.close();
        save_snapshot(options_.start.save, session_.simulation());
        if (options_.start.hash) std::cout << hash_text(session_.simulation().hash()) << "\n" << std::flush;
    }

    [[nodiscard]] bool finish_video() {
        if (!video_) return true;
        video_->close();
        if (video_->error().empty()) return true;
        tell("drape-capture: no video, " + video_->error() + (frames_ ? "; the pictures are in " + options_.out : ""));
        return false;
    }

    const StopSignals& signals_;
    CaptureOptions options_;
    Session session_;
    Camera camera_;
    std::optional<FrameWriter> frames_;
    std::optional<VideoPipe> video_;
    OutputFile stats_, state_;
    std::optional<GlContext> context_;
    std::unique_ptr<Renderer> renderer_;
    Progress progress_;
    std::vector<StatsColumn> columns_;  ///< of `stats_`
    int frame_ = 0;
    double frame_rate_ = 0;  ///< per simulated second
    std::string failure_;    ///< what was told of the state that has diverged
};

}  // namespace

int capture(CaptureOptions options, const StopSignals& signals) { return Capture(std::move(options), signals).run(); }

int draw_tour(const CaptureOptions& options, const StopSignals& signals) {
    check_picture_memory(options.size);
    const auto stops = tour_stops();
    FrameWriter pictures(options.out, static_cast<int>(stops.size()), options.again);
    const GlContext context = make_context(options.context);
    Renderer renderer;
    renderer.resize(options.size.width, options.size.height);
    Progress progress(stops.size(), "picture");
    int number = 0;
    for (const TourStop& stop : stops) {
        Session session(Simulation(std::string(stop.scene), load_scene(std::string(stop.scene))));
        for (const Command& command : commands_of(stop)) session.send(command);
        Simulation& simulation = session.simulation();
        const ViewSettings& shown = simulation.settings().view;
        // What is slow or has spheres says so in its panel; a full one is what the stop is about
        const bool needs_panel = shown.panel == PanelSize::Full || shown.speed != 1 || shown.bounds;
        if (!options.overlay && !needs_panel) session.send(command::Set{"view.panel=off"});
        if (options.overlay) renderer.panels().hint = tour_hint(static_cast<std::size_t>(number));
        // Panels show medians and curves of what was drawn since the scene began
        constexpr int views = 6;
        for (int k = 0; k <= views; ++k) {
            session.run_until(stop.time * k / views, [&] { return signals.arrived() != 0; });
            if (const int signal = signals.arrived()) {
                pictures.finish();
                return 128 + signal;
            }
            renderer.draw(session.view(), Camera(shown), {});
        }
        const auto image = std::make_shared<Image>(renderer.read_back());
        image->texts = picture_texts(simulation);
        pictures.write(image, ++number);
        progress.advance();
    }
    pictures.finish();
    progress.close(options.out);
    pictures.remove_older();
    return Done;
}

}  // namespace drape
