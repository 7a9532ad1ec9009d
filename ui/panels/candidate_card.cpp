// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/candidate_card.h"

#include <QMouseEvent>
#include <QPainter>
#include <QTextLayout>
#include <algorithm>

#include "ui/core_text.h"
#include "ui/theme/appearance.h"
#include "ui/viewport/solid_picture.h"

namespace ew {

namespace {
constexpr int kPictureWidth = 92;
constexpr int kPictureHeight = 76;
}  // namespace

QString operationText(Operation operation) {
    switch (operation) {
        case Operation::Add:
            return CandidateCard::tr("add");
        case Operation::Cut:
            return CandidateCard::tr("cut");
        case Operation::Split:
            return CandidateCard::tr("split");
        default:
            return {};
    }
}

/// A probability in percent; never that something is sure or cannot be.
static QString percentText(double probability) {
    if (probability > 0.0 && probability < 0.005) return QStringLiteral("<1");
    return QString::number(std::min(99, qRound(probability * 100)));
}

QString evidenceText(const Candidate& candidate) {
    const int left = static_cast<int>(candidate.unusedStrokes.size());
    QString out = CandidateCard::tr("explains all ink");
    if (left > 0) {
        out = CandidateCard::tr("%n stroke(s) not explained", nullptr, left);
    } else if (candidate.extraEdges > 0) {
        out = CandidateCard::tr("%n line(s) not explained", nullptr, candidate.extraEdges);
    }
    const int missing = candidate.missingEdges;
    if (missing == 0) return out;
    return out + QStringLiteral("; ") + CandidateCard::tr("%n edge(s) not drawn", nullptr, missing);
}

/// Wraps a text into a rectangle; what has no room is left out with an ellipsis.
static void drawWholeLines(QPainter& painter, const QRect& area, const QString& text) {
    const QFontMetrics metrics(painter.font());
    QTextLayout layout(text, painter.font());
    layout.beginLayout();
    int top = area.top();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(area.width());
        const bool last = top + 2 * metrics.lineSpacing() > area.bottom() + 1;
        const QString rest = text.mid(line.textStart());
        painter.drawText(area.left(), top + metrics.ascent(),
                         last ? metrics.elidedText(rest, Qt::ElideRight, area.width())
                              : rest.left(line.textLength()));
        if (last) break;
        top += metrics.lineSpacing();
    }
    layout.endLayout();
}

CandidateCard::CandidateCard(int index, Appearance& appearance, QWidget* parent)
    : QAbstractButton(parent), index_(index), appearance_(appearance) {
    setCheckable(true);
    setAutoExclusive(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&appearance, &Appearance::changed, this, [this] { redraw(); });
}

void CandidateCard::show(const Candidate& candidate, const OrthographicCamera& camera, bool clear) {
    candidate_ = candidate;
    camera_ = camera;
    clear_ = clear;
    QString name = coreText(candidate.templateName);
    const QString reading = coreText(candidate.readingName);
    setAccessibleName(tr("Reading %1: %2, %3, %4 % likely")
                          .arg(index_ + 1)
                          .arg(name, reading)
                          .arg(percentText(candidate.probability)));
    QString notes = evidenceText(candidate) + QStringLiteral(". ");
    notes.front() = notes.front().toUpper();
    for (const std::string& note : candidate.notes) notes += coreText(note) + ' ';
    setAccessibleDescription(notes);
    setToolTip(notes.trimmed());
    redraw();
}

void CandidateCard::redraw() {
    picture_ =
        solidPicture(candidate_.spec, candidate_.pose, camera_, {kPictureWidth, kPictureHeight},
                     devicePixelRatioF(), appearance_.colours());
    update();
}

void CandidateCard::paintEvent(QPaintEvent*) {
    const ThemeColours& c = appearance_.colours();
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(1, 1, -1, -1);
    p.setPen(QPen(isChecked() || hasFocus() ? c.accent : c.border, isChecked() ? 2.0 : 1.0));
    p.setBrush(hovered_ ? mixColours(c.surface, c.raised, 0.6) : c.surface);
    p.drawRoundedRect(frame, metrics::kRadius, metrics::kRadius);
    if (hasFocus()) {
        p.setPen(QPen(c.accent, 1.0, Qt::DotLine));
        p.drawRoundedRect(frame.adjusted(3, 3, -3, -3), metrics::kRadius - 2, metrics::kRadius - 2);
    }
    p.drawImage(QPointF(metrics::kSpace, (height() - kPictureHeight) / 2.0), picture_);

    QFont bold = font();
    bold.setBold(true);
    const QFontMetrics strong(bold);
    const QFontMetrics plain(font());
    QRect text = rect().adjusted(kPictureWidth + 2 * metrics::kSpace, 9, -metrics::kSpace - 4, -8);
    const QString key = QString::number(index_ + 1);
    const QRect keyBox(text.right() - 16, text.top() - 1, 18, 18);
    p.setPen(QPen(c.border, 1.0));
    p.setBrush(c.window);
    p.drawRoundedRect(QRectF(keyBox), 4, 4);
    p.setPen(c.mutedText);
    p.drawText(keyBox, Qt::AlignCenter, key);

    p.setFont(bold);
    p.setPen(c.text);
    QString name = coreText(candidate_.templateName);
    const QString operation = operationText(candidate_.operation);
    if (!operation.isEmpty()) name = tr("%1, %2").arg(name, operation);
    p.drawText(text.left(), text.top() + strong.ascent(),
               strong.elidedText(name, Qt::ElideRight, text.width() - 24));
    text.setTop(text.top() + strong.height() + 3);
    p.setFont(font());
    p.setPen(clear_ ? c.ok : c.mutedText);
    const QString likely = tr("%1 % likely").arg(percentText(candidate_.probability));
    const QString reading = candidate_.readingName.empty()
                                ? likely
                                : tr("%1 \u00b7 %2").arg(likely, coreText(candidate_.readingName));
    p.drawText(text.left(), text.top() + plain.ascent(),
               plain.elidedText(reading, Qt::ElideRight, text.width()));
    text.setTop(text.top() + plain.height() + 3);
    p.setPen(c.mutedText);
    QString more = evidenceText(candidate_);
    if (!candidate_.notes.empty())
        more += QStringLiteral(". ") + coreText(candidate_.notes.front());
    more.front() = more.front().toUpper();
    drawWholeLines(p, text, more);
}

void CandidateCard::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) emit doubleClicked();
}

void CandidateCard::enterEvent(QEnterEvent* event) {
    hovered_ = true;
    update();
    QAbstractButton::enterEvent(event);
}

void CandidateCard::leaveEvent(QEvent* event) {
    hovered_ = false;
    update();
    QAbstractButton::leaveEvent(event);
}

}  // namespace ew
