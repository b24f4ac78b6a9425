#include "drape/sim/setting_table.h"

#include "setting_rows.h"

namespace drape {
namespace {

using Values = std::vector<double>;

constexpr Range lengths{-1e4, 1e4};  // m: everything happens within ten kilometres
constexpr Range sizes{1e-6, 1e4};    // m
constexpr Range any_text{0, 0};
constexpr double usual_friction = 2;  // rubber

void add_spring(SectionRows<ClothParameters>& rows, const std::string& kind, SpringLaw ClothParameters::*law,
                const std::string& where) {
    rows.number_at(
        kind + ".stiffness", [law](ClothParameters& c) -> Real& { return (c.*law).stiffness; }, "N/m", {0, 1e9},
        "stiffness of the springs " + where);
    rows.number_at(
        kind + ".damping", [law](ClothParameters& c) -> Real& { return (c.*law).damping; }, "N s/m", {0, 1e6},
        "damping of the springs " + where);
}

/// Pins by name; a list has none.
std::span<const std::string> pin_names() {
    return names_of<Pins::Kind>().first(static_cast<std::size_t>(Pins::Kind::List));
}

SettingValue pins_value(const Pins& pins) {
    if (pins.kind == Pins::Kind::List) return Values(pins.list.begin(), pins.list.end());
    return name_of(pins.kind);
}

Pins pins_of(const SettingValue& value) {
    const auto* list = std::get_if<Values>(&value);
    if (list == nullptr) return {value_named<Pins::Kind>(std::get<std::string>(value)).value(), {}};
    Pins pins{Pins::Kind::List, {}};
    for (const double particle : *list) pins.list.push_back(static_cast<int>(particle));
    return pins;
}

/// Two numbers of particles, as a list and back.
Values grid_values(const Grid& grid) { return {static_cast<double>(grid.nx), static_cast<double>(grid.ny)}; }
Grid grid_of(const SettingValue& value) {
    const auto& list = std::get<Values>(value);
    return {static_cast<int>(list[0]), static_cast<int>(list[1])};
}

void add_cloth(std::vector<Setting>& table) {
    SectionRows<ClothParameters> rows(
        "cloth", [](Settings& s, std::size_t i) -> ClothParameters& { return s.cloths[i]; }, table);
    rows.add(
        "particles", SettingKind::Grid, "", {2, 4096}, {}, "columns and rows of particles",
        [](const ClothParameters& c) { return grid_values(c.particles); },
        [](ClothParameters& c, const SettingValue& value) { c.particles = grid_of(value); });
    rows.add(
        "size", SettingKind::Size, "m", sizes, {}, "along columns and rows",
        [](const ClothParameters& c) {
            return Values{static_cast<double>(c.width), static_cast<double>(c.height)};
        },
        [](ClothParameters& c, const SettingValue& value) {
            const auto& list = std::get<Values>(value);
            c.width = static_cast<Real>(list[0]);
            c.height = static_cast<Real>(list[1]);
        });
    rows.number("mass", &ClothParameters::mass, "kg", {1e-9, 1e6}, "of the whole cloth, pinned particles counted");
    rows.choice("plane", &ClothParameters::plane, "in which it starts: horizontal or vertical");
    rows.add(
        "origin", SettingKind::Vector, "m", lengths, {}, "where particle (0,0) starts",
        [](const ClothParameters& c) { return values_of(c.origin()); },
        [](ClothParameters& c, const SettingValue& value) { c.place = vector_of(value), c.centred = false; });
    rows.add(
        "centre", SettingKind::Vector, "m", lengths, {}, "where its centre starts, in place of origin",
        [](const ClothParameters& c) { return values_of(c.centre()); },
        [](ClothParameters& c, const SettingValue& value) { c.place = vector_of(value), c.centred = true; });
    rows.add(
        "pinned", SettingKind::Pins, "", {0, 4096.0 * 4096 - 1}, {pin_names().begin(), pin_names().end()},
        "which particles never move, by name or by number",
        [](const ClothParameters& c) { return pins_value(c.pinned); },
        [](ClothParameters& c, const SettingValue& value) { c.pinned = pins_of(value); });
    add_spring(rows, "structural", &ClothParameters::structural, "to the 4 neighbours");
    add_spring(rows, "shear", &ClothParameters::shear, "to the 4 diagonals");
    add_spring(rows, "bend", &ClothParameters::bend, "to the 4 at distance two along rows and columns");
    rows.number("drag", &ClothParameters::drag, "N s/m", {0, 1e3}, "b of the air drag -b v, per particle");
    rows.number("stretch_limit", &ClothParameters::stretch_limit, "", {0, 10},
                "largest stretch of a structural spring, of its rest length; 0: none");
}

Values path_values(const std::vector<PathPoint>& path) {
    Values values;
    for (const PathPoint& point : path) {
        values.push_back(static_cast<double>(point.time));
        for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<double>(point.centre[axis]));
    }
    return values;
}

std::vector<PathPoint> path_of(const SettingValue& value) {
    const auto& list = std::get<Values>(value);
    std::vector<PathPoint> path;
    for (std::size_t k = 0; k + 3 < list.size(); k += 4) {
        const auto at = [&](std::size_t offset) { return static_cast<Real>(list[k + offset]); };
        path.push_back({at(0), Vec3(at(1), at(2), at(3))});
    }
    return path;
}

/// A row that is points in time.
template <class Moved>
void add_path(SectionRows<Moved>& rows, const std::string& name, std::vector<PathPoint> Moved::*path,
              const std::string& unit, const std::string& help) {
    rows.add(
        name, SettingKind::Path, unit, lengths, {}, help,
        [path](const Moved& moved) { return path_values(moved.*path); },
        [path](Moved& moved, const SettingValue& value) { moved.*path = path_of(value); });
}

void add_ball(std::vector<Setting>& table) {
    SectionRows<BallSettings> rows(
        "ball", [](Settings& s, std::size_t i) -> BallSettings& { return s.balls[i]; }, table);
    rows.number("radius", &BallSettings::radius, "m", sizes, "of the ball");
    rows.vector("position", &BallSettings::position, "m", lengths, "of its centre at the start; not used on a path");
    rows.vector("velocity", &BallSettings::velocity, "m/s", {-1e3, 1e3}, "at the start, under the keys or free");
    rows.choice("motion", &BallSettings::motion,
                "what moves it: the arrow keys, its path, nothing, or (free) gravity and what it meets");
    rows.number("speed", &BallSettings::speed, "m/s", {0, 1e2}, "to which the keys bring it");
    rows.number("mass", &BallSettings::mass, "kg", {1e-9, 1e6}, "of a free ball, which is solid");
    add_path(rows, "path", &BallSettings::path, "s, m",
             "points t,x,y,z it passes on a smooth curve; repeats if the last is the first again");
}

void add_solid(std::vector<Setting>& table) {
    SectionRows<SolidSettings> rows(
        "solid", [](Settings& s, std::size_t i) -> SolidSettings& { return s.solids[i]; }, table);
    rows.choice("shape", &SolidSettings::shape, "a box, a capsule along its y axis, or a closed mesh of triangles");
    rows.vector("position", &SolidSettings::position, "m", lengths,
                "of its centre, or of a mesh's origin; not used on a path");
    rows.vector("axis", &SolidSettings::axis, "", {-1, 1}, "about which it is turned; not all zero");
    rows.number("angle", &SolidSettings::angle, "degree", {-360, 360}, "by which it is turned about the axis");
    rows.vector("size", &SolidSettings::size, "m", sizes, "of a box, along x, y and z");
    rows.number("radius", &SolidSettings::radius, "m", sizes, "of a capsule");
    rows.number("length", &SolidSettings::length, "m", sizes, "of the segment that a capsule is about");
    rows.add(
        "file", SettingKind::Text, "", any_text, {},
        "OBJ or STL file of a mesh, in metres; a scene names one in its own folder or below",
        [](const SolidSettings& s) { return s.file; },
        [](SolidSettings& s, const SettingValue& value) { s.file = std::get<std::string>(value); });
    rows.choice("motion", &SolidSettings::motion, "what moves it: nothing, or its path");
    add_path(rows, "path", &SolidSettings::path, "s, m",
             "points t,x,y,z its position passes on a smooth curve; repeats if the last is the first again");
}

void add_pins(std::vector<Setting>& table) {
    SectionRows<PinSettings> rows(
        "pins", [](Settings& s, std::size_t i) -> PinSettings& { return s.pins[i]; }, table);
    rows.integer("cloth", &PinSettings::cloth, {0, 63}, "number of the cloth that they pin, counted from 0");
    rows.add(
        "particles", SettingKind::Grid, "", {0, 4096.0 * 4096 - 1}, {},
        "those that cloth.pinned pins from the first to the second of these particles move together",
        [](const PinSettings& p) { return grid_values(p.particles); },
        [](PinSettings& p, const SettingValue& value) { p.particles = grid_of(value); });
    add_path(rows, "shift", &PinSettings::shift, "s, m",
             "points t,x,y,z of their way from where they start, on a smooth curve; repeats if the last is the first "
             "again");
    add_path(rows, "turns", &PinSettings::turns, "s, turns",
             "points t,x,y,z of whole turns about the direction x,y,z through their middle; likewise");
}

void add_needs(std::vector<Setting>& table) {
    SectionRows<NeedsSettings> needs(
        "needs", [](Settings& s, std::size_t) -> NeedsSettings& { return s.needs; }, table);
    needs.number("position_error", &NeedsSettings::position_error, "", {0, 1},
                 "of the cloth's side, that the scene allows against its full model up to the horizon; 0: not stated");
    needs.choice(
        "measure", &NeedsSettings::measure,
        "of that error: RMS over the particles; or centre of mass and spread about it, where motion is chaotic");
    needs.number("horizon", &NeedsSettings::horizon, "s", {1e-9, 1e3}, "time up to which needs count");
    needs.number("penetration", &NeedsSettings::penetration, "m", {0, 1},
                 "largest that the scene allows after any step's response (its last substep's); 0: not stated");
    needs.number("stretch", &NeedsSettings::stretch, "", {0, 1e3},
                 "largest of a structural spring that the scene allows after any step; 0: not stated");
    needs.number("least_stretch", &NeedsSettings::least_stretch, "", {0, 1e3},
                 "that the scene must show after some step, to be soft; 0: not stated");
    needs.flag("diverges", &NeedsSettings::diverges,
               "the scene must have diverged by the horizon, to show how a method fails");
    needs.add(
        "keep", SettingKind::Text, "", any_text, {},
        "knobs that stay as they are by the scene's nature: particles, bend, drag, integrator, dt, iterations, volume, "
        "update, sphere_fit, leaf_cells, with commas between",
        [](const NeedsSettings& n) { return n.keep; },
        [](NeedsSettings& n, const SettingValue& value) { n.keep = std::get<std::string>(value); });
    needs.add(
        "full.particles", SettingKind::Grid, "", {0, 4096}, {}, "of the full model; 0,0: as in [cloth]",
        [](const NeedsSettings& n) { return grid_values(n.full.particles); },
        [](NeedsSettings& n, const SettingValue& value) { n.full.particles = grid_of(value); });
    needs.number_at(
        "full.bend.stiffness", [](NeedsSettings& n) -> Real& { return n.full.bend.stiffness; }, "N/m", {0, 1e9},
        "of the full model; without it and its damping: as in [cloth]");
    needs.number_at(
        "full.bend.damping", [](NeedsSettings& n) -> Real& { return n.full.bend.damping; }, "N s/m", {0, 1e6},
        "of the full model");
    needs.number_at(
        "full.drag", [](NeedsSettings& n) -> Real& { return n.full.drag; }, "N s/m", {0, 1e3},
        "of the full model, per particle of its grid; 0: the same on the whole cloth as in [cloth]");
}

void add_the_rest(std::vector<Setting>& table) {
    SectionRows<SolverSettings> solver(
        "solver", [](Settings& s, std::size_t) -> SolverSettings& { return s.solver; }, table);
    solver.choice("integrator", &SolverSettings::integrator, "how a step is made");
    solver.choice("hessian", &SolverSettings::hessian,
                  "of the implicit methods: without or with the negative stiffness across a compressed spring");
    solver.integer("iterations", &SolverSettings::iterations, {1, 1000}, "of xpbd and projective_dynamics in one step");
    solver.number(
        "tolerance", &SolverSettings::tolerance, "", {1e-14, 0.1},
        "of dormand_prince: error of an inner step, of the cloth's spacing; at most 10000 are tried in a step");
    solver.integer(
        "threads", &SolverSettings::threads, {1, 64},
        "that share a step of the explicit methods, and the search where cloths touch; the motion is the same");
    solver.choice("kernels", &SolverSettings::kernels,
                  "of forces, hierarchy and contact: vectors, or the plain code that is there to be read");
    solver.number("dt", &SolverSettings::dt, "s", {1e-9, 0.1}, "length of one step");
    solver.choice(
        "on_unstable", &SolverSettings::on_unstable,
        "substep: divide a step longer than 0.9 of its limit, as predicted every 0.25 s and after a change, into "
        "substeps; when the state has diverged, warn: the window freezes the last good one, stop: it ends, as other "
        "programs always do; when a step was not solved to its tolerance or the method has added energy, stop: every "
        "program ends, warn and substep: the run is marked");
    solver.number("sleep_speed", &SolverSettings::sleep_speed, "m/s", {0, 1},
                  "a scene that is slower for half a second falls asleep; 0: never");

    solver.flag("ledger", &SolverSettings::ledger, "keep the balance of the energy, for panel and CSV");

    SectionRows<ContactSettings> contact(
        "contact", [](Settings& s, std::size_t) -> ContactSettings& { return s.contact; }, table);
    contact.choice("volume", &ContactSettings::volume, "of the hierarchy; brute tests every cell");
    contact.choice("update", &ContactSettings::update, "how the hierarchy follows the cloth");
    contact.choice("sphere_fit", &ContactSettings::sphere_fit,
                   "how a sphere is put about particles, where the volume is one");
    contact.integer("leaf_cells", &ContactSettings::leaf_cells, {0, 64},
                    "a leaf has at most this many cells squared; 0: 7 or 15, by size");
    contact.integer("search_level", &ContactSettings::search_level, {0, SearchLimit::all_levels},
                    "level at which a search ends, its nodes taken as spheres; 30: at the leaves");
    contact.integer("search_tests", &ContactSettings::search_tests, {0, 1e9},
                    "volume tests after which a search ends; 0: no end");
    contact.choice("response", &ContactSettings::response, "how contacts are answered");
    contact.number("friction", &ContactSettings::friction, "", {0, 10},
                   "Coulomb coefficient of balls, with cloth and each other, and of solids");
    table.back().usual_high = usual_friction;
    contact.number("rolling", &ContactSettings::rolling, "", {0, 1},
                   "coefficient of rolling resistance of free balls on cloth and solids");
    contact.number("restitution", &ContactSettings::restitution, "", {0, 1}, "of the normal speed");
    contact.number("thickness", &ContactSettings::thickness, "m", {0, 1}, "by which the cloth is grown on both sides");
    contact.number("stiffness", &ContactSettings::stiffness, "N/m", {1e-3, 1e9},
                   "of a penalty's spring k, one a contact; a particle of mass m needs a step below 0.83 sqrt(m/k), or "
                   "up to 2 sqrt(m/k) "
                   "with restitution");
    contact.add(
        "longest_step", SettingKind::Number, "s", {1e-6, 1}, {},
        "while anything touches, and under xpbd always in a scene with a free ball, a longer step of an implicit "
        "method is divided into substeps, so that what rests is not moved farther within one than contact can put back "
        "without stretching the cloth",
        [](const ContactSettings& c) { return c.longest_step; },
        [](ContactSettings& c, const SettingValue& value) { c.longest_step = std::get<double>(value); });
    contact.choice("continuous", &ContactSettings::continuous,
                   "look for what balls and solids meet within a step, not only at its end; auto is the same as true");
    contact.flag("self", &ContactSettings::self,
                 "cloths meet themselves and each other, and keep apart by contact.thickness, but by no more than half "
                 "of what particles are from the diagonals beside them; always answered by projection");

    SectionRows<Ground> ground(
        "ground", [](Settings& s, std::size_t) -> Ground& { return s.ground; }, table);
    ground.number("height", &Ground::height, "m", lengths, "of the plane that is drawn");
    ground.flag("solid", &Ground::solid, "cloth and balls stay above it; a ball on a path goes where that leads");
    ground.number("friction", &Ground::friction, "", {0, 10}, "Coulomb coefficient of what lies on it");
    table.back().usual_high = usual_friction;
    ground.number("restitution", &Ground::restitution, "", {0, 1}, "of the normal speed");
    ground.number("rolling", &Ground::rolling, "", {0, 1}, "coefficient of rolling resistance of free balls");

    for (Setting& setting : table) {
        if (setting.section == "ground") setting.full_name_only = true;
    }

    SectionRows<WorldSettings> world(
        "world", [](Settings& s, std::size_t) -> WorldSettings& { return s.world; }, table);
    world.number("gravity", &WorldSettings::gravity, "m/s^2", {0, 50}, "of cloths and free balls, downwards");

    SectionRows<WindSettings> wind(
        "wind", [](Settings& s, std::size_t) -> WindSettings& { return s.wind; }, table);
    wind.flag("on", &WindSettings::on, "let the wind blow");
    wind.vector("velocity", &WindSettings::velocity, "m/s", {-100, 100}, "mean velocity of the air");
    wind.number("gust", &WindSettings::gust, "", {0, 1}, "amplitude of the gusts over the mean");

    SectionRows<ViewSettings> view(
        "view", [](Settings& s, std::size_t) -> ViewSettings& { return s.view; }, table);
    view.choice("panel", &ViewSettings::panel, "how much the stats panel shows");
    view.number("text_scale", &ViewSettings::text_scale, "", {0.5, 4}, "text size; it scales with the window");
    view.flag("controls", &ViewSettings::controls, "show the settings panel, in the window");
    view.flag("plots", &ViewSettings::plots, "plot times, energy, contacts, nodes and dt / limit of the last 10 s");
    view.flag("help", &ViewSettings::help, "show keys and menu");
    view.flag("bounds", &ViewSettings::bounds, "show the bounding volumes of a level");
    view.integer("level", &ViewSettings::level, {0, 30},
                 "of the hierarchy whose bounds are shown; 0 is the root, and past the finest are all");
    view.flag("wireframe", &ViewSettings::wireframe, "show the triangles' edges");
    view.flag("particles", &ViewSettings::particles, "show particles and springs");
    view.flag("contacts", &ViewSettings::contacts, "show contact points and normals");
    view.choice("colour", &ViewSettings::colour,
                "what the cloth's colour says: nothing, strain, speed, contact depth, the node of the shown level, "
                "side, difference from what is compared");
    view.flag("weave", &ViewSettings::weave, "show the cloth's weave, which stretches with it");
    view.flag("smooth", &ViewSettings::smooth, "draw the cloth's outline as curves through its particles");
    view.flag("grid", &ViewSettings::grid,
              "show a grid on the ground, a line every 10 cm and a stronger one every metre");
    view.choice("quality", &ViewSettings::quality,
                "fast: half the width and height, one sample a pixel, fewer particles of a large cloth; auto: "
                "so in a window that is slow, while something moves");
    view.vector("eye", &ViewSettings::eye, "m", lengths, "where the camera starts");
    view.vector("target", &ViewSettings::target, "m", lengths, "what the camera looks at");
    view.number("speed", &ViewSettings::speed, "", {1e-4, 100},
                "simulated seconds in a second at the window: 1 is real time, less is slow motion");

    add_needs(table);
}

std::vector<Setting> make_table() {
    std::vector<Setting> table;
    SectionRows<Settings> top(
        "", [](Settings& s, std::size_t) -> Settings& { return s; }, table);
    top.add(
        "title", SettingKind::Text, "", any_text, {}, "one line that names the scene",
        [](const Settings& s) { return s.title; },
        [](Settings& s, const SettingValue& value) { s.title = std::get<std::string>(value); });
    top.add(
        "start", SettingKind::Text, "", any_text, {},
        "file written by --state in whose last moment cloths and balls start, at its time; cloth.origin, ball.position "
        "and ball.velocity are not used then; a scene names one in its own folder or below",
        [](const Settings& s) { return s.start; },
        [](Settings& s, const SettingValue& value) { s.start = std::get<std::string>(value); });
    add_cloth(table);
    add_ball(table);
    add_solid(table);
    add_pins(table);
    for (Setting& setting : table) {
        if (setting.section == "solid" || setting.section == "pins") setting.full_name_only = true;
    }
    add_the_rest(table);
    return table;
}

}  // namespace

std::span<const Setting> setting_table() {
    static const std::vector<Setting> table = make_table();
    return table;
}

}  // namespace drape
