// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QEvent>
#include <QPointingDevice>
#include <QTemporaryDir>
#include <memory>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "ui/main_window.h"
#include "ui/theme/appearance.h"

namespace ew::test {

/// What holds the pointer of a test.
enum class Hand { Mouse, Pen };

/// A shown window with the shipped templates, and hands that put events in where the system would:
/// at the platform's border, in native pixels.
class WindowTest : public testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    Document& document() { return window_->document(); }
    QWidget& surface();

    /// px of the viewport.
    void press(Hand hand, const Vec2& at, Qt::MouseButton button = Qt::LeftButton);
    void move(Hand hand, const Vec2& at, Qt::MouseButton button = Qt::LeftButton);
    void release(Hand hand, const Vec2& at, Qt::MouseButton button = Qt::LeftButton);
    /// A straight stroke with a sample every 6 px or so, and a reading after it.
    void drawLine(Hand hand, const Vec2& from, const Vec2& to);
    void drawLines(Hand hand, const std::vector<std::array<Vec2, 2>>& lines);
    /// The pen is turned round.
    void useEraserEnd(bool on) { eraserEnd_ = on; }
    void leaveProximity();
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void settle();

    /// The nine visible edges of a box seen through the start camera, centred in the viewport [px].
    std::vector<std::array<Vec2, 2>> boxLines(const Vec3& size = {60, 40, 30}) const;

    /// The six visible edges of a triangular prism: a drawing that leaves a freedom open.
    std::vector<std::array<Vec2, 2>> prismLines() const;

    std::unique_ptr<Appearance> appearance_;
    std::unique_ptr<MainWindow> window_;
    QTemporaryDir folder_;
    QString workFolder_;  ///< for working copies; empty: none are kept
    QString recentList_;  ///< file with the list of recent files; empty: none is kept
    Qt::KeyboardModifiers modifiers_ = Qt::NoModifier;

  private:
    void mouse(QEvent::Type type, const Vec2& at, Qt::MouseButtons buttons, Qt::MouseButton button);
    void tablet(const Vec2& at, Qt::MouseButtons buttons);
    QPointF nativeLocal(const Vec2& at);
    QPointF nativeGlobal(const Vec2& at);

    bool eraserEnd_ = false;
    unsigned long clockMs_ = 1000;
};

}  // namespace ew::test
