// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

namespace ew {

Result<std::string> readFileBytes(const QString& path, std::size_t maxBytes) {
    const std::string name = path.toStdString();
    const QFileInfo info(path);
    if (!info.exists()) return fail(Errc::FileNotFound, "There is no file at " + name + ".");
    if (info.isDir()) return fail(Errc::FileNotFound, name + " is a folder, not a file.");
    const auto tooLarge = [&] {
        return fail(Errc::TooLarge,
                    name + " is larger than " + std::to_string(maxBytes >> 20U) + " MiB.");
    };
    if (info.size() > static_cast<qint64>(maxBytes)) return tooLarge();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return fail(Errc::FileNotFound,
                    name + " cannot be read: " + file.errorString().toStdString() + ".");
    }
    // One byte more than allowed: a pipe or device has no size to ask for.
    const QByteArray bytes = file.read(static_cast<qint64>(maxBytes) + 1);
    if (bytes.size() > static_cast<qsizetype>(maxBytes)) return tooLarge();
    return bytes.toStdString();
}

Result<void> writeFileBytes(const QString& path, std::string_view bytes) {
    QSaveFile file(path);
    const auto size = static_cast<qint64>(bytes.size());
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes.data(), size) != size ||
        !file.commit()) {
        return fail(Errc::CannotWrite, path.toStdString() + " cannot be written: " +
                                           file.errorString().toStdString() + ".");
    }
    return {};
}

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
    auto file = readDocument(*text, shipped);
    if (!file) {
        const std::string name = QFileInfo(path).fileName().toStdString();
        return fail(file.error().code, name + ": " + file.error().message);
    }
    return file;
}

}  // namespace ew
