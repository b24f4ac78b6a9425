// What a run goes on from, class by class, as a snapshot has it: see snapshot.h.

#include <algorithm>

#include "drape/base/input_error.h"
#include "drape/base/snapshot_text.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

void exchange(SnapshotText& text, ClothState& state) {
    text.points("x", state.x);
    text.points("v", state.v);
}

void exchange(SnapshotText& text, Ball& ball) {
    text.line("ball", ball.centre, ball.velocity, ball.orientation, ball.spin, ball.moved, ball.turned);
}

void exchange(SnapshotText& text, Solid& solid) { text.line("solid", solid.position, solid.velocity, solid.moved); }

void exchange(SnapshotText& text, TraversalStats& stats) {
    text.line("traversal", stats.nodes, stats.visited, stats.volume_tests, stats.pruned, stats.leaves, stats.candidates,
              stats.stopped);
}

/// Some of it is asked before the next step, some adds up over a run, and some is shown until then.
void exchange(SnapshotText& text, StepReport& report) {
    text.line("step", report.step, within(report.substeps, 1, 1e6), within(report.time, 0, 1e9));
    text.line("limit", Unbounded{report.step_limit_ratio}, report.limit_is_lower_bound);
    for (TraversalStats* of : {&report.traversal, &report.ground, &report.solids, &report.between_cloths}) {
        exchange(text, *of);
    }
    text.line("stretch", report.stretch_excess, report.worst_stretch_excess, report.overstretched);
    text.line("contact", report.contacts, report.false_candidates, report.contact_residual, report.contact_sweeps,
              report.penetration, report.false_contacts, report.missed_penetration);
    text.line("pairs", report.listed_pairs, report.pairs, report.failsafe_particles);
    text.line("asleep", report.asleep);
    text.line("solves", report.unconverged, Unbounded{report.worst_residual}, report.unsolved_by);
    text.line("energy", report.energy_excess, report.energy_gain_step, report.gained_by);
    text.line("crossing", report.crossing.starts, report.crossing.last, report.crossing.speed,
              report.crossing.safe_speed);
}

void exchange(SnapshotText& text, EnergyFlow& flow) {
    text.line("energy_flow", flow.energy.kinetic, flow.energy.gravity, flow.energy.spring, flow.power.damping,
              flow.power.drag, flow.power.wind, flow.power.hand, flow.power.pins);
}

/// What contacts may name.
struct Known {
    std::span<const Cloth> cloths;
    int balls, bodies;
    bool pairs;  ///< cloth meets cloth

    [[nodiscard]] const Grid& grid_of(const RowParticle& p) const {
        return cloths[static_cast<std::size_t>(p.cloth)].model.grid;
    }
    [[nodiscard]] bool has(const RowParticle& p) const {
        return p.cloth < static_cast<int>(cloths.size()) && p.particle < grid_of(p).particles();
    }
};

/// Whether particles are the corners of a triangle of their cloth.
bool is_triangle(const Known& known, int triangle, std::span<const RowParticle> particles) {
    const Grid& grid = known.grid_of(particles[0]);
    if (particles.size() != 3 || triangle < 0 || triangle >= grid.triangles()) return false;
    return std::ranges::equal(particles, grid.triangle_corners(triangle), {}, &RowParticle::particle);
}

/// Whether they are the ends of a side of a triangle, or of the diagonal of a cell.
bool is_edge(const Known& known, const RowParticle& first, const RowParticle& second) {
    const int columns = known.grid_of(first).nx, low = std::min(first.particle, second.particle);
    const int apart = std::max(first.particle, second.particle) - low;
    if (apart == 1) return low % columns < columns - 1;
    return apart == columns || (apart == columns - 1 && low % columns > 0);
}

bool fits_pair(const Known& known, const ContactRow& row) {
    const auto& p = row.particles;
    const int first_count = row.triangle == -1 ? 2 : 1;
    if (!known.pairs || row.count != 4 || row.first_count != first_count || row.body != no_body) return false;
    for (int k = 0; k < 4; ++k) {
        const std::size_t side = k < first_count ? 0 : 3, at = static_cast<std::size_t>(k);
        if (p[at].cloth != p[side].cloth) return false;
        for (std::size_t other = side == 0 ? static_cast<std::size_t>(first_count) : 4; other < 4; ++other) {
            if (p[at].cloth == p[other].cloth && p[at].particle == p[other].particle) return false;
        }
    }
    if (first_count == 2) return is_edge(known, p[0], p[1]) && is_edge(known, p[2], p[3]);
    return is_triangle(known, row.triangle, std::span(p).subspan(1));
}

/// Whether a contact can be one.
bool fits(const Known& known, const ContactRow& row) {
    if (!has_length_one(row.normal)) return false;
    if (!std::ranges::all_of(row.moved(), [&](const RowParticle& p) { return known.has(p); })) return false;
    if (row.kind == RowKind::Pair) return row.first_body == no_body && fits_pair(known, row);
    const bool of_bodies = row.kind == RowKind::Bodies;
    if (row.body == no_body || of_bodies != (row.first_body != no_body) || row.first_count != row.count) return false;
    if (of_bodies) return row.count == 0 && row.first_body < known.balls && row.first_body < row.body;
    if (row.count == 0 || row.triangle < 0) return false;
    if (row.triangle >= known.grid_of(row.particles[0]).triangles()) return false;
    for (const RowParticle& p : row.moved()) {
        if (p.cloth != row.particles[0].cloth) return false;
    }
    if (row.kind == RowKind::Particle) return row.count == 1;
    if (row.kind == RowKind::Node && row.body >= known.balls) return false;
    return is_triangle(known, row.triangle, row.moved());
}

void exchange(SnapshotText& text, ContactRow& row, const Known& known) {
    text.line("row", row.kind, within(row.count, 0, 4), within(row.first_count, 0, 4), row.lasts, row.separated,
              within(row.triangle, -1, 1e9), within(row.first_body, no_body, known.bodies - 1),
              within(row.body, no_body, known.bodies - 1), row.normal, row.distance, row.depth, row.displacement.normal,
              row.displacement.friction, row.impulse.normal, row.impulse.friction);
    for (std::size_t k = 0; k < row.count; ++k) {
        RowParticle& p = row.particles[k];
        text.line("of", p.cloth, p.particle, within(p.weight, -1.01, 1.01));
    }
    if (text.reads() && !fits(known, row)) text.refuse("a contact of features that there are");
}

}  // namespace

void Simulation::exchange(SnapshotText& text) {
    drape::exchange(text, report_);
    text.line("plan", within(planned_substeps_, 1, max_substeps));
    text.line("counted_from", within(counted_from_step_, 0, static_cast<double>(report_.step)), counted_from_time_);
    if (text.reads() && report_.time != counted_time()) text.refuse("what the time follows from");
    text.line("start", depth_at_start_);
    text.line("steer", steer_);
    if (!steer_.isZero(0) && !has_length_one(steer_)) text.refuse("a direction of length 1");
    exchange_users_ball(text);
    for (Ball& ball : balls_) drape::exchange(text, ball);
    for (Solid& solid : solids_) drape::exchange(text, solid);
    hand_.exchange(text, cloths_, balls_.size());
    for (Cloth& cloth : cloths_) {
        text.line("cloth", cloth.pin_speed, cloth.model.air.velocity, within(cloth.model.air.density, 0, 1e3));
        drape::exchange(text, cloth.state);
        cloth.energy.exchange(text, cloth.grabbed);
        cloth.integrator.exchange(text, cloth.model);
    }
    contact_.exchange(text, {cloths_, balls_, solids_}, settings_.ground.solid);
    sleep_.exchange(text, cloths_, balls_.size());
    text.line("end");
    if (!text.reads()) return;
    previous_balls_ = balls_;
    previous_solids_ = solids_;
    for (Cloth& cloth : cloths_) {
        cloth.previous = cloth.state;
        cloth.search.positions_changed();
    }
}

void Simulation::exchange_users_ball(SnapshotText& text) {
    const double last = static_cast<double>(enum_count<BallMotion>) - 1;
    int motion = motion_by_scene_ ? static_cast<int>(*motion_by_scene_) : -1;
    text.line("users_ball", within(users_ball_, 0, std::max<double>(static_cast<double>(balls_.size()) - 1, 0)),
              within(motion, -1, balls_.empty() ? -1 : last));
    if (!text.reads() || motion < 0) return;
    motion_by_scene_ = static_cast<BallMotion>(motion);
    Settings given_back = settings_;
    given_back.balls[users_ball_].motion = *motion_by_scene_;
    try {
        check(given_back);
    } catch (const InputError& error) {
        text.refuse(std::string("a motion that the ball can have: ") + error.what());
    }
}

void ClothIntegrator::exchange(SnapshotText& text, const ClothModel& model) {
    if (integrator_) before_ = integrator_->step_before();
    // What was known of another model is of no use
    if (before_.revision != model.revision) before_.h = 0;
    text.line("step_before", within(before_.h, 0, 1));
    if (text.reads()) integrator_ = nullptr;
    if (before_.h == 0) return;
    before_.revision = model.revision;
    for (ClothState* state : {&before_.from, &before_.to}) {
        if (text.reads()) *state = {Points(model.grid.particles(), 3), Points(model.grid.particles(), 3)};
        drape::exchange(text, *state);
    }
}

void ContactStage::exchange(SnapshotText& text, const ContactBodies& bodies, bool has_ground) {
    const auto balls = static_cast<int>(bodies.balls.size()), solids = static_cast<int>(bodies.solids.size());
    const Known known{bodies.cloths, balls, balls + solids + (has_ground ? 1 : 0), self_.on()};
    double max_rows = balls * known.bodies;
    for (const Cloth& cloth : bodies.cloths) {
        max_rows += 4.0 * cloth.model.grid.triangles() * known.bodies +
                    static_cast<double>(SelfSearch::max_pairs) * cloth.model.grid.particles();
    }
    text.line("near", near_);
    text.entries("rows", rows_, max_rows, [&](ContactRow& row) {
        drape::exchange(text, row, known);
        const bool follows = rows_.size() < 2 || compare(rows_[rows_.size() - 2], rows_.back()) < 0;
        if (text.reads() && !follows) text.refuse("rows in their order");
    });
    warm_start_.exchange(text);
    self_.exchange(text);
}

void EnergyLedger::exchange(SnapshotText& text) {
    text.line("ledger", balance_.wind, balance_.hand, balance_.pins, balance_.ball, balance_.damping, balance_.drag,
              balance_.contact, balance_.failsafe, balance_.integrator);
    drape::exchange(text, seen_);
    text.line("since", since_, within(h_, 0, 1), contact_energy_, contact_power_.damping, contact_power_.drag,
              contact_power_.wind, contact_power_.hand, contact_power_.pins);
}

void Hand::exchange(SnapshotText& text, std::span<Cloth> cloths, std::size_t balls) {
    int kind = grab_ ? 1 : ball_ >= 0 ? 2 : 0;
    text.line("hand", within(kind, 0, balls == 0 ? 1 : 2));
    if (kind == 2) text.line("holds", within(ball_, 0, static_cast<double>(balls) - 1), target_);
    if (kind != 1) return;
    if (text.reads()) grab_ = Grab{0, 0, false};
    text.line("holds", within(grab_->cloth, 0, static_cast<double>(cloths.size() - 1)), grab_->particle, target_);
    if (!text.reads()) return;
    Cloth& cloth = cloths[grab_->cloth];
    if (grab_->particle >= cloth.model.grid.particles()) text.refuse("an existing particle");
    hold_in(grab_->cloth, cloth.model);
    cloth.grabbed = grab_->particle;
}

void RestWatch::exchange(SnapshotText& text, Eigen::Index particles) {
    text.line("watching", watching_, since_);
    if (!watching_) return;
    if (text.reads()) start_.resize(particles, 3);
    text.points("from", start_);
}

void SleepWatch::exchange(SnapshotText& text, std::span<const Cloth> cloths, std::size_t balls) {
    watches_.resize(cloths.size());
    for (std::size_t c = 0; c < cloths.size(); ++c) watches_[c].exchange(text, cloths[c].state.x.rows());
    ball_watch_.exchange(text, static_cast<Eigen::Index>(balls));
}

}  // namespace drape
