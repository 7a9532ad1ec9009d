// SPDX-License-Identifier: GPL-3.0-or-later
// Every text that the code hands to tr() is translated, and nothing is translated that the code no
// longer says. Where this fails:
//   /usr/lib/qt6/bin/lupdate -I . ui app core -locations none -no-obsolete \
//       -ts translations/edgewright_de.ts
// and fill in what is unfinished. English has a file for its plurals only (-pluralonly).
#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <map>

namespace ew::test {
namespace {

struct Message {
    bool plural = false;
    bool finished = true;
    QStringList forms;  ///< of the translation: one, or one for each plural form
};
/// By context, source and comment.
using Messages = std::map<std::array<QString, 3>, Message>;

void readMessage(QXmlStreamReader& xml, const QString& context, Messages& out) {
    Message message;
    message.plural = xml.attributes().value("numerus") == QStringLiteral("yes");
    QString source;
    QString comment;
    while (xml.readNextStartElement()) {
        if (xml.name() == QStringLiteral("source")) {
            source = xml.readElementText();
        } else if (xml.name() == QStringLiteral("comment")) {
            comment = xml.readElementText();
        } else if (xml.name() == QStringLiteral("translation")) {
            message.finished = !xml.attributes().hasAttribute("type");
            if (!message.plural) {
                message.forms << xml.readElementText();
            } else {
                while (xml.readNextStartElement()) message.forms << xml.readElementText();
            }
        } else {
            xml.skipCurrentElement();
        }
    }
    out[{context, source, comment}] = message;
}

Messages readTs(const QString& path) {
    Messages out;
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QStringLiteral("context")) context.clear();
        if (xml.name() == QStringLiteral("name")) context = xml.readElementText();
        if (xml.name() == QStringLiteral("message")) readMessage(xml, context, out);
    }
    EXPECT_FALSE(xml.hasError()) << path.toStdString() << ": " << xml.errorString().toStdString();
    return out;
}

QString translationFile(const char* language) {
    return QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/translations/edgewright_%1.ts").arg(language);
}

/// What the code says, as lupdate finds it.
const Messages& textsOfTheCode() {
    static const Messages kTexts = [] {
        const QTemporaryDir folder;
        const QString ts = folder.filePath("code_de.ts");
        QProcess lupdate;
        lupdate.setWorkingDirectory(EDGEWRIGHT_SOURCE_DIR);
        lupdate.start(EDGEWRIGHT_LUPDATE,
                      {"-I", ".", "ui", "app", "core", "-locations", "none", "-ts", ts});
        EXPECT_TRUE(lupdate.waitForFinished(60'000)) << "lupdate did not run";
        EXPECT_EQ(lupdate.exitCode(), 0) << lupdate.readAllStandardError().toStdString();
        return readTs(ts);
    }();
    return kTexts;
}

std::string named(const std::array<QString, 3>& key) {
    return (key[0] + ": \"" + key[1] + '"').toStdString();
}

QStringList allMatches(const QString& text, const char* pattern) {
    QStringList found;
    auto it = QRegularExpression(pattern).globalMatch(text);
    while (it.hasNext()) found << it.next().captured();
    found.sort();
    return found;
}

TEST(Translations, LupdateSeesTheClassesOfTheNamespace) {
    EXPECT_GT(textsOfTheCode().size(), 150U);
    EXPECT_TRUE(textsOfTheCode().contains({"ew::MainWindow", "&File", ""}));
}

TEST(Translations, GermanHasEveryTextAndNoOther) {
    const Messages german = readTs(translationFile("de"));
    for (const auto& [key, message] : textsOfTheCode()) {
        EXPECT_TRUE(german.contains(key)) << named(key) << " is not in edgewright_de.ts";
    }
    for (const auto& [key, message] : german) {
        EXPECT_TRUE(textsOfTheCode().contains(key)) << named(key) << " is no longer in the code";
    }
}

TEST(Translations, EveryGermanTextIsFinished) {
    for (const auto& [key, message] : readTs(translationFile("de"))) {
        SCOPED_TRACE(named(key));
        EXPECT_TRUE(message.finished);
        ASSERT_EQ(message.forms.size(), message.plural ? 2 : 1);
        for (const QString& form : message.forms) {
            EXPECT_FALSE(form.isEmpty());
            EXPECT_EQ(allMatches(form, "%(\\d|n)"), allMatches(key[1], "%(\\d|n)"));
            EXPECT_EQ(allMatches(form, "&\\S").size(), allMatches(key[1], "&\\S").size());
            EXPECT_EQ(form.startsWith(' '), key[1].startsWith(' '));
            EXPECT_EQ(form.endsWith('.'), key[1].endsWith('.'));
        }
    }
}

TEST(Translations, EnglishHasEveryPlural) {
    const Messages english = readTs(translationFile("en"));
    for (const auto& [key, message] : textsOfTheCode()) {
        if (!message.plural) continue;
        const auto found = english.find(key);
        ASSERT_NE(found, english.end()) << named(key) << " is not in edgewright_en.ts";
        EXPECT_TRUE(found->second.finished);
        EXPECT_EQ(found->second.forms.size(), 2);
        EXPECT_FALSE(found->second.forms.contains(QString())) << named(key);
    }
    for (const auto& [key, message] : english) {
        EXPECT_TRUE(textsOfTheCode().contains(key)) << named(key) << " is no longer in the code";
    }
}

}  // namespace
}  // namespace ew::test
