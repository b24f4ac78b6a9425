#include <fmt/ranges.h>

#include <map>
#include <memory>
#include <set>

#include "drape/base/command_line.h"
#include "drape/base/input_error.h"
#include "drape/base/run_program.h"
#include "drape/base/unfinished_file.h"
#include "run_experiment.h"

namespace drape {
namespace {

struct MergeOptions {
    std::vector<std::string> folders;
    std::string out = "merged";
};

/// The tables of all shares as that of a single run; nothing if there is none in these folders.
/// @throws InputError unless all are finished and of the same run but for date and machine, and have each case once
std::optional<ExperimentTable> joined(const Experiment& experiment, const std::vector<std::string>& folders) {
    std::optional<ExperimentTable> whole;
    std::string first;
    std::map<std::size_t, std::string> file_of;  // of each case
    std::set<std::string> machines;
    for (const std::filesystem::path folder : folders) {
        const auto path = folder / (experiment.name + ".csv");
        std::string file = path.string();
        if (exists(unfinished_name(path))) {
            throw InputError(unfinished_name(path).string() + ": not finished; start its run again to go on with it");
        }
        auto share = read_table(experiment, path, false);
        if (!share) continue;
        for (auto& [key, value] : share->head) {
            if (key == "machine") machines.insert(value);
            const std::size_t mark = key == "settings" ? value.find(" --share ") : std::string::npos;
            if (mark == std::string::npos) continue;
            file += " (" + value.substr(mark + 1) + ")";
            value.resize(mark);
        }
        if (!whole) {
            first = file;
            whole = ExperimentTable{share->head, {}};
        }
        if (const auto differs = difference(share->head, whole->head, {"date", "machine"}); !differs.empty()) {
            throw InputError(fmt::format("{} is of another run than {} ({})", file, first, differs));
        }
        for (const auto& [number, rows] : share->cases) {
            const auto [other, is_new] = file_of.emplace(number, file);
            if (!is_new) throw InputError(fmt::format("case {} is in {} and in {}", number, other->second, file));
        }
        whole->cases.merge(share->cases);
    }
    if (!whole) return {};
    const CaseSelection selection = parse_selection(line_of(whole->head, "settings")).value();
    for (const std::size_t number : selection.numbers(std::stoul(line_of(whole->head, "cases")))) {
        if (whole->cases.contains(number)) continue;
        throw InputError(fmt::format("case {} is missing beside {}: not all shares are there", number, first));
    }
    for (auto& [key, value] : whole->head) {
        if (key == "machine") value = fmt::format("{}", fmt::join(machines, "; "));
    }
    return whole;
}

void merge(std::span<const Experiment> experiments, const MergeOptions& options) {
    std::map<const Experiment*, ExperimentTable> found;
    for (const Experiment& experiment : experiments) {
        if (auto table = joined(experiment, options.folders)) found[&experiment] = std::move(*table);
    }
    if (found.empty()) throw InputError("there is no table of an experiment in " + options.folders.front());
    for (const auto& [of, table] : found) {
        const Experiment& experiment = *of;
        // A folder has one page
        const std::filesystem::path out = options.out, folder = found.size() == 1 ? out : out / experiment.name;
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        const auto file = folder / (experiment.name + ".csv");
        const FolderLock lock(file);
        if (exists(unfinished_name(file))) {
            throw InputError(unfinished_name(file).string() +
                             ": an unfinished run is there; name another folder by --out");
        }
        TableWriter(experiment, file, table).finish();
        tell(file.string() + ": " + std::to_string(table.cases.size()) + " cases");
        present(experiment, table, file);
    }
}

}  // namespace

void add_merge(CommandLine& line, std::span<const Experiment> experiments) {
    auto options = std::make_shared<MergeOptions>();
    CommandLine& command = line.command("merge", "Joins the tables of shares, and draws their charts",
                                        [experiments, options] { merge(experiments, *options); });
    command.option("folders", options->folders, "folders that --share runs have written", {"DIR...", true});
    command.option("--out", options->out,
                   "folder for table, charts and page, or for a folder an experiment where there are several; "
                   "'merged' if not given",
                   {"DIR"});
}

}  // namespace drape
