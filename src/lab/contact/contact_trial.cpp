#include "contact_trial.h"

namespace drape {

ContactTrial::ContactTrial(Settings of, const std::optional<StartState>& start)
    : settings(std::move(of)), cloths(settings.cloths.size()) {
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        Cloth& cloth = cloths[c];
        cloth.model = make_cloth_model(settings.cloths[c]);
        cloth.model.gravity = gravity_of(settings);
        cloth.state = start ? start->states[c] : make_rest_state(settings.cloths[c]);
        cloth.integrator.use(settings.solver, cloth.model.grid);
        cloth.energy.restart(cloth.model, cloth.state, settings.solver.kernels);
    }
    for (const BallSettings& ball : settings.balls) {
        balls.push_back({.centre = ball.position, .radius = ball.radius, .velocity = ball.velocity});
    }
    stage.use(settings, cloths);
}

void ContactTrial::advance(Real h) {
    report.forget_contacts();
    for (Cloth& cloth : cloths) cloth.previous = cloth.state;
    for (Ball& ball : balls) {
        ball.moved = h * ball.velocity;
        ball.centre += ball.moved;
    }
    stage.begin(settings, {cloths, balls, {}}, {.h = h});
    for (Cloth& cloth : cloths) {
        cloth.integrator.step(cloth.model, cloth.state, h);
        cloth.search.positions_changed();
    }
    unpushed = cloths[0].state.x;
    stage.warm_start();
    stage.detect(report);
}

}  // namespace drape
