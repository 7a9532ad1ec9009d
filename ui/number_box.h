// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>
#include <optional>

namespace ew {

/// A field for a number with decimals or a sum of such (quantity), its unit typed or not. What
/// cannot be meant stays as it was typed and is refused when it is to count; the value stays. Every
/// printable key is the field's while it has the focus.
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
