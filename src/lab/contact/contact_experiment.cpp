#include <cmath>
#include <set>
#include <utility>

#include "contact_trial.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "lab/experiments.h"

namespace drape {
namespace {

constexpr int reference_substeps = 100;  ///< steps of the reference for one of a run

/// Ways to search, by their names in the table, and the settings that make them.
const std::pair<const char*, std::vector<std::string>> contact_searches[] = {
    {"discrete", {}},
    {"continuous", {"contact.continuous=auto"}},
    {"limited", {"contact.search_tests=24"}},
    {"limited", {"contact.search_tests=12"}}};

/// What the reference has, all triangles and all that may have met within each step.
const std::vector<std::string> reference_search{"contact.volume=brute", "contact.continuous=auto"};

/// CPU time for a simulated second, without the observer.
Quartiles time_run(const ContactScene& scene, double step, int repeats) {
    const auto steps = std::llround(scene.end / step);
    std::vector<double> costs;
    for (int repeat = -1; repeat < repeats; ++repeat) {
        ContactTrial trial(scene, static_cast<Real>(step));
        const double seconds = cpu_time_of([&] {
            for (std::int64_t k = 0; k < steps; ++k) trial.advance(), trial.respond();
        });
        if (repeat >= 0) costs.push_back(seconds / (static_cast<double>(steps) * step));
    }
    return quartiles_of(std::move(costs));
}

/// How many triangles a run has touched.
std::size_t count_triangles(const ContactHistory& history) {
    std::set<int> triangles;
    for (const std::vector<int>& touched : history.touched) triangles.insert(touched.begin(), touched.end());
    return triangles.size();
}

/// @throws RunError if there is nothing to find, or the reference itself fails
Rows run_contact_case(double speed, double step, int repeats) {
    const ContactScene scene = hung_cloth_and_ball(speed, step);
    const ContactHistory reference =
        watch_contacts(scene.with(reference_search), static_cast<Real>(step / reference_substeps));
    const std::size_t triangles = count_triangles(reference);
    if (triangles == 0 || reference.passed) {
        throw RunError("contact: at " + real_text(speed) + " m/s the ball of the reference has gone through the cloth");
    }
    const auto radius = static_cast<double>(scene.settings.balls[0].radius);
    Rows rows;
    for (const auto& [name, changes] : contact_searches) {
        const ContactScene searched = scene.with(changes);
        const ContactHistory run = watch_contacts(searched, static_cast<Real>(step));
        Row& row = rows.emplace_back(compare_contacts(run, reference, reference_substeps));
        // A ball that has gone through counts with its radius
        const bool passed = row.word("passed") == "1";
        row.set({{"search", name},
                 {"tests", std::to_string(searched.settings.contact.search_tests)},
                 {"speed_m_per_s", speed},
                 {"step_s", step},
                 {"penetration_m", passed ? radius : run.entered},
                 {"left_m", passed ? radius : run.left},
                 {"false_contacts", run.false_contacts},
                 {"cpu_s_per_s", time_run(searched, step, repeats)},
                 {"reference_triangles", triangles},
                 {"reference_penetration_m", reference.left}});
    }
    return rows;
}

ExperimentCases contact_cases(bool quick) {
    std::vector rates{30.0, 60.0, 120.0, 240.0, 480.0, 960.0};
    if (!quick) rates.push_back(1920);
    return cases_over([=](double speed, double rate) { return run_contact_case(speed, 1 / rate, quick ? 5 : 15); },
                      quick ? std::vector{2.0, 8.0, 32.0} : std::vector{0.5, 2.0, 8.0, 32.0}, rates);
}

std::vector<Chart> contact_charts(const Rows& rows) {
    const auto shown = words_of(rows, [](const Row& row) { return row.word("search") + "." + row.word("tests"); });
    const auto speeds = words_of(rows, [](const Row& row) { return real_text(row.number("speed_m_per_s")); });
    return {{"contact", {{"searches", in_words(shown)}, {"speeds", in_words(speeds)}}}};
}

}  // namespace

ContactScene hung_cloth_and_ball(double speed, double step) {
    ContactScene scene;
    scene.settings.cloths = {{.particles = {25, 25},
                              .plane = Plane::XY,
                              .place = Vec3(Real(-0.5), 1, 0),
                              .pinned = {Pins::Kind::Row, {}},
                              .structural = {400, Real(0.02)},
                              .shear = {200, Real(0.02)},
                              .bend = {5, Real(0.01)}}};
    // A little to the side, so that no triangle is met by symmetry alone; its end is before the cloth slips off the
    // ball
    BallSettings& ball = scene.settings.balls.emplace_back();
    ball.radius = Real(0.15);
    ball.position = Vec3(Real(0.03), Real(0.48), Real(-0.4));
    ball.velocity = Vec3(0, 0, static_cast<Real>(speed));
    scene.settings.ground.solid = false;
    scene.end = std::ceil(0.5 / speed / step) * step;
    scene.settings.solver.integrator = IntegratorKind::BackwardEuler;
    scene.settings.contact.leaf_cells = 4;
    scene.settings.contact.continuous = Continuous::Never;
    return scene;
}

Experiment contact_experiment() {
    return {"contact",
            "which steps and searches find the contacts that there are?",
            8,
            {word_column("search", {"discrete", "continuous", "limited"}), word_column("tests", {"0", "24", "12"}),
             positive_column("speed_m_per_s"), positive_column("step_s"), number_column("missed_contacts"),
             number_column("missed_steps"),
             number_column("penetration_m"),  // largest, before the response
             number_column("left_m"),         // and after it
             number_column("momentum_error"), word_column("passed", {"0", "1"}), number_column("false_contacts"),
             number_column("cpu_s_per_s").with_quartiles(),  // time for a simulated second
             whole_column("reference_triangles", 1), number_column("reference_penetration_m")},
            {{"search", "tests", "speed_m_per_s", "passed"},
             {"step_s", "missed_contacts", "left_m", "momentum_error", "cpu_s_per_s"}},
            {{"", contact_cases, contact_charts}}};
}

}  // namespace drape
