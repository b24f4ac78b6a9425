// window_fuzz [--events N] [--seed K] [--folder DIR]: sends random keys, buttons, drags, turns of the wheel, choices of
// the menu, sizes and minimisations to `drape` on a desktop of its own, in batches. After each batch it must answer a
// key; in the end its recording must replay to the bits that it had.

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <optional>
#include <random>
#include <sstream>

#include "app/desktop.h"
#include "support/process.h"

namespace drape::window_fuzz {
namespace {

namespace fs = std::filesystem;
using test::Process;

constexpr int batch = 100;             // events in one run of xdotool
constexpr int batches_a_session = 20;  // then the window is closed and its recording replayed
constexpr double patience = 120;       // s, for an answer on a machine that is busy

/// Keys that `drape` knows and some that it does not; none that quits.
constexpr const char* keys[] = {"space",       "p",
                                "o",           "period",
                                "shift+o",     "1",
                                "2",           "3",
                                "4",           "5",
                                "6",           "7",
                                "8",           "9",
                                "i",           "t",
                                "y",           "u",
                                "b",           "c",
                                "l",           "n",
                                "Tab",         "k",
                                "f",           "Left",
                                "a",           "Right",
                                "d",           "Up",
                                "w",           "Down",
                                "s",           "Prior",
                                "e",           "Next",
                                "h",           "v",
                                "question",    "F1",
                                "x",           "ctrl+a",
                                "alt+b",       "z",
                                "bracketleft", "bracketright",
                                "Return",      "F5"};

class Fuzzer {
public:
    Fuzzer(fs::path folder, unsigned long seed) : folder_(std::move(folder)), desktop_(folder_), random_(seed) {}

    /// One window from its start to its end. @return events that were sent
    int session(int most);

    [[nodiscard]] int sessions() const { return sessions_; }
    [[nodiscard]] int failed() const { return failed_; }

private:
    int below(int bound) { return static_cast<int>(random_() % static_cast<unsigned>(bound)); }
    std::string place() { return std::to_string(below(660)) + " " + std::to_string(below(500)); }
    std::string event();
    void send_batch(int events);
    [[nodiscard]] int resets() const;
    [[nodiscard]] bool answers();
    void check_end();
    void fail(const std::string& what);

    fs::path folder_;
    test::Desktop desktop_;
    std::mt19937_64 random_;
    std::optional<Process> drape_;
    std::string window_;
    int sessions_ = 0, failed_ = 0;
};

/// One or a few words of xdotool's language, a line each.
std::string Fuzzer::event() {
    switch (below(16)) {
        case 0:
        case 1:
        case 2:
            return "mousemove " + place() + "\n";
        case 3:
            return "mousedown " + std::to_string(1 + below(3)) + "\n";
        case 4:
            return "mouseup " + std::to_string(1 + below(3)) + "\n";
        case 5:
            return "click " + std::to_string(4 + below(2)) + "\n";
        case 6:
            return "click " + std::to_string(1 + below(3)) + "\n";
        case 7:
            return below(4) > 0 ? "mousemove " + place() + "\n"
                                : "windowsize " + window_ + " " + std::to_string(1 + below(700)) + " " +
                                      std::to_string(1 + below(500)) + "\n";
        case 8:
            return below(20) > 0 ? "mousemove " + place() + "\n"
                                 : "windowunmap " + window_ + "\nwindowmap " + window_ + "\n";
        case 9:
            return std::string("keydown ") + keys[below(std::size(keys))] + "\n";
        case 10:
            return std::string("keyup ") + keys[below(std::size(keys))] + "\n";
        default:
            return std::string("key --delay 0 ") + keys[below(std::size(keys))] + "\n";
    }
}

void Fuzzer::send_batch(int events) {
    std::string script;
    for (int e = 0; e < events; ++e) script += event();
    // Everything is let go, and a menu that is open is closed
    for (const char* key : keys) script += std::string("keyup ") + key + "\n";
    for (int button = 1; button <= 3; ++button) script += "mouseup " + std::to_string(button) + "\n";
    script += "windowmap " + window_ + "\nwindowsize " + window_ + " 640 480\nmousemove 1200 1000\nclick 1\n";
    script += "mousemove 20 20\nwindowfocus " + window_ + "\n";
    std::ofstream(folder_ / "batch.txt") << script;
    desktop_.act({(folder_ / "batch.txt").string()});
}

int Fuzzer::resets() const {
    std::istringstream lines(test::read_file(folder_ / "session.txt.unfinished"));
    int count = 0;
    for (std::string line; std::getline(lines, line);) count += line.ends_with(" reset") ? 1 : 0;
    return count;
}

/// Whether the window still does what a key says.
bool Fuzzer::answers() {
    const int before = resets();
    double waited = 0;
    constexpr double turn = 1;  // s
    for (; waited < patience && drape_->running(); waited += turn) {
        desktop_.key("r");
        if (test::eventually([&] { return resets() > before || !drape_->running(); }, turn)) break;
    }
    return resets() > before;
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
    drape_.emplace(std::vector<std::string>{std::string(DRAPE_PROGRAMS) + "/drape", "hang", "--record", "session.txt",
                                            "--hash", "--size", "640x480"},
                   std::map<std::string, std::string>{{"DISPLAY", desktop_.display()}}, folder_);
    window_ = desktop_.find_window();
    if (window_.empty()) return fail("the window did not come"), most;
    int sent = 0;
    for (int b = 0; b < batches_a_session && sent < most; ++b) {
        const int events = std::min(batch, most - sent);
        send_batch(events);
        sent += events;
        if (answers()) continue;
        // The menu has an entry that quits
        if (drape_->running()) fail("the window does not answer");
        break;
    }
    if (drape_->running()) desktop_.key("Escape");
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
