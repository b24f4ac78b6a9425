#include <fmt/ranges.h>

#include <map>
#include <memory>
#include <set>
#include <utility>

#include "case_selection.h"
#include "drape/base/command_line.h"
#include "drape/base/folder_lock.h"
#include "drape/base/input_error.h"
#include "drape/base/run_program.h"
#include "run_experiment.h"

namespace drape {
namespace {

struct MergeOptions {
    std::vector<std::string> folders;
    std::string out = "merged";
};

/// A table of one share.
struct Part {
    std::filesystem::path file;
    ExperimentTable table;
    std::string settings;  ///< without the share
    Share share;
};

std::vector<Part> parts_of(const Experiment& experiment, const std::vector<std::string>& folders) {
    std::vector<Part> parts;
    for (const std::filesystem::path folder : folders) {
        const auto file = folder / (experiment.name + ".csv");
        if (exists(unfinished_name(file))) {
            throw InputError(unfinished_name(file).string() + ": not finished; start its run again to go on with it");
        }
        auto table = read_table(experiment, file, false);
        if (!table) continue;
        CaseSelection selection = parse_selection(line_of(table->head, "settings")).value();
        const Share share = parse_share(std::exchange(selection.share, ""));
        parts.push_back({file, std::move(*table), selection.text(), share});
    }
    return parts;
}

/// Every share once, all of the same run but for date and machine.
void check_fit(const std::vector<Part>& parts) {
    const Part& first = parts.front();
    const auto fail = [](const std::string& what) { throw InputError(what); };
    std::set<std::size_t> missing;
    for (std::size_t k = 1; k <= first.share.parts; ++k) missing.insert(k);
    for (const Part& part : parts) {
        const std::string file = part.file.string();
        const auto demand_same = [&](const char* key, const std::string& here, const std::string& there) {
            if (here != there)
                fail(fmt::format("{}: {} is {}, but {} in {}", file, key, here, there, first.file.string()));
        };
        for (const char* key : {"drape", "commit", "compiler", "cases"}) {
            demand_same(key, line_of(part.table.head, key), line_of(first.table.head, key));
        }
        demand_same("settings", part.settings, first.settings);
        demand_same("number of shares", std::to_string(part.share.parts), std::to_string(first.share.parts));
        if (missing.erase(part.share.part) > 0) continue;
        fail(fmt::format("{}: share {}/{} is there twice", file, part.share.part, part.share.parts));
    }
    if (missing.empty()) return;
    fail(
        fmt::format("part {} of {} was not found beside {}", *missing.begin(), first.share.parts, first.file.string()));
}

ExperimentTable joined(std::vector<Part> parts) {
    ExperimentTable whole{parts.front().table.head, {}};
    std::set<std::string> machines;
    for (Part& part : parts) {
        machines.insert(line_of(part.table.head, "machine"));
        whole.cases.merge(part.table.cases);
    }
    for (auto& [key, value] : whole.head) {
        if (key == "settings") value = parts.front().settings;
        if (key == "machine") value = fmt::format("{}", fmt::join(machines, "; "));
    }
    return whole;
}

int merge(std::span<const Experiment> experiments, const MergeOptions& options) {
    std::map<const Experiment*, ExperimentTable> found;
    for (const Experiment& experiment : experiments) {
        auto parts = parts_of(experiment, options.folders);
        if (parts.empty()) continue;
        check_fit(parts);
        found[&experiment] = joined(std::move(parts));
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
    return Done;
}

}  // namespace

void add_merge(CommandLine& line, std::span<const Experiment> experiments, int& exit_code) {
    auto options = std::make_shared<MergeOptions>();
    CommandLine& command =
        line.command("merge", "Joins the tables of shares, and draws their charts",
                     [experiments, options, &exit_code] { exit_code = merge(experiments, *options); });
    command.option("folders", options->folders, "folders that --share runs have written", {"DIR...", true});
    command.option("--out", options->out,
                   "folder for table, charts and page, or for a folder an experiment where there are several; "
                   "'merged' if not given",
                   {"DIR"});
}

}  // namespace drape
