// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people type them.
#include "ui/number_box.h"

#include <QDockWidget>
#include <QLineEdit>
#include <QTest>

#include "tests/ui/window_fixture.h"
#include "ui/apply_controller.h"
#include "ui/live_reading.h"
#include "ui/panels/message_bar.h"
#include "ui/quantity.h"
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
        EXPECT_EQ(typed(box, "1.234,5"), 1234.5) << language;
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

/// What is typed and refused leaves the 7 that was there, and says so once Enter is pressed.
template <class Box>
void expectRefused(Box& box, const char* text) {
    QStringList told;
    const auto listening =
        QObject::connect(&box, &Box::refused, &box, [&](const QString& why) { told << why; });
    EXPECT_EQ(typed(box, text), 7) << text;
    ASSERT_EQ(told.size(), 1) << text;
    EXPECT_TRUE(told[0].contains(text)) << told[0].toStdString();
    EXPECT_TRUE(box.text().contains(text)) << "it stays to be mended: " << box.text().toStdString();
    QObject::disconnect(listening);
    box.clearFocus();
}

TEST(NumberBox, WhatCannotBeMeantIsRefusedAndNeverAnotherNumber) {
    NumberBox box;
    box.setRange(1, 100);
    box.setDecimals(3);
    box.setSuffix(" mm");
    for (const char* text : {"1.2.3", "1,2,3", "1..5", "1e1", "1x", "x", "5 kg", "5m", "--5",
                             "0x10", "1 2", "500", "0.5", "-5", "1.234.567"}) {
        expectRefused(box, text);
    }
    WholeNumberBox whole;
    whole.setRange(1, 100);
    for (const char* text : {"2.5", "2,5", "1e1", "500", "0", "99999999999", "3 4", "1,000"}) {
        expectRefused(whole, text);
    }
}

TEST(NumberBox, ItsUnitMayBeTyped) {
    NumberBox box;
    box.setRange(1, 100);
    box.setSuffix(" mm");
    for (const char* text : {"5", "5mm", "5 mm", "5 MM", "+5", "5.", "5,00"}) {
        EXPECT_EQ(typed(box, text), 5) << text;
        EXPECT_EQ(box.text(), "5.00 mm");
    }
    WholeNumberBox whole;
    whole.setSuffix(" MiB");
    for (const char* text : {"5", "5MiB", "5 MiB"}) EXPECT_EQ(typed(whole, text), 5) << text;
}

TEST(NumberBox, SumsAndOtherUnitsOfLengthCount) {
    NumberBox box;
    box.setRange(1, 1000);
    box.setSuffix(" mm");
    EXPECT_EQ(typed(box, "120/3 + 2"), 42);
    EXPECT_EQ(box.text(), "42.00 mm");
    EXPECT_EQ(typed(box, "2,5 cm"), 25);
    EXPECT_EQ(typed(box, "1 1/2 in"), 38.1);
    expectRefused(box, "2 in * 3 in");
    expectRefused(box, "4/0");
}

TEST(NumberBox, AWordForItsLeastValueMayBeTyped) {
    NumberBox box;
    box.setRange(-0.5, 10);
    box.setSpecialValueText("auto");
    EXPECT_EQ(typed(box, "auto"), -0.5);
    EXPECT_EQ(box.text(), "auto");
    EXPECT_EQ(typed(box, "3"), 3);
    expectRefused(box, "aut");
}

TEST(NumberBox, AFieldThatIsLeftHasItsNumberAgain) {
    QWidget window;
    NumberBox box(&window);
    window.show();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    box.setValue(7);
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, "1.2.3");
    box.clearFocus();
    EXPECT_EQ(box.value(), 7);
    EXPECT_EQ(box.cleanText(), "7.00");
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

TEST_F(TypedNumber, NoKeyIsAToolsWhileANumberIsTyped) {
    const bool automatic = window_->applyController().automatic();
    window_->findChild<QDockWidget*>("surfacePanel")->raise();
    settle();
    int fields = 0;
    for (QAbstractSpinBox* number : window_->findChildren<QAbstractSpinBox*>()) {
        if (!number->isVisible() || !number->isEnabled()) continue;
        ++fields;
        window_->tools().setActive(ToolBox::Kind::Pen);
        number->setFocus();
        ASSERT_TRUE(number->hasFocus());
        for (int k = Qt::Key_A; k <= Qt::Key_Z; ++k) {
            number->selectAll();
            key(static_cast<Qt::Key>(k));
            EXPECT_EQ(window_->tools().active(), ToolBox::Kind::Pen) << static_cast<char>(k);
            EXPECT_EQ(window_->applyController().automatic(), automatic) << static_cast<char>(k);
            EXPECT_TRUE(number->hasFocus()) << static_cast<char>(k);
        }
        number->selectAll();
        key(Qt::Key_9);
        EXPECT_EQ(window_->reading().chosen(), -1) << "a digit is the number's";
    }
    EXPECT_GE(fields, 4);
}

TEST_F(TypedNumber, WhatIsRefusedIsSaidInTheWindow) {
    auto* number = window_->findChild<QDoubleSpinBox*>("distanceNumber");
    const double before = document().thresholds().distancePx;
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, "1.2.3");
    key(Qt::Key_Return);
    EXPECT_EQ(document().thresholds().distancePx, before);
    EXPECT_TRUE(number->hasFocus()) << "so that it can be mended";
    EXPECT_EQ(window_->messages().text(), "\u201c1.2.3\u201d is not a number; the old one stays.");
    QTest::keyClicks(number, "12.5");
    key(Qt::Key_Return);
    EXPECT_EQ(document().thresholds().distancePx, 12.5);
    EXPECT_TRUE(surface().hasFocus());
}

}  // namespace
}  // namespace ew::test
