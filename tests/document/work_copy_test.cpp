// SPDX-License-Identifier: GPL-3.0-or-later
// Working copies: what is in them after every step, whatever happens to the program or the disk.
#include "core/document/work_copy.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QUndoStack>
#include <random>

#include "core/document/document_compare.h"
#include "tests/document/fault_vfs.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

using test::doSomething;
using test::fakeDocument;
using test::line;

constexpr int kOpensAndOthers = 30;

/// What is in a folder of working copies as a machine would find it that was switched off now.
class Image {
  public:
    explicit Image(const QString& folder) : copies_(copy_.path()) {
        for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files)) {
            const QString to = copy_.filePath(file.fileName());
            QFile::copy(file.filePath(), to);
            // Which one is the newest is told by this.
            QFile made(to);
            if (made.open(QIODevice::ReadWrite)) {
                made.setFileTime(file.lastModified(), QFileDevice::FileModificationTime);
            }
        }
    }
    QString file(const QString& ending) const {
        for (const QFileInfo& file : QDir(copy_.path()).entryInfoList(QDir::Files)) {
            if (file.fileName().endsWith(ending)) return file.filePath();
        }
        return {};
    }
    /// The newest copy in it as a document; nothing where there is none.
    std::unique_ptr<Document> document() const {
        const auto entries = copies_.list();
        if (entries.empty()) return nullptr;
        auto file = copies_.read(entries.front(), test::smallLibrary());
        if (!file) {
            ADD_FAILURE() << file.error().message;
            return nullptr;
        }
        auto d = fakeDocument();
        d->restore(*std::move(file), {});
        return d;
    }

  private:
    QTemporaryDir copy_;
    WorkFolder copies_;
};

void expectSame(const Document& a, const Document& b) {
    EXPECT_TRUE(identicalDocuments(a, b));
    EXPECT_EQ(a.canUndoInk(), b.canUndoInk());
    EXPECT_EQ(a.canRedoInk(), b.canRedoInk());
    EXPECT_EQ(a.thresholds(), b.thresholds());
    EXPECT_EQ(writeSketchScript(a.recordedScript()), writeSketchScript(b.recordedScript()));
}

RC_GTEST_PROP(WorkCopies, HoldTheWholeDocumentAfterEveryStep, ()) {
    const QTemporaryDir folder;
    const auto d = fakeDocument();
    WorkCopy copy(*d, WorkFolder(folder.path()));
    const auto deeds = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(0, test::kDeeds), rc::gen::inRange(0, kOpensAndOthers)));
    for (const auto& [what, number] : deeds) {
        doSomething(*d, what, number);
        const auto flushed = copy.flush();
        if (!flushed) RC_FAIL(flushed.error().message);
        if (number % 4 != 0 || copy.path().isEmpty()) continue;
        const auto found = Image(folder.path()).document();
        RC_ASSERT(found != nullptr);
        expectSame(*d, *found);
        // It goes on from there as the document itself does.
        while (found->undo()) {
        }
        while (found->redo()) {
        }
    }
}

TEST(WorkCopies, ADocumentThatNothingIsDoneToHasNone) {
    const QTemporaryDir folder;
    const auto d = fakeDocument();
    {
        WorkCopy copy(*d, WorkFolder(folder.path()));
        ASSERT_TRUE(copy.flush());
        EXPECT_TRUE(copy.path().isEmpty());
    }
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST(WorkCopies, ALogThatIsCutHoldsAnEarlierStepWhole) {
    const QTemporaryDir folder;
    const auto d = fakeDocument();
    WorkCopy copy(*d, WorkFolder(folder.path()));
    std::vector<std::string> scripts;
    for (int i = 0; i < 40; ++i) {
        doSomething(*d, i % 4 == 3 ? 3 : 0, i % 30);
        ASSERT_TRUE(copy.flush());
        scripts.push_back(writeSketchScript(d->recordedScript()));
    }
    std::mt19937 random(3);
    std::size_t latest = 0;
    for (int i = 0; i < 60; ++i) {
        const Image image(folder.path());
        QFile log(image.file(QStringLiteral("-wal")));
        ASSERT_GT(log.size(), 0);
        ASSERT_TRUE(log.resize(static_cast<qint64>(random()) % log.size()));
        const auto found = image.document();
        if (!found) continue;  // cut before the first step was whole
        const std::string script = writeSketchScript(found->recordedScript());
        const auto at = std::find(scripts.begin(), scripts.end(), script);
        ASSERT_NE(at, scripts.end()) << "a state that never was";
        latest = std::max(latest, static_cast<std::size_t>(at - scripts.begin()));
    }
    EXPECT_GT(latest, scripts.size() / 2);
}

TEST(WorkCopies, ChangedBytesAreToldOrDoNoHarm) {
    const QTemporaryDir folder;
    const auto d = fakeDocument();
    WorkCopy copy(*d, WorkFolder(folder.path()));
    std::set<std::string> scripts;
    for (int i = 0; i < 40; ++i) {
        doSomething(*d, i % 4 == 3 ? 3 : 0, i % 30);
        ASSERT_TRUE(copy.flush());
        scripts.insert(writeSketchScript(d->recordedScript()));
    }
    std::mt19937 random(4);
    for (int i = 0; i < 200; ++i) {
        const Image image(folder.path());
        QFile log(image.file(QStringLiteral("-wal")));
        ASSERT_TRUE(log.open(QIODevice::ReadWrite));
        ASSERT_TRUE(log.seek(static_cast<qint64>(random()) % log.size()));
        ASSERT_TRUE(log.putChar(static_cast<char>(random())));
        log.close();
        const WorkFolder copies(QFileInfo(log.fileName()).path());
        const auto entries = copies.list();
        if (entries.empty() || entries.front().problem) continue;
        const auto file = copies.read(entries.front(), test::smallLibrary());
        if (!file) continue;
        const auto found = fakeDocument();
        found->restore(*file, {});
        EXPECT_TRUE(scripts.contains(writeSketchScript(found->recordedScript())));
    }
}

/// How many broken disks of a kind are tried; the whole number in `tests/run soak`.
int faultRuns() {
    bool ok = false;
    const int wanted = qEnvironmentVariableIntValue("EDGEWRIGHT_FAULTS", &ok);
    return ok ? wanted : 150;
}

TEST(WorkCopies, NothingThatWasToldAsDoneIsLostOnABrokenDisk) {
    test::FaultyDisk disk;
    std::mt19937 random(5);
    int broken = 0;
    for (int run = 0; run < faultRuns(); ++run) {
        SCOPED_TRACE(run);
        const QTemporaryDir folder;
        const auto d = fakeDocument();
        WorkCopy copy(*d, WorkFolder(folder.path()));
        const auto fault = static_cast<test::FaultyDisk::Fault>(run % 3);
        disk.breakAfter(static_cast<int>(random() % 60U), fault);
        std::string done;
        for (int i = 0; i < 12 && !disk.broke(); ++i) {
            doSomething(*d, i % 4 == 3 ? 3 : 0, static_cast<int>(random() % 30U));
            if (copy.flush()) done = writeSketchScript(d->recordedScript());
        }
        broken += disk.broke();
        disk.mend();
        if (!done.empty()) {
            // Switched off now: the last step that was told as done is there, or the one after it.
            const auto found = Image(folder.path()).document();
            ASSERT_NE(found, nullptr);
            const std::string script = writeSketchScript(found->recordedScript());
            EXPECT_TRUE(script == done || script == writeSketchScript(d->recordedScript()));
        }
        // With a disk that works again the copy is whole again.
        ASSERT_TRUE(d->addStroke(line({1, 1}, {2, 2})));
        const auto flushed = copy.flush();
        ASSERT_TRUE(flushed) << flushed.error().message;
        const auto found = Image(folder.path()).document();
        ASSERT_NE(found, nullptr);
        expectSame(*d, *found);
    }
    EXPECT_GT(broken, faultRuns() / 2);
}

TEST(WorkCopies, AFolderThatCannotBeMadeIsToldOnce) {
    const QTemporaryDir folder;
    ASSERT_TRUE(writeFileBytes(folder.filePath("file"), "x"));
    const auto d = fakeDocument();
    WorkCopy copy(*d, WorkFolder(folder.filePath("file/work")));
    int told = 0;
    QObject::connect(&copy, &WorkCopy::failed, [&](const Error& error) {
        ++told;
        EXPECT_EQ(error.code, Errc::CannotWrite);
    });
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(d->addStroke(line({0, 0}, {5, 5})));
        EXPECT_FALSE(copy.flush());
    }
    EXPECT_EQ(told, 1);
}

TEST(WorkCopies, TellWhoHasADocumentOpenAndForgetItWithTheProcess) {
    const QTemporaryDir folder;
    const WorkFolder work(folder.filePath("work"));
    const QString path = folder.filePath("d.edgewright");
    const auto d = fakeDocument();
    {
        WorkCopy copy(*d, work);
        ASSERT_TRUE(d->addStroke(line({0, 0}, {5, 5})));
        ASSERT_TRUE(copy.flush());
        EXPECT_FALSE(work.openElsewhere(path));
        ASSERT_TRUE(d->save(path));
        const auto who = work.openElsewhere(path);
        ASSERT_TRUE(who);
        EXPECT_EQ(who->process, QCoreApplication::applicationPid());
        ASSERT_EQ(work.list().size(), 1U);
        EXPECT_TRUE(work.list().front().open);
    }
    EXPECT_FALSE(work.openElsewhere(path));
    // Closed and saved: nothing to offer, but it is still there.
    ASSERT_EQ(work.list().size(), 1U);
    EXPECT_FALSE(work.list().front().lost());
    EXPECT_EQ(work.list().front().summary.strokes, 1);
}

TEST(WorkCopies, WhatACrashLeftIsOfferedUntilItIsDeclinedOrReplaced) {
    const QTemporaryDir folder;
    const WorkFolder work(folder.filePath("work"));
    ASSERT_TRUE(QDir().mkpath(work.path()));
    const auto d = fakeDocument();
    QTemporaryDir crashed;
    {
        WorkCopy copy(*d, WorkFolder(crashed.path()));
        ASSERT_TRUE(d->addStroke(line({0, 0}, {5, 5})));
        ASSERT_TRUE(copy.flush());
        for (const QFileInfo& file : QDir(crashed.path()).entryInfoList(QDir::Files)) {
            QFile::copy(file.filePath(), work.path() + '/' + file.fileName());
        }
    }
    ASSERT_EQ(work.list().size(), 1U);
    WorkCopyEntry entry = work.list().front();
    EXPECT_TRUE(entry.lost());
    EXPECT_EQ(entry.summary.strokes, 1);
    ASSERT_TRUE(work.decline(entry));
    EXPECT_FALSE(work.list().front().lost());
    work.tidy({});
    EXPECT_EQ(work.list().size(), 1U) << "kept for a month";
    work.tidy({.daysDeclined = -1});
    EXPECT_TRUE(work.list().empty());
}

TEST(WorkCopies, OnlySomeOfTheClosedOnesStay) {
    const QTemporaryDir folder;
    const WorkFolder work(folder.path());
    for (int i = 0; i < 5; ++i) {
        const auto d = fakeDocument();
        WorkCopy copy(*d, work);
        ASSERT_TRUE(d->addStroke(line({0, 0}, {5.0 + i, 5})));
        ASSERT_TRUE(copy.flush());
    }
    EXPECT_EQ(work.list().size(), 5U);
    work.tidy({.copies = 3});
    EXPECT_EQ(work.list().size(), 3U);
    work.tidy({.bytes = 1});
    EXPECT_TRUE(work.list().empty());
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

}  // namespace
}  // namespace ew
