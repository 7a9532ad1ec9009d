// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace ew {

class Appearance;
class ClassSession;
class LessonGuide;

/// What a lesson says: the step, what to do, what became of it, hints.
class LessonPanel : public QWidget {
    Q_OBJECT

  public:
    LessonPanel(LessonGuide& guide, ClassSession& session, Appearance& appearance,
                QWidget* parent = nullptr);

  signals:
    /// The lesson is to end.
    void endWanted();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void claimHeight();
    void showPupil();
    void showPicture();
    void arrange(bool isPractice);
    QString doneText() const;
    void refresh();
    void showHint();

    LessonGuide& guide_;
    ClassSession& session_;
    Appearance& appearance_;
    QLabel* title_;
    QLabel* place_;
    QLabel* pupil_;
    QProgressBar* progress_;
    QLabel* task_;
    QLabel* picture_;
    QLabel* said_;
    QGridLayout* buttons_;
    QPushButton* hint_;
    QPushButton* show_;
    QPushButton* again_;
    QPushButton* next_;
    QPushButton* end_;
    bool hintShown_ = false;
    std::size_t step_ = 0;
};

}  // namespace ew
