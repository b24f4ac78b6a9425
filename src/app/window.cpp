#include "window.h"

#include <GL/glew.h>
// GLEW comes before any other header of OpenGL.
#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "display.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/run_program.h"
#include "drape/scene/scene.h"
#include "drape/session/failure.h"
#include "window_size.h"

namespace drape {

namespace {

constexpr double hidden_tick = 0.1;   // s between ticks while there is nothing to draw
constexpr double min_budget = 0.025;  // s for the steps of one frame
constexpr double asleep_tick = 0.5;   // s between pictures of what sleeps, whose time goes on

bool keeps_size(const Options& options) { return !options.size && !options.check; }

PictureSize first_size(const Options& options, double display_scale) {
    PictureSize size = options.size.value_or(PictureSize{});
    if (!keeps_size(options)) return size;
    const PictureSize screen{glutGet(GLUT_SCREEN_WIDTH), glutGet(GLUT_SCREEN_HEIGHT)};
    size = {std::min(static_cast<int>(size.width * display_scale), screen.width),
            std::min(static_cast<int>(size.height * display_scale), screen.height)};
    return kept_window_size(screen).value_or(size);
}

}  // namespace

Window::Window(Session& session, const Options& options, const StopSignals& signals)
    : session_(session),
      signals_(signals),
      entries_(make_entries(scene_names())),
      camera_(session.simulation().settings().view),
      shown_(camera_),
      video_(signals),
      first_scene_(session.simulation().scene()),
      options_(options) {
    glutInitContextVersion(3, 3);
    glutInitContextProfile(GLUT_CORE_PROFILE);
    if (options.check) glutInitContextFlags(GLUT_DEBUG);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_GLUTMAINLOOP_RETURNS);
    const double scale = display_scale();
    const auto [width, height] = first_size(options, scale);
    glutInitWindowSize(width, height);
    window_ = glutCreateWindow("Drape");
    start_glew();
    wait_for_refresh();
    if (options.check) listen_for_errors(gl_error_);
    session_.keep_history({});
    renderer_ = std::make_unique<Renderer>();
    renderer_->panels().display_scale = scale;
    start_scene();
    renderer_->panels().hint = first_hints(!session.simulation().balls().empty());
    if (options.tour) go_to_stop(0);
    register_callbacks();
    on_reshape(glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
    // A wait a little shorter than a frame leaves the rest to the display.
    frame_time_ = 0.9 / display_rate();
}

int Window::run() {
    clock_.lap();
    schedule();
    glutMainLoop();
    if (const std::string news = video_.close(); !news.empty()) tell("drape: " + news);
    if (keeps_size(options_) && kept_size_.width > 0 && kept_size_.height > 0) keep_window_size(kept_size_);
    if (failure_) std::rethrow_exception(failure_);
    return signal_ == 0 ? 0 : 128 + signal_;
}

void Window::on_tick(int) {
    if (closed_) return;
    glutSetWindow(window_);
    signal_ = signals_.arrived();
    if (signal_ != 0) return leave();

    const double elapsed = clock_.lap();
    steer(elapsed);
    if (pointer_.moved()) carry_out(pointer_.flush({session_.view(), shown_, width_, height_}));
    repeat_shot();
    // Steps may take half as long as drawing does: a slow scene still answers the mouse, and a slow display does not
    // slow a cloth whose steps take less than a third of real time.
    const double passed = drawable() ? scene_clock_.pass(elapsed) : elapsed;
    session_.advance(passed, std::max(min_budget, picture_time_ / 2));
    show_drawn();
    for (const Command& command : session_.take_view_commands()) follow(command);
    dirty_ |= shown_.ease_towards(camera_, elapsed);
    follow_scene_file(elapsed);
    tell_of_drops();
    tell_of_lost_ball();

    const Simulation& simulation = session_.simulation();
    tell_of_failure();
    for (const News& news : session_.take_news()) {
        notices_.add(news.topic == News::Topic::Takeover ? "takeover" : "crossing", news.text);
    }
    if (simulation.report().status == Status::Diverged &&
        simulation.settings().solver.on_unstable == OnUnstable::Stop) {
        failure_ = std::make_exception_ptr(RunError(simulation.report().error));
        return leave();
    }
    const bool sleeps = simulation.report().asleep && !simulation.paused() && is_at_rest(session_.view());
    dirty_ |= notices_.advance(elapsed) || (simulation.paused() ? simulation.report().step != drawn_step_ : !sleeps);
    menu_->update(simulation);
    take_panel_changes();
    if (const std::string news = video_.news(); !news.empty()) notices_.add("video", news), dirty_ = true;
    dirty_ |= video_.recording() || session_.swings();
    if (simulation.settings().view.quality != PictureQuality::Auto) pace_ = {};
    pace_.follow(dirty_, elapsed);
    if (panel_frames_ > 0) --panel_frames_, dirty_ = true;  // which is no motion of what is shown
    since_drawn_ += elapsed;
    dirty_ |= pace_.unfinished() || (sleeps && since_drawn_ >= asleep_tick);
    if (dirty_ && drawable()) glutPostRedisplay();
    schedule();
}

void Window::schedule() {
    if (closed_) return;
    const double wait = (drawable() ? frame_time_ : hidden_tick) - clock_.seconds();
    const auto milliseconds = static_cast<unsigned>(std::max(1.0, 1000 * wait));
    glutTimerFuncUcall(milliseconds, Callback<&Window::on_tick>::call, 0, this);
}

void Window::on_display() {
    if (closed_ || !drawable()) return;
    show_drawn();
    FrameView view = seen();
    const Stopwatch watch;
    view.prefer_speed = draws_fast();
    draw(view);
    if (video_.due()) video_.take(renderer_->read_back());
    renderer_->present(video_.recording());
    glFlush();
    since_drawn_ = 0;
    dirty_ = false;
    // A slow display draws while the next steps are made. Where pictures seem quick, one is drawn by itself, to know.
    const bool waits = is_fast(view) && drawing_time_ >= PicturePace::shortest;
    drawing_time_ = watch.seconds();
    unshown_ = view.prefer_speed;
    if (!waits) show_drawn();
}

void Window::show_drawn() {
    if (!unshown_) return;
    const bool prefer_speed = *std::exchange(unshown_, std::nullopt);
    const Stopwatch watch;
    glFinish();  // without it, the time to draw would have the wait for the display in it
    const double wait = watch.seconds();
    glutSwapBuffers();
    if (scene_clock_.begin()) clock_.lap();  // what the first picture took is no time of the scene
    if (options_.check) check_frame(gl_error_, session_.view(), camera_);
    picture_time_ = drawing_time_ + watch.seconds();
    drawing_time_ += wait;
    if (session_.simulation().settings().view.quality == PictureQuality::Auto) pace_.drew(prefer_speed, drawing_time_);
}

FrameView Window::seen() {
    FrameView view = session_.view();
    view.timeline = session_.timeline();
    if (view.settings->view.panel != PanelSize::Off) view.search = search_timer_.look(view);
    return view;
}

void Window::draw(const FrameView& view) {
    std::vector<std::string> texts = notices_.texts(session_.replay_notice());
    for (std::string& text : state_notices(session_.simulation(), {})) texts.push_back(std::move(text));
    if (view.report->status == Status::Diverged && undo_.any()) {
        texts.emplace_back("Ctrl+Z takes the last change of a setting back");
    }
    if (view.mode != nullptr) texts.push_back(text_of(*view.mode, !(view.report->step_limit_ratio > 1)));
    if (!scene_error_.empty()) texts.push_back(scene_error_);
    renderer_->draw(view, shown_, texts);
    drawn_step_ = view.report->step;
}

void Window::take_picture() {
    if (!drawable() || closed_) return;
    // The bar of time is no part of the picture, but a drag of it would end with a frame without it
    FrameView view = seen();
    view.timeline.has_bar = panel_button_;
    draw(view);
    Image picture = renderer_->read_back();
    picture.texts = picture_texts(session_.simulation());
    write_new("Picture", ".png", [&](const std::filesystem::path& file) { return write_png(picture, file, true); });
}

// Under the first free name; another program may be faster
void Window::write_new(const char* what, const char* extension,
                       const std::function<bool(const std::filesystem::path& file)>& write) {
    try {
        std::filesystem::path file = first_free_name(extension);
        while (!write(file)) file = first_free_name(extension);
        notices_.add("picture", std::string(what) + " written: " + file.string());
    } catch (const RunError& error) {
        notices_.add("picture", error.what());
    }
}

void Window::steer(double elapsed) {
    if ((steering_.active() || !held_keys_.empty()) && !window_has_keyboard()) {
        steering_.release_all();
        held_keys_.clear();
    }
    steering_.advance(elapsed);
    if (const auto command = steering_.update(camera_)) {
        if (!command->direction.isZero(0)) tell_whose_ball();
        carry_out(*command);
    }
}

void Window::tell_whose_ball() {
    const std::vector<BallSettings>& balls = session_.simulation().settings().balls;
    if (balls.empty()) return notices_.add("ball", "This scene has no ball for the keys");
    const bool led = std::ranges::find(balls, BallMotion::Keys, &BallSettings::motion) != balls.end();
    const std::string which = balls.size() > 1 ? "the ball with the red ring" : "the ball";
    if (!led) notices_.add("ball", "The keys lead " + which + " from now on; R gives it back to the scene");
}

// Once, however often the user comes back to it
void Window::tell_of_failure() {
    const Simulation& simulation = session_.simulation();
    const std::string& error = simulation.report().error;
    if (simulation.report().status == Status::Ok || error == told_failure_) return;
    told_failure_ = error;
    tell("drape: " + error);
    if (const std::string warning = simulation.step_warning(); !warning.empty()) tell(warning);
}

// Not where the panel says that the picture is coarse, as where there is no time for every step, nor of what sleeps
void Window::tell_of_drops() {
    const double dropped = session_.dropped();
    dropped_ = std::min(dropped_, dropped);
    if (dropped < dropped_ + 0.1) return;
    dropped_ = dropped;
    const Simulation& simulation = session_.simulation();
    if (draws_fast() || simulation.report().asleep) return;
    notices_.add("dropped", "The scene is slower than view.speed asks: " + real_text(std::round(10 * dropped) / 10, 6) +
                                " s behind so far");
}

// As it leaves the picture
void Window::tell_of_lost_ball() {
    const Simulation& simulation = session_.simulation();
    const Timeline timeline = session_.timeline();
    if (!drawable() || timeline.replay || !timeline.is_live() || simulation.balls().empty()) return;
    const std::size_t number = simulation.users_ball();
    const BallMotion motion = simulation.settings().balls[number].motion;
    if (motion != BallMotion::Keys && motion != BallMotion::Free) return;
    const Ball& ball = simulation.balls()[number];
    const float aspect = static_cast<float>(width_) / static_cast<float>(height_);
    const bool saw_ball = std::exchange(sees_ball_, shown_.sees(ball, aspect));
    if (!saw_ball || sees_ball_ || simulation.paused() || ball.velocity.isZero()) return;
    notices_.add("ball", "The ball has left the picture: X throws it again");
}

// A replay and a tour have scenes of their own
void Window::follow_scene_file(double elapsed) {
    const bool saved = scene_watch_.saved(elapsed);
    if (!saved || touring_ || session_.timeline().replay) return;
    reload_scene();
    if (scene_error_.empty()) notices_.add("scene", "The scene begins again, as its file was saved");
}

// With what the command line asks for, but without what the user has changed since
void Window::reload_scene() {
    dirty_ = true;
    const command::LoadScene again{session_.simulation().scene()};
    try {
        session_.send(again);
    } catch (const InputError& error) {
        scene_error_ = one_line(std::string("The scene as it was stays: ") + error.what());
        return tell("drape: " + scene_error_);
    }
    follow(again);
    if (again.name != first_scene_) return;
    if (!options_.start.versus.empty()) carry_out(command::Compare{options_.start.versus});
    for (const std::string& assignment : options_.start.assignments) {
        if (assignment.find('=') != std::string::npos) carry_out(command::Set{assignment});
    }
}

void Window::repeat_shot() {
    const Timeline timeline = session_.timeline();
    if (timeline.replay) shot_repeat_.end();
    if (!timeline.is_live()) return;
    const std::vector<Command> commands = shot_repeat_.due(session_.simulation());
    carry_out(commands);
    if (commands.size() > 1) notices_.add("repeat", "Once more, ten times as slow");
}

void Window::start_scene() {
    scene_watch_.watch(session_.simulation().scene());
    scene_error_.clear();
    notices_.keep_only({"picture", "video"});  // the files stay
    camera_ = shown_ = Camera(session_.simulation().settings().view);
    renderer_->panels().set_scene(session_.simulation().settings());
    renderer_->panels().help = help_lines(entries_, !session_.simulation().balls().empty());
    renderer_->panels().hint = {};
    touring_ = false;
    undo_ = {};
    glutSetWindowTitle(("Drape - " + session_.simulation().settings().title).c_str());
}

void Window::take_panel_changes() {
    const PanelWishes wishes = std::exchange(renderer_->panels().wishes, {});
    if (wishes.back) go_to(session_.step_before_newest(*wishes.back));
    for (const std::string& assignment : wishes.changes) change(command::Set{assignment}, panel_presses_);
    if (wishes.comparison) carry_out(command::Compare{*wishes.comparison});
    if (wishes.entry) on_choice(static_cast<int>(*wishes.entry));
}

void Window::leave() {
    if (!closed_) glutLeaveMainLoop();
}

Window::~Window() {
    if (!closed_) glutDestroyWindow(window_);  // which calls on_close, while there is somebody to hear it
}

void Window::on_close() {
    // The last moment in which the window's context is there.
    closed_ = true;
    renderer_.reset();
}

}  // namespace drape
