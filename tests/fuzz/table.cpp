// The table of an experiment, finished or not: read, written, read again.

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
    std::filesystem::remove(file);
    TableWriter(experiment, file, table).finish();
    return read_text(file.string());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(fuzz::text_of(data, size));
    static const Experiment experiment = stability_experiment();
    for (const bool unfinished : {false, true}) {
        std::optional<ExperimentTable> table;
        if (!fuzz::accepts([&] {
                std::istringstream in(text);
                table = read_table(experiment, in, "table.csv", unfinished);
            }) ||
            !table)
            continue;
        // An unfinished one may lack cases, which a table that is written may not
        if (unfinished) continue;
        const std::string once = written(experiment, *table);
        std::istringstream in(once);
        const auto again = read_table(experiment, in, "table.csv", false);
        fuzz::require(again && written(experiment, *again) == once,
                      "a table that was written is read and written the same");
        // What it says in the end must not depend on luck
        fuzz::accepts([&] { (void)experiment.charts(table->rows()); });
    }
    return 0;
}
