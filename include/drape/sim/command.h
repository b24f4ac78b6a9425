#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "drape/base/real.h"

namespace drape {

/// Everything that a user can do. Keys, menu, recordings and tests all speak it; each has one text form, given here.
namespace command {

struct Pause {};  ///< `pause`: stops or goes on
struct Step {     ///< `step 1`: n steps, and pauses
    int count = 1;
};
struct Reset {};    ///< `reset`: the scene as it was loaded, with the settings of now
struct LoadScene {  ///< `scene drop`
    std::string name;
};
struct Load {  ///< `load run.snapshot`: goes on from a snapshot
    std::string file;
};
struct Compare {  ///< `compare dt=1e-4,friction=0`: begins again, beside a run with other settings; `compare none` ends
    std::string assignments;
    [[nodiscard]] bool begins() const { return assignments != "none"; }
};
struct Set {  ///< `set solver.dt=1e-4`
    std::string assignment;
};
struct Next {  ///< `next integrator`: the next choice, or the flag's other value
    std::string setting;
};
struct Add {  ///< `add view.level 1`: to a number, kept in its range
    std::string setting;
    double amount = 0;
};
struct Steer {  ///< `steer 1 0 0`: where the keys send the user's ball, of whatever motion; zero stops it
    Vec3 direction = Vec3::Zero();
};
struct Throw {  ///< `throw 0 1 2 0 0 -6`: the user's ball flies from a point [m] at a velocity [m/s]
    Vec3 from = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
};
struct Fall {};  ///< `fall`: the user's ball is let go, and falls
struct Grab {    ///< `grab 0 17`: takes a particle of a cloth in hand
    int cloth = 0;
    int particle = 0;
};
struct Hold {  ///< `hold 0`: takes a ball in hand, which moves it while the keys would, or while it is free
    int ball = 0;
};
struct Drag {  ///< `drag 0.1 0.2 0.3`: where the hand goes [m]
    Vec3 target = Vec3::Zero();
};
struct Release {};  ///< `release`: the hand lets go
struct Pin {        ///< `pin 0 17`: pins a particle of a cloth where it is, or frees a pinned one
    int cloth = 0;
    int particle = 0;
};
struct Orbit {  ///< `orbit 0.1 0.05`: the camera about its target [rad]
    double yaw = 0, pitch = 0;
};
struct Pan {  ///< `pan 0.1 0`: eye and target, in units of the distance
    double right = 0, up = 0;
};
struct Zoom {  ///< `zoom 0.9`: the distance times a factor
    double factor = 1;
};
struct Frame {};    ///< `frame`: the whole scene into the picture
struct Home {};     ///< `home`: the view with which the scene begins
struct Picture {};  ///< `picture`: writes a PNG
struct Video {};    ///< `video`: begins a video of what is shown, or ends it
struct Quit {};     ///< `quit`

/// Of the camera, the picture or the program: nothing that cloth or ball follows from.
template <class C>
concept OfThePicture =
    std::is_same_v<C, Orbit> || std::is_same_v<C, Pan> || std::is_same_v<C, Zoom> || std::is_same_v<C, Frame> ||
    std::is_same_v<C, Home> || std::is_same_v<C, Picture> || std::is_same_v<C, Video> || std::is_same_v<C, Quit>;

}  // namespace command

using Command = std::variant<command::Pause, command::Step, command::Reset, command::LoadScene, command::Load,
                             command::Compare, command::Set, command::Next, command::Add, command::Steer,
                             command::Throw, command::Fall, command::Grab, command::Hold, command::Drag,
                             command::Release, command::Pin, command::Orbit, command::Pan, command::Zoom,
                             command::Frame, command::Home, command::Picture, command::Video, command::Quit>;

/// The text form: one line without its end.
std::string command_text(const Command& command);

/// Reads the text form.
/// @throws InputError naming the nearest known command, or what its arguments are
Command parse_command(std::string_view text);

/// The setting that `set`, `next` or `add` names; empty for other commands.
std::string_view setting_of(const Command& command);

/// True for commands after which there is another scene.
bool changes_scene(const Command& command);

/// True for commands that can change the cloth or the ball; the others change the picture or the program only.
bool changes_state(const Command& command);

/// True for those after which the run is at its start again.
bool begins_again(const Command& command);

/// True for those of these that the motion follows from: not for pauses, single steps and settings of the view.
bool changes_motion(const Command& command);

/// True for pauses and single steps, which pause as well.
bool pauses(const Command& command);

}  // namespace drape
