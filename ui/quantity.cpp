// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/quantity.h"

#include <QRegularExpression>
#include <array>
#include <cmath>
#include <utility>

namespace ew {
namespace {

constexpr int kDeepest = 40;  // brackets within brackets

struct LengthUnit {
    const char* name;
    double mm;
};
constexpr std::array<LengthUnit, 9> kLengthUnits{{{"mm", 1.0},
                                                  {"cm", 10.0},
                                                  {"m", 1000.0},
                                                  {"inch", 25.4},
                                                  {"in", 25.4},
                                                  {"\"", 25.4},
                                                  {"ft", 304.8},
                                                  {"'", 304.8},
                                                  {"\u2033", 25.4}}};

/// A number and how many lengths were multiplied in it; a length is in mm.
struct Value {
    double number = 0.0;
    int lengths = 0;
};

/// sum := product {(+|-) product}; product := factor {(*|/) factor};
/// factor := [+|-] (number [unit] {number unit} | "(" sum ")" [unit])
class Reader {
  public:
    Reader(QString text, QString unit) : text_(std::move(text)), unit_(std::move(unit)) {}

    std::optional<double> all() {
        const auto value = sum();
        skip();
        if (!value || at_ < text_.size() || !std::isfinite(value->number)) return std::nullopt;
        if (value->lengths != 0 && value->lengths != 1) return std::nullopt;
        return value->number;
    }

  private:
    bool isLength() const { return unit_ == QLatin1String("mm"); }

    void skip() {
        while (at_ < text_.size() && text_[at_].isSpace()) ++at_;
    }
    bool take(QChar c) {
        skip();
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    bool takeAny(std::initializer_list<char16_t> signs) {
        for (const char16_t c : signs) {
            if (take(QChar(c))) return true;
        }
        return false;
    }

    std::optional<Value> sum() {
        auto value = product();
        while (value) {
            const bool plus = take(QLatin1Char('+'));
            if (!plus && !takeAny({u'-', u'\u2212'})) break;
            const auto next = product();
            if (!next) return std::nullopt;
            if (!fit(*value, *next)) return std::nullopt;
            value->number += plus ? next->number : -next->number;
            value->lengths = std::max(value->lengths, next->lengths);
        }
        return value;
    }

    /// A number without a unit is in the field's unit, so it may be added to a length.
    static bool fit(const Value& a, const Value& b) {
        return a.lengths == b.lengths ||
               (std::min(a.lengths, b.lengths) == 0 && std::max(a.lengths, b.lengths) == 1);
    }

    std::optional<Value> product() {
        auto value = factor();
        while (value) {
            const bool times = takeAny({u'*', u'\u00d7', u'\u00b7'});
            if (!times && !takeAny({u'/', u'\u00f7'})) break;
            const auto next = factor();
            if (!next || (!times && next->number == 0.0)) return std::nullopt;
            value->number = times ? value->number * next->number : value->number / next->number;
            value->lengths += times ? next->lengths : -next->lengths;
        }
        return value;
    }

    std::optional<Value> factor() {
        if (take(QLatin1Char('+'))) return factorAfterSign();
        if (!takeAny({u'-', u'\u2212'})) return factorAfterSign();
        auto value = factorAfterSign();
        if (value) value->number = -value->number;
        return value;
    }

    std::optional<Value> factorAfterSign() {
        if (take(QLatin1Char('('))) {
            if (++depth_ > kDeepest) return std::nullopt;
            const auto value = sum();
            --depth_;
            if (!value || !take(QLatin1Char(')'))) return std::nullopt;
            return withUnit(*value);
        }
        auto value = measure();
        // 5 ft 6 in
        while (value && value->lengths == 1 && startsNumber()) {
            const auto next = measure();
            if (!next || next->lengths != 1) return std::nullopt;
            value->number += next->number;
        }
        return value;
    }

    bool startsNumber() {
        skip();
        return at_ < text_.size() && (text_[at_].isDigit() || text_[at_] == QLatin1Char('.') ||
                                      text_[at_] == QLatin1Char(','));
    }

    /// A number or fraction with its unit, where it has one.
    std::optional<Value> measure() {
        static const QRegularExpression kFraction(
            QStringLiteral(R"(\G\s*(?:(\d+)\s+)?(\d+)\s*/\s*(\d+)(?![\d.,]))"));
        static const QRegularExpression kNumber(QStringLiteral(R"(\G\s*([\d.,]+))"));
        Value value;
        if (const auto m = kFraction.match(text_, at_); m.hasMatch()) {
            const double below = m.captured(3).toDouble();
            if (below == 0.0) return std::nullopt;
            value.number = m.captured(1).toDouble() + m.captured(2).toDouble() / below;
            at_ = m.capturedEnd();
        } else if (const auto n = kNumber.match(text_, at_); n.hasMatch()) {
            const auto plain = decimalText(n.captured(1), QLocale::c());
            if (!plain) return std::nullopt;
            value.number = plain->toDouble();
            at_ = n.capturedEnd();
        } else {
            return std::nullopt;
        }
        return withUnit(value);
    }

    std::optional<Value> withUnit(Value value) {
        skip();
        if (!isLength() || at_ >= text_.size()) return value;
        for (const LengthUnit& u : kLengthUnits) {
            const QString name = QString::fromUtf8(u.name);
            if (!QStringView(text_).mid(at_).startsWith(name, Qt::CaseInsensitive)) continue;
            const auto end = at_ + name.size();
            const bool word = name[0].isLetter();
            if (word && end < text_.size() && text_[end].isLetter()) continue;  // "mil" is no "m"
            at_ = end;
            value.number *= u.mm;
            ++value.lengths;
            return value;
        }
        return value;
    }

    QString text_;
    QString unit_;
    qsizetype at_ = 0;
    int depth_ = 0;
};

}  // namespace

std::optional<QString> decimalText(const QString& typed, const QLocale& locale) {
    static const QRegularExpression kPlain(
        QStringLiteral(R"(^\s*[-+]?(?:\d+[.,]?\d*|[.,]\d+)\s*$)"));
    static const QRegularExpression kGrouped(
        QStringLiteral(R"(^\s*[-+]?\d{1,3}(?:(?:\.\d{3})+,|(?:,\d{3})+\.)\d*\s*$)"));
    QString text = typed;
    if (kPlain.match(typed).hasMatch()) {
        text.replace(QLatin1Char('.'), locale.decimalPoint());
        text.replace(QLatin1Char(','), locale.decimalPoint());
        return text;
    }
    if (!kGrouped.match(typed).hasMatch()) return std::nullopt;
    const bool decimalComma =
        typed.lastIndexOf(QLatin1Char(',')) > typed.lastIndexOf(QLatin1Char('.'));
    text.remove(QLatin1Char(decimalComma ? '.' : ','));
    text.replace(QLatin1Char(decimalComma ? ',' : '.'), locale.decimalPoint());
    return text;
}

std::optional<double> quantity(const QString& typed, const QString& unit) {
    constexpr qsizetype kLongest = 200;
    if (typed.size() > kLongest) return std::nullopt;
    return Reader(typed, unit).all();
}

}  // namespace ew
