// A sheet that is hung by two corners and let go, moved by Drape and by Bullet 3.24.

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <fmt/core.h>

#include <cmath>

#include "drape/base/input_error.h"
#include "drape/integrate/integrator.h"
#include "drape/model/stencils.h"
#include "lab/measure/methods.h"
#include "runner.h"

namespace drape::peers {
namespace {

constexpr Real horizon = Real(0.4);  // s

/// 1 m a side, and so coarse that small errors do not grow. One stiffness for structural and shear springs, and one
/// damping: what btDeformableMassSpringForce can have.
ClothParameters hung_sheet(int particles, Real damping) {
    ClothParameters sheet;
    sheet.particles = {particles, particles};
    sheet.pinned.kind = Pins::Kind::Two;
    sheet.structural = sheet.shear = {1000, damping};
    sheet.bend = {100, damping};
    sheet.drag = 0;
    return sheet;
}

/// A sheet in motion.
struct Moving {
    std::function<void()> step;
    std::function<Points()> positions;
};

/// What moves a sheet from rest, by steps of h [s].
struct ClothMethod {
    std::string name;
    std::function<Moving(const ClothParameters& sheet, Real h)> start;
};

Moving start_ours(const ClothParameters& sheet, Real h, const IntegratorParameters& parameters, bool off = false) {
    const auto model = std::make_shared<ClothModel>(make_cloth_model(sheet));
    const ClothState rest = make_rest_state(sheet);
    const auto state = std::make_shared<ClothState>(off ? disturbed(*model, rest) : rest);
    const std::shared_ptr<Integrator> integrator = make_integrator(parameters, model->grid);
    return {[=] { integrator->step(*model, *state, h); }, [=] { return state->x; }};
}

/// Where Dormand-Prince takes the sheet; off: from a start with an error of 1e-9 m.
Points solved(const ClothParameters& sheet, Real tolerance, bool off = false) {
    constexpr int parts = 32;
    const Moving moving =
        start_ours(sheet, horizon / parts, {.integrator = IntegratorKind::DormandPrince, .tolerance = tolerance}, off);
    for (int part = 0; part < parts; ++part) moving.step();
    return moving.positions();
}

/// A world of Bullet with the sheet, without faces: nothing touches it, and no air. In every step a box of each
/// particle is updated in a tree: that cannot be turned off.
template <class World, class Constraints>
struct BulletSheet {
    ClothModel model;
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase boxes;
    Constraints constraints;
    btDeformableBodySolver solver;
    std::unique_ptr<btSoftBody> body;
    World world;

    template <class... Solver>
    explicit BulletSheet(const ClothParameters& sheet, Solver... of_solver)
        : model(make_cloth_model(sheet)),
          world(&dispatcher, &boxes, &constraints, &configuration, (&(this->*of_solver))...) {
        world.setGravity({model.gravity[0], model.gravity[1], model.gravity[2]});
        world.getWorldInfo().m_gravity = world.getGravity();
        btAlignedObjectArray<btVector3> places;
        const Points x = make_rest_state(sheet).x;
        for (int p = 0; p < x.rows(); ++p) places.push_back({x(p, 0), x(p, 1), x(p, 2)});
        body = std::make_unique<btSoftBody>(&world.getWorldInfo(), places.size(), &places[0], nullptr);
        for (int p = 0; p < x.rows(); ++p) body->setMass(p, model.pinned(p) ? 0 : model.particle_mass);
        body->m_cfg.collisions = 0;
        body->setActivationState(DISABLE_DEACTIVATION);
    }

    /// @param material_of a spring of some law between particles of some sum of inverse masses
    template <class MaterialOf>
    void link(const MaterialOf& material_of) {
        for (const SpringStencil& springs : spring_stencils(model)) {
            springs.for_each(model.grid, [&](int a, int b) {
                body->appendLink(a, b, material_of(springs.law, body->m_nodes[a].m_im + body->m_nodes[b].m_im));
                body->m_links[body->m_links.size() - 1].m_bbending = springs.law == model.bend;
            });
        }
        world.addSoftBody(body.get());
    }

    [[nodiscard]] Points positions() const {
        Points x(body->m_nodes.size(), 3);
        for (int p = 0; p < x.rows(); ++p) {
            for (int axis = 0; axis < 3; ++axis) x(p, axis) = body->m_nodes[p].m_x[axis];
        }
        return x;
    }
};

/// In each iteration a link moves its ends by the part m_kLST of what would bring it to its length. The part is here
/// what brings a single spring where a step of backward Euler does. There is no damping of springs.
Moving start_position_based(const ClothParameters& sheet, Real h, int iterations) {
    const auto made =
        std::make_shared<BulletSheet<btSoftRigidDynamicsWorld, btSequentialImpulseConstraintSolver>>(sheet);
    made->body->m_cfg.piterations = iterations;
    made->link([&](const SpringLaw& law, Real inverse_mass) {
        btSoftBody::Material* const material = made->body->appendMaterial();
        material->m_kLST = 1 - std::pow(1 + h * h * law.stiffness * inverse_mass, Real(-1) / Real(iterations));
        return material;
    });
    return {[=] { made->world.stepSimulation(h, 0); }, [=] { return made->positions(); }};
}

/// The springs themselves. Implicit: one Newton step of backward Euler from x + h v, as Bullet makes unless its sources
/// are changed; else forces at the start of the step. Damping is always implicit.
Moving start_mass_spring(const ClothParameters& sheet, Real h, bool implicit) {
    using Sheet = BulletSheet<btDeformableMultiBodyDynamicsWorld, btDeformableMultiBodyConstraintSolver>;
    const auto made = std::make_shared<Sheet>(sheet, &Sheet::solver);
    const auto springs = std::make_shared<btDeformableMassSpringForce>(
        sheet.structural.stiffness, sheet.structural.damping, true, sheet.bend.stiffness);
    const auto gravity = std::make_shared<btDeformableGravityForce>(made->world.getGravity());
    made->constraints.setDeformableSolver(&made->solver);
    made->solver.setImplicit(implicit);
    made->world.setImplicit(implicit);
    made->solver.m_useProjection = true;
    made->world.setUseProjection(true);
    made->link([&](const SpringLaw&, Real) { return made->body->m_materials[0]; });
    made->world.addForce(made->body.get(), springs.get());
    made->world.addForce(made->body.get(), gravity.get());
    return {[=] { made->world.stepSimulation(h, 0); }, [made, springs, gravity] { return made->positions(); }};
}

std::vector<ClothMethod> cloth_methods() {
    std::vector<ClothMethod> methods;
    const auto add = [&methods](const std::string& name, auto start, auto how) {
        methods.push_back({name, [=](const ClothParameters& sheet, Real h) { return start(sheet, h, how); }});
    };
    const auto ours = [](const ClothParameters& sheet, Real h, const IntegratorParameters& parameters) {
        return start_ours(sheet, h, parameters);
    };
    using Parameters = IntegratorParameters;
    add("Bullet btSoftBody 1", start_position_based, 1);
    add("Bullet btSoftBody 10", start_position_based, 10);
    add("Bullet deformable explicit", start_mass_spring, false);
    add("Bullet deformable implicit", start_mass_spring, true);
    add("Drape symplectic Euler", ours, Parameters{.integrator = IntegratorKind::SymplecticEuler});
    add("Drape XPBD 1", ours, Parameters{.integrator = IntegratorKind::Xpbd, .iterations = 1});
    add("Drape XPBD 10", ours, Parameters{.integrator = IntegratorKind::Xpbd, .iterations = 10});
    add("Drape backward Euler", ours, Parameters{.integrator = IntegratorKind::BackwardEuler});
    add("Drape backward Euler Newton 2", ours,
        Parameters{.integrator = IntegratorKind::BackwardEuler, .newton_steps = 2});
    return methods;
}

}  // namespace

void race_with_cloth(bool quick, std::ostream& out) {
    const int particles = quick ? 12 : 16;
    const ClothParameters sheet = hung_sheet(particles, Real(0.01));
    const Points truth = solved(sheet, Real(1e-9));
    const auto percent_off = [&truth](const Points& x) { return 100 * position_error(x, truth); };
    const double growth = percent_off(solved(sheet, Real(1e-9), true)) / 100 / static_cast<double>(small_error);
    if (growth > most_growth) throw RunError("small errors grow: positions are not to be compared");
    const std::string worth = fmt::format("{:.2g},{:.3g},{:.3g}", percent_off(solved(sheet, Real(1e-8))), growth,
                                          percent_off(solved(hung_sheet(particles, 0), Real(1e-9))));

    tell(out, "side,method,steps,step_ms,error_percent,cost_s_per_s,runs,reference_percent,growth,damping_percent");
    const auto race = [&](const std::vector<ClothMethod>& methods, int steps) {
        const Real h = horizon / static_cast<Real>(steps);
        Runners runners;
        std::vector<double> errors(methods.size());
        // All but the first step, in which methods set up what they keep
        for (std::size_t m = 0; m < methods.size(); ++m) {
            const auto moving = std::make_shared<Moving>();
            runners.push_back(std::make_unique<OneFrame>(
                methods[m].name,
                [=, &sheet, &methods] {
                    *moving = methods[m].start(sheet, h);
                    moving->step();
                },
                [] {},
                [=] {
                    for (int step = 1; step < steps; ++step) moving->step();
                },
                [=, &errors, &percent_off] { errors[m] = percent_off(moving->positions()); }));
        }
        const std::vector<Result> results = take_turns(runners, quick ? 1 : 3);
        for (std::size_t m = 0; m < results.size(); ++m) {
            if (!(errors[m] < 100)) continue;  // it blew up
            tell(out, fmt::format("{},{},{},{:.5g},{:.4g},{:.4g},{},{}", particles, results[m].method, steps, 1e3 * h,
                                  errors[m], results[m].total / ((steps - 1) * h), results[m].frames, worth));
        }
    };
    const std::vector<ClothMethod> all = cloth_methods();
    for (int steps = 24; steps <= (quick ? 1536 : 12288); steps *= 2) race(all, steps);
    // In steps so short that what is left is the difference of the models
    race({all.front()}, quick ? 6144 : 196608);
}

}  // namespace drape::peers
