// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_names.h"

#include <QHash>
#include <QLocale>

#include "core/tlib/library.h"

namespace ew {

namespace {

QHash<QString, QString>& texts() {
    static QHash<QString, QString> known;
    return known;
}

void learn(const std::string& text, const std::string& here) {
    if (text.empty()) return;
    const QString word = QString::fromStdString(text);
    if (here.empty()) {
        texts().remove(word);
    } else {
        texts().insert(word, QString::fromStdString(here));
    }
}

}  // namespace

void learnTemplateNames(const TemplateLibrary& library) {
    const QString whole = QLocale().bcp47Name();
    for (std::size_t i = 0; i < library.size(); ++i) {
        const Template& t = library.at(i);
        const auto& all = t.about.inLanguage;
        auto words = all.find(whole.toStdString());
        if (words == all.end()) words = all.find(whole.section('-', 0, 0).toStdString());
        const TemplateWords here = words == all.end() ? TemplateWords{} : words->second;
        learn(t.name, here.name);
        learn(t.description, here.description);
    }
}

QString ownTemplateText(const QString& text) { return texts().value(text, text); }

}  // namespace ew
