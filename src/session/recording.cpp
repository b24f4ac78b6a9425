#include "drape/session/recording.h"

#include <algorithm>
#include <charconv>

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"
#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

constexpr std::string_view first_line = "drape-recording 1";
constexpr std::uintmax_t largest_recording = 128 << 20;
constexpr long long last_possible_step = 1'000'000'000;
constexpr std::size_t longest_recorded_line = 1 << 20;  // a list of pins or a path may be long

std::optional<std::uint64_t> parse_hash(std::string_view text) {
    std::uint64_t hash = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
    if (text.size() != 16 || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return hash;
}

/// Takes in what one line says. @throws InputError if it says nothing that a recording can
void read_entry(const std::string& line, int number, Recording& recording) {
    const std::size_t blank = line.find(' ');
    const auto step = parse_integer(std::string_view(line).substr(0, blank));
    if (blank == std::string::npos || !step || *step < 0 || *step > last_possible_step) {
        throw InputError("expected 'STEP COMMAND' with 0 <= STEP <= " + std::to_string(last_possible_step));
    }
    if (!recording.entries.empty() && *step < recording.entries.back().step) throw InputError("steps must not go back");
    const std::string text = line.substr(blank + 1);
    if (text == "end") {
        recording.last_step = *step;
    } else if (text.starts_with("hash ")) {
        const auto hash = parse_hash(std::string_view(text).substr(5));
        if (!hash) throw InputError("expected 'hash' and 16 hexadecimal digits");
        recording.entries.push_back({*step, *hash, number});
    } else {
        recording.entries.push_back({*step, parse_command(text), number});
    }
}

}  // namespace

Recording read_recording(const std::string& file) {
    InputFile in(file, largest_recording);
    return read_recording(in, file);
}

Recording read_recording(std::istream& in, const std::string& file) {
    std::string line;
    if (read_line(in, line, longest_recorded_line) != LineEnd::Whole || line != first_line) {
        throw InputError(file + ":1: no recording: expected '" + std::string(first_line) + "'");
    }
    Recording recording;
    if (read_line(in, line, longest_recorded_line) != LineEnd::Whole || !line.starts_with("scene ") ||
        line.size() == 6) {
        throw InputError(file + ":2: expected 'scene NAME'");
    }
    recording.scene = line.substr(6);
    recording.file = file;

    // A line without its end was cut off while it was written
    for (int number = Recording::first_assignment;; ++number) {
        const auto cut = [&](const std::string& why) {
            recording.notice =
                one_line(file + ":" + std::to_string(number) + ": " + why + "; played up to the line before");
            return recording;
        };
        const LineEnd end = read_line(in, line, longest_recorded_line);
        if (end == LineEnd::None) return cut("the recording ends without its 'end'");
        if (end == LineEnd::CutOff) return cut("cut off in mid-line");
        if (end == LineEnd::TooLong) return cut("the line is too long");
        if (line.starts_with("set ") && recording.entries.empty()) {
            recording.assignments.push_back(line.substr(4));
            continue;
        }
        try {
            read_entry(line, number, recording);
            if (recording.last_step) return recording;
        } catch (const InputError& error) {
            return cut(error.what());
        }
    }
}

void load_scene_first(Recording& recording) {
    std::vector<RecordedEntry> first{{0, command::LoadScene{recording.scene}, Recording::first_assignment - 1}};
    Simulation probe(recording.scene, load_scene(recording.scene));
    std::vector<std::string> left = recording.assignments;
    std::string refusal;
    const auto is_taken = [&](const std::string& assignment) {
        try {
            probe.apply(command::Set{assignment});
        } catch (const InputError& error) {
            refusal = error.what();
            return false;
        }
        first.push_back({0, command::Set{assignment}, first.back().line + 1});
        return true;
    };
    // One that another has to come before is refused until then
    while (!left.empty()) {
        if (std::erase_if(left, is_taken) == 0) throw InputError(recording.file + ": " + refusal);
    }
    first.push_back({0, command::Reset{}, first.back().line});
    recording.entries.insert(recording.entries.begin(), first.begin(), first.end());
}

std::vector<std::string> recordings_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    std::error_code refused;
    std::string line;
    for (std::filesystem::directory_iterator file(folder, refused), end; file != end; file.increment(refused)) {
        if (!file->is_regular_file(refused)) continue;
        try {
            InputFile in(file->path().string(), largest_recording, InputKind::Regular);
            const bool begins = read_line(in, line, first_line.size()) == LineEnd::Whole && line == first_line;
            if (begins) names.push_back(file->path().filename().string());
        } catch (const InputError&) {
            continue;
        }
    }
    std::ranges::sort(names);
    return names;
}

Recorder::Recorder(const std::string& file, const std::string& scene, const std::vector<std::string>& assignments)
    : file_(file, OutputFile::LeftOver::Keep) {
    begin(scene, assignments);
    file_.stream() << text_;
    file_.flush();
}

void Recorder::begin(const std::string& scene, const std::vector<std::string>& assignments) {
    text_ = std::string(first_line) + "\nscene " + scene + '\n';
    for (const std::string& assignment : assignments) text_ += "set " + assignment + '\n';
    lines_.clear();
}

void Recorder::add(std::int64_t step, const std::string& what) {
    lines_.push_back({step, text_.size(), paused_});
    const std::string line = std::to_string(step - first_step_) + ' ' + what;
    text_ += line + '\n';
    file_.stream() << line << std::endl;
}

void Recorder::begin_step(std::int64_t step) {
    if (paused_ && granted_ == 0) write(step, command::Pause{});
    granted_ = std::max<std::int64_t>(granted_ - 1, 0);
}

bool Recorder::cut_after(std::int64_t step) {
    const auto later = std::ranges::upper_bound(lines_, step, {}, &Line::step);
    if (later != lines_.end()) {
        if (file_.wanted() && !file_.cut_at(static_cast<std::int64_t>(later->begin))) return false;
        paused_ = later->paused;
        text_.resize(later->begin);
        lines_.erase(later, lines_.end());
    }
    granted_ = 0;
    return true;
}

void Recorder::write(std::int64_t step, const Command& command) {
    const auto* scene = std::get_if<command::LoadScene>(&command);
    if (scene != nullptr && !file_.wanted()) {
        begin(scene->name, {});
        first_step_ = step;
        if (paused_) add(step, command_text(command::Pause{}));
        return;
    }
    add(step, command_text(command));
    const auto* steps = std::get_if<command::Step>(&command);
    if (std::holds_alternative<command::Pause>(command)) paused_ = !paused_, granted_ = 0;
    if (steps != nullptr) paused_ = true, granted_ = steps->count;
}

void Recorder::write_hash(std::int64_t step, std::uint64_t hash) { add(step, "hash " + hash_text(hash)); }

bool Recorder::save(const std::filesystem::path& file, std::int64_t step) const {
    OutputFile out(file.string());
    out.stream() << text_ << step - first_step_ << " end\n";
    return out.close_if_free();
}

void Recorder::close(std::int64_t step) {
    file_.stream() << step << " end\n";
    file_.close();
}

}  // namespace drape
