// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/outlined_style.h"

#include <QPainter>
#include <QStyleOption>

#include "ui/theme/colours.h"
#include "ui/theme/themed_icon.h"

namespace ew {
namespace {

void outline(const QStyleOption& option, QPainter& painter) {
    const QColor window = option.palette.color(QPalette::Window);
    if (!isDark(window)) return;
    // Fusion itself marks the field that has the focus.
    const bool focused = option.state.testFlag(QStyle::State_HasFocus) &&
                         option.state.testFlag(QStyle::State_Enabled);
    if (focused) return;
    constexpr double kShare = 0.55;
    constexpr double kRadius = 2.0;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(mixColours(option.palette.color(QPalette::WindowText), window, kShare));
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), kRadius, kRadius);
    painter.restore();
}

}  // namespace

void OutlinedStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                  QPainter* painter, const QWidget* widget) const {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_IndicatorCheckBox || element == PE_FrameLineEdit) outline(*option, *painter);
}

QIcon OutlinedStyle::standardIcon(StandardPixmap which, const QStyleOption* option,
                                  const QWidget* widget) const {
    // Fusion's arrow is dark in every theme.
    if (which == SP_ToolBarHorizontalExtensionButton) return themedIcon(QStringLiteral("more"));
    return QProxyStyle::standardIcon(which, option, widget);
}

int OutlinedStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                               const QWidget* widget) const {
    constexpr int kExtension = 22;
    if (metric == PM_ToolBarExtensionExtent) return kExtension;
    return QProxyStyle::pixelMetric(metric, option, widget);
}

void OutlinedStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                       QPainter* painter, const QWidget* widget) const {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_SpinBox) outline(*option, *painter);
}

}  // namespace ew
