#include "drape/session/state_csv.h"

#include <utility>

#include "drape/base/numbers.h"

namespace drape {
namespace {

constexpr int exact_digits = 17;  // a double reads back as itself

template <class Numbers>
void append(std::ostream& out, const Numbers& numbers) {
    for (Eigen::Index k = 0; k < numbers.size(); ++k) {
        out << ',' << real_text(static_cast<double>(numbers[k]), exact_digits);
    }
}

}  // namespace

void write_state_header(std::ostream& out, const Simulation& simulation) {
    out << (simulation.cloths().size() > 1 ? "t,cloth,particle,x,y,z,vx,vy,vz\n" : "t,particle,x,y,z,vx,vy,vz\n");
    if (!simulation.balls().empty()) out << "# " << ball_columns << '\n';
}

void write_state(std::ostream& out, const Simulation& simulation) {
    const std::string time = real_text(simulation.report().time, exact_digits);
    const auto cloths = simulation.cloths();
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        const ClothState& state = cloths[c].state;
        for (Eigen::Index p = 0; p < state.x.rows(); ++p) {
            out << time << ',';
            if (cloths.size() > 1) out << c << ',';
            out << p;
            append(out, state.x.row(p));
            append(out, state.v.row(p));
            out << '\n';
        }
    }
    for (std::size_t b = 0; b < simulation.balls().size(); ++b) {
        const Ball& ball = simulation.balls()[b];
        out << "# " << time << ',' << b;
        append(out, ball.centre);
        append(out, ball.velocity);
        append(out, ball.orientation.coeffs());
        append(out, ball.spin);
        out << '\n';
    }
}

void add_report_columns(std::vector<StatsColumn>& columns) {
    for (const ReportField& field : report_fields()) {
        columns.push_back({std::string(field.name), std::string(field.unit),
                           [&field](const FrameView& view) { return real_text(field.read(*view.report)); }});
    }
}

void add_ball_columns(std::vector<StatsColumn>& columns, std::size_t balls) {
    for (std::size_t b = 0; b < balls; ++b) {
        for (const BallField& field : ball_fields()) {
            columns.push_back({"ball" + std::to_string(b) + "_" + std::string(field.name), std::string(field.unit),
                               [&field, b](const FrameView& view) {
                                   return b < view.balls.size() ? real_text(field.read(view.balls[b])) : "";
                               }});
        }
    }
}

void write_stats_head(std::ostream& out, std::span<const StatsColumn> columns) {
    std::string units, names;
    for (const StatsColumn& column : columns) {
        if (!column.unit.empty()) units += (units.empty() ? "" : ", ") + column.name + " [" + column.unit + "]";
        names += (names.empty() ? "" : ",") + column.name;
    }
    out << "# units: " << units << '\n' << names << '\n';
}

void write_stats_row(std::ostream& out, std::span<const StatsColumn> columns, const FrameView& view) {
    const char* comma = "";
    for (const StatsColumn& column : columns) out << std::exchange(comma, ",") << column.cell(view);
    out << '\n';
}

}  // namespace drape
