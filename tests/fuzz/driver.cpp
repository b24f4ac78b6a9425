// The main program of a fuzz target where there is no libFuzzer: it runs a corpus, then seeded mutations of it. Its
// options are those of libFuzzer's that it has, so that one command line runs either.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "drape/base/stopwatch.h"
#include "fuzz/target.h"
#include "support/random_user.h"

namespace {

using namespace drape::fuzz;

constexpr std::size_t most_changes = 6;

constexpr const char* extreme_numbers =
    "0 -0 1 -1 2 1e-320 5e-324 1e308 1e309 -1e308 nan inf -inf 0x10 1e-30 1e12 2147483647 2147483648 4294967296 "
    "-2 9223372036854775807 0.1 1e-9 9223372036854775808 18446744073709551616 1_000 1e6 999999 0,5 "
    "1.0000000000000002 4096 4097";

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream words(text);
    return {std::istream_iterator<std::string>(words), {}};
}

bool in_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == 'e' || c == '-' || c == '+'; }

/// Makes new inputs of old ones: bytes flipped, put in, taken out and repeated, parts of two inputs joined, words of a
/// dictionary put in, numbers made extreme. The same seed makes the same inputs.
class Mutation : drape::test::Chance {
public:
    /// @param seeds at least one, which may be empty
    /// @param longest of an input that is made [bytes]
    Mutation(std::vector<std::string> seeds, std::vector<std::string> dictionary, unsigned long seed,
             std::size_t longest)
        : Chance(seed),
          seeds_(std::move(seeds)),
          dictionary_(std::move(dictionary)),
          numbers_(words_of(extreme_numbers)),
          longest_(longest) {
        if (dictionary_.empty()) dictionary_ = numbers_;
    }

    /// The next input.
    const std::string& next() {
        input_ = one_of(seeds_);
        for (std::size_t changes = 1 + below(most_changes); changes > 0; --changes) change_once();
        if (input_.size() > longest_) input_.resize(longest_);
        return input_;
    }

private:
    std::size_t position() { return below(input_.size() + 1); }
    const std::string& one_of(const std::vector<std::string>& texts) { return texts[below(texts.size())]; }
    void change_once();
    void splice();
    void replace_number();

    std::vector<std::string> seeds_, dictionary_, numbers_;
    std::size_t longest_;
    std::string input_;
};

void Mutation::change_once() {
    const std::size_t at = position(), size = input_.size();
    const std::size_t length = std::min(below(16) == 0 ? below(size + 1) : below(8), size - at);
    switch (below(10)) {
        case 0:
            if (at < size) input_[at] = static_cast<char>(input_[at] ^ (1 << below(8)));
            break;
        case 1:
            if (at < size) input_[at] = static_cast<char>(below(256));
            break;
        case 2:
            input_.insert(at, 1 + below(4), static_cast<char>(below(256)));
            break;
        case 3:
            input_.erase(at, length);
            break;
        case 4:
            input_.insert(position(), input_.substr(at, length));
            break;
        case 5:
            splice();
            break;
        case 6:
            input_.insert(at, one_of(dictionary_));
            break;
        case 7:
            input_.replace(at, length, one_of(dictionary_));
            break;
        default:
            replace_number();
    }
}

/// The beginning of this input and the end of another, or a piece of the other in the midst.
void Mutation::splice() {
    const std::string& other = one_of(seeds_);
    const std::size_t from = below(other.size() + 1);
    if (below(2) == 0) {
        input_ = input_.substr(0, position()) + other.substr(from);
    } else {
        input_.insert(position(), other, from, below(64));
    }
}

void Mutation::replace_number() {
    std::size_t begin = position();
    const auto first = std::find_if(input_.begin() + static_cast<std::ptrdiff_t>(begin), input_.end(), in_number);
    if (first == input_.end()) return;
    begin = static_cast<std::size_t>(first - input_.begin());
    const auto last = std::find_if_not(first, input_.end(), in_number);
    input_.replace(begin, static_cast<std::size_t>(last - first), one_of(numbers_));
}

/// The words of a dictionary as libFuzzer writes them: a line each in double quotes, with \xNN, \\ and \" in it.
std::vector<std::string> dictionary_words(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t open = line.find('"'), close = line.rfind('"');
        if (line.starts_with('#') || open == close) continue;
        std::string word;
        for (std::size_t i = open + 1; i < close; ++i) {
            if (line[i] == '\\' && line[i + 1] == 'x') {
                word += static_cast<char>(std::stoi(line.substr(i + 2, 2), nullptr, 16));
                i += 3;
            } else {
                if (line[i] == '\\') ++i;
                word += line[i];
            }
        }
        words.push_back(word);
    }
    return words;
}

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

/// The command line: files and folders of inputs, and libFuzzer's options that there are here, empty if not given.
struct Options {
    std::vector<std::string> corpus;
    std::map<std::string, std::string> given{{"-runs", ""},           {"-max_total_time", ""}, {"-seed", ""},
                                             {"-max_len", ""},        {"-timeout", ""},        {"-dict", ""},
                                             {"-artifact_prefix", ""}};

    /// @return false for an option that there is not
    bool take(const std::string& word) {
        const std::size_t equals = std::min(word.find('='), word.size());
        const auto option = given.find(word.substr(0, equals));
        if (option != given.end()) option->second = word.substr(std::min(equals + 1, word.size()));
        if (!word.starts_with('-')) corpus.push_back(word);
        return option != given.end() || !word.starts_with('-');
    }

    [[nodiscard]] double number(const std::string& name, double otherwise) const {
        return given.at(name).empty() ? otherwise : std::stod(given.at(name));
    }

    /// As with libFuzzer, files that are given alone are run and no more.
    [[nodiscard]] bool mutate() const {
        const auto is_folder = [](const std::string& part) { return std::filesystem::is_directory(part); };
        return corpus.empty() || std::ranges::any_of(corpus, is_folder) || !given.at("-runs").empty() ||
               !given.at("-max_total_time").empty();
    }
};

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

void fuzz_all(const Options& options) {
    constexpr double endless = std::numeric_limits<double>::infinity();
    const drape::Stopwatch watch;
    const auto timeout = static_cast<unsigned>(options.number("-timeout", 20));  // s, for one input
    const std::string prefix = options.given.at("-artifact_prefix"), dictionary = options.given.at("-dict");
    std::vector<std::string> seeds;
    for (const auto& file : files_of(options.corpus)) {
        kept_name = prefix + file.filename().string() + ".crash";
        seeds.push_back(whole(file));
        run(seeds.back(), timeout);
    }
    const auto seed = static_cast<unsigned long>(options.number("-seed", 1));
    kept_name = prefix + "crash-seed-" + std::to_string(seed);
    long long done = static_cast<long long>(seeds.size());
    if (seeds.empty()) seeds.emplace_back();
    std::vector<std::string> words;
    if (!dictionary.empty()) words = dictionary_words(whole(dictionary));
    Mutation mutation(std::move(seeds), std::move(words), seed,
                      static_cast<std::size_t>(options.number("-max_len", 4096)));
    const double runs = options.mutate() ? options.number("-runs", endless) : 0;
    const double seconds = options.number("-max_total_time", endless);
    for (; static_cast<double>(done) < runs && watch.seconds() < seconds; ++done) run(mutation.next(), timeout);
    alarm(0);
    std::cerr << "Done " << done << " runs in " << static_cast<long long>(watch.seconds()) << " second(s)\n";
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    for (int a = 1; a < argc; ++a) {
        if (options.take(argv[a])) continue;
        std::cerr << "unknown option " << argv[a] << "\n";
        return 2;
    }
    watch_for_death();
    fuzz_all(options);
}
