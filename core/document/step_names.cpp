// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/step_names.h"

#include <QCoreApplication>

namespace ew {

namespace {

constexpr const char* kContext = "ew::Document";

constexpr const char* kNames[] = {
    QT_TRANSLATE_NOOP("ew::Document", "Add %1"),
    QT_TRANSLATE_NOOP("ew::Document", "Cut %1"),
    QT_TRANSLATE_NOOP("ew::Document", "Create %1"),
    QT_TRANSLATE_NOOP("ew::Document", "Define template \u201c%1\u201d"),
    QT_TRANSLATE_NOOP("ew::Document", "Change template \u201c%1\u201d"),
    QT_TRANSLATE_NOOP("ew::Document", "Delete solid"),
    QT_TRANSLATE_NOOP("ew::Document", "Cut in two"),
    QT_TRANSLATE_NOOP("ew::Document", "Pull face"),
    QT_TRANSLATE_NOOP("ew::Document", "Move solid"),
    QT_TRANSLATE_NOOP("ew::Document", "Copy solid"),
    QT_TRANSLATE_NOOP("ew::Document", "Name solid"),
    QT_TRANSLATE_NOOP("ew::Document", "Show solid"),
    QT_TRANSLATE_NOOP("ew::Document", "Hide solid"),
    QT_TRANSLATE_NOOP("ew::Document", "Join solids"),
    QT_TRANSLATE_NOOP("ew::Document", "Subtract solid"),
    QT_TRANSLATE_NOOP("ew::Document", "Set mirror plane"),
    QT_TRANSLATE_NOOP("ew::Document", "Drop mirror plane"),
    QT_TRANSLATE_NOOP("ew::Document", "Fillet 1 edge"),
    QT_TRANSLATE_NOOP("ew::Document", "Fillet %1 edges"),
    QT_TRANSLATE_NOOP("ew::Document", "Sharpen 1 edge"),
    QT_TRANSLATE_NOOP("ew::Document", "Sharpen %1 edges"),
    QT_TRANSLATE_NOOP("ew::Document", "Crease 1 edge"),
    QT_TRANSLATE_NOOP("ew::Document", "Crease %1 edges"),
    QT_TRANSLATE_NOOP("ew::Document", "Smooth surface"),
    QT_TRANSLATE_NOOP("ew::Document", "Surface off"),
    QT_TRANSLATE_NOOP("ew::Document", "Map 1 stroke"),
    QT_TRANSLATE_NOOP("ew::Document", "Map %1 strokes"),
    QT_TRANSLATE_NOOP("ew::Document", "Remove strokes from surface")};

/// A shape's name is small in an English sentence and translated by its name as it stands alone.
QString shownPart(const QString& part) {
    const QString several = QStringLiteral(" solids");
    if (part.endsWith(several)) {
        QString shown = QCoreApplication::translate("Core", "%1 solids");
        return shown.replace(QStringLiteral("%1"), part.chopped(several.size()));
    }
    const QString alone = part.left(1).toUpper() + part.mid(1);
    const QString translated = QCoreApplication::translate("Core", alone.toUtf8().constData());
    return translated == alone ? part : translated;
}

}  // namespace

QString shownStepName(const QString& english) {
    for (const char* name : kNames) {
        const QString source = QString::fromUtf8(name);
        const QString shown = QCoreApplication::translate(kContext, name);
        if (english == source) return shown;
        if (shown == source) continue;
        const qsizetype place = source.indexOf(QStringLiteral("%1"));
        const QString before = source.left(place);
        const QString after = source.mid(place + 2);
        const bool fits = place >= 0 && english.size() > source.size() - 2 &&
                          english.startsWith(before) && english.endsWith(after);
        if (!fits) continue;
        QString text = shown;
        return text.replace(
            QStringLiteral("%1"),
            shownPart(english.mid(place, english.size() - before.size() - after.size())));
    }
    return english;
}

}  // namespace ew
