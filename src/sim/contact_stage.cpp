#include "drape/sim/contact_stage.h"

#include <algorithm>

#include "ball_motion.h"
#include "drape/base/assert.h"
#include "drape/base/stopwatch.h"
#include "drape/contact/contact.h"
#include "drape/contact/solid_contacts.h"
#include "run_checks.h"

namespace drape {
namespace {

std::vector<const ClothModel*> models_of(std::span<const Cloth> cloths) {
    std::vector<const ClothModel*> models;
    for (const Cloth& cloth : cloths) models.push_back(&cloth.model);
    return models;
}

}  // namespace

void ContactStage::use(const Settings& settings, std::span<Cloth> cloths) {
    stage_ = Stage::Ended;
    std::size_t contacts = 0;
    std::vector<const Points*> positions;
    for (Cloth& cloth : cloths) {
        cloth.search.use(broad_phase_of(settings), cloth.model.grid, cloth.state.x);
        cloth.contacts.reserve(2 * static_cast<std::size_t>(cloth.model.grid.triangles()));
        cloth.warm_start.reserve(cloth.contacts.capacity());
        contacts += cloth.contacts.capacity();
        positions.push_back(&cloth.state.x);
    }
    rows_.reserve(contacts);
    const std::size_t balls = settings.balls.size();
    ball_contacts_.clear();
    ball_contacts_.reserve(balls * (balls + 1) / 2 + balls * settings.solids.size());
    self_.use(settings, models_of(cloths), positions);
}

void ContactStage::configure(const Settings& settings, const Settings& before, std::span<Cloth> cloths) {
    const BroadPhaseParameters search = broad_phase_of(settings);
    const bool same_search = search == broad_phase_of(before);
    for (Cloth& cloth : cloths) {
        if (!same_search) cloth.search.use(search, cloth.model.grid, cloth.state.x);
    }
    if (settings.contact.self != before.contact.self) {
        std::vector<const Points*> positions;
        for (const Cloth& cloth : cloths) positions.push_back(&cloth.state.x);
        self_.use(settings, models_of(cloths), positions);
    } else if (!same_search) {
        self_.use_hierarchy(settings, models_of(cloths));
    }
    self_.share(settings.solver.threads);
}

void ContactStage::go_on(Stage from, Stage to) {
    DRAPE_ASSERT(stage_ == from);
    stage_ = to;
}

const Points& ContactStage::start_of(const Cloth& cloth) const {
    return now_.divided ? cloth.before : cloth.previous.x;
}

void ContactStage::begin(const Settings& settings, const ContactBodies& bodies, const Substep& now) {
    stage_ = Stage::Begun;
    static_cast<Substep&>(now_) = now;
    now_.settings = &settings;
    now_.bodies = bodies;
    now_.response = response_of(settings);
    now_.cloths.clear();
    for (Cloth& cloth : bodies.cloths) {
        if (now.divided) cloth.before = cloth.state.x;
        now_.cloths.push_back({cloth.model, start_of(cloth), cloth.state, cloth.contacts});
    }
    for (Cloth& cloth : bodies.cloths) {
        cloth.warm_start.take(now_.response, now.h, cloth.model.gravity.norm(), now_.cloths, cloth.contacts);
    }
    self_.take_pushes(now_.response, now.h, gravity_of(settings).norm(), now_.cloths);
}

void ContactStage::warm_start() {
    go_on(Stage::Begun, Stage::Given);
    const auto& [cloths, balls, solids] = now_.bodies;
    const auto& pairs = self_.warm_start();
    const bool any = std::ranges::any_of(cloths, [](const Cloth& cloth) { return !cloth.warm_start.pushes().empty(); });
    if (!any && pairs.pushes().empty()) return;
    const double balls_before = kinetic_energy(balls);
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        Cloth& cloth = cloths[c];
        cloth.energy.before_pushes(cloth.model, cloth.state,
                                   {cloth.warm_start.pushes(), pairs.pushes(), static_cast<int>(c), balls, true});
    }
    for (const Cloth& cloth : cloths) cloth.warm_start.give(now_.cloths, balls);
    pairs.give(now_.cloths, balls);
    double free_work = balls_before - kinetic_energy(balls);
    for (Cloth& cloth : cloths) enter_pushes(cloth, cloth.warm_start.pushes(), 0, free_work);
}

/// @param contacts that push it
/// @param led_work by balls that nothing pushes, on this cloth [J]
/// @param free_work by all free balls, which the first cloth that touches one enters; 0 after that [J]
void ContactStage::enter_pushes(Cloth& cloth, std::span<const Contact> contacts, double led_work, double& free_work) {
    const bool takes = std::ranges::any_of(contacts, [&](const Contact& contact) {
        if (is_plane(contact.ball) || (contact.displacement.normal == 0 && contact.impulse.normal == 0)) return false;
        return now_.bodies.balls[static_cast<std::size_t>(contact.ball)].inverse_mass > 0;
    });
    const double work = led_work + (takes ? free_work : 0);
    if (cloth.energy.after_pushes(cloth.model, cloth.state, work) && takes) free_work = 0;
}

void ContactStage::detect(StepReport& report) {
    go_on(Stage::Given, Stage::Found);
    build(report);
    traverse(report);
    narrow(report);
}

void ContactStage::build(StepReport& report) {
    const auto& [cloths, balls, solids] = now_.bodies;
    if (balls.empty() && solids.empty()) return;
    const ContactSettings& contact = now_.settings->contact;
    Stopwatch watch;
    for (Cloth& cloth : cloths) {
        cloth.search.build(motion_of(cloth), contact);
        if (contact.continuous != Continuous::Never) continue;
        const auto mark = [&](const Crossing& crossing) { mark_crossing(crossing, now_.time, now_.h, report); };
        if (!balls.empty()) mark(cloth.search.crossing(motion_of(cloth), balls, contact.thickness));
        if (!solids.empty()) mark(cloth.search.crossing(motion_of(cloth), solids, contact.thickness));
    }
    report.times.build += watch.lap();
}

void ContactStage::traverse(StepReport& report) {
    Stopwatch watch;
    for (Cloth& cloth : now_.bodies.cloths) {
        report.traversal += cloth.search.traverse(now_.bodies.balls, now_.settings->contact.thickness);
    }
    report.times.traverse += watch.lap();
}

void ContactStage::narrow(StepReport& report) {
    const auto& [cloths, balls, solids] = now_.bodies;
    const Ground& ground = now_.settings->ground;
    const Real thickness = now_.settings->contact.thickness;
    Stopwatch watch;
    for (Cloth& cloth : cloths) {
        report.false_candidates +=
            cloth.search.narrow(motion_of(cloth), balls, thickness, node_push_speed * now_.h, cloth.contacts);
        report.solids += cloth.search.meet_solids(motion_of(cloth), solids, thickness, cloth.contacts);
        if (ground.solid) {
            report.ground += cloth.search.meet_ground(cloth.state.x, ground.height, thickness, cloth.contacts);
        }
        cloth.warm_start.carry_over(now_.response, now_.cloths, balls, cloth.contacts);
        report.contacts += std::ranges::count_if(cloth.contacts, [](const Contact& found) { return found.depth > 0; });
    }
    find_ball_contacts(balls, ground, ball_contacts_);
    find_ball_contacts(balls, solids, ball_contacts_);
    report.times.narrow += watch.lap();
    self_.find(now_.response, now_.cloths, balls);
    report.pairs = static_cast<std::int64_t>(self_.contacts().size());
    report.times.pairs += watch.lap();
}

void ContactStage::audit_search(StepReport& report) {
    DRAPE_ASSERT(stage_ == Stage::Found);
    for (Cloth& cloth : now_.bodies.cloths) {
        report.false_contacts +=
            cloth.search.false_contacts(cloth.state.x, now_.bodies.balls, now_.settings->contact.thickness);
    }
}

void ContactStage::audit_response(StepReport& report) {
    DRAPE_ASSERT(stage_ == Stage::Solved);
    for (Cloth& cloth : now_.bodies.cloths) {
        const Real missed =
            cloth.search.missed_penetration(cloth.state.x, now_.bodies.balls, now_.settings->contact.thickness);
        report.missed_penetration = std::max(report.missed_penetration, static_cast<double>(missed));
    }
}

ResponseReport ContactStage::solve(StepReport& report) {
    go_on(Stage::Found, Stage::Solved);
    const auto& [cloths, balls, solids] = now_.bodies;
    Stopwatch watch;
    const std::span<PairContact> pairs = self_.contacts();
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        Cloth& cloth = cloths[c];
        cloth.energy.before_pushes(cloth.model, cloth.state, {cloth.contacts, pairs, static_cast<int>(c), balls});
    }
    ContactRows* const rows = now_.settings->solver.kernels == Kernels::Vector ? &rows_ : nullptr;
    const ResponseReport left =
        resolve_contacts(now_.response, now_.h, now_.cloths, pairs, balls, ball_contacts_, rows);
    double free_work = left.free_ball_work;
    for (Cloth& cloth : cloths) {
        enter_pushes(cloth, cloth.contacts, work_of_kinematic_bodies(cloth.contacts, balls), free_work);
    }
    report.penetration = static_cast<double>(left.depth);
    report.contact_residual = std::max(report.contact_residual, static_cast<double>(left.residual));
    report.contact_sweeps += left.sweeps;
    report.times.respond += watch.lap();
    return left;
}

bool ContactStage::would_cross() {
    DRAPE_ASSERT(stage_ == Stage::Solved);
    return self_.would_cross(now_.cloths);
}

void ContactStage::prevent_crossing(StepReport& report) {
    Stopwatch watch;
    if (would_cross()) {
        const std::span<Cloth> cloths = now_.bodies.cloths;
        for (Cloth& cloth : cloths) cloth.energy.before_hold(cloth.model, cloth.state);
        report.held_back = self_.prevent_crossing(now_.cloths);
        for (Cloth& cloth : cloths) cloth.energy.after_hold(cloth.model, cloth.state);
        report.penetration = static_cast<double>(depth_left(now_.response, now_.cloths, now_.bodies.balls));
    }
    report.listed_pairs = self_.report().listed;
    report.between_cloths = self_.report().traversal;
    report.times.pairs += watch.lap();
}

void ContactStage::end() {
    go_on(Stage::Solved, Stage::Ended);
    const std::span<Cloth> cloths = now_.bodies.cloths;
    const std::span<Ball> balls = now_.bodies.balls;
    const ContactSettings& contact = now_.settings->contact;
    for (std::size_t c = 0; c < cloths.size() && now_.settings->solver.ledger; ++c) {
        const int number = static_cast<int>(c);
        cloths[c].energy.pushed(cloths[c].warm_start.work(now_.cloths, number) +
                                self_.warm_start().work(now_.cloths, number));
    }
    const auto resist = [&](Real coefficient, int ball, Real load) {
        if (coefficient > 0) resist_rolling(coefficient, load, balls[static_cast<std::size_t>(ball)]);
    };
    for (const BallContact& found : ball_contacts_) {
        if (found.ball == the_ground) resist(now_.settings->ground.rolling, found.first, found.impulse.normal);
        if (is_solid(found.ball)) resist(contact.rolling, found.first, found.impulse.normal);
    }
    for (Cloth& cloth : cloths) {
        for (const Contact& found : cloth.contacts) {
            if (!is_plane(found.ball)) resist(contact.rolling, found.ball, found.impulse.normal);
        }
        // What only might have touched is of no use to anyone
        std::erase_if(cloth.contacts, [](const Contact& found) {
            return !(found.depth > 0) && found.displacement.normal == 0 && found.impulse.normal == 0;
        });
    }
}

}  // namespace drape
