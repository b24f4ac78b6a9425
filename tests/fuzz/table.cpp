// The table of an experiment: read, written, read again.

#include <filesystem>
#include <optional>
#include <sstream>

#include "drape/base/input_file.h"
#include "fuzz/target.h"
#include "lab/experiment/experiment_table.h"
#include "lab/experiments.h"
#include "support/scratch_folder.h"

using namespace drape;

namespace {

/// What a table is as a file.
std::string written(const Experiment& experiment, const ExperimentTable& table) {
    static const ScratchFolder folder;
    const auto file = folder.path() / "table.csv";
    write_table(experiment, table, file);
    return read_text(file.string());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(fuzz::text_of(data, size));
    static const Experiment experiment = stability_experiment();
    std::optional<ExperimentTable> table;
    if (!fuzz::accepts([&] {
            std::istringstream in(text);
            table = read_table(experiment, in, "table.csv");
        })) {
        return 0;
    }
    const std::string once = written(experiment, *table);
    std::istringstream in(once);
    fuzz::require(written(experiment, read_table(experiment, in, "table.csv")) == once,
                  "a table that was written is read and written the same");
    // What it says in the end must not depend on luck
    fuzz::accepts([&] { (void)experiment.charts(table->rows()); });
    return 0;
}
