// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace ew {

class Appearance;

/// Asks a pupil for the class folder and her name; those who worked there before are listed.
class JoinDialog : public QDialog {
    Q_OBJECT

  public:
    JoinDialog(Appearance& appearance, const QString& folder, QWidget* parent = nullptr);

    QString folder() const;
    QString pupil() const;
    /// Says why it cannot be.
    void showProblem(const QString& text);

  signals:
    /// Both are told; accept() or showProblem() is the answer.
    void joinWanted();

  private:
    void browse();
    void listPupils();
    void refresh();

    Appearance& appearance_;
    QLineEdit* folder_;
    QComboBox* pupil_;
    QLabel* problem_;
    QPushButton* join_;
    QString listed_;  ///< folder whose pupils are listed
};

}  // namespace ew
