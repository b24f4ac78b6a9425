#include "drape/session/recording.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "support/input_errors.h"
#include "support/process.h"
#include "support/scratch_file.h"
#include "support/scratch_folder.h"

namespace drape {
namespace {

using test::input_error_of;
using test::read_file;
using test::ScratchFile;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* good =
    "drape-recording 1\nscene drop\nset solver.dt=1e-4\nset friction=0.2\n"
    "0 steer 1 0 0\n5 hash 0123456789abcdef\n5 set wind.on=true\n9 orbit 0.1 0.2\n12 end\n";

Recording recording_of(std::string_view text) {
    const ScratchFile file("recording.txt", text);
    return read_recording(file.name());
}

TEST(Recording, LoadsItsSceneWithSettingsInAnOrderThatIsAllowed) {
    const std::string head = "drape-recording 1\nscene drop\nset ball.motion=path\n",
                      path = "ball.path=0,0,1,0,1,0,1,0";
    Recording recording = recording_of(head + "set " + path + "\n0 pause\n");
    load_scene_first(recording);
    std::vector<std::string> texts;
    for (const RecordedEntry& entry : recording.entries)
        texts.push_back(command_text(std::get<Command>(entry.content)));
    EXPECT_THAT(texts, ElementsAre("scene drop", "set " + path, "set ball.motion=path", "reset", "pause"));
    Recording without = recording_of(head + "0 pause\n");
    EXPECT_THAT(input_error_of([&] { load_scene_first(without); }),
                AllOf(HasSubstr("recording.txt"), HasSubstr("path")));
}

TEST(Recording, ReadsWhatARecorderWrote) {
    const ScratchFile file("recording.txt");
    Recorder recorder(file.name(), "drop", {"solver.dt=1e-4", "friction=0.2"});
    recorder.write(0, command::Steer{Vec3(1, 0, 0)});
    recorder.write_hash(5, 0x0123456789abcdef);
    recorder.write(5, command::Set{"wind.on=true"});
    recorder.write(9, command::Orbit{0.1, 0.2});
    recorder.close(12);
    EXPECT_EQ(read_file(file.name()), good);

    // With the ends of lines of other systems too
    std::string other = good;
    for (std::size_t at = 0; (at = other.find('\n', at)) != std::string::npos; at += 2) other.replace(at, 1, "\r\n");
    for (const Recording& recording : {read_recording(file.name()), recording_of(other)}) {
        EXPECT_EQ(recording.scene, "drop");
        EXPECT_THAT(recording.assignments, ElementsAre("solver.dt=1e-4", "friction=0.2"));
        ASSERT_EQ(recording.entries.size(), 4u);
        EXPECT_EQ(std::get<std::uint64_t>(recording.entries[1].content), 0x0123456789abcdefu);
        EXPECT_EQ(recording.entries[2].step, 5);
        EXPECT_EQ(recording.entries[2].line, 7);
        EXPECT_EQ(command_text(std::get<Command>(recording.entries[3].content)), "orbit 0.1 0.2");
        EXPECT_EQ(recording.last_step, 12);
        EXPECT_EQ(recording.notice, "");
    }
}

TEST(Recording, WithoutAFileIsSavedWhenItIsWantedAndBeginsAgainWithEachScene) {
    const ScratchFile file("saved.txt");
    Recorder recorder("", "drop", {"solver.dt=1e-4"});
    recorder.write(3, parse_command("next wind.on"));
    ASSERT_TRUE(recorder.save(file.name(), 5));
    EXPECT_FALSE(recorder.save(file.name(), 5)) << "a file is there";
    EXPECT_EQ(read_file(file.name()), "drape-recording 1\nscene drop\nset solver.dt=1e-4\n3 next wind.on\n5 end\n");
    recorder.write(6, command::Pause{});
    recorder.write(6, parse_command("scene hang"));
    recorder.begin_step(6);
    recorder.write(8, parse_command("reset"));
    recorder.write_hash(9, 0x0123456789abcdef);
    ASSERT_TRUE(recorder.cut_after(8));
    std::filesystem::remove(file.name());
    ASSERT_TRUE(recorder.save(file.name(), 8));
    EXPECT_EQ(read_file(file.name()), "drape-recording 1\nscene hang\n0 pause\n0 pause\n2 reset\n2 end\n");
}

TEST(Recording, CutOffAnywhereIsReadToTheLastWholeLineAndSaysSo) {
    const std::string text = good;
    const std::size_t header = text.find("set ");
    for (std::size_t size = 0; size < header; ++size) {
        EXPECT_THROW(recording_of(text.substr(0, size)), InputError) << "without a whole header, " << size;
    }
    for (std::size_t size = header; size < text.size(); ++size) {
        const std::string_view kept = std::string_view(text).substr(0, size);
        const Recording recording = recording_of(kept);
        const auto lines = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), '\n'));
        EXPECT_EQ(recording.assignments.size() + recording.entries.size(), lines - 2) << kept;
        EXPECT_THAT(recording.notice, HasSubstr(":" + std::to_string(lines + 1) + ": ")) << kept;
        EXPECT_EQ(recording.last_step, std::nullopt);
    }
}

TEST(Recording, OfAnotherFormIsRefused) {
    const ScratchFile file("foreign.txt");
    for (const char* text : {"", "\n", "drape-recording 2\nscene drop\n", "[cloth]\nmass = 1\n", "t,particle,x,y,z\n",
                             "\x89PNG\r\n\x1a\n"}) {
        file.write(text);
        EXPECT_THAT(input_error_of([&] { read_recording(file.name()); }),
                    AllOf(StartsWith(file.name() + ":1: "), HasSubstr("'drape-recording 1'")));
    }
    file.write("drape-recording 1\n0 pause\n");
    EXPECT_THAT(input_error_of([&] { read_recording(file.name()); }), StartsWith(file.name() + ":2: "));
    EXPECT_THAT(input_error_of([] { read_recording("/no/such/recording"); }), HasSubstr("/no/such/recording"));
    EXPECT_THROW(read_recording(testing::TempDir()), InputError) << "a folder";
}

TEST(Recording, WithADamagedLineIsReadUpToIt) {
    const std::string head = "drape-recording 1\nscene drop\n1 pause\n";
    for (const char* line :
         {"2 paus", "pause", "x pause", "-1 pause", "0 pause", "2 hash 12", "2 hash 0123456789abcdeg", "2 hash", "2",
          "", "2  pause", "set dt=1e-4", "\x01\x02", "2 steer nan 0 0", "0 end", "9223372036854775807 end",
          "1000000001 end", "1000000001 pause", "99999999999999999999 end"}) {
        const Recording recording = recording_of(head + line + "\n9 end\n");
        EXPECT_EQ(recording.entries.size(), 1u) << line;
        EXPECT_THAT(recording.notice, HasSubstr(":4: ")) << line;
    }
    EXPECT_THAT(recording_of(head + "1000000001 end\n").notice, HasSubstr("STEP <= 1000000000"));
    EXPECT_EQ(recording_of(head + "1000000000 end\n").last_step, 1'000'000'000);
    EXPECT_THAT(recording_of(head + "2 \x1b[31m\n").notice, HasSubstr("'\\x1b[31m'"));
    EXPECT_THAT(recording_of(head + "2 paus\n").notice, AllOf(HasSubstr("'pause'"), HasSubstr("line before")));
    EXPECT_THAT(recording_of(head + std::string(3'000'000, 'x') + "\n").notice, HasSubstr("too long"));
}

TEST(Recording, IsFoundInItsFolderByItsFirstLine) {
    const ScratchFolder folder;
    const auto write = [&](const char* name, const std::string& text) { std::ofstream(folder.path() / name) << text; };
    write("b.txt", "drape-recording 1\nscene drop\n0 end\n");
    write("a", "drape-recording 1\n");
    write("other.txt", "drape-recording 12\n");
    write("empty", "");
    std::filesystem::create_directory(folder.path() / "folder");
    ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
    EXPECT_THAT(recordings_in(folder.path()), ElementsAre("a", "b.txt"));
    EXPECT_THAT(recordings_in(folder.path() / "nowhere"), testing::IsEmpty());
}

TEST(Recording, MayHaveALongListInALine) {
    std::string pins = "set cloth.pinned=0";
    for (int i = 0; i < 5'000; ++i) pins += ",899";
    EXPECT_EQ(recording_of("drape-recording 1\nscene drop\n0 " + pins + "\n1 end\n").notice, "");
}

}  // namespace
}  // namespace drape
