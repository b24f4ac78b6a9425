// Output that cannot be written: disk full, files cut by a limit, folders that take nothing, streams that are closed.

#include <algorithm>
#include <array>
#include <regex>

#include "faults/fault.h"
#include "support/process.h"

namespace drape::faults {
namespace {

namespace fs = std::filesystem;

/// Commands that write, each into files of the folder $OUT.
constexpr std::array writers{
    "$CAPTURE drop --frames 6 --size 160x90 --out $OUT/frames",
    "$CAPTURE drop --frames 3 --size 160x90 --stats $OUT/stats.csv --state $OUT/state.csv",
    "$LAB simulate drop --time 0,0.01,0.02,0.03 --state $OUT/state.csv --stats $OUT/stats.csv",
    "env PATH=/nonexistent $LAB stability --quick --cases 1-3 --out $OUT/table",
};

bool has_end(const std::string& png) { return png.size() > 12 && png.substr(png.size() - 8, 4) == "IEND"; }

bool frames_are_whole(const fs::path& folder) {
    if (!fs::is_directory(folder)) return true;
    return std::ranges::all_of(fs::directory_iterator(folder), [](const fs::directory_entry& entry) {
        const std::string name = entry.path().filename().string();
        return !name.starts_with("frame_") || has_end(test::read_file(entry.path()));
    });
}

/// Whether this user may make a file system of its own to fill.
bool may_mount(const Trial& trial) {
    return trial.run("mkdir -p disk && unshare -m mount -t tmpfs -o size=64k full disk").code == 0;
}

void fill_disk_between_frames(Trial& trial, int count) {
    for (int k = 0; k < count; ++k) {
        // More than the file by which the program tries its folder, and less than all frames
        const int size = 260 + static_cast<int>(trial.random() * 400);  // KiB
        const Outcome outcome =
            trial.run("exec unshare -m bash -c 'mount -t tmpfs -o size=" + std::to_string(size) +
                      "k full disk; $CAPTURE drop --frames 300 --size 160x90 --out disk/frames; code=$?; mkdir -p "
                      "kept; cp -r disk/. kept; exit $code'");
        const std::regex told(
            "(?:[0-9]+ of [0-9]+ pictures, about [^\n]* left\n)*drape-capture: disk/frames/frame_[0-9]+\\.png: "
            "[^\n]*No space left on "
            "device; the last good frame is disk/(frames/frame_[0-9]+\\.png)\n");
        std::smatch found;
        const bool names_frames = std::regex_match(outcome.err, found, told);
        trial.check(outcome.code == 1 && names_frames,
                    "a disk of " + std::to_string(size) + " KiB, full after some frames", outcome);
        trial.check(frames_are_whole(trial.path("kept/frames")), "every frame is whole", outcome);
        trial.check(names_frames && fs::exists(trial.path("kept") / found[1].str()), "the last good frame is there",
                    outcome);
        trial.remove("kept");
    }
}

}  // namespace

void fill_disk(Trial& trial, int count) {
    const auto check = [&trial](const Outcome& outcome, const std::string& what, const std::string& folder) {
        trial.check(ended_cleanly(outcome), what, outcome);
        trial.check(frames_are_whole(trial.path(folder + "/frames")), "every frame is whole", outcome);
        trial.remove(folder);
    };
    for (int k = 0; k < count; ++k) {
        const std::string writer = writers[static_cast<std::size_t>(k) % writers.size()];
        const int blocks =
            1 + static_cast<int>(trial.random() * 40);  // of 1024 bytes, a file; messages go into one too
        trial.run("mkdir -p limited");
        const Outcome outcome = trial.run("ulimit -f " + std::to_string(blocks) + "; OUT=limited; exec " + writer +
                                          " 2>&1 >/dev/null | cat >&2; exit ${PIPESTATUS[0]}");
        check(outcome, "files of at most " + std::to_string(blocks) + " KiB: " + writer, "limited");
    }
    for (const std::string option : {"--state", "--stats"}) {
        const Outcome outcome = trial.run("exec $LAB simulate drop --time 0.01 " + option + " /dev/full");
        trial.check(outcome.code == 1 && !outcome.err.empty(), option + " on a full device", outcome);
    }
    if (!may_mount(trial)) return trial.skip("a full disk: needs the right to mount one");
    for (int k = 0; k < count; ++k) {
        const std::string writer = writers[static_cast<std::size_t>(k) % writers.size()];
        const int size = 4 * (1 + static_cast<int>(trial.random() * 30));  // KiB
        const Outcome outcome =
            trial.run("exec unshare -m bash -c 'mount -t tmpfs -o size=" + std::to_string(size) +
                      "k full disk; OUT=disk; " + writer + "; code=$?; mkdir -p kept; cp -r disk/. kept; exit $code'");
        check(outcome, "a disk of " + std::to_string(size) + " KiB: " + writer, "kept");
    }
    fill_disk_between_frames(trial, (count + 1) / 2);
}

void write_where_nobody_may(Trial& trial, int /*count*/) {
    const bool mounts = may_mount(trial);
    if (!mounts) trial.skip("a read-only disk: needs the right to mount one");
    for (const std::string writer : writers) {
        const auto refused = [](const Outcome& outcome) { return outcome.code == 1 && !outcome.err.empty(); };
        Outcome outcome = trial.run("OUT=/proc; exec " + writer);
        trial.check(refused(outcome), "in /proc: " + writer, outcome);
        outcome = trial.run("touch file; OUT=file; exec " + writer);
        trial.check(refused(outcome), "in a file: " + writer, outcome);
        if (!mounts) continue;
        outcome = trial.run("exec unshare -m bash -c 'mount -t tmpfs -o ro full disk; OUT=disk; " + writer + "'");
        trial.check(refused(outcome), "on a read-only disk: " + writer, outcome);
    }
}

void close_streams(Trial& trial, int /*count*/) {
    trial.run("$LAB simulate drop --time 0.01 --state whole.csv --stats stats_whole.csv");
    trial.run("$CAPTURE drop --frames 2 --size 64x36 --state whole_capture.csv");
    const std::string state = trial.text("whole.csv"), captured = trial.text("whole_capture.csv");
    for (const std::string streams : {">&-", "2>&-", "<&-", ">&- 2>&-", "<&- >&- 2>&-", ">/dev/full", "2>/dev/full"}) {
        // A file that is opened where a standard stream was closed must not take what is meant for the stream
        const Outcome lab =
            trial.run("exec $LAB simulate drop --time 0.01 --state s.csv --stats t.csv --hash " + streams);
        const bool out_lost =
            streams.find(">&-") == 0 || streams == ">/dev/full" || streams.find(" >&-") != std::string::npos;
        trial.check(out_lost ? lab.code == 1 : lab.code == 0, "simulate " + streams, lab);
        trial.check(trial.text("s.csv") == state || trial.text("s.csv").empty(), "the state is clean: " + streams, lab);
        trial.check(trial.text("t.csv").find("steps to") == std::string::npos, "the figures are clean: " + streams,
                    lab);
        const Outcome capture =
            trial.run("exec $CAPTURE drop --frames 2 --size 64x36 --out frames --state s.csv --hash " + streams);
        trial.check(out_lost ? capture.code == 1 : capture.code == 0, "capture " + streams, capture);
        trial.check(trial.text("s.csv") == captured || trial.text("s.csv").empty(),
                    "capture's state is clean: " + streams, capture);
        const Outcome list = trial.run("exec $LAB list settings " + streams);
        trial.check(out_lost ? list.code == 1 : list.code == 0, "list " + streams, list);
        for (const std::string name : {"s.csv", "t.csv", "frames"}) trial.remove(name);
    }
}

}  // namespace drape::faults
