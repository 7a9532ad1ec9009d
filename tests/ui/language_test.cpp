// SPDX-License-Identifier: GPL-3.0-or-later
// The window in German.
#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QMenuBar>
#include <QUndoStack>
#include <set>

#include "core/document/step_names.h"
#include "tests/ui/german_fixture.h"
#include "ui/app_setup.h"
#include "ui/core_text.h"
#include "ui/panels/graph_panel.h"

namespace ew::test {
namespace {

TEST_F(German, MenusPanelsAndPluralsAreGerman) {
    QStringList menus;
    for (const QAction* a : window_->menuBar()->actions()) menus << a->text();
    EXPECT_EQ(menus, (QStringList{"&Datei", "&Bearbeiten", "&Ansicht", "&Zeichnung", "&Oberfläche",
                                  "&Hilfe"}));
    const auto edges = [](int n) {
        return QCoreApplication::translate("ew::GraphPanel", "%n edge(s)", nullptr, n);
    };
    EXPECT_EQ(edges(1), "1 Kante");
    EXPECT_EQ(edges(9), "9 Kanten");
    drawLines(Hand::Mouse, boxLines());
    ASSERT_TRUE(document().apply());
    EXPECT_EQ(document().undoStack().text(0), "Quader erzeugen");
}

TEST_F(German, TheHistoryOfADocumentFromAnEnglishWindowIsGerman) {
    const QString path = folder_.filePath("english.edgewright");
    QCoreApplication::removeTranslator(&translator_);
    Document english(document().state().library);
    ASSERT_TRUE(english.setCamera(document().camera()));
    for (const auto& l : boxLines()) {
        ASSERT_TRUE(english.addStroke(Stroke{{{l[0], 1, 0}, {l[1], 1, 0}}}));
    }
    ASSERT_TRUE(english.apply());
    ASSERT_TRUE(english.fillet({{}, 2.0, {}, false}));
    ASSERT_TRUE(english.fillet({{EdgeChoice::Which::Picked, {{0, 1}}}, 3.0, {}, false}));
    SubdivisionSettings smooth;
    smooth.on = true;
    ASSERT_TRUE(english.subdivide(smooth));
    ASSERT_TRUE(english.defineTemplateFromSolid("mine", "Hat stand"));
    ASSERT_TRUE(english.deleteBodies());
    EXPECT_EQ(english.undoStack().text(0), "Create cube");
    ASSERT_TRUE(english.save(path));
    ASSERT_TRUE(QCoreApplication::installTranslator(&translator_));
    ASSERT_TRUE(document().open(path));
    const QStringList german{
        "Quader erzeugen", "12 Kanten verrunden",           "1 Kante verrunden",
        "Glatte Fläche",   "Vorlage „Hat stand“ festlegen", "Körper löschen"};
    for (int i = 0; i < german.size(); ++i) {
        EXPECT_EQ(document().undoStack().text(i).toStdString(), german[i].toStdString());
    }
    // And the other way round.
    const QString back = folder_.filePath("german.edgewright");
    ASSERT_TRUE(document().save(back));
    QCoreApplication::removeTranslator(&translator_);
    ASSERT_TRUE(english.open(back));
    EXPECT_EQ(english.undoStack().text(0), "Create cube");
    EXPECT_EQ(english.undoStack().text(4), "Define template “Hat stand”");
    ASSERT_TRUE(QCoreApplication::installTranslator(&translator_));
}

TEST_F(German, SeveralSolidsOfOneDrawingAreCounted) {
    EXPECT_EQ(shownStepName("Create 2 solids").toStdString(), "2 Körper erzeugen");
    EXPECT_EQ(coreText("2 solids").toStdString(), "2 Körper");
    EXPECT_EQ(aspectText("region").toStdString(), "Zeichnung im Ganzen");
}

TEST_F(German, ExamplesOpenFromTheMenuByTheirGermanTitles) {
    QMenu* const file = window_->menuBar()->actions().front()->menu();
    QMenu* examples = nullptr;
    for (QAction* a : file->actions()) {
        if (a->menu() != nullptr) examples = a->menu();
    }
    ASSERT_NE(examples, nullptr);
    emit examples->aboutToShow();
    QAction* mouse = nullptr;
    QStringList titles;
    for (QAction* a : examples->actions()) {
        titles << a->text();
        EXPECT_TRUE(a->text().contains("von Hand gezeichnet")) << a->text().toStdString();
        if (a->text().contains("Computermaus")) mouse = a;
    }
    for (const char* title : {"Ein Drucker, von Hand gezeichnet", "Eine Uhr, von Hand gezeichnet",
                              "Eine Computermaus, von Hand gezeichnet"}) {
        EXPECT_TRUE(titles.contains(title)) << title;
    }
    ASSERT_NE(mouse, nullptr);
    mouse->trigger();
    EXPECT_EQ(document().state().bodies.size(), 1U);
    EXPECT_TRUE(document().shape()->hasSurface());
    EXPECT_FALSE(document().shape()->curves.empty());
}

/// Every sentence of a reading that people see.
std::vector<std::string> sentences(const Interpretation& r) {
    std::vector<std::string> all;
    if (r.problem) all.push_back(r.problem->message);
    for (const Culprit& c : r.culprits) all.push_back(c.label);
    for (const Repair& repair : r.repairs) all.push_back(repair.label);
    for (const Candidate& c : r.candidates) {
        all.push_back(c.templateName);
        if (!c.readingName.empty()) all.push_back(c.readingName);
        all.insert(all.end(), c.notes.begin(), c.notes.end());
    }
    return all;
}

TEST_F(German, WhatTheCoreSaysIsGermanToo) {
    using Lines = std::vector<std::array<Vec2, 2>>;
    const Lines box = boxLines();
    Lines open(box.begin(), box.end() - 1);
    Lines gap = box;
    gap[8][1] += 19.0 * (gap[8][0] - gap[8][1]).normalized();
    Lines two = box;
    for (const auto& l : boxLines({20, 20, 20}))
        two.push_back({l[0] + Vec2(300, 0), l[1] + Vec2(300, 0)});
    Lines turned = box;
    for (auto& l : turned) {
        for (Vec2& p : l) {
            if ((p - box[3][1]).norm() < 1) p += Vec2(-46, 12);
        }
    }
    const Lines bowTie{{Vec2(200, 200), Vec2(400, 400)},
                       {Vec2(400, 400), Vec2(400, 200)},
                       {Vec2(400, 200), Vec2(200, 400)},
                       {Vec2(200, 400), Vec2(200, 200)}};
    const Lines square{{Vec2(200, 200), Vec2(400, 200)},
                       {Vec2(400, 200), Vec2(400, 400)},
                       {Vec2(400, 400), Vec2(200, 400)},
                       {Vec2(200, 400), Vec2(200, 200)}};
    std::set<std::string> told;
    for (const Lines& lines :
         {Lines{}, open, gap, two, turned, bowTie, square, prismLines(), box}) {
        document().clearStrokes();
        for (const auto& l : lines) {
            ASSERT_TRUE(document().addStroke(Stroke{{{l[0], 1, 0}, {l[1], 1, 0}}}));
        }
        for (const std::string& s : sentences(document().interpretation())) told.insert(s);
    }
    EXPECT_GT(told.size(), 20U);
    for (const std::string& s : told) {
        const QString german = coreText(s);
        EXPECT_NE(german.toStdString(), s);
        EXPECT_FALSE(german.contains('%')) << german.toStdString();
        for (const char* english : {" the ", "edge", "corner", "line", "degree"}) {
            EXPECT_FALSE(german.contains(english)) << german.toStdString();
        }
    }
    EXPECT_EQ(coreText("A line ends 19 px from what it should meet (the distance threshold is 14 "
                       "px)."),
              "Eine Linie endet 19 px vor dem, was sie treffen sollte (die Abstandsschwelle ist 14 "
              "px).");
    EXPECT_EQ(coreText("No template shows one corner and 9 edges like this. The nearest is Cube "
                       "(one line missing, 2 lines too many)."),
              "Keine Vorlage zeigt so eine Ecke und 9 Kanten. Am nächsten ist: Quader "
              "(zu wenig: eine Linie, zu viel: 2 Linien).");
    EXPECT_EQ(coreText("This can be read as Cube or Hat stand or L-prism; choose one."),
              "Lesbar als Quader oder Hat stand oder L-Prisma; bitte auswählen.");
    EXPECT_EQ(coreText("This could be a Cube or an L-prism, but only without some of the lines; "
                       "choose it, or draw on."),
              "Lesbar als Quader oder L-Prisma, aber nur ohne einige der Linien; auswählen oder "
              "weiterzeichnen.");
    EXPECT_EQ(coreText("Take it as an L-prism all the same"), "Trotzdem nehmen: L-Prisma");
    EXPECT_EQ(coreText("Take it as an L-prism"), "Nehmen: L-Prisma");
    EXPECT_EQ(coreText("This could be an L-prism of these lengths; choose it, or draw on."),
              "Lesbar als L-Prisma mit diesen Längen; auswählen oder weiterzeichnen.");
    EXPECT_EQ(coreText("Take: cutting an L-prism"), "Nehmen: L-Prisma abziehen");
    EXPECT_EQ(coreText("This can be read as adding a Cube or cutting an L-prism; choose one."),
              "Lesbar als Quader hinzufügen oder L-Prisma abziehen; bitte auswählen.");
    EXPECT_EQ(solidText("Cube"), "Quader");
    EXPECT_EQ(solidText("Hat stand"), "Hat stand");
    // The name that somebody gave, and what nobody has translated.
    EXPECT_EQ(coreText("Take the 50 %1 thing"), "Nehmen: 50 %1 thing");
    EXPECT_EQ(coreText("Do or die"), "Do or die");
    EXPECT_EQ(coreText("Something else happened."), "Something else happened.");
}

TEST_F(German, WhatTheCoreSaysOfSurfacesIsGermanToo) {
    std::vector<std::string> said;
    const auto told = [&](const auto& refused) {
        ASSERT_FALSE(refused);
        said.push_back(refused.error().message);
    };
    const EdgeChoice all;
    EdgeChoice concave;
    concave.which = EdgeChoice::Which::Concave;
    EdgeChoice picked;
    picked.which = EdgeChoice::Which::Picked;
    SubdivisionSettings smooth;
    smooth.on = true;
    told(document().fillet({all, 3.0, {}, false}));
    told(document().subdivide(smooth));
    told(document().unmapStrokes());
    told(document().exportTo("solid"));
    drawLines(Hand::Mouse, boxLines());
    told(document().mapStrokes());
    ASSERT_TRUE(document().apply());
    told(document().fillet({all, 0.0, {}, false}));
    told(document().fillet({all, 3.0, 1000, false}));
    told(document().fillet({concave, 3.0, {}, false}));
    told(document().fillet({picked, 3.0, {}, false}));
    told(document().sharpen(all));
    told(document().crease(all, 11.0));
    document().setSurfaceMemoryLimit(1000);
    told(document().subdivide(smooth));
    smooth.levels = 1000;
    told(document().subdivide(smooth));
    smooth.tolerance = -1.0;
    told(document().subdivide(smooth));
    const auto outcome = document().fillet({all, 500.5, {}, false});
    ASSERT_TRUE(outcome);
    ASSERT_FALSE(outcome->clamped.empty());
    for (const ClampedEdge& c : outcome->clamped) {
        said.push_back(clampText(document().state().bodies, c));
    }
    for (const std::string& s : said) {
        const QString german = coreText(s);
        EXPECT_NE(german.toStdString(), s);
        EXPECT_FALSE(german.contains('%')) << german.toStdString();
        for (const char* english : {" the ", "edge", "radius", "instead", "surface", "room"}) {
            EXPECT_FALSE(german.contains(english)) << german.toStdString();
        }
    }
    const QLocale before;
    QLocale::setDefault(QLocale("de"));
    EXPECT_EQ(coreText("Edge 5 (20 mm long): radius 2.25 mm instead of 5 mm, corner 3 leaves no "
                       "more room"),
              "Kante 5 (20 mm lang): Radius 2,25 mm statt 5 mm, Ecke 3 lässt nicht mehr Platz");
    QLocale::setDefault(before);
}

TEST(CoreText, IsEnglishInEnglish) {
    for (const char* text : {"Take the Cube", "gap 19 px, threshold 14 px", "one corner", "",
                             "This could be an L-prism, but only without some of the lines; choose "
                             "it, or draw on."}) {
        EXPECT_EQ(coreText(text), text);
    }
}

/// Texts of buttons, labels and numbers that get less room than they ask for.
QStringList cutOff(const QWidget& window) {
    QStringList found;
    for (const QWidget* w : window.findChildren<QWidget*>()) {
        if (!w->isVisible()) continue;
        QString text;
        if (const auto* button = qobject_cast<const QAbstractButton*>(w)) text = button->text();
        if (const auto* label = qobject_cast<const QLabel*>(w)) {
            text = label->text();
            if (label->wordWrap() && w->height() < label->heightForWidth(w->width())) found << text;
            if (label->wordWrap()) continue;
        }
        if (const auto* number = qobject_cast<const QAbstractSpinBox*>(w)) text = number->text();
        if (!text.isEmpty() && w->width() < w->sizeHint().width()) found << text;
    }
    return found;
}

TEST_F(German, NothingIsCutOff) {
    const auto complaints = [&] {
        QApplication::processEvents();  // layouts ask for a second turn
        return cutOff(*window_).join(" | ").toStdString();
    };
    EXPECT_EQ(complaints(), "");
    drawLines(Hand::Mouse, boxLines());
    EXPECT_EQ(complaints(), "");
    ASSERT_TRUE(document().apply());
    settle();
    EXPECT_EQ(complaints(), "");
    window_->findChild<QDockWidget*>("surfacePanel")->raise();
    EXPECT_EQ(complaints(), "");
}

TEST(Language, OneWithoutATranslationIsRefused) {
    for (const char* code : {"tlh", "fr", "C", "../de", "nonsense"}) {
        const QLocale before;
        const auto chosen = chooseLanguage(code);
        ASSERT_FALSE(chosen) << code;
        EXPECT_EQ(chosen.error().code, Errc::BadValue);
        EXPECT_NE(chosen.error().message.find(code), std::string::npos);
        EXPECT_EQ(QLocale(), before);
    }
}

}  // namespace
}  // namespace ew::test
