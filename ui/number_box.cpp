// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/number_box.h"

#include <QKeyEvent>
#include <QRegularExpression>

namespace ew {

namespace {

/// Prefix and suffix are no part of what is typed.
struct Parts {
    QString before, number, after;
};

Parts partsOf(const QString& text, const QString& prefix, const QString& suffix) {
    Parts parts{{}, text, {}};
    if (!prefix.isEmpty() && parts.number.startsWith(prefix)) {
        parts.before = prefix;
        parts.number.remove(0, prefix.size());
    }
    if (!suffix.isEmpty() && parts.number.endsWith(suffix)) {
        parts.after = suffix;
        parts.number.chop(suffix.size());
    }
    return parts;
}

/// The key of a letter that the field has no use for.
bool isForTheWindow(const QEvent& event, const QString& specialText) {
    if (event.type() != QEvent::ShortcutOverride) return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    const bool plain = (key.modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier;
    return plain && key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z &&
           !specialText.contains(QChar(key.key()), Qt::CaseInsensitive);
}

}  // namespace

std::optional<QString> decimalText(const QString& typed, const QLocale& locale) {
    const auto points = typed.count(QLatin1Char('.'));
    const auto commas = typed.count(QLatin1Char(','));
    QString text = typed;
    if (points + commas == 0) return text;
    if (points + commas == 1) {
        text.replace(QLatin1Char(points == 1 ? '.' : ','), locale.decimalPoint());
        return text;
    }
    static const QRegularExpression kGrouped(
        QStringLiteral(R"(^\s*[-+]?\d{1,3}(?:(?:\.\d{3})+,|(?:,\d{3})+\.)\d*\s*$)"));
    if (!kGrouped.match(typed).hasMatch()) return std::nullopt;
    const bool decimalComma =
        typed.lastIndexOf(QLatin1Char(',')) > typed.lastIndexOf(QLatin1Char('.'));
    text.remove(QLatin1Char(decimalComma ? '.' : ','));
    text.replace(QLatin1Char(decimalComma ? ',' : '.'), locale.decimalPoint());
    return text;
}

QValidator::State NumberBox::validate(QString& text, int& position) const {
    const Parts parts = partsOf(text, prefix(), suffix());
    const auto number = decimalText(parts.number, locale());
    if (!number) return QValidator::Invalid;
    QString meant = parts.before + *number + parts.after;
    return QDoubleSpinBox::validate(meant, position);
}

double NumberBox::valueFromText(const QString& text) const {
    const Parts parts = partsOf(text, prefix(), suffix());
    const auto number = decimalText(parts.number, locale());
    if (!number) return value();
    return QDoubleSpinBox::valueFromText(parts.before + *number + parts.after);
}

bool NumberBox::event(QEvent* event) {
    if (!isForTheWindow(*event, specialValueText())) return QDoubleSpinBox::event(event);
    event->ignore();
    return false;
}

QValidator::State WholeNumberBox::validate(QString& text, int& position) const {
    const QString number = partsOf(text, prefix(), suffix()).number;
    if (number.contains(QLatin1Char('.')) || number.contains(QLatin1Char(','))) {
        return QValidator::Invalid;
    }
    return QSpinBox::validate(text, position);
}

bool WholeNumberBox::event(QEvent* event) {
    if (!isForTheWindow(*event, specialValueText())) return QSpinBox::event(event);
    event->ignore();
    return false;
}

}  // namespace ew
