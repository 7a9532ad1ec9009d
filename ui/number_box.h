// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QLocale>
#include <QSpinBox>
#include <optional>

namespace ew {

/// What a person means by a number with decimals, as the locale writes it without group separators.
/// A comma and a point are both a decimal mark, whatever the language; where both are there, the
/// last one is, and the other must stand between groups of three digits.
/// \return nothing where it cannot be meant, as with "1,2,3": it is never guessed.
std::optional<QString> decimalText(const QString& typed, const QLocale& locale);

/// A field for a number with decimals. A letter that is no part of a number is left to the window's
/// shortcuts.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

  public:
    using QDoubleSpinBox::QDoubleSpinBox;
    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;

  protected:
    bool event(QEvent* event) override;
};

/// The same for a whole number, which has no mark of any kind: "2.5" is not 25.
class WholeNumberBox : public QSpinBox {
    Q_OBJECT

  public:
    using QSpinBox::QSpinBox;
    QValidator::State validate(QString& text, int& position) const override;

  protected:
    bool event(QEvent* event) override;
};

}  // namespace ew
