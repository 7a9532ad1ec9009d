// SPDX-License-Identifier: GPL-3.0-or-later
// The window in German.
#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QLocale>
#include <QMenuBar>
#include <QTranslator>
#include <QUndoStack>

#include "tests/ui/window_fixture.h"
#include "ui/app_setup.h"

namespace ew::test {
namespace {

class German : public WindowTest {
  protected:
    void SetUp() override {
        ASSERT_TRUE(translator_.load(QLocale("de"), "edgewright", "_", ":/translations"));
        // On top of the English that main() chose; taken off again for the other tests.
        ASSERT_TRUE(QCoreApplication::installTranslator(&translator_));
        WindowTest::SetUp();
    }
    void TearDown() override {
        WindowTest::TearDown();
        QCoreApplication::removeTranslator(&translator_);
    }

    QTranslator translator_;
};

TEST_F(German, MenusPanelsAndPluralsAreGerman) {
    QStringList menus;
    for (const QAction* a : window_->menuBar()->actions()) menus << a->text();
    EXPECT_EQ(menus, (QStringList{"&Datei", "&Bearbeiten", "&Ansicht", "&Zeichnung", "&Hilfe"}));
    const auto edges = [](int n) {
        return QCoreApplication::translate("ew::GraphPanel", "%n edge(s)", nullptr, n);
    };
    EXPECT_EQ(edges(1), "1 Kante");
    EXPECT_EQ(edges(9), "9 Kanten");
    drawLines(Hand::Mouse, boxLines());
    ASSERT_TRUE(document().apply());
    EXPECT_EQ(document().undoStack().text(0).section(' ', -1), "erzeugen");
}

/// Texts of buttons and labels that get less room than they ask for.
QStringList cutOff(const QWidget& window) {
    QStringList found;
    for (const QWidget* w : window.findChildren<QWidget*>()) {
        if (!w->isVisible()) continue;
        QString text;
        if (const auto* button = qobject_cast<const QAbstractButton*>(w)) text = button->text();
        if (const auto* label = qobject_cast<const QLabel*>(w)) {
            text = label->text();
            if (label->wordWrap() && w->height() < label->heightForWidth(w->width())) found << text;
            if (label->wordWrap()) continue;
        }
        if (!text.isEmpty() && w->width() < w->sizeHint().width()) found << text;
    }
    return found;
}

TEST_F(German, NothingIsCutOff) {
    const auto complaints = [&] {
        QApplication::processEvents();  // layouts ask for a second turn
        return cutOff(*window_).join(" | ").toStdString();
    };
    EXPECT_EQ(complaints(), "");
    drawLines(Hand::Mouse, boxLines());
    EXPECT_EQ(complaints(), "");
    ASSERT_TRUE(document().apply());
    settle();
    EXPECT_EQ(complaints(), "");
}

TEST(Language, OneWithoutATranslationIsRefused) {
    for (const char* code : {"tlh", "fr", "C", "../de", "nonsense"}) {
        const QLocale before;
        const auto chosen = chooseLanguage(code);
        ASSERT_FALSE(chosen) << code;
        EXPECT_EQ(chosen.error().code, Errc::BadValue);
        EXPECT_NE(chosen.error().message.find(code), std::string::npos);
        EXPECT_EQ(QLocale(), before);
    }
}

}  // namespace
}  // namespace ew::test
