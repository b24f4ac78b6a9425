#include "contact_experiment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "lab/measure/timing.h"

namespace drape {
namespace {

namespace at = contact_column;

constexpr int finer = 100;  ///< steps of the reference for one of a run

/// The searches that are compared: the full one, and ends after some tests.
struct NamedSearch {
    const char* name;
    std::int64_t tests;
};
constexpr NamedSearch searches[] = {{"full", 0}, {"limited", 24}, {"limited", 12}};

BroadPhaseParameters search_of(std::int64_t tests) { return {.leaf_cells = 4, .search = {.tests = tests}}; }

/// CPU time for a simulated second, without the observer.
Quartiles time_run(const ContactScene& scene, const BroadPhaseParameters& search, Real step, int repeats) {
    const auto hierarchy = make_broad_phase(search, scene.cloth.particles);
    const auto steps = std::llround(scene.end / static_cast<double>(step));
    std::vector<double> costs;
    for (int repeat = -1; repeat < repeats; ++repeat) {
        ContactTrial trial(scene, step);
        const double before = thread_cpu_time();
        for (std::int64_t k = 0; k < steps; ++k) {
            trial.advance(*hierarchy);
            trial.respond();
        }
        if (repeat >= 0)
            costs.push_back((thread_cpu_time() - before) / (static_cast<double>(steps) * static_cast<double>(step)));
    }
    return quartiles_of(std::move(costs));
}

std::vector<TableRow> run_case(double speed, double step, int repeats) {
    const ContactScene scene = hung_cloth_and_ball(speed, step);
    const ContactHistory reference = watch_contacts(scene, search_of(0), static_cast<Real>(step / finer));
    std::set<int> triangles;
    for (const std::vector<int>& touched : reference.touched) triangles.insert(touched.begin(), touched.end());
    if (triangles.empty() || reference.passed) {
        throw RunError("contact: at " + real_text(speed) + " m/s the ball of the reference has gone through the cloth");
    }
    std::vector<TableRow> rows;
    for (const NamedSearch& search : searches) {
        const ContactHistory run = watch_contacts(scene, search_of(search.tests), static_cast<Real>(step));
        const ContactErrors errors = compare_contacts(run, reference, finer);
        const double penetration = errors.passed ? static_cast<double>(scene.ball.radius) : run.entered;
        const Quartiles cost = time_run(scene, search_of(search.tests), static_cast<Real>(step), repeats);
        const auto text = [](double value) { return real_text(value, 8); };
        rows.push_back({search.name, std::to_string(search.tests), text(speed), text(step),
                        text(errors.missed_contacts), text(errors.missed_steps), text(penetration), text(run.left),
                        errors.passed ? "1" : "0", text(run.false_contacts), text(cost.median), text(cost.lower),
                        text(cost.upper), std::to_string(triangles.size()), text(reference.entered)});
    }
    return rows;
}

std::vector<ExperimentCase> cases(bool quick) {
    std::vector<ExperimentCase> all;
    const std::vector<double> speeds = quick ? std::vector{2.0, 8.0, 32.0} : std::vector{0.5, 2.0, 8.0, 32.0};
    const std::vector<double> rates = quick ? std::vector{30.0, 60.0, 120.0, 240.0, 480.0, 960.0}
                                            : std::vector{30.0, 60.0, 120.0, 240.0, 480.0, 960.0, 1920.0};
    for (const double speed : speeds) {
        for (const double rate : rates) {
            all.push_back([=] { return run_case(speed, 1 / rate, quick ? 5 : 15); });
        }
    }
    return all;
}

std::vector<Column> columns() {
    std::vector<std::string> names, tests;
    for (const NamedSearch& search : searches) {
        if (std::ranges::find(names, search.name) == names.end()) names.emplace_back(search.name);
        tests.push_back(std::to_string(search.tests));
    }
    return {word_column("search", names),
            word_column("tests", tests),
            positive_column("speed_m_per_s"),
            positive_column("step_s"),
            number_column("missed_contacts"),
            number_column("missed_steps"),
            number_column("penetration_m"),
            number_column("left_m"),
            word_column("passed", {"0", "1"}),
            number_column("false_contacts"),
            number_column("cpu_s_per_s"),
            number_column("cpu_lower_s_per_s"),
            number_column("cpu_upper_s_per_s"),
            whole_column("reference_triangles", 1),
            number_column("reference_penetration_m")};
}

/// For each search and speed, the longest step from which down nothing passes and little is missed.
std::string summary(const std::vector<TableRow>& rows) {
    const auto number = [](const TableRow& row, std::size_t column) { return number_in(row[column]); };
    std::map<std::pair<std::string, double>, std::vector<const TableRow*>> runs;
    for (const TableRow& row : rows) {
        const std::string search = row[at::Search] == "full" ? "full search" : "search of " + row[at::Tests] + " tests";
        runs[{search, number(row, at::Speed)}].push_back(&row);
    }
    std::string text;
    for (auto& [key, steps] : runs) {
        std::ranges::sort(steps, {}, [&](const TableRow* row) { return number(*row, at::Step); });
        double longest = 0, worst = 0;
        bool good = true;
        for (const TableRow* row : steps) {
            good = good && (*row)[at::Passed] == "0" && number(*row, at::MissedContacts) <= 0.1;
            if (!good) break;
            longest = number(*row, at::Step);
            worst = std::max(worst, number(*row, at::Penetration));
        }
        text += key.first + ", ball at " + real_text(key.second) + " m/s: ";
        text += longest > 0
                    ? "at most a tenth of the contacts missed up to a step of " + real_text(1e3 * longest, 3) +
                          " ms, penetration up to " + real_text(1e3 * worst, 3) + " mm"
                    : std::string("more than a tenth of the contacts missed, or the ball lost, at the shortest step");
        text += "\n";
    }
    return text;
}

}  // namespace

ContactScene hung_cloth_and_ball(double speed, double step) {
    ContactScene scene;
    scene.cloth = {.particles = {25, 25},
                   .plane = Plane::XY,
                   .place = Vec3(Real(-0.5), 1, 0),
                   .pinned = {Pins::Kind::Row, {}},
                   .structural = {400, Real(0.02)},
                   .shear = {200, Real(0.02)},
                   .bend = {5, Real(0.01)}};
    // A little to the side, so that no triangle is met by symmetry alone; its end is before the cloth slips off the
    // ball
    scene.ball = {.centre = Vec3(Real(0.03), Real(0.48), Real(-0.4)),
                  .radius = Real(0.15),
                  .velocity = Vec3(0, 0, static_cast<Real>(speed))};
    scene.end = std::ceil(0.5 / speed / step) * step;
    scene.integrator.kind = IntegratorKind::BackwardEuler;
    return scene;
}

Experiment contact_experiment() {
    return {"contact", "which steps and searches find the contacts that there are?", columns(), cases, contact_charts,
            summary};
}

}  // namespace drape
