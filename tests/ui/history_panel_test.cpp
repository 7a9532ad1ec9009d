// SPDX-License-Identifier: GPL-3.0-or-later
// The history as a person uses it: names, pictures, a step that is changed, compacting; and what an
// export asks.
#include "ui/panels/history_panel.h"

#include <QAbstractItemModel>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QIcon>
#include <QInputDialog>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QUndoStack>

#include "core/document/file_bytes.h"
#include "tests/ui/window_fixture.h"
#include "ui/actions/file_actions.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/step_dialog.h"
#include "ui/panels/message_bar.h"

namespace ew::test {
namespace {

class History : public WindowTest {
  protected:
    HistoryPanel& panel() { return *window_->findChild<HistoryPanel*>(); }
    QListView& list() { return *window_->findChild<QListView*>("historyList"); }
    QString text(int row) { return list().model()->index(row, 0).data().toString(); }
    void drawBoxAndFillet() {
        drawLines(Hand::Mouse, boxLines());
        key(Qt::Key_Return);
        FilletRequest request;
        request.radius = 4.0;
        ASSERT_TRUE(document().fillet(request));
        SubdivisionSettings smooth;
        smooth.on = true;
        ASSERT_TRUE(document().subdivide(smooth));
    }
    template <class Dialog, class Deed>
    void inDialog(const Deed& deed, const std::function<void()>& action) {
        bool seen = false;
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, [&] {
            auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr || !dialog->isVisible() || seen) return;
            seen = true;
            deed(*dialog);
        });
        timer.start(10);
        action();
        EXPECT_TRUE(seen) << "no dialog";
    }
};

TEST_F(History, ANameStandsInPlaceOfTheStep) {
    drawBoxAndFillet();
    inDialog<QInputDialog>(
        [](QInputDialog& dialog) {
            dialog.setTextValue("  before the tray ");
            dialog.accept();
        },
        [&] { panel().nameState(1); });
    EXPECT_EQ(text(1), "before the tray");
    EXPECT_EQ(document().stateName(1), "before the tray");
    EXPECT_EQ(text(2).toStdString(), "Fillet 12 edges");
}

TEST_F(History, EveryStateWithASolidHasAPictureOfItsOwn) {
    drawBoxAndFillet();
    const auto picture = [&](int row) {
        const QIcon icon = list().model()->index(row, 0).data(Qt::DecorationRole).value<QIcon>();
        return icon.pixmap(list().iconSize()).toImage();
    };
    const QImage none = picture(0);
    EXPECT_TRUE(QTest::qWaitFor([&] { return picture(1) != none && picture(2) != none; }, 20000));
    EXPECT_NE(picture(1), picture(2)) << "the fillet is seen";
}

TEST_F(History, AStepInTheMiddleIsChangedInItsDialog) {
    drawBoxAndFillet();
    inDialog<StepDialog>(
        [](StepDialog& dialog) {
            auto* radius = dialog.findChild<QDoubleSpinBox*>();
            ASSERT_NE(radius, nullptr);
            EXPECT_EQ(radius->value(), 4.0);
            radius->setValue(7.0);
            dialog.accept();
        },
        [&] { panel().changeStep(2); });
    ASSERT_EQ(document().undoStack().count(), 3);
    EXPECT_EQ(document().undoStack().index(), 3);
    const EdgeRef any{0, 0};
    EXPECT_EQ(document().state().surface.radius(any), 7.0);
    EXPECT_TRUE(document().state().surface.subdivision.on);
    ASSERT_TRUE(document().canTakeBackHistory());
    document().takeBackHistory();
    EXPECT_EQ(document().state().surface.radius(any), 4.0);
}

TEST_F(History, AnotherReadingIsChosenInTheMiddle) {
    drawLines(Hand::Mouse, prismLines());
    key(Qt::Key_Return);
    ASSERT_EQ(document().state().bodies.size(), 1U);
    FilletRequest request;
    request.radius = 2.0;
    ASSERT_TRUE(document().fillet(request));
    const double before = document().stateAt(1)->bodies[0].solid.volume();
    inDialog<StepDialog>(
        [](StepDialog& dialog) {
            auto* readings = dialog.findChild<QListWidget*>("stepReadings");
            ASSERT_NE(readings, nullptr);
            ASSERT_GT(readings->count(), 1);
            readings->setCurrentRow(readings->currentRow() == 0 ? 1 : 0);
            dialog.accept();
        },
        [&] { panel().changeStep(1); });
    ASSERT_EQ(document().undoStack().count(), 2);
    EXPECT_NE(document().stateAt(1)->bodies[0].solid.volume(), before);
}

TEST_F(History, CompactingAsksFirst) {
    drawBoxAndFillet();
    const auto press = [](const QString& text) {
        return [text](QMessageBox& box) {
            for (auto* button : box.findChildren<QPushButton*>()) {
                if (button->text().remove('&') == text) return button->click();
            }
            box.reject();
        };
    };
    inDialog<QMessageBox>(press("Cancel"), [&] { panel().compact(); });
    EXPECT_EQ(document().undoStack().count(), 3);
    inDialog<QMessageBox>(press("Compact"), [&] { panel().compact(); });
    EXPECT_EQ(document().undoStack().count(), 1);
    EXPECT_TRUE(document().state().surface.subdivision.on);
}

TEST_F(History, TheUnitOfAnExportIsAskedOnceAndRemembered) {
    drawBoxAndFillet();
    ExportDialog dialog({ExportUnit::Millimetre, {QStringLiteral("one")}});
    auto* unit = dialog.findChild<QComboBox*>("exportUnit");
    ASSERT_NE(unit, nullptr);
    unit->setCurrentIndex(unit->findData(static_cast<int>(ExportUnit::Inch)));
    EXPECT_EQ(dialog.unit(), ExportUnit::Inch);
    EXPECT_TRUE(dialog.bodies().empty());
    EXPECT_EQ(dialog.findChild<QListWidget*>("exportBodies"), nullptr) << "there is only one";

    ExportDialog several(
        {std::nullopt, {QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")}});
    EXPECT_EQ(several.findChild<QComboBox*>("exportUnit"), nullptr);
    auto* bodies = several.findChild<QListWidget*>("exportBodies");
    ASSERT_NE(bodies, nullptr);
    bodies->item(1)->setCheckState(Qt::Unchecked);
    EXPECT_EQ(several.bodies(), (std::vector<int>{0, 2}));

    ExportOptions options;
    options.unit = ExportUnit::Inch;
    ASSERT_TRUE(window_->files().exportTo(folder_.filePath("a.obj"), options));
    EXPECT_TRUE(window_->messages().text().contains("inches"));
    EXPECT_TRUE(
        readFileBytes(folder_.filePath("a.obj"), 1U << 26U)->starts_with("# Edgewright, inch\n"));
}

TEST_F(History, AnExportThatIsGivenUpLeavesNothing) {
    drawBoxAndFillet();
    ExportOptions options;
    options.progress = [](double) { return false; };
    const auto done = document().exportTo(folder_.filePath("a.stl"), options);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, Errc::Cancelled);
    EXPECT_FALSE(QFileInfo::exists(folder_.filePath("a.stl")));
}

}  // namespace
}  // namespace ew::test
