// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/resources.h"

#include <QCoreApplication>
#include <QDir>
#include <QStandardPaths>
#include <QStringList>

namespace ew {

Result<QString> resourcesFolder() {
    QStringList places;
    const QString named = qEnvironmentVariable("EDGEWRIGHT_RESOURCES");
    if (!named.isEmpty()) places << named;
    if (QCoreApplication::instance() != nullptr) {
        places << QCoreApplication::applicationDirPath() + "/../share/edgewright";
    }
    places << QStringLiteral(EDGEWRIGHT_SOURCE_RESOURCES);
    for (const QString& place : places) {
        if (QDir(place + "/templates").exists()) return QDir::cleanPath(place);
    }
    return fail(Errc::FileNotFound,
                "The templates that belong to this program are in none of these folders: " +
                    places.join(", ").toStdString() + ".");
}

QString personalTemplateFolder() {
    // Not AppDataLocation, which would differ from program to program.
    const QString data = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    return data.isEmpty() ? QString() : data + "/edgewright/templates";
}

Result<QString> ensurePersonalTemplateFolder() {
    const QString folder = personalTemplateFolder();
    if (folder.isEmpty() || !QDir().mkpath(folder)) {
        return fail(Errc::CannotWrite,
                    "The folder for your own templates cannot be made: " + folder.toStdString());
    }
    return folder;
}

Result<LibraryLoad> loadTemplates(const QString& shipped, const QString& personal) {
    auto load = loadLibrary(shipped.toStdString());
    if (!load) return fail(load.error());
    if (personal.isEmpty() || !QDir(personal).exists()) return load;
    auto own = loadLibrary(personal.toStdString());
    if (!own) return fail(own.error());
    for (Error& problem : own->problems) load->problems.push_back(std::move(problem));
    std::vector<Template> added;
    for (std::size_t i = 0; i < own->library.size(); ++i) {
        const Template& tmpl = own->library.at(i);
        if (load->library.find(tmpl.id) < 0) {
            added.push_back(tmpl);
            continue;
        }
        load->problems.push_back({Errc::DuplicateId,
                                  "The template \"" + tmpl.id + "\" in " + personal.toStdString() +
                                      " has the id of a template that belongs to the program.",
                                  {}});
    }
    auto library = load->library.withAll(std::move(added));
    if (!library) return fail(library.error());
    load->library = *std::move(library);
    return load;
}

Result<LibraryLoad> loadTemplates() {
    const auto folder = resourcesFolder();
    if (!folder) return fail(folder.error());
    return loadTemplates(*folder + "/templates", personalTemplateFolder());
}

}  // namespace ew
