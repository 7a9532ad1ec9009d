// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people type them.
#include "ui/number_box.h"

#include <QLineEdit>
#include <QTest>

#include "tests/ui/window_fixture.h"
#include "ui/live_reading.h"
#include "ui/tools/tool_box.h"

namespace ew::test {
namespace {

template <class Box>
double typed(Box& box, const QString& text) {
    box.setValue(7);
    box.show();
    box.selectAll();
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
    return box.value();
}

TEST(NumberBox, ACommaAndAPointAreBothADecimalMark) {
    for (const char* language : {"en_US", "de_DE", "de_CH", "fr_FR"}) {
        NumberBox box;
        box.setLocale(QLocale(language));
        box.setRange(0, 1e7);
        box.setDecimals(3);
        box.setSuffix(" mm");
        EXPECT_EQ(typed(box, "2.5"), 2.5) << language;
        EXPECT_EQ(typed(box, "2,5"), 2.5) << language;
        EXPECT_EQ(typed(box, "0,125"), 0.125) << language;
        EXPECT_EQ(typed(box, "12"), 12) << language;
        // A key that nothing can be meant by is refused; the others count.
        EXPECT_EQ(typed(box, "1,2,3"), 1.23) << language;
        EXPECT_EQ(typed(box, "1..5"), 1.5) << language;
    }
}

TEST(NumberBox, KnowsGroupsWhereBothMarksAreThere) {
    for (const char* language : {"en_US", "de_DE"}) {
        const QLocale locale(language);
        const QString mark = locale.decimalPoint();
        EXPECT_EQ(decimalText("1.234,5", locale), "1234" + mark + "5");
        EXPECT_EQ(decimalText("1,234.5", locale), "1234" + mark + "5");
        EXPECT_EQ(decimalText("12,345,678.9", locale), "12345678" + mark + "9");
        EXPECT_EQ(decimalText("-1.000,", locale), "-1000" + mark);
        for (const char* nonsense :
             {"1.2,5", "1,23.4", "1.234.567", "1,2,3", "1.234,567,8", ".,"}) {
            EXPECT_FALSE(decimalText(nonsense, locale)) << nonsense;
        }
    }
}

TEST(NumberBox, AWholeNumberIsNotMultiplied) {
    WholeNumberBox box;
    box.setRange(0, 100000);
    box.setLocale(QLocale("de_DE"));
    for (const char* text : {"2.5", "2,5"}) {
        QString copy = text;
        int position = 0;
        EXPECT_EQ(box.validate(copy, position), QValidator::Invalid) << text;
    }
    EXPECT_EQ(typed(box, "25"), 25);
}

class TypedNumber : public WindowTest {};

TEST_F(TypedNumber, EnterGivesTheKeysBackToTheDrawing) {
    auto* number = window_->findChild<QDoubleSpinBox*>("distanceNumber");
    ASSERT_NE(number, nullptr);
    window_->tools().setActive(ToolBox::Kind::Eraser);
    number->setFocus();
    number->selectAll();
    for (const Qt::Key k : {Qt::Key_2, Qt::Key_5, Qt::Key_Comma, Qt::Key_5}) key(k);
    key(Qt::Key_Return);
    EXPECT_EQ(document().thresholds().distancePx, 25.5);
    EXPECT_TRUE(surface().hasFocus());
    key(Qt::Key_P);
    EXPECT_EQ(window_->tools().active(), ToolBox::Kind::Pen);
}

TEST_F(TypedNumber, ALetterIsTheWindowsAlsoBeforeEnter) {
    auto* number = window_->findChild<QDoubleSpinBox*>("distanceNumber");
    ASSERT_NE(number, nullptr);
    number->setFocus();
    key(Qt::Key_E);
    EXPECT_EQ(window_->tools().active(), ToolBox::Kind::Eraser);
    number->setFocus();
    number->selectAll();
    key(Qt::Key_9);
    EXPECT_EQ(window_->reading().chosen(), -1) << "a digit is the number's";
    EXPECT_EQ(number->cleanText(), "9");
}

}  // namespace
}  // namespace ew::test
