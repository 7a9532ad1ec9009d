// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPersistentModelIndex>
#include <QPixmap>
#include <QStyledItemDelegate>
#include <string>

namespace ew {

class Appearance;

/// What a card shows beside its name (Qt::DisplayRole) and picture (Qt::DecorationRole, a
/// QPixmap, or nothing).
enum CardRole {
    kDetailRole = Qt::UserRole + 1,  ///< QString, a line under the name
    kMissingRole,                    ///< bool: there is no such file any more
    kPinnedRole,                     ///< bool; not set: it cannot be pinned
    kPathRole,                       ///< QString
    kSearchRole,                     ///< QString, what a search looks in
    kPlaceRole,                      ///< int, in the list that it is from
};

/// A PNG as a picture; null where it is none.
QPixmap pictureOf(const std::string& png);

/// Paints documents as cards: a picture, a name, a line of detail and a pin.
class CardDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    CardDelegate(Appearance& appearance, QObject* parent);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;

    /// Was the last click on a pin, and so none on the card?
    bool tookClick() const { return tookClick_; }

  signals:
    /// The pin of a card was clicked.
    void pinClicked(const QModelIndex& index);

  private:
    void paintPicture(QPainter& painter, const QRect& area, const QModelIndex& index) const;
    void paintPin(QPainter& painter, const QRect& area, bool pinned) const;

    Appearance& appearance_;
    bool tookClick_ = false;
};

}  // namespace ew
