// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/json_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ew {
namespace {

std::string nested(int depth) {
    const auto n = static_cast<std::size_t>(depth);
    return std::string(n, '[') + std::string(n, ']');
}

TEST(JsonText, HoldsItsLimits) {
    EXPECT_TRUE(parseJson(nested(32), {}));
    EXPECT_EQ(parseJson(nested(33), {}).error().code, Errc::TooDeep);
    EXPECT_TRUE(parseJson("[1, 2]", {.maxBytes = 6}));
    EXPECT_EQ(parseJson("[1, 2]", {.maxBytes = 5}).error().code, Errc::TooLarge);
}

TEST(JsonText, RefusesTextsThatWouldFillTheMemory) {
    // Each item is a few bytes of text and many times that in the tree.
    const JsonLimits limits{.maxTreeBytes = std::size_t{1} << 20U};
    for (const char* item : {"[]", "{}", "\"\"", "0", "{\"a\": 0}"}) {
        std::string text = "[0";
        for (int i = 0; i < 100; ++i) (text += ",") += item;
        EXPECT_TRUE(parseJson(text + "]", limits)) << item;
        while (text.size() < std::size_t{512} << 10U) (text += ",") += item;
        const auto read = parseJson(text + "]", limits);
        ASSERT_FALSE(read) << item;
        EXPECT_EQ(read.error().code, Errc::TooLarge) << item;
    }
    const auto text = parseJson('"' + std::string(std::size_t{2} << 20U, 'x') + '"', limits);
    EXPECT_EQ(text.error().code, Errc::TooLarge);
}

TEST(JsonText, RefusesKeysThatComeTwiceAndNumbersBeyondRange) {
    EXPECT_EQ(parseJson(R"({"a": 1, "b": {"a": 2}, "a": 3})", {}).error().code, Errc::Syntax);
    EXPECT_TRUE(parseJson(R"({"a": 1, "b": {"a": 2}})", {}));
    EXPECT_EQ(parseJson("[-1e999]", {}).error().code, Errc::BadValue);
    for (const char* bad :
         {"", " ", "[1,]", "{a: 1}", "[NaN]", "[Infinity]", "[01]", "1 2", "\"\x80\""}) {
        const auto read = parseJson(bad, {});
        ASSERT_FALSE(read) << bad;
        EXPECT_EQ(read.error().code, Errc::Syntax) << bad;
    }
}

TEST(JsonText, WritesNumbersThatReadBackToTheBit) {
    for (const double x : {0.0, -0.0, 0.1, 1.0 / 3.0, 1e22, 5e-324, 1.7976931348623157e308, -3.0}) {
        const auto read = parseJson(numberText(x), {});
        ASSERT_TRUE(read) << numberText(x);
        EXPECT_EQ(read->get<double>(), x);
        EXPECT_EQ(std::signbit(read->get<double>()), std::signbit(x));
    }
    EXPECT_EQ(numberText(0.25), "0.25");
}

TEST(JsonText, CutsOffNamesThatGoOnAndOn) {
    EXPECT_EQ(nameQuoted("a\"b"), R"("a\"b")");
    EXPECT_EQ(nameQuoted(std::string(80, 'x')), '"' + std::string(80, 'x') + '"');
    EXPECT_EQ(nameQuoted(std::string(81, 'x')), '"' + std::string(80, 'x') + "...\"");
    // Never in the middle of a character.
    EXPECT_EQ(nameQuoted(std::string(79, 'x') + "\u00e4\u00e4"),
              '"' + std::string(79, 'x') + "...\"");
    const auto read = parseJson(
        "{\"" + std::string(5000, 'k') + "\": 1, \"" + std::string(5000, 'k') + "\": 2}", {});
    ASSERT_FALSE(read);
    EXPECT_LT(read.error().message.size(), 200U);
}

TEST(JsonText, QuotesWhateverBytesComeIn) {
    EXPECT_EQ(jsonQuoted("a\"b\\c\n"), R"("a\"b\\c\n")");
    EXPECT_TRUE(parseJson(jsonQuoted("broken \xff\xfe utf-8 \x01"), {}));
}

}  // namespace
}  // namespace ew
