#include "drape/base/input_error.h"

#include <gtest/gtest.h>

#include <vector>

namespace drape {
namespace {

TEST(DidYouMean, OffersTheNameWithTheFewestEditsIfItIsNear) {
    const std::vector<std::string> names{"integrator", "dt", "velocity_verlet", "cat", "bat"};
    EXPECT_EQ(did_you_mean("intergator", names), ": did you mean 'integrator'?");
    EXPECT_EQ(did_you_mean("Dt", names), ": did you mean 'dt'?");
    EXPECT_EQ(did_you_mean("hat", names), ": did you mean 'cat'?") << "the first of two that are equally near";
    EXPECT_EQ(did_you_mean("velocity_sweden", names, "!"), "!") << "more than three edits";
    EXPECT_EQ(did_you_mean("cow", names), "") << "two edits of three letters";
    for (const std::string& far : {std::string(), std::string(1'000'000, 'x')}) EXPECT_EQ(did_you_mean(far, names), "");
}

TEST(ListedNames, ReadAsASentence) {
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed(std::vector<std::string>{"a"}), "'a'");
    EXPECT_EQ(listed(std::vector<std::string>{"a", "b"}), "'a' or 'b'");
    EXPECT_EQ(listed(std::vector<std::string>{"a", "b", "c"}), "'a', 'b' or 'c'");
}

TEST(InputErrors, AreOneLineWhateverTheyQuote) {
    EXPECT_STREQ(InputError("a\nb\rc\td\x1b[31m\x7f e").what(), "a\\nb\\rc\\td\\x1b[31m\\x7f e");
    EXPECT_STREQ(InputError("\xc2\x9b"
                            "31m")
                     .what(),
                 "\\xc2\\x9b31m")
        << "a control character of two bytes";
    EXPECT_STREQ(InputError("\xc3\xa4 \xe2\x82\xac").what(), "\xc3\xa4 \xe2\x82\xac") << "letters stay";
    EXPECT_STREQ(InputError(InputError("a\nb").what()).what(), "a\\nb") << "also where one quotes another";
    EXPECT_STREQ(InputError("a\nb", "See --help.").what(), "a\\nb\nSee --help.");
    const std::string endless = one_line("place: " + std::string(1'000'000, 'x') + ": allowed 1");
    EXPECT_LT(endless.size(), 2100u);
    EXPECT_TRUE(endless.starts_with("place: x") && endless.ends_with("x: allowed 1"));
}

TEST(QuotedValue, IsCutToAHundredBytesAndNotWithinALetter) {
    EXPECT_EQ(shortened(std::string(100, 'x')), std::string(100, 'x'));
    EXPECT_EQ(shortened(std::string(101, 'x')), std::string(100, 'x') + "...");
    EXPECT_EQ(shortened(std::string(99, 'x') + "\xc3\xa4x"), std::string(99, 'x') + "...");
}

}  // namespace
}  // namespace drape
