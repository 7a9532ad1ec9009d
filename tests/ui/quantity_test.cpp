// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/quantity.h"

#include <gtest/gtest.h>

#include <limits>

namespace ew::test {
namespace {

double mm(const char* text) {
    return quantity(QString::fromUtf8(text), QStringLiteral("mm"))
        .value_or(std::numeric_limits<double>::quiet_NaN());
}

TEST(Quantity, SumsAreReadAsTheyAreWritten) {
    EXPECT_EQ(mm("12"), 12);
    EXPECT_EQ(mm("120/3 + 2"), 42);
    EXPECT_EQ(mm("2 + 3 * 4"), 14);
    EXPECT_EQ(mm("(2 + 3) * 4"), 20);
    EXPECT_EQ(mm("-(2 - 5)"), 3);
    EXPECT_EQ(mm("10 - 2 - 3"), 5);
    EXPECT_EQ(mm("100/5/2"), 10);
    EXPECT_EQ(mm("7 / 2,5"), 2.8);
    EXPECT_EQ(mm("3 \u00d7 4 \u00f7 2"), 6);
    EXPECT_EQ(mm("1,5 + 1.5"), 3);
    EXPECT_EQ(mm("2 * -3"), -6);
}

TEST(Quantity, EachNumberMayHaveAUnitOfLength) {
    EXPECT_DOUBLE_EQ(mm("2 cm"), 20);
    EXPECT_DOUBLE_EQ(mm("0.1m"), 100);
    EXPECT_DOUBLE_EQ(mm("1 IN"), 25.4);
    EXPECT_DOUBLE_EQ(mm("2 cm + 3"), 23);
    EXPECT_DOUBLE_EQ(mm("3 * 2 cm"), 60);
    EXPECT_DOUBLE_EQ(mm("(1 + 1) in"), 50.8);
    EXPECT_DOUBLE_EQ(mm("6 in / 2"), 76.2);
    EXPECT_DOUBLE_EQ(mm("6 in / 2 in"), 3);
    EXPECT_DOUBLE_EQ(mm("5 ft 6 in"), 66 * 25.4);
    EXPECT_DOUBLE_EQ(mm("5' 6\""), 66 * 25.4);
}

TEST(Quantity, FractionsOfInchesAreOneNumber) {
    EXPECT_DOUBLE_EQ(mm("3/4 in"), 19.05);
    EXPECT_DOUBLE_EQ(mm("1 1/2 in"), 38.1);
    EXPECT_DOUBLE_EQ(mm("2 3/8\""), 60.325);
    EXPECT_DOUBLE_EQ(mm("1 1/2"), 1.5);
}

TEST(Quantity, WhatIsNoLengthIsNotGuessed) {
    for (const char* text : {"",        " ",           "1 2",      "1/0",
                             "1/(2-2)", "2 in * 3 in", "1/(2 in)", "2 in + (2 in * 2 in)",
                             "2 kg",    "5 mil",       "(2",       "2)",
                             "2 +",     "* 2",         "--2",      "1e3",
                             "1,2,3",   "5 ft 6",      "2 cm 3 4", "nan",
                             "inf",     "()",          "2(3)"}) {
        EXPECT_FALSE(quantity(QString::fromUtf8(text), QStringLiteral("mm"))) << text;
    }
    EXPECT_FALSE(quantity(QString(5000, QLatin1Char('(')), QStringLiteral("mm")));
}

TEST(Quantity, OtherFieldsHaveSumsWithoutUnits) {
    EXPECT_EQ(quantity(QStringLiteral("360/8"), QStringLiteral("\u00b0")), 45.0);
    EXPECT_FALSE(quantity(QStringLiteral("2 cm"), QStringLiteral("px")));
    EXPECT_FALSE(quantity(QStringLiteral("2 m"), QString()));
}

}  // namespace
}  // namespace ew::test
