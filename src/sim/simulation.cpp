#include "drape/sim/simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ball_motion.h"
#include "drape/base/exact_math.h"
#include "drape/base/stopwatch.h"
#include "drape/contact/node_contacts.h"
#include "drape/contact/response.h"
#include "drape/integrate/stability.h"
#include "drape/sim/memory.h"
#include "drape/sim/setting_table.h"

namespace drape {
namespace {

/// Density of air at 15 degrees Celsius and sea level (ISO 2533) [kg/m^3].
constexpr Real air_density = Real(1.225);

/// The air at a time: the mean wind with two gusts of incommensurate frequency on it. It depends on time alone.
Air air_at(const WindSettings& wind, double time) {
    if (!wind.on) return {};
    const double gusts = (sine(2.1 * time) + sine(5.3 * time + 1.3)) / 2;
    return {wind.velocity * (1 + wind.gust * static_cast<Real>(gusts)), air_density};
}

/// Whether a build may be left out: not one that is on show, nor one of a limited search, whose spheres may reach what
/// the cloth does not.
bool may_skip(const Settings& settings) {
    return settings.contact.coherence && !settings.view.bounds && broad_phase_of(settings).search.none() &&
           !settings.balls.empty();
}

/// How far a particle may go in the time of a watch and count as resting: no small cloth swings in so little either.
Real resting_reach(const ClothModel& model, const SolverSettings& solver) {
    const Grid& grid = model.grid;
    const Real side = std::min(model.hx * static_cast<Real>(grid.nx - 1), model.hy * static_cast<Real>(grid.ny - 1));
    return std::min(solver.sleep_speed * static_cast<Real>(RestWatch::duration), side / 1000);
}

ResponseParameters response_of(const ContactSettings& contact) {
    return {contact.response, contact.friction, contact.restitution, contact.thickness};
}

}  // namespace

Simulation::Simulation(std::string scene, Settings settings, std::optional<StartState> start)
    : scene_(std::move(scene)), settings_(std::move(settings)), start_(std::move(start)) {
    check(settings_);
    if (!start_) start_ = find_start(settings_);
    with_memory(settings_, [&] { restart(); });
}

void Simulation::step() {
    if (report_.status == Status::Diverged) return;
    report_.times = {};
    report_.solve = {};
    previous_balls_ = balls_;
    if (!report_.asleep) {
        for (Cloth& cloth : cloths_) cloth.previous = cloth.state;
    }
    for (Cloth& cloth : cloths_) {
        if (cloth.ledger) cloth.ledger->mark();
    }
    watch_limit();
    const Real h = static_cast<Real>(settings_.solver.dt / report_.substeps);
    for (int k = 0; k < report_.substeps; ++k) {
        substep(report_.time + k * static_cast<double>(h), h);
        if (report_.status == Status::Diverged) return;
    }
    ++report_.step;
    if (report_.solve.unconverged > 0) {
        ++report_.unconverged;
        report_.unsolved_by = settings_.solver.integrator;
    }
    report_.time = counted_from_time_ + static_cast<double>(report_.step - counted_from_step_) * settings_.solver.dt;
    steps_wanted_ = std::max(0, steps_wanted_ - 1);
    if (!report_.asleep) watch_rest();
}

/// Springs that are drawn out or pushed together vibrate faster than at the start. Parts only become more: a symplectic
/// method whose step changes to and fro gains energy. The search is the one thing that allocates in mid-run.
void Simulation::watch_limit() {
    constexpr double pause = 0.25;  // s
    const SolverSettings& solver = settings_.solver;
    if (solver.on_unstable != OnUnstable::Substep || !has_step_limit(solver.integrator) || report_.asleep) return;
    const auto between = static_cast<std::int64_t>(std::ceil(pause / solver.dt));
    if (report_.step > 0 && report_.step % between == 0) predict_limit(report_.substeps);
}

void Simulation::substep(double time, Real h) {
    // Input: what moves on its own
    move_hand(h);
    move_balls(time, h);
    if (ball_has_moved()) wake();
    if (report_.asleep) return;

    const double hand_power_before = present_hand_power();
    move_cloths(time, h);
    count_hand_work(hand_power_before, h);
    check_cloths(h);
    if (report_.status == Status::Diverged) return;
    for (Cloth& cloth : cloths_) {
        if (cloth.ledger) cloth.ledger->integrated(cloth.model, cloth.state, h);
    }
    if (balls_.empty() && !settings_.view.bounds) return;
    for (Cloth& cloth : cloths_) collide(cloth, h);
}

void Simulation::move_cloths(double time, Real h) {
    report_.traversal = {};
    report_.contacts = report_.false_candidates = report_.false_contacts = 0;
    report_.penetration = report_.missed_penetration = 0;
    const Air air = air_at(settings_.wind, time);
    for (Cloth& cloth : cloths_) {
        cloth.model.air = air;
        cloth.tree_is_fresh = false;
        if (cloth.ledger) cloth.ledger->begin(cloth.model, cloth.state, cloth.touched || settings_.wind.on);
        cloth.touched = false;
        Stopwatch watch;
        with_memory(settings_, [&] { report_.solve += cloth.integrator->step(cloth.model, cloth.state, h); });
        report_.times.step += watch.lap();
        if (settings_.wind.on) cloth.energy_watch.give(most_wind_power(cloth.model) * static_cast<double>(h));
    }
}

void Simulation::collide(Cloth& cloth, Real h) {
    const ContactSettings& contact = settings_.contact;
    Stopwatch watch;

    // Build, unless it is proven that nothing touches; the proof has cost what the last traversal did
    cloth.contacts.clear();
    const bool skipped = nothing_touches(cloth);
    if (!skipped) build(cloth);
    report_.times.build += watch.lap();
    if (skipped) {
        ++report_.skipped_builds;
        report_.traversal += cloth.traversal;
        return;
    }

    // Traverse and narrow
    find_contacts(cloth, h);
    if (may_skip(settings_)) cloth.separation.renew(*cloth.broad_phase, cloth.state.x, balls_, contact.thickness);

    // Respond
    watch.lap();
    respond(cloth, h);
    report_.times.respond += watch.lap();
    if (cloth.audit) {
        const Real missed = cloth.audit->penetration(cloth.state.x, balls_, contact.thickness);
        report_.missed_penetration = std::max(report_.missed_penetration, static_cast<double>(missed));
    }
}

/// What pushing stretches the springs by is the ball's work too. Mostly it is next to nothing, and a bound of it will
/// do.
void Simulation::respond(Cloth& cloth, Real h) {
    const ContactSettings& contact = settings_.contact;
    double squared_push = 0;
    for (const Contact& found : cloth.contacts) {
        const auto push = static_cast<double>(push_of(found, balls_[static_cast<std::size_t>(found.ball)].radius));
        if (push > 0) squared_push += push * push;
    }
    const double push_work = most_push_work(cloth.model, static_cast<Real>(squared_push));
    const bool measured = push_work > cloth.energy_watch.small_work();
    const double before = measured ? compute_energy(cloth.model, cloth.state).total() : 0;

    const ResponseReport left =
        resolve_contacts(cloth.model, response_of(contact), balls_, h, cloth.contacts, cloth.state);
    const double work =
        measured ? compute_energy(cloth.model, cloth.state).total() - before : left.ball_work + push_work;
    cloth.energy_watch.give(std::max(work, 0.0));
    report_.contacts += static_cast<std::int64_t>(cloth.contacts.size());
    report_.penetration = std::max(report_.penetration, static_cast<double>(left.depth));
    if (cloth.ledger && !cloth.contacts.empty()) cloth.ledger->responded(cloth.model, cloth.state, left.ball_work);
}

bool Simulation::nothing_touches(const Cloth& cloth) const {
    return may_skip(settings_) &&
           cloth.separation.holds(*cloth.broad_phase, cloth.state.x, balls_, settings_.contact.thickness);
}

void Simulation::build(Cloth& cloth) {
    cloth.broad_phase->build(cloth.state.x);
    cloth.tree_is_fresh = true;
    cloth.separation.forget();
}

void Simulation::find_contacts(Cloth& cloth, Real h) {
    const Grid& grid = cloth.model.grid;
    const Points& x = cloth.state.x;
    const Real thickness = settings_.contact.thickness;
    cloth.traversal = {};
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        const Ball& ball = balls_[b];
        const int number = static_cast<int>(b);
        Stopwatch watch;
        const TraversalStats traversal = cloth.broad_phase->query(grown(ball, thickness), cloth.candidates);
        cloth.traversal += traversal;
        // In the same order whatever found them, so that contacts are answered in the same order
        std::ranges::sort(cloth.candidates.cells);
        report_.times.traverse += watch.lap();
        const auto& [cells, stopped] = cloth.candidates;
        const std::int64_t touching =
            drape::find_contacts(grid, x, ball, number, thickness, cells, cloth.contacts, settings_.solver.kernels);
        find_node_contacts(grid, x, ball, number, thickness, node_push_speed * h, stopped, cloth.contacts);
        report_.times.narrow += watch.lap();
        report_.false_candidates += traversal.candidates - touching;
        if (cloth.audit) report_.false_contacts += cloth.audit->false_contacts(x, ball, thickness, stopped);
    }
    report_.traversal += cloth.traversal;
}

void Simulation::watch_rest() {
    const bool may_sleep =
        settings_.solver.sleep_speed > 0 && !settings_.wind.on && !hand_.has_value() && !ball_has_moved();
    bool rests = may_sleep;
    for (Cloth& cloth : cloths_) {
        if (!may_sleep)
            cloth.rest.restart();
        else if (!cloth.rest.look(cloth.state.x, report_.time, resting_reach(cloth.model, settings_.solver)))
            rests = false;
    }
    if (!rests) return;
    report_.asleep = true;
    for (Cloth& cloth : cloths_) {
        cloth.state.v.setZero();
        cloth.previous = cloth.state;
        if (cloth.ledger) cloth.ledger->stilled(cloth.model, cloth.state);
    }
    for (Ball& ball : balls_) ball.velocity.setZero();
    previous_balls_ = balls_;
}

void Simulation::wake() {
    report_.asleep = false;
    for (Cloth& cloth : cloths_) cloth.rest.restart();
}

bool Simulation::ball_has_moved() const {
    return !std::ranges::equal(balls_, previous_balls_, {}, &Ball::centre, &Ball::centre);
}

void Simulation::move_balls(double time, Real h) {
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        move_ball(settings_.balls[b], steer_, static_cast<Real>(time), h, balls_[b]);
    }
}

FrameView Simulation::view(Real blend) {
    report_.energy = {};
    report_.balance = {};
    report_.stretch = 0;
    double square_sum = 0, particles = 0;
    for (const Cloth& cloth : cloths_) {
        const Energy energy = compute_energy(cloth.model, cloth.state);
        report_.energy.kinetic += energy.kinetic;
        report_.energy.gravity += energy.gravity;
        report_.energy.spring += energy.spring;
        if (cloth.ledger) report_.balance += cloth.ledger->balance();
        report_.stretch = std::max(report_.stretch, static_cast<double>(largest_stretch(cloth.model, cloth.state.x)));
        square_sum += static_cast<double>(cloth.state.v.squaredNorm());
        particles += static_cast<double>(cloth.state.v.rows());
    }
    report_.rms_speed = std::sqrt(square_sum / particles);
    return {.cloths = cloths_,
            .balls = balls_,
            .previous_balls = previous_balls_,
            .blend = std::clamp(blend, Real(0), Real(1)),
            .settings = &settings_,
            .report = &report_,
            .scene = scene_,
            .paused = paused_,
            .held = hand_.has_value()};
}

std::uint64_t Simulation::hash() const {
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a, 64 bits
    const auto add = [&hash](const Real* values, Eigen::Index count) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(values);
        for (std::size_t i = 0; i < static_cast<std::size_t>(count) * sizeof(Real); ++i) {
            hash = (hash ^ bytes[i]) * 1099511628211u;
        }
    };
    for (const Cloth& cloth : cloths_) {
        add(cloth.state.x.data(), cloth.state.x.size());
        add(cloth.state.v.data(), cloth.state.v.size());
    }
    for (const Ball& ball : balls_) {
        add(ball.centre.data(), 3);
        add(ball.velocity.data(), 3);
    }
    return hash;
}

}  // namespace drape
