// window_fuzz [--events N] [--seed K] [--folder DIR]: sends random keys, buttons, drags, turns of the wheel, choices of
// the menu and of the settings panel, typed values, sizes and minimisations to `drape --check` on a desktop of its own,
// in batches. After each batch it must answer a key; in the end its recording must replay to the bits that it had.

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <sstream>

#include "app/desktop.h"
#include "support/process.h"

namespace drape::window_fuzz {
namespace {

namespace fs = std::filesystem;
using test::Process;

constexpr int most_at_once = 400;      // events in one run of xdotool
constexpr int events_a_window = 2000;  // then it is closed and its recording replayed
constexpr double patience = 120;       // s, for an answer on a machine that is busy

/// Keys that `drape` knows and some that it does not; none that quits.
constexpr const char* keys[] = {"space",   "p",        "o",      "period", "shift+o", "r",           "shift+r",
                                "1",       "2",        "3",      "4",      "5",       "6",           "7",
                                "8",       "9",        "i",      "t",      "y",       "u",           "j",
                                "b",       "c",        "l",      "n",      "Tab",     "m",           "k",
                                "shift+k", "f",        "Left",   "a",      "Right",   "d",           "Up",
                                "w",       "Down",     "s",      "Prior",  "e",       "Next",        "q",
                                "x",       "z",        "g",      "minus",  "equal",   "plus",        "v",
                                "h",       "F1",       "F2",     "F5",     "F12",     "bracketleft", "bracketright",
                                "comma",   "question", "ctrl+a", "alt+b",  "Return",  "BackSpace",   "shift+f",
                                "ctrl+r",  "ctrl+z",   "ctrl+y", "ctrl+s", "slash",   "F11"};

/// What may be typed into a field.
constexpr const char* typed[] = {"0", "1", "2", "5", "9", "period", "minus", "e", "x", "BackSpace"};

constexpr const char* modifiers[] = {"", "", "shift", "ctrl"};

// A word of xdotool's with a number, as a line
std::string with(const char* word, int number) { return std::string(word) + " " + std::to_string(number) + "\n"; }

std::string pointer_to(const std::string& place) { return "mousemove " + place + "\n"; }

/// Random things that a user may do to a window of 640 x 480 at the upper left of the screen, in xdotool's language.
class EventSource {
public:
    explicit EventSource(unsigned long seed) : random_(seed) {}

    /// One of them, in a few lines. None quits by key; the menu may.
    std::string event(const std::string& window);

    /// The pointer on a menu that is open at a place: over its entries and those of its submenus, and a click.
    std::string menu_walk(int x, int y);

    /// Lets go of every key and button.
    static std::string all_released();

    /// That, and shows the window at its size, and leaves menus, lists and fields.
    static std::string all_quiet(const std::string& window);

    int below(int bound) { return static_cast<int>(random_() % static_cast<unsigned>(bound)); }

private:
    std::string anywhere();
    std::string on_the_panel();
    std::string key();
    std::string drag();
    std::string drag_on_the_panel();
    std::string typed_value();
    std::string size_or_visibility(const std::string& window);

    std::mt19937_64 random_;
};

// A little beside the window, too
std::string EventSource::anywhere() { return std::to_string(below(660)) + " " + std::to_string(below(500)); }

std::string EventSource::on_the_panel() { return std::to_string(330 + below(300)) + " " + std::to_string(below(480)); }

std::string EventSource::key() { return keys[below(std::size(keys))]; }

std::string EventSource::drag() {
    const std::string held = modifiers[below(std::size(modifiers))];
    const int button = 1 + below(2);
    std::string lines = held.empty() ? "" : "keydown " + held + "\n";
    lines += pointer_to(anywhere()) + with("mousedown", button);
    for (int moves = below(4); moves >= 0; --moves) lines += pointer_to(anywhere());
    lines += with("mouseup", button);
    return held.empty() ? lines : lines + "keyup " + held + "\n";
}

std::string EventSource::drag_on_the_panel() {
    std::string lines = pointer_to(on_the_panel()) + with("mousedown", 1);
    for (int moves = below(4); moves >= 0; --moves) lines += pointer_to(on_the_panel());
    return lines + with("mouseup", 1);
}

std::string EventSource::typed_value() {
    std::string lines = "keydown ctrl\n" + pointer_to(on_the_panel()) + "click 1\nkeyup ctrl\n";
    for (int keys_left = below(6); keys_left >= 0; --keys_left) {
        lines += std::string("key --delay 0 ") + typed[below(std::size(typed))] + "\n";
    }
    return lines + (below(2) == 0 ? "key --delay 0 Return\n" : "");
}

std::string EventSource::size_or_visibility(const std::string& window) {
    if (below(4) == 0) return "windowunmap " + window + "\nwindowmap " + window + "\n";
    return "windowsize " + window + " " + std::to_string(1 + below(700)) + " " + std::to_string(1 + below(500)) + "\n";
}

std::string EventSource::event(const std::string& window) {
    const std::string drags = drag(), slides = drag_on_the_panel();
    const std::string events[] = {pointer_to(anywhere()),
                                  with("mousedown", 1 + below(3)),
                                  with("mouseup", 1 + below(3)),
                                  with("click", 4 + below(2)),
                                  with("click", 1 + below(3)),
                                  below(4) == 0 ? size_or_visibility(window) : pointer_to(on_the_panel()),
                                  drags,
                                  drags,
                                  slides,
                                  slides,
                                  typed_value(),
                                  pointer_to(on_the_panel()) + with("click", below(3) == 0 ? 5 : 1),
                                  "keydown " + key() + "\n",
                                  "keyup " + key() + "\n"};
    const auto chosen = static_cast<std::size_t>(below(20));
    return chosen < std::size(events) ? events[chosen] : "key --delay 0 " + key() + "\n";
}

std::string EventSource::menu_walk(int x, int y) {
    constexpr int width = 400, height = 600;  // [pixel] of a menu with a submenu
    std::string lines;
    for (int moves = 1 + below(4); moves >= 0; --moves) {
        lines += pointer_to(std::to_string(x + 5 + below(width)) + " " + std::to_string(y + 5 + below(height)));
    }
    return lines + "click 1\n";
}

std::string EventSource::all_released() {
    std::string lines;
    for (const char* name : keys) lines += std::string("keyup --delay 0 ") + name + "\n";
    for (const char* name : typed) lines += std::string("keyup --delay 0 ") + name + "\n";
    for (int button = 1; button <= 3; ++button) lines += with("mouseup", button);
    return lines;
}

std::string EventSource::all_quiet(const std::string& window) {
    std::string lines = all_released() + "windowmap " + window + "\nwindowsize " + window + " 640 480\n";
    // A click beside the window closes a menu, one beside the panel what is open there
    lines += pointer_to("1200 1000") + "click 1\nwindowfocus " + window + "\n" + pointer_to("20 470") + "click 1\n";
    return lines;
}

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
    [[nodiscard]] bool quits() const;
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
        // freeglut opens no menu at the window's first column and row
        const int x = 1 + source_.below(639), y = 1 + source_.below(479);
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
    const bool answered = answers() != before;
    return answered && !quits();
}

/// Whether its recording is closed, as at its end, which may take as long as that of a video.
bool Fuzzer::quits() const { return !fs::exists(folder_ / "session.txt.unfinished"); }

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
    // xdotool stops at a window that has quit, and leaves held what the rest of its batch would release. The X server
    // ignores a press of a button that is held: the first right click in the next window would open no menu.
    send(EventSource::all_released());
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
        if (!quits() && drape_->running()) fail("the window does not respond");
        break;
    }
    if (drape_->running()) desktop_.key("ctrl+q");
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
