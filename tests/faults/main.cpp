// faults [--seed K] [--folder DIR] [NAME=COUNT]...: does to the programs what they must bear, and counts what they do
// not. Without a name each kind of fault is tried as often as in the tests.

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <map>

#include "faults/fault.h"

namespace drape::faults {
namespace {

const std::vector<Fault>& all_faults() {
    static const std::vector<Fault> faults{
        {"kill_capture", "SIGKILL to drape-capture at random times", 6, kill_capture},
        {"kill_experiment", "SIGKILL to experiments at random times", 3, kill_experiments},
        {"full_disk", "disks and files that are full", 4, fill_disk},
        {"read_only", "folders that take no files", 1, write_where_nobody_may},
        {"closed_streams", "standard streams closed or full", 1, close_streams},
        {"no_memory", "a limit of memory", 4, withhold_memory},
        {"no_threads", "threads that cannot be started", 4, withhold_threads},
        {"locale", "a locale with a decimal comma", 1, change_locale},
    };
    return faults;
}

int run(int argc, char** argv) {
    std::map<std::string, int> counts;
    unsigned long seed = 1;
    std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("drape-faults-" + std::to_string(getpid()));
    for (int a = 1; a < argc; ++a) {
        const std::string word = argv[a];
        const std::size_t equals = std::min(word.find('='), word.size());
        if (word == "--seed" && a + 1 < argc) {
            seed = std::stoul(argv[++a]);
        } else if (word == "--folder" && a + 1 < argc) {
            folder = argv[++a];
        } else {
            counts[word.substr(0, equals)] = equals < word.size() ? std::stoi(word.substr(equals + 1)) : 0;
        }
    }
    int failed = 0;
    const bool all = counts.empty();
    std::vector<std::string> results;
    for (const Fault& fault : all_faults()) {
        if (!all && !counts.contains(fault.name)) continue;
        const int count = counts[fault.name] > 0 ? counts[fault.name] : fault.quick;
        counts.erase(fault.name);
        Trial trial(folder / fault.name, seed);
        fault.run(trial, count);
        failed += trial.failed();
        std::printf("%-18s %6d checks, %4d failed: %s\n", fault.name.c_str(), trial.tried(), trial.failed(),
                    fault.help.c_str());
        std::fflush(stdout);
        results.push_back("result," + fault.help + "," + std::to_string(trial.tried()) + "," +
                          std::to_string(trial.failed()));
    }
    for (const auto& [name, count] : counts) std::cerr << "there is no fault '" << name << "'\n";
    for (const std::string& result : results) std::cout << result << "\n";
    if (failed == 0) std::filesystem::remove_all(folder);
    return !counts.empty() ? 2 : failed > 0 ? 1 : 0;
}

}  // namespace
}  // namespace drape::faults

int main(int argc, char** argv) { return drape::faults::run(argc, argv); }
