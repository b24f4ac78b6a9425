#include "drape/base/enum_names.h"
#include "lab/experiments.h"
#include "shots.h"

namespace drape {

template <>
inline constexpr auto enum_names<Target> = all_names<Target>("point", "sheet");

namespace {

/// A line of the table: shots at one target at one speed, or times of one way to detect on one cloth.
struct ContinuousRow {
    std::string part;                ///< misses or time
    std::string target = "none";     ///< of misses
    std::string detection = "none";  ///< of time
    double q = no_number;            ///< v dt / (2 R)
    double shots = no_number;
    double discrete = no_number, continuous = no_number, predicted = no_number;  ///< parts of the shots that are missed
    double particles = no_number;
    Quartiles build = no_quartiles, search = no_quartiles;
};

using ContinuousRows = std::vector<ContinuousRow>;

ContinuousRows misses_at(Target target, double q, int shots) {
    const ShotCount count = shoot(target, q, shots);
    return {{.part = "misses",
             .target = name_of(target),
             .q = q,
             .shots = count.shots,
             .discrete = count.discrete / count.shots,
             .continuous = count.continuous / count.shots,
             .predicted = predicted_misses(target, q)}};
}

ContinuousRows times_of(int side, int steps) {
    const auto [discrete, continuous] = time_detections(side, steps);
    const double particles = static_cast<double>(side) * side;
    return {{.part = "time",
             .detection = "discrete",
             .particles = particles,
             .build = discrete.build,
             .search = discrete.search},
            {.part = "time",
             .detection = "continuous",
             .particles = particles,
             .build = continuous.build,
             .search = continuous.search}};
}

std::vector<CaseOf<ContinuousRow>> miss_cases(bool quick) {
    return cases_over([=](Target target, double q) { return misses_at(target, q, quick ? 5'000 : 100'000); },
                      std::vector{Target::Point, Target::Sheet},
                      quick ? std::vector{0.5, 1.0, 2.0, 8.0}
                            : std::vector{0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0, 1.25, 1.5, 2.0, 3.0, 4.0,
                                          8.0, 16.0, 83.0});
}

std::vector<CaseOf<ContinuousRow>> time_cases(bool quick) {
    return cases_over([=](int side) { return times_of(side, quick ? 31 : 101); },
                      quick ? std::vector{32, 64} : std::vector{16, 32, 64, 128, 256, 512});
}

std::vector<Chart> miss_charts(const ContinuousRows& rows) {
    return {{"continuous_misses",
             "continuous_misses",
             "The part of the shots that pass a target unseen, against the diameters that the ball moves in a step: by "
             "discrete detection, beside what is predicted for it, and by continuous detection.",
             {{"targets", in_words(words_of(rows, &ContinuousRow::target))}}}};
}

std::vector<Chart> time_charts(const ContinuousRows& rows) {
    return {{"continuous_time",
             "continuous_time",
             "CPU time of the build and of the search, query and exact test, at the positions after a step and over "
             "all of it: medians with quartiles.",
             {{"detections", in_words(words_of(rows, &ContinuousRow::detection))}}}};
}

}  // namespace

Experiment continuous_experiment() {
    using Row = ContinuousRow;
    return ExperimentOf<Row>{"continuous",
                             "what passes unseen between two steps, and what does it cost to see it?",
                             {6,
                              {{word_column("part", {"misses", "time"}), &Row::part},
                               {name_column<Target>("target", {"none"}), &Row::target},
                               {word_column("detection", {"discrete", "continuous", "none"}), &Row::detection},
                               {positive_column("q").or_nan(), &Row::q},
                               {whole_column("shots", 1).or_nan(), &Row::shots},
                               {number_column("discrete_missed").or_nan(), &Row::discrete},
                               {number_column("continuous_missed").or_nan(), &Row::continuous},
                               {number_column("predicted").or_nan(), &Row::predicted},
                               {whole_column("particles", 4).or_nan(), &Row::particles},
                               {number_column("build_s").or_nan(), &Row::build},
                               {number_column("search_s").or_nan(), &Row::search}}},
                             {{"part", "target", "detection", "q", "particles"},
                              {"discrete_missed", "predicted", "continuous_missed", "build_s", "search_s"}},
                             {{"misses", miss_cases, miss_charts}, {"time", time_cases, time_charts}}};
}

}  // namespace drape
