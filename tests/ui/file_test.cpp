// SPDX-License-Identifier: GPL-3.0-or-later
// Files as a person opens and writes them: names, questions, what opening must not do.
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QListView>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <functional>

#include "core/document/file_bytes.h"
#include "core/document/sketch_script.h"
#include "tests/document/later_version.h"
#include "tests/ui/window_fixture.h"
#include "ui/actions/file_actions.h"
#include "ui/panels/message_bar.h"

namespace ew::test {
namespace {

using Deed = std::function<void(QDialog&)>;

/// Runs what opens dialogs one after the other, and does one deed in each of them.
void inDialogs(std::vector<Deed> deeds, const std::function<void()>& action) {
    std::size_t done = 0;
    QTimer timer;
    const QWidget* last = nullptr;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (dialog == nullptr || !dialog->isVisible() || dialog == last) return;
        last = dialog;
        if (done == deeds.size()) {
            ADD_FAILURE() << "another dialog: " << dialog->windowTitle().toStdString();
            dialog->reject();
            return;
        }
        deeds[done++](*dialog);
        last = nullptr;
    });
    timer.start(10);
    action();
    EXPECT_EQ(done, deeds.size()) << "dialogs that opened";
}

QLineEdit& nameField(QDialog& dialog) {
    auto* field = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    EXPECT_NE(field, nullptr) << dialog.windowTitle().toStdString();
    return *field;
}

Deed typeName(const QString& name) {
    return [name](QDialog& dialog) {
        QLineEdit& field = nameField(dialog);
        // Typing takes the mark off the file that is there; without the focus it would stay.
        if (auto* list = dialog.findChild<QListView*>(QStringLiteral("listView"))) {
            list->clearSelection();
        }
        // At once: while a path is typed, the dialog selects the folders on the way.
        field.setText(name);
        QTest::keyClick(&field, Qt::Key_Return);
    };
}

void giveUp(QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); }

void replaceIt(QDialog& dialog) {
    for (QAbstractButton* button : dialog.findChildren<QAbstractButton*>()) {
        if (button->text() == QStringLiteral("&Replace")) return button->click();
    }
    ADD_FAILURE() << "nothing to replace in: " << dialog.windowTitle().toStdString();
    dialog.reject();
}

class Files : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        window_->files().setExportUnit(ExportUnit::Millimetre);  // so it is not asked for
    }
    QString path(const QString& name) const { return folder_.filePath(name); }
    std::string bytesOf(const QString& name) const {
        const auto bytes = readFileBytes(path(name), 1U << 26U);
        return bytes ? *bytes : "none";
    }
    QAction* fileAction(const QString& text) {
        for (QAction* action : window_->menuBar()->actions().front()->menu()->actions()) {
            if (action->text().remove('&').startsWith(text)) return action;
        }
        ADD_FAILURE() << text.toStdString();
        return nullptr;
    }
    void trigger(const QString& text) {
        fileAction(text)->trigger();
        settle();
    }
    void makeBox() {
        drawLines(Hand::Mouse, boxLines());
        ASSERT_TRUE(document().apply());
        settle();
    }
    std::string said() { return window_->messages().text().toStdString(); }
};

TEST_F(Files, ANameThatGetsItsEndingReplacesNothingUnasked) {
    makeBox();
    const std::vector<std::array<QString, 3>> table{{"Save as", "box", "box.edgewright"},
                                                    {"Save what was done", "steps", "steps.json"},
                                                    {"Export", "part", "part.obj"},
                                                    {"Screenshot", "view", "view.png"}};
    for (const auto& [action, typed, made] : table) {
        SCOPED_TRACE(action.toStdString());
        ASSERT_TRUE(writeFileBytes(path(made), "mine"));
        inDialogs({typeName(path(typed)), giveUp, giveUp}, [&] { trigger(action); });
        EXPECT_EQ(bytesOf(made), "mine");
        inDialogs({typeName(path(typed)), replaceIt}, [&] { trigger(action); });
        EXPECT_NE(bytesOf(made), "mine");
        EXPECT_FALSE(QFileInfo::exists(path(typed)));
    }
}

TEST_F(Files, SaveAsHasAShortcutAndQuitTooOnEveryDesktop) {
    inDialogs({giveUp}, [&] { key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier); });
    EXPECT_EQ(fileAction("Quit")->shortcut(), QKeySequence(QStringLiteral("Ctrl+Q")));
}

TEST_F(Files, ADotInANameIsNoExtension) {
    makeBox();
    inDialogs({typeName(path("bracket v1.2"))}, [&] { trigger("Save as"); });
    EXPECT_EQ(document().filePath(), path("bracket v1.2.edgewright"));
    EXPECT_TRUE(window_->windowTitle().startsWith("bracket v1.2"));
    inDialogs({typeName(path("bracket v1.2"))}, [&] { trigger("Export"); });
    EXPECT_TRUE(QFileInfo(path("bracket v1.2.obj")).isFile());
    // The dialog would take the file that it proposes, which it finds, for what is set as text.
    ASSERT_TRUE(QFile::remove(path("bracket v1.2.obj")));
    inDialogs({typeName(path("bracket v1.2.STL"))}, [&] { trigger("Export"); });
    EXPECT_TRUE(QFileInfo(path("bracket v1.2.STL")).isFile());
}

TEST_F(Files, TheUnitOfAnExportIsAskedForOnce) {
    makeBox();
    window_->files().setExportUnit({});
    const auto typed = typeName(path("part.obj"));
    inDialogs({typed, giveUp}, [&] { trigger("Export"); });
    EXPECT_FALSE(QFileInfo::exists(path("part.obj"))) << "given up";
    EXPECT_FALSE(window_->files().exportUnit());
    inDialogs({typeName(path("part.3mf"))}, [&] { trigger("Export"); });
    EXPECT_TRUE(QFileInfo::exists(path("part.3mf"))) << "it has a unit of its own";
    const Deed inches = [](QDialog& dialog) {
        auto* unit = dialog.findChild<QComboBox*>(QStringLiteral("exportUnit"));
        ASSERT_NE(unit, nullptr);
        unit->setCurrentIndex(unit->findData(static_cast<int>(ExportUnit::Inch)));
        dialog.accept();
    };
    inDialogs({typed, inches}, [&] { trigger("Export"); });
    EXPECT_TRUE(bytesOf("part.obj").starts_with("# Edgewright, inch"));
    ASSERT_TRUE(QFile::remove(path("part.obj")));
    inDialogs({typed}, [&] { trigger("Export"); });
    EXPECT_TRUE(bytesOf("part.obj").starts_with("# Edgewright, inch"));
}

TEST_F(Files, ADocumentIsNeverCalledAsAScriptIs) {
    makeBox();
    inDialogs({typeName(path("foo.json"))}, [&] { trigger("Save as"); });
    EXPECT_FALSE(QFileInfo::exists(path("foo.json")));
    EXPECT_NE(said().find("foo.json"), std::string::npos) << said();
    EXPECT_TRUE(document().isModified());
}

TEST_F(Files, TheContentTellsADocumentFromAScript) {
    makeBox();
    ASSERT_TRUE(window_->files().saveTo(path("box.edgewright")));
    ASSERT_TRUE(QFile::rename(path("box.edgewright"), path("box.json")));
    ASSERT_TRUE(window_->files().saveScriptTo(path("steps.txt")));
    for (const char* name : {"box.json", "steps.txt"}) {
        document().reset();
        EXPECT_TRUE(window_->files().openPath(path(name))) << name << ": " << said();
        EXPECT_EQ(document().state().bodies.size(), 1U) << name;
    }
}

TEST_F(Files, AFileOfAnotherKindGetsATrueSentence) {
    ASSERT_TRUE(writeFileBytes(path("bh.stl"), "solid bh\nendsolid bh\n"));
    EXPECT_FALSE(window_->files().openPath(path("bh.stl")));
    EXPECT_EQ(said(), "bh.stl is no Edgewright document or sketch script: it holds an STL mesh.");
}

TEST_F(Files, TheProposedNameComesFromTheDocument) {
    makeBox();
    QString proposed;
    const auto look = [&](QDialog& dialog) {
        proposed = nameField(dialog).text();
        giveUp(dialog);
    };
    inDialogs({look}, [&] { trigger("Save as"); });
    EXPECT_EQ(proposed, "Untitled.edgewright");
    ASSERT_TRUE(window_->files().saveScriptTo(path("lamp.json")));
    ASSERT_TRUE(window_->files().openPath(path("lamp.json")));
    inDialogs({look}, [&] { trigger("Save as"); });
    EXPECT_EQ(proposed, "lamp.edgewright");
    ASSERT_TRUE(window_->files().saveTo(path("desk v2.edgewright")));
    inDialogs({look}, [&] { trigger("Export"); });
    EXPECT_EQ(proposed, "desk v2.obj");
    trigger("New");
    inDialogs({look}, [&] { trigger("Save as"); });
    EXPECT_EQ(proposed, "Untitled.edgewright");
}

TEST_F(Files, AFileThatOthersChangedIsNotReplacedUnasked) {
    makeBox();
    ASSERT_TRUE(window_->files().saveTo(path("box.edgewright")));
    drawLine(Hand::Mouse, {100, 100}, {200, 100});
    ASSERT_TRUE(window_->files().saveTo(path("box.edgewright"))) << "its own saving is no change";
    // Another window on the same file.
    Document other(document().state().library);
    ASSERT_TRUE(other.open(path("box.edgewright")));
    ASSERT_TRUE(other.deleteBodies());
    ASSERT_TRUE(other.save(path("box.edgewright")));
    const std::string theirs = bytesOf("box.edgewright");
    drawLine(Hand::Mouse, {100, 150}, {200, 150});
    inDialogs({giveUp}, [&] { key(Qt::Key_S, Qt::ControlModifier); });
    EXPECT_TRUE(bytesOf("box.edgewright") == theirs);
    EXPECT_TRUE(document().isModified());
    EXPECT_NE(said().find("Not saved"), std::string::npos) << said();
    inDialogs({replaceIt}, [&] { trigger("Save"); });
    EXPECT_TRUE(bytesOf("box.edgewright") != theirs);
    EXPECT_FALSE(document().isModified());
}

TEST_F(Files, OpeningAScriptWritesNothing) {
    makeBox();
    SketchScript script = document().recordedScript();
    script.steps.emplace_back(SaveStep{"mine.edgewright"});
    script.steps.emplace_back(ExportStep{"notes.obj"});
    script.steps.emplace_back(OpenStep{"mine.edgewright"});
    const std::size_t first = script.steps.size() - 3;
    for (const char* name : {"mine.edgewright", "notes.obj"}) {
        ASSERT_TRUE(writeFileBytes(path(name), "mine"));
    }
    ASSERT_TRUE(writeFileBytes(path("s.json"), writeSketchScript(script)));
    document().reset();
    ASSERT_TRUE(window_->files().openPath(path("s.json"))) << said();
    EXPECT_EQ(document().state().bodies.size(), 1U);
    EXPECT_EQ(bytesOf("mine.edgewright"), "mine");
    EXPECT_EQ(bytesOf("notes.obj"), "mine");
    EXPECT_TRUE(document().filePath().isEmpty());
    const auto told = [&](std::size_t step, const std::string& what) {
        return said().find(std::to_string(first + step) + " (" + what + ")") != std::string::npos;
    };
    EXPECT_TRUE(told(0, "save mine.edgewright") && told(1, "export notes.obj") &&
                told(2, "open mine.edgewright"))
        << said();
}

TEST_F(Files, SaveAsAsksOnlyAboutTheFileThatItReplaces) {
    makeBox();
    ASSERT_TRUE(writeFileBytes(path("bracket v1.2"), "mine"));
    inDialogs({typeName(path("bracket v1.2"))}, [&] { trigger("Save as"); });
    EXPECT_TRUE(QFileInfo(path("bracket v1.2.edgewright")).isFile());
    EXPECT_EQ(bytesOf("bracket v1.2"), "mine");
    inDialogs({typeName(path("bracket v1.2.edgewright")), replaceIt}, [&] { trigger("Save as"); });
}

TEST_F(Files, RevertingAsksAboutRevertingAndReplacesNoFile) {
    makeBox();
    ASSERT_TRUE(window_->files().saveTo(path("box.edgewright")));
    drawLine(Hand::Mouse, {100, 100}, {200, 100});
    const auto revertIt = [](QDialog& dialog) {
        auto& box = dynamic_cast<QMessageBox&>(dialog);
        EXPECT_FALSE((box.windowTitle() + box.text()).contains("eplac"))
            << box.windowTitle().toStdString() << ": " << box.text().toStdString();
        for (QAbstractButton* button : box.buttons()) {
            EXPECT_NE(button->text(), "&Replace");
            if (button->text().remove('&') == "Revert") return button->click();
        }
        ADD_FAILURE() << "no button for it";
    };
    inDialogs({revertIt}, [&] { trigger("Revert"); });
    EXPECT_FALSE(document().isModified());
    EXPECT_TRUE(document().pendingStrokes().empty());
}

TEST_F(Files, AnExampleIsNoPlaceForOnesOwnFiles) {
    const QString examples = QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/examples");
    ASSERT_TRUE(window_->files().openPath(examples + "/cube.json")) << said();
    QString proposed;
    const auto look = [&](QDialog& dialog) {
        proposed = dynamic_cast<QFileDialog&>(dialog).directory().absolutePath();
        giveUp(dialog);
    };
    inDialogs({look}, [&] { trigger("Export"); });
    EXPECT_FALSE(proposed.startsWith(QDir(examples).absolutePath())) << proposed.toStdString();
    ASSERT_TRUE(window_->files().saveScriptTo(path("lamp.json")));
    ASSERT_TRUE(window_->files().openPath(path("lamp.json")));
    inDialogs({look}, [&] { trigger("Export"); });
    EXPECT_EQ(QDir(proposed).canonicalPath(), QDir(folder_.path()).canonicalPath());
}

TEST_F(Files, AnErrorIsGoneOnceSomethingElseIsBegun) {
    makeBox();
    const auto fails = [&] {
        inDialogs({typeName(path("foo.json"))}, [&] { trigger("Save as"); });
        return said().find("foo.json") != std::string::npos;
    };
    ASSERT_TRUE(fails());
    for (const char* next : {"Save as", "Save a copy", "Export", "Screenshot", "Open\u2026"}) {
        std::string seen = "none";
        const auto look = [&](QDialog& dialog) {
            seen = said();
            giveUp(dialog);
        };
        inDialogs({look}, [&] { trigger(QString::fromUtf8(next)); });
        EXPECT_EQ(seen.find("foo.json"), std::string::npos) << next << ": " << seen;
        ASSERT_TRUE(fails());
    }
}

TEST_F(Files, WhatALaterVersionWroteIsReadOnly) {
    drawLines(Hand::Mouse, boxLines());
    ASSERT_TRUE(document().save(path("plain.edgewright")));
    const QString file = path("later.edgewright");
    ASSERT_TRUE(writeFileBytes(file, ofLaterVersion(bytesOf("plain.edgewright"), "2")));
    ASSERT_TRUE(window_->files().openPath(file));
    EXPECT_EQ(document().pendingStrokes().size(), boxLines().size());
    EXPECT_TRUE(window_->windowTitle().contains(QStringLiteral("(read-only)")));
    EXPECT_NE(said().find("later version"), std::string::npos) << said();

    // Save asks for another name.
    const std::string before = bytesOf("later.edgewright");
    inDialogs({typeName(path("own"))}, [&] { key(Qt::Key_S, Qt::ControlModifier); });
    EXPECT_EQ(bytesOf("later.edgewright"), before);
    EXPECT_EQ(document().filePath(), path("own.edgewright"));
    EXPECT_FALSE(window_->windowTitle().contains(QStringLiteral("(read-only)")));
}

}  // namespace
}  // namespace ew::test
