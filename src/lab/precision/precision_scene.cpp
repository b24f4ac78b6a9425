#include "precision_scene.h"

namespace drape {
namespace {

/// Drag of the whole cloth [N s/m]: a tenth of its speed in 0.04 s.
constexpr Real whole_drag = Real(0.5);

ClothParameters sheet(int particles, Real stiffness, Real damping) {
    ClothParameters cloth;
    cloth.particles = {particles, particles};
    cloth.structural = {stiffness, damping};
    cloth.shear = {stiffness / 2, damping};
    cloth.bend = {stiffness / 10, damping};
    cloth.drag = whole_drag / static_cast<Real>(cloth.particles.particles());
    return cloth;
}

/// Held level by two corners and let go.
PrecisionScene hung(const std::string& name, int particles, Real stiffness, Real damping, int rungs, int finest_steps) {
    Settings settings;
    settings.cloths = {sheet(particles, stiffness, damping)};
    settings.cloths.front().pinned.kind = Pins::Kind::Two;
    return {name, settings, Real(0.25), rungs, finest_steps, 0, 1};
}

/// Falls level on a small ball beside its middle. The first impact is at 0.2 s, the horizon 0.04 s later: while the
/// cloth folds about the ball, small errors do not grow yet. The ball is small because the response leaves contacts as
/// deep as a part of its radius, which no step makes smaller.
PrecisionScene dropped(int particles, int finest_steps, int reference_steps, int phases) {
    Settings settings;
    settings.cloths = {sheet(particles, 300, Real(0.2))};
    settings.cloths.front().centred = true;
    const Real gap = Real(0.2), radius = Real(0.05);
    BallSettings ball;
    ball.radius = radius;
    ball.position = {Real(0.07), -(radius + settings.contact.thickness + gap), Real(0.04)};
    ball.motion = BallMotion::Still;
    settings.balls = {ball};
    settings.solver.sleep_speed = 0;
    settings.solver.ledger = false;
    return {"contact", settings, Real(0.24), 0, finest_steps, reference_steps, phases};
}

}  // namespace

std::vector<PrecisionScene> precision_scenes(bool quick) {
    const int particles = quick ? 6 : 16, rungs = quick ? 7 : 8, steps = quick ? 512 : 4096;
    return {hung("soft", particles, 100, Real(0.05), rungs, steps),
            hung("stiff", particles, 2000, Real(0.1), rungs, steps),
            quick ? dropped(6, 512, 1 << 20, 8) : dropped(12, 2048, 1 << 21, 8)};
}

}  // namespace drape
