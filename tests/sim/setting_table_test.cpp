#include "drape/scene/setting_table.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <set>

#include "support/input_errors.h"

namespace drape {
namespace {

using test::input_error_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Settings in which every row of the table has something to read and write.
Settings with_one_of_each() {
    Settings settings = settings_with_one_of_each();
    settings.cloths[0].pinned.kind = Pins::Kind::Row;
    return settings;
}

bool holds_numbers(const Setting& setting) {
    return setting.kind != SettingKind::Flag && setting.kind != SettingKind::Choice &&
           setting.kind != SettingKind::Text;
}

/// A value of the setting's kind with `number` at every place.
SettingValue filled_with(const Setting& setting, double number) {
    switch (setting.kind) {
        case SettingKind::Integer:
        case SettingKind::Number:
            return number;
        case SettingKind::Grid:
        case SettingKind::Size:
            return std::vector<double>(2, number);
        case SettingKind::Path:
            return std::vector<double>(4, number);
        default:
            return std::vector<double>(3, number);
    }
}

TEST(SettingTable, NamesEverySettingOnceAndExplainsIt) {
    std::set<std::string> names;
    for (const Setting& setting : setting_table()) {
        EXPECT_TRUE(names.insert(setting.full_name()).second) << setting.full_name() << " stands twice";
        EXPECT_THAT(setting.help, Not(IsEmpty())) << setting.full_name();
        EXPECT_EQ(&find_setting(setting.full_name()), &setting);
    }
    EXPECT_GT(names.size(), 40u);
}

TEST(SettingTable, ReadsBackEveryValueThatItWrites) {
    EXPECT_NO_THROW(check(with_one_of_each()));
    for (const Setting& setting : setting_table()) {
        Settings settings = with_one_of_each();
        const SettingValue value = setting.read(settings, 0);
        EXPECT_EQ(parse_value(setting, value_text(value)), value) << setting.full_name();
        ASSERT_NO_THROW(assign(settings, setting.full_name() + "=" + value_text(value))) << setting.full_name();
        EXPECT_EQ(setting.read(settings, 0), value) << setting.full_name();
    }
}

TEST(SettingTable, TakesBothEndsOfEveryRangeAndNothingBeyond) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const Setting& setting : setting_table()) {
        if (!holds_numbers(setting)) continue;
        SCOPED_TRACE(setting.full_name());
        const double low = setting.range.low, high = setting.range.high;
        for (const double end : {low, high}) {
            Settings settings = with_one_of_each();
            const SettingValue value = filled_with(setting, end);
            ASSERT_EQ(refusal(setting, value), "");
            setting.write(settings, 0, value);
            EXPECT_EQ(setting.read(settings, 0), value);
        }
        for (const double outside : {std::nextafter(low, -1e300), std::nextafter(high, 1e300)}) {
            const SettingValue value = filled_with(setting, outside);
            EXPECT_THAT(refusal(setting, value), AllOf(HasSubstr(setting.full_name() + " = " + value_text(value)),
                                                       HasSubstr("allowed " + accepted(setting))));
        }
        for (const double number : {std::nan(""), infinity, -infinity}) {
            EXPECT_NE(refusal(setting, filled_with(setting, number)), "");
        }
    }
}

TEST(SettingTable, RefusesValuesOfAnotherKind) {
    const std::vector<SettingValue> values{true, 2.0, std::string("none"), std::vector<double>{4, 4}};
    for (const Setting& setting : setting_table()) {
        std::size_t accepted_kinds = 0;
        for (const SettingValue& value : values) accepted_kinds += refusal(setting, value).empty() ? 1 : 0;
        EXPECT_LE(accepted_kinds, setting.kind == SettingKind::Pins ? 2u : 1u) << setting.full_name();
    }
}

TEST(SettingTable, SaysWhatIsAcceptedInItsHelp) {
    const std::string help = settings_help();
    for (const Setting& setting : setting_table()) {
        EXPECT_THAT(
            help, AllOf(HasSubstr(setting.full_name() + " = "), HasSubstr(setting.help), HasSubstr(accepted(setting))));
    }
    EXPECT_THAT(help, HasSubstr("solver.dt = 2e-04 [s]"));
}

TEST(SettingTable, HasWordsForNumbersThatMeanMore) {
    const Setting &level = find_setting("contact.search_level"), &sleep = find_setting("solver.sleep_speed");
    EXPECT_EQ(parse_value(level, "unlimited"), SettingValue(30.0));
    EXPECT_EQ(shown_value(level, 30.0), "unlimited");
    EXPECT_EQ(shown_value(level, 3.0), "3");
    EXPECT_EQ(shown_value(sleep, 0.0), "never");
    EXPECT_EQ(shown_value(sleep, 0.5), "0.5 m/s");
    EXPECT_THAT(refusal(sleep, parse_value(sleep, "unlimited")), HasSubstr("sleep_speed = unlimited: allowed"));
}

TEST(SettingTable, FindsAShortNameThatOnlyOneSettingHasAndNamesTheCandidatesOfOthers) {
    EXPECT_EQ(find_setting("dt").full_name(), "solver.dt");
    EXPECT_EQ(find_setting("structural.stiffness").full_name(), "cloth.structural.stiffness");
    EXPECT_THAT(input_error_of([] { find_setting("mass"); }),
                AllOf(HasSubstr("'mass'"), HasSubstr("'cloth.mass' or 'ball.mass'")));
}

TEST(SettingTable, NamesTheNearestKnownSetting) {
    EXPECT_THAT(input_error_of([] { find_setting("solver.intergator"); }), HasSubstr("'solver.integrator'"));
    EXPECT_THAT(input_error_of([] { find_setting("leafcells"); }), HasSubstr("'leaf_cells'"));
    EXPECT_THAT(input_error_of([] { find_setting(""); }), HasSubstr("unknown setting ''"));
    EXPECT_LT(input_error_of([] { find_setting(std::string(100'000, 'x')); }).size(), 300u);
}

// A reset button stands beside them
TEST(SettingTable, HasShortLabelsThatDifferWithinASection) {
    std::set<std::string> seen;
    for (const Setting& setting : setting_table()) {
        const std::string label = setting_label(setting);
        EXPECT_LE(label.size(), 20U) << setting.full_name();
        EXPECT_TRUE(seen.insert(setting.section + ": " + label).second) << setting.full_name();
    }
}

}  // namespace
}  // namespace drape
