#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "drape/integrate/stability.h"
#include "drape/scene/setting_table.h"

namespace drape {

std::string why_without_effect(const Setting& setting, const Settings& settings, std::size_t number) {
    std::string why;
    const std::string name = setting.full_name();
    // Of several reasons, the first counts
    const auto ignores = [&](bool is_so, std::initializer_list<std::string_view> names, const std::string& reason) {
        if (why.empty() && is_so && std::ranges::find(names, name) != names.end()) why = reason;
    };

    if (setting.section == "ball") {
        const BallMotion motion = settings.balls[number].motion;
        const std::string reason = "no effect while the ball's motion is " + name_of(motion);
        ignores(motion == BallMotion::Path, {"ball.position", "ball.velocity"}, reason);
        ignores(motion == BallMotion::Still, {"ball.velocity"}, reason);
        ignores(motion != BallMotion::Keys, {"ball.speed"}, reason);
        ignores(motion != BallMotion::Free, {"ball.mass"}, reason);
    } else if (setting.section == "solid") {
        const SolidSettings& solid = settings.solids[number];
        const std::string reason = "no effect while the shape is " + name_of(solid.shape);
        ignores(solid.motion == SolidMotion::Path, {"solid.position"}, "no effect on a path");
        ignores(solid.angle == 0, {"solid.axis"}, "no effect while the angle is 0");
        ignores(solid.shape != SolidKind::Box, {"solid.size"}, reason);
        ignores(solid.shape != SolidKind::Capsule, {"solid.radius", "solid.length"}, reason);
    }

    const IntegratorKind integrator = settings.solver.integrator;
    const std::string with_integrator = "no effect with " + name_of(integrator);
    const MethodRow& method = method_of(integrator);
    const bool solves = method.keeps == Keeps::NewtonSystem, limited = has_step_limit(integrator);
    ignores(!solves, {"solver.hessian", "solver.newton_steps"}, with_integrator);
    ignores(!solves && integrator != IntegratorKind::DormandPrince, {"solver.tolerance"}, with_integrator);
    ignores(!method.iterates, {"solver.iterations"}, with_integrator);
    ignores(!limited && !solves && !settings.contact.self, {"solver.threads"}, with_integrator);
    ignores(limited, {"contact.longest_step"}, with_integrator);

    const VolumeKind volume = settings.contact.volume;
    ignores(volume == VolumeKind::Brute,
            {"contact.update", "contact.leaf_cells", "contact.sphere_fit", "contact.search_level",
             "contact.search_tests", "view.bounds", "view.level"},
            "brute force has no hierarchy");
    ignores(volume != VolumeKind::Sphere, {"contact.sphere_fit"},
            "no effect while the bounding volume is " + name_of(volume));
    ignores(!settings.view.bounds && settings.view.colour != ColourBy::Level, {"view.level"}, "B shows it");

    const ResponseKind response = settings.contact.response;
    ignores(!has_penalties(response), {"contact.stiffness"}, "no effect with " + name_of(response));
    ignores(!settings.ground.solid, {"ground.friction", "ground.restitution", "ground.rolling"},
            "no effect while the ground is not solid");
    ignores(std::ranges::count(settings.balls, BallMotion::Free, &BallSettings::motion) == 0,
            {"contact.rolling", "ground.rolling"}, "no effect without a free ball");
    ignores(!settings.wind.on, {"wind.velocity", "wind.gust"}, "no effect without wind (V)");
    return why;
}

}  // namespace drape
