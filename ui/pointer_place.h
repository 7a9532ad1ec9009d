// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

class QWidget;

namespace ew {

/// Where mouse, pen or finger was last, by what it did. QWidget::underMouse() goes by enter and
/// leave instead, which never come where a pen touches down elsewhere or a menu closes by key.
class PointerPlace : public QObject {
  public:
    /// \param parent  owner; its display's pointer is meant.
    explicit PointerPlace(QObject* parent);

    /// False for what is hidden, and before anything was pointed at.
    bool isOver(const QWidget& widget) const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    std::optional<QPointF> global_;  // [logical px of the screens]
};

}  // namespace ew
