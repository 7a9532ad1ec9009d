// SPDX-License-Identifier: GPL-3.0-or-later
// Several solids in the window: the list of them, and faces that are pulled.
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QUndoStack>
#include <functional>

#include "tests/ui/window_fixture.h"
#include "ui/dialogs/move_dialog.h"
#include "ui/edge_selection.h"
#include "ui/number_box.h"
#include "ui/panels/body_panel.h"
#include "ui/panels/message_bar.h"
#include "ui/tools/tool_box.h"
#include "ui/viewport/viewport_widget.h"

namespace ew::test {
namespace {

class Bodies : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        drawLines(Hand::Mouse, boxLines());
        (void)document().apply();
        settle();
        ASSERT_EQ(document().state().bodies.size(), 1U);
    }
    BodyPanel& panel() { return *window_->findChild<BodyPanel*>(); }
    QListWidget& list() { return *window_->findChild<QListWidget*>(QStringLiteral("bodyList")); }
    NumberBox& distance() {
        return *window_->findChild<NumberBox*>(QStringLiteral("pullDistance"));
    }
    double volume(std::size_t body = 0) { return document().state().bodies[body].solid.volume(); }
    /// The middle of the face that looks up, in the view, and where it is seen when it is as much
    /// higher.
    Vec2 topAt(double higher) {
        const Body& body = document().state().bodies[0];
        for (std::size_t f = 0; f < body.solid.faces().size(); ++f) {
            if (body.pose.directionToWorld(body.solid.faces()[f].normal).z() < 0.99) continue;
            const Vec3 p = pointInFace(body, static_cast<int>(f));
            return document().camera().project(p + higher * Vec3::UnitZ());
        }
        ADD_FAILURE() << "no face looks up";
        return Vec2::Zero();
    }
    double topArea() {
        const auto before = volume();
        const auto face = faceUnder(document().state().bodies, document().camera(), topAt(0));
        const auto after = document().pulled({*face, 1.0, PullWalls::Follow});
        return (*after)->bodies[0].solid.volume() - before;
    }
    void drag(const Vec2& from, const Vec2& to, Hand hand = Hand::Mouse) {
        press(hand, from);
        for (int i = 1; i <= 5; ++i) {
            move(hand, from + (to - from) * i / 5);
            settle();
        }
        release(hand, to);
        settle();
    }
    void type(const QString& text) {
        distance().setFocus();
        distance().selectAll();
        QTest::keyClicks(&distance(), text);
        QTest::keyClick(&distance(), Qt::Key_Return);
        settle();
    }
};

TEST_F(Bodies, AFaceIsPulledByThePenAndCorrectedByANumber) {
    const double before = volume();
    const double area = topArea();
    const int steps = document().undoStack().index();
    key(Qt::Key_L);
    ASSERT_EQ(window_->tools().active(), ToolBox::Kind::Pull);
    EXPECT_TRUE(distance().isVisible());
    drag(topAt(0), topAt(20), Hand::Pen);
    EXPECT_EQ(document().undoStack().index(), steps + 1);
    const double pulled = (volume() - before) / area;
    EXPECT_NEAR(pulled, 20.0, 1.5);
    EXPECT_NEAR(distance().value(), pulled, 1e-6);
    // A round number of millimetres.
    EXPECT_NEAR(pulled, std::round(pulled * 10) / 10, 1e-6);

    type(QStringLiteral("12,5"));
    EXPECT_NEAR(volume(), before + 12.5 * area, 1e-6 * before);
    EXPECT_EQ(document().undoStack().index(), steps + 1);
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NEAR(volume(), before, 1e-9 * before);
}

TEST_F(Bodies, AClickTakesAFaceForATypedNumber) {
    const double before = volume();
    const double area = topArea();
    key(Qt::Key_L);
    EXPECT_FALSE(distance().isEnabled());
    press(Hand::Mouse, topAt(0));
    release(Hand::Mouse, topAt(0));
    settle();
    ASSERT_TRUE(distance().isEnabled());
    type(QStringLiteral("-4"));
    EXPECT_NEAR(volume(), before - 4 * area, 1e-6 * before);
    // What cannot be is told, and nothing is lost.
    type(QStringLiteral("-900"));
    EXPECT_NEAR(volume(), before - 4 * area, 1e-6 * before);
    EXPECT_FALSE(window_->messages().text().isEmpty());
}

TEST_F(Bodies, EscapeLeavesTheSolidAsItWas) {
    const double before = volume();
    const int steps = document().undoStack().index();
    key(Qt::Key_L);
    press(Hand::Mouse, topAt(0));
    move(Hand::Mouse, topAt(15));
    settle();
    key(Qt::Key_Escape);
    release(Hand::Mouse, topAt(15));
    settle();
    EXPECT_EQ(volume(), before);
    EXPECT_EQ(document().undoStack().index(), steps);
    key(Qt::Key_P);
    EXPECT_FALSE(distance().isVisible());
}

TEST_F(Bodies, AnOutlineOnAFaceIsPulledOut) {
    const double before = volume();
    const std::size_t faces = document().state().bodies[0].solid.faces().size();
    const Body& body = document().state().bodies[0];
    const auto face = faceUnder(document().state().bodies, document().camera(), topAt(0));
    // Half as large as the face, round its middle.
    std::vector<Vec3> corners;
    const auto& loop = body.solid.faces()[static_cast<std::size_t>(face->face)].loops[0];
    Vec3 middle = Vec3::Zero();
    for (const int v : loop) {
        corners.push_back(body.pose.toWorld(body.solid.vertices()[static_cast<std::size_t>(v)]));
        middle += corners.back() / static_cast<double>(loop.size());
    }
    std::vector<std::array<Vec2, 2>> lines;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto half = [&](std::size_t i) {
            return document().camera().project(Vec3(0.5 * (middle + corners[i % corners.size()])));
        };
        lines.push_back({half(k), half(k + 1)});
    }
    const double area = topArea() / 4;
    drawLines(Hand::Mouse, lines);
    settle();
    EXPECT_EQ(document().pendingStrokes().size(), lines.size());
    key(Qt::Key_L);
    const Vec2 from = document().camera().project(middle);
    drag(from, document().camera().project(Vec3(middle + 10 * Vec3::UnitZ())));
    EXPECT_TRUE(document().pendingStrokes().empty());
    EXPECT_EQ(document().state().bodies[0].solid.faces().size(), faces + 5);
    EXPECT_NEAR((volume() - before) / area, 10.0, 1.0);
}

TEST_F(Bodies, TheListShowsHidesAndNames) {
    ASSERT_EQ(list().count(), 1);
    EXPECT_EQ(list().item(0)->text(), QStringLiteral("Solid 1"));
    list().item(0)->setCheckState(Qt::Unchecked);
    settle();
    EXPECT_TRUE(document().state().bodies[0].hidden);
    EXPECT_FALSE(faceUnder(document().state().bodies, document().camera(), topAt(0)));
    list().item(0)->setCheckState(Qt::Checked);
    list().item(0)->setText(QStringLiteral("Sockel"));
    settle();
    EXPECT_EQ(document().state().bodies[0].name, "Sockel");
    key(Qt::Key_Z, Qt::ControlModifier);
    key(Qt::Key_Z, Qt::ControlModifier);
    settle();
    EXPECT_EQ(list().item(0)->text(), QStringLiteral("Solid 1"));
    EXPECT_EQ(list().item(0)->checkState(), Qt::Unchecked);
}

TEST_F(Bodies, AreCopiedMovedJoinedAndDeleted) {
    const double one = volume();
    list().item(0)->setSelected(true);
    panel().duplicate();
    settle();
    ASSERT_EQ(document().state().bodies.size(), 2U);
    EXPECT_TRUE(list().item(1)->isSelected());
    EXPECT_FALSE(list().item(0)->isSelected());

    // By numbers, in the dialog.
    QTimer::singleShot(50, [] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr);
        dialog->findChild<NumberBox*>(QStringLiteral("moveByX"))->setValue(-10);
        dialog->findChild<NumberBox*>(QStringLiteral("movePercent"))->setValue(50);
        dialog->accept();
    });
    panel().move();
    settle();
    EXPECT_NEAR(volume(1), one / 8, 1e-9 * one);

    list().item(0)->setSelected(true);
    list().item(1)->setSelected(true);
    panel().combine(BooleanKind::Add);
    settle();
    // They do not touch: that is said, and both are there.
    EXPECT_EQ(document().state().bodies.size(), 2U);
    EXPECT_NE(window_->messages().text().indexOf(QStringLiteral("touch")), -1)
        << window_->messages().text().toStdString();

    list().clearSelection();
    list().item(1)->setSelected(true);
    // Where no window manager gives the window the keys back.
    window_->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    surface().setFocus();
    key(Qt::Key_Delete, Qt::ControlModifier);
    settle();
    EXPECT_EQ(document().state().bodies.size(), 1U);
    EXPECT_NEAR(volume(), one, 1e-9 * one);
}

/// The action with this text (without its mnemonic), wherever it stands.
QAction* actionCalled(const QWidget& window, const QString& text) {
    for (QAction* action : window.findChildren<QAction*>()) {
        if (QString(action->text()).remove(QLatin1Char('&')) == text) return action;
    }
    return nullptr;
}

TEST_F(Bodies, AreDoneOnBothSidesOfAMirrorPlane) {
    QAction* across = actionCalled(*window_, QStringLiteral("Left and right, across X"));
    QAction* drop = actionCalled(*window_, QStringLiteral("No mirror plane"));
    ASSERT_TRUE(across != nullptr && drop != nullptr);
    EXPECT_FALSE(drop->isEnabled());
    across->trigger();
    ASSERT_TRUE(document().state().mirror);
    const Vec3 middle = middleOf(document().state().bodies[0]);
    EXPECT_NEAR(document().state().mirror->height(middle), 0.0, 1e-9);
    EXPECT_TRUE(drop->isEnabled());
    // Its outline is drawn, and goes with the plane.
    settle();
    const QImage with = window_->findChild<ViewportWidget*>()->grabFramebuffer();
    drop->trigger();
    settle();
    EXPECT_NE(window_->findChild<ViewportWidget*>()->grabFramebuffer(), with);
    EXPECT_FALSE(document().state().mirror);
    document().undoStack().undo();
    EXPECT_TRUE(document().state().mirror);
}

TEST_F(Bodies, AreSetLevelUnlessThatIsSwitchedOff) {
    QAction* level = actionCalled(*window_, QStringLiteral("Set new solids level"));
    ASSERT_NE(level, nullptr);
    EXPECT_TRUE(level->isChecked());
    const auto lowest = [&] { return worldBounds(document().state().bodies[0])[0].z(); };
    // SetUp() applied without the window.
    EXPECT_NE(lowest(), 0.0);
    (void)document().undo();
    settle();
    QTest::keyClick(window_.get(), Qt::Key_Return);
    settle();
    ASSERT_EQ(document().state().bodies.size(), 1U);
    EXPECT_NEAR(lowest(), 0.0, 1e-9);
    (void)document().undo();
    level->trigger();
    settle();
    QTest::keyClick(window_.get(), Qt::Key_Return);
    settle();
    ASSERT_EQ(document().state().bodies.size(), 1U);
    EXPECT_GT(std::abs(lowest()), 1e-6);
}

}  // namespace
}  // namespace ew::test
