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

/// A row with a cell in every column.
Row good_row(const Experiment& experiment) {
    Row row;
    for (const Column& column : experiment.columns) row.set(column.name, 4);
    return row;
}

std::vector<std::string> good_texts(const Experiment& experiment) {
    return good_row(experiment).texts(experiment.columns, experiment.digits);
}

std::string line_with(const std::string& number, const std::vector<std::string>& row) {
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
    std::string columns = line_with("case", column_names());
    std::string rows = row("3") + row("3") + row("4");
    std::string end = "# end: 2\n";

    static std::vector<std::string> column_names() {
        std::vector<std::string> names;
        for (const Column& column : experiment_of("stability").columns) names.push_back(column.name);
        return names;
    }
    static std::string row(const std::string& number) {
        return line_with(number, good_texts(experiment_of("stability")));
    }
    [[nodiscard]] std::string all() const { return experiment + origin + settings + columns + rows + end; }
};

ExperimentTable read(const std::string& text) {
    std::istringstream in(text);
    return read_table(experiment_of("stability"), in, "t.csv");
}

/// What is said of a table that is refused; empty if it is not.
std::string refusal(const std::string& text) try {
    read(text);
    return "";
} catch (const InputError& error) {
    return error.what();
}

TEST(TableCheck, TakesNoCellThatIsMoreThanAWordOrANumber) {
    const auto with = [&](const std::string& cell) {
        Text text;
        std::vector<std::string> row = good_texts(experiment_of("stability"));
        row[0] = cell;
        text.rows = Text::row("3") + line_with("3", row) + Text::row("4");
        return refusal(text.all());
    };
    EXPECT_EQ(with("rk4"), "");
    EXPECT_EQ(with("`id`"), "t.csv:11: column method: '`id`': allowed letters, digits and any of _.+-");
    for (const char* cell :
         {"'", "\"", "$x", "@x", "\\", "<b>", "1 2", "2`id`", "nan(id)", "1;2", "\x7f", "\xc3\xa4"}) {
        EXPECT_THAT(with(cell), HasSubstr("t.csv:11: column method: '")) << cell;
    }
    EXPECT_EQ(with("1,1"), "t.csv:11: 15 cells: allowed 14");
    Text text;
    text.settings.insert(12, "\x1b[2J");
    EXPECT_EQ(refusal(text.all()), "t.csv:7: allowed is plain ASCII");
}

TEST(TableCheck, RefusesATableThatWasCutOffOrHasRowsOfAnother) {
    const auto with = [](const std::string& rows, const std::string& end) {
        Text text;
        text.rows = rows, text.end = end;
        return refusal(text.all());
    };
    const std::string three = Text::row("3"), four = Text::row("4");
    const char* const order = "': allowed that of the row above, or a greater one";
    EXPECT_EQ(with(three + four + three, "# end: 2\n"), std::string("t.csv:12: case '3") + order);
    for (const char* number : {"-3", "0", "3.0", "", "99999999999999999999"}) {
        EXPECT_THAT(with(three + Text::row(number), "# end: 2\n"), HasSubstr("t.csv:11: case '")) << number;
    }
    for (const char* end : {"# end: 3\n", "# end: x\n"}) {
        EXPECT_THAT(with(three + four, end), HasSubstr("': allowed '# end: 2'"));
    }
    EXPECT_THAT(with(three + four, ""), HasSubstr("t.csv:11: cut off"));
    EXPECT_THAT(with(three + four.substr(0, 20), ""), HasSubstr("t.csv:11: cut off"));
    EXPECT_EQ(refusal(Text().all() + "4,`id`\n"), "t.csv:14: there is more after the end");
}

TEST(TableCheck, DemandsAHeadThatSaysWhatTheTableIs) {
    Text text;
    const auto with = [&](const std::string& from, const std::string& to) {
        return refusal(replaced(text.all(), from, to));
    };
    EXPECT_THAT(with(": stability", ": contact"), HasSubstr("t.csv:9: this is no table of stability"));
    EXPECT_THAT(with("case,method", "case,way"), HasSubstr("t.csv:9: this is no table of stability"));
    for (const std::string line : {"", "# date: 1\n", "# <b>: 1\n", "# commit\n"}) {
        EXPECT_THAT(with("# commit: 1\n", line), MatchesRegex("t.csv:3: '# .*': allowed '# commit: ' of a head"));
    }
    EXPECT_THAT(refusal(std::string("\x7f"
                                    "ELF\0\0\x01\n",
                                    8)),
                HasSubstr("t.csv:1: "));
    EXPECT_THAT(refusal(""), HasSubstr("there is no table"));
    EXPECT_THAT(with("A (R)", std::string(20'000, 'a')), HasSubstr("t.csv:4: longer than 16384 bytes"));
}

TEST(TableCheck, ReadsWhatARunHasWrittenUnlessItIsCutOffAnywhere) {
    const std::string whole = Text().all();
    const ExperimentTable table = read(whole);
    EXPECT_EQ(table.rows().size(), 3u);
    EXPECT_EQ(table.cases.at(3).size(), 2u);
    EXPECT_EQ(table.head.at("machine"), "A (R)");
    for (std::size_t length = 0; length < whole.size(); ++length) EXPECT_NE(refusal(whole.substr(0, length)), "");
}

TEST(TableRow, HasWholeNumbersAsTheyAreAndDigitsOfOthersAndItsColumnsWordForNothing) {
    const Columns columns{"a", "b", Column{"c", "none"}, Column{"d", ""}, quartile_columns("e_s")};
    const Row row{{"a", 1234567}, {"b", 0.12345678}, {"d", no_number}, {"e_s", Quartiles{1, 2, 3}}};
    EXPECT_EQ(row.texts(columns, 3), (std::vector<std::string>{"1234567", "0.123", "none", "", "2", "1", "3"}));
    EXPECT_EQ(Row({{"a", no_number}, {"b", 1e6}}).texts({"a", "b"}, 6), (std::vector<std::string>{"nan", "1e+06"}));
    EXPECT_THROW((void)row.texts({"a", "b"}, 3), RunError) << "a cell that no column has";
    EXPECT_THROW((void)Row({{"a", "word"}}).number("a"), InputError);
}

TEST(TableCheck, ChartsStandWhateverPassesTheCheck) {
    for (const Experiment& experiment : experiments()) {
        const Rows rows(3, good_row(experiment));
        EXPECT_NO_THROW(static_cast<void>(experiment.charts(rows))) << experiment.name;
    }
}

}  // namespace
}  // namespace drape
