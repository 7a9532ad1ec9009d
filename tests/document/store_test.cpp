// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QUndoStack>

#include "tests/document/fixtures.h"

namespace ew {
namespace {

using test::doSomething;
using test::fakeDocument;
using test::line;

void expectSameInk(const Document& a, const Document& b) {
    ASSERT_EQ(a.pendingStrokes().size(), b.pendingStrokes().size());
    for (std::size_t i = 0; i < a.pendingStrokes().size(); ++i) {
        const PendingStroke& x = a.pendingStrokes()[i];
        const PendingStroke& y = b.pendingStrokes()[i];
        EXPECT_EQ(x.id, y.id);
        EXPECT_EQ(x.camera, y.camera);
        ASSERT_EQ(x.stroke.samples.size(), y.stroke.samples.size());
        for (std::size_t k = 0; k < x.stroke.samples.size(); ++k) {
            EXPECT_EQ(x.stroke.samples[k].position, y.stroke.samples[k].position);
        }
    }
}

void expectSame(const Document& a, const Document& b) {
    EXPECT_TRUE(test::sameState(a.state(), b.state()));
    EXPECT_EQ(a.undoStack().index(), b.undoStack().index());
    ASSERT_EQ(a.undoStack().count(), b.undoStack().count());
    for (int i = 0; i < a.undoStack().count(); ++i) {
        EXPECT_EQ(a.undoStack().text(i), b.undoStack().text(i));
    }
    EXPECT_EQ(a.camera(), b.camera());
    EXPECT_EQ(a.thresholds(), b.thresholds());
    EXPECT_EQ(a.obliqueFactor(), b.obliqueFactor());
    EXPECT_EQ(writeSketchScript(a.recordedScript()), writeSketchScript(b.recordedScript()));
    expectSameInk(a, b);
}

RC_GTEST_PROP(Store, SaveAndOpenKeepTheWholeHistory, ()) {
    const auto d = fakeDocument();
    const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(0, test::kDeeds), rc::gen::inRange(0, 30)));
    for (const auto& [what, number] : steps) doSomething(*d, what, number);

    const QTemporaryDir folder;
    const QString path = folder.filePath("d.edgewright");
    const auto saved = d->save(path);
    RC_ASSERT(saved.has_value());
    const auto e = fakeDocument();
    ASSERT_TRUE(e->addStroke(line({0, 0}, {9, 9})));  // gone after opening
    const auto opened = e->open(path);
    if (!opened) RC_FAIL(opened.error().message);
    expectSame(*d, *e);
    RC_ASSERT(!e->isModified());

    // The same all the way down the history and up again, and in the file's very text.
    while (d->undo()) {
        ASSERT_TRUE(e->undo());
        expectSame(*d, *e);
    }
    while (d->redo()) {
        ASSERT_TRUE(e->redo());
        expectSame(*d, *e);
    }
    RC_ASSERT(d->save(path).has_value());
    const QString other = folder.filePath("e.edgewright");
    RC_ASSERT(e->save(other).has_value());
    RC_ASSERT(*readFileBytes(path, kMaxDocumentBytes) == *readFileBytes(other, kMaxDocumentBytes));
}

/// A document with a bit of everything, as the text of its file.
std::string richText() {
    const auto d = fakeDocument();
    const std::vector<std::pair<int, int>> steps{
        {0, 7},  {3, 0}, {9, 4},  {10, 1}, {0, 3},  {0, 2},  {3, 4},  {6, 0}, {12, 3},
        {13, 9}, {0, 5}, {17, 2}, {16, 8}, {16, 3}, {18, 2}, {20, 1}, {0, 1}};
    for (const auto& [what, number] : steps) doSomething(*d, what, number);
    const QTemporaryDir folder;
    const QString path = folder.filePath("d.edgewright");
    EXPECT_TRUE(d->save(path));
    return *readFileBytes(path, kMaxDocumentBytes);
}

TEST(Store, KeepsEachSolidOnce) {
    const auto d = fakeDocument();
    ASSERT_TRUE(d->addStroke(line({0, 0}, {5, 5})));
    ASSERT_TRUE(d->apply());
    for (int i = 0; i < 5; ++i) {
        ASSERT_TRUE(d->defineTemplate(test::boxTemplate("t" + std::to_string(i), "T")));
    }
    const QTemporaryDir folder;
    ASSERT_TRUE(d->save(folder.filePath("d.edgewright")));
    const std::string text = *readFileBytes(folder.filePath("d.edgewright"), kMaxDocumentBytes);
    const auto begin = text.find("\"solids\"");
    const auto end = text.find("\"cameras\"");
    const std::string solids = text.substr(begin, end - begin);
    // The key, and one text: two pairs of quotes in all.
    EXPECT_EQ(std::count(solids.begin(), solids.end(), '\n'), 2);
}

TEST(Store, RefusesAFileThatIsCutAnywhere) {
    const std::string whole = richText();
    const TemplateLibrary library = test::smallLibrary();
    ASSERT_TRUE(readDocument(whole, library));
    const std::size_t lastBrace = whole.rfind('}');
    for (std::size_t n = 0; n <= lastBrace; ++n) {
        const auto read = readDocument(std::string_view(whole).substr(0, n), library);
        ASSERT_FALSE(read) << "cut after byte " << n;
        ASSERT_EQ(read.error().code, Errc::Syntax) << "cut after byte " << n;
    }
}

RC_GTEST_PROP(Store, MutatedFilesAreReadOrRefused, ()) {
    static const std::string whole = richText();
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
        RC_ASSERT(readDocument(writeDocument(*read), library).has_value());
    else
        RC_ASSERT(!read.error().message.empty());
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(Store, RefusesWhatDoesNotHangTogether) {
    const std::string whole = richText();
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
        {"\"rotation\": [1, 0", "\"rotation\": [2, 0", Errc::BadValue},
        {"\"rotation\": [1, 0", "\"rotation\": [-1, 0", Errc::BadValue},
        {"\"rotation\": [1, 0", "\"rotation\": [1e200, 0", Errc::BadValue},
        {"\"rotation\": [1, 0", "\"rotation\": [0", Errc::BadValue},
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

TEST(Store, AFileThatCannotBeReadChangesNothing) {
    const QTemporaryDir folder;
    const auto d = fakeDocument();
    ASSERT_TRUE(d->addStroke(line({0, 0}, {5, 5})));
    ASSERT_TRUE(d->apply());
    ASSERT_TRUE(d->addStroke(line({0, 0}, {5, 5})));
    const DocumentState* before = &d->state();
    EXPECT_EQ(d->open(folder.filePath("missing")).error().code, Errc::FileNotFound);
    EXPECT_EQ(d->open(folder.path()).error().code, Errc::FileNotFound);
    const QString bad = folder.filePath("bad.edgewright");
    ASSERT_TRUE(writeFileBytes(bad, richText().substr(0, 400)));
    const auto opened = d->open(bad);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().message.find("bad.edgewright: "), 0U);
    EXPECT_EQ(&d->state(), before);
    EXPECT_EQ(d->pendingStrokes().size(), 1U);
    EXPECT_TRUE(d->filePath().isEmpty());
}

TEST(Store, AFailedSaveLeavesTheOldFile) {
    const QTemporaryDir folder;
    const auto d = fakeDocument();
    EXPECT_EQ(d->save(folder.filePath("no/such/folder/d.edgewright")).error().code,
              Errc::CannotWrite);
    EXPECT_EQ(d->save(folder.path()).error().code, Errc::CannotWrite);
    EXPECT_TRUE(d->filePath().isEmpty());
}

TEST(Store, ADocumentIsSavedUnderANameThatItOpensBy) {
    const QTemporaryDir folder;
    const auto d = fakeDocument();
    const std::vector<std::pair<const char*, const char*>> names{
        {"box", "box.edgewright"},
        {"bracket v1.2", "bracket v1.2.edgewright"},
        {"a.obj", "a.obj.edgewright"},
        {"A.EdgeWright", "A.EdgeWright"}};
    for (const auto& [given, made] : names) {
        ASSERT_TRUE(d->save(folder.filePath(given))) << given;
        EXPECT_EQ(d->filePath(), folder.filePath(made));
        EXPECT_TRUE(QFileInfo(folder.filePath(made)).isFile());
        EXPECT_TRUE(fakeDocument()->open(d->filePath()));
    }
    const QString last = d->filePath();
    for (const char* name : {"foo.json", "foo.JSON"}) {
        const auto refused = d->save(folder.filePath(name));
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, Errc::BadValue);
        EXPECT_FALSE(QFileInfo::exists(folder.filePath(name)));
    }
    EXPECT_EQ(d->filePath(), last);
}

TEST(Store, KnowsWhetherItsFileWasChangedByOthers) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("d.edgewright");
    const auto d = fakeDocument();
    EXPECT_FALSE(d->fileChangedByOthers());
    ASSERT_TRUE(d->save(path));
    EXPECT_FALSE(d->fileChangedByOthers());
    const auto other = fakeDocument();
    ASSERT_TRUE(other->open(path));
    ASSERT_TRUE(other->save(path));
    EXPECT_TRUE(d->fileChangedByOthers());
    EXPECT_FALSE(other->fileChangedByOthers());
    ASSERT_TRUE(d->open(path));
    EXPECT_FALSE(d->fileChangedByOthers());
    ASSERT_TRUE(QFile::remove(path));
    EXPECT_FALSE(d->fileChangedByOthers());
    ASSERT_TRUE(writeFileBytes(path, "another file"));
    EXPECT_TRUE(d->fileChangedByOthers());
    d->reset();
    EXPECT_FALSE(d->fileChangedByOthers());
}

TEST(Store, SaysWhatAFileOfAnotherKindHolds) {
    const QTemporaryDir folder;
    std::string binaryStl(84, '\0');
    const std::vector<std::pair<std::string, const char*>> table{
        {"solid x\nendsolid x\n", "an STL mesh"},
        {binaryStl, "an STL mesh"},
        {"\x89PNG\r\n", "a picture"},
        {"PK\x03\x04", "a ZIP package, as 3MF files are"},
        {"glTF", "a glTF mesh"},
        {"ply\n", "a PLY mesh"},
        {"# made by hand\nv 1 2 3\n", "an OBJ mesh"},
        {"<svg/>", "XML text, as SVG files are"},
        {"Dear all,", "text of another kind"},
        {std::string("\x01\0\x02", 3), "data of another kind"},
        {" \n", "nothing"},
        {"", "nothing"}};
    const QString path = folder.filePath("x.edgewright");
    for (const auto& [bytes, words] : table) {
        ASSERT_TRUE(writeFileBytes(path, bytes));
        const auto opened = fakeDocument()->open(path);
        ASSERT_FALSE(opened);
        EXPECT_EQ(opened.error().code, Errc::WrongFormat);
        EXPECT_EQ(opened.error().message,
                  "x.edgewright is no Edgewright document or sketch script: it holds " +
                      std::string(words) + ".");
    }
}

TEST(Store, KnowsWhetherItIsSaved) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("d.edgewright");
    const auto d = fakeDocument();
    ASSERT_TRUE(d->addStroke(line({0, 0}, {5, 5})));
    EXPECT_TRUE(d->isModified());
    ASSERT_TRUE(d->save(path));
    EXPECT_FALSE(d->isModified());
    EXPECT_EQ(d->filePath(), path);
    ASSERT_TRUE(d->apply());
    EXPECT_TRUE(d->isModified());
}

TEST(Store, TheDocumentsOwnTemplateWinsOverAShippedOne) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("d.edgewright");
    const auto d = fakeDocument();
    Template slab = test::boxTemplate("slab", "Own slab");
    ASSERT_TRUE(d->defineTemplate(slab));
    ASSERT_TRUE(d->save(path));
    auto shipped = test::smallLibrary().with(test::boxTemplate("slab", "Shipped slab"));
    ASSERT_TRUE(shipped);
    Document later(*shipped, &test::fakeInterpreter);
    const auto opened = later.open(path);
    ASSERT_TRUE(opened) << opened.error().message;
    const int found = later.state().library.find("slab");
    ASSERT_GE(found, 0);
    EXPECT_EQ(later.state().library.at(static_cast<std::size_t>(found)).name, "Own slab");
    EXPECT_EQ(later.state().library.size(), 2U);
}

}  // namespace
}  // namespace ew
