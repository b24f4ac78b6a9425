#include "run_experiment.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "case_selection.h"
#include "drape/base/command_line.h"
#include "drape/base/folder_lock.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/progress.h"
#include "drape/base/run_program.h"
#include "drape/base/stopwatch.h"

namespace drape {
namespace {

struct RunOptions {
    std::string folder;
    CaseSelection selection;
    bool again = false;
};

/// Shares that run side by side do not write into one folder.
std::filesystem::path folder_of(const Experiment& experiment, const RunOptions& options) {
    if (!options.folder.empty()) return options.folder;
    std::string name = experiment.name;
    if (!options.selection.share.empty()) name += "-" + options.selection.share;
    std::replace(name.begin(), name.end(), '/', '-');
    return name;
}

/// The first line in which another run differs, but for the date; nothing if it is the same.
std::optional<std::string> difference(const TableHead& head, const TableHead& other) {
    for (const auto& [key, value] : head) {
        const std::string there = line_of(other, key);
        if (key != "date" && there != value) return key + ": " + there + ", now " + value;
    }
    return {};
}

/// One page and one table a folder.
void check_alone(const Experiment& experiment, std::span<const Experiment> all, const std::filesystem::path& folder) {
    for (const Experiment& other : all) {
        if (other.name == experiment.name || !exists(folder / (other.name + ".csv"))) continue;
        throw InputError(folder.string() + " has the table of " + other.name + ": name another folder by --out");
    }
}

/// The finished table of the same program, machine and settings, if there is one; anything else is none of ours.
/// @throws InputError if its head says that it is, and its rows are not
std::optional<ExperimentTable> finished(const Experiment& experiment, const TableHead& head,
                                        const std::filesystem::path& file) {
    const auto there = read_head(experiment, file);
    if (!there || difference(head, *there)) return {};
    try {
        return read_table(experiment, file, false);
    } catch (const InputError& error) {
        throw InputError(error.what(), "--again computes it once more, and keeps this one under another name");
    }
}

/// What an interrupted run of the same program, machine and settings has left, or an empty table.
ExperimentTable resumed(const Experiment& experiment, const TableHead& head, const std::filesystem::path& file) {
    const auto part = unfinished_name(file);
    auto left = read_table(experiment, part, true);
    if (!left) return {head, {}};
    if (const auto differs = difference(head, left->head)) {
        throw InputError(part.string() + " is of another run (" + *differs +
                         "): finish that one, remove it, or name another folder by --out");
    }
    if (!left->cases.empty()) {
        tell(part.string() + ": resuming, " + std::to_string(left->cases.size()) + " cases are done");
    }
    return *left;
}

int run(const Experiment& experiment, std::span<const Experiment> all, const RunOptions& options) {
    const auto cases = experiment.cases(options.selection.quick);
    const auto wanted = options.selection.numbers(cases.size());
    const std::filesystem::path folder = folder_of(experiment, options);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    check_alone(experiment, all, folder);
    const auto file = folder / (experiment.name + ".csv");
    const FolderLock lock(file);
    const TableHead head = head_of(experiment, options.selection.text(), cases.size());
    if (!options.again && !exists(unfinished_name(file))) {
        if (const auto done = finished(experiment, head, file)) {
            tell(file.string() + ": all cases are there already; --again computes them once more");
            present(experiment, *done, file);
            return Done;
        }
    }
    ExperimentTable table = resumed(experiment, head, file);
    TableWriter writer(experiment, file, table);

    const Stopwatch watch;
    const std::size_t before = table.cases.size();
    {
        Progress progress(wanted.size() - before, "case");
        for (const std::size_t number : wanted) {
            if (table.cases.contains(number)) continue;
            std::vector<TableRow> rows;
            for (const Row& row : cases[number - 1]()) rows.push_back(row.texts(experiment.columns, experiment.digits));
            writer.write(number, rows);
            table.cases[number] = std::move(rows);
            progress.advance();
        }
    }
    writer.finish();
    tell(file.string() + ": " + std::to_string(table.cases.size() - before) + " cases in " +
         real_text(watch.seconds(), 3) + " s");
    present(experiment, table, file);
    return Done;
}

}  // namespace

void add_experiments(CommandLine& line, std::span<const Experiment> experiments, int& exit_code) {
    for (const Experiment& experiment : experiments) {
        auto options = std::make_shared<RunOptions>();
        CommandLine& command = line.command(
            experiment.name, "Experiment: " + experiment.question,
            [&experiment, experiments, options, &exit_code] { exit_code = run(experiment, experiments, *options); });
        command.option("--out", options->folder,
                       "folder for table, charts and page; NAME, or NAME-K-N for a share, if not given", {"DIR"});
        command.flag("--quick", options->selection.quick, "fewer and smaller cases");
        command.option("--cases", options->selection.cases, "only these cases", {"FIRST-LAST"});
        command.option("--share", options->selection.share, "only the K-th of N parts of the cases", {"K/N"});
        command.flag("--again", options->again, "compute once more what is there already");
        command.footer(
            [] { return "An interrupted run goes on where it was when it is started again. `merge` joins shares."; });
    }
}

}  // namespace drape
