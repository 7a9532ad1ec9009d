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
/// \return nothing where it cannot be meant, as with "1,2,3" or "1e1": it is never guessed.
std::optional<QString> decimalText(const QString& typed, const QLocale& locale);

/// A field for a number with decimals, its unit typed or not. What cannot be meant stays as it was
/// typed and is refused when it is to count; the value stays. Every printable key is the field's
/// while it has the focus.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

  public:
    explicit NumberBox(QWidget* parent = nullptr);
    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;

  signals:
    /// \param why  a sentence in the window's language.
    void refused(const QString& why);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    std::optional<double> meant(const QString& text) const;
    /// Tells what is wrong with the text, if anything is.
    bool refuses();
};

/// The same for a whole number, which has no mark of any kind: "2.5" is not 25.
class WholeNumberBox : public QSpinBox {
    Q_OBJECT

  public:
    explicit WholeNumberBox(QWidget* parent = nullptr);
    QValidator::State validate(QString& text, int& position) const override;
    int valueFromText(const QString& text) const override;

  signals:
    /// \param why  a sentence in the window's language.
    void refused(const QString& why);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    std::optional<int> meant(const QString& text) const;
    bool refuses();
};

}  // namespace ew
