#include "drape/session/state_csv.h"

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

/// Calls with the full name and the field of every column of the balls.
template <class Work>
void for_each_ball_column(std::size_t balls, Work work) {
    for (std::size_t b = 0; b < balls; ++b) {
        for (const BallField& field : ball_fields()) {
            work("ball" + std::to_string(b) + "_" + std::string(field.name), field);
        }
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

void write_report_units(std::ostream& out) {
    const char* before = "# units: ";
    for (const ReportField& field : report_fields()) {
        if (field.unit.empty()) continue;
        out << before << field.name << " [" << field.unit << ']';
        before = ", ";
    }
}

void write_report_header(std::ostream& out) {
    const char* comma = "";
    for (const ReportField& field : report_fields()) {
        out << comma << field.name;
        comma = ",";
    }
}

void write_report(std::ostream& out, const StepReport& report) {
    const char* comma = "";
    for (const ReportField& field : report_fields()) {
        out << comma << real_text(field.read(report));
        comma = ",";
    }
}

void write_ball_units(std::ostream& out, std::size_t balls) {
    for_each_ball_column(balls, [&out](const std::string& name, const BallField& field) {
        out << ", " << name << " [" << field.unit << ']';
    });
}

void write_ball_header(std::ostream& out, std::size_t balls) {
    for_each_ball_column(balls, [&out](const std::string& name, const BallField&) { out << ',' << name; });
}

void write_balls(std::ostream& out, std::span<const Ball> balls, std::size_t columns) {
    for (std::size_t b = 0; b < columns; ++b) {
        for (const BallField& field : ball_fields()) {
            out << ',' << (b < balls.size() ? real_text(field.read(balls[b])) : "");
        }
    }
}

}  // namespace drape
