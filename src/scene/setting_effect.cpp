#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "drape/integrate/stability.h"
#include "drape/scene/setting_table.h"

namespace drape {

namespace {

template <class Enum>
std::string no_effect_with(Enum value) {
    return "no effect with " + std::string(name_of(value));
}

std::string why_ball_ignores(std::string_view name, BallMotion motion) {
    const bool on_path = motion == BallMotion::Path;
    const bool ignored =
        (name == "position" && on_path) || (name == "velocity" && (on_path || motion == BallMotion::Still)) ||
        (name == "speed" && motion != BallMotion::Keys) || (name == "mass" && motion != BallMotion::Free);
    return ignored ? "no effect while the ball's motion is " + std::string(name_of(motion)) : "";
}

std::string why_solid_ignores(std::string_view name, const SolidSettings& solid) {
    if (name == "position" && solid.motion == SolidMotion::Path) return "no effect on a path";
    if (name == "axis" && solid.angle == 0) return "no effect while the angle is 0";
    const bool ignored = (name == "size" && solid.shape != SolidKind::Box) ||
                         ((name == "radius" || name == "length") && solid.shape != SolidKind::Capsule);
    return ignored ? "no effect while the shape is " + std::string(name_of(solid.shape)) : "";
}

}  // namespace

std::string why_without_effect(const Setting& setting, const Settings& settings, std::size_t number) {
    if (setting.section == "ball") return why_ball_ignores(setting.name, settings.balls[number].motion);
    if (setting.section == "solid") return why_solid_ignores(setting.name, settings.solids[number]);
    const std::string name = setting.full_name();
    const auto is = [&](std::initializer_list<std::string_view> names) {
        return std::ranges::find(names, name) != names.end();
    };

    const IntegratorKind integrator = settings.solver.integrator;
    const bool solves = solves_a_system(integrator), limited = has_step_limit(integrator);
    const bool unused = (is({"solver.hessian", "solver.newton_steps"}) && !solves) ||
                        (is({"solver.tolerance"}) && !solves && integrator != IntegratorKind::DormandPrince) ||
                        (is({"solver.iterations"}) && !has_iterations(integrator)) ||
                        (is({"solver.threads"}) && !limited && !settings.contact.self) ||
                        (is({"contact.longest_step"}) && limited);
    if (unused) return no_effect_with(integrator);

    const VolumeKind volume = settings.contact.volume;
    if (volume == VolumeKind::Brute &&
        is({"contact.update", "contact.leaf_cells", "contact.sphere_fit", "contact.search_level",
            "contact.search_tests", "view.bounds", "view.level"}))
        return "brute force has no hierarchy";
    if (volume != VolumeKind::Sphere && is({"contact.sphere_fit"}))
        return "no effect while the bounding volume is " + std::string(name_of(volume));
    const bool has_level = settings.view.bounds || settings.view.colour == ColourBy::Level;
    if (!has_level && is({"view.level"})) return "B shows it";

    const ResponseKind response = settings.contact.response;
    const bool has_springs = response == ResponseKind::Penalty || response == ResponseKind::Hybrid;
    if (!has_springs && is({"contact.stiffness"})) return no_effect_with(response);
    if (!settings.ground.solid && is({"ground.friction", "ground.restitution", "ground.rolling"}))
        return "no effect while the ground is not solid";
    if (std::ranges::count(settings.balls, BallMotion::Free, &BallSettings::motion) == 0 &&
        is({"contact.rolling", "ground.rolling"}))
        return "no effect without a free ball";
    if (!settings.wind.on && is({"wind.velocity", "wind.gust"})) return "no effect without wind (V)";
    return {};
}

}  // namespace drape
