// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store.h"

#include <QFileInfo>

#include "core/document/file_names.h"

namespace ew {

Result<void> saveDocument(const DocumentFile& file, const QString& path) {
    const std::string text = writeDocument(file);
    if (text.size() > kMaxDocumentBytes) {
        return fail(Errc::TooLarge, "The document is larger than " +
                                        std::to_string(kMaxDocumentBytes >> 20U) +
                                        " MiB and could not be opened again.");
    }
    return writeFileBytes(path, text);
}

Result<DocumentFile> loadDocument(const QString& path, const TemplateLibrary& shipped) {
    auto text = readFileBytes(path, kMaxDocumentBytes);
    if (!text) return fail(text.error());
    const std::string name = QFileInfo(path).fileName().toStdString();
    if (auto ok = refuseOtherKinds(name, *text); !ok) return fail(ok.error());
    auto file = readDocument(*text, shipped);
    if (!file) {
        return fail(file.error().code, name + ": " + file.error().message);
    }
    return file;
}

}  // namespace ew
