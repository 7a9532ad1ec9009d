// SPDX-License-Identifier: GPL-3.0-or-later
// Fillet, surface and strokes on it, by hand.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "tests/ui/window_fixture.h"
#include "ui/apply_controller.h"
#include "ui/panels/message_bar.h"
#include "ui/surface_controller.h"
#include "ui/tools/tool_box.h"
#include "ui/viewport/viewport_widget.h"

namespace ew::test {

namespace {

class SurfacePanelTest : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        window_->applyController().setAutomatic(false);
        for (const auto& line : boxLines()) {
            Stroke stroke;
            for (int i = 0; i <= 20; ++i) {
                stroke.samples.push_back({line[0] + (line[1] - line[0]) * (i / 20.0), 1.0, 0.0});
            }
            ASSERT_TRUE(document().addStroke(std::move(stroke)));
        }
        ASSERT_TRUE(document().apply());
        window_->findChild<QDockWidget*>("surfacePanel")->raise();
        settle();
    }
    template <class W>
    W* find(const char* name) {
        W* w = window_->findChild<W*>(QLatin1String(name));
        EXPECT_NE(w, nullptr) << name;
        return w;
    }
    SurfaceController& surfaceController() { return window_->surface(); }
    int step() { return document().undoStack().index(); }
    /// px of the middle of an edge of the box.
    Vec2 middleOf(int edge) {
        const Body& body = document().state().bodies[0];
        const auto& ends = body.solid.edges()[static_cast<std::size_t>(edge)].ends;
        const auto corner = [&](int i) {
            return body.pose.toWorld(body.solid.vertices()[static_cast<std::size_t>(i)]);
        };
        return document().camera().project(0.5 * (corner(ends[0]) + corner(ends[1])));
    }
    /// The face that is seen in the middle of the box, and a point in it [px].
    Vec2 middleOfFace(const Vec3& normal) {
        const Body& body = document().state().bodies[0];
        for (const SolidFace& face : body.solid.faces()) {
            if (body.pose.directionToWorld(face.normal).dot(normal) < 0.9) continue;
            Vec3 sum = Vec3::Zero();
            for (const int v : face.loops[0]) {
                sum += body.pose.toWorld(body.solid.vertices()[static_cast<std::size_t>(v)]);
            }
            return document().camera().project(sum / static_cast<double>(face.loops[0].size()));
        }
        ADD_FAILURE();
        return Vec2::Zero();
    }
    void click(const Vec2& at) {
        press(Hand::Mouse, at);
        release(Hand::Mouse, at);
    }
};

}  // namespace

TEST_F(SurfacePanelTest, DraggingTheRadiusShowsItAndLettingGoMakesOneStep) {
    auto* slider = find<QSlider>("radiusSlider");
    const int before = step();
    QSignalSpy changed(&surfaceController(), &SurfaceController::changed);
    slider->setSliderDown(true);
    for (const int value : {500, 550, 600}) slider->setValue(value);
    EXPECT_EQ(step(), before) << "nothing is done while the slider is held";
    EXPECT_FALSE(document().shape()->hasCage());
    surfaceController().settle();
    EXPECT_GE(changed.count(), 1) << "the preview came";
    slider->setSliderDown(false);
    surfaceController().settle();
    EXPECT_EQ(step(), before + 1);
    EXPECT_EQ(document().undoStack().undoText(), QStringLiteral("Fillet 12 edges"));
    const double radius = document().state().surface.radius({0, 0});
    EXPECT_NEAR(radius, find<QDoubleSpinBox>("radiusNumber")->value(), 1e-9);

    // Dragged again: the same step, with another radius.
    slider->setSliderDown(true);
    slider->setValue(700);
    slider->setSliderDown(false);
    surfaceController().settle();
    EXPECT_EQ(step(), before + 1);
    EXPECT_GT(document().state().surface.radius({0, 0}), radius);
    ASSERT_TRUE(document().undo());
    EXPECT_FALSE(document().shape()->hasCage());
}

TEST_F(SurfacePanelTest, EnterEndsANumberAndAppliesNothing) {
    auto* radius = find<QDoubleSpinBox>("radiusNumber");
    const int before = step();
    radius->setFocus();
    radius->selectAll();
    key(Qt::Key_5);
    key(Qt::Key_Return);
    surfaceController().settle();
    EXPECT_EQ(step(), before + 1);
    EXPECT_NEAR(document().state().surface.radius({0, 0}), 5.0, 1e-9);
}

TEST_F(SurfacePanelTest, AWindowMayGoAwayWhileANumberIsTyped) {
    auto* radius = find<QDoubleSpinBox>("radiusNumber");
    radius->setFocus();
    radius->selectAll();
    key(Qt::Key_5);
    EXPECT_FALSE(document().state().surface.hasFillet());
    window_.reset();  // commits to a document that is still there
}

TEST_F(SurfacePanelTest, ADragThatIsTooSlowIsShownCoarserUntilItRests) {
    SubdivisionSettings fine;
    fine.on = true;
    fine.levels = 4;
    surfaceController().commitSubdivision(fine);
    surfaceController().settle();
    auto* slider = find<QSlider>("radiusSlider");
    const auto shown = [&] {
        const auto& surface = window_->viewport().shownShape()->bodies[0].surface;
        return surface ? surface->triangles.size() : 0;  // none: the cage alone
    };
    surfaceController().setStepBudget(0.0);  // no machine is that fast
    slider->setSliderDown(true);
    std::vector<std::size_t> counts;
    for (const int value : {500, 510, 520, 525, 530}) {
        slider->setValue(value);
        surfaceController().settle();
        counts.push_back(shown());
        EXPECT_TRUE(QTest::qWaitFor([&] { return !surfaceController().waitsForFrame(); }));
    }
    EXPECT_EQ(counts[1], counts[0] / 4) << "a level less";
    EXPECT_EQ(counts[2], counts[0] / 16);
    EXPECT_EQ(counts[3], counts[0] / 64);
    EXPECT_EQ(counts[4], 0U);
    EXPECT_TRUE(QTest::qWaitFor([&] { return shown() == counts[0]; })) << "whole where it rests";
    slider->setValue(535);
    surfaceController().settle();
    EXPECT_LT(shown(), counts[0]);
    slider->setSliderDown(false);
    surfaceController().settle();
    EXPECT_EQ(shown(), counts[0]);
    EXPECT_EQ(document().shape()->bodies[0].surface->triangles.size(), counts[0]);
    EXPECT_EQ(document().state().surface.subdivision.levels, 4);

    // A machine that has time to spare shows all of it.
    surfaceController().setStepBudget(1e9);
    slider->setSliderDown(true);
    for (int value = 540; value < 545; ++value) {
        slider->setValue(value);
        surfaceController().settle();
        EXPECT_TRUE(QTest::qWaitFor([&] { return !surfaceController().waitsForFrame(); }));
    }
    EXPECT_EQ(shown(), counts[0]);
    slider->setSliderDown(false);
    surfaceController().settle();
}

TEST_F(SurfacePanelTest, TooLargeARadiusListsTheClampedEdges) {
    auto* list = find<QListWidget>("clampedList");
    EXPECT_FALSE(list->isVisible());
    find<QDoubleSpinBox>("radiusNumber")->setValue(500);
    surfaceController().settle();
    settle();
    EXPECT_EQ(list->count(), static_cast<int>(document().shape()->clamped.size()));
    ASSERT_GT(list->count(), 0);
    EXPECT_TRUE(list->isVisibleTo(list->parentWidget()));
    EXPECT_TRUE(list->item(0)->text().contains("instead of 500 mm"));
    EXPECT_TRUE(window_->messages().text().contains("room"));
    emit list->itemClicked(list->item(0));
    EXPECT_EQ(surfaceController().selection().edges().size(), 1U);
}

TEST_F(SurfacePanelTest, EdgesArePickedByClickLoopAndFace) {
    window_->tools().setActive(ToolBox::Kind::PickEdge);
    EdgeSelection& selection = surfaceController().selection();
    click(middleOf(0));
    ASSERT_EQ(selection.edges().size(), 1U);
    EXPECT_EQ(selection.edges()[0], (EdgeRef{0, 0}));
    EXPECT_EQ(find<QComboBox>("edgeChoice")->currentIndex(), 3);
    modifiers_ = Qt::ShiftModifier;
    click(middleOf(5));
    EXPECT_EQ(selection.edges().size(), 2U) << "Shift adds";
    click(middleOf(5));
    EXPECT_EQ(selection.edges().size(), 1U) << "and takes out";
    modifiers_ = Qt::NoModifier;

    window_->tools().setPickMode(PickMode::Face);
    click(middleOfFace({0, 0, 1}));
    EXPECT_EQ(selection.edges().size(), 4U);
    find<QPushButton>("filletButton")->click();
    surfaceController().settle();
    EXPECT_EQ(document().undoStack().undoText(), QStringLiteral("Fillet 4 edges"));

    window_->tools().setPickMode(PickMode::Loop);
    click(middleOf(0));
    EXPECT_EQ(selection.edges().size(), 4U);
    window_->tools().setPickMode(PickMode::Edge);
    click({20, 20});
    EXPECT_TRUE(selection.edges().empty()) << "beside everything";
    EXPECT_TRUE(document().pendingStrokes().empty()) << "picking draws nothing";
    find<QPushButton>("sharpenButton");
    EXPECT_FALSE(find<QPushButton>("filletButton")->isEnabled());
}

TEST_F(SurfacePanelTest, TheSurfaceFollowsItsWidgets) {
    find<QCheckBox>("smoothSwitch")->click();
    surfaceController().settle();
    EXPECT_TRUE(document().shape()->hasSurface());
    EXPECT_EQ(document().undoStack().undoText(), QStringLiteral("Smooth surface"));
    const int on = step();
    find<QSpinBox>("levelsNumber")->setValue(2);
    surfaceController().settle();
    EXPECT_EQ(document().state().surface.subdivision.levels, 2);
    EXPECT_EQ(step(), on) << "settings of the same surface are one step";
    auto* detail = find<QComboBox>("detailChoice");
    detail->setCurrentIndex(1);
    emit detail->activated(1);
    surfaceController().settle();
    EXPECT_GT(document().state().surface.subdivision.tolerance, 0.0);
    EXPECT_FALSE(find<QSpinBox>("levelsNumber")->isVisible());
    // More than is allowed is refused, and the surface that is there stays.
    const auto* state = &document().state();
    auto* memory = find<QSpinBox>("memoryNumber");
    memory->setValue(1);
    find<QDoubleSpinBox>("toleranceNumber")->setValue(0.001);
    surfaceController().settle();
    settle();
    EXPECT_EQ(&document().state(), state);
    EXPECT_TRUE(window_->messages().text().contains("limit of 1 MiB"))
        << window_->messages().text().toStdString();
    EXPECT_TRUE(document().shape()->hasSurface());
    memory->setValue(1024);
    find<QCheckBox>("smoothSwitch")->click();
    surfaceController().settle();
    EXPECT_FALSE(document().shape()->hasSurface());
}

TEST_F(SurfacePanelTest, StrokesGoStraightOntoTheSurface) {
    find<QToolButton>("drawOnSurface")->click();
    EXPECT_EQ(window_->tools().active(), ToolBox::Kind::SurfacePen);
    const Vec2 middle = middleOfFace({0, 0, 1});
    const int before = step();
    for (const Hand hand : {Hand::Mouse, Hand::Pen}) {
        press(hand, middle - Vec2(20, 0));
        move(hand, middle);
        move(hand, middle + Vec2(20, 4));
        release(hand, middle + Vec2(20, 4));
        settle();
    }
    EXPECT_EQ(document().state().mapped.size(), 2U);
    EXPECT_EQ(step(), before + 2);
    EXPECT_TRUE(document().pendingStrokes().empty());
    press(Hand::Pen, {10, 10});
    move(Hand::Pen, {40, 12});
    release(Hand::Pen, {40, 12});
    settle();
    EXPECT_EQ(document().state().mapped.size(), 2U);
    EXPECT_TRUE(document().pendingStrokes().empty()) << "a stroke beside it leaves nothing";
    EXPECT_TRUE(window_->messages().text().contains("surface"))
        << window_->messages().text().toStdString();
    ASSERT_TRUE(document().undo(2));
    EXPECT_TRUE(document().state().mapped.empty());
}

TEST_F(SurfacePanelTest, ADrawingIsMappedByItsAction) {
    const Vec2 middle = middleOfFace({0, 0, 1});
    drawLine(Hand::Pen, middle - Vec2(20, 0), middle + Vec2(20, 0));
    ASSERT_EQ(document().pendingStrokes().size(), 1U);
    key(Qt::Key_M, Qt::ControlModifier);
    EXPECT_EQ(document().state().mapped.size(), 1U);
    EXPECT_TRUE(document().pendingStrokes().empty());
}

TEST_F(SurfacePanelTest, ManyDragsNeverWaitAndEndWithTheLast) {
    auto* slider = find<QSlider>("radiusSlider");
    slider->setSliderDown(true);
    for (int value = 200; value <= 700; ++value) slider->setValue(value);
    slider->setSliderDown(false);
    const double wanted = find<QDoubleSpinBox>("radiusNumber")->value();
    EXPECT_TRUE(surfaceController().busy());
    surfaceController().settle();
    EXPECT_FALSE(surfaceController().busy());
    EXPECT_NEAR(document().state().surface.radius({0, 7}), wanted, 1e-12);
}

}  // namespace ew::test
