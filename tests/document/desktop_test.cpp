// SPDX-License-Identifier: GPL-3.0-or-later
// What file managers are told of the program is what its documents are.
#include <gtest/gtest.h>

#include <QFile>
#include <QRegularExpression>
#include <QString>
#include <QTemporaryDir>
#include <cstdint>
#include <string>

#include "core/document/file_bytes.h"
#include "core/document/file_names.h"
#include "core/document/store_schema.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

QString desktopFile(const char* name) {
    QFile file(QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/packaging/desktop/") + name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name;
    return QString::fromUtf8(file.readAll());
}

TEST(Desktop, TheMimeTypeIsThatOfDocuments) {
    const QString mime = desktopFile("edgewright-mime.xml");
    const QString id =
        QStringLiteral("value=\"0x%1\"").arg(schema::kApplicationId, 8, 16, QChar('0'));
    EXPECT_TRUE(mime.contains(id)) << id.toStdString();
    EXPECT_TRUE(mime.contains(QStringLiteral("<glob pattern=\"*%1\"/>").arg(kDocumentEnding)));
    EXPECT_TRUE(mime.contains(QStringLiteral("type=\"application/x-edgewright\"")));
    EXPECT_TRUE(desktopFile("edgewright.desktop")
                    .contains(QStringLiteral("MimeType=application/x-edgewright;")));
}

/// The first bytes of a document are what the type's magic says.
TEST(Desktop, ADocumentIsKnownByItsContentAlone) {
    const QTemporaryDir folder;
    const auto d = test::fakeDocument();
    ASSERT_TRUE(d->addStroke(test::line({0, 0}, {5, 5})));
    ASSERT_TRUE(d->save(folder.filePath(QStringLiteral("d.edgewright"))));
    const auto bytes = readFileBytes(folder.filePath(QStringLiteral("d.edgewright")), 1U << 26U);
    ASSERT_TRUE(bytes);
    const QString mime = desktopFile("edgewright-mime.xml");
    const QRegularExpression match(
        QStringLiteral("<match type=\"(\\w+)\" offset=\"(\\d+)\" value=\"([^\"]+)\""));
    int matches = 0;
    for (auto all = match.globalMatch(mime); all.hasNext(); ++matches) {
        const auto one = all.next();
        const auto offset = static_cast<std::size_t>(one.captured(2).toInt());
        const std::string value = one.captured(3).toStdString();
        if (one.captured(1) == QStringLiteral("string")) {
            ASSERT_EQ(value, "SQLite format 3\\0");
            EXPECT_EQ(bytes->substr(offset, 16), std::string("SQLite format 3\0", 16));
            continue;
        }
        ASSERT_EQ(one.captured(1), QStringLiteral("big32"));
        std::uint32_t number = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            number = (number << 8U) | static_cast<unsigned char>((*bytes)[offset + k]);
        }
        EXPECT_EQ(number, std::stoul(value, nullptr, 16));
    }
    EXPECT_EQ(matches, 2);
}

}  // namespace
}  // namespace ew
