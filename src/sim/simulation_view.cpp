#include <algorithm>
#include <cmath>

#include "drape/base/numbers.h"
#include "drape/bounds/fold_test.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

/// Marks what searches of cloth against cloth do with the nodes of the hierarchies that are shown, where there is no
/// ball: beside its search, which prunes most, one sees nothing of what that prunes. For pictures alone: these searches
/// are for what is nearer than the thickness at this moment, and no contact depends on them. (Those of a run look
/// farther ahead, find touching cells in another way, and keep what they find, see `SelfSearch`.)
/// @param cloths with hierarchies that are fit to be drawn, see `ContactSearch::show`
/// @param rows with the pairs in contact
/// @param touched receives the cells of each cloth with a particle of such a pair, in no particular order
/// @return what the searches have cost
TraversalStats mark_pairs(std::span<Cloth> cloths, std::span<const ContactRow> rows, const ContactSettings& contact,
                          std::vector<std::vector<int>>& touched) {
    touched.assign(cloths.size(), {});
    for (const ContactRow& row : rows) {
        if (row.kind != RowKind::Pair) continue;
        for (const RowParticle& p : row.moved()) {
            const auto c = static_cast<std::size_t>(p.cloth);
            const Grid& grid = cloths[c].model.grid;
            const int i = std::min(p.particle % grid.nx, grid.cell_columns() - 1),
                      j = std::min(p.particle / grid.nx, grid.cell_rows() - 1);
            touched[c].push_back(j * grid.cell_columns() + i);
        }
    }
    TraversalStats stats;
    std::vector<LeafPair> leaves;
    for (std::size_t first = 0; first < cloths.size(); ++first) {
        const ClothModel& model = cloths[first].model;
        FoldTest folds(model.grid, model.hx, model.hy, contact.leaf_cells);
        folds.build(cloths[first].state.x);
        BroadPhase& one = cloths[first].search.hierarchy();
        stats += one.query(one, contact.thickness, &folds, leaves);
        for (std::size_t second = first + 1; second < cloths.size(); ++second) {
            BroadPhase& other = cloths[second].search.hierarchy();
            stats += one.query(other, contact.thickness, nullptr, leaves);
            // A search marks the nodes of the first alone
            other.query(one, contact.thickness, nullptr, leaves);
        }
    }
    return stats;
}

}  // namespace

FrameView Simulation::view(Real blend) {
    report_.energy = {};
    report_.balance = {};
    report_.stretch = 0;
    double square_sum = 0, particles = 0;
    shown_.clear();
    for (Cloth& cloth : cloths_) {
        EnergyBalance balance;
        const Energy energy = cloth.energy.energy(cloth.model, cloth.state, balance);
        report_.energy.kinetic += energy.kinetic;
        report_.energy.gravity += energy.gravity;
        report_.energy.spring += energy.spring;
        report_.balance += balance;
        report_.stretch = std::max(report_.stretch, static_cast<double>(largest_stretch(cloth.model, cloth.state.x)));
        square_sum += static_cast<double>(cloth.state.v.squaredNorm());
        particles += static_cast<double>(cloth.state.v.rows());
        if (settings_.view.bounds) cloth.search.show(cloth.state.x, balls_, settings_.contact.thickness);
        shown_.push_back({cloth.model, cloth.state.x, cloth.previous.x, contact_.rows_of(shown_.size()),
                          &cloth.search.hierarchy(), &cloth.state.v, cloth.grabbed});
    }
    report_.rms_speed = std::sqrt(square_sum / particles);
    TraversalStats pair_search;
    if (settings_.view.bounds && settings_.contact.self && balls_.empty()) {
        pair_search = mark_pairs(cloths_, contact_.rows(), settings_.contact, pair_cells_);
        for (std::size_t c = 0; c < shown_.size(); ++c) shown_[c].pair_cells = pair_cells_[c];
    }
    const bool leads = balls_.size() > 1 && settings_.balls[users_ball_].motion == BallMotion::Keys;
    return {.cloths = shown_,
            .balls = balls_,
            .previous_balls = previous_balls_,
            .solids = solids_,
            .previous_solids = previous_solids_,
            .blend = std::clamp(blend, Real(0), Real(1)),
            .settings = &settings_,
            .report = &report_,
            .longest_step = longest_step(),
            .scene = scene_,
            .paused = paused_,
            .held = hand_.holds(),
            .steered_ball = hand_.ball() >= 0 ? hand_.ball()
                            : leads           ? static_cast<int>(users_ball_)
                                              : -1,
            .pair_search = pair_search};
}

std::uint64_t Simulation::hash() const {
    std::uint64_t hash = fnv1a("");
    const auto add = [&hash](const Real* values, Eigen::Index count) {
        hash = fnv1a({reinterpret_cast<const char*>(values), static_cast<std::size_t>(count) * sizeof(Real)}, hash);
    };
    for (const Cloth& cloth : cloths_) {
        add(cloth.state.x.data(), cloth.state.x.size());
        add(cloth.state.v.data(), cloth.state.v.size());
    }
    for (const Ball& ball : balls_) {
        add(ball.centre.data(), 3);
        add(ball.velocity.data(), 3);
        if (ball.inverse_mass == 0) continue;
        add(ball.spin.data(), 3);
        add(ball.orientation.coeffs().data(), 4);
    }
    return hash;
}

}  // namespace drape
