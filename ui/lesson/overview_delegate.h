// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace ew {

class Appearance;

/// Paints a lesson of a pupil: a picture of what she made over how far she is. What is done, and
/// where somebody is stuck, is told by colour and by a sign.
class OverviewDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    explicit OverviewDelegate(Appearance& appearance, QObject* parent = nullptr);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;

    static int rowHeight(const QFontMetrics& font);

  private:
    void paintLesson(QPainter& painter, const QStyleOptionViewItem& option,
                     const QModelIndex& index) const;

    Appearance& appearance_;
};

}  // namespace ew
