#include "experiment.h"

#include <array>
#include <ctime>
#include <fstream>
#include <memory>

#include "drape/base/numbers.h"
#include "drape/base/output_file.h"
#include "drape/base/program.h"
#include "drape/base/real.h"
#include "drape/base/stopwatch.h"
#include "gnuplot.h"

namespace drape {
namespace {

struct Options {
    std::string folder, share;
    bool quick = false;
};

/// The K-th of N parts of the cases.
struct Share {
    std::size_t part = 1, parts = 1;
};

Share parse_share(const std::string& text) {
    constexpr long long most = 10000;
    if (text.empty()) return {};
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto part = parse_integer(std::string_view(text).substr(0, slash));
    const auto parts = parse_integer(std::string_view(text).substr(std::min(slash + 1, text.size())));
    if (!part || !parts || !(*part >= 1 && *part <= *parts && *parts <= most)) {
        throw InputError("--share " + text.substr(0, 100) +
                         ": allowed K/N with 1 <= K <= N <= " + std::to_string(most));
    }
    return {static_cast<std::size_t>(*part), static_cast<std::size_t>(*parts)};
}

std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("model name")) return line.substr(std::min(line.find(':') + 2, line.size()));
    }
    return "unknown";
}

std::string compiler() {
#ifdef __clang__
    return __VERSION__;
#else
    return "g++ " __VERSION__;
#endif
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    std::array<char, 16> text{};
    gmtime_r(&now, &parts);
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts);
    return text.data();
}

std::string joined(const TableRow& row) {
    std::string line;
    for (const std::string& cell : row) line += (line.empty() ? "" : ",") + cell;
    return line + "\n";
}

/// What a table must say about where it comes from.
std::string head(const Experiment& experiment, const Options& options) {
    return "# experiment: " + experiment.name + " (" + experiment.question + ")\n# drape " + DRAPE_VERSION +
           (sizeof(Real) == 4 ? ", single" : ", double") +
           " precision, commit " DRAPE_COMMIT "\n# machine: " + processor() + "\n# compiler: " + compiler() +
           "\n# date: " + today() + "\n# settings:" + (options.quick ? " --quick" : " whole") +
           (options.share.empty() ? "" : " --share " + options.share) + "\n";
}

int run(const Experiment& experiment, const Options& options) {
    const Share share = parse_share(options.share);
    const std::filesystem::path folder = options.folder.empty() ? experiment.name : options.folder;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const auto table = folder / (experiment.name + ".csv");
    OutputFile file(table.string());
    file.stream() << head(experiment, options) << joined(experiment.columns);

    const Stopwatch watch;
    const auto cases = experiment.cases(options.quick);
    std::vector<TableRow> rows;
    for (std::size_t i = share.part - 1; i < cases.size(); i += share.parts) {
        for (TableRow& row : cases[i]()) {
            file.stream() << joined(row);
            rows.push_back(std::move(row));
        }
        file.stream().flush();
    }
    file.close();
    std::cout << experiment.summary(rows);
    std::cerr << table.string() << ": " << rows.size() << " rows in " << real_text(watch.seconds(), 3) << " s\n";
    if (!draw_charts(experiment.charts(rows), table)) std::cerr << "There is no gnuplot: the charts are not drawn.\n";
    return Done;
}

}  // namespace

void add_experiments(CLI::App& app, int& exit_code) {
    for (const Experiment& experiment : experiments()) {
        CLI::App* command = app.add_subcommand(experiment.name, "Experiment: " + experiment.question);
        auto options = std::make_shared<Options>();
        command->add_option("--out", options->folder, "folder for table and charts; that of its name if not given")
            ->type_name("DIR");
        command->add_flag("--quick", options->quick, "fewer and smaller cases");
        command->add_option("--share", options->share, "only the K-th of N parts of the cases")->type_name("K/N");
        command->callback([&experiment, options, &exit_code] { exit_code = run(experiment, *options); });
    }
}

}  // namespace drape
