#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "drape/base/input_error.h"
#include "lab/experiment/experiment_table.h"
#include "lab/experiments.h"
#include "lab/lab_run.h"
#include "support/input_errors.h"

namespace drape {
namespace {

using test::LabFolder;
using test::replaced;
using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;

const std::vector<Experiment>& experiments() {
    static const std::vector<Experiment> all = all_experiments();
    return all;
}

const Experiment& experiment_of(const std::string& name) {
    return *std::ranges::find(experiments(), name, &Experiment::name);
}

/// A row with cells that its columns may have.
Row good_row(const Experiment& experiment) {
    Row row;
    for (const Column& column : experiment.columns) {
        row.set(column.name, column.kind == Column::Kind::Word ? Cell(column.words.front()) : Cell(4));
    }
    return row;
}

TableRow good_texts(const Experiment& experiment) {
    return good_row(experiment).texts(experiment.columns, experiment.digits);
}

std::size_t place_of(const Experiment& experiment, const std::string& column) {
    const auto found = std::ranges::find(experiment.columns, column, &Column::name);
    EXPECT_NE(found, experiment.columns.end()) << column;
    return static_cast<std::size_t>(found - experiment.columns.begin());
}

std::string line_with(const std::string& number, const TableRow& row) {
    std::string line = number;
    for (const std::string& cell : row) line += "," + cell;
    return line + "\n";
}

/// A table of stability with cases 3 and 4, as a run writes it; each part can be replaced.
struct Text {
    std::string experiment = "# experiment: stability\n";
    std::string origin =
        "# drape: 0, double precision\n# commit: 1\n# machine: A (R)\n# compiler: g\n# date: 2026-01-01\n";
    std::string settings = "# settings: --quick --cases 3-4\n# cases: 10\n";
    std::string columns = line_with("case", names_in(experiment_of("stability").columns, &Column::name));
    std::string rows = row("3") + row("3") + row("4");
    std::string end = "# end: 2\n";

    static std::string row(const std::string& number) {
        return line_with(number, good_texts(experiment_of("stability")));
    }
    [[nodiscard]] std::string all() const { return experiment + origin + settings + columns + rows + end; }
};

std::optional<ExperimentTable> read(const std::string& text, bool unfinished = false,
                                    const std::string& experiment = "stability") {
    std::istringstream in(text);
    return read_table(experiment_of(experiment), in, "t.csv", unfinished);
}

/// What is said of a table that is refused; empty if it is not.
std::string refusal(const std::string& text, bool unfinished = false) try {
    read(text, unfinished);
    return "";
} catch (const InputError& error) {
    return error.what();
}

TEST(TableCheck, NoColumnOfAnyExperimentTakesTextThatIsNoneOfItsWords) {
    for (const Experiment& experiment : experiments()) {
        const TableRow good = good_texts(experiment);
        ASSERT_EQ(flaw_of(experiment.columns, good), "") << experiment.name;
        for (std::size_t k = 0; k < good.size(); ++k) {
            for (const char* cell : {"banana", "`id`", "'", "\"", "$x", "@x", "\\", "<b>", "1 2", "0x10", "1e999",
                                     "2`id`", "infinity", "nan(id)", "1;2", "\n", "-2"}) {
                TableRow bad = good;
                bad[k] = cell;
                EXPECT_THAT(flaw_of(experiment.columns, bad),
                            AllOf(HasSubstr("column " + experiment.columns[k].name + ": '"), HasSubstr("allowed ")))
                    << cell;
            }
        }
    }
}

TEST(TableCheck, NamesLineColumnValueAndWhatIsAllowed) {
    const Experiment& stability = experiment_of("stability");
    const auto with = [&](const std::string& column, const std::string& cell) {
        Text text;
        TableRow row = good_texts(stability);
        row[place_of(stability, column)] = cell;
        text.rows = Text::row("3") + line_with("3", row) + Text::row("4");
        return refusal(text.all());
    };
    EXPECT_EQ(with("measured_step_s", "banana"),
              "t.csv:11: column measured_step_s: 'banana': allowed a finite number >= 0, or 'inf'");
    EXPECT_THAT(with("step_s", "nan"), HasSubstr("column step_s: 'nan': allowed a finite number > 0"));
    EXPECT_THAT(with("side", "16.5"), HasSubstr("column side: '16.5': allowed a whole number >= 2"));
    EXPECT_EQ(with("agreement", "maybe"),
              "t.csv:11: column agreement: 'maybe': allowed 'agrees', 'disagrees' or 'close'");
    EXPECT_EQ(with("step_s", "1,1"), "t.csv:11: 15 cells: allowed 14");
    EXPECT_EQ(with("step_s", "0.12345678"),
              "t.csv:11: column step_s: '0.12345678': allowed '0.123457', as a run writes it");
    TableRow row = good_texts(stability);
    row[place_of(stability, "measured_step_s")] = "inf";
    EXPECT_EQ(flaw_of(stability.columns, row), "") << "of a method without a limit";
}

TEST(TableCheck, DemandsTheCasesOfItsHeadEachOnceInTheirOrder) {
    const auto with = [](const std::string& rows, const std::string& end, bool unfinished = false) {
        Text text;
        text.rows = rows, text.end = end;
        return refusal(text.all(), unfinished);
    };
    const std::string three = Text::row("3"), four = Text::row("4");
    EXPECT_EQ(with(three + four + three, "# end: 2\n"),
              "t.csv:12: column case: '3': allowed 4, by 'settings' and 'cases' above");
    EXPECT_EQ(with(four, "# end: 1\n"), "t.csv:10: column case: '4': allowed 3, by 'settings' and 'cases' above");
    EXPECT_THAT(with(four, "", true), HasSubstr("column case: '4': allowed 3")) << "also if it is unfinished";
    for (const char* number : {"5", "-3", "3.0", "", "99999999999999999999"}) {
        EXPECT_THAT(with(three + Text::row(number), "# end: 2\n"), HasSubstr("t.csv:11: column case: '")) << number;
    }
    EXPECT_EQ(with(three, "# end: 1\n"), "t.csv:11: case 4 is missing above");
    EXPECT_EQ(with(three + four, "# end: 3\n"), "t.csv:12: '# end: 3': allowed '# end: 2', the number of cases above");
    EXPECT_EQ(with(three + four, "# end: x\n"), "t.csv:12: '# end: x': allowed '# end: 2', the number of cases above");
    EXPECT_THAT(with(three + four, ""), HasSubstr("t.csv:11: cut off"));
    for (const std::string after : {"x\n", "\n", "x", "4,`id`\n", "# end: 2\n"}) {
        for (const bool unfinished : {false, true}) {
            EXPECT_EQ(refusal(Text().all() + after, unfinished), "t.csv:13: there is more after the end") << after;
        }
    }
}

TEST(TableCheck, DemandsAHeadThatSaysWhatTheTableIs) {
    Text text;
    const auto with = [&](const std::string& from, const std::string& to) {
        return refusal(replaced(text.all(), from, to));
    };
    EXPECT_EQ(with(": stability", ": contact"), "t.csv:8: experiment = 'contact' above: allowed 'stability'");
    for (const std::string line : {"", "# date: 1\n", "# <b>: 1\n", "# commit\n"}) {
        EXPECT_THAT(with("# commit: 1\n", line), MatchesRegex("t.csv:3: '# .*': allowed '# commit: ' of a head"));
    }
    for (const char* count : {"0", "x", "1e3", "100001", ""}) {
        EXPECT_THAT(with("cases: 10", std::string("cases: ") + count), HasSubstr("' above: allowed 1 to 100000"))
            << count;
    }
    for (const char* settings : {"quick", "", "--quick --share 1/2 --cases 3-4", "--quick  --cases 3-4", "whole x"}) {
        EXPECT_THAT(with("--quick --cases 3-4", settings), HasSubstr("' above: allowed 'whole' or '--quick', then"))
            << settings;
    }
    EXPECT_THAT(with("--cases 3-4", "--cases 3-11"), HasSubstr("t.csv:8: the settings above have --cases 3-11"));
    EXPECT_THAT(with("A (R)", "\x1b[2J"), HasSubstr("t.csv:4: byte 12 is no printable"));
}

TEST(TableCheck, EndsEarlyWhereAFileIsTooLargeOrNoText) {
    EXPECT_EQ(refusal(std::string("\x7f"
                                  "ELF\0\0\x01\n",
                                  8)),
              "t.csv:1: byte 1 is no printable ASCII character");
    EXPECT_THAT(refusal(""), HasSubstr("there is no table"));
    EXPECT_THAT(refusal("banana\n"), HasSubstr("t.csv:1: 'banana': allowed '# experiment: ' of a head"));
    EXPECT_THAT(refusal(replaced(Text().all(), "case,method", "case,way")),
                HasSubstr("t.csv:9: these are not the columns of stability"));
    Text text;
    EXPECT_THAT(refusal(replaced(text.all(), "A (R)", std::string(20'000, 'a'))),
                HasSubstr("t.csv:4: too long: allowed 16384 bytes in a line"));
    // Of its size alone, before a line is read
    const std::string long_row = replaced(Text::row("3"), ",4,", ",4." + std::string(16'000, '0') + ",");
    text.rows.clear();
    for (int k = 0; k < 2200; ++k) text.rows += long_row;
    const LabFolder folder;
    folder.write("t.csv", text.all());
    EXPECT_THAT(test::input_error_of([&] { read_table(experiment_of("stability"), folder.path("t.csv"), false); }),
                HasSubstr(" bytes: allowed at most 33554432"));
}

TEST(TableCheck, ReadsWhatARunHasWrittenAndAnUnfinishedTableThatIsCutOffAnywhere) {
    const std::string whole = Text().all();
    const auto table = read(whole);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->rows().size(), 3u);
    EXPECT_EQ(table->cases.at(3).size(), 2u);
    EXPECT_EQ(table->head.at("machine"), "A (R)");
    for (std::size_t length = 0; length < whole.size(); ++length) {
        std::optional<ExperimentTable> part;
        ASSERT_NO_THROW(part = read(whole.substr(0, length), true)) << length;
        EXPECT_LE(part ? part->cases.size() : 0, 1u) << "the last case may lack rows";
    }
    EXPECT_EQ(read(whole, true)->cases.size(), 2u);
}

TEST(TableCheck, LetsNothingBeWrittenThatCouldNotBeReadBack) {
    const LabFolder folder;
    const Experiment& stability = experiment_of("stability");
    const ExperimentTable table{head_of(stability, {.quick = true}, 162), {}};
    TableWriter writer(stability, folder.path("t.csv"), table);
    Row row = good_row(stability);
    writer.write(1, Rows{row});
    row.set("step_s", no_number);
    EXPECT_THROW(writer.write(2, Rows{row}), RunError);
    EXPECT_THROW(writer.write(2, Rows{}), RunError);
    EXPECT_EQ(folder.read("t.csv.part").find("\n2,"), std::string::npos);
}

TEST(Summary, HasALineForEachChoiceOfCellsWithTheRangesOfItsRows) {
    const Experiment experiment{
        .name = "x",
        .question = "",
        .digits = 6,
        .columns = {word_column("kind", {"a", "b"}), number_column("size").or_nan(), number_column("time_s").or_nan()},
        .summary = {{"kind", "size"}, {"time_s"}},
        .parts = {}};
    const std::string text = summary_of(experiment, {{{"kind", "b"}, {"size", 8}, {"time_s", 0.5}},
                                                     {{"kind", "a"}, {"size", no_number}, {"time_s", 3}},
                                                     {{"kind", "b"}, {"size", 8}, {"time_s", no_number}},
                                                     {{"kind", "b"}, {"size", 8}, {"time_s", 0.1234}},
                                                     {{"kind", "a"}, {"size", 9}, {"time_s", no_number}}});
    EXPECT_EQ(text, "b, size 8: 3 rows, time_s 0.123 to 0.5\na: 1 row, time_s 3\na, size 9: 1 row\n");
}

TEST(TableCheck, SummariesAndChartsStandWhateverPassesTheCheck) {
    for (const Experiment& experiment : experiments()) {
        const Rows rows(3, good_row(experiment));
        EXPECT_NO_THROW(static_cast<void>(summary_of(experiment, rows))) << experiment.name;
        // That of precision refuses a reference that is worth nothing
        try {
            static_cast<void>(experiment.charts(rows));
        } catch (const RunError& error) {
            EXPECT_THAT(error.what(), HasSubstr("no chart is drawn"));
        }
    }
}

}  // namespace
}  // namespace drape
