// SPDX-License-Identifier: GPL-3.0-or-later
// edgewright-replay killed at random moments of work: what it told as done is there afterwards.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QUndoStack>
#include <nlohmann/json.hpp>
#include <random>

#include "core/document/document_compare.h"
#include "core/document/replay.h"
#include "core/document/store.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

/// How often it is killed; the whole number in `tests/run soak`.
int kills() {
    bool ok = false;
    const int wanted = qEnvironmentVariableIntValue("EDGEWRIGHT_KILLS", &ok);
    return ok ? wanted : 12;
}

QString program() {
    return QCoreApplication::applicationDirPath() + QStringLiteral("/../app/edgewright-replay");
}

/// An example with strokes, solids, a save and an export now and then, undo and redo.
SketchScript busyScript(const char* example) {
    const auto text = readFileBytes(
        QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/examples/%1.json").arg(example),
        kMaxScriptBytes);
    SketchScript script = *readSketchScript(*text);
    std::vector<ScriptStep> steps;
    for (ScriptStep& step : script.steps) {
        const bool applies = std::holds_alternative<ApplyStep>(step);
        steps.push_back(std::move(step));
        if (!applies) continue;
        steps.emplace_back(SaveStep{"saved.edgewright"});
        steps.emplace_back(UndoStep{1, false});
        steps.emplace_back(RedoStep{1, false});
        steps.emplace_back(ExportStep{"part.stl"});
    }
    script.steps = std::move(steps);
    return script;
}

/// The document as it is after each step.
std::vector<DocumentFile> statesOf(const SketchScript& script, const QString& folder) {
    Document d(test::shippedLibrary());
    std::vector<DocumentFile> states;
    ReplayOptions options;
    options.outFolder = folder;
    replay(d, script, options, [&](const StepReport& step) {
        EXPECT_TRUE(step.ok) << step.index;
        states.push_back(d.contents());
        return true;
    });
    return states;
}

bool isState(const DocumentFile& file, const Document& found) {
    Document d(test::shippedLibrary());
    d.restore(file, {});
    return identicalDocuments(d, found);
}

struct Work {
    int done = -1;          ///< the last step that was told as done
    bool finished = false;  ///< before it could be killed
};

Work workUntilKilled(const QStringList& arguments, int afterMs) {
    QProcess process;
    process.start(program(), arguments);
    EXPECT_TRUE(process.waitForStarted());
    QElapsedTimer clock;
    clock.start();
    Work work;
    while (clock.elapsed() < afterMs && process.state() == QProcess::Running) {
        process.waitForReadyRead(1);
    }
    work.finished = process.state() != QProcess::Running;
    process.kill();
    process.waitForFinished();
    for (const QByteArray& text : process.readAllStandardOutput().split('\n')) {
        if (text.startsWith("done ")) work.done = text.mid(5).toInt();
    }
    return work;
}

TEST(Killed, NothingThatWasToldAsDoneIsLost) {
    const QTemporaryDir folder;
    const SketchScript script = busyScript("printer");
    const QString path = folder.filePath("busy.json");
    ASSERT_TRUE(writeFileBytes(path, writeSketchScript(script)));
    const std::vector<DocumentFile> states = statesOf(script, folder.filePath("whole"));
    ASSERT_EQ(states.size(), script.steps.size());

    // How long it takes undisturbed, here and now.
    QElapsedTimer clock;
    clock.start();
    const QStringList arguments{path,    "--work-copy",          folder.filePath("calm"),
                                "--out", folder.filePath("out"), "--progress"};
    ASSERT_EQ(QProcess::execute(program(), arguments), 0);
    const int wholeMs = static_cast<int>(clock.elapsed());

    std::mt19937 random(11);
    int interrupted = 0;
    for (int i = 0; i < kills(); ++i) {
        SCOPED_TRACE(i);
        const QTemporaryDir work;
        const QString copies = work.filePath("copies");
        const QString out = work.filePath("out");
        const Work killed =
            workUntilKilled({path, "--work-copy", copies, "--out", out, "--progress"},
                            static_cast<int>(random() % static_cast<unsigned>(wholeMs)));
        interrupted += killed.done >= 0 && !killed.finished;
        // What was saved is the old file or the new one, whole.
        const QString saved = out + QStringLiteral("/saved.edgewright");
        const bool readable =
            !QFileInfo::exists(saved) || loadDocument(saved, test::shippedLibrary()).has_value();
        EXPECT_TRUE(readable);
        if (killed.done < 0) continue;

        QProcess recovery;
        recovery.start(program(), {"--recover", copies, "--out", work.filePath("back")});
        ASSERT_TRUE(recovery.waitForFinished());
        ASSERT_EQ(recovery.exitCode(), 0) << recovery.readAllStandardError().toStdString();
        const auto list =
            nlohmann::json::parse(recovery.readAllStandardOutput().toStdString(), nullptr, false);
        ASSERT_TRUE(list.is_array());
        ASSERT_EQ(list.size(), 1U) << list.dump(1);
        ASSERT_TRUE(list[0].contains("restored")) << list.dump(1);
        Document found(test::shippedLibrary());
        const auto opened =
            found.open(QString::fromStdString(list[0]["restored"].get<std::string>()));
        ASSERT_TRUE(opened) << opened.error().message;
        EXPECT_EQ(list[0]["steps"], found.undoStack().count());
        EXPECT_EQ(list[0]["strokes"], found.pendingStrokes().size());
        const auto done = static_cast<std::size_t>(killed.done);
        const bool asTold = isState(states[done], found);
        const bool oneMore = done + 1 < states.size() && isState(states[done + 1], found);
        EXPECT_TRUE(asTold || oneMore) << "killed after step " << killed.done;
    }
    EXPECT_GT(interrupted, kills() / 4);
}

}  // namespace
}  // namespace ew
