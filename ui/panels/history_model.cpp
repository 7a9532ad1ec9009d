// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/history_model.h"

#include <QApplication>
#include <QFont>
#include <QIcon>
#include <QPalette>
#include <QPixmap>
#include <QUndoStack>

#include "ui/theme/appearance.h"

namespace ew {

HistoryModel::HistoryModel(Document& document, Appearance& appearance, QObject* parent)
    : QAbstractListModel(parent),
      document_(document),
      appearance_(appearance),
      pictures_(new StepPictures(kPicture, this)) {
    pictures_->setLook(appearance.colours(), ratio_);
    connect(pictures_, &StepPictures::ready, this,
            [this] { emit dataChanged(index(0), index(rowCount() - 1), {Qt::DecorationRole}); });
    connect(&appearance, &Appearance::changed, this,
            [this] { pictures_->setLook(appearance_.colours(), ratio_); });
}

void HistoryModel::setPixelRatio(double ratio) {
    if (ratio == ratio_) return;
    ratio_ = ratio;
    pictures_->setLook(appearance_.colours(), ratio);
}

int HistoryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : document_.undoStack().count() + 1;
}

QString HistoryModel::stepText(int row) const {
    return row == 0 ? tr("Empty document") : document_.undoStack().text(row - 1);
}

QIcon HistoryModel::pictureOf(int row) const {
    const QImage image = pictures_->picture(document_.stateAt(row));
    if (!image.isNull()) {
        const QPixmap picture = QPixmap::fromImage(image);
        QIcon icon(picture);
        icon.addPixmap(picture, QIcon::Selected);  // else it is tinted
        return icon;
    }
    // Room is kept, so that texts stand below each other.
    QPixmap empty(kPicture * ratio_);
    empty.setDevicePixelRatio(ratio_);
    empty.fill(Qt::transparent);
    return QIcon(empty);
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const int row = index.row();
    const QString name = QString::fromStdString(document_.stateName(row));
    switch (role) {
        case Qt::DisplayRole:
            return name.isEmpty() ? stepText(row) : name;
        case Qt::ToolTipRole:
            return name.isEmpty() ? stepText(row)
                                  : QStringLiteral("%1\n%2").arg(name, stepText(row));
        case Qt::DecorationRole:
            return pictureOf(row);
        case Qt::FontRole: {
            QFont font = QApplication::font("QAbstractItemView");
            font.setBold(!name.isEmpty());
            return font;
        }
        case Qt::ForegroundRole:
            // What can be redone reads as not there yet.
            if (row > document_.undoStack().index())
                return QApplication::palette().placeholderText();
            return {};
        default:
            return {};
    }
}

void HistoryModel::refresh() {
    beginResetModel();
    endResetModel();
}

}  // namespace ew
