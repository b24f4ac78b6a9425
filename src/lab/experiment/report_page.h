#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment.h"
#include "experiment_table.h"

namespace drape {

/// Writes index.html beside a table: question, charts with captions, what was found, and where it is from. It opens
/// from disk and needs nothing but the files beside it.
/// @param charts that were drawn
/// @throws RunError if it cannot be written
void write_report_page(const Experiment& experiment, const TableHead& head, const std::vector<Chart>& charts,
                       const std::string& summary, const std::filesystem::path& table);

}  // namespace drape
