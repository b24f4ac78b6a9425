#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drape/render/camera.h"
#include "drape/render/image.h"
#include "drape/sim/frame_view.h"

namespace drape {

struct Entry;

/// What one frame cost, beside the steps in it.
struct FrameReport {
    std::int64_t frame = 0;
    double gl_calls = 0;   ///< OpenGL calls made for it so far, `present` and `read_back` included once they are made
    double vertices = 0;   ///< vertices sent through the pipeline
    double draw_time = 0;  ///< wall time of `draw` [s]
    double rate = 0;       ///< frames per second, averaged over the last second
    double cpu = 0;        ///< processor time over wall time of this process, averaged over the last second
};

/// One field of a frame's report, for overlay and CSV.
struct FrameField {
    std::string_view name;
    std::string_view unit;
    double (*read)(const FrameReport&);
};
inline constexpr std::array frame_fields{
    FrameField{"gl_calls", "", [](const FrameReport& r) { return r.gl_calls; }},
    FrameField{"vertices", "", [](const FrameReport& r) { return r.vertices; }},
    FrameField{"draw_time", "s", [](const FrameReport& r) { return r.draw_time; }},
    FrameField{"rate", "1/s", [](const FrameReport& r) { return r.rate; }},
    FrameField{"cpu", "", [](const FrameReport& r) { return r.cpu; }},
};

/// What a key does, for the panels of help and hints; without a key, the heading of the lines after it.
struct KeyHelp {
    std::string key;
    std::string text;

    [[nodiscard]] bool is_heading() const { return key.empty(); }
};

/// The pointer, as panels see it.
struct PanelPointer {
    int x = -1, y = -1;    ///< from the upper left [pixel]
    bool down = false;     ///< its left button
    bool control = false;  ///< Control is held: a click opens a field to type into
    int notches = 0;       ///< of the wheel since the last one, positive away from the user
};

/// What the user has asked for at the panels.
struct PanelWishes {
    std::vector<std::string> changes;       ///< of settings, as "solver.dt=0.001"
    std::optional<std::string> comparison;  ///< as `command::Compare` has it
    std::optional<double> back;             ///< to go to, before the newest step [s]
    std::optional<std::size_t> entry;       ///< its number, of those of the drawn menu
};

/// The panels over the picture, which follow in the next frames.
class Panels {
public:
    std::vector<KeyHelp> help;  ///< shown by `settings->view.help`
    std::vector<KeyHelp> hint;  ///< what to try first, in a panel at the bottom; no lines: no panel
    int hover_x = -1,
        hover_y = -1;    ///< of the pointer over the picture, where node or figure is explained; -1: not known [pixel]
    PanelWishes wishes;  ///< since they were last taken
    double display_scale = 1;  ///< pixels for one of a usual display: text grows with it in steps, and lines do too

    /// The settings to which the settings panel's buttons lead back.
    virtual void set_scene(const Settings& settings) = 0;

    /// Opens the drawn menu of these entries and of the settings that a scene has.
    virtual void open_menu(std::span<const Entry> entries, const Settings& settings) = 0;
    [[nodiscard]] virtual bool menu_open() const = 0;

    /// What the user's pointer does.
    virtual void point(const PanelPointer& pointer) = 0;

    /// A typed character for a field of the settings panel, or for the menu while it is open: 8 deletes, 13 ends or
    /// chooses, 27 gives up, 14 and 16 go down and up in the menu.
    virtual void type(unsigned char code) = 0;

    /// Whether pointer and keyboard are the panels' now.
    [[nodiscard]] virtual bool have_pointer() const = 0;
    [[nodiscard]] virtual bool have_keyboard() const = 0;

    /// Closes a list of names of the settings panel with the next frame. @return whether one is open
    [[nodiscard]] virtual bool close_list() = 0;

    /// Whether the bar of time is shown, which follows the pointer as the settings panel does.
    [[nodiscard]] virtual bool shows_timeline() const = 0;

protected:
    ~Panels() = default;
};

/// Finds the functions of the OpenGL context that is current. GLX may be missing, as under Wayland or EGL.
/// @throws RunError that says why they were not found
void start_glew();

/// Draws a `FrameView` with OpenGL 3.3 core, multisampled, into a framebuffer of its own.
/// Needs a current context with `start_glew` called from construction to destruction.
class Renderer {
public:
    /// @throws RunError with the compiler's log if a shader does not compile
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Size of the picture in pixels; below 1 x 1 nothing is drawn until the next call.
    void resize(int width, int height);

    [[nodiscard]] Panels& panels();

    /// Draws one frame: shadow, sky, ground, balls, cloths, what `settings->view` asks for, overlay.
    /// @param notices texts for the user (an error, a replay that ended), shown with the overlay or without
    void draw(const FrameView& view, const Camera& camera, std::span<const std::string> notices);

    /// Has the drawn frame in framebuffer 0, for a window.
    /// @param is_recorded with a red mark in its corner, which `read_back` does not have
    void present(bool is_recorded);

    /// The drawn frame.
    [[nodiscard]] Image read_back() const;

    [[nodiscard]] const FrameReport& report() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace drape
