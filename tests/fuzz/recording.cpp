// A recording: read, written, read again, and its commands carried out.

#include "drape/session/recording.h"

#include <sstream>
#include <utility>

#include "drape/scene/setting_table.h"
#include "fuzz/small_run.h"
#include "fuzz/target.h"
#include "support/scratch_folder.h"

using namespace drape;

namespace {

bool same_entry(const RecordedEntry& one, const RecordedEntry& other) {
    if (one.step != other.step || one.content.index() != other.content.index()) return false;
    if (const auto* hash = std::get_if<std::uint64_t>(&one.content)) {
        return *hash == std::get<std::uint64_t>(other.content);
    }
    return command_text(std::get<Command>(one.content)) == command_text(std::get<Command>(other.content));
}

bool same(const Recording& one, const Recording& other) {
    return one.scene == other.scene && one.assignments == other.assignments &&
           std::equal(one.entries.begin(), one.entries.end(), other.entries.begin(), other.entries.end(), same_entry);
}

void check_written(const Recording& recording) {
    static const ScratchFolder folder;
    const std::string file = folder.path() / "recording.txt";
    const std::int64_t last = recording.entries.empty() ? 0 : recording.entries.back().step;
    Recorder recorder(file, recording.scene, recording.assignments);
    for (const RecordedEntry& entry : recording.entries) {
        if (const auto* hash = std::get_if<std::uint64_t>(&entry.content)) {
            recorder.write_hash(entry.step, *hash);
        } else {
            recorder.write(entry.step, std::get<Command>(entry.content));
        }
    }
    recorder.close(last);
    const Recording again = read_recording(file);
    fuzz::require(again.notice.empty() && again.last_step == last, "a recording that was closed is whole");
    fuzz::require(same(recording, again), "a recording that was written reads the same");
}

/// Whether a command leads to something that a fuzzer can afford: no other scene, no large cloth.
bool affordable(const Command& command, const Settings& now) {
    if (std::holds_alternative<command::LoadScene>(command)) return false;
    const auto* set = std::get_if<command::Set>(&command);
    if (set == nullptr) return true;
    Settings then = now;
    if (!fuzz::accepts([&] { assign(then, set->assignment); })) return true;
    const auto small = fuzz::made_small(then);
    return small && fuzz::same_settings(*small, then);
}

void play(const Recording& recording) {
    constexpr std::size_t most_commands = 30;
    Settings settings;
    settings.cloths.front().particles = {5, 4};
    settings.balls.emplace_back();
    settings.solver.threads = 1;
    Simulation simulation("fuzz.toml", settings);
    std::size_t played = 0;
    for (const RecordedEntry& entry : recording.entries) {
        const auto* command = std::get_if<Command>(&entry.content);
        if (command == nullptr || !affordable(*command, simulation.settings())) continue;
        fuzz::accepts([&] { simulation.apply(*command); });
        fuzz::step_a_little(simulation);
        if (++played == most_commands) return;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in{std::string(fuzz::text_of(data, size))};
    std::optional<Recording> recording;
    if (!fuzz::accepts([&] { recording = read_recording(in, "fuzz.txt"); })) return 0;
    std::int64_t last = 0;
    for (const RecordedEntry& entry : recording->entries) {
        fuzz::require(entry.step >= std::exchange(last, entry.step), "the steps of a recording do not go back");
    }
    check_written(*recording);
    play(*recording);
    return 0;
}
