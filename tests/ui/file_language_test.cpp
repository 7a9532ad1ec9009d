// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of files, in German; and the texts that Qt brings along.
#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>
#include <set>

#include "core/document/file_bytes.h"
#include "core/document/file_names.h"
#include "core/document/sketch_script.h"
#include "core/document/store.h"
#include "tests/ui/german_fixture.h"
#include "ui/actions/file_actions.h"
#include "ui/app_setup.h"
#include "ui/core_text.h"
#include "ui/file_sentences.h"
#include "ui/panels/message_bar.h"

namespace ew::test {
namespace {

/// English words that no German sentence about a file holds.
void expectNoEnglish(const QString& text, const std::string& source) {
    EXPECT_NE(text.toStdString(), source);
    EXPECT_FALSE(text.contains('%')) << text.toStdString();
    static const QRegularExpression kEnglish(
        QStringLiteral(R"(\b(the|an?|is|must|not|of|be|from|than|holds?|missing|kind|mesh|program|)"
                       R"(picture|package|files|script|step|list|number|text|object)\b)"));
    QString prose = text;
    prose.remove(QRegularExpression(QStringLiteral("\"[^\"]*\"")));  // what the file itself says
    EXPECT_FALSE(kEnglish.match(prose).hasMatch()) << text.toStdString();
}

TEST_F(German, WhatAFileOfAnotherKindHoldsIsSaidInGerman) {
    std::string stl(84, '\0');
    const std::vector<std::string> contents{"",
                                            "\x89PNG",
                                            "\xff\xd8\xff",
                                            "GIF8",
                                            "%PDF-1.4",
                                            "PK\x03\x04",
                                            "SQLite format 3",
                                            "glTF",
                                            "ply\nformat",
                                            "solid a\nendsolid",
                                            stl,
                                            "ISO-10303-21;",
                                            "<svg>",
                                            "v 1 2 3\n",
                                            "hello",
                                            std::string("\x01\0\x02", 3)};
    std::set<std::string> told;
    for (const std::string& bytes : contents) {
        const auto refused = refuseOtherKinds("X1", bytes);
        ASSERT_FALSE(refused) << bytes;
        told.insert(refused.error().message);
        expectNoEnglish(coreText(refused.error().message), refused.error().message);
    }
    EXPECT_GE(told.size(), 12U) << "kinds";
    EXPECT_EQ(coreText("bh.stl is no Edgewright document or sketch script: it holds an STL mesh."),
              "bh.stl ist weder ein Edgewright-Dokument noch ein Zeichenskript; der Inhalt: ein "
              "STL-Netz.");
}

TEST_F(German, WhatIsWrongWithAScriptIsSaidInGerman) {
    const std::string head = R"({"format":"edgewright-sketch","version":1,)";
    const auto step = [&](const std::string& body) { return head + "\"steps\":[" + body + "]}"; };
    const std::vector<std::string> scripts{
        "{",
        "{\"a\":1,\"a\":2}",
        "{\"a\":1e999}",
        std::string(64, '['),
        "[]",
        "{}",
        R"({"format":"other"})",
        R"({"format":1})",
        R"({"format":"edgewright-sketch"})",
        R"({"format":"edgewright-sketch","version":2})",
        R"({"format":"edgewright-sketch","version":"1"})",
        head + "\"x\":1}",
        head + "\"title\":1}",
        head + "\"viewport\":[1,2]}",
        head + "\"viewport\":[1]}",
        head + "\"thresholds\":{\"angle_deg\":1000}}",
        head + "\"thresholds\":null}",
        head + "\"steps\":{}}",
        step("1"),
        step("{}"),
        step(R"({"do":"fly"})"),
        step(R"({"do":"clear","x":1})"),
        step(R"({"do":"camera","up":[0,0,0]})"),
        step(R"({"do":"camera","center":[1e30,0,0]})"),
        step(R"({"do":"stroke"})"),
        step(R"({"do":"stroke","points":[[1]]})"),
        step(R"({"do":"stroke","points":[["a","b"]]})"),
        step(R"({"do":"stroke","points":[[1,2,3,4]]})"),
        step(R"({"do":"erase","at":[true,2]})"),
        step(R"({"do":"apply","template":""})"),
        step(R"({"do":"apply","operation":"glue"})"),
        step(R"({"do":"apply","candidate":-1})"),
        step(R"({"do":"apply","candidate":1.5})"),
        step(R"({"do":"define_template","id":"a","name":"b"})"),
        step(R"({"do":"define_template","id":"a","name":"b","from":"solid","template":{}})"),
        step(R"({"do":"define_template","id":"a","name":"b","from":"air"})"),
        step(R"({"do":"undo","of":"time"})"),
        step(R"({"do":"save","path":""})"),
        step(R"({"do":"export","path":"a.obj","faces":"round"})"),
        step(R"({"do":"fillet","radius":0,"edges":"all"})"),
        step(R"({"do":"fillet","radius":1,"edges":"some"})"),
        step(R"({"do":"fillet","radius":1,"edges":[]})"),
        step(R"({"do":"crease","edges":"all","sharpness":99})"),
        step(R"({"do":"subdivide"})"),
        step(R"({"do":"subdivide","levels":1,"tolerance":1})"),
        step(R"({"do":"subdivide","levels":1,"scheme":"x"})"),
        step(R"({"do":"map_strokes","color":"no colour"})")};
    std::set<std::string> told;
    for (const std::string& text : scripts) {
        const auto script = readSketchScript(text);
        ASSERT_FALSE(script) << text;
        const std::string message = "X1.json: " + script.error().message;
        told.insert(message);
        expectNoEnglish(coreText(message), message);
    }
    EXPECT_GE(told.size(), scripts.size() - 2);
    EXPECT_EQ(coreText("lamp.json: script: the key \"format\" is missing"),
              "lamp.json: Skript: der Schlüssel \"format\" fehlt");
    // And of a document of an earlier version.
    for (const char* text :
         {R"({"format":"edgewright-document"})", R"({"format":"edgewright-document","version":7})",
          R"({"format":"edgewright-document","version":1})"}) {
        const auto document = readDocument(text, this->document().state().library);
        ASSERT_FALSE(document) << text;
        const std::string message = "X1.edgewright: " + document.error().message;
        expectNoEnglish(coreText(message), message);
    }
}

TEST_F(German, StepsThatAreLeftOutHaveGermanNames) {
    for (const char* const word : kStepWords) {
        EXPECT_NE(stepText(word).toStdString(), word);
        EXPECT_FALSE(stepText(word).contains('_'));
    }
    SketchScript script;
    script.viewport = {800, 600};
    script.steps.emplace_back(ExportStep{"notes.obj"});
    script.steps.emplace_back(SaveStep{"mine.edgewright"});
    ASSERT_TRUE(writeFileBytes(folder_.filePath("s.json"), writeSketchScript(script)));
    ASSERT_TRUE(window_->files().openPath(folder_.filePath("s.json")));
    const QString said = window_->messages().text();
    EXPECT_TRUE(said.contains("0 (Exportieren notes.obj), 1 (Speichern mine.edgewright)"))
        << said.toStdString();
}

TEST(Language, EveryStepOfScriptsHasAName) {
    std::set<std::string> words(std::begin(kStepWords), std::end(kStepWords));
    for (const ScriptStep& step :
         {ScriptStep(CameraStep{}),         ScriptStep(ThresholdsStep{}),
          ScriptStep(StrokeStep{}),         ScriptStep(EraseStep{}),
          ScriptStep(ClearStep{}),          ScriptStep(ApplyStep{}),
          ScriptStep(FilletStep{}),         ScriptStep(SharpenStep{}),
          ScriptStep(CreaseStep{}),         ScriptStep(SubdivideStep{}),
          ScriptStep(MapStrokesStep{}),     ScriptStep(UnmapStrokesStep{}),
          ScriptStep(DefineTemplateStep{}), ScriptStep(DeleteSolidStep{}),
          ScriptStep(UndoStep{}),           ScriptStep(RedoStep{}),
          ScriptStep(SaveStep{}),           ScriptStep(OpenStep{}),
          ScriptStep(ExportStep{}),         ScriptStep(NameStep{}),
          ScriptStep(CompactStep{}),        ScriptStep(PullStep{}),
          ScriptStep(MoveBodyStep{}),       ScriptStep(NameBodyStep{}),
          ScriptStep(ShowBodyStep{}),       ScriptStep(DeleteBodyStep{}),
          ScriptStep(CombineBodiesStep{}),  ScriptStep(MirrorPlaneStep{})}) {
        words.erase(std::string(stepName(step)));
    }
    EXPECT_EQ(words, std::set<std::string>{"begin"});
    EXPECT_EQ(std::variant_size_v<ScriptStep>, std::size(kStepWords) - 1);
}

TEST(Language, TheTextsOfQtAreGermanToo) {
    const QLocale before;
    const auto installed = qApp->findChildren<QTranslator*>();
    ASSERT_TRUE(chooseLanguage("de"));
    for (const char* english : {"Save", "Discard", "Cancel"}) {
        EXPECT_NE(QCoreApplication::translate("QPlatformTheme", english), english)
            << "the package of Qt's translations is missing";
    }
    EXPECT_NE(QCoreApplication::translate("QFileDialog", "Look in:"), "Look in:");
    for (QTranslator* translator : qApp->findChildren<QTranslator*>()) {
        if (!installed.contains(translator)) delete translator;
    }
    QLocale::setDefault(before);
}

}  // namespace
}  // namespace ew::test
