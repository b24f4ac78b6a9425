#include "drape/sim/contact_stage.h"

#include <algorithm>

#include "body_motion.h"
#include "drape/base/assert.h"
#include "drape/base/stopwatch.h"
#include "drape/bounds/displacement.h"
#include "drape/contact/detection.h"

namespace drape {
namespace {

std::vector<ClothInContact> at_present(std::span<Cloth> cloths) {
    std::vector<ClothInContact> list;
    for (Cloth& cloth : cloths) list.push_back({cloth.model, cloth.state.x, cloth.state});
    return list;
}

bool is_limited(const Settings& settings) { return !broad_phase_of(settings).search.none(); }

/// Of rows in the order of `compare`, those of one cloth and bodies.
std::span<const ContactRow> of_cloth(std::span<const ContactRow> rows, std::size_t cloth) {
    const auto is_its = [&](const ContactRow& row) {
        return row.kind < RowKind::Pair && row.particles[0].cloth == static_cast<int>(cloth);
    };
    const auto begin = std::ranges::find_if(rows, is_its);
    return {begin, std::find_if_not(begin, rows.end(), is_its)};
}

/// Marks in the report that a ball or a solid may have passed through a cloth unseen within the substep, as far as its
/// start and end tell: a ball of radius r that is outside must come as far as r before its centre is on the other side.
/// Half of that counts. The radius of a solid is half the shortest side of its bounding box.
void mark_crossing(const MovingCloth& cloth, std::span<const Body> bodies, const Settings& settings, const Substep& now,
                   StepReport& report) {
    constexpr double calm = 0.5;  // s, between one danger and the next
    const Real moved = largest_displacement(cloth.x, cloth.before);
    Real nearer = 0, radius = 0, beyond = 0;  // of what is farthest beyond where it becomes possible
    for (const Body& body : bodies) {
        if (body.is_ground()) continue;
        Real own = body.radius;
        if (body.solid != nullptr) {
            const auto [low, high] = body.solid->shape->extent();
            own = (high - low).minCoeff() / 2;
        }
        const Real distance = body.moved.norm() + moved, outer = own + settings.contact.thickness;
        if (2 * distance - outer > beyond) nearer = distance, radius = outer, beyond = 2 * distance - outer;
    }
    if (!(beyond > 0)) return;
    TunnellingRisk& danger = report.crossing;
    if (danger.starts == 0 || now.time > danger.last + calm) {
        ++danger.starts;
        danger.speed = static_cast<double>(nearer / now.h);
        danger.safe_speed = static_cast<double>(radius / (2 * now.h));
    }
    danger.last = now.time;
}

}  // namespace

std::span<const ContactRow> ContactStage::rows_of(std::size_t cloth) const { return of_cloth(rows_, cloth); }

void ContactStage::use(const Settings& settings, std::span<Cloth> cloths) {
    stage_ = Stage::Ended;
    std::size_t contacts = 0;
    for (Cloth& cloth : cloths) {
        cloth.search.use(broad_phase_of(settings), cloth.model.grid, cloth.state.x);
        contacts += 2 * static_cast<std::size_t>(cloth.model.grid.triangles());
    }
    rows_.clear();
    rows_.reserve(contacts);
    warm_start_.forget();
    warm_start_.reserve(contacts);
    solver_.reserve(contacts);
    near_ = false;
    self_.use(settings, at_present(cloths));
}

void ContactStage::configure(const Settings& settings, const Settings& before, std::span<Cloth> cloths) {
    const BroadPhaseParameters search = broad_phase_of(settings);
    const bool same_search = search == broad_phase_of(before);
    for (Cloth& cloth : cloths) {
        if (!same_search) cloth.search.use(search, cloth.model.grid, cloth.state.x);
    }
    if (settings.contact.self != before.contact.self) {
        std::erase_if(rows_, [](const ContactRow& row) { return row.kind == RowKind::Pair; });
        self_.use(settings, at_present(cloths));
    } else if (!same_search && self_.on()) {
        self_.use(search, at_present(cloths));
    }
    self_.use_threads(settings.solver.threads);
    const int ground = static_cast<int>(settings.balls.size() + settings.solids.size());
    const Ground &now = settings.ground, &then = before.ground;
    if (!now.solid || now.height < then.height) forget_bodies([&](int body) { return body == ground; });
    // A row has the distance that it was found with
    if (settings.contact.thickness != before.contact.thickness) rows_.clear();
}

void ContactStage::go_on(Stage from, Stage to) {
    DRAPE_ASSERT(stage_ == from);
    stage_ = to;
}

MovingCloth ContactStage::motion_of(std::size_t cloth) const {
    const Cloth& moving = now_.moving.cloths[cloth];
    return {moving.model.grid, now_.cloths[cloth].before, moving.state.x, static_cast<int>(cloth)};
}

void ContactStage::begin(const Settings& settings, const ContactBodies& bodies, const Substep& now) {
    stage_ = Stage::Begun;
    static_cast<Substep&>(now_) = now;
    now_.settings = &settings;
    now_.moving = bodies;
    now_.response = response_of(settings);
    now_.cloths.clear();
    for (Cloth& cloth : bodies.cloths) {
        if (now.divided) cloth.before = cloth.state.x;
        now_.cloths.push_back({cloth.model, now.divided ? cloth.before : cloth.previous.x, cloth.state, cloth.grabbed});
    }
    now_.bodies.clear();
    for (std::size_t b = 0; b < bodies.balls.size(); ++b) {
        now_.bodies.push_back(body_of(bodies.balls[b], settings.contact));
        now_.bodies.back().is_motor = settings.balls[b].motion == BallMotion::Keys;
    }
    for (const Solid& solid : bodies.solids) now_.bodies.push_back(body_of(solid, settings.contact));
    if (settings.ground.solid) now_.bodies.push_back(body_of(settings.ground));
    warm_start_.take(now_.response, now.h, gravity_of(settings).norm(), now_.cloths, now_.bodies, rows_);
}

void ContactStage::warm_start() {
    go_on(Stage::Begun, Stage::WarmStarted);
    const std::span<const ContactRow> rows = warm_start_.rows();
    if (std::ranges::none_of(rows, &ContactRow::has_impulse)) return;
    push(rows, true, [this] { warm_start_.give(now_.cloths, now_.bodies); });
}

/// @param known the impulses were given in the substep before
/// @param give pushes cloths and bodies
template <class Give>
void ContactStage::push(std::span<const ContactRow> rows, bool known, Give give) {
    const std::span<Cloth> cloths = now_.moving.cloths;
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        Cloth& cloth = cloths[c];
        cloth.energy.before_pushes(cloth.model, cloth.state, {rows, static_cast<int>(c), now_.bodies, known});
    }
    const double balls_before = kinetic_energy(now_.bodies);
    give();
    // The work by all free balls, which the first cloth that touches one enters [J]
    double free_work = balls_before - kinetic_energy(now_.bodies);
    for (std::size_t b = 0; b < now_.moving.balls.size(); ++b) now_.moving.balls[b] = now_.bodies[b];
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        Cloth& cloth = cloths[c];
        const std::span<const ContactRow> own = of_cloth(rows, c);
        const bool takes = std::ranges::any_of(own, [&](const ContactRow& row) {
            return row.has_impulse() && now_.bodies[static_cast<std::size_t>(row.body)].inverse_mass > 0;
        });
        const double by_kinematic = known ? 0 : work_of_kinematic_bodies(own, now_.bodies);
        cloth.energy.after_pushes(cloth.model, cloth.state, by_kinematic + (takes ? free_work : 0));
        if (takes) free_work = 0;
    }
}

void ContactStage::detect(StepReport& report) {
    go_on(Stage::WarmStarted, Stage::Found);
    build(report);
    traverse(report);
    narrow(report);
}

void ContactStage::build(StepReport& report) {
    const auto& [cloths, balls, solids] = now_.moving;
    if (balls.empty() && solids.empty()) return;
    const ContactSettings& contact = now_.settings->contact;
    Stopwatch watch;
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        cloths[c].search.build(motion_of(c), contact);
        if (contact.continuous == Continuous::Never) {
            mark_crossing(motion_of(c), now_.bodies, *now_.settings, now_, report);
        }
    }
    report.times.build += watch.lap();
}

void ContactStage::traverse(StepReport& report) {
    Stopwatch watch;
    for (Cloth& cloth : now_.moving.cloths) {
        for (std::size_t b = 0; b < now_.bodies.size(); ++b) {
            const Body& body = now_.bodies[b];
            const TraversalStats found = cloth.search.traverse(body, b, now_.settings->contact.thickness);
            (body.is_ball() ? report.traversal : body.is_ground() ? report.ground : report.solids) += found;
            if (body.is_ball()) report.false_candidates += found.candidates;
        }
    }
    report.times.traverse += watch.lap();
}

void ContactStage::narrow(StepReport& report) {
    const Real thickness = now_.settings->contact.thickness, longest_push = node_push_speed * now_.h;
    Stopwatch watch;
    for (std::size_t c = 0; c < now_.cloths.size(); ++c) {
        ContactSearch& search = now_.moving.cloths[c].search;
        for (std::size_t b = 0; b < now_.bodies.size(); ++b) {
            report.false_candidates -= search.narrow(motion_of(c), now_.bodies[b], b, thickness, longest_push, rows_);
        }
    }
    report.times.narrow += watch.lap();
    self_.find_contacts(now_.response, now_.cloths, rows_);
    report.times.pairs += watch.lap();
    find_body_contacts(now_.bodies, thickness, rows_);
    warm_start_.carry_over(now_.cloths, now_.bodies, rows_);
    near_ = !self_.pairs().empty();
    for (const ContactRow& row : rows_) {
        report.pairs += row.kind == RowKind::Pair;
        report.contacts += row.kind < RowKind::Pair && row.depth > 0;
        near_ = near_ || (row.kind == RowKind::Bodies && !stops_motor(row, now_.bodies));
    }
    report.times.narrow += watch.lap();
}

void ContactStage::audit_search(StepReport& report) {
    DRAPE_ASSERT(stage_ == Stage::Found);
    if (!is_limited(*now_.settings)) return;
    const std::span<const Ball> balls = now_.moving.balls;
    for (const Cloth& cloth : now_.moving.cloths) {
        for (std::size_t b = 0; b < balls.size(); ++b) {
            report.false_contacts +=
                count_false_contacts(cloth.model.grid, cloth.state.x, balls[b], now_.settings->contact.thickness,
                                     cloth.search.candidates(b).stopped);
        }
    }
}

void ContactStage::audit_response(StepReport& report) {
    DRAPE_ASSERT(stage_ == Stage::Solved);
    if (!is_limited(*now_.settings)) return;
    for (const Cloth& cloth : now_.moving.cloths) {
        const Real missed =
            deepest_penetration(cloth.model.grid, cloth.state.x, now_.moving.balls, now_.settings->contact.thickness);
        report.missed_penetration = std::max(report.missed_penetration, static_cast<double>(missed));
    }
}

void ContactStage::solve(StepReport& report) {
    go_on(Stage::Found, Stage::Solved);
    Stopwatch watch;
    ResponseReport left;
    push(rows_, false, [&] { left = solver_.resolve(now_.response, now_.h, now_.cloths, now_.bodies, rows_); });
    report.penetration = static_cast<double>(left.depth);
    report.contact_residual = std::max(report.contact_residual, static_cast<double>(left.residual));
    report.contact_sweeps += left.sweeps;
    report.times.respond += watch.lap();
}

bool ContactStage::would_cross() {
    DRAPE_ASSERT(stage_ == Stage::Solved);
    return self_.would_cross(now_.cloths, !rows_.empty());
}

void ContactStage::prevent_crossing(StepReport& report) {
    Stopwatch watch;
    if (would_cross()) {
        const std::span<Cloth> cloths = now_.moving.cloths;
        for (Cloth& cloth : cloths) cloth.energy.before_hold(cloth.model, cloth.state);
        report.failsafe_particles = self_.prevent_crossing(now_.cloths);
        for (Cloth& cloth : cloths) cloth.energy.after_pushes(cloth.model, cloth.state);
        report.penetration = static_cast<double>(update_depths(now_.cloths, now_.bodies, rows_));
    }
    report.listed_pairs = self_.report().listed;
    report.between_cloths = self_.report().traversal;
    report.times.pairs += watch.lap();
}

void ContactStage::end() {
    go_on(Stage::Solved, Stage::Ended);
    for (std::size_t c = 0; c < now_.moving.cloths.size() && now_.settings->solver.ledger; ++c) {
        now_.moving.cloths[c].energy.pushed(warm_start_.work(now_.cloths, static_cast<int>(c)));
    }
    for (const ContactRow& row : rows_) {
        if (row.body == no_body) continue;
        const Body& body = now_.bodies[static_cast<std::size_t>(row.body)];
        const bool on_body = row.kind == RowKind::Bodies;
        if (body.surface.rolling == 0 || on_body == body.is_ball()) continue;
        const int ball = on_body ? row.first_body : row.body;
        resist_rolling(body.surface.rolling, row.impulse.normal, now_.moving.balls[static_cast<std::size_t>(ball)]);
    }
    // What only might have touched a body is of no use to anyone
    std::erase_if(rows_, [](const ContactRow& row) {
        return row.kind != RowKind::Pair && !(row.depth > 0) && !row.has_impulse();
    });
}

}  // namespace drape
