#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using testing::AllOf;
using testing::HasSubstr;

/// Whether a payload that makes a file of this name anywhere below has run.
bool has_marker(const LabFolder& folder) {
    const auto all = std::filesystem::recursive_directory_iterator(folder.path());
    return std::ranges::any_of(all, [](const auto& entry) { return entry.path().filename() == "marker"; });
}

constexpr const char* payload = "o`touch marker`";

LabRun run_two(const LabFolder& folder, std::vector<std::string> words) {
    words.insert(words.begin(), {"stability", "--quick", "--cases", "161-162"});
    return folder.run(words);
}

/// A finished table with a cell of its last method replaced.
void spoil(const LabFolder& folder, const std::string& file, const std::string& from, const std::string& to) {
    std::string text = folder.read(file);
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
        text.replace(at, from.size(), to);
    }
    ASSERT_THAT(text, HasSubstr(to));
    folder.write(file, text);
}

TEST(HostileTable, RunsNothingThroughMerge) {
    const LabFolder folder;
    ASSERT_EQ(run_two(folder, {"--out", "in"}).code, 0);
    const std::string whole = folder.read("in/stability.csv");
    for (const std::string method :
         {"`touch marker`", "x' . system('touch marker') . '", "\" . system(\"touch marker\") . \""}) {
        folder.write("in/stability.csv", whole);
        spoil(folder, "in/stability.csv", ",projective_dynamics,", "," + method + ",");
        const LabRun run = folder.run({"merge", "in"});
        EXPECT_EQ(run.code, 2) << run.out;
        EXPECT_THAT(run.err, HasSubstr("in/stability.csv:10: column method: '" + method + "': allowed letters, "));
        EXPECT_FALSE(has_marker(folder));
        EXPECT_FALSE(folder.has("merged"));
    }
    // The head is text on the page
    const std::size_t machine = whole.find("# machine: ") + 11;
    folder.write("in/stability.csv",
                 whole.substr(0, machine) + "<script>\"&" + whole.substr(whole.find('\n', machine)));
    ASSERT_EQ(folder.run({"merge", "in"}).code, 0);
    const std::string page = folder.read("merged/stability.html");
    EXPECT_THAT(page, HasSubstr("<dd>&lt;script&gt;&quot;&amp;</dd>"));
    EXPECT_THAT(page, testing::Not(HasSubstr("<script>")));
}

TEST(HostileTable, RunsNothingThroughAFinishedFolderOrAnUnfinishedOne) {
    const LabFolder folder;
    ASSERT_EQ(run_two(folder, {"--out", "out"}).code, 0);
    spoil(folder, "out/stability.csv", ",projective_dynamics,", ",`touch marker`,");
    const LabRun run = run_two(folder, {"--out", "out"});
    EXPECT_EQ(run.code, 2) << run.out;
    EXPECT_THAT(run.err, AllOf(HasSubstr("out/stability.csv:10: column method: '`touch marker`': allowed "),
                               HasSubstr("--again computes it once more")));
    EXPECT_EQ(run_two(folder, {"--out", "out", "--again"}).code, 0);
    EXPECT_TRUE(folder.has("out/stability-1.csv"));
    std::filesystem::create_directories(folder.path("part"));
    std::filesystem::rename(folder.path("out/stability-1.csv"), folder.path("part/stability.csv.part"));
    const LabRun unfinished = run_two(folder, {"--out", "part"});
    EXPECT_EQ(unfinished.code, 2) << unfinished.out;
    EXPECT_THAT(unfinished.err, HasSubstr("part/stability.csv.part:10: column method: "));
    EXPECT_FALSE(has_marker(folder));
}

TEST(HostileFolder, RunsNothingByItsName) {
    const LabFolder folder;
    for (const std::string name : {payload, "|touch marker;", "< touch marker;", "x'.system('touch marker').'"}) {
        const LabRun run = run_two(folder, {"--out", name});
        EXPECT_EQ(run.code, 0) << run.err;
        EXPECT_FALSE(has_marker(folder)) << name;
        if (run.has_no_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
        EXPECT_TRUE(folder.has(name + "/stability_projective_dynamics.png"));
        const LabRun again = folder.run({"merge", name, "--out", name + "2"});
        EXPECT_EQ(again.code, 0) << again.err;
        EXPECT_FALSE(has_marker(folder)) << name;
    }
    // The script that draws the chart again
    const std::string name = std::string(payload) + "/stability_projective_dynamics";
    EXPECT_THAT(folder.read(name + ".gnuplot"), testing::Not(HasSubstr("touch")));
    const std::string picture = folder.read(name + ".png");
    std::filesystem::remove(folder.path(name + ".png"));
    const LabRun by_hand =
        folder.run({"-c", "cd 'o`touch marker`' && gnuplot stability_projective_dynamics.gnuplot"}, "sh");
    EXPECT_EQ(by_hand.code, 0) << by_hand.err;
    EXPECT_EQ(folder.read(name + ".png"), picture);
    EXPECT_FALSE(has_marker(folder));
}

TEST(HostileFolder, NoProgramInItIsTakenForGnuplot) {
    const LabFolder folder;
    std::filesystem::create_directories(folder.path("out"));
    folder.write("out/gnuplot", "#!/bin/sh\ntouch marker\n");
    std::filesystem::permissions(folder.path("out/gnuplot"), std::filesystem::perms::owner_all);
    const LabRun run =
        folder.run({"stability", "--quick", "--cases", "161-162", "--out", "out"}, DRAPE_LAB, {{"PATH", ".:"}});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("no gnuplot"));
    EXPECT_FALSE(has_marker(folder));
}

}  // namespace
}  // namespace drape
