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

/// In which scenes a line is shown.
enum class ShownIn { AnyScene, ScenesWithBall, ScenesWithoutBall };

/// What a key does, for the panels of help and hints; without a key, the heading of the lines after it.
struct KeyHelp {
    std::string key;
    std::string text;
    ShownIn where = ShownIn::AnyScene;

    [[nodiscard]] bool is_heading() const { return key.empty(); }
};

/// The pointer, as panels see it.
struct PanelPointer {
    int x = -1, y = -1;    ///< from the upper left [pixel]
    bool down = false;     ///< its left button
    bool control = false;  ///< Control is held: a click opens a field to type into
    int notches = 0;       ///< of the wheel since the last one, positive away from the user
};

/// What may follow when a frame is drawn: `read_back` and `present`, or `present` only, at less cost if it is drawn
/// fast.
enum class DrawnFor { Picture, Window };

/// Draws a `FrameView` with OpenGL 3.3 core, multisampled, into a framebuffer of its own.
/// Needs a current context with GLEW initialised from construction to destruction.
class Renderer {
public:
    /// @throws RunError with the compiler's log if a shader does not compile
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Size of the picture in pixels; below 1 x 1 nothing is drawn until the next call.
    void resize(int width, int height);

    /// The lines of the help panel, which `settings->view.help` shows.
    void set_help(std::vector<KeyHelp> lines);

    /// Opens the drawn menu of these entries and of the settings that a scene has.
    void open_menu(std::span<const Entry> entries, const Settings& settings);
    [[nodiscard]] bool menu_open() const;

    /// The number of the entry that the user has chosen in the drawn menu since the last call.
    [[nodiscard]] std::optional<std::size_t> take_entry();

    /// What a newcomer may try, in a panel at the bottom; no lines: no panel.
    void set_hint(std::vector<KeyHelp> lines);

    /// The settings to which the settings panel's buttons lead back.
    void set_scene(const Settings& settings);

    /// What the user's pointer does, for the settings panel, which follows in the next frames.
    void point(const PanelPointer& pointer);

    /// Where the pointer is over the picture: while bounding volumes are shown, the node there is named [pixel].
    void hover(int x, int y);

    /// A typed character for a field of the settings panel, or for the menu while it is open: 8 deletes, 13 ends or
    /// chooses, 27 gives up, 14 and 16 go down and up in the menu.
    void type(unsigned char code);

    /// Whether pointer and keyboard are the settings panel's now.
    [[nodiscard]] bool panel_has_pointer() const;
    [[nodiscard]] bool panel_has_keyboard() const;

    /// Whether a list of names of the settings panel is open, and closes it with the next frame.
    [[nodiscard]] bool panel_has_list() const;
    void close_list();

    /// What the user has changed at the settings panel since the last call, as "solver.dt=0.001".
    [[nodiscard]] std::vector<std::string> take_changes();

    /// What the user wants to compare the run with since the last call, as `command::Compare` has it.
    [[nodiscard]] std::optional<std::string> take_wanted_comparison();

    /// Whether the bar of time is shown, which follows the pointer as the settings panel does.
    [[nodiscard]] bool shows_timeline() const;

    /// The step that the user has asked for at the bar of time since the last call.
    [[nodiscard]] std::optional<std::int64_t> take_wanted_step();

    /// Draws one frame: shadow, sky, ground, balls, cloths, what `settings->view` asks for, overlay.
    /// @param notices lines for the user (an error, a replay that ended), shown with the overlay or without
    void draw(const FrameView& view, const Camera& camera, std::span<const std::string> notices,
              DrawnFor use = DrawnFor::Picture);

    /// Has the drawn frame in framebuffer 0, for a window.
    void present();

    /// The drawn frame.
    /// @pre it was drawn for a picture
    [[nodiscard]] Image read_back() const;

    [[nodiscard]] const FrameReport& report() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace drape
