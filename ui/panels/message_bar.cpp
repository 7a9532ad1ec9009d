// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <algorithm>

#include "ui/apply_controller.h"
#include "ui/core_text.h"
#include "ui/live_reading.h"
#include "ui/theme/appearance.h"
#include "ui/theme/themed_icon.h"

namespace ew {

namespace {

constexpr std::size_t kMostRepairs = 3;
constexpr int kTextRoom = 240;  // for the sentence [px]

bool sameRepairs(const std::vector<Repair>& a, const std::vector<Repair>& b) {
    return a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(), [](const Repair& x, const Repair& y) {
               return x.kind == y.kind && x.label == y.label && x.from == y.from && x.to == y.to &&
                      x.strokes == y.strokes && x.value == y.value && x.candidate == y.candidate;
           });
}

/// One of a kind: of several that a person cannot tell apart the first, which is the nearest where
/// they go by distance. "This line" is none of several.
std::vector<Repair> oneOfAKind(const std::vector<Repair>& repairs) {
    const auto same = [](const Repair& a, const Repair& b) {
        return a.kind == b.kind && a.label == b.label;
    };
    std::vector<Repair> shown;
    for (const Repair& r : repairs) {
        const auto count = std::count_if(repairs.begin(), repairs.end(),
                                         [&](const Repair& other) { return same(r, other); });
        if (count > 1 && r.kind == Repair::Kind::DropStrokes) continue;
        const bool again = std::any_of(shown.begin(), shown.end(),
                                       [&](const Repair& other) { return same(r, other); });
        if (!again) shown.push_back(r);
    }
    return shown;
}

QString doneText(const Candidate& candidate) {
    const QString solid = solidText(candidate.templateName);
    switch (candidate.operation) {
        case Operation::Add:
            return MessageBar::tr("Added %1.").arg(solid);
        case Operation::Cut:
            return MessageBar::tr("Cut %1.").arg(solid);
        case Operation::Split:
            return MessageBar::tr("Cut the solid in two.");
        default:
            return MessageBar::tr("Made %1.").arg(solid);
    }
}

}  // namespace

MessageBar::MessageBar(Document& document, LiveReading& reading, ApplyController& apply,
                       Appearance& appearance, QWidget* parent)
    : QFrame(parent),
      document_(document),
      reading_(reading),
      apply_(apply),
      appearance_(appearance),
      icon_(new QLabel(this)),
      text_(new QLabel(this)),
      buttons_(new QHBoxLayout) {
    setFixedHeight(metrics::kMessageHeight);
    setAccessibleName(tr("Message"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(metrics::kMargin, 2, metrics::kMargin, 4);
    layout->setSpacing(metrics::kSpace);
    icon_->setFixedSize(metrics::kIcon, metrics::kIcon);
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setObjectName(QStringLiteral("message"));
    text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    layout->addWidget(icon_);
    layout->addWidget(text_, 1);
    layout->addLayout(buttons_);
    buttons_->setSpacing(metrics::kGap);
    countdown_.setStartValue(0.0);
    countdown_.setEndValue(1.0);
    countdown_.setDuration(ApplyController::kWaitMs);
    connect(&countdown_, &QVariantAnimation::valueChanged, this, qOverload<>(&QWidget::update));
    connect(&reading, &LiveReading::changed, this, &MessageBar::refresh);
    connect(&apply, &ApplyController::countdownChanged, this, &MessageBar::onCountdown);
    connect(&apply, &ApplyController::failed, this, &MessageBar::showError);
    connect(&apply, &ApplyController::applied, this, &MessageBar::onApplied);
    connect(&appearance, &Appearance::changed, this, &MessageBar::refresh);
    connect(&document, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::Ink || what == DocumentChange::Bodies) notice_.reset();
        if (what == DocumentChange::Bodies || what == DocumentChange::History) refresh();
    });
    refresh();
}

QString MessageBar::text() const { return text_->text(); }

void MessageBar::showNotice(const QString& text) {
    notice_ = Sentence{Tone::Quiet, text};
    refresh();
}

void MessageBar::showError(const Error& error) {
    notice_ = Sentence{Tone::Warning, coreText(error.message)};
    show();  // the start page hides it
    refresh();
}

void MessageBar::clearNotice() {
    notice_.reset();
    refresh();
}

void MessageBar::onCountdown(bool running) {
    if (running) {
        countdown_.start();
    } else {
        countdown_.stop();
    }
    refresh();
}

void MessageBar::onApplied(const ApplyOutcome& outcome) {
    const int left = static_cast<int>(document_.pendingStrokes().size());
    if (left == 0 || outcome.chosen < 0) return;
    const auto chosen = static_cast<std::size_t>(outcome.chosen);
    notice_ =
        Sentence{Tone::Good, doneText(outcome.interpretation.candidates[chosen]) + ' ' +
                                 tr("%n stroke(s) that it does not use stay.", nullptr, left)};
    refresh();
}

MessageBar::Sentence MessageBar::idleSentence() const {
    if (!apply_.showsApplied()) {
        if (!document_.state().bodies.empty()) return {Tone::Quiet, tr("Draw the next shape.")};
        return {Tone::Quiet, tr("Draw the edges that you would see of a box, a prism or a pyramid, "
                                "in any order and with any number of strokes.")};
    }
    const ApplyOutcome& last = *document_.lastApply();
    if (last.chosen < 0) return {Tone::Quiet, tr("Draw the next shape.")};
    const Candidate& made = last.interpretation.candidates[static_cast<std::size_t>(last.chosen)];
    QString text = doneText(made);
    if (!made.notes.empty()) text += ' ' + coreText(made.notes.front());
    const int others = static_cast<int>(last.interpretation.candidates.size()) - 1;
    if (others > 0) text += ' ' + tr("%n other reading(s): keys 1 to 9.", nullptr, others);
    return {Tone::Good, text};
}

namespace {
QString whatEnterDoes(const Interpretation& reading, int candidate) {
    if (candidate >= 0) {
        switch (reading.candidates[static_cast<std::size_t>(candidate)].operation) {
            case Operation::Add:
                return MessageBar::tr("Enter adds it to the solid.");
            case Operation::Cut:
                return MessageBar::tr("Enter cuts it out of the solid.");
            case Operation::Split:
                return MessageBar::tr("Enter cuts the solid in two.");
            default:
                break;
        }
    }
    return MessageBar::tr("Enter makes it a solid.");
}
}  // namespace

MessageBar::Sentence MessageBar::sentence() const {
    if (notice_) return *notice_;
    const bool ink = !document_.pendingStrokes().empty() || reading_.strokeUnderWay();
    if (!ink) return idleSentence();
    const Interpretation& r = reading_.reading();
    const int current = reading_.current();
    QString name;
    if (current >= 0) {
        const Candidate& c = r.candidates[static_cast<std::size_t>(current)];
        name = coreText(c.templateName);
        if (!c.readingName.empty() && c.readingId != "default") {
            name = tr("%1 (%2)").arg(name, coreText(c.readingName));
        }
    }
    if (r.accepted && reading_.chosen() < 0) {
        if (apply_.countingDown()) {
            return {Tone::Good, tr("Clear: %1. Applying it; Escape waits.").arg(name)};
        }
        return {Tone::Good, tr("Clear: %1. %2").arg(name, whatEnterDoes(r, current))};
    }
    if (reading_.chosen() >= 0) {
        return {Tone::Quiet, tr("Chosen: %1. %2").arg(name, whatEnterDoes(r, current))};
    }
    if (reading_.justBegun()) {
        const bool bent = r.problem && r.problem->code == Errc::CurvedStroke;
        return {Tone::Quiet, bent ? coreText(r.problem->message) : tr("Keep drawing.")};
    }
    if (!reading_.settled()) return {Tone::Quiet, tr("Reading the drawing\u2026")};
    // Lines that enclose nothing yet are a drawing that is not done.
    const bool begun = r.problem && r.problem->code == Errc::NoRegion;
    if (r.problem) return {begun ? Tone::Quiet : Tone::Warning, coreText(r.problem->message)};
    return {Tone::Quiet, tr("Keep drawing.")};
}

void MessageBar::refresh() {
    say(sentence());
    showRepairs();
}

void MessageBar::say(const Sentence& sentence) {
    const ThemeColours& colours = appearance_.colours();
    text_->setText(sentence.text);
    text_->setToolTip(sentence.text);
    QPalette palette = text_->palette();
    palette.setColor(QPalette::WindowText,
                     sentence.tone == Tone::Warning ? colours.warning : colours.text);
    text_->setPalette(palette);
    const char* name = sentence.tone == Tone::Warning ? "warning"
                       : sentence.tone == Tone::Good  ? "ok"
                                                      : "pen";
    icon_->setPixmap(themedIcon(QLatin1String(name))
                         .pixmap(QSize(metrics::kIcon, metrics::kIcon), devicePixelRatioF()));
    update();
}

void MessageBar::showRepairs() {
    std::vector<Repair> wanted;
    if (reading_.settled() && !reading_.strokeUnderWay() && !document_.pendingStrokes().empty()) {
        wanted = oneOfAKind(reading_.reading().repairs);
    }
    if (wanted.size() > kMostRepairs) wanted.resize(kMostRepairs);
    if (sameRepairs(wanted, shownRepairs_)) return;
    shownRepairs_ = wanted;
    while (QLayoutItem* item = buttons_->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    for (std::size_t i = 0; i < shownRepairs_.size(); ++i) {
        auto* button = new QPushButton(coreText(shownRepairs_[i].label), this);
        button->setObjectName(QStringLiteral("repair%1").arg(i + 1));
        buttons_->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, i] {
            // A copy: carrying it out changes the list that it is in.
            const Repair repair = shownRepairs_[i];
            if (repair.kind == Repair::Kind::UseCandidate) {
                apply_.take(repair.candidate);
            } else if (auto done = document_.repair(repair); !done) {
                showError(done.error());
            }
        });
    }
    fitRepairs();
}

void MessageBar::fitRepairs() {
    int left = width() - kTextRoom;
    for (int i = 0; i < buttons_->count(); ++i) {
        QWidget* button = buttons_->itemAt(i)->widget();
        left -= button->sizeHint().width() + buttons_->spacing();
        button->setVisible(i == 0 || left >= 0);
    }
}

QSize MessageBar::minimumSizeHint() const { return {kTextRoom, metrics::kMessageHeight}; }

void MessageBar::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fitRepairs();
}

void MessageBar::paintEvent(QPaintEvent*) {
    const ThemeColours& colours = appearance_.colours();
    QPainter painter(this);
    painter.fillRect(rect(), colours.window);
    painter.fillRect(QRect(0, 0, width(), 1), colours.border);
    if (countdown_.state() != QAbstractAnimation::Running) return;
    const double share = countdown_.currentValue().toDouble();
    painter.fillRect(QRectF(0, height() - 3, width() * share, 3), colours.accent);
}

}  // namespace ew
