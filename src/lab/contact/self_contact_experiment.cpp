#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "contact_trial.h"
#include "drape/base/exact_math.h"
#include "drape/base/input_error.h"
#include "drape/contact/near_pairs.h"
#include "lab/experiments.h"

namespace drape {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

/// Waved along both axes, by amplitudes at which it nearly keeps its rest lengths.
void wave(Points& x) {
    for (Eigen::Index p = 0; p < x.rows(); ++p)
        x(p, 1) += static_cast<Real>(0.01 * sine(9 * x(p, 0)) + 0.006 * sine(13 * x(p, 2) + right_angle));
}

/// About the middle.
void turn(Points& x, const Vec3& axis, Real angle) {
    const Eigen::RowVector<Real, 3> middle = x.colwise().mean();
    Eigen::Quaternion<Real> turned;
    turned.w() = static_cast<Real>(sine(angle / 2 + right_angle));
    turned.vec() = static_cast<Real>(sine(angle / 2)) * axis.normalized();
    const Eigen::Matrix<Real, 3, 3> rotation = turned.toRotationMatrix();
    x = ((x.rowwise() - middle) * rotation.transpose()).rowwise() + middle;
}

/// Makes a step, or takes it back and makes it in two halves. What is made again starts with no pushes: those of the
/// try are not what the halves need.
void make(ContactTrial& sheets, FailSafe fail_safe, Real h, int halvings_left, SelfContactCounts& counts) {
    const std::array start{sheets.cloths[0].state, sheets.cloths[1].state};
    const bool rejects = fail_safe == FailSafe::Rejection;
    sheets.advance(h);
    sheets.stage.solve(sheets.report);
    if (fail_safe == FailSafe::Zones) sheets.stage.prevent_crossing(sheets.report);
    const bool would_cross = rejects && sheets.stage.would_cross();
    sheets.stage.end();
    const SelfSearchReport& search = sheets.stage.self().report();
    counts["held_back"] += sheets.report.failsafe_particles;
    counts["pair_tests"] += search.traversal.volume_tests + search.listed;
    if (!would_cross && !search.gave_up) return;
    if (!rejects || halvings_left == 0) {
        if (search.gave_up) counts["unsearched_steps"] = 1;
        if (rejects) counts["unsafe_steps"] = 1;
        return;
    }
    for (std::size_t s = 0; s < start.size(); ++s) sheets.cloths[s].state = start[s];
    sheets.stage.clear();
    ++counts["rejected"];
    for (int half = 0; half < 2; ++half) make(sheets, fail_safe, h / 2, halvings_left - 1, counts);
}

constexpr double sheet_seconds = 0.1;

/// What one run saw.
struct SelfContactRun {
    Row row;
    Vec3 given;  ///< momentum that the first sheet has lost at the end [kg m/s]
};

SelfContactRun watch_sheets(const ContactScene& scene, double step, FailSafe fail_safe) {
    ContactTrial sheets(scene.settings, scene.start);
    const Vec3 first = sheets.momentum(0), both = first + sheets.momentum(1);
    const auto steps = std::llround(sheet_seconds / step);
    const double share = 1 / static_cast<double>(steps);
    SheetMeeting meeting;
    Real penetration = 0;
    std::map<std::string, double> means;
    for (std::int64_t k = 0; k < steps; ++k) {
        SelfContactCounts counts = make_step(sheets, fail_safe, static_cast<Real>(step));
        meeting = meeting_of(sheets);
        counts["crossed_steps"] = meeting.crossings > 0;
        for (const auto& [column, count] : counts) means[column] += share * static_cast<double>(count);
        penetration = std::max(penetration, meeting.penetration);
    }
    Row row{{"step_s", step},
            {"fail_safe", fail_safe},
            {"crossings", meeting.crossings},
            {"penetration_m", penetration},
            {"momentum_change", (sheets.momentum(0) + sheets.momentum(1) - both).norm() / both.norm()}};
    for (const auto& [column, mean] : means) row.set(column, mean);
    return {row, first - sheets.momentum(0)};
}

/// CPU time for a simulated second, without an observer.
double time_sheets(const ContactScene& scene, double step, FailSafe fail_safe) {
    ContactTrial sheets(scene.settings, scene.start);
    const auto steps = std::llround(sheet_seconds / step);
    return cpu_time_of([&] { make_step(sheets, fail_safe, static_cast<Real>(step)); }, steps) / step;
}

/// The runs of a thickness, those of each step timed in turn.
/// @throws RunError if the reference itself fails
Rows run_thickness(double thickness, const std::vector<double>& rates, int finer, int repeats) {
    constexpr Real speed = 8;  // m/s
    const ContactScene scene = throw_sheet(speed, static_cast<Real>(thickness));
    const SelfContactRun reference = watch_sheets(scene, 1 / (finer * rates.back()), FailSafe::Zones);
    if (reference.row.number("crossed_steps") > 0 || reference.row.number("unsearched_steps") > 0) {
        throw RunError("self_contact: sheets of the reference have crossed");
    }
    Rows rows;
    for (const double rate : rates) {
        std::map<FailSafe, std::vector<double>> cpu;
        for (int repeat = 0; repeat < repeats; ++repeat) {
            for (const FailSafe safe : values_of<FailSafe>()) cpu[safe].push_back(time_sheets(scene, 1 / rate, safe));
        }
        for (const auto& [fail_safe, times] : cpu) {
            auto [row, given] = watch_sheets(scene, 1 / rate, fail_safe);
            row.set("momentum_error", (given - reference.given).norm() / reference.given.norm());
            row.set("cpu_s_per_s", quartiles_of(times));
            rows.push_back(row);
        }
    }
    return rows;
}

}  // namespace

ContactScene throw_sheet(Real speed, Real thickness) {
    ContactScene scene;
    Settings& settings = scene.settings;
    std::vector<ClothState>& start = scene.start.states;
    settings.cloths.clear();
    settings.world.gravity = 0;
    // So far that waves and turns leave a gap, and beside each other so that edges meet the inside
    for (const Vec3& centre : {Vec3(Real(0.22), Real(0.12), Real(0.31)), Vec3(0, 0, 0)}) {
        settings.cloths.push_back({.particles = {25, 25},
                                   .place = centre,
                                   .centred = true,
                                   .pinned = {},
                                   .structural = {400, Real(0.02)},
                                   .shear = {200, Real(0.02)},
                                   .bend = {5, Real(0.01)},
                                   .drag = 0});
        start.push_back(make_rest_state(settings.cloths.back()));
    }
    wave(start[0].x);
    turn(start[0].x, Vec3(Real(0.12), 1, Real(0.08)), Real(0.5));
    start[0].v.rowwise() = Vec3(speed / 8, -speed, speed / 16).transpose();
    settings.contact.self = true;
    settings.contact.thickness = thickness;
    settings.solver.integrator = IntegratorKind::BackwardEuler;
    settings.solver.tolerance = Real(1e-6);  // what a solve leaves is no momentum that contact has lost
    return scene;
}

SelfContactCounts make_step(ContactTrial& sheets, FailSafe fail_safe, Real h) {
    constexpr int most_halvings = 10;  // to a thousandth: a part that is still rejected is left as it is
    SelfContactCounts counts{
        {"pair_tests", 0}, {"held_back", 0}, {"rejected", 0}, {"unsearched_steps", 0}, {"unsafe_steps", 0}};
    make(sheets, fail_safe, h, most_halvings, counts);
    return counts;
}

SheetMeeting meeting_of(const ContactTrial& sheets) {
    const Grid& grid = sheets.cloths[0].model.grid;
    const Real thickness = response_of(sheets.settings).pair_thickness;
    const std::vector<Real> reaches(static_cast<std::size_t>(grid.particles()), thickness / 2);
    std::array<CellBoxes, 2> boxes;
    std::vector<BoxedCloth> boxed;
    for (std::size_t s = 0; s < boxes.size(); ++s) {
        const Points& x = sheets.cloths[s].state.x;
        boxes[s].build(grid, x, reaches);
        boxed.push_back({{static_cast<int>(s), grid, x}, boxes[s], reaches});
    }
    SheetMeeting meeting;
    std::vector<NearPair> pairs;
    const LeafPair all[] = {{all_cells(grid), all_cells(grid)}};
    for (std::size_t a = 0; a < boxed.size(); ++a) {
        for (std::size_t b = a; b < boxed.size(); ++b) {
            meeting.crossings += count_crossings(boxed[a], boxed[b], all);
            find_near_pairs(boxed[a], boxed[b], all, pairs);
        }
    }
    for (const NearPair& pair : pairs) meeting.penetration = std::max(meeting.penetration, thickness - pair.distance);
    if (meeting.crossings > 0) meeting.penetration = sheets.settings.contact.thickness;
    return meeting;
}

Experiment self_contact_experiment() {
    return {
        "self_contact",
        "what keeps cloth from crossing cloth, and at which step?",
        6,
        {"thickness_m", "step_s", "fail_safe", "crossings", "crossed_steps", "unsearched_steps", "unsafe_steps",
         "penetration_m", "momentum_error", "momentum_change", "pair_tests", "held_back", "rejected",
         quartile_columns("cpu_s_per_s")},  // time for a simulated second
        {{"",
          cases_over(run_thickness, Axis<double>{"thickness_m", {1.25e-4, 5e-4, 2e-3, 8e-3}},
                     quick_or_whole<std::vector<double>>({120, 240, 480, 960}, {60, 120, 240, 480, 960, 1920, 3840}),
                     quick_or_whole(2, 4), quick_or_whole(1, 5)),
          {{"self_contact"}}}}};
}

}  // namespace drape
