// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QString>
#include <vector>

#include "core/document/lesson/lesson.h"
#include "core/document/resources.h"
#include "core/tlib/library.h"

namespace ew::test {

/// The shipped templates and nothing of the person's.
inline const TemplateLibrary& shippedLibrary() {
    static const TemplateLibrary library =
        loadTemplates(QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/templates"), {})->library;
    return library;
}

inline QString lessonFolder(const QString& id) {
    return QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/lessons/") + id;
}

inline QStringList shippedLessons() {
    return QDir(QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/lessons"))
        .entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
}

}  // namespace ew::test
