#include "drape/sim/state_csv.h"

#include "drape/base/numbers.h"

namespace drape {
namespace {

constexpr int exact_digits = 17;  // a double reads back as itself

}  // namespace

void write_state_header(std::ostream& out, const Simulation& simulation) {
    out << (simulation.cloths().size() > 1 ? "t,cloth,particle,x,y,z,vx,vy,vz\n" : "t,particle,x,y,z,vx,vy,vz\n");
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
            for (const Points* points : {&state.x, &state.v}) {
                for (int axis = 0; axis < 3; ++axis) {
                    out << ',' << real_text(static_cast<double>((*points)(p, axis)), exact_digits);
                }
            }
            out << '\n';
        }
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

}  // namespace drape
