#include "drape/base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace drape {
namespace {

TEST(Numbers, ReadWholeDecimalTextsOnly) {
    EXPECT_EQ(parse_real("2e-4"), 2e-4);
    EXPECT_EQ(parse_real("+1.5"), 1.5);
    EXPECT_EQ(parse_real("-0.25"), -0.25);
    for (const char* text : {"", " 1", "1 ", "1,5", "1.5x", "0x10", "+-1", "++1", "1e999", "e5"}) {
        EXPECT_EQ(parse_real(text), std::nullopt) << '"' << text << '"';
    }
}

TEST(Numbers, ReadNanAndInfinityForTheRangeToRefuse) {
    EXPECT_TRUE(std::isnan(parse_real("nan").value()));
    EXPECT_EQ(parse_real("-inf"), -std::numeric_limits<double>::infinity());
}

TEST(Numbers, ReadWholeIntegersOnly) {
    EXPECT_EQ(parse_integer("-12"), -12);
    for (const char* text : {"", "1.0", "1e3", "99999999999999999999", "7 "}) {
        EXPECT_EQ(parse_integer(text), std::nullopt) << '"' << text << '"';
    }
}

TEST(Numbers, WriteTheShortestTextThatReadsBack) {
    EXPECT_EQ(real_text(0.1), "0.1");
    EXPECT_EQ(real_text(0.1, 17), "0.10000000000000001");
    EXPECT_EQ(real_text(2.0), "2");
}

TEST(Numbers, WriteHashesWithSixteenDigits) {
    EXPECT_EQ(hash_text(0), "0000000000000000");
    EXPECT_EQ(hash_text(0xdeadbeef), "00000000deadbeef");
    EXPECT_EQ(hash_text(~0ull), "ffffffffffffffff");
}

}  // namespace
}  // namespace drape
