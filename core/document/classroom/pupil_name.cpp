// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/classroom/pupil_name.h"

#include <QCryptographicHash>
#include <QStringList>
#include <algorithm>

namespace ew {
namespace {

/// Can every letter be written down?
bool isText(const QString& name) {
    for (const uint code : name.toUcs4()) {
        if (QChar::isSurrogate(code) || QChar::category(code) == QChar::Other_Control) return false;
    }
    return name.isValidUtf16();
}

/// Of the name what no disk, no file manager and no command line stumbles over.
QString readablePart(const QString& name) {
    constexpr qsizetype kLongest = 24;
    QString out;
    for (const QChar c : name) {
        const bool plain = c.isLetterOrNumber() || c == QLatin1Char('_');
        if (plain) {
            out += c;
        } else if (!out.isEmpty() && !out.endsWith(QLatin1Char('-')) && !c.isMark()) {
            out += QLatin1Char('-');
        }
        if (out.size() >= kLongest) break;
    }
    while (out.endsWith(QLatin1Char('-'))) out.chop(1);
    return out.isEmpty() ? QStringLiteral("pupil") : out;
}

}  // namespace

Result<QString> pupilName(const QString& typed) {
    const QString name = typed.simplified().normalized(QString::NormalizationForm_C);
    if (name.isEmpty()) return fail(Errc::BadValue, "A pupil has a name.");
    if (name.size() > kLongestPupilName) {
        return fail(Errc::BadValue, "A pupil's name has at most " +
                                        std::to_string(kLongestPupilName) + " letters.");
    }
    if (!isText(name)) {
        return fail(Errc::BadValue, "A pupil's name has letters only that can be seen.");
    }
    return name;
}

QString pupilFolderName(const QString& name, int copy) {
    constexpr qsizetype kSumDigits = 8;
    const QByteArray sum =
        QCryptographicHash::hash(name.toUtf8(), QCryptographicHash::Sha256).toHex();
    const QString out =
        readablePart(name) + QLatin1Char('-') + QString::fromLatin1(sum.first(kSumDigits));
    return copy > 1 ? out + QLatin1Char('-') + QString::number(copy) : out;
}

}  // namespace ew
