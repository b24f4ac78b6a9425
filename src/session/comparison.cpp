#include "drape/session/comparison.h"

#include <algorithm>
#include <cmath>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/scene/setting_table.h"

namespace drape {
namespace {

/// Of the other simulation within a step of the first.
constexpr int max_steps = 1000;

/// The particle of another grid that is nearest to the place of one in the flat cloth.
int nearest_particle(const Grid& from, int particle, const Grid& to) {
    const auto nearest = [](int k, int cells, int other_cells) {
        return static_cast<int>(
            std::lround(static_cast<Real>(k) / static_cast<Real>(cells) * static_cast<Real>(other_cells)));
    };
    return to.particle(nearest(particle % from.nx, from.cell_columns(), to.cell_columns()),
                       nearest(particle / from.nx, from.cell_rows(), to.cell_rows()));
}

/// The command, with the same particle of another grid where it names one.
Command moved_to(const Simulation& other, const Simulation& first, Command command) {
    const auto grid_in = [](const Simulation& simulation, int cloth) -> const Grid& {
        return simulation.cloths()[static_cast<std::size_t>(cloth)].model.grid;
    };
    std::visit(
        [&](auto& at) {
            if constexpr (requires { at.particle; }) {
                at.particle = nearest_particle(grid_in(first, at.cloth), at.particle, grid_in(other, at.cloth));
            }
        },
        command);
    return command;
}

}  // namespace

std::vector<std::string> split_assignments(std::string_view text) {
    std::vector<std::string> assignments;
    if (text.empty()) return assignments;
    for (const std::string_view part : split_at_commas(text)) {
        if (part.find('=') != std::string_view::npos) {
            assignments.emplace_back(part);
        } else if (!assignments.empty()) {
            assignments.back() += "," + std::string(part);
        } else {
            throw InputError("'" + shortened(text) + "': expected name=value, or several of these with commas");
        }
    }
    return assignments;
}

Comparison::Comparison(const Simulation& first, std::string assignments)
    : text_(std::move(assignments)), other_(make_other(first, text_)) {}

Simulation Comparison::make_other(const Simulation& first, std::string_view assignments) {
    Settings settings = first.settings();
    for (const std::string& assignment : split_assignments(assignments)) assign(settings, assignment);
    const double least = first.settings().solver.dt / max_steps;
    if (settings.solver.dt < least) {
        throw InputError("solver.dt = " + real_text(settings.solver.dt) + ": allowed " + real_text(least, 3) +
                         " and more, a thousandth of the step that it is compared with");
    }
    return {first.scene(), std::move(settings)};
}

/// A setting of all balls and that of one of them are the same here.
bool Comparison::compares(std::string_view setting) const {
    return std::ranges::any_of(split_assignments(text_), [&](const std::string& assignment) {
        return &setting_meant_by(assignment.substr(0, assignment.find('='))) == &setting_meant_by(setting);
    });
}

void Comparison::apply(const Command& command, const Simulation& first) {
    if (!changes_motion(command)) return;
    follow_command(command, first);
    // Where only one of both has begun again, both do
    if (first.report().step == 0 && other_.report().step != 0) other_.apply(command::Reset{});
}

void Comparison::follow_command(const Command& command, const Simulation& first) {
    if (const std::string_view setting = setting_of(command); !setting.empty() && compares(setting)) return;
    try {
        other_.apply(moved_to(other_, first, command));
    } catch (const InputError&) {
        // What the other one cannot do shows as a difference
    }
}

void Comparison::follow(const Simulation& first) {
    const double tolerance = 1e-6 * other_.settings().solver.dt;
    for (int k = 0; k < max_steps; ++k) {
        if (other_.report().status != Status::Ok || other_.report().time >= first.report().time - tolerance) break;
        other_.step();
    }
}

ComparisonView Comparison::view(const Simulation& first) {
    FrameView other = other_.view();
    const double ahead = (other_.report().time - first.report().time) / other_.settings().solver.dt;
    other.blend = static_cast<Real>(std::clamp(1 - ahead, 0.0, 1.0));
    double squares = 0, count = 0, largest = 0;
    distances_.resize(first.cloths().size());
    for (std::size_t c = 0; c < first.cloths().size(); ++c) {
        const Cloth &one = first.cloths()[c], &two = other_.cloths()[c];
        const int particles = one.model.grid.particles();
        const Points there =
            resampled((1 - other.blend) * two.previous.x + other.blend * two.state.x, two.model.grid, one.model.grid);
        std::vector<float>& distances = distances_[c];
        distances.resize(static_cast<std::size_t>(particles));
        for (int p = 0; p < particles; ++p) {
            const auto distance = static_cast<double>((one.state.x.row(p) - there.row(p)).norm());
            distances[static_cast<std::size_t>(p)] = static_cast<float>(distance);
            squares += distance * distance;
            largest = std::max(largest, distance);
        }
        count += particles;
    }
    return {other, distances_, std::sqrt(squares / count), largest, text_};
}

}  // namespace drape
