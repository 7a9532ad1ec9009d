// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/picture_file.h"

#include <QBuffer>

#include "core/document/file_bytes.h"

namespace ew {

Result<void> writePicture(const QImage& image, const QString& path) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !image.save(&buffer, "PNG")) {
        return fail(Errc::CannotWrite,
                    "The picture " + path.toStdString() + " could not be put into a file.");
    }
    return writeFileBytes(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace ew
