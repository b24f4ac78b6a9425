// window_fuzz [--events N] [--seed K] [--folder DIR]: sends random keys, buttons, drags, turns of the wheel, choices of
// the menu and of the settings panel, typed values, sizes and minimisations to `drape --check` on a desktop of its own,
// in batches. After each batch it must answer a key; in the end its recording must replay to the bits that it had.

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>

#include "app/desktop.h"
#include "events.h"
#include "support/process.h"

namespace drape::window_fuzz {
namespace {

namespace fs = std::filesystem;
using test::Process;

constexpr int most_at_once = 60;       // events in one run of xdotool
constexpr int events_a_window = 2000;  // then it is closed and its recording replayed
constexpr double patience = 120;       // s, for an answer on a machine that is busy

class Fuzzer {
public:
    Fuzzer(fs::path folder, unsigned long seed) : folder_(std::move(folder)), desktop_(folder_), source_(seed) {}

    /// One window from its start to its end. @return events that were sent
    int session(int most);

    [[nodiscard]] int sessions() const { return sessions_; }
    [[nodiscard]] int failed() const { return failed_; }

private:
    void send(const std::string& lines);
    int send_batch(int most);
    [[nodiscard]] int answers() const;
    [[nodiscard]] bool responds();
    void check_end();
    void fail(const std::string& what);

    fs::path folder_;
    test::Desktop desktop_;
    EventSource source_;
    std::optional<Process> drape_;
    std::string window_;
    int sessions_ = 0, failed_ = 0;
};

void Fuzzer::send(const std::string& lines) {
    std::ofstream(folder_ / "batch.txt") << lines;
    desktop_.act({(folder_ / "batch.txt").string()});
}

/// @return events that were sent
int Fuzzer::send_batch(int most) {
    const int events = std::min(1 + source_.below(most_at_once), most);
    std::string lines;
    int left = events;
    if (source_.below(3) == 0) {
        const int x = source_.below(640), y = source_.below(480);
        desktop_.move_to(x, y);
        desktop_.click(3);
        if (!test::eventually([&] { return desktop_.visible_windows() > 1; })) fail("the menu does not come");
        lines += source_.menu_walk(x, y);
        --left;
    }
    for (; left > 0; --left) lines += source_.event(window_);
    send(lines + EventSource::all_quiet(window_));
    // Somewhere beside a menu that is still open
    int turn = 0;  // not by chance: how many it takes is no matter of the seed
    const bool alone = test::eventually([&] {
        if (desktop_.visible_windows() <= 1) return true;
        ++turn;
        desktop_.move_to(97 * turn % 640, 61 * turn % 480);
        desktop_.click(1);
        return false;
    });
    if (!alone) fail("the menu stays");
    return events;
}

// What the key C has been seen to do so far
int Fuzzer::answers() const {
    std::istringstream lines(test::read_file(folder_ / "session.txt.unfinished"));
    int count = 0;
    for (std::string line; std::getline(lines, line);) count += line.ends_with(" next view.contacts") ? 1 : 0;
    return count;
}

/// Whether the window still does what a key says.
bool Fuzzer::responds() {
    const int before = answers();
    double waited = 0;
    constexpr double turn = 5;  // s
    for (; waited < patience && drape_->running(); waited += turn) {
        desktop_.key("c");
        // Fewer where the key's command came after another one that went on from an earlier step
        if (test::eventually([&] { return answers() != before || !drape_->running(); }, turn)) break;
    }
    return answers() != before;
}

void Fuzzer::fail(const std::string& what) {
    ++failed_;
    const fs::path kept = folder_ / ("failed-" + std::to_string(failed_));
    fs::create_directories(kept);
    for (const char* name : {"session.txt", "session.txt.unfinished", "batch.txt", "stderr.txt", "stdout.txt"}) {
        std::error_code ignored;
        fs::copy_file(folder_ / name, kept / name, fs::copy_options::overwrite_existing, ignored);
    }
    std::cout << "FAILED: " << what << "; see " << kept.string() << std::endl;
}

void Fuzzer::check_end() {
    const int code = drape_->wait(patience).value_or(-1);
    // The menu and the panel have a policy that ends a run which diverges
    const bool may_stop = test::read_file(folder_ / "session.txt").find("on_unstable=stop") != std::string::npos;
    if (code == 1 && may_stop && drape_->standard_error().find("iverged") != std::string::npos) return;
    if (code != 0) return fail("the window ended with " + std::to_string(code));
    const std::string hash = drape_->standard_output();
    fs::create_directories(folder_ / "replay");
    Process lab({std::string(DRAPE_PROGRAMS) + "/drape-lab", "simulate", "--replay", (folder_ / "session.txt").string(),
                 "--hash"},
                {}, folder_ / "replay");
    lab.wait(600);
    if (lab.standard_output() != hash) fail("the replay has another hash: " + lab.standard_error());
}

int Fuzzer::session(int most) {
    ++sessions_;
    std::error_code ignored;
    fs::remove(folder_ / "session.txt", ignored);
    drape_.emplace(std::vector<std::string>{std::string(DRAPE_PROGRAMS) + "/drape", "hang", "--check", "--record",
                                            "session.txt", "--hash", "--size", "640x480"},
                   std::map<std::string, std::string>{{"DISPLAY", desktop_.display()}}, folder_);
    window_ = desktop_.find_window();
    if (window_.empty()) return fail("the window did not come"), most;
    int sent = 0;
    while (sent < std::min(most, events_a_window)) {
        sent += send_batch(most - sent);
        if (responds()) continue;
        // The menu has an entry that quits
        if (drape_->running()) fail("the window does not respond");
        break;
    }
    if (drape_->running()) desktop_.key("q");
    check_end();
    drape_.reset();
    return sent;
}

int run(int argc, char** argv) {
    int wanted = 500;
    unsigned long seed = 1;
    fs::path folder = fs::temp_directory_path() / ("drape-window-fuzz-" + std::to_string(getpid()));
    for (int a = 1; a + 1 < argc; a += 2) {
        const std::string name = argv[a];
        if (name == "--events") wanted = std::stoi(argv[a + 1]);
        if (name == "--seed") seed = std::stoul(argv[a + 1]);
        if (name == "--folder") folder = argv[a + 1];
    }
    std::printf("seed %lu\n", seed);
    int sent = 0, sessions = 0, failed = 0;
    {
        Fuzzer fuzzer(folder, seed);
        while (sent < wanted) sent += fuzzer.session(wanted - sent);
        sessions = fuzzer.sessions(), failed = fuzzer.failed();
    }
    std::printf("%d events in %d windows, %d failed\nresult,window events,%d,%d\n", sent, sessions, failed, sent,
                failed);
    if (failed == 0) fs::remove_all(folder);
    return failed > 0 ? 1 : 0;
}

}  // namespace
}  // namespace drape::window_fuzz

int main(int argc, char** argv) { return drape::window_fuzz::run(argc, argv); }
