// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/practice_curve.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/theme/appearance.h"

namespace ew {

namespace {

constexpr std::size_t kShown = 30;
constexpr int kRowHeight = 46;
constexpr int kNameWidth = 92;
constexpr int kValueWidth = 66;
constexpr int kWidth = 420;

QString percentText(double share) {
    return PracticeCurve::tr("%1 %").arg(QLocale().toString(100.0 * share, 'f', 0));
}
QString secondsText(double seconds) {
    return PracticeCurve::tr("%1 s").arg(QLocale().toString(seconds, 'f', seconds < 10 ? 1 : 0));
}
QString pixelText(double px) {
    return PracticeCurve::tr("%1 px").arg(QLocale().toString(px, 'f', 1));
}

}  // namespace

PracticeCurve::PracticeCurve(Appearance& appearance, QWidget* parent)
    : QWidget(parent), appearance_(appearance) {
    setObjectName(QStringLiteral("practiceCurve"));
    connect(&appearance_, &Appearance::changed, this, qOverload<>(&QWidget::update));
}

void PracticeCurve::setResults(std::vector<PracticeResult> results) {
    if (results.size() > kShown) {
        results.erase(results.begin(), results.end() - static_cast<std::ptrdiff_t>(kShown));
    }
    results_ = std::move(results);
    setAccessibleName(results_.empty() ? QString() : words(results_.back()));
    update();
}

QString PracticeCurve::words(const PracticeResult& result) {
    return tr("Accuracy %1, pen down for %2, lines off straight by %3.")
        .arg(percentText(result.accuracy), secondsText(result.seconds), pixelText(result.wobblePx));
}

QSize PracticeCurve::sizeHint() const { return {kWidth, 3 * kRowHeight}; }

std::vector<PracticeCurve::Row> PracticeCurve::rows() const {
    Row accuracy{tr("Accuracy"), percentText(results_.back().accuracy), {}, 0.0, 1.0};
    Row speed{tr("Time"), secondsText(results_.back().seconds), {}, 0.0, 1.0};
    Row steady{tr("Wobble"), pixelText(results_.back().wobblePx), {}, 0.0, 1.0};
    for (const PracticeResult& r : results_) {
        accuracy.values.push_back(r.accuracy);
        speed.values.push_back(r.seconds);
        steady.values.push_back(r.wobblePx);
    }
    for (Row* row : {&speed, &steady}) {
        row->most = std::max(1e-3, *std::max_element(row->values.begin(), row->values.end()));
    }
    return {accuracy, speed, steady};
}

void PracticeCurve::paintRow(QPainter& painter, const Row& row, const QRect& area) const {
    const ThemeColours& c = appearance_.colours();
    const QRect name(area.left(), area.top(), kNameWidth, area.height());
    const QRect value(area.right() - kValueWidth, area.top(), kValueWidth, area.height());
    painter.setPen(c.mutedText);
    painter.drawText(name, Qt::AlignVCenter | Qt::AlignLeft, row.name);
    painter.setPen(c.text);
    painter.drawText(value, Qt::AlignVCenter | Qt::AlignRight, row.newest);
    const QRectF plot(name.right() + 1, area.top() + metrics::kSpace,
                      area.width() - kNameWidth - kValueWidth - metrics::kSpace,
                      area.height() - 2 * metrics::kSpace);
    painter.setPen(c.border);
    painter.drawLine(plot.bottomLeft(), plot.bottomRight());
    // A newest result stands at the right, however few there are.
    const double step = plot.width() / static_cast<double>(kShown - 1);
    const auto at = [&](std::size_t i) {
        const double y = (row.values[i] - row.least) / (row.most - row.least);
        return QPointF(plot.right() - step * static_cast<double>(row.values.size() - 1 - i),
                       plot.bottom() - std::clamp(y, 0.0, 1.0) * plot.height());
    };
    QPainterPath curve(at(0));
    for (std::size_t i = 1; i < row.values.size(); ++i) curve.lineTo(at(i));
    painter.setPen(QPen(c.accent, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(curve);
    painter.setBrush(c.accent);
    constexpr double kDot = 3.0;
    painter.drawEllipse(at(row.values.size() - 1), kDot, kDot);
    painter.setBrush(Qt::NoBrush);
}

void PracticeCurve::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (results_.empty()) {
        painter.setPen(appearance_.colours().mutedText);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("After the first exercise your accuracy, time and steadiness are "
                            "shown here."));
        return;
    }
    int top = 0;
    for (const Row& row : rows()) {
        paintRow(painter, row, QRect(0, top, width(), kRowHeight));
        top += kRowHeight;
    }
}

}  // namespace ew
