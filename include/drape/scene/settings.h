#pragma once

#include <string>
#include <vector>

#include "drape/base/enum_names.h"
#include "drape/base/real.h"
#include "drape/bounds/broad_phase.h"
#include "drape/contact/body.h"
#include "drape/contact/response.h"
#include "drape/integrate/integrator.h"
#include "drape/model/cloth_model.h"

namespace drape {

/// What moves a ball: the keys, a path through points in time, nothing, or gravity and whatever touches it.
enum class BallMotion { Keys, Path, Still, Free };

/// A point of a ball's path: where its centre is at a time.
struct PathPoint {
    Real time = 0;               ///< [s]
    Vec3 centre = Vec3::Zero();  ///< [m]
    bool operator==(const PathPoint&) const = default;
};

struct BallSettings {
    Real radius = Real(0.3);
    Vec3 position = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    BallMotion motion = BallMotion::Keys;
    Real speed = Real(0.8);       ///< under the keys [m/s]
    Real mass = 1;                ///< of a free one [kg]
    std::vector<PathPoint> path;  ///< times ascending; repeats if it ends where it starts, else rests there
    bool operator==(const BallSettings&) const = default;
};

/// The shape of a solid.
enum class SolidKind { Box, Capsule, Mesh };

/// What moves a solid.
enum class SolidMotion { Still, Path };

struct SolidSettings {
    SolidKind shape = SolidKind::Box;
    Vec3 position = Vec3::Zero();
    Vec3 axis{0, 1, 0};                          ///< about which it is turned, of any length but zero
    Real angle = 0;                              ///< by which [degree]
    Vec3 size{Real(0.5), Real(0.5), Real(0.5)};  ///< of a box [m]
    Real radius = Real(0.1);                     ///< of a capsule [m]
    Real length = Real(0.3);                     ///< of a capsule's segment [m]
    std::string file;                            ///< of a mesh
    SolidMotion motion = SolidMotion::Still;
    std::vector<PathPoint> path;  ///< as a ball's
    bool operator==(const SolidSettings&) const = default;
};

/// Pins of a cloth that move together: shifted, and turned about an axis through their middle.
struct PinSettings {
    int cloth = 0;                 ///< its number
    Grid particles{0, 0};          ///< the pins from the first to the second of these particles
    std::vector<PathPoint> shift;  ///< from where the cloth starts, as a ball's path; none: not shifted
    std::vector<PathPoint> turns;  ///< about x, y and z: their sum as vectors is axis and size; none: not turned
    bool operator==(const PinSettings&) const = default;
};

/// What to do about steps that are too long: freeze a state that has diverged and say so; divide every step into as
/// many substeps as its limit asks for; or end with the state.
enum class OnUnstable { Warn, Substep, Stop };

/// The integrator, and what steps are made by it. Its kernels are those of hierarchy and detection too; its threads
/// share the search where cloths touch.
struct SolverSettings : IntegratorParameters {
    double dt = 2e-4;  ///< in every precision: it counts steps and time
    OnUnstable on_unstable = OnUnstable::Warn;
    Real sleep_speed = Real(2e-4);  ///< slower than this for half a second, a scene falls asleep; 0: never [m/s]
    bool ledger = false;            ///< keep the balance of the energy
    bool operator==(const SolverSettings&) const = default;
};

/// Whether what may have met within a step is a contact, and not only what touches at its end.
enum class Continuous {
    Auto,
    Always,  ///< the same, as older scenes call it
    Never
};

template <>
inline constexpr std::string_view other_name<Continuous::Always> = "true";
template <>
inline constexpr std::string_view other_name<Continuous::Never> = "false";

/// The hierarchy by which contacts are found, how they are answered, and the surface of balls, solids and cloth.
/// Kernels are the solver's, see `broad_phase_of`.
struct ContactSettings : Surface, BroadPhaseParameters {
    ResponseKind response = ResponseKind::Projection;
    Real thickness = Real(0.002);
    Real stiffness = 1000;       ///< of penalties, a contact [N/m]
    double longest_step = 5e-4;  ///< of an implicit method in contact, see `substeps_in_contact` [s]
    Continuous continuous = Continuous::Auto;
    bool self = false;  ///< cloths meet themselves and each other
    bool operator==(const ContactSettings&) const = default;
};

struct WorldSettings {
    Real gravity = -standard_gravity()[1];  ///< of cloths and free balls, downwards [m/s^2]
    bool operator==(const WorldSettings&) const = default;
};

struct WindSettings {
    bool on = false;
    Vec3 velocity{Real(1.5), 0, Real(-2.5)};  ///< mean [m/s]
    Real gust = Real(0.5);                    ///< amplitude of the gusts over the mean
    bool operator==(const WindSettings&) const = default;
};

/// How much the stats panel shows: nothing, what a glance takes in, or every figure.
enum class PanelSize { Off, Compact, Full };

/// What the colour of the cloth says.
enum class ColourBy {
    Plain,            ///< nothing but front and back
    Strain,           ///< of the structural springs of a particle
    PrincipalStrain,  ///< the same, with the directions of the strain of cells
    Speed,
    Depth,      ///< of the contacts of a particle
    Level,      ///< the node of the shown level of the hierarchy
    Side,       ///< front or back, in colours that colour-blind eyes tell apart
    Difference  ///< from the simulation that this one is compared with
};

/// How much is spent on a picture.
enum class PictureQuality {
    Auto,  ///< fast in a window whose display is slow while something moves, else full
    Fast,  ///< half the width and height, fewer particles of a large cloth
    Full   ///< the whole size, and every particle
};

/// What the cloth looks like.
enum class Fabric {
    Cotton,  ///< checks, and fibres that shine at grazing angles
    Silk,    ///< one colour, and a gloss along its threads
    Denim,   ///< a twill of coloured and white threads
    Plain    ///< one colour in simple light
};

/// The colours of cloths, ground and wall.
enum class Palette { Studio, Dusk, Linen };

/// What the picture shows besides cloth and ball. It changes no state.
struct ViewSettings {
    PanelSize panel = PanelSize::Compact;
    bool help = false;
    double text_scale = 1;  ///< of the panels' text, which follows the window's size
    bool controls = false;  ///< the panel of settings
    bool plots = false;     ///< figures over the last seconds
    bool bounds = false;
    int level = 3;
    bool wireframe = false;
    bool particles = false;  ///< particles and springs
    bool contacts = false;
    ColourBy colour = ColourBy::Plain;
    bool weave = true;
    bool smooth = true;  ///< outlines of the cloth are curves through the particles
    bool grid = true;    ///< a grid on the ground says how large things are
    PictureQuality quality = PictureQuality::Auto;
    Vec3 eye{Real(1.6), Real(0.9), Real(2.2)};
    Vec3 target{0, 0, 0};
    double speed = 1;   ///< simulated seconds that pass in a second at the window
    double repeat = 0;  ///< time at which the window shows the scene once more in slow motion [s]; 0: never
    Fabric fabric = Fabric::Cotton;
    Palette palette = Palette::Studio;
};

/// What of two motions is compared.
enum class NeedsMeasure {
    Positions,       ///< RMS distance of the particles
    CentreAndSpread  ///< of the centres of mass, or of the RMS distances from them, whichever differs more
};

/// What of a scene's cloth may be left out; zero: as in the scene.
struct FullModelSettings {
    Grid particles{0, 0};
    SpringLaw bend;
    Real drag = 0;  ///< per particle of that grid [N s/m]
};

/// What a scene must show, and no more, for the lab to find the cheapest way to it. Zero: not stated.
struct NeedsSettings {
    Real position_error = 0;  ///< against the full model up to the horizon, of the cloth's side
    NeedsMeasure measure = NeedsMeasure::Positions;
    Real horizon = Real(0.5);
    Real penetration = 0;   ///< at most [m]
    Real stretch = 0;       ///< at most, of a structural spring
    Real min_stretch = 0;   ///< to which it must come: a scene that shows a soft method
    bool diverges = false;  ///< by the horizon: a scene that shows a method failing
    std::string keep;       ///< names of the knobs that are as they are by the scene's nature
    FullModelSettings full;
};

/// Every knob of Drape, as `setting_table` describes it.
struct Settings {
    std::string title = "Untitled";
    std::string start;  ///< file of the state in which cloths and balls start; empty: at rest
    std::vector<ClothParameters> cloths{ClothParameters{}};
    std::vector<BallSettings> balls;
    std::vector<SolidSettings> solids;
    std::vector<PinSettings> pins;  ///< that move
    SolverSettings solver;
    ContactSettings contact;
    Ground ground;
    WorldSettings world;
    WindSettings wind;
    ViewSettings view;
    NeedsSettings needs;
};

/// Of cloths and free balls [m/s^2].
[[nodiscard]] Vec3 gravity_of(const Settings& settings);

/// The response that the settings name.
[[nodiscard]] ResponseParameters response_of(const Settings& settings);

/// The hierarchy that the settings name.
[[nodiscard]] BroadPhaseParameters broad_phase_of(const Settings& settings);

/// True if both have all in common that cloths and balls move by, and how their contacts are found.
bool same_motion(const Settings& a, const Settings& b);

/// True if the cloths start in the same positions with the same particles, so that a state can be kept.
bool same_start(const Settings& a, const Settings& b);

/// True if the longest stable step and the number of substeps are the same.
bool same_step_plan(const Settings& a, const Settings& b);

}  // namespace drape
