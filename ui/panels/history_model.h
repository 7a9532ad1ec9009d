// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>

#include "ui/panels/step_pictures.h"

namespace ew {

class Appearance;

/// The states of the history for a list: row n is the one with n steps done. Text and picture are
/// looked up when they are shown, so a long history costs nothing.
class HistoryModel : public QAbstractListModel {
    Q_OBJECT

  public:
    static constexpr QSize kPicture{56, 42};

    HistoryModel(Document& document, Appearance& appearance, QObject* parent);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    /// What made the state of a row, in the window's language.
    QString stepText(int row) const;
    void refresh();
    /// For pictures on a screen of this kind.
    void setPixelRatio(double ratio);

  private:
    QIcon pictureOf(int row) const;

    Document& document_;
    Appearance& appearance_;
    StepPictures* pictures_;
    double ratio_ = 1.0;
};

}  // namespace ew
