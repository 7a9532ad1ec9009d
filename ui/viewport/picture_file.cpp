// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/picture_file.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImageWriter>
#include <algorithm>

#include "core/document/file_bytes.h"

namespace ew {

namespace {

constexpr int kQuality = 95;  // of formats that lose something

/// PNG where the name has no ending, as that of a device has none.
QByteArray formatOf(const QString& path) {
    const QByteArray ending = QFileInfo(path).suffix().toLower().toLatin1();
    return ending.isEmpty() ? QByteArray("png") : ending;
}

bool isSeenThrough(const QImage& image) {
    if (!image.hasAlphaChannel()) return false;
    const QImage alpha = image.convertToFormat(QImage::Format_Alpha8);
    for (int y = 0; y < alpha.height(); ++y) {
        const uchar* row = alpha.constScanLine(y);
        if (std::any_of(row, row + alpha.width(), [](uchar a) { return a != 255; })) return true;
    }
    return false;
}

}  // namespace

Result<void> checkPictureName(const QString& path) {
    if (QImageWriter::supportedImageFormats().contains(formatOf(path))) return {};
    return fail(Errc::UnknownExtension,
                "The extension ." + QFileInfo(path).suffix().toStdString() +
                    " names no format that pictures can be written in; use .png or .jpg.");
}

Result<void> writePicture(const QImage& image, const QString& path) {
    if (auto ok = checkPictureName(path); !ok) return ok;
    const QByteArray format = formatOf(path);
    if ((format == "jpg" || format == "jpeg") && isSeenThrough(image)) {
        return fail(Errc::CannotWrite, "A JPEG picture cannot be transparent; use .png.");
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) ||
        !image.save(&buffer, format.constData(), format == "png" ? -1 : kQuality)) {
        return fail(Errc::CannotWrite,
                    "The picture " + path.toStdString() + " could not be put into a file.");
    }
    return writeFileBytes(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace ew
