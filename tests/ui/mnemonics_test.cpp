// SPDX-License-Identifier: GPL-3.0-or-later
// Alt and a letter mean one thing in the window, and a letter one thing in a menu, in every
// language.
#include <QAbstractButton>
#include <QCoreApplication>
#include <QDir>
#include <QKeySequence>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTranslator>
#include <map>

#include "core/tlib/family.h"
#include "tests/ui/window_fixture.h"
#include "ui/template_editor/template_editor.h"

namespace ew::test {
namespace {

class Mnemonics : public WindowTest {};

/// Tells which texts share a mnemonic.
void expectUnique(const QStringList& texts, const std::string& where) {
    std::map<QString, QString> taken;
    for (const QString& text : texts) {
        const QKeySequence key = QKeySequence::mnemonic(text);
        if (key.isEmpty()) continue;
        const auto [other, isNew] = taken.emplace(key.toString(), text);
        EXPECT_TRUE(isNew) << where << ": " << key.toString().toStdString() << " is \""
                           << other->second.toStdString() << "\" and \"" << text.toStdString()
                           << '"';
    }
}

void checkMenu(const QMenu& menu, const std::string& language) {
    QStringList texts;
    for (const QAction* action : menu.actions()) {
        texts << action->text();
        if (action->menu() != nullptr) checkMenu(*action->menu(), language);
    }
    expectUnique(texts, language + ", menu " + menu.title().toStdString());
}

void checkWindow(const QMainWindow& window, const std::string& language) {
    QStringList texts;
    for (const QAction* action : window.menuBar()->actions()) {
        texts << action->text();
        checkMenu(*action->menu(), language);
    }
    EXPECT_GE(texts.size(), 6);
    for (const auto* label : window.findChildren<QLabel*>()) {
        if (label->buddy() != nullptr) texts << label->text();
    }
    for (const auto* button : window.findChildren<QAbstractButton*>()) texts << button->text();
    EXPECT_GE(texts.size(), 20);
    expectUnique(texts, language);
}

void checkEditor(const TemplateEditor& editor, const std::string& language) {
    QStringList texts;
    for (const auto* label : editor.findChildren<QLabel*>()) {
        if (label->buddy() != nullptr) texts << label->text();
    }
    for (const auto* button : editor.findChildren<QAbstractButton*>()) texts << button->text();
    for (const auto* pages : editor.findChildren<QTabWidget*>()) {
        for (int i = 0; i < pages->count(); ++i) texts << pages->tabText(i);
    }
    EXPECT_GE(texts.size(), 20);
    expectUnique(texts, language + ", template editor");
    for (const auto* button : editor.findChildren<QPushButton*>()) {
        if (button->menu() != nullptr) checkMenu(*button->menu(), language);
    }
}

TEST_F(Mnemonics, MeanOneThingInEveryLanguage) {
    const QStringList files = QDir(":/translations").entryList({"edgewright_*.qm"});
    ASSERT_GE(files.size(), 2);
    for (const QString& file : files) {
        QTranslator translator;
        ASSERT_TRUE(translator.load(":/translations/" + file));
        ASSERT_TRUE(QCoreApplication::installTranslator(&translator));
        const QTemporaryDir work;
        MainWindow window(document().state().library, *appearance_,
                          MainWindowOptions{.remember = false, .workFolder = work.path()});
        checkWindow(window, file.toStdString());
        for (const bool replaces : {false, true}) {
            Template tmpl = familyTemplate(Family::Prism, 6);
            const TemplateEditor editor(window.document(), *appearance_, std::move(tmpl), replaces,
                                        &window);
            checkEditor(editor, file.toStdString());
        }
        QCoreApplication::removeTranslator(&translator);
    }
}

}  // namespace
}  // namespace ew::test
