#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "drape/base/stop_signals.h"
#include "drape/base/stopwatch.h"
#include "drape/render/camera.h"
#include "drape/render/entries.h"
#include "drape/render/renderer.h"
#include "drape/session/search_timer.h"
#include "drape/session/session.h"
#include "frame_check.h"
#include "menu.h"
#include "notices.h"
#include "options.h"
#include "picture_pace.h"
#include "pointer.h"
#include "scene_watch.h"
#include "setting_undo.h"
#include "shot_repeat.h"
#include "steering.h"
#include "window_video.h"

namespace drape {

/// The window: GLUT's callbacks reach it through their user pointer, and it turns what they bring into commands.
class Window {
public:
    /// Opens the window.
    /// @param options outlive the window
    /// @param signals that end it
    /// @pre glutInit was called
    Window(Session& session, const Options& options, const StopSignals& signals);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Runs until the user ends it.
    /// @return 0, or 128 + the number of the signal that ended it
    /// @throws what a callback threw
    int run();

private:
    void register_callbacks();

    // What GLUT brings.
    void on_tick(int);
    void on_display();
    void on_reshape(int width, int height);
    void on_visibility(int state);
    void on_entry(int state);
    void on_character(unsigned char code, int x, int y);
    void on_character_up(unsigned char code, int x, int y);
    void on_special(int code, int x, int y);
    void on_special_up(int code, int x, int y);
    void on_button(int button, int state, int x, int y);
    void on_motion(int x, int y);
    void on_passive_motion(int x, int y);
    void on_wheel(int wheel, int notches, int x, int y);
    void on_menu(int status, int x, int y);
    void on_choice(int entry);
    void on_close();

    // `Callback<&Window::on_...>::call` is what GLUT calls. An exception must not pass through it: it ends the main
    // loop, and `run` throws it again.
    template <auto callback>
    struct Callback;
    template <class... Arguments, void (Window::*callback)(Arguments...)>
    struct Callback<callback> {
        static void call(Arguments... arguments, void* user) {
            Window& window = *static_cast<Window*>(user);
            try {
                (window.*callback)(arguments...);
            } catch (...) {
                window.failure_ = std::current_exception();
                window.leave();
            }
        }
    };

    void press(const std::string& key);
    void release(const std::string& key);
    void type_at_panel(unsigned char code);
    bool carry_out(const Command& command);
    bool change(const Command& command, int press = 0);
    void undo(bool again);
    void carry_out(const std::vector<Command>& commands);
    void give(const Entry& entry);
    [[nodiscard]] std::vector<Command> commands_of(const Entry& entry);
    [[nodiscard]] std::vector<Command> safe_step();
    [[nodiscard]] std::int64_t steps_of_a_frame() const;
    void go_to(std::int64_t step);
    void replay_run();
    void replay_file(const std::string& file);
    void go_to_stop(int stop);
    void leave_tour();
    void forget_hint();
    bool close_topmost();
    bool at_panel(const PanelPointer& pointer);
    void take_panel_changes();
    void steer(double elapsed);
    void follow(const Command& command);
    void tell_of_drops();
    void tell_of_lost_ball();
    void tell_of_failure();
    void tell_whose_ball();
    void follow_scene_file(double elapsed);
    void reload_scene();
    void repeat_shot();
    void start_scene();
    FrameView seen();
    void draw(const FrameView& view);
    void show_drawn();
    void take_picture();
    void write_new(const char* what, const char* extension,
                   const std::function<bool(const std::filesystem::path& file)>& write);
    void schedule();
    void leave();
    [[nodiscard]] bool draws_fast() const { return pace_.prefer_speed() && !video_.recording(); }
    [[nodiscard]] bool drawable() const { return visible_ && width_ > 0 && height_ > 0; }

    Session& session_;
    const StopSignals& signals_;
    std::vector<Entry> entries_;
    Camera camera_;  ///< where the commands have led
    Camera shown_;   ///< what the picture shows, on its way there
    Pointer pointer_;
    Steering steering_;
    std::set<std::string> held_keys_;  ///< by the names they have without Shift and Control
    Notices notices_;
    SearchTimer search_timer_;
    PicturePace pace_;
    SceneClock scene_clock_;
    WindowVideo video_;
    std::string gl_error_;  ///< the first, where `options_.check` asks for it
    std::unique_ptr<Renderer> renderer_;
    std::optional<Menu> menu_;
    Stopwatch clock_;  ///< since the last tick
    std::exception_ptr failure_;
    std::string told_failure_;  ///< the last of which the terminal was told
    ShotRepeat shot_repeat_;
    SceneWatch scene_watch_;
    SettingUndo undo_;
    std::string first_scene_;  ///< with which the program began
    const Options& options_;
    std::string scene_error_;       ///< of the scene's file as it was last saved; empty: none
    double frame_time_ = 1.0 / 60;  ///< from tick to tick [s]
    double drawing_time_ = 0;       ///< of the last picture, as far as nothing else was done meanwhile [s]
    double picture_time_ = 0;       ///< the same, its way to the display included [s]
    double dropped_ = 0;            ///< of which the user was told [s]
    double since_drawn_ = 0;        ///< time since the last picture [s]
    std::int64_t drawn_step_ = -1;
    int window_ = 0;
    int width_ = 0, height_ = 0;
    PictureSize kept_size_{0, 0};  ///< that it had last while it did not fill the screen
    int signal_ = 0;
    bool visible_ = true;
    bool sees_ball_ = false;       ///< the user's ball is in the picture
    bool dirty_ = true;            ///< the picture is not up to date
    std::optional<bool> unshown_;  ///< a picture is being drawn and has to be shown: whether it is a fast one
    bool closed_ = false;
    bool panel_button_ = false;  ///< the left button is down at the settings panel
    int panel_presses_ = 0;      ///< of the left button there
    int panel_frames_ = 0;       ///< to be drawn for what the settings panel was told
    int stop_ = 0;               ///< of the tour: the present one, or that which F1 goes to
    bool touring_ = false;       ///< the scene is a stop's, and its panel is on show
};

}  // namespace drape
