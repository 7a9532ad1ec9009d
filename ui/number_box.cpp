// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/number_box.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QRegularExpression>
#include <limits>

#include "ui/quantity.h"

namespace ew {

namespace {

/// What is typed, without prefix and unit. A unit may stand there twice: the field's own, and the
/// one that was typed before it.
QString bare(QString text, const QString& prefix, const QString& suffix) {
    if (!prefix.isEmpty() && text.startsWith(prefix)) text.remove(0, prefix.size());
    const QString unit = suffix.trimmed();
    text = text.trimmed();
    for (int i = 0; i < 2 && !unit.isEmpty(); ++i) {
        if (!text.endsWith(unit, Qt::CaseInsensitive)) break;
        text.chop(unit.size());
        text = text.trimmed();
    }
    return text;
}

bool isEnter(const QKeyEvent& event) {
    return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

/// Red while what stands there is refused.
void mark(QLineEdit& line, const QPalette& normal, bool refused) {
    QPalette palette = normal;
    if (refused) palette.setColor(QPalette::Text, normal.color(QPalette::BrightText));
    line.setPalette(palette);
}

QString rangeSentence(const QString& typed, const QString& least, const QString& most) {
    return NumberBox::tr("\u201c%1\u201d is not between %2 and %3; the old number stays.")
        .arg(typed, least, most);
}

}  // namespace

// With decimals ----------------------------------------------------------------------------------

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    // A number counts when it is typed as a whole: 1.2 is not what 1.2.3 begins with.
    setKeyboardTracking(false);
    connect(lineEdit(), &QLineEdit::textChanged, this,
            [this] { mark(*lineEdit(), palette(), false); });
}

std::optional<double> NumberBox::meant(const QString& text) const {
    const QString typed = bare(text, prefix(), suffix());
    if (!specialValueText().isEmpty() &&
        typed.compare(specialValueText(), Qt::CaseInsensitive) == 0) {
        return minimum();
    }
    const auto number = quantity(typed, suffix().trimmed());
    if (!number) return std::nullopt;
    return QString::number(*number, 'f', decimals()).toDouble();
}

QValidator::State NumberBox::validate(QString& text, int& /*position*/) const {
    const auto number = meant(text);
    return number && *number >= minimum() && *number <= maximum() ? QValidator::Acceptable
                                                                  : QValidator::Intermediate;
}

double NumberBox::valueFromText(const QString& text) const { return meant(text).value_or(value()); }

bool NumberBox::refuses() {
    const QString text = lineEdit()->text();
    const QString typed = bare(text, prefix(), suffix());
    if (typed.isEmpty() || hasAcceptableInput()) return false;
    mark(*lineEdit(), palette(), true);
    emit refused(meant(text)
                     ? rangeSentence(typed, textFromValue(minimum()), textFromValue(maximum()))
                     : tr("\u201c%1\u201d is not a number; the old one stays.").arg(typed));
    return true;
}

void NumberBox::keyPressEvent(QKeyEvent* event) {
    if (isEnter(*event) && refuses()) {
        selectAll();
        return;
    }
    QDoubleSpinBox::keyPressEvent(event);
}

void NumberBox::focusOutEvent(QFocusEvent* event) {
    (void)refuses();
    QDoubleSpinBox::focusOutEvent(event);
}

// Whole ------------------------------------------------------------------------------------------

WholeNumberBox::WholeNumberBox(QWidget* parent) : QSpinBox(parent) {
    setKeyboardTracking(false);
    connect(lineEdit(), &QLineEdit::textChanged, this,
            [this] { mark(*lineEdit(), palette(), false); });
}

std::optional<int> WholeNumberBox::meant(const QString& text) const {
    static const QRegularExpression kWhole(QStringLiteral(R"(^[-+]?\d+$)"));
    const QString typed = bare(text, prefix(), suffix());
    if (!kWhole.match(typed).hasMatch()) return std::nullopt;
    // What does not fit into an int is out of every range.
    bool fits = false;
    const int number = typed.toInt(&fits);
    if (fits) return number;
    return typed.startsWith(QLatin1Char('-')) ? std::numeric_limits<int>::min()
                                              : std::numeric_limits<int>::max();
}

QValidator::State WholeNumberBox::validate(QString& text, int& /*position*/) const {
    const auto number = meant(text);
    return number && *number >= minimum() && *number <= maximum() ? QValidator::Acceptable
                                                                  : QValidator::Intermediate;
}

int WholeNumberBox::valueFromText(const QString& text) const {
    return meant(text).value_or(value());
}

bool WholeNumberBox::refuses() {
    const QString text = lineEdit()->text();
    const QString typed = bare(text, prefix(), suffix());
    if (typed.isEmpty() || hasAcceptableInput()) return false;
    mark(*lineEdit(), palette(), true);
    emit refused(meant(text)
                     ? rangeSentence(typed, textFromValue(minimum()), textFromValue(maximum()))
                     : tr("\u201c%1\u201d is not a whole number; the old one stays.").arg(typed));
    return true;
}

void WholeNumberBox::keyPressEvent(QKeyEvent* event) {
    if (isEnter(*event) && refuses()) {
        selectAll();
        return;
    }
    QSpinBox::keyPressEvent(event);
}

void WholeNumberBox::focusOutEvent(QFocusEvent* event) {
    (void)refuses();
    QSpinBox::focusOutEvent(event);
}

}  // namespace ew
