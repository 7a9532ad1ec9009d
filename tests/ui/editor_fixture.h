// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qpa/qwindowsysteminterface.h>

#include <QAction>
#include <QApplication>
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <QWindow>

#include "core/reading/template_drawing.h"
#include "tests/ui/window_fixture.h"
#include "ui/template_editor/rule_list.h"
#include "ui/template_editor/template_editor.h"
#include "ui/template_editor/trial_page.h"

namespace ew::test {

/// A hand in any window.
class MouseIn {
  public:
    explicit MouseIn(QWidget& widget) : widget_(widget) {}

    void send(QEvent::Type type, const QPointF& at, Qt::MouseButtons buttons,
              Qt::MouseButton button) const {
        static unsigned long clockMs = 100'000;
        clockMs += 8;
        QWidget& window = *widget_.window();
        const double scale = window.windowHandle()->devicePixelRatio();
        QWindowSystemInterface::handleMouseEvent(
            window.windowHandle(), clockMs, widget_.mapTo(&window, at) * scale,
            widget_.mapToGlobal(at) * scale, buttons, button, type, Qt::NoModifier);
        QWindowSystemInterface::sendWindowSystemEvents(QEventLoop::AllEvents);
    }
    void hover(const QPointF& at) const { send(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton); }
    void drag(const QPointF& from, const QPointF& to) const {
        constexpr int kSteps = 30;
        hover(from);
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        for (int i = 1; i <= kSteps; ++i) {
            send(QEvent::MouseMove, from + (to - from) * (static_cast<double>(i) / kSteps),
                 Qt::LeftButton, Qt::NoButton);
        }
        send(QEvent::MouseButtonRelease, to, Qt::NoButton, Qt::LeftButton);
    }
    void click(const QPointF& at) const {
        hover(at);
        send(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, at, Qt::NoButton, Qt::LeftButton);
    }

  private:
    QWidget& widget_;
};

class EditorTest : public WindowTest {
  protected:
    QAction& menuAction(const QString& menu, const QString& text) {
        for (QAction* top : window_->menuBar()->actions()) {
            if (top->text().remove('&') != menu) continue;
            for (QAction* action : top->menu()->actions()) {
                if (action->text().remove('&') == text) return *action;
            }
        }
        ADD_FAILURE() << "no such action: " << text.toStdString();
        static QAction none;
        return none;
    }

    TemplateEditor* openEditor() const {
        auto* editor = window_->findChild<TemplateEditor*>();
        if (editor == nullptr) return nullptr;
        EXPECT_TRUE(QTest::qWaitForWindowExposed(editor));
        editor->activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(editor));
        settle(*editor);
        return editor;
    }
    TemplateEditor* editorFromMenu() {
        menuAction("Sketch", QStringLiteral("Template editor\u2026")).trigger();
        return openEditor();
    }
    static void settle(TemplateEditor& editor) {
        QApplication::processEvents();
        editor.checker().settle();
        editor.trial().settle();
        QApplication::processEvents();
    }
    template <class T>
    static T& part(TemplateEditor& editor, const char* name) {
        auto* found = editor.findChild<T*>(name);
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    static void type(TemplateEditor& editor, const char* field, const QString& text) {
        auto& line = part<QLineEdit>(editor, field);
        MouseIn(line).click(line.rect().center());
        QTest::keyClicks(&line, text);
        settle(editor);
    }
    static void click(QWidget& widget) { MouseIn(widget).click(QRectF(widget.rect()).center()); }
    static void keys(TemplateEditor& editor, QKeySequence::StandardKey key) {
        QTest::keySequence(editor.windowHandle(), QKeySequence(key));
        settle(editor);
    }
    /// The box before a rule.
    static void tick(TemplateEditor& editor, int rule) {
        auto& list = part<RuleList>(editor, "ruleList");
        list.scrollToItem(list.item(rule));
        const QRect row = list.visualItemRect(list.item(rule));
        MouseIn(*list.viewport()).click(QPointF(row.left() + 14.0, row.center().y()));
        settle(editor);
    }
    const Template* inUse(const std::string& id) {
        const TemplateLibrary& library = document().state().library;
        const int place = library.find(id);
        return place < 0 ? nullptr : &library.at(static_cast<std::size_t>(place));
    }
    /// The window is the active one again, so that its shortcuts work.
    void backToWindow() {
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        window_->activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    }
    void makeBox() {
        drawLines(Hand::Mouse, boxLines());
        key(Qt::Key_Return);
        ASSERT_EQ(document().state().bodies.size(), 1U);
    }
    /// Right click on a template of the panel, and one of the menu's actions.
    void chooseInPanel(const QString& name, const char* action) {
        auto* list = window_->findChild<QListWidget*>("templateList");
        ASSERT_NE(list, nullptr);
        const auto items = list->findItems(name, Qt::MatchExactly);
        ASSERT_EQ(items.size(), 1);
        list->scrollToItem(items.front());
        const QPoint at = list->visualItemRect(items.front()).center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, list->viewport()->mapToGlobal(at));
        QApplication::sendEvent(list->viewport(), &event);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        ASSERT_NE(menu, nullptr);
        auto* wanted = menu->findChild<QAction*>(action);
        ASSERT_NE(wanted, nullptr);
        enabled_ = wanted->isEnabled();
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(wanted).center());
        menu->close();
        QApplication::processEvents();
    }
    /// Draws a random body of the draft on the sheet.
    void drawOnSheet(TemplateEditor& editor, std::uint64_t seed) {
        part<QTabWidget>(editor, "editorPages").setCurrentIndex(1);
        settle(editor);
        TrialCanvas& canvas = editor.trialPage().canvas();
        Random random(seed);
        Template tmpl = templateOf(editor.model().draft());
        for (int attempt = 0; attempt < 200; ++attempt) {
            const auto drawn = randomDrawing(*makeEntry(tmpl), random);
            ASSERT_TRUE(drawn);
            QRectF box;
            for (const Line2& line : drawn->lines) {
                const QPointF a(line[0].x(), line[0].y());
                const QPointF b(line[1].x(), line[1].y());
                box |= QRectF(a, b).normalized().adjusted(0, 0, 0.1, 0.1);
            }
            if (box.width() > canvas.width() - 20 || box.height() > canvas.height() - 20) continue;
            const QPointF by = QRectF(canvas.rect()).center() - box.center();
            for (const Line2& line : drawn->lines) {
                MouseIn(canvas).drag(QPointF(line[0].x(), line[0].y()) + by,
                                     QPointF(line[1].x(), line[1].y()) + by);
            }
            settle(editor);
            lines_ = drawn->lines.size();
            return;
        }
        FAIL() << "no drawing fits the sheet";
    }

    bool enabled_ = false;   ///< was the action in the panel's menu?
    std::size_t lines_ = 0;  ///< drawn on the sheet
};

}  // namespace ew::test
