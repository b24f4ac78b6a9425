#pragma once

#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace drape::faults {

/// What a program did that something was done to.
struct Outcome {
    int code = -1;  ///< exit code; 256 + the signal that ended it, -1 if it did not end in time
    std::string out, err;
};

/// A place and the means to try programs in, and the count of what was tried there.
class Trial {
public:
    /// @param folder of this trial's own
    Trial(std::filesystem::path folder, unsigned long seed);

    /// Runs a line of shell to its end, in the folder; `$CAPTURE` and `$LAB` are our programs.
    Outcome run(const std::string& line) const;

    /// Runs a single command that is killed by SIGKILL after some time [s]; what it has started goes on.
    Outcome run_and_kill(const std::string& line, double seconds) const;

    /// Counts one thing that was tried; tells it if it failed.
    /// @return `holds`
    bool check(bool holds, const std::string& what, const Outcome& outcome = {});

    /// Says why some of it could not be tried here.
    void skip(const std::string& why);

    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }
    [[nodiscard]] std::string text(const std::string& name) const;
    void remove(const std::string& name) const;

    /// Between 0 and 1.
    double random();

    [[nodiscard]] int tried() const { return tried_; }
    [[nodiscard]] int failed() const { return failed_; }

private:
    std::filesystem::path folder_;
    std::mt19937_64 random_;
    int tried_ = 0, failed_ = 0;
};

/// Whether a program ended by itself, and with a message unless it succeeded.
bool ended_cleanly(const Outcome& outcome);

/// A kind of fault, and how often it is tried in the tests.
struct Fault {
    std::string name, help;
    int quick;
    std::function<void(Trial& trial, int count)> run;
};

void kill_capture(Trial& trial, int count);
void kill_experiments(Trial& trial, int count);
void fill_disk(Trial& trial, int count);
void write_where_nobody_may(Trial& trial, int count);
void close_streams(Trial& trial, int count);
void withhold_memory(Trial& trial, int count);
void withhold_threads(Trial& trial, int count);
void change_locale(Trial& trial, int count);

}  // namespace drape::faults
