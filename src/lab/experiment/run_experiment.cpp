#include "run_experiment.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "drape/base/folder_lock.h"
#include "drape/base/numbers.h"
#include "drape/base/program.h"
#include "drape/base/stopwatch.h"
#include "gnuplot.h"
#include "progress.h"
#include "report_page.h"
#include "share.h"

namespace drape {
namespace {

struct Options {
    std::string folder, share, cases;
    bool quick = false, again = false;
};

/// The numbers of the cases that are wanted, from 1.
std::set<std::size_t> wanted_cases(const Options& options, std::size_t count) {
    std::size_t first = 1, last = count;
    if (!options.cases.empty()) {
        const std::size_t dash = std::min(options.cases.find('-'), options.cases.size());
        const auto from = parse_integer(std::string_view(options.cases).substr(0, dash));
        const auto to = parse_integer(std::string_view(options.cases).substr(std::min(dash + 1, options.cases.size())));
        if (!from || !to || !(*from >= 1 && *from <= *to && *to <= static_cast<long long>(count))) {
            throw InputError("--cases " + options.cases.substr(0, 100) +
                             ": allowed FIRST-LAST with 1 <= FIRST <= LAST <= " + std::to_string(count));
        }
        first = static_cast<std::size_t>(*from);
        last = static_cast<std::size_t>(*to);
    }
    const Share share = parse_share(options.share);
    std::set<std::size_t> wanted;
    for (std::size_t number = first; number <= last; ++number) {
        if (share.has(number)) wanted.insert(number);
    }
    return wanted;
}

std::string settings_text(const Options& options) {
    return std::string(options.quick ? "--quick" : "whole") +
           (options.cases.empty() ? "" : " --cases " + options.cases) +
           (options.share.empty() ? "" : " --share " + options.share);
}

/// Shares that run side by side do not write into one folder.
std::filesystem::path folder_of(const Experiment& experiment, const Options& options) {
    if (!options.folder.empty()) return options.folder;
    std::string name = experiment.name;
    if (!options.share.empty()) name += "-" + options.share;
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
void check_alone(const Experiment& experiment, const std::filesystem::path& folder) {
    for (const Experiment& other : experiments()) {
        if (other.name == experiment.name || !exists(folder / (other.name + ".csv"))) continue;
        throw InputError(folder.string() + " has the table of " + other.name + ": name another folder by --out");
    }
}

/// True if a table of the same program, machine and settings is there and whole; anything else is none of ours.
bool is_done(const Experiment& experiment, const TableHead& head, const std::filesystem::path& file) try {
    const auto table = read_table(experiment, file, false);
    return table && !difference(head, table->head);
} catch (const InputError&) {
    return false;
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
        std::cerr << part.string() << ": goes on after " << left->cases.size() << " cases that are there\n";
    }
    return *left;
}

int run(const Experiment& experiment, const Options& options) {
    const auto cases = experiment.cases(options.quick);
    const auto wanted = wanted_cases(options, cases.size());
    const std::filesystem::path folder = folder_of(experiment, options);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    check_alone(experiment, folder);
    const auto file = folder / (experiment.name + ".csv");
    const FolderLock lock(file);
    const TableHead head = head_of(experiment, settings_text(options), cases.size());
    if (!options.again && !exists(unfinished_name(file)) && is_done(experiment, head, file)) {
        std::cerr << file.string() << ": all cases are there already; --again computes them anew\n";
        present(experiment, *read_table(experiment, file, false), file);
        return Done;
    }
    ExperimentTable table = resumed(experiment, head, file);
    TableWriter writer(experiment, file, table);

    const Stopwatch watch;
    const std::size_t before = table.cases.size();
    {
        Progress progress(wanted.size() - before);
        for (const std::size_t number : wanted) {
            if (table.cases.contains(number)) continue;
            auto rows = cases[number - 1]();
            writer.write(number, rows);
            table.cases[number] = std::move(rows);
            progress.advance();
        }
    }
    writer.finish();
    std::cerr << file.string() << ": " << table.cases.size() - before << " cases in " << real_text(watch.seconds(), 3)
              << " s\n";
    present(experiment, table, file);
    return Done;
}

}  // namespace

void present(const Experiment& experiment, const ExperimentTable& table, const std::filesystem::path& file) {
    const auto rows = table.rows();
    const std::string summary = experiment.summary(rows);
    std::cout << summary;
    auto charts = experiment.charts(rows);
    if (!draw_charts(charts, file)) {
        std::cerr << "There is no gnuplot: the charts are not drawn.\n";
        charts.clear();
    }
    write_report_page(experiment, table.head, charts, summary, file);
}

void add_experiments(CLI::App& app, int& exit_code) {
    for (const Experiment& experiment : experiments()) {
        CLI::App* command = app.add_subcommand(experiment.name, "Experiment: " + experiment.question);
        auto options = std::make_shared<Options>();
        command
            ->add_option("--out", options->folder,
                         "folder for table, charts and page; NAME, or NAME-K-N for a share, if not given")
            ->type_name("DIR");
        command->add_flag("--quick", options->quick, "fewer and smaller cases");
        command->add_option("--cases", options->cases, "only these cases")->type_name("FIRST-LAST");
        command->add_option("--share", options->share, "only the K-th of N parts of the cases")->type_name("K/N");
        command->add_flag("--again", options->again, "compute anew what is there already");
        command->footer("An interrupted run goes on where it was when it is started again. `merge` joins shares.");
        command->callback([&experiment, options, &exit_code] { exit_code = run(experiment, *options); });
    }
}

}  // namespace drape
