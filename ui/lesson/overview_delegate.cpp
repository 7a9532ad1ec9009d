// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/overview_delegate.h"

#include <QPainter>
#include <QPainterPath>

#include "ui/lesson/overview_model.h"
#include "ui/theme/appearance.h"

namespace ew {

namespace {
constexpr int kPictureHeight = 54;
constexpr int kPictureWidth = 86;
}  // namespace

OverviewDelegate::OverviewDelegate(Appearance& appearance, QObject* parent)
    : QStyledItemDelegate(parent), appearance_(appearance) {}

int OverviewDelegate::rowHeight(const QFontMetrics& font) {
    return kPictureHeight + 2 * font.height() + 2 * metrics::kSpace + metrics::kGap;
}

void OverviewDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const {
    QStyleOptionViewItem opt = option;
    initStyleOption(&opt, index);
    const ThemeColours& c = appearance_.colours();
    const bool isLesson = index.column() >= OverviewModel::FirstLesson;
    opt.displayAlignment = Qt::AlignLeft | Qt::AlignVCenter;
    opt.features |= QStyleOptionViewItem::WrapText;
    if (index.column() == OverviewModel::Name) opt.font.setBold(true);
    if (index.column() == OverviewModel::Stuck) opt.palette.setColor(QPalette::Text, c.warning);
    if (isLesson) {
        opt.text.clear();
        opt.icon = {};
        opt.features &= ~QStyleOptionViewItem::HasDecoration;
    }
    // A selection in the colour of the palette would hide what colours tell.
    const bool chosen = opt.state.testFlag(QStyle::State_Selected);
    opt.state &= ~(QStyle::State_Selected | QStyle::State_HasFocus | QStyle::State_MouseOver);
    constexpr double kTint = 0.14;
    if (chosen) painter->fillRect(opt.rect, mixColours(c.surface, c.accent, kTint));
    opt.widget->style()->drawControl(QStyle::CE_ItemViewItem, &opt, painter, opt.widget);
    if (isLesson) paintLesson(*painter, opt, index);
    painter->save();
    painter->setPen(c.border);
    painter->drawLine(opt.rect.bottomLeft(), opt.rect.bottomRight());
    if (chosen) {
        painter->setPen(QPen(c.accent, 1.0));
        painter->drawRect(opt.rect.adjusted(0, 0, -1, -1));
    }
    painter->restore();
}

void OverviewDelegate::paintLesson(QPainter& painter, const QStyleOptionViewItem& option,
                                   const QModelIndex& index) const {
    const QString text = index.data().toString();
    if (text.isEmpty()) return;
    const ThemeColours& c = appearance_.colours();
    QRect area =
        option.rect.adjusted(metrics::kGap, metrics::kSpace, -metrics::kGap, -metrics::kSpace);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QRect frame(area.topLeft(), QSize(kPictureWidth, kPictureHeight));
    painter.setPen(c.border);
    // The pictures are made for the light theme's drawing.
    painter.setBrush(lightColours().background);
    painter.drawRoundedRect(QRectF(frame).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kGap,
                            metrics::kGap);
    const auto picture = index.data(Qt::DecorationRole).value<QPixmap>();
    if (!picture.isNull()) {
        const QSize size = picture.size().scaled(frame.size() - QSize(4, 4), Qt::KeepAspectRatio);
        QRect target(QPoint(), size);
        target.moveCenter(frame.center());
        painter.drawPixmap(target, picture);
    }
    const bool stuck = index.data(OverviewModel::StuckRole).toBool();
    const bool finished = index.data(OverviewModel::FinishedRole).toBool();
    const QString sign = stuck ? QStringLiteral("! ") : finished ? QStringLiteral("\u2713 ") : "";
    const QColor tone = stuck ? c.warning : finished ? c.ok : c.text;
    area.setTop(frame.bottom() + metrics::kGap);
    painter.setFont(option.font);
    painter.setPen(tone);
    const QFontMetrics& font = option.fontMetrics;
    painter.drawText(area.left(), area.top() + font.ascent(),
                     font.elidedText(sign + text, Qt::ElideRight, area.width()));
    painter.setPen(c.mutedText);
    painter.drawText(area.left(), area.top() + font.height() + font.ascent(),
                     index.data(OverviewModel::TimeRole).toString());
    painter.restore();
}

}  // namespace ew
