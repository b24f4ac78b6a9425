#include "lab/commands.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <set>

#include "drape/base/command_line.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/progress.h"
#include "drape/base/run_program.h"
#include "drape/base/stopwatch.h"
#include "drape/base/unfinished_file.h"
#include "experiment_table.h"

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

/// What an interrupted run of the same program, machine and settings has left, or an empty table.
ExperimentTable resumed(const Experiment& experiment, const TableHead& head, const std::filesystem::path& file) {
    const auto part = unfinished_name(file);
    auto left = read_table(experiment, part);
    if (!left) return {head, {}};
    if (const auto differs = difference(left->head, head, {"date"}); !differs.empty()) {
        throw InputError(part.string() + " is of another run (" + differs +
                         "): finish that one, remove it, or name another folder by --out");
    }
    if (!left->cases.empty()) {
        tell(part.string() + ": resuming, " + std::to_string(left->cases.size()) + " cases are done");
    }
    return *left;
}

/// Computes the cases that are missing.
void compute(const Experiment& experiment, const ExperimentCases& cases, std::vector<std::size_t> wanted,
             const TableHead& head, const std::filesystem::path& file) {
    constexpr double most_unwritten = 1;  // s
    ExperimentTable table = resumed(experiment, head, file);
    write_table(experiment, table, unfinished_name(file));
    const Stopwatch watch;
    Stopwatch unwritten;
    std::erase_if(wanted, [&](std::size_t number) { return table.cases.contains(number); });
    Progress progress(wanted.size(), "case");
    for (const std::size_t number : wanted) {
        table.cases[number] = cases[number - 1]();
        progress.advance();
        if (unwritten.seconds() < most_unwritten) continue;
        write_table(experiment, table, unfinished_name(file));
        unwritten.lap();
    }
    progress.clear();
    finish_table(experiment, table, file);
    tell(file.string() + ": " + std::to_string(wanted.size()) + " cases in " + real_text(watch.seconds(), 3) + " s");
}

/// The finished table of the same program, machine and settings; a table of anything else is none of ours.
std::optional<ExperimentTable> finished(const Experiment& experiment, const TableHead& head,
                                        const std::filesystem::path& file) try {
    auto table = read_table(experiment, file);
    if (table && !difference(table->head, head, {"date"}).empty()) table.reset();
    return table;
} catch (const InputError& error) {
    throw InputError(error.what(), "--again computes it once more, and keeps this one under another name");
}

void run(const Experiment& experiment, const RunOptions& options) {
    const auto cases = experiment.cases(options.selection.quick);
    const auto wanted = options.selection.numbers(cases.size());
    const std::filesystem::path folder = folder_of(experiment, options);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const auto file = folder / (experiment.name + ".csv");
    const UnfinishedFile lock(file.string() + ".lock");
    const TableHead head = head_of(experiment, options.selection, cases.size());
    std::optional<ExperimentTable> table;
    if (!options.again && !exists(unfinished_name(file))) table = finished(experiment, head, file);
    if (table) {
        tell(file.string() + ": all cases are there already; --again computes them once more");
    } else {
        compute(experiment, cases, wanted, head, file);
        table = read_table(experiment, file);
    }
    present(experiment, *table, file);
}

struct MergeOptions {
    std::vector<std::string> folders;
    std::string out = "merged";
};

/// The tables of all shares as that of a single run; nothing if there is none in these folders.
/// @throws InputError unless all are finished and of the same run but for date and machine, and have each case once
std::optional<ExperimentTable> joined(const Experiment& experiment, const std::vector<std::string>& folders) {
    std::optional<ExperimentTable> whole;
    std::string first;
    std::set<std::string> machines;
    for (const std::filesystem::path folder : folders) {
        const auto path = folder / (experiment.name + ".csv");
        if (exists(unfinished_name(path))) {
            throw InputError(unfinished_name(path).string() + ": not finished; start its run again to go on with it");
        }
        auto share = read_table(experiment, path);
        if (!share) continue;
        machines.insert(share->head["machine"]);
        std::string& settings = share->head["settings"];
        settings.resize(std::min(settings.find(" --share "), settings.size()));
        if (!whole) {
            first = path.string();
            whole = ExperimentTable{share->head, {}};
        }
        if (const auto differs = difference(share->head, whole->head, {"date", "machine"}); !differs.empty()) {
            throw InputError(fmt::format("{} is of another run than {} ({})", path.string(), first, differs));
        }
        whole->cases.merge(share->cases);
        if (share->cases.empty()) continue;
        throw InputError(
            fmt::format("case {} of {} is in a table before it, too", share->cases.begin()->first, path.string()));
    }
    if (!whole) return {};
    const std::string settings = whole->head["settings"], mark = " --cases ";
    const std::size_t at = settings.find(mark);
    const std::string cases = at == std::string::npos ? "1-" + whole->head["cases"] : settings.substr(at + mark.size());
    const auto range = parse_integers(cases, '-');
    if (!range || range->first < 1) throw InputError(fmt::format("{}: cases {}: allowed A-B", first, shortened(cases)));
    for (long long number = range->first; number <= range->second; ++number) {
        if (whole->cases.contains(static_cast<std::size_t>(number))) continue;
        throw InputError(fmt::format("case {} is missing beside {}: not all shares are there", number, first));
    }
    whole->head["machine"] = fmt::format("{}", fmt::join(machines, "; "));
    return whole;
}

void merge(std::span<const Experiment> experiments, const MergeOptions& options) {
    bool any = false;
    for (const Experiment& experiment : experiments) {
        const auto table = joined(experiment, options.folders);
        if (!table) continue;
        any = true;
        const std::filesystem::path folder = options.out, file = folder / (experiment.name + ".csv");
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        const UnfinishedFile lock(file.string() + ".lock");
        if (exists(unfinished_name(file))) {
            throw InputError(unfinished_name(file).string() +
                             ": an unfinished run is there; name another folder by --out");
        }
        finish_table(experiment, *table, file);
        tell(file.string() + ": " + std::to_string(table->cases.size()) + " cases");
        present(experiment, *table, file);
    }
    if (!any) throw InputError("there is no table of an experiment in " + options.folders.front());
}

}  // namespace

void add_experiments(CommandLine& line, std::span<const Experiment> experiments) {
    for (const Experiment& experiment : experiments) {
        auto options = std::make_shared<RunOptions>();
        CommandLine& command = line.command(experiment.name, "Experiment: " + experiment.question,
                                            [&experiment, options] { run(experiment, *options); });
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

void add_merge(CommandLine& line, std::span<const Experiment> experiments) {
    auto options = std::make_shared<MergeOptions>();
    CommandLine& command = line.command("merge", "Joins the tables of shares, and draws their charts",
                                        [experiments, options] { merge(experiments, *options); });
    command.option("folders", options->folders, "folders that --share runs have written", {"DIR...", true});
    command.option("--out", options->out, "folder for table, charts and page; 'merged' if not given", {"DIR"});
}

}  // namespace drape
