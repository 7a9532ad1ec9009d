// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QUndoStack>
#include <array>
#include <functional>
#include <random>

#include "core/document/store_schema.h"
#include "tests/document/fixtures.h"
#include "tests/document/later_version.h"
#include "tests/document/store_rows.h"

namespace ew {
namespace {

using test::doSomething;
using test::fakeDocument;
using test::line;
using test::withRow;

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
    auto opened = e->openTask(path)();
    if (!opened) RC_FAIL(opened.error().message);
    e->open(*std::move(opened));
    expectSame(*d, *e);
    RC_ASSERT(!e->isModified());

    // The same all the way down the history and up again, and in the file's very bytes.
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

/// A document with a bit of everything, as the bytes of its file.
std::string richFile() {
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

RC_GTEST_PROP(Store, WorkGoesOnAfterOpeningAsIfItHadNeverBeenClosed, ()) {
    const auto d = fakeDocument();
    const auto deeds = [] {
        return *rc::gen::container<std::vector<std::pair<int, int>>>(
            rc::gen::pair(rc::gen::inRange(0, test::kDeeds), rc::gen::inRange(0, 30)));
    };
    for (const auto& [what, number] : deeds()) doSomething(*d, what, number);
    const QTemporaryDir folder;
    const QString path = folder.filePath("d.edgewright");
    RC_ASSERT(d->save(path).has_value());
    const auto e = fakeDocument();
    auto opened = e->openTask(path)();
    RC_ASSERT(opened.has_value());
    e->open(*std::move(opened));
    RC_ASSERT(d->canUndoInk() == e->canUndoInk());
    RC_ASSERT(d->canRedoInk() == e->canRedoInk());
    constexpr int kOtherReading = 11;  // which a file does not hold
    for (const auto& [what, number] : deeds()) {
        if (what == kOtherReading) continue;
        doSomething(*d, what, number);
        doSomething(*e, what, number);
        expectSame(*d, *e);
    }
}

TEST(Store, AStrokeThatIsGoneForGoodDoesNotKeepADocumentFromOpening) {
    const auto d = fakeDocument();
    ASSERT_TRUE(d->addStroke(line({0, 5}, {9, 9})));
    ASSERT_TRUE(d->defineTemplate(test::boxTemplate("t", "T")));
    ASSERT_TRUE(d->undo());
    ASSERT_TRUE(d->undoInk());
    ASSERT_TRUE(d->redo());  // the step, which still knows that a stroke was drawn before it
    const QTemporaryDir folder;
    ASSERT_TRUE(d->save(folder.filePath("d.edgewright")));
    const auto e = fakeDocument();
    const auto opened = e->open(folder.filePath("d.edgewright"));
    ASSERT_TRUE(opened) << opened.error().message;
    expectSame(*d, *e);
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
    auto db = Database::overBytes(
        *readFileBytes(folder.filePath("d.edgewright"), kMaxDocumentBytes), schema::kKind);
    ASSERT_TRUE(db);
    int blobs = 0;
    ASSERT_TRUE(db->each(schema::kBlob, [&](const Row&) -> Result<void> {
        ++blobs;
        return {};
    }));
    EXPECT_EQ(blobs, 2) << "a solid, and the samples of a stroke";
}

TEST(Store, EqualDocumentsAreEqualFiles) { EXPECT_EQ(richFile(), richFile()); }

/// What is read is what was written, or nothing is.
void expectWholeOrRefused(const std::string& bytes, const std::string& whole) {
    const TemplateLibrary library = test::smallLibrary();
    const auto read = readDocument(bytes, library);
    if (read) {
        EXPECT_EQ(*writeDocument(*read), whole);
    } else {
        EXPECT_FALSE(read.error().message.empty());
    }
}

TEST(Store, AFileThatIsCutIsRefused) {
    const std::string whole = richFile();
    const TemplateLibrary library = test::smallLibrary();
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i) {
        const auto read = readDocument(whole.substr(0, random() % whole.size()), library);
        ASSERT_FALSE(read);
    }
}

TEST(Store, AFileWithChangedBytesIsRefusedOrReadAsItWas) {
    const std::string whole = richFile();
    std::mt19937 random(8);
    for (int i = 0; i < 200; ++i) {
        std::string one = whole;
        one[random() % one.size()] = static_cast<char>(random());
        expectWholeOrRefused(one, whole);
    }
    std::string many = whole;
    for (int i = 0; i < 200; ++i) {
        many[random() % many.size()] = static_cast<char>(random());
        expectWholeOrRefused(many, whole);
    }
}

TEST(Store, RefusesWhatDoesNotHangTogether) {
    const std::string whole = richFile();
    const TemplateLibrary library = test::smallLibrary();
    struct Case {
        Table table;
        std::size_t row, column;
        Field value;
        Errc code;
    };
    const auto text = [](const char* t) { return Field(std::string(t)); };
    const std::vector<Case> table{
        {schema::kBlob, 0, 4, Bytes{"x"}, Errc::Damaged},
        {schema::kBlob, 0, 2, std::int64_t{1} << 30, Errc::Damaged},
        {schema::kBlob, 0, 1, Bytes{std::string(32, 'x')}, Errc::Damaged},
        {schema::kCamera, 0, 1, text("{}"), Errc::MissingKey},
        {schema::kCamera, 0, 1, text("{"), Errc::Syntax},
        {schema::kTemplate, 0, 1, text("{\"format\": 1}"), Errc::WrongFormat},
        {schema::kStroke, 0, 1, std::int64_t{99}, Errc::Damaged},
        {schema::kStroke, 0, 2, std::int64_t{99}, Errc::Damaged},
        {schema::kStroke, 0, 0, std::int64_t{-1}, Errc::BadValue},
        {schema::kState, 1, 1, text("[{\"solid\": 99}]"), Errc::Damaged},
        {schema::kState, 1, 1, text("[3]"), Errc::WrongType},
        {schema::kState, 1, 2, text("[99]"), Errc::Damaged},
        {schema::kState, 1, 3, std::int64_t{1}, Errc::Syntax},
        {schema::kState, 1, 4, std::int64_t{99}, Errc::Damaged},
        {schema::kStep, 0, 0, std::int64_t{77}, Errc::Damaged},
        {schema::kStep, 0, 2, std::int64_t{77}, Errc::Damaged},
        {schema::kStep, 0, 3, text("[0, 0]"), Errc::BadValue},
        {schema::kStep, 0, 3, text("[99]"), Errc::Damaged},
        {schema::kInk, 0, 0, std::int64_t{9999}, Errc::BadValue},
        {schema::kInk, 0, 1, std::int64_t{5}, Errc::Damaged},
        {schema::kInk, 0, 2, std::int64_t{9999}, Errc::BadValue},
        {schema::kPending, 0, 0, std::int64_t{9999}, Errc::Damaged},
        {schema::kScript, 0, 1, std::int64_t{9999}, Errc::Damaged},
        {schema::kScript, 1, 2, text("{\"do\": \"fly\"}"), Errc::BadValue},
        {schema::kScript, 0, 5, std::int64_t{99}, Errc::Damaged}};
    for (const Case& c : table) {
        const std::string bad =
            withRow(whole, c.table, c.row, [&](Row& row) { row[c.column] = c.value; });
        const auto read = readDocument(bad, library);
        ASSERT_FALSE(read) << c.table.name << " " << c.column;
        EXPECT_EQ(read.error().code, c.code) << c.table.name << " " << c.column << "\n"
                                             << read.error().message;
    }
    const std::vector<std::array<const char*, 2>> settings{
        {"index", "99"},           {"index", "-1"},         {"next_stroke", "1"},
        {"next_ink", "0"},         {"oblique_factor", "9"}, {"thresholds", "{\"distance_px\": -1}"},
        {"first_state", "99"},     {"title", "7"},          {"automatic_distance", "3"},
        {"rows", "{\"step\": 1}"}, {"camera", "{}"},        {"camera", "["}};
    for (const auto& [key, value] : settings) {
        auto db = Database::overBytes(whole, schema::kKind);
        std::size_t number = 0;
        std::size_t found = 0;
        ASSERT_TRUE(db->each(schema::kSetting, [&](const Row& row) -> Result<void> {
            if (row[0] == Field(std::string(key))) found = number;
            ++number;
            return {};
        }));
        const std::string bad =
            withRow(whole, schema::kSetting, found, [&](Row& row) { row[1] = text(value); });
        EXPECT_FALSE(readDocument(bad, library)) << key << " " << value;
    }
}

TEST(Store, ALaterSchemaSaysWhichVersionItNeeds) {
    std::string later = withRow(richFile(), schema::kSetting, 4, [](Row& row) {
        EXPECT_EQ(row[0], Field(std::string("needs")));
        row[1] = std::string("\"7.5.0\"");
    });
    later[63] = 9;  // the last byte of user_version
    const auto read = readDocument(later, test::smallLibrary());
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, Errc::WrongVersion);
    EXPECT_NE(read.error().message.find("7.5.0"), std::string::npos) << read.error().message;
    EXPECT_NE(read.error().message.find("schema is 9"), std::string::npos) << read.error().message;
}

TEST(Store, ALaterSchemaThatSaysSoIsReadAndNeverWrittenOver) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("later.edgewright");
    const std::string later = test::ofLaterVersion(richFile(), "2");
    ASSERT_TRUE(writeFileBytes(path, later));
    const auto d = fakeDocument();
    const auto opened = d->open(path);
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_TRUE(d->isReadOnly());
    const auto plain = readDocument(richFile(), test::smallLibrary());
    ASSERT_TRUE(plain);
    const auto e = fakeDocument();
    e->restore(*plain, {});
    expectSame(*d, *e);

    // Neither this document nor another one takes its place.
    for (const auto& save : {d->save(path), e->save(path), e->saveCopy(path)}) {
        ASSERT_FALSE(save);
        EXPECT_EQ(save.error().code, Errc::WrongVersion);
    }
    EXPECT_EQ(*readFileBytes(path, 1U << 26U), later);
    ASSERT_TRUE(d->save(folder.filePath("own.edgewright")));
    EXPECT_FALSE(d->isReadOnly());
    ASSERT_TRUE(d->save(folder.filePath("own.edgewright")));
}

TEST(Store, ALaterSchemaThatCannotBeReadIsRefused) {
    for (const char* readableAs : {"3", "0", "-1", "\"2\"", "1e99", "null", "["}) {
        const auto read =
            readDocument(test::ofLaterVersion(richFile(), readableAs), test::smallLibrary());
        ASSERT_FALSE(read) << readableAs;
        EXPECT_EQ(read.error().code, Errc::WrongVersion) << readableAs;
    }
}

TEST(Store, OpeningCanBeGivenUp) {
    double told = -1.0;
    const auto read =
        readDocument(richFile(), test::smallLibrary(), {.progress = [&](double share) {
                         EXPECT_GE(share, 0.0);
                         EXPECT_LE(share, 1.0);
                         told = share;
                         return false;
                     }});
    EXPECT_GE(told, 0.0);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, Errc::Cancelled);
}

TEST(Store, ATemplateThatIsNowhereElseComesWithTheDocument) {
    const auto d = fakeDocument();  // it uses "box"
    ASSERT_TRUE(d->addStroke(line({0, 0}, {5, 5})));
    ASSERT_TRUE(d->apply());
    const QTemporaryDir folder;
    ASSERT_TRUE(d->save(folder.filePath("d.edgewright")));
    Document e(*TemplateLibrary().with(test::boxTemplate("slab", "Slab")), &test::fakeInterpreter);
    ASSERT_LT(e.state().library.find("box"), 0);
    const auto opened = e.open(folder.filePath("d.edgewright"));
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_GE(e.state().library.find("box"), 0);
    EXPECT_GE(e.state().library.find("slab"), 0);
    EXPECT_TRUE(e.state().addedTemplates.empty());
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
    ASSERT_TRUE(writeFileBytes(bad, richFile().substr(0, 400)));
    const auto opened = d->open(bad);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().message.find("bad.edgewright is damaged"), 0U);
    EXPECT_EQ(opened.error().code, Errc::Damaged);
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
        {std::string("SQLite format 3\0", 16) + std::string(84, '\0'),
         "a database of another program"},
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
