#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "drape/base/exact_math.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/contact/near_pairs.h"
#include "lab/experiments.h"
#include "self_contact_trial.h"

namespace drape {
namespace {

constexpr std::array<std::size_t, 2> sheets{0, 1};

/// A step that is rejected this often is left as it is: its parts are a thousandth of it.
constexpr int most_halvings = 10;

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

}  // namespace

ContactScene throw_sheet(Real speed, Real thickness) {
    ContactScene scene;
    Settings& settings = scene.settings;
    settings.cloths.clear();
    settings.world.gravity = 0;
    // So far that waves and turns leave a gap, and beside each other so that edges meet the inside
    for (const Vec3& centre : {Vec3(Real(0.22), Real(0.12), Real(0.31)), Vec3(0, 0, 0)}) {
        ClothParameters cloth;
        cloth.particles = {25, 25};
        cloth.place = centre;
        cloth.centred = true;
        cloth.structural = {400, Real(0.02)};
        cloth.shear = {200, Real(0.02)};
        cloth.bend = {5, Real(0.01)};
        cloth.drag = 0;
        settings.cloths.push_back(cloth);
        scene.start.push_back(make_rest_state(cloth));
    }
    wave(scene.start[0].x);
    turn(scene.start[0].x, Vec3(Real(0.12), 1, Real(0.08)), Real(0.5));
    scene.start[0].v.rowwise() = Vec3(speed / 8, -speed, speed / 16).transpose();
    settings.contact.self = true;
    settings.contact.thickness = thickness;
    settings.solver.integrator = IntegratorKind::BackwardEuler;
    settings.solver.tolerance = Real(1e-6);  // what a solve leaves is no momentum that contact has lost
    scene.end = 0.1;
    return scene;
}

SelfContactStep SelfContactTrial::step() {
    SelfContactStep step;
    if (fail_safe_ == FailSafe::Rejection) {
        make_in_halves(h_, most_halvings, step);
    } else {
        make(h_, step);
        step.searched = searched_;
    }
    return step;
}

/// Makes a step, with the zones if these are asked for.
/// @return whether pairs would meet within it, or may, where the search gave up
bool SelfContactTrial::make(Real h, SelfContactStep& step) {
    advance(h);
    stage_.solve(report_);
    if (fail_safe_ == FailSafe::Zones) stage_.prevent_crossing(report_);
    const bool would_cross = fail_safe_ == FailSafe::Rejection && stage_.would_cross();
    stage_.end();
    step.held_back += report_.failsafe_particles;
    step.pair_tests += stage_.self().report().traversal.volume_tests + stage_.self().report().listed;
    searched_ = !stage_.self().report().gave_up;
    return would_cross || !searched_;
}

/// Makes a step, or takes it back and makes it in two halves. What is made again starts with no pushes: those of the
/// try are not what the halves need.
void SelfContactTrial::make_in_halves(Real h, int halvings_left, SelfContactStep& step) {
    const std::array<ClothState, 2> start{cloths_[0].state, cloths_[1].state};
    if (!make(h, step)) return;
    if (halvings_left == 0) {
        step.searched = step.searched && searched_;
        step.halved_enough = false;
        return;
    }
    for (const std::size_t s : sheets) cloths_[s].state = start[s];
    stage_.clear();
    ++step.rejected;
    for (int half = 0; half < 2; ++half) make_in_halves(h / 2, halvings_left - 1, step);
}

/// Both sheets with themselves and with each other, as boxed cloths, and all of their cells.
template <class Visit>
void SelfContactTrial::for_each_two_sheets(Real reach, Visit visit) const {
    const std::vector<Real> reaches(static_cast<std::size_t>(cloths_[0].model.grid.particles()), reach);
    std::array<CellBoxes, 2> boxes;
    for (const std::size_t s : sheets) boxes[s].build(cloths_[s].model.grid, cloths_[s].state.x, reaches);
    for (const auto& [a, b] : {std::pair(0, 0), std::pair(0, 1), std::pair(1, 1)}) {
        const auto first = static_cast<std::size_t>(a), second = static_cast<std::size_t>(b);
        const LeafPair all{all_cells(cloths_[first].model.grid), all_cells(cloths_[second].model.grid)};
        visit(BoxedCloth{{a, cloths_[first].model.grid, cloths_[first].state.x}, boxes[first], reaches},
              BoxedCloth{{b, cloths_[second].model.grid, cloths_[second].state.x}, boxes[second], reaches},
              std::span<const LeafPair>(&all, 1));
    }
}

std::int64_t SelfContactTrial::crossings() const {
    std::int64_t count = 0;
    for_each_two_sheets(0, [&](const auto&... pair) { count += count_crossings(pair...); });
    return count;
}

Real SelfContactTrial::penetration() const {
    std::vector<NearPair> pairs;
    const Real thickness = response_of(settings_).pair_thickness;
    for_each_two_sheets(thickness / 2, [&](const auto&... pair) { find_near_pairs(pair..., pairs); });
    Real nearest = thickness;
    for (const NearPair& pair : pairs) nearest = std::min(nearest, pair.distance);
    return thickness - nearest;
}

SelfContactHistory watch_sheets(const ContactScene& scene, Real step, FailSafe fail_safe) {
    SelfContactTrial trial(scene, step, fail_safe);
    const Vec3 first = trial.momentum(0), both = first + trial.momentum(1);
    SelfContactHistory history;
    const auto steps = std::llround(scene.end / static_cast<double>(step));
    const double share = 1 / static_cast<double>(steps);
    for (std::int64_t k = 0; k < steps; ++k) {
        const SelfContactStep done = trial.step();
        history.pair_tests += share * static_cast<double>(done.pair_tests);
        history.held_back += share * static_cast<double>(done.held_back);
        history.rejected += share * static_cast<double>(done.rejected);
        history.unsearched_steps += done.searched ? 0 : share;
        history.unsafe_steps += done.halved_enough ? 0 : share;
        history.crossings = trial.crossings();
        history.crossed_steps += history.crossings > 0 ? share : 0;
        const Real depth = history.crossings > 0 ? scene.settings.contact.thickness : trial.penetration();
        history.penetration = std::max(history.penetration, static_cast<double>(depth));
    }
    history.given = first - trial.momentum(0);
    history.momentum_change = static_cast<double>((trial.momentum(0) + trial.momentum(1) - both).norm() / both.norm());
    return history;
}

double momentum_error(const SelfContactHistory& run, const SelfContactHistory& reference) {
    return static_cast<double>((run.given - reference.given).norm() / reference.given.norm());
}

template <>
inline constexpr auto enum_names<FailSafe> = all_names<FailSafe>("none", "zones", "rejection");

namespace {

constexpr Real sheet_speed = 8;  // m/s

/// Those compared, in the order of the table.
constexpr std::array fail_safes{FailSafe::Zones, FailSafe::Rejection, FailSafe::None};

/// CPU time for a simulated second, without an observer.
double time_sheets(const ContactScene& scene, double step, FailSafe fail_safe) {
    SelfContactTrial trial(scene, static_cast<Real>(step), fail_safe);
    return cpu_time_of([&] {
               for (auto left = std::llround(scene.end / step); left > 0; --left) trial.step();
           }) /
           scene.end;
}

/// The runs of a step, timed in turn.
Rows run_step(const ContactScene& scene, double step, const SelfContactHistory& reference, int repeats) {
    std::array<std::vector<double>, fail_safes.size()> cpu;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (std::size_t k = 0; k < fail_safes.size(); ++k) cpu[k].push_back(time_sheets(scene, step, fail_safes[k]));
    }
    Rows rows;
    for (std::size_t k = 0; k < fail_safes.size(); ++k) {
        const SelfContactHistory run = watch_sheets(scene, static_cast<Real>(step), fail_safes[k]);
        rows.push_back({{"thickness_m", scene.settings.contact.thickness},
                        {"step_s", step},
                        {"fail_safe", fail_safes[k]},
                        {"crossings", run.crossings},
                        {"crossed_steps", run.crossed_steps},
                        {"unsearched_steps", run.unsearched_steps},
                        {"unsafe_steps", run.unsafe_steps},
                        {"penetration_m", run.penetration},
                        {"momentum_error", momentum_error(run, reference)},
                        {"momentum_change", run.momentum_change},
                        {"pair_tests", run.pair_tests},
                        {"held_back", run.held_back},
                        {"rejected", run.rejected},
                        {"cpu_s_per_s", quartiles_of(std::move(cpu[k]))}});
    }
    return rows;
}

/// @throws RunError if the reference itself fails
Rows run_thickness(double thickness, const std::vector<double>& rates, int finer, int repeats) {
    const ContactScene scene = throw_sheet(sheet_speed, static_cast<Real>(thickness));
    const SelfContactHistory reference =
        watch_sheets(scene, static_cast<Real>(1 / (finer * rates.back())), FailSafe::Zones);
    if (reference.crossed_steps > 0 || reference.unsearched_steps > 0) {
        throw RunError("self_contact: sheets of the reference have crossed");
    }
    Rows rows;
    for (const double rate : rates) {
        for (Row& row : run_step(scene, 1 / rate, reference, repeats)) rows.push_back(std::move(row));
    }
    return rows;
}

ExperimentCases self_contact_cases(bool quick) {
    const auto rates =
        quick ? std::vector{120.0, 240.0, 480.0, 960.0} : std::vector{60.0, 120.0, 240.0, 480.0, 960.0, 1920.0, 3840.0};
    return cases_over([=](double thickness) { return run_thickness(thickness, rates, quick ? 2 : 4, quick ? 1 : 5); },
                      std::vector{1.25e-4, 5e-4, 2e-3, 8e-3});
}

std::vector<Chart> self_contact_charts(const Rows& rows) {
    const auto shown = words_of(rows, [](const Row& row) { return real_text(1e3 * row.number("thickness_m"), 4); });
    return {{"self_contact", {{"thicknesses", in_words(shown)}}}};
}

}  // namespace

Experiment self_contact_experiment() {
    return {"self_contact",
            "what keeps cloth from crossing cloth, and at which step?",
            6,
            {positive_column("thickness_m"), positive_column("step_s"), name_column<FailSafe>("fail_safe"),
             whole_column("crossings"), number_column("crossed_steps"), number_column("unsearched_steps"),
             number_column("unsafe_steps"), number_column("penetration_m"), number_column("momentum_error"),
             number_column("momentum_change"), number_column("pair_tests"), number_column("held_back"),
             number_column("rejected"), number_column("cpu_s_per_s").with_quartiles()},  // time for a simulated second
            {{"thickness_m", "step_s", "fail_safe"},
             {"crossed_steps", "unsearched_steps", "penetration_m", "momentum_error", "cpu_s_per_s"}},
            {{"", self_contact_cases, self_contact_charts}}};
}

}  // namespace drape
