// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <optional>

namespace ew {

/// What a person means by a number with decimals, as the locale writes it without group separators.
/// A comma and a point are both a decimal mark, whatever the language; where both are there, the
/// last one is, and the other must stand between groups of three digits.
/// \return nothing where it cannot be meant, as with "1,2,3" or "1e1": it is never guessed.
std::optional<QString> decimalText(const QString& typed, const QLocale& locale);

/// What a person means by a sum: numbers as in decimalText, fractions ("3/4", "1 1/2"), + - * / and
/// brackets.
/// \param unit  of the field, after which numbers without one count: "mm" for a length, where mm,
///     cm, m, in (or ") and ft (or ') may follow each number; any other word may only follow all of
///     it.
/// \return in the field's unit; nothing where it cannot be meant, as with "2 in * 3 in", which is
/// no
///     length, "1/0" or "2 kg".
std::optional<double> quantity(const QString& typed, const QString& unit);

}  // namespace ew
