// SPDX-License-Identifier: GPL-3.0-or-later
// Documents of schema 1, as earlier versions wrote them: tests/data keeps five of them for ever.
#include "core/document/store_schema1.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <QTemporaryDir>
#include <QUndoStack>

#include "core/document/report.h"
#include "core/store/database.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

QString dataFile(const char* name) {
    return QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/tests/data/%1.edgewright").arg(name);
}

std::string smallText() { return *readFileBytes(dataFile("small"), kMaxSchema1Bytes); }

struct Kept {
    const char* name;
    int steps, index, strokes;  ///< of the history, done, pending
    int vertices;
    double volume;
};

/// What the version that wrote them said of them.
const std::vector<Kept> kKept{{"small", 5, 3, 3, 8, 63999.8},
                              {"undone", 3, 1, 3, 8, 3637.96},
                              {"template", 5, 5, 0, 8, 3637.96},
                              {"mouse", 17, 17, 0, 52, 191079},
                              {"printer", 20, 20, 0, 72, 624035}};

TEST(Schema1, TheFiveOpenAndAreConverted) {
    const QTemporaryDir folder;
    for (const Kept& kept : kKept) {
        SCOPED_TRACE(kept.name);
        Document d(test::shippedLibrary());
        const auto opened = d.open(dataFile(kept.name));
        ASSERT_TRUE(opened) << opened.error().message;
        EXPECT_FALSE(d.isModified());
        EXPECT_EQ(d.undoStack().count(), kept.steps);
        EXPECT_EQ(d.undoStack().index(), kept.index);
        EXPECT_EQ(static_cast<int>(d.pendingStrokes().size()), kept.strokes);
        const SolidSummary solid = summarize(d.state().bodies);
        EXPECT_EQ(solid.vertices, kept.vertices);
        EXPECT_NEAR(solid.volume, kept.volume, kept.volume * 1e-5);

        const QString path = folder.filePath(kept.name);
        ASSERT_TRUE(d.save(path));
        EXPECT_TRUE(isDatabase(*readFileBytes(d.filePath(), kMaxDocumentBytes)));
        Document e(test::shippedLibrary());
        const auto again = e.open(d.filePath());
        ASSERT_TRUE(again) << again.error().message;
        EXPECT_TRUE(test::sameState(d.state(), e.state()));
        EXPECT_EQ(writeSketchScript(d.recordedScript()), writeSketchScript(e.recordedScript()));
        for (int i = 0; i <= kept.steps; ++i) {
            ASSERT_TRUE(d.goToStep(i));
            ASSERT_TRUE(e.goToStep(i));
            EXPECT_TRUE(test::sameState(d.state(), e.state())) << i;
        }
    }
}

TEST(Schema1, RefusesAFileThatIsCutAnywhere) {
    const std::string whole = smallText();
    const TemplateLibrary library = test::smallLibrary();
    ASSERT_TRUE(readDocument(whole, library));
    const std::size_t lastBrace = whole.rfind('}');
    for (std::size_t n = 0; n <= lastBrace; ++n) {
        const auto read = readDocument(whole.substr(0, n), library);
        ASSERT_FALSE(read) << "cut after byte " << n;
        ASSERT_EQ(read.error().code, Errc::Syntax) << "cut after byte " << n;
    }
}

RC_GTEST_PROP(Schema1, MutatedFilesAreReadOrRefused, ()) {
    static const std::string whole = smallText();
    static const TemplateLibrary library = test::smallLibrary();
    std::string text = whole;
    const int changes = *rc::gen::inRange(1, 4);
    for (int i = 0; i < changes; ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
        text[at] = *rc::gen::element('{', '}', '[', ']', ',', ':', '"', '0', '1', '7', '9', '-',
                                     'e', '.', ' ', '/', '\x80');
    }
    const auto read = readDocument(text, library);
    if (read)
        RC_ASSERT(readDocument(*writeDocument(*read), library).has_value());
    else
        RC_ASSERT(!read.error().message.empty());
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(Schema1, RefusesWhatDoesNotHangTogether) {
    const std::string whole = smallText();
    const TemplateLibrary library = test::smallLibrary();
    struct Case {
        const char* from;
        const char* to;
        Errc code;
    };
    const std::vector<Case> table{
        {"edgewright-document", "edgewright-sketch", Errc::WrongFormat},
        {"\"version\": 1,", "\"version\": 9,", Errc::WrongVersion},
        {"\"version\": 1,", "\"version\": \"1\",", Errc::WrongType},
        {"\"index\": ", "\"index\": 99", Errc::BadValue},
        {"\"index\": ", "\"indx\": ", Errc::UnknownKey},
        {"\"solid\": 0", "\"solid\": 17", Errc::BadValue},
        {"\"solid\": 0", "\"solid\": -1", Errc::BadValue},
        {"\"solid\": 0", "\"solid\": 0.5", Errc::WrongType},
        {"\"rotation\": [2.2411872021010915e-06", "\"rotation\": [2", Errc::BadValue},
        {"\"rotation\": [2.2411872021010915e-06", "\"rotation\": [-1", Errc::BadValue},
        {"\"rotation\": [2.2411872021010915e-06", "\"rotation\": [1e200", Errc::BadValue},
        {"\"rotation\": [2.2411872021010915e-06, ", "\"rotation\": [", Errc::BadValue},
        {"\"camera\": 0, \"samples\"", "\"camera\": 50, \"samples\"", Errc::BadValue},
        {"\"samples\": [", "\"samples\": [1,", Errc::BadValue},
        {"\"samples\": [", "\"samples\": [1e300,0,1,0,", Errc::BadCoordinates},
        {"\"samples\": [", "\"samples\": [1,0,7,0,", Errc::BadValue},
        {"\"next_stroke\": ", "\"next_stroke\": -", Errc::BadValue},
        {"\"oblique_factor\": ", "\"oblique_factor\": 9", Errc::BadValue},
        {"\"distance_px\": ", "\"distance_px\": -", Errc::BadValue},
        {"\"id\": 1,", "\"id\": 0,", Errc::DuplicateId},
        {"\"history\": [", "\"history\": [{\"name\": \"x\", \"strokes\": []},", Errc::BadValue},
        {"\"strokes\": [0]", "\"strokes\": [0, 0]", Errc::BadValue},
        {"\"format\":\"edgewright-template\"", "\"format\":\"something\"", Errc::WrongFormat},
        {"\"script\": {", "\"script\": {\"x\": 1,", Errc::UnknownKey},
    };
    for (const Case& c : table) {
        const auto read = readDocument(replaced(whole, c.from, c.to), library);
        ASSERT_FALSE(read) << c.from << " -> " << c.to;
        EXPECT_EQ(read.error().code, c.code) << c.to << "\n" << read.error().message;
    }
    EXPECT_EQ(readDocument(std::string(1'000'000, '['), library).error().code, Errc::TooDeep);
}

}  // namespace
}  // namespace ew
