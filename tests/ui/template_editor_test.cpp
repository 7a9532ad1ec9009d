// SPDX-License-Identifier: GPL-3.0-or-later
// The template editor, with the events that a person makes.
#include "ui/template_editor/template_editor.h"

#include <QComboBox>
#include <QLabel>

#include "core/document/template_id.h"
#include "core/tlib/family.h"
#include "core/tlib/template_io.h"
#include "tests/ui/editor_fixture.h"
#include "tests/ui/german_fixture.h"
#include "ui/core_text.h"
#include "ui/number_box.h"
#include "ui/template_editor/aspect_list.h"
#include "ui/template_editor/shape_view.h"
#include "ui/theme/colours.h"

namespace ew::test {
namespace {

int pixelsLike(const QImage& image, const QColor& colour) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            count += std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                                 std::abs(c.blue() - colour.blue()) <
                             24
                         ? 1
                         : 0;
        }
    }
    return count;
}

TEST_F(EditorTest, DraftsOfShippedTemplatesSayTheSame) {
    const TemplateLibrary& library = document().state().library;
    for (std::size_t i = 0; i < library.size(); ++i) {
        const TemplateDraft draft = draftOf(library.at(i));
        EXPECT_EQ(writeTemplate(templateOf(draft)), writeTemplate(library.at(i)));
        EXPECT_TRUE(checkDraft(draft, library.without(library.at(i).id)).usable());
        // No right angle between the same two directions is offered a second time.
        for (std::size_t k = 0; k < draft.rules.size(); ++k) {
            for (std::size_t n = 0; n < k; ++n) {
                EXPECT_FALSE(sameRelation(draft.rules[k].relation, draft.rules[n].relation));
            }
        }
    }
}

TEST_F(EditorTest, IdsOfNamesAreWellFormed) {
    EXPECT_EQ(idFromName("House with a roof"), "house-with-a-roof");
    EXPECT_EQ(idFromName("  \xc3\x84 2. W\xc3\xbcrfel! "), "a-2-wurfel");
    EXPECT_EQ(idFromName("---"), "");
    EXPECT_LE(idFromName(std::string(300, 'x')).size(), 64U);
    const auto taken = [](const std::string& id) { return id == "a" || id == "a-2"; };
    EXPECT_EQ(freeId("a", taken), "a-3");
    EXPECT_EQ(freeId("b", taken), "b");
    EXPECT_EQ(freeId("", taken), "template");
}

TEST_F(EditorTest, MakesATemplateOfTheSolid) {
    makeBox();
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    EXPECT_EQ(editor->model().draft().tmpl.shape.vertices.size(), 8U);
    auto& save = part<QPushButton>(*editor, "saveTemplate");
    EXPECT_FALSE(save.isEnabled());
    type(*editor, "templateName", "My crate");
    EXPECT_EQ(part<QLineEdit>(*editor, "templateId").text(), "my-crate");
    ASSERT_TRUE(save.isEnabled());
    click(save);
    QApplication::processEvents();
    const Template* crate = inUse("my-crate");
    ASSERT_NE(crate, nullptr);
    EXPECT_EQ(crate->name, "My crate");
    EXPECT_EQ(crate->relations.parallel.size(), 3U);
    EXPECT_EQ(window_->findChild<TemplateEditor*>(), nullptr);
    backToWindow();
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(inUse("my-crate"), nullptr);
}

TEST_F(EditorTest, BeginsWithAPrismWhereThereIsNoSolid) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    EXPECT_EQ(editor->model().draft().tmpl.shape.vertices.size(), 12U);
    EXPECT_GT(part<AspectList>(*editor, "aspectList").count(), 2);
    // Nothing was changed, so nothing is asked.
    editor->setQuestion([] {
        ADD_FAILURE() << "asked for nothing";
        return TemplateEditor::Answer::Stay;
    });
    QTest::keyClick(editor->windowHandle(), Qt::Key_Escape);
    QApplication::processEvents();
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(window_->findChild<TemplateEditor*>(), nullptr);
}

TEST_F(EditorTest, WhatIsTickedIsARuleAndCanBeTakenBack) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    const int rule = 0;
    const auto on = [&] { return editor->model().draft().rules[rule].on; };
    const int open = editor->checker().report().openFreedoms;
    ASSERT_TRUE(on());
    tick(*editor, rule);
    EXPECT_FALSE(on());
    EXPECT_GT(editor->checker().report().openFreedoms, open);
    keys(*editor, QKeySequence::Undo);
    EXPECT_TRUE(on());
    EXPECT_EQ(part<RuleList>(*editor, "ruleList").item(rule)->checkState(), Qt::Checked);
    EXPECT_EQ(editor->checker().report().openFreedoms, open);
    keys(*editor, QKeySequence::Redo);
    EXPECT_FALSE(on());
}

TEST_F(EditorTest, UndoIsTheEditorsAlsoInAField) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    tick(*editor, 0);
    type(*editor, "templateName", "Nut");
    EXPECT_EQ(editor->model().draft().tmpl.name, "Nut");
    keys(*editor, QKeySequence::Undo);  // what was typed in one go is one step
    EXPECT_EQ(editor->model().draft().tmpl.name, "");
    EXPECT_EQ(part<QLineEdit>(*editor, "templateName").text(), "");
    EXPECT_FALSE(editor->model().draft().rules[0].on);
    keys(*editor, QKeySequence::Undo);
    EXPECT_TRUE(editor->model().draft().rules[0].on);
    EXPECT_FALSE(editor->model().isChanged());
}

TEST_F(EditorTest, LightsTheEdgesOfTheRuleThatIsPointedAt) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    ShapeView& view = editor->shapeView();
    const QColor lit = lightColours().accent;
    const int before = pixelsLike(view.grab().toImage(), lit);
    auto& list = part<RuleList>(*editor, "ruleList");
    MouseIn(*list.viewport()).hover(QRectF(list.visualItemRect(list.item(1))).center());
    QApplication::processEvents();
    EXPECT_GT(pixelsLike(view.grab().toImage(), lit), before + 300);
}

TEST_F(EditorTest, TurnsTheShapeAndPicksItsCorners) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    ShapeView& view = editor->shapeView();
    const Vec3 direction = view.camera().direction;
    MouseIn(view).drag({60, 60}, {130, 90});
    EXPECT_GT((view.camera().direction - direction).norm(), 0.1);
    EXPECT_EQ(view.pickedVertex(), -1);
    const auto& shape = editor->model().draft().tmpl.shape;
    const Vec2 corner = view.camera().project(shape.vertices[7]);
    MouseIn(view).click({corner.x(), corner.y()});
    ASSERT_GE(view.pickedVertex(), 0);
    EXPECT_TRUE(part<NumberBox>(*editor, "vertexX").isVisible());
    const Vec2 middle = (view.camera().project(shape.vertices[6]) + corner) / 2.0;
    MouseIn(view).click({middle.x(), middle.y()});
    ASSERT_TRUE(view.pickedEdge());
    EXPECT_FALSE(part<NumberBox>(*editor, "vertexX").isVisible());
    EXPECT_FALSE(editor->model().isChanged());
}

TEST_F(EditorTest, TellsWhatAMovedCornerBreaksAndMendsIt) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    type(*editor, "templateName", "Nut");
    ShapeView& view = editor->shapeView();
    const Vec2 corner = view.camera().project(editor->model().draft().tmpl.shape.vertices[7]);
    MouseIn(view).click({corner.x(), corner.y()});
    const int vertex = view.pickedVertex();
    ASSERT_GE(vertex, 0);
    auto& x = part<NumberBox>(*editor, "vertexX");
    click(x);
    x.selectAll();
    QTest::keyClicks(&x, "5");
    QTest::keyClick(&x, Qt::Key_Return);
    settle(*editor);
    EXPECT_EQ(editor->model().draft().tmpl.shape.vertices[static_cast<std::size_t>(vertex)].x(),
              5.0);
    ASSERT_FALSE(editor->checker().report().usable());
    EXPECT_FALSE(part<QPushButton>(*editor, "saveTemplate").isEnabled());
    const auto& faults = editor->checker().report().faults;
    EXPECT_TRUE(std::any_of(faults.begin(), faults.end(), [](const DraftFault& f) {
        return f.place == DraftFault::Place::Shape && f.text.startsWith("Face ");
    }));
    // The button beside a broken rule drops it.
    const auto broken = [&] {
        return std::count_if(faults.begin(), faults.end(), [](const DraftFault& f) {
            return f.mend == DraftFault::Mend::DropRule;
        });
    };
    const auto before = broken();
    ASSERT_GT(before, 0);
    click(part<QPushButton>(*editor, "mend"));
    settle(*editor);
    EXPECT_EQ(broken(), before - 1);
    keys(*editor, QKeySequence::Undo);
    keys(*editor, QKeySequence::Undo);
    EXPECT_TRUE(editor->checker().report().usable());
}

TEST_F(EditorTest, ATakenIdIsMendedByAButton) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    type(*editor, "templateName", "Bolt");
    auto& id = part<QLineEdit>(*editor, "templateId");
    id.selectAll();
    type(*editor, "templateId", "");
    id.selectAll();
    QTest::keyClicks(&id, "cube");
    settle(*editor);
    ASSERT_FALSE(editor->checker().report().usable());
    click(part<QPushButton>(*editor, "mend"));
    settle(*editor);
    EXPECT_EQ(id.text(), "cube-2");
    EXPECT_TRUE(editor->checker().report().usable());
}

TEST_F(EditorTest, SaysThatAnotherTemplateIsTheSame) {
    chooseInPanel("Wedge frustum", "duplicateTemplate");
    TemplateEditor* editor = openEditor();
    ASSERT_NE(editor, nullptr);
    const auto& faults = editor->checker().aspects().faults;
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_TRUE(faults[0].text.contains("Wedge frustum")) << faults[0].text.toStdString();
    EXPECT_TRUE(editor->checker().report().usable());
}

TEST_F(EditorTest, AsksBeforeSomethingIsLost) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    type(*editor, "templateName", "Nut");
    int asked = 0;
    auto answer = TemplateEditor::Answer::Stay;
    editor->setQuestion([&] {
        ++asked;
        return answer;
    });
    QTest::keyClick(editor->windowHandle(), Qt::Key_Escape);
    EXPECT_EQ(asked, 1);
    EXPECT_TRUE(editor->isVisible());
    answer = TemplateEditor::Answer::Discard;
    editor->close();
    EXPECT_EQ(asked, 2);
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(inUse("nut"), nullptr);
    EXPECT_EQ(window_->findChild<TemplateEditor*>(), nullptr);
}

TEST_F(EditorTest, OnlyTemplatesOfTheDocumentAreEdited) {
    chooseInPanel("Cube", "editTemplate");
    EXPECT_FALSE(enabled_);
    EXPECT_EQ(window_->findChild<TemplateEditor*>(), nullptr);
    chooseInPanel("Cube", "duplicateTemplate");
    EXPECT_TRUE(enabled_);
    TemplateEditor* copy = openEditor();
    ASSERT_NE(copy, nullptr);
    EXPECT_EQ(copy->model().draft().tmpl.id, "copy-of-cube");
    tick(*copy, 3);
    click(part<QPushButton>(*copy, "saveTemplate"));
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    ASSERT_NE(inUse("copy-of-cube"), nullptr);
    const std::size_t templates = document().state().library.size();

    chooseInPanel("Copy of Cube", "editTemplate");
    EXPECT_TRUE(enabled_);
    TemplateEditor* editor = openEditor();
    ASSERT_NE(editor, nullptr);
    EXPECT_TRUE(part<QLineEdit>(*editor, "templateId").isReadOnly());
    type(*editor, "templateName", " 2");
    click(part<QPushButton>(*editor, "saveTemplate"));
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(document().state().library.size(), templates);
    EXPECT_EQ(inUse("copy-of-cube")->name, "Copy of Cube 2");
    backToWindow();
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(inUse("copy-of-cube")->name, "Copy of Cube");
}

TEST_F(EditorTest, ShapesComeFromFamiliesAndOtherTemplates) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    type(*editor, "templateName", "Spire");
    QMenu* sources = part<QPushButton>(*editor, "shapeSources").menu();
    ASSERT_NE(sources, nullptr);
    auto* pyramids = sources->findChild<QMenu*>("family1");
    ASSERT_NE(pyramids, nullptr);
    EXPECT_EQ(pyramids->actions()[2]->text(), "over 5 corners");
    pyramids->actions()[2]->trigger();
    settle(*editor);
    EXPECT_EQ(editor->model().draft().tmpl.shape.vertices.size(), 6U);
    EXPECT_EQ(editor->model().draft().tmpl.name, "Spire");
    EXPECT_TRUE(editor->checker().report().usable());
    keys(*editor, QKeySequence::Undo);
    EXPECT_EQ(editor->model().draft().tmpl.shape.vertices.size(), 12U);
}

TEST_F(EditorTest, WordsAreKeptInTheTemplate) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    type(*editor, "templateName", "Nut");
    for (QTabWidget* pages : editor->findChildren<QTabWidget*>()) pages->setCurrentIndex(1);
    QApplication::processEvents();
    type(*editor, "templateDescription", "Six sides.");
    type(*editor, "templateCategory", "Screws");
    type(*editor, "templateTags", "hexagon, metal,");
    type(*editor, "templateAuthor", "A. Person");
    type(*editor, "templateLicence", "CC0-1.0");
    type(*editor, "templateVersion", "2");
    auto& language = part<QComboBox>(*editor, "templateLanguage");
    language.setCurrentIndex(language.findData("fr"));
    type(*editor, "templateLanguageName",
         QString::fromUtf8("\xc3\x89"
                           "crou"));
    EXPECT_TRUE(editor->save());
    const Template* nut = inUse("nut");
    ASSERT_NE(nut, nullptr);
    EXPECT_EQ(nut->description, "Six sides.");
    EXPECT_EQ(nut->about.category, "Screws");
    EXPECT_EQ(nut->about.tags, (std::vector<std::string>{"hexagon", "metal"}));
    EXPECT_EQ(nut->about.author, "A. Person");
    EXPECT_EQ(nut->about.licence, "CC0-1.0");
    EXPECT_EQ(nut->about.version, "2");
    ASSERT_TRUE(nut->about.inLanguage.contains("fr"));
    EXPECT_EQ(nut->about.inLanguage.at("fr").name,
              "\xc3\x89"
              "crou");
}

using GermanEditor = German;

TEST_F(GermanEditor, SpeaksGerman) {
    TemplateEditor editor(document(), *appearance_, familyTemplate(Family::Prism, 6), false,
                          window_.get());
    editor.show();
    editor.checker().settle();
    QApplication::processEvents();
    EXPECT_EQ(editor.windowTitle(), "Neue Vorlage[*]");
    const auto* rules = editor.findChild<RuleList*>("ruleList");
    ASSERT_NE(rules, nullptr);
    EXPECT_TRUE(rules->item(0)->text().startsWith("Parallel: "))
        << rules->item(0)->text().toStdString();
    EXPECT_EQ(editor.findChild<QPushButton*>("saveTemplate")->text(), "In das &Dokument aufnehmen");
    // What a template says of itself in German is said in German.
    Template box = document().state().library.at(0);
    box.id = "crate";
    box.name = "A crate";
    box.about.inLanguage["de"].name = "Eine Kiste";
    const QLocale before;
    QLocale::setDefault(QLocale("de"));
    ASSERT_TRUE(document().defineTemplate(box));
    const auto* list = window_->findChild<QListWidget*>("templateList");
    EXPECT_EQ(list->item(list->count() - 1)->text(), "Eine Kiste");
    EXPECT_EQ(coreText("A crate"), "Eine Kiste");
    QLocale::setDefault(before);
}

}  // namespace
}  // namespace ew::test
