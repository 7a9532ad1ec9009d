// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QVariantAnimation>

#include "core/document/document.h"

class QHBoxLayout;
class QLabel;

namespace ew {

class Appearance;
class ApplyController;
class LiveReading;

/// The sentence under the viewport: what the drawing reads as, or why it is not understood, with
/// one-click repairs beside it. Its height never changes, so the drawing never moves.
class MessageBar : public QFrame {
    Q_OBJECT

  public:
    MessageBar(Document& document, LiveReading& reading, ApplyController& apply,
               Appearance& appearance, QWidget* parent = nullptr);

    /// A sentence that stays until the ink changes or the next one comes.
    void showNotice(const QString& text);
    void showError(const Error& error);
    /// Something else is begun, to which the last sentence of the two above says nothing.
    void clearNotice();
    QString text() const;

    /// Long labels of repairs do not widen the window.
    QSize minimumSizeHint() const override;

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    enum class Tone { Quiet, Good, Warning };
    struct Sentence {
        Tone tone = Tone::Quiet;
        QString text;
    };
    void refresh();
    Sentence sentence() const;
    Sentence idleSentence() const;
    void say(const Sentence& sentence);
    void showRepairs();
    /// Shows the first repairs that there is room for beside the sentence.
    void fitRepairs();
    void onApplied(const ApplyOutcome& outcome);
    void onCountdown(bool running);

    Document& document_;
    LiveReading& reading_;
    ApplyController& apply_;
    Appearance& appearance_;
    QLabel* icon_;
    QLabel* text_;
    QHBoxLayout* buttons_;
    std::vector<Repair> shownRepairs_;
    std::optional<Sentence> notice_;
    QVariantAnimation countdown_;
};

}  // namespace ew
