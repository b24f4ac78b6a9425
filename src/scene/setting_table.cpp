#include "drape/scene/setting_table.h"

#include "setting_rows.h"

namespace drape {

SettingValue setting_value(const Vec3& v) {
    return std::vector{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

void take(const SettingValue& value, Vec3& v) {
    const auto& list = std::get<std::vector<double>>(value);
    for (int axis = 0; axis < 3; ++axis) v[axis] = static_cast<Real>(list[static_cast<std::size_t>(axis)]);
}

SettingValue setting_value(const Grid& grid) {
    return std::vector{static_cast<double>(grid.nx), static_cast<double>(grid.ny)};
}

void take(const SettingValue& value, Grid& grid) {
    const auto& list = std::get<std::vector<double>>(value);
    grid = {static_cast<int>(list[0]), static_cast<int>(list[1])};
}

SettingValue setting_value(const Pins& pins) {
    if (pins.kind == Pins::Kind::List) return std::vector<double>(pins.list.begin(), pins.list.end());
    return name_of(pins.kind);
}

void take(const SettingValue& value, Pins& pins) {
    const auto* list = std::get_if<std::vector<double>>(&value);
    pins = {list != nullptr ? Pins::Kind::List : value_named<Pins::Kind>(std::get<std::string>(value)).value(), {}};
    if (list == nullptr) return;
    for (const double particle : *list) pins.list.push_back(static_cast<int>(particle));
}

SettingValue setting_value(const std::vector<PathPoint>& path) {
    std::vector<double> values;
    for (const PathPoint& point : path) {
        values.push_back(static_cast<double>(point.time));
        for (const Real x : point.centre) values.push_back(static_cast<double>(x));
    }
    return values;
}

void take(const SettingValue& value, std::vector<PathPoint>& path) {
    const auto& list = std::get<std::vector<double>>(value);
    path.clear();
    for (std::size_t k = 0; k + 3 < list.size(); k += 4) {
        const auto at = [&](std::size_t offset) { return static_cast<Real>(list[k + offset]); };
        path.push_back({at(0), Vec3(at(1), at(2), at(3))});
    }
}

namespace {

using Values = std::vector<double>;

constexpr Range lengths{-1e4, 1e4};   // m: everything happens within ten kilometres
constexpr Range sizes{1e-6, 1e4};     // m
constexpr double usual_friction = 2;  // rubber

void add_spring(SectionRows<ClothParameters>& rows, const std::string& kind, SpringLaw ClothParameters::*law,
                const std::string& where) {
    rows.add(
        kind + ".stiffness", [law](auto& c) -> auto& { return (c.*law).stiffness; }, "N/m", {0, 1e9},
        "stiffness of the springs " + where);
    rows.add(
        kind + ".damping", [law](auto& c) -> auto& { return (c.*law).damping; }, "N s/m", {0, 1e6},
        "damping of the springs " + where);
}

void add_cloth(std::vector<Setting>& table) {
    auto rows = SectionRows<ClothParameters>::of_several<&Settings::cloths>("cloth", table);
    rows.add("particles", &ClothParameters::particles, "", {2, 4096}, "columns and rows of particles");
    rows.add(
        "size", SettingKind::Size, "m", sizes, "along columns and rows",
        [](const ClothParameters& c) {
            return Values{static_cast<double>(c.width), static_cast<double>(c.height)};
        },
        [](ClothParameters& c, const SettingValue& value) {
            const auto& list = std::get<Values>(value);
            c.width = static_cast<Real>(list[0]);
            c.height = static_cast<Real>(list[1]);
        });
    rows.add("mass", &ClothParameters::mass, "kg", {1e-9, 1e6}, "of the whole cloth, pinned particles counted");
    rows.add("plane", &ClothParameters::plane, "in which it starts: horizontal or vertical");
    rows.add(
        "origin", SettingKind::Vector, "m", lengths, "where particle (0,0) starts",
        [](const ClothParameters& c) { return setting_value(c.origin()); },
        [](ClothParameters& c, const SettingValue& value) { take(value, c.place), c.centred = false; });
    rows.add(
        "centre", SettingKind::Vector, "m", lengths, "where its centre starts, in place of origin",
        [](const ClothParameters& c) { return setting_value(c.centre()); },
        [](ClothParameters& c, const SettingValue& value) { take(value, c.place), c.centred = true; });
    rows.add("pinned", &ClothParameters::pinned, "", {0, 4096.0 * 4096 - 1},
             "which particles never move, by name or by number");
    const auto pins = names_of<Pins::Kind>().first(static_cast<std::size_t>(Pins::Kind::List));
    table.back().choices.assign(pins.begin(), pins.end());
    add_spring(rows, "structural", &ClothParameters::structural, "to the 4 neighbours");
    add_spring(rows, "shear", &ClothParameters::shear, "to the 4 diagonals");
    add_spring(rows, "bend", &ClothParameters::bend, "to the 4 at distance two along rows and columns");
    rows.add("drag", &ClothParameters::drag, "N s/m", {0, 1e3}, "b of the air drag -b v, per particle");
    rows.add("stretch_limit", &ClothParameters::stretch_limit, "", {0, 10},
             "largest stretch of a structural spring, of its rest length; 0: none");
    table.back().word = {0, "none"};
}

void add_ball(std::vector<Setting>& table) {
    auto rows = SectionRows<BallSettings>::of_several<&Settings::balls>("ball", table);
    rows.add("radius", &BallSettings::radius, "m", sizes, "of the ball");
    rows.add("position", &BallSettings::position, "m", lengths, "of its centre at the start; not used on a path");
    rows.add("velocity", &BallSettings::velocity, "m/s", {-1e3, 1e3}, "at the start, under the keys or free");
    rows.add("motion", &BallSettings::motion,
             "what moves it: the arrow keys, its path, nothing, or (free) gravity and what it meets");
    rows.add("speed", &BallSettings::speed, "m/s", {0, 1e2}, "to which the keys bring it");
    rows.add("mass", &BallSettings::mass, "kg", {1e-9, 1e6}, "of a free ball, which is solid");
    rows.add("path", &BallSettings::path, "s, m", lengths,
             "points t,x,y,z it passes on a smooth curve; repeats if the last is the first again");
}

void add_solid(std::vector<Setting>& table) {
    auto rows = SectionRows<SolidSettings>::of_several<&Settings::solids>("solid", table);
    rows.add("shape", &SolidSettings::shape, "a box, a capsule along its y axis, or a closed mesh of triangles");
    rows.add("position", &SolidSettings::position, "m", lengths,
             "of its centre, or of a mesh's origin; not used on a path");
    rows.add("axis", &SolidSettings::axis, "", {-1, 1}, "about which it is turned; not all zero");
    rows.add("angle", &SolidSettings::angle, "degree", {-360, 360}, "by which it is turned about the axis");
    rows.add("size", &SolidSettings::size, "m", sizes, "of a box, along x, y and z");
    rows.add("radius", &SolidSettings::radius, "m", sizes, "of a capsule");
    rows.add("length", &SolidSettings::length, "m", sizes, "of the segment that a capsule is about");
    rows.add("file", &SolidSettings::file,
             "OBJ or STL file of a mesh, in metres; a scene names one in its own folder or below");
    rows.add("motion", &SolidSettings::motion, "what moves it: nothing, or its path");
    rows.add("path", &SolidSettings::path, "s, m", lengths,
             "points t,x,y,z its position passes on a smooth curve; repeats if the last is the first again");
}

void add_pins(std::vector<Setting>& table) {
    auto rows = SectionRows<PinSettings>::of_several<&Settings::pins>("pins", table);
    rows.add("cloth", &PinSettings::cloth, "", {0, 63}, "number of the cloth that they pin, counted from 0");
    rows.add("particles", &PinSettings::particles, "", {0, 4096.0 * 4096 - 1},
             "those that cloth.pinned pins from the first to the second of these particles move together");
    rows.add("shift", &PinSettings::shift, "s, m", lengths,
             "points t,x,y,z of their way from where they start, on a smooth curve; repeats if the last is the first "
             "again");
    rows.add("turns", &PinSettings::turns, "s, turns", lengths,
             "points t,x,y,z of whole turns about the direction x,y,z through their middle; likewise");
}

void add_needs(std::vector<Setting>& table) {
    SectionRows<NeedsSettings> needs("needs", &Settings::needs, table);
    needs.add("position_error", &NeedsSettings::position_error, "", {0, 1},
              "of the cloth's side, that the scene allows against its full model up to the horizon; 0: not stated");
    needs.add("measure", &NeedsSettings::measure,
              "of that error: RMS over the particles; or centre of mass and spread about it, where motion is chaotic");
    needs.add("horizon", &NeedsSettings::horizon, "s", {1e-9, 1e3}, "time up to which needs count");
    needs.add("penetration", &NeedsSettings::penetration, "m", {0, 1},
              "largest that the scene allows after any step's response (its last substep's); 0: not stated");
    needs.add("stretch", &NeedsSettings::stretch, "", {0, 1e3},
              "largest of a structural spring that the scene allows after any step; 0: not stated");
    needs.add("min_stretch", &NeedsSettings::min_stretch, "", {0, 1e3},
              "that the scene must show after some step, to be soft; 0: not stated");
    needs.add("diverges", &NeedsSettings::diverges,
              "the scene must have diverged by the horizon, to show how a method fails");
    needs.add("keep", &NeedsSettings::keep,
              "what stays as it is by the scene's nature: particles, bend, drag, integrator, dt, iterations, "
              "volume, update, sphere_fit, leaf_cells, with commas between");
    needs.add(
        "full.particles", [](auto& n) -> auto& { return n.full.particles; }, "", {0, 4096},
        "of the full model; 0,0: as in [cloth]");
    needs.add(
        "full.bend.stiffness", [](auto& n) -> auto& { return n.full.bend.stiffness; }, "N/m", {0, 1e9},
        "of the full model; without it and its damping: as in [cloth]");
    needs.add(
        "full.bend.damping", [](auto& n) -> auto& { return n.full.bend.damping; }, "N s/m", {0, 1e6},
        "of the full model");
    needs.add(
        "full.drag", [](auto& n) -> auto& { return n.full.drag; }, "N s/m", {0, 1e3},
        "of the full model, per particle of its grid; 0: the same on the whole cloth as in [cloth]");
}

void add_the_rest(std::vector<Setting>& table) {
    SectionRows<SolverSettings> solver("solver", &Settings::solver, table);
    solver.add("integrator", &SolverSettings::integrator,
               "method that makes a step from forces, positions and velocities");
    solver.add("hessian", &SolverSettings::hessian,
               "of the implicit methods: without or with the negative stiffness across a compressed spring");
    solver.add("iterations", &SolverSettings::iterations, "", {1, 1000}, "of xpbd and projective_dynamics in one step");
    solver.add("tolerance", &SolverSettings::tolerance, "", {0, 0.1},
               "of backward_euler, implicit_midpoint and bdf2: what a solve may leave, of its right side (0: 1e-4, of "
               "implicit_midpoint 1e-6, with the exact Hessian 1e-8); of dormand_prince: error of an inner step, of "
               "the cloth's spacing (0: 1e-6), of which at most 10000 are tried in a step");
    table.back().word = {0, "auto"};
    solver.add("threads", &SolverSettings::threads, "", {1, 64},
               "that share a step of the explicit and the implicit methods, and the search where cloths touch; the "
               "motion is the same");
    solver.add("kernels", &SolverSettings::kernels,
               "of forces, hierarchy and detection: vectors, or the plain code that is there to be read");
    solver.add("dt", &SolverSettings::dt, "s", {1e-9, 0.1}, "length of one step");
    solver.add(
        "on_unstable", &SolverSettings::on_unstable,
        "substep: divide a step longer than 0.9 of its limit, as predicted every 0.25 s and after a change, into "
        "substeps; when the state has diverged, warn: the window freezes the last good one, stop: it ends, as other "
        "programs always do; when a step was not solved to its tolerance or the method has added energy, stop: every "
        "program ends, warn and substep: the run is marked");
    solver.add("sleep_speed", &SolverSettings::sleep_speed, "m/s", {0, 1},
               "a scene that is slower for half a second falls asleep; 0: never");
    table.back().word = {0, "never"};

    solver.add("ledger", &SolverSettings::ledger, "keep the balance of the energy, for panel and CSV");
    solver.add(
        "newton_steps", &SolverSettings::newton_steps, "", {1, 20},
        "of backward_euler, implicit_midpoint and bdf2 in one step, at most; 1: its equations are solved as if linear");

    SectionRows<ContactSettings> contact("contact", &Settings::contact, table);
    contact.add(
        "volume", &ContactSettings::volume,
        "shape around each node of the tree: spheres, boxes (aabb; obb: turned with the cloth) or boxes with cut "
        "edges (kdop); brute: no tree, every cell is tested, and with contact.self every pair of cells");
    contact.add("update", &ContactSettings::update,
                "how the tree follows the cloth: rebuild, from the root down; merge, from the leaves up; refit, where "
                "the cloth "
                "moved; insertion, cell by cell; none, the first tree stays");
    contact.add(
        "sphere_fit", &ContactSettings::sphere_fit,
        "how a sphere is put around particles, where the volume is one: from quick and loose (centroid) to slow "
        "and tight (welzl, the smallest)");
    contact.add("leaf_cells", &ContactSettings::leaf_cells, "", {0, 64},
                "a leaf has at most this many cells squared; 0, auto: 7 or 15, by size");
    table.back().word = {0, "auto"};
    contact.add(
        "search_level", [](auto& c) -> auto& { return c.search.level; }, "", {0, SearchLimit::all_levels},
        "level at which a search ends, its nodes taken as spheres; 30, unlimited: at the leaves");
    table.back().word = {SearchLimit::all_levels, "unlimited"};
    contact.add(
        "search_tests", [](auto& c) -> auto& { return c.search.tests; }, "", {0, 1e9},
        "volume tests after which a search ends; 0, unlimited: no end");
    table.back().word = {0, "unlimited"};
    table.back().usual_high = 1000;
    contact.add("response", &ContactSettings::response, "how contacts are answered");
    contact.add("friction", &ContactSettings::friction, "", {0, 10},
                "Coulomb coefficient of balls, with cloth and each other, and of solids");
    table.back().usual_high = usual_friction;
    contact.add("rolling", &ContactSettings::rolling, "", {0, 1},
                "coefficient of rolling resistance of free balls on cloth and solids");
    contact.add("restitution", &ContactSettings::restitution, "", {0, 1}, "of the normal speed");
    contact.add("thickness", &ContactSettings::thickness, "m", {0, 1}, "by which the cloth is grown on both sides");
    contact.add("stiffness", &ContactSettings::stiffness, "N/m", {1e-3, 1e9},
                "of a penalty's spring k, one a contact; a particle of mass m needs a step below 0.83 sqrt(m/k), or "
                "up to 2 sqrt(m/k) "
                "with restitution");
    contact.add(
        "longest_step", &ContactSettings::longest_step, "s", {1e-6, 1},
        "while anything touches, and always where the response has penalties, a longer step of a method without a step "
        "limit is divided into substeps, so that what rests is not moved farther within one than contact can put back "
        "without stretching the cloth");
    contact.add("continuous", &ContactSettings::continuous,
                "look for what balls and solids meet within a step, not only at its end; auto is the same as true");
    contact.add("self", &ContactSettings::self,
                "cloths meet themselves and each other, and keep apart by contact.thickness, but by no more than half "
                "of what particles are from the diagonals beside them; always answered by projection");

    SectionRows<Ground> ground("ground", &Settings::ground, table);
    ground.add("height", &Ground::height, "m", lengths, "of the plane that is drawn");
    ground.add("solid", &Ground::solid, "cloth and balls stay above it; a ball on a path goes where that leads");
    ground.add("friction", &Ground::friction, "", {0, 10}, "Coulomb coefficient of what lies on it");
    table.back().usual_high = usual_friction;
    ground.add("restitution", &Ground::restitution, "", {0, 1}, "of the normal speed");
    ground.add("rolling", &Ground::rolling, "", {0, 1}, "coefficient of rolling resistance of free balls");

    SectionRows<WorldSettings> world("world", &Settings::world, table);
    world.add("gravity", &WorldSettings::gravity, "m/s^2", {0, 50}, "of cloths and free balls, downwards");

    SectionRows<WindSettings> wind("wind", &Settings::wind, table);
    wind.add("on", &WindSettings::on, "let the wind blow");
    wind.add("velocity", &WindSettings::velocity, "m/s", {-100, 100}, "mean velocity of the air");
    wind.add("gust", &WindSettings::gust, "", {0, 1}, "amplitude of the gusts over the mean");

    SectionRows<ViewSettings> view("view", &Settings::view, table);
    view.add("panel", &ViewSettings::panel, "how much the stats panel shows");
    view.add("text_scale", &ViewSettings::text_scale, "", {0.5, 4}, "text size; it scales with the window");
    view.add("controls", &ViewSettings::controls, "show the settings panel, in the window");
    view.add("plots", &ViewSettings::plots, "plot times, energy, contacts, nodes and dt / limit of the last 10 s");
    view.add("help", &ViewSettings::help, "show keys and menu");
    view.add("bounds", &ViewSettings::bounds, "show the bounding volumes of a level");
    view.add("level", &ViewSettings::level, "", {0, 30},
             "of the hierarchy whose bounds are shown; 0 is the root, and past the finest are all");
    table.back().word = {30, "all"};
    view.add("wireframe", &ViewSettings::wireframe, "show the triangles' edges");
    view.add("particles", &ViewSettings::particles, "show particles and springs");
    view.add("contacts", &ViewSettings::contacts, "show where cloth touches bodies, and with what force");
    view.add("colour", &ViewSettings::colour,
             "what the cloth's colour says: nothing, strain, the same with its principal directions, speed, contact "
             "depth, the node of the shown level, side, difference from what is compared");
    view.add("weave", &ViewSettings::weave, "show the cloth's weave, which stretches with it");
    view.add("smooth", &ViewSettings::smooth,
             "draw the cloth's outline as curves through its particles, and its edge as thick as contact.thickness");
    view.add("grid", &ViewSettings::grid,
             "show a grid on the ground, a line every 10 cm and a stronger one every metre");
    view.add("quality", &ViewSettings::quality,
             "fast: half the width and height, fewer particles of a large cloth; auto: "
             "so in a window that is slow, while something moves (FPS: coarse)");
    view.add("eye", &ViewSettings::eye, "m", lengths, "where the camera starts");
    view.add("target", &ViewSettings::target, "m", lengths, "what the camera looks at");
    view.add("speed", &ViewSettings::speed, "", {1e-4, 100},
             "simulated seconds in a second at the window: 1 is real time, less is slow motion");
    view.add("repeat", &ViewSettings::repeat, "s", {0, 10},
             "time at which the window begins the scene again, once, ten times as slow; 0: never");
    table.back().word = {0, "never"};
    view.add("fabric", &ViewSettings::fabric, "what the cloth looks like; plain: one colour in simple light");
    view.add("palette", &ViewSettings::palette, "colours of cloths, ground and wall");

    add_needs(table);
}

std::vector<Setting> make_table() {
    std::vector<Setting> table;
    SectionRows<Settings> top(
        "", [](Settings& s, std::size_t) -> Settings& { return s; }, table);
    top.add("title", &Settings::title, "one line that names the scene");
    top.add(
        "start", &Settings::start,
        "file written by --state in whose last moment cloths and balls start, at its time; cloth.origin, ball.position "
        "and ball.velocity are not used then; a scene names one in its own folder or below");
    add_cloth(table);
    add_ball(table);
    add_solid(table);
    add_pins(table);
    add_the_rest(table);
    return table;
}

}  // namespace

std::span<const Setting> setting_table() {
    static const std::vector<Setting> table = make_table();
    return table;
}

}  // namespace drape
