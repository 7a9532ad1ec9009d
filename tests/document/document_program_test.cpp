// SPDX-License-Identifier: GPL-3.0-or-later
// edgewright-replay with documents: reports, scripts of them, and folders of working copies.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include "core/document/document_compare.h"
#include "core/document/replay.h"
#include "core/document/store.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

class DocumentProgram : public ::testing::Test {
  protected:
    int run(const QStringList& arguments) {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("XDG_DATA_HOME", folder_.filePath("data"));
        process.setProcessEnvironment(environment);
        process.start(QCoreApplication::applicationDirPath() + "/../app/edgewright-replay",
                      arguments);
        EXPECT_TRUE(process.waitForFinished(120'000));
        out_ = process.readAllStandardOutput().toStdString();
        err_ = process.readAllStandardError().toStdString();
        return process.exitCode();
    }
    nlohmann::json json(const QString& name) {
        const auto text = readFileBytes(folder_.filePath(name), kMaxScriptBytes);
        return text ? nlohmann::json::parse(*text, nullptr, false) : nlohmann::json();
    }
    static QString example(const char* name) {
        return QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/examples/%1.json").arg(name);
    }
    /// Saves an example as a document beside its report.
    void document(const char* name) {
        const auto text = readFileBytes(example(name), kMaxScriptBytes);
        SketchScript script = *readSketchScript(*text);
        script.steps.emplace_back(UndoStep{1, false});
        script.steps.emplace_back(StrokeStep{test::line({9, 9}, {70, 30}), false});
        script.steps.emplace_back(SaveStep{"d.edgewright"});
        ASSERT_TRUE(writeFileBytes(folder_.filePath("s.json"), writeSketchScript(script)));
        ASSERT_EQ(run({"s.json", "--report", "s-report.json"}), 0) << err_;
    }

    QTemporaryDir folder_;
    std::string out_, err_;
};

TEST_F(DocumentProgram, TellsOfADocumentWhatItTellsOfAScript) {
    for (const char* name : {"cube", "clock"}) {
        SCOPED_TRACE(name);
        document(name);
        ASSERT_EQ(run({"d.edgewright", "--report", "d-report.json"}), 0) << err_;
        const auto of = json("s-report.json");
        const auto told = json("d-report.json");
        for (const char* key : {"solid", "surface", "undo"}) EXPECT_EQ(told[key], of[key]) << key;
        EXPECT_EQ(told["script"], "d.edgewright");
        const auto applies = [](const nlohmann::json& report) {
            std::vector<nlohmann::json> list;
            for (const auto& step : report["steps"]) {
                if (step["do"] == "apply") list.push_back({step["edge_graph"], step["match"]});
            }
            return list;
        };
        EXPECT_FALSE(applies(of).empty());
        EXPECT_EQ(applies(told), applies(of));
        EXPECT_EQ(out_.find("differently"), std::string::npos) << out_;
    }
}

TEST_F(DocumentProgram, ADocumentAsAScriptReplaysToTheSameBits) {
    for (const char* name : {"mouse", "triangular-prism"}) {
        SCOPED_TRACE(name);
        document(name);
        ASSERT_EQ(run({"d.edgewright", "--save-script", "again.json"}), 0) << err_;
        Document saved(test::shippedLibrary());
        ASSERT_TRUE(saved.open(folder_.filePath("d.edgewright")));
        const auto script =
            readSketchScript(*readFileBytes(folder_.filePath("again.json"), kMaxScriptBytes));
        ASSERT_TRUE(script);
        Document again(test::shippedLibrary());
        ASSERT_EQ(replay(again, *script, {}).firstFailure(), nullptr);
        EXPECT_TRUE(identicalDocuments(saved, again));
    }
}

TEST_F(DocumentProgram, SaysWhereADocumentIsDamaged) {
    document("cube");
    std::string bytes = *readFileBytes(folder_.filePath("d.edgewright"), kMaxDocumentBytes);
    bytes.resize(bytes.size() / 2);
    ASSERT_TRUE(writeFileBytes(folder_.filePath("cut.edgewright"), bytes));
    EXPECT_EQ(run({"cut.edgewright", "--report", "r.json"}), 2);
    EXPECT_NE(err_.find("cut.edgewright is damaged"), std::string::npos) << err_;
    EXPECT_NE(err_.find("(damaged)"), std::string::npos) << err_;
    EXPECT_FALSE(QFileInfo::exists(folder_.filePath("r.json")));
}

TEST_F(DocumentProgram, ListsAndRestoresWorkingCopies) {
    ASSERT_EQ(run({example("cube"), "--work-copy", "copies", "--progress"}), 0) << err_;
    EXPECT_NE(out_.find("done 0\n"), std::string::npos) << out_;
    ASSERT_EQ(run({"--recover", "copies"}), 0) << err_;
    auto list = nlohmann::json::parse(out_, nullptr, false);
    ASSERT_EQ(list.size(), 1U) << out_;
    EXPECT_EQ(list[0]["steps"], 1);
    EXPECT_EQ(list[0]["strokes"], 0);
    EXPECT_FALSE(list[0]["lost"].get<bool>()) << "it ended as programs do";
    EXPECT_FALSE(list[0].contains("restored"));
    ASSERT_EQ(run({"--recover", "copies", "--out", "back"}), 0) << err_;
    list = nlohmann::json::parse(out_, nullptr, false);
    Document found(test::shippedLibrary());
    ASSERT_TRUE(found.open(QString::fromStdString(list[0]["restored"].get<std::string>())));
    EXPECT_EQ(found.state().bodies.size(), 1U);
}

TEST_F(DocumentProgram, AFolderThatIsNoneIsUnusable) {
    EXPECT_EQ(run({"--recover", "nowhere"}), 2);
    EXPECT_NE(err_.find("(file-not-found)"), std::string::npos) << err_;
    EXPECT_EQ(run({"--recover", "nowhere", example("cube")}), 2);
    ASSERT_TRUE(writeFileBytes(folder_.filePath("file"), "x"));
    EXPECT_EQ(run({example("cube"), "--work-copy", "file"}), 2);
    EXPECT_NE(err_.find("(cannot-write)"), std::string::npos) << err_;
}

}  // namespace
}  // namespace ew
