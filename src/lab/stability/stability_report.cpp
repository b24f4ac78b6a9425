#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "stability_row.h"

namespace drape {
namespace {

/// How often the trials of a method with a limit speak against the prediction, and how far the measured limits are from
/// it.
std::string limited_summary(const std::vector<StabilityRow>& rows) {
    int against = 0;
    double lowest = std::numeric_limits<double>::infinity(), highest = 0;
    for (const StabilityRow& row : rows) {
        against += row.agreement == "disagrees" ? 1 : 0;
        lowest = std::min(lowest, row.measured / row.expected);
        highest = std::max(highest, row.measured / row.expected);
    }
    return fmt::format("{} against the prediction, measured limit {:.4g} to {:.4g} of the expected", against, lowest,
                       highest);
}

/// How often a method without a limit did not stay bounded, and the shortest step that failed in each sweep.
std::string unlimited_summary(const std::vector<StabilityRow>& rows) {
    const auto failed = std::ranges::count_if(rows, [](const StabilityRow& row) { return row.end != "bounded"; });
    std::map<std::string, std::map<double, double>> shortest;  // by sweep and what varies in it
    for (const StabilityRow& row : rows) {
        shortest[row.sweep][row.sweep == "damping" ? row.damping : row.stiffness] = row.measured;
    }
    std::string text = fmt::format("{} not bounded; shortest step that failed [s]", failed);
    for (const auto& [sweep, steps] : shortest) {
        text += "\n  " + sweep + ":";
        for (const auto& [value, step] : steps) text += fmt::format(" {:.3g}: {:.6g},", value, step);
        text.pop_back();
    }
    return text;
}

Chart stability_chart(const std::string& method, std::vector<StabilityRow> rows) {
    // The sheet that is drawn is the last of its method; the damped sweep of stiffness is for the table only
    std::erase_if(rows, [](const StabilityRow& row) { return row.sweep == "damped_stiffness"; });
    const double side = rows.back().side;
    std::erase_if(rows, [side](const StabilityRow& row) { return row.side != side; });
    const auto count = [&rows](std::string StabilityRow::*member, const char* word) {
        return static_cast<double>(std::ranges::count(rows, word, member));
    };
    const bool limited = std::isfinite(rows.front().expected);
    return {"stability_" + method,
            "stability",
            limited ? "Steps that stayed bounded and steps that failed, over stiffness and damping, and the longest "
                      "step that is predicted: every dot should lie below the line, every cross above it."
                    : "Steps that stayed bounded and steps that failed, over stiffness and damping, under a method "
                      "that has no linear limit: a cross is a failure that no linear theory predicts.",
            {{"method", method},
             {"side", side},
             {"trials", static_cast<double>(rows.size())},
             {"against", count(&StabilityRow::agreement, "disagrees")},
             {"limited", limited ? 1. : 0.},
             {"stiffness", count(&StabilityRow::sweep, "stiffness") > 0 ? 1. : 0.},
             {"damping", count(&StabilityRow::sweep, "damping") > 0 ? 1. : 0.}}};
}

}  // namespace

std::string stability_summary(const std::vector<StabilityRow>& rows) {
    std::map<std::string, std::vector<StabilityRow>> methods;
    for (const StabilityRow& row : rows) methods[row.method].push_back(row);
    std::string text;
    for (const auto& [method, trials] : methods) {
        const bool limited = std::isfinite(trials.front().expected);
        text += fmt::format("{}: {} trials, {}\n", method, trials.size(),
                            limited ? limited_summary(trials) : unlimited_summary(trials));
    }
    return text;
}

std::vector<Chart> stability_charts(const std::vector<StabilityRow>& rows) {
    std::vector<Chart> charts;
    for (const std::string& method : words_of(rows, &StabilityRow::method)) {
        const auto of_method = rows_with(rows, &StabilityRow::method, method);
        const auto drawn = [](const StabilityRow& row) { return row.sweep != "damped_stiffness"; };
        if (std::ranges::any_of(of_method, drawn)) charts.push_back(stability_chart(method, of_method));
    }
    return charts;
}

}  // namespace drape
