#include <fmt/core.h>

#include <limits>

#include "drape/base/enum_names.h"
#include "lab/experiments.h"
#include "shots.h"

namespace drape {

template <>
inline constexpr auto enum_names<Target> = all_names<Target>("point", "sheet");

namespace {

/// A line of the table: shots at one target at one speed, or times of one way to detect on one cloth.
struct ContinuousRow {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();
    static constexpr Quartiles no_times{none, none, none};

    std::string part;       ///< misses or time
    std::string target;     ///< of misses
    std::string detection;  ///< of time
    double q = none;        ///< v dt / (2 R)
    double shots = none;
    double discrete = none, continuous = none, predicted = none;  ///< parts of the shots that are missed
    double particles = none;
    Quartiles build = no_times, search = no_times;
};

using ContinuousRows = std::vector<ContinuousRow>;

ContinuousRows misses_at(Target target, double q, int shots) {
    const ShotCount count = shoot(target, q, shots);
    ContinuousRow row{.part = "misses", .target = name_of(target), .detection = "none", .q = q, .shots = count.shots};
    row.discrete = count.discrete / count.shots;
    row.continuous = count.continuous / count.shots;
    row.predicted = predicted_misses(target, q);
    return {row};
}

ContinuousRows times_of(int side, int steps) {
    const BothDetections both = time_detections(side, steps);
    ContinuousRows rows;
    for (const bool continuous : {false, true}) {
        const DetectionTimes& times = continuous ? both.continuous : both.discrete;
        ContinuousRow row{.part = "time", .target = "none", .detection = continuous ? "continuous" : "discrete"};
        row.particles = static_cast<double>(side) * side;
        row.build = times.build, row.search = times.search;
        rows.push_back(row);
    }
    return rows;
}

std::vector<CaseOf<ContinuousRow>> continuous_cases(bool quick) {
    std::vector<CaseOf<ContinuousRow>> all;
    const auto qs =
        quick ? std::vector{0.5, 1.0, 2.0, 8.0} : std::vector{0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0,
                                                              1.25,  1.5,  2.0,   3.0, 4.0,   8.0,  16.0,  83.0};
    for (const Target target : {Target::Point, Target::Sheet}) {
        for (const double q : qs) all.push_back([=] { return misses_at(target, q, quick ? 5'000 : 100'000); });
    }
    for (const int side : quick ? std::vector{32, 64} : std::vector{16, 32, 64, 128, 256, 512}) {
        all.push_back([=] { return times_of(side, quick ? 31 : 101); });
    }
    return all;
}

RowFormat<ContinuousRow> continuous_format() {
    using Row = ContinuousRow;
    const auto missed = [](const Column& column) { return column.or_nan().where("part", {"time"}); };
    const auto timed = [](const Column& column) { return column.or_nan().where("part", {"misses"}); };
    return {6,
            {{word_column("part", {"misses", "time"}), &Row::part},
             {name_column<Target>("target", {"none"}), &Row::target},
             {word_column("detection", {"discrete", "continuous", "none"}), &Row::detection},
             {missed(positive_column("q")), &Row::q},
             {missed(whole_column("shots", 1)), &Row::shots},
             {missed(number_column("discrete_missed")), &Row::discrete},
             {missed(number_column("continuous_missed")), &Row::continuous},
             {missed(number_column("predicted")), &Row::predicted},
             {timed(whole_column("particles", 4)), &Row::particles},
             {timed(number_column("build_s")), &Row::build},
             {timed(number_column("search_s")), &Row::search}}};
}

std::string continuous_summary(const ContinuousRows& rows) {
    std::string text;
    for (const ContinuousRow& row : rows_with(rows, &ContinuousRow::part, "misses")) {
        text += fmt::format("misses: {} at q = {}: discrete {:.4f}, predicted {:.4f}, continuous {}\n", row.target,
                            row.q, row.discrete, row.predicted, row.continuous);
    }
    for (const ContinuousRow& row : rows_with(rows, &ContinuousRow::part, "time")) {
        text += fmt::format("time: {}, {} particles: build {:.3g} us, search {:.3g} us\n", row.detection, row.particles,
                            1e6 * row.build.median, 1e6 * row.search.median);
    }
    return text;
}

std::vector<Chart> continuous_charts(const ContinuousRows& rows) {
    const auto misses = rows_with(rows, &ContinuousRow::part, "misses");
    const auto times = rows_with(rows, &ContinuousRow::part, "time");
    std::vector<Chart> charts;
    if (!misses.empty()) {
        charts.push_back({"continuous_misses",
                          "continuous_misses",
                          "The part of the shots that pass a target unseen, against the diameters that the ball "
                          "moves in a step: by positions at whole steps, beside what is predicted for it, and by "
                          "all that may have met between them.",
                          {{"targets", in_words(words_of(misses, &ContinuousRow::target))}}});
    }
    if (!times.empty()) {
        charts.push_back({"continuous_time",
                          "continuous_time",
                          "CPU time of the build and of the search, query and exact test, at the positions after a "
                          "step and over all of it: medians with quartiles.",
                          {{"detections", in_words(words_of(times, &ContinuousRow::detection))}}});
    }
    return charts;
}

}  // namespace

Experiment continuous_experiment() {
    return ExperimentOf<ContinuousRow>{
        "continuous",        "what passes unseen between two steps, and what does it cost to see it?",
        continuous_format(), continuous_cases,
        continuous_charts,   continuous_summary}
        .as_table();
}

}  // namespace drape
