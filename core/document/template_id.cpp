// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/template_id.h"

#include <QString>

namespace ew {

namespace {
constexpr qsizetype kLongestId = 64;
}

std::string idFromName(const std::string& name) {
    QString id;
    const QString plain =
        QString::fromStdString(name).normalized(QString::NormalizationForm_KD).toLower();
    for (const QChar c : plain) {
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
            id += c;
        } else if (c.category() != QChar::Mark_NonSpacing && !id.isEmpty() && !id.endsWith('-')) {
            id += '-';
        }
    }
    id.truncate(kLongestId);
    while (id.endsWith('-')) id.chop(1);
    return id.toStdString();
}

}  // namespace ew
