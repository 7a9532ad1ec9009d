// SPDX-License-Identifier: GPL-3.0-or-later
// Many changes in a row, each on what the ones before left: the solid stays a solid, and the
// history leads back and forth over the same bits.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <QTemporaryDir>
#include <QUndoStack>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/document/document.h"
#include "core/reading/interpret.h"
#include "core/solid/boolean.h"
#include "tests/document/fixtures.h"
#include "tests/support/modification_cases.h"
#include "tests/support/random.h"

namespace ew::test {
namespace {

constexpr double kGridMm = 0.5;

double onGrid(double x) { return kGridMm * std::round(x / kGridMm); }

/// A point of a face that is not seen too flatly, on the grid along the face, in the body's frame.
struct Spot {
    int face = -1;
    Vec3 at = Vec3::Zero();
};

std::optional<Spot> randomSpot(const Body& body, const Vec3& direction, Random& random) {
    constexpr double kFlattest = -0.25;
    constexpr int kTries = 50;
    const Solid& solid = body.solid;
    for (int i = 0; i < kTries; ++i) {
        const auto& triangles = solid.triangles();
        const SolidTriangle& t =
            triangles[static_cast<std::size_t>(random.index(static_cast<int>(triangles.size())))];
        const SolidFace& face = solid.faces()[static_cast<std::size_t>(t.face)];
        // Slanted faces get their changes by the neighbours that stand straight.
        if (face.normal.cwiseAbs().maxCoeff() < 1.0 - 1e-12) continue;
        if (body.pose.directionToWorld(face.normal).dot(direction) > kFlattest) continue;
        double u = random.uniform();
        double v = random.uniform();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const auto corner = [&](std::size_t k) {
            return solid.vertices()[static_cast<std::size_t>(t.vertices[k])];
        };
        const Vec3 p = corner(0) + u * (corner(1) - corner(0)) + v * (corner(2) - corner(0));
        Spot spot{t.face, Vec3(onGrid(p.x()), onGrid(p.y()), onGrid(p.z()))};
        spot.at += (face.offset - face.normal.dot(spot.at)) * face.normal;
        return spot;
    }
    return std::nullopt;
}

/// A box or a roof on or in the face, 8 to 30 mm wide.
PolyhedronSpec toolAt(const Solid& solid, const Spot& spot, bool inwards, Random& random) {
    const Vec3& normal = solid.faces()[static_cast<std::size_t>(spot.face)].normal;
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    Vec3 half = Vec3::Zero();
    for (int k = 0; k < 3; ++k) half[k] = onGrid(random.uniform(4, 15));
    const double height = onGrid(random.uniform(4, 14)) * (inwards ? -1.0 : 1.0);
    half[axis] = 0;
    const Vec3 a = spot.at - half;
    const Vec3 b = spot.at + half + height * normal;
    if (inwards || random.chance(0.7)) return boxSpec(a.cwiseMin(b), a.cwiseMax(b));
    const int along = (axis + 1) % 3;
    const int across = (axis + 2) % 3;
    Vec3 left = a;
    Vec3 right = a;
    right[across] += 2 * half[across];
    Vec3 top = a + height * normal;
    top[across] += half[across];
    Vec3 way = Vec3::Zero();
    way[along] = 2 * half[along];
    return prismSpec({left, right, top}, way);
}

/// A document in which changes of its only solid are drawn.
class Chain {
  public:
    /// \param understood  every drawing is read as it is meant: what it takes to read it is spared.
    Chain(std::uint64_t seed, bool understood)
        : random_(seed), understood_(understood), document_(shippedLibrary(), reader()) {
        OrthographicCamera camera = modificationCamera(0, Vec3(75, 60, 45));
        EXPECT_TRUE(document_.setCamera(camera));
        const auto p = [&](int x, int y, int z) {
            return camera.project(Vec3(150 * x, 120 * y, 90 * z));
        };
        draw({{p(0, 0, 0), p(1, 0, 0)},
              {p(1, 0, 0), p(1, 1, 0)},
              {p(0, 0, 1), p(1, 0, 1)},
              {p(1, 0, 1), p(1, 1, 1)},
              {p(1, 1, 1), p(0, 1, 1)},
              {p(0, 1, 1), p(0, 0, 1)},
              {p(0, 0, 0), p(0, 0, 1)},
              {p(1, 0, 0), p(1, 0, 1)},
              {p(1, 1, 0), p(1, 1, 1)}});
        EXPECT_TRUE(document_.apply());
        remember();
    }

    const Body& body() const { return document_.state().bodies.front(); }
    int changes() const { return static_cast<int>(solids_.size()) - 1; }
    Document& document() { return document_; }

    /// Draws one change and applies it; where it is refused, document and ink are as they were.
    void step() {
        const double azimuth = random_.uniform(0, 2 * std::numbers::pi);
        const double tilt = random_.uniform(0.45, 0.9) * (random_.chance(0.15) ? -1 : 1);
        OrthographicCamera camera;
        camera.direction = -Vec3(std::cos(azimuth) * std::cos(tilt),
                                 std::sin(azimuth) * std::cos(tilt), std::sin(tilt));
        camera.worldPerPixel = 0.1;
        const auto spot = randomSpot(body(), camera.direction, random_);
        if (!spot) return;
        camera.center = body().pose.toWorld(spot->at);
        const bool cut = random_.chance(0.5);
        const auto tool = Solid::fromSpec(toolAt(body().solid, *spot, cut, random_));
        if (!tool) return;
        const auto meant = combine(body().solid, *tool, cut ? BooleanKind::Cut : BooleanKind::Add);
        if (!meant) return;
        const ModificationCase c{"",     "",
                                 0,      body(),
                                 camera, Operation::Auto,
                                 "",     newVisibleLines(body(), meant->solid, camera)};
        if (c.lines.size() < 4) return;
        ASSERT_TRUE(document_.setCamera(camera));
        draw(linesOnPlane(c));
        meant_ = Change{cut ? Operation::Cut : Operation::Add, meant->solid};
        const auto before = &document_.state();
        const auto ink = document_.pendingStrokes().size();
        ApplyRequest request;
        request.operation = cut ? Operation::Cut : Operation::Add;
        if (document_.apply(request)) {
            remember();
            return;
        }
        EXPECT_EQ(&document_.state(), before);
        EXPECT_EQ(document_.pendingStrokes().size(), ink);
        document_.clearStrokes();
    }

    /// Back to the empty sheet and forth to the end: the solids of every step, to the bit.
    void walkTheHistory() {
        const int count = static_cast<int>(solids_.size());
        ASSERT_EQ(document_.undoStack().count(), count);
        for (int i = count - 1; i >= 0; --i) {
            expectSolid(i);
            ASSERT_TRUE(document_.undo());
        }
        EXPECT_TRUE(document_.state().bodies.empty());
        EXPECT_FALSE(document_.undo());
        for (int i = 0; i < count; ++i) {
            ASSERT_TRUE(document_.redo());
            expectSolid(i);
        }
        EXPECT_FALSE(document_.redo());
    }

  private:
    struct Change {
        Operation operation;
        Solid result;
    };

    Interpreter reader() {
        return [this](const std::vector<Stroke>& strokes, const TemplateLibrary& templates,
                      const InterpretOptions& options) {
            if (!understood_ || !meant_) return interpret(strokes, templates, options);
            Interpretation r;
            Candidate c;
            c.templateId = c.templateName = "part";
            c.operation = meant_->operation;
            c.body = 0;
            c.result = meant_->result;
            r.candidates.push_back(std::move(c));
            r.accepted = 0;
            return r;
        };
    }

    void draw(const std::vector<Line2>& lines) {
        for (Stroke& s : exactStrokes(lines)) EXPECT_TRUE(document_.addStroke(std::move(s)));
    }

    /// Keeps the newest solid; reading it from its text passes the whole validity check.
    void remember() {
        ASSERT_EQ(document_.state().bodies.size(), 1U);
        const Solid& solid = body().solid;
        const auto read = Solid::deserialize(solid.serialize());
        ASSERT_TRUE(read) << "after " << solids_.size() << ": " << read.error().message;
        EXPECT_TRUE(read->identicalTo(solid));
        EXPECT_EQ(read->shellCount(), solid.shellCount());
        EXPECT_EQ(read->genus(), solid.genus());
        solids_.push_back(solid);
    }

    void expectSolid(int i) const {
        ASSERT_EQ(document_.state().bodies.size(), 1U) << i;
        EXPECT_TRUE(body().solid.identicalTo(solids_[static_cast<std::size_t>(i)])) << i;
    }

    Random random_;
    bool understood_ = false;
    std::optional<Change> meant_;
    Document document_;
    std::vector<Solid> solids_;  ///< after every step of the history
};

TEST(ModificationChain, TwoHundredChangesAreTakenBackAndRedoneToTheBit) {
    Chain chain(7, true);
    for (int i = 0; i < 1000 && chain.changes() < 200; ++i) {
        chain.step();
        if (HasFatalFailure()) return;
    }
    ASSERT_EQ(chain.changes(), 200);
    chain.walkTheHistory();
    // The file holds the same history.
    const QTemporaryDir folder;
    const QString path = folder.filePath("chain.edgewright");
    ASSERT_TRUE(chain.document().save(path));
    Document again(shippedLibrary());
    ASSERT_TRUE(again.open(path));
    EXPECT_TRUE(sameState(again.state(), chain.document().state()));
    EXPECT_EQ(again.undoStack().count(), 201);
    ASSERT_TRUE(again.undo(201));
    EXPECT_TRUE(again.state().bodies.empty());
}

TEST(ModificationChain, DrawnChangesKeepASolid) {
    int changes = 0;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        Chain chain(seed, false);
        for (int i = 0; i < 6; ++i) chain.step();
        chain.walkTheHistory();
        changes += chain.changes();
    }
    EXPECT_GE(changes, 6);
}

RC_GTEST_PROP(ModificationChain, RandomChangesAreTakenBackAndRedoneToTheBit, ()) {
    Chain chain(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1 << 30)), true);
    for (int i = 0; i < 4; ++i) chain.step();
    chain.walkTheHistory();
    RC_ASSERT(!::testing::Test::HasFailure());
}

}  // namespace
}  // namespace ew::test
