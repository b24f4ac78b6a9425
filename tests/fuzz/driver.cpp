// The main program of a fuzz target where there is no libFuzzer: it runs a corpus, then seeded mutations of it. Its
// options are those of libFuzzer's that it has, so that one command line runs either.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/mutation.h"
#include "fuzz/target.h"

namespace {

using namespace drape::fuzz;

/// What is running, for the handler that keeps it when the process dies of it.
const std::string* running = nullptr;
std::string kept_name;

extern "C" void keep_input(int signal) {
    const int file = open(kept_name.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    const bool kept = running != nullptr && write(file, running->data(), running->size()) >= 0;
    const char* text = signal == SIGALRM ? "fuzz: too slow; " : "fuzz: crashed; ";
    [[maybe_unused]] ssize_t told = write(STDERR_FILENO, text, std::char_traits<char>::length(text));
    const char* where = kept ? "the input is in " : "the input could not be kept in ";
    told = write(STDERR_FILENO, where, std::char_traits<char>::length(where));
    told = write(STDERR_FILENO, kept_name.data(), kept_name.size());
    told = write(STDERR_FILENO, "\n", 1);
    _exit(signal == SIGALRM ? 70 : 77);  // libFuzzer's exit codes
}

#if defined(__SANITIZE_ADDRESS__)
extern "C" void __sanitizer_set_death_callback(void (*callback)());
void keep_on_report() { keep_input(SIGABRT); }
#endif

void watch_for_death() {
    for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL, SIGALRM}) std::signal(signal, keep_input);
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_set_death_callback(keep_on_report);
#endif
}

std::string whole(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

struct Options {
    std::vector<std::string> corpus;
    std::string dictionary, artifact_prefix;
    long long runs = std::numeric_limits<long long>::max();
    double seconds = std::numeric_limits<double>::infinity();
    unsigned long seed = 1;
    std::size_t longest = 4096;
    unsigned timeout = 20;  // s, for one input

    [[nodiscard]] bool bounded() const {
        return runs != std::numeric_limits<long long>::max() || seconds != std::numeric_limits<double>::infinity();
    }
};

std::optional<Options> parse(int argc, char** argv) {
    Options options;
    for (int a = 1; a < argc; ++a) {
        const std::string word = argv[a];
        const std::size_t equals = std::min(word.find('='), word.size());
        const std::string name = word.substr(0, equals), value = word.substr(std::min(equals + 1, word.size()));
        if (!word.starts_with('-')) {
            options.corpus.push_back(word);
        } else if (name == "-runs") {
            options.runs = std::stoll(value);
        } else if (name == "-max_total_time") {
            options.seconds = std::stod(value);
        } else if (name == "-seed") {
            options.seed = std::stoul(value);
        } else if (name == "-max_len") {
            options.longest = std::stoul(value);
        } else if (name == "-timeout") {
            options.timeout = static_cast<unsigned>(std::stoul(value));
        } else if (name == "-dict") {
            options.dictionary = value;
        } else if (name == "-artifact_prefix") {
            options.artifact_prefix = value;
        } else {
            std::cerr << "unknown option " << word << "\n";
            return {};
        }
    }
    // As with libFuzzer, files that are given alone are run and no more
    const bool alone = !options.corpus.empty() && std::ranges::none_of(options.corpus, [](const std::string& part) {
        return std::filesystem::is_directory(part);
    });
    if (alone && !options.bounded()) options.runs = 0;
    return options;
}

/// The files of a corpus in the order of their names.
std::vector<std::filesystem::path> files_of(const std::vector<std::string>& corpus) {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path part : corpus) {
        if (!is_directory(part)) files.push_back(part);
        if (!is_directory(part)) continue;
        for (const auto& entry : std::filesystem::directory_iterator(part)) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

void run(const std::string& input, unsigned timeout) {
    running = &input;
    alarm(timeout);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
    running = nullptr;
}

int fuzz_all(const Options& options) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    std::vector<std::string> seeds;
    for (const auto& file : files_of(options.corpus)) {
        kept_name = options.artifact_prefix + file.filename().string() + ".crash";
        seeds.push_back(whole(file));
        run(seeds.back(), options.timeout);
    }
    kept_name = options.artifact_prefix + "crash-seed-" + std::to_string(options.seed);
    long long done = static_cast<long long>(seeds.size());
    if (seeds.empty()) seeds.emplace_back();
    std::vector<std::string> words;
    if (!options.dictionary.empty()) words = dictionary_words(whole(options.dictionary));
    Mutation mutation(std::move(seeds), std::move(words), options.seed, options.longest);
    for (; done < options.runs && seconds() < options.seconds; ++done) run(mutation.next(), options.timeout);
    alarm(0);
    std::cerr << "Done " << done << " runs in " << static_cast<long long>(seconds()) << " second(s)\n";
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const auto options = parse(argc, argv);
    if (!options) return 2;
    watch_for_death();
    return fuzz_all(*options);
}
