// SPDX-License-Identifier: GPL-3.0-or-later
// The scripts of resources/examples, as the File menu opens them.
#include <gtest/gtest.h>

#include <QDir>
#include <algorithm>
#include <set>

#include "core/document/replay.h"
#include "core/document/report.h"
#include "core/document/resources.h"
#include "core/document/store.h"
#include "core/surface/subdivision.h"

namespace ew {
namespace {

SketchScript example(const QString& name) {
    const auto folder = resourcesFolder();
    EXPECT_TRUE(folder);
    const auto text = readFileBytes(*folder + "/examples/" + name + ".json", kMaxScriptBytes);
    EXPECT_TRUE(text) << name.toStdString();
    auto script = readSketchScript(*text);
    EXPECT_TRUE(script) << name.toStdString() << ": " << script.error().message;
    return script ? *script : SketchScript{};
}

/// A document in which every step of an example was done.
std::unique_ptr<Document> replayed(const QString& name, ReplayReport& report) {
    auto document = std::make_unique<Document>(loadTemplates()->library);
    report = replay(*document, example(name), {});
    if (const StepReport* failed = report.firstFailure()) {
        ADD_FAILURE() << name.toStdString() << ", step " << failed->index << ": "
                      << failed->error->message;
    }
    return document;
}

TEST(Examples, AllHaveTitlesOfTheirOwnAndReplay) {
    const QDir folder(*resourcesFolder() + "/examples");
    const QStringList files = folder.entryList({"*.json"}, QDir::Files);
    EXPECT_GE(files.size(), 8);
    std::set<std::string> titles;
    for (const QString& file : files) {
        const QString name = file.chopped(5);
        EXPECT_FALSE(example(name).title.empty()) << name.toStdString();
        EXPECT_TRUE(titles.insert(example(name).title).second) << name.toStdString();
        ReplayReport report;
        const auto document = replayed(name, report);
        EXPECT_FALSE(document->state().bodies.empty()) << name.toStdString();
        EXPECT_TRUE(document->pendingStrokes().empty()) << name.toStdString();
    }
}

struct Model {
    const char* name;
    std::size_t sketches;  // at least
    bool drawnOn;
};

constexpr Model kModels[] = {{"printer", 10, true}, {"clock", 10, true}, {"mouse", 8, false}};

TEST(Examples, ModelsAreReadWithoutHelp) {
    std::set<std::string> kinds;
    for (const Model& model : kModels) {
        SCOPED_TRACE(model.name);
        for (const ScriptStep& step : example(model.name).steps) {
            const auto* apply = std::get_if<ApplyStep>(&step);
            if (apply == nullptr) continue;
            EXPECT_FALSE(apply->candidate || apply->obliqueFactor);
            EXPECT_TRUE(apply->templateId.empty());
            EXPECT_EQ(apply->operation, Operation::Auto);
        }
        ReplayReport report;
        const auto document = replayed(model.name, report);
        std::size_t sketches = 0;
        std::set<Operation> operations;
        for (const StepReport& step : report.steps) {
            if (step.chosen < 0) continue;
            ++sketches;
            const Candidate& c =
                step.interpretation->candidates[static_cast<std::size_t>(step.chosen)];
            operations.insert(c.operation);
            kinds.insert(c.templateId);
        }
        EXPECT_GE(sketches, model.sketches);
        EXPECT_EQ(operations,
                  (std::set<Operation>{Operation::Create, Operation::Add, Operation::Cut}));
    }
    EXPECT_EQ(kinds, (std::set<std::string>{"cube", "l-prism", "triangular-prism",
                                            "triangular-pyramid", "wedge-frustum"}));
}

TEST(Examples, ModelsEndAsClosedSurfacesThatWereDrawnOn) {
    for (const Model& model : kModels) {
        SCOPED_TRACE(model.name);
        ReplayReport report;
        const auto document = replayed(model.name, report);
        ASSERT_EQ(document->state().bodies.size(), 1U);
        const auto shape = document->shape();
        EXPECT_FALSE(shape->problem);
        EXPECT_TRUE(shape->clamped.empty());
        ASSERT_TRUE(shape->bodies[0].cage);
        ASSERT_TRUE(shape->bodies[0].surface);
        const SurfaceMesh& surface = *shape->bodies[0].surface;
        // Closed: every side of a triangle is one of another triangle, the other way round.
        std::set<std::pair<int, int>> sides;
        for (const auto& t : surface.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_TRUE(sides.emplace(t[k], t[(k + 1) % 3]).second);
            }
        }
        EXPECT_TRUE(std::all_of(sides.begin(), sides.end(), [&](const auto& s) {
            return sides.contains({s.second, s.first});
        }));
        const double solid = document->state().bodies[0].solid.volume();
        const double smooth = enclosedVolume(surface.positions, surface.triangles);
        EXPECT_LT(smooth, solid);
        EXPECT_GT(smooth, 0.9 * solid);
        EXPECT_TRUE(shape->missed.empty());
        EXPECT_GE(shape->curves.size(), model.drawnOn ? 30U : 5U);
    }
}

}  // namespace
}  // namespace ew
