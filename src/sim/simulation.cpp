#include "drape/sim/simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ball_motion.h"
#include "divergence.h"
#include "drape/base/stopwatch.h"
#include "drape/contact/response.h"
#include "drape/sim/setting_table.h"

namespace drape {
namespace {

/// Density of air at 15 degrees Celsius and sea level (ISO 2533) [kg/m^3].
constexpr Real air_density = Real(1.225);

/// The air at a time: the mean wind with two gusts of incommensurate frequency on it. It depends on time alone.
Air air_at(const WindSettings& wind, double time) {
    if (!wind.on) return {};
    const double gusts = (std::sin(2.1 * time) + std::sin(5.3 * time + 1.3)) / 2;
    return {wind.velocity * (1 + wind.gust * static_cast<Real>(gusts)), air_density};
}

ResponseParameters response_of(const ContactSettings& contact) {
    return {contact.response, contact.friction, contact.restitution, contact.thickness};
}

}  // namespace

Simulation::Simulation(std::string scene, Settings settings)
    : scene_(std::move(scene)), settings_(std::move(settings)) {
    check(settings_);
    restart();
}

void Simulation::step() {
    if (report_.status == Status::Diverged) return;
    const Real h = settings_.solver.dt;
    report_.times = {};
    report_.traversal = {};
    report_.contacts = 0;
    report_.penetration = 0;
    Stopwatch watch;

    // Input: what moves on its own
    move_hand(h);
    previous_balls_ = balls_;
    move_balls(h);

    // Step
    const Air air = air_at(settings_.wind, report_.time);
    for (Cloth& cloth : cloths_) {
        cloth.previous = cloth.state;
        cloth.model.air = air;
        report_.solve = cloth.integrator->step(cloth.model, cloth.state, h);
    }
    report_.times.step = watch.lap();

    detect_divergence();
    if (report_.status == Status::Diverged) return;
    if (!balls_.empty() || settings_.view.bounds) {
        for (Cloth& cloth : cloths_) collide(cloth, h);
    }

    ++report_.step;
    report_.time = counted_from_time_ + static_cast<double>(report_.step - counted_from_step_) * static_cast<double>(h);
    steps_wanted_ = std::max(0, steps_wanted_ - 1);
}

void Simulation::collide(Cloth& cloth, Real h) {
    const ContactSettings& contact = settings_.contact;
    Stopwatch watch;

    // Build
    cloth.broad_phase->build(cloth.state.x);
    report_.times.build += watch.lap();

    // Traverse and narrow
    cloth.contacts.clear();
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        report_.traversal += cloth.broad_phase->query(grown(balls_[b], contact.thickness), cloth.candidates);
        // In the same order whatever found them, so that contacts are answered in the same order
        std::ranges::sort(cloth.candidates.cells);
        report_.times.traverse += watch.lap();
        find_contacts(cloth.model.grid, cloth.state.x, balls_[b], static_cast<int>(b), contact.thickness,
                      cloth.candidates.cells, cloth.contacts);
        report_.times.narrow += watch.lap();
    }

    // Respond
    const Real deepest = resolve_contacts(cloth.model, response_of(contact), balls_, h, cloth.contacts, cloth.state);
    report_.times.respond += watch.lap();
    report_.contacts += static_cast<std::int64_t>(cloth.contacts.size());
    report_.penetration = std::max(report_.penetration, static_cast<double>(deepest));
}

void Simulation::move_balls(Real h) {
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        move_ball(settings_.balls[b], steer_, static_cast<Real>(report_.time), h, balls_[b]);
    }
}

void Simulation::detect_divergence() {
    for (std::size_t c = 0; c < cloths_.size(); ++c) {
        report_.trouble = divergence(cloths_[c], balls_, settings_);
        if (report_.trouble.empty()) continue;

        // The last good state stays on show
        report_.trouble +=
            " in step " + std::to_string(report_.step + 1) + " of " + std::string(name_of(settings_.solver.integrator));
        report_.status = Status::Diverged;
        steps_wanted_ = 0;
        for (Cloth& cloth : cloths_) {
            cloth.state = cloth.previous;
            cloth.contacts.clear();
        }
        balls_ = previous_balls_;
        return;
    }
}

FrameView Simulation::view(Real blend) {
    report_.energy = {};
    report_.stretch = 0;
    double square_sum = 0, particles = 0;
    for (const Cloth& cloth : cloths_) {
        const Energy energy = compute_energy(cloth.model, cloth.state);
        report_.energy.kinetic += energy.kinetic;
        report_.energy.gravity += energy.gravity;
        report_.energy.spring += energy.spring;
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
