#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "drape/base/unfinished_file.h"
#include "lab/lab_run.h"

namespace drape {
namespace {

using test::LabFolder;
using test::LabRun;
using test::table_of;
using testing::HasSubstr;

const std::map<std::string, std::string> without_gnuplot{{"PATH", "/nowhere"}};

/// Some cases that take no time, without charts.
LabRun run_some(const LabFolder& folder, std::vector<std::string> words) {
    words.insert(words.begin(), {"stability", "--quick", "--cases", "157-162"});
    return folder.run(words, DRAPE_LAB, without_gnuplot);
}

/// Quick cases of an experiment, how many rows they have, and what is in the files.
struct SomeCases {
    const char *experiment, *cases;
    std::size_t rows;
    std::vector<const char*> in_table;
    std::vector<const char*> charts = {};
};

TEST(LabExperiment, WritesTheRowsOfTheCasesThatAreAskedForAndDrawsThem) {
    const LabFolder folder;
    const SomeCases asked[]{
        {"combinations", "9-10", 2, {"\n9,symplectic_euler,projection,discrete,1,0.0005,", ",none\n10,"}},
        {"rest", "2-2", 1, {"\n2,rest,drop,projection,symplectic_euler,0.000313,asleep,"}},
        {"responses", "16-17", 2, {"\n16,step,hybrid,0.00026042,", "\n17,limit,penalty,nan,"}},
        {"contact", "14-14", 4, {"\n14,discrete,0,32,"}},
        {"continuous", "1-10", 12, {"\n9,time,none,continuous,"}, {"continuous_misses.svg", "continuous_time.svg"}}};
    for (const auto& [experiment, cases, rows, in_table, charts] : asked) {
        SCOPED_TRACE(experiment);
        const LabRun run = folder.run({experiment, "--quick", "--cases", cases, "--out", "out"});
        ASSERT_EQ(run.code, 0) << run.err;
        const std::string table = std::string("out/") + experiment + ".csv";
        EXPECT_EQ(table_of(folder, table).size(), 1 + rows);
        for (const char* text : in_table) EXPECT_THAT(folder.read(table), HasSubstr(text));
        if (run.has_no_gnuplot()) continue;
        for (const std::string chart : charts) EXPECT_THAT(folder.read("out/" + chart), HasSubstr("</svg>"));
    }
}

TEST(LabExperiment, GoesOnWhereItWasInterruptedAndOnlyWithItsOwnTable) {
    const LabFolder folder;
    const LabRun first = run_some(folder, {"--out", "whole"});
    ASSERT_EQ(first.code, 0) << first.err;
    EXPECT_THAT(first.err, HasSubstr("no gnuplot"));
    EXPECT_EQ(first.out, "whole/stability.html\n");
    EXPECT_THAT(folder.read("whole/stability.html"), testing::Not(HasSubstr("<img")));
    const std::string whole = folder.read("whole/stability.csv");
    std::filesystem::create_directories(folder.path("cut"));
    const std::string part = whole.substr(0, whole.find("\n160,") + 1) + "# end: 3\n";
    folder.write("cut/stability.csv.part", part);
    const LabRun run = run_some(folder, {"--out", "cut"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("resuming, 3 cases"));
    EXPECT_THAT(run.err, HasSubstr("stability.csv: 3 cases in"));
    EXPECT_EQ(folder.read("cut/stability.csv"), whole);
    EXPECT_FALSE(folder.has("cut/stability.csv.part"));

    std::string foreign = part;
    const std::size_t line = part.find("# commit: ");
    foreign.replace(line, part.find('\n', line) - line, "# commit: another");
    const std::pair<std::string, const char*> refused[]{
        {foreign, "out/stability.csv.part is of another run (commit: another, not "},
        {whole.substr(0, whole.find("\n160,") + 7), "cut off"},
        {"# experiment: stability\ncase,x\n1,2\n", "stability.csv.part:2: 'case,x': allowed '# drape: '"}};
    std::filesystem::create_directories(folder.path("out"));
    for (const auto& [text, said] : refused) {
        folder.write("out/stability.csv.part", text);
        const LabRun other = run_some(folder, {"--out", "out"});
        EXPECT_EQ(other.code, 2);
        EXPECT_THAT(other.err, HasSubstr(said));
        EXPECT_EQ(folder.read("out/stability.csv.part"), text);
    }
}

TEST(LabExperiment, KeepsTheTableThatIsThereAndComputesItAgainIfAsked) {
    const LabFolder folder;
    ASSERT_EQ(run_some(folder, {"--out", "out"}).code, 0);
    EXPECT_GT(table_of(folder, "out/stability.csv").size(), 10u);
    const LabRun second = run_some(folder, {"--out", "out"});
    EXPECT_EQ(second.code, 0);
    EXPECT_THAT(second.err, HasSubstr("all cases are there already"));
    EXPECT_FALSE(folder.has("out/stability-1.csv"));
    EXPECT_EQ(run_some(folder, {"--out", "out", "--again"}).code, 0);
    EXPECT_EQ(folder.read("out/stability-1.csv"), folder.read("out/stability.csv"));
    // That of another run is kept; what is no table is left to whoever has put it there
    const std::string older =
        test::replaced(folder.read("out/stability.csv"), "# commit: ", "# commit: an older one, ");
    folder.write("out/stability.csv", older);
    EXPECT_EQ(run_some(folder, {"--out", "out"}).code, 0);
    EXPECT_EQ(folder.read("out/stability-2.csv"), older);
    folder.write("out/stability.csv", "older");
    EXPECT_EQ(run_some(folder, {"--out", "out"}).code, 2);
    EXPECT_EQ(folder.read("out/stability.csv"), "older");
}

TEST(LabExperiment, LeavesAFolderToTheRunThatIsWritingThere) {
    const LabFolder folder;
    std::filesystem::create_directories(folder.path() / "out");
    {
        const UnfinishedFile other(folder.path() / "out/stability.csv.lock");
        const LabRun run = run_some(folder, {"--out", "out"});
        EXPECT_EQ(run.code, 1);
        EXPECT_THAT(run.err, HasSubstr("another run is writing "));
        EXPECT_FALSE(folder.has("out/stability.csv.part"));
    }
    EXPECT_EQ(run_some(folder, {"--out", "out"}).code, 0);
    EXPECT_FALSE(folder.has("out/.stability.csv.drape.lock"));

    folder.write("taken", "a file");
    const LabRun none = run_some(folder, {"--out", "taken/out"});
    EXPECT_EQ(none.code, 1);
    EXPECT_THAT(none.err, HasSubstr("taken/out/stability.csv.lock: cannot be written"));
}

TEST(LabExperiment, RefusesCasesAndSharesThatThereAreNot) {
    const LabFolder folder;
    const std::pair<const char*, std::vector<const char*>> bad[]{
        {"--cases", {"0-3", "5-4", "1-100000", "3", "a-b"}}, {"--share", {"0/2", "3/2", "1", "a/b", "1/0", "1/2/3"}}};
    for (const auto& [option, values] : bad) {
        for (const char* value : values) {
            const LabRun run = folder.run({"stability", option, value});
            EXPECT_EQ(run.code, 2) << value;
            EXPECT_THAT(run.err, testing::ContainsRegex("allowed (FIRST-LAST|K/N)")) << value;
        }
    }
    EXPECT_FALSE(folder.has("stability")) << "nothing is written before the options are read";
}

TEST(LabPage, ShowsEveryChartWithItsCaption) {
    const LabFolder folder;
    const LabRun run = folder.run({"stability", "--quick", "--cases", "161-162", "--out", "out"});
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string page = folder.read("out/stability.html");
    EXPECT_THAT(page, HasSubstr("<h1>stability: which steps stay bounded"));
    EXPECT_THAT(page, HasSubstr("<dt>settings</dt><dd>--quick --cases 161-162</dd>"));
    EXPECT_THAT(page, HasSubstr("<a href=\"stability.csv\">"));
    if (run.has_no_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
    EXPECT_THAT(page, HasSubstr("<img src=\"stability_projective_dynamics.svg\""));
    EXPECT_THAT(page, testing::ContainsRegex("<figcaption>[A-Z][^<]{40,}</figcaption>"));
    EXPECT_TRUE(folder.has("out/stability_projective_dynamics.svg"));
}

TEST(LabMerge, JoinsWhatGnuParallelHasComputedIntoTheTableOfASingleRun) {
    const LabFolder folder;
    const LabRun parallel = folder.run({"--jobs", "2", DRAPE_LAB, "stability", "--quick", "--cases", "157-162",
                                        "--share", "{}/3", ":::", "1", "2", "3"},
                                       "parallel", {{"PARALLEL_HOME", folder.path()}});
    if (parallel.code == 127) GTEST_SKIP() << "there is no GNU parallel";
    ASSERT_EQ(parallel.code, 0) << parallel.err;
    ASSERT_EQ(run_some(folder, {"--out", "whole"}).code, 0);
    const LabRun merge = folder.run({"merge", "stability-1-3", "stability-2-3", "stability-3-3"});
    ASSERT_EQ(merge.code, 0) << merge.err;
    EXPECT_EQ(folder.read("merged/stability.csv"), folder.read("whole/stability.csv"));
    EXPECT_TRUE(folder.has("merged/stability.html"));
}

TEST(LabMerge, RefusesSharesThatAreNotTheWhole) {
    const LabFolder folder;
    for (const char* share : {"1/3", "2/3"}) ASSERT_EQ(run_some(folder, {"--share", share}).code, 0);
    ASSERT_EQ(run_some(folder, {"--share", "1/2"}).code, 0);
    const auto refusal = [&folder](const std::vector<std::string>& folders) {
        std::vector<std::string> words{"merge"};
        words.insert(words.end(), folders.begin(), folders.end());
        const LabRun run = folder.run(words, DRAPE_LAB, without_gnuplot);
        EXPECT_EQ(run.code, 2) << run.out;
        return run.err;
    };
    EXPECT_THAT(refusal({"stability-1-3", "stability-2-3"}), HasSubstr("case 159 is missing beside stability-1-3/"));
    EXPECT_THAT(refusal({"stability-1-3", "stability-1-3"}),
                HasSubstr("case 157 of stability-1-3/stability.csv is in a table before it, too"));
    EXPECT_THAT(refusal({"stability-1-3", "stability-1-2"}),
                HasSubstr("case 157 of stability-1-2/stability.csv is in a table before it, too"));
    EXPECT_THAT(refusal({"nowhere"}), HasSubstr("no table of an experiment in nowhere"));
    folder.write("stability-1-3/stability.csv.part", "");
    EXPECT_THAT(refusal({"stability-1-3"}), HasSubstr("stability.csv.part: not finished"));
    EXPECT_FALSE(folder.has("merged"));
    std::filesystem::create_directories(folder.path("out"));
    folder.write("out/stability.csv.part", "of someone");
    ASSERT_EQ(run_some(folder, {"--share", "1/1"}).code, 0);
    EXPECT_THAT(refusal({"stability-1-1", "--out", "out"}), HasSubstr("an unfinished run is there"));
    EXPECT_EQ(folder.read("out/stability.csv.part"), "of someone");
}

}  // namespace
}  // namespace drape
