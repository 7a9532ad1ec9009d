// SPDX-License-Identifier: GPL-3.0-or-later
// What an author of templates is told: relations of a shape, freedoms, families, aspects of others.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "core/base/tolerance.h"
#include "core/tlib/aspect_facts.h"
#include "core/tlib/family.h"
#include "core/tlib/freedom.h"
#include "core/tlib/template_io.h"

namespace ew::test {
namespace {

const TemplateLibrary& shipped() {
    static const TemplateLibrary library =
        loadLibrary(std::string(EDGEWRIGHT_SOURCE_DIR) + "/resources/templates")->library;
    return library;
}

const Template& shippedTemplate(const std::string& id) {
    return shipped().at(static_cast<std::size_t>(shipped().find(id)));
}

int count(const std::vector<FoundRelation>& relations, RelationKind kind) {
    return static_cast<int>(std::count_if(relations.begin(), relations.end(),
                                          [&](const auto& r) { return r.kind == kind; }));
}

/// The vertices in another order, and no face beginning where it did.
Template relabelled(Template t) {
    const int n = static_cast<int>(t.shape.vertices.size());
    const auto to = [n](int v) { return (5 * v + 3) % n; };  // 5 has no divisor in common with 6, 8
    std::vector<Vec3> moved(t.shape.vertices.size());
    for (int v = 0; v < n; ++v) {
        moved[static_cast<std::size_t>(to(v))] = t.shape.vertices[static_cast<std::size_t>(v)];
    }
    t.shape.vertices = std::move(moved);
    for (std::vector<int>& face : t.shape.faces) {
        for (int& v : face) v = to(v);
        std::rotate(face.begin(), face.begin() + 1, face.end());
    }
    const auto edges = [&](auto& group) {
        for (TemplateEdge& e : group) e = {to(e[0]), to(e[1])};
    };
    for (auto& group : t.relations.parallel) edges(group);
    for (auto& pair : t.relations.perpendicular) edges(pair);
    for (auto& group : t.relations.equalLength) edges(group);
    t.readings.clear();
    return t;
}

TEST(FoundRelations, ABoxHasThreeDirectionsAtRightAngles) {
    const auto found = findRelations(shippedTemplate("cube").shape);
    EXPECT_EQ(count(found, RelationKind::Parallel), 3);
    EXPECT_EQ(count(found, RelationKind::Perpendicular), 3);
    for (const FoundRelation& r : found) {
        if (r.kind == RelationKind::Parallel) {
            EXPECT_EQ(r.edges.size(), 4U);
        }
    }
}

TEST(FoundRelations, OfNumbersOfSevenDigits) {
    Template box = shippedTemplate("cube");
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vec3& v : box.shape.vertices) v = (turn * v).cast<float>().cast<double>();
    box.relations = {};
    const auto found = findRelations(box.shape, tol::kTemplateRelation);
    EXPECT_EQ(count(found, RelationKind::Parallel), 3);
    EXPECT_EQ(count(found, RelationKind::Perpendicular), 3);
    for (const FoundRelation& r : found) addRelation(box.relations, r);
    EXPECT_TRUE(checkTemplate(box, "t")) << checkTemplate(box, "t").error().message;
}

TEST(FoundRelations, HoldOfEveryFamily) {
    for (const Family family : {Family::Prism, Family::Pyramid, Family::Frustum}) {
        for (int corners = kFewestCorners; corners <= kMostCorners; ++corners) {
            Template t = familyTemplate(family, corners);
            ASSERT_TRUE(checkTemplate(t, t.id)) << checkTemplate(t, t.id).error().message;
            t.relations = {};
            for (const FoundRelation& r : findRelations(t.shape)) addRelation(t.relations, r);
            ASSERT_TRUE(checkTemplate(t, t.id)) << checkTemplate(t, t.id).error().message;
        }
    }
}

TEST(FoundRelations, AreTheSameInAnyOrderAndSense) {
    const FoundRelation a{RelationKind::Parallel, {{0, 1}, {3, 2}}};
    EXPECT_TRUE(sameRelation(a, {RelationKind::Parallel, {{2, 3}, {1, 0}}}));
    EXPECT_FALSE(sameRelation(a, {RelationKind::EqualLength, {{0, 1}, {3, 2}}}));
    EXPECT_FALSE(sameRelation(a, {RelationKind::Parallel, {{0, 1}, {4, 2}}}));
    EXPECT_FALSE(sameRelation(a, {RelationKind::Parallel, {{0, 1}, {3, 2}, {4, 5}}}));
}

TEST(Freedom, IsWhatABoxHasBesidesItsSize) {
    const Template& cube = shippedTemplate("cube");
    const auto held = countFreedom(cube.shape, listRelations(cube.relations));
    EXPECT_EQ(held.open, 2);  // three lengths, one of which is the size
    EXPECT_EQ(std::count(held.follows.begin(), held.follows.end(), true), 0);
    // A hexahedron with flat faces and nothing else: 24 coordinates, a plane asks one of each face.
    EXPECT_EQ(countFreedom(cube.shape, {}).open, 24 - 6 - 7);
}

TEST(Freedom, TellsWhatFollowsFromTheRest) {
    const Template& cube = shippedTemplate("cube");
    auto relations = listRelations(cube.relations);
    relations.push_back(relations.front());
    const auto twice = countFreedom(cube.shape, relations);
    EXPECT_TRUE(twice.follows.back());
    EXPECT_FALSE(twice.follows.front());
    // Opposite edges of a box are equally long already.
    relations.back() = {RelationKind::EqualLength,
                        {cube.relations.parallel[0][0], cube.relations.parallel[0][1]}};
    EXPECT_TRUE(countFreedom(cube.shape, relations).follows.back());
}

TEST(Freedom, OfAPyramidOverATriangle) {
    const Template t = familyTemplate(Family::Pyramid, 3);
    EXPECT_EQ(countFreedom(t.shape, {}).open, 12 - 7);
    const FoundRelation slanting{RelationKind::EqualLength, {{0, 3}, {1, 3}, {2, 3}}};
    EXPECT_EQ(countFreedom(t.shape, {slanting}).open, 12 - 7 - 2);
}

TEST(AspectFacts, SharesOfABoxAreThoseOfItsViews) {
    const auto entry = makeEntry(shippedTemplate("cube"));
    const auto facts = aspectFacts(*entry, shipped(), false);
    ASSERT_FALSE(facts.empty());
    ASSERT_TRUE(facts.front().share);
    // From nearly everywhere three faces of a box are seen.
    EXPECT_EQ(facts.front().aspect.name, "explicit-3");
    EXPECT_GT(*facts.front().share, 0.9);
    double sum = 0.0;
    for (const AspectFacts& f : facts) sum += f.share.value_or(0.0);
    EXPECT_LE(sum, 1.0 + 1e-9);
}

TEST(AspectFacts, SymmetricViewsAreCountedTogether) {
    for (const char* id : {"triangular-prism", "l-prism", "wedge-frustum"}) {
        const auto entry = makeEntry(shippedTemplate(id));
        double sum = 0.0;
        for (const AspectFacts& f : aspectFacts(*entry, shipped(), false)) {
            sum += f.share.value_or(0.0);
        }
        EXPECT_GT(sum, 0.85) << id;
        EXPECT_LE(sum, 1.0 + 1e-9) << id;
    }
}

TEST(AspectFacts, NamesWhoShowsTheSame) {
    const auto box = makeEntry(shippedTemplate("cube"));
    const auto facts = aspectFacts(*box, shipped(), true);
    const auto& rivals = facts.front().alsoShownBy;
    EXPECT_NE(std::find(rivals.begin(), rivals.end(), "wedge-frustum"), rivals.end());
    EXPECT_EQ(std::find(rivals.begin(), rivals.end(), "cube"), rivals.end());
    EXPECT_TRUE(std::any_of(facts.begin(), facts.end(), [](const AspectFacts& f) {
        return f.aspect.kind == AspectKind::Mouth && f.share;
    }));
}

TEST(AspectFacts, ManyEdgesHaveNoCuts) {
    const auto cuts = [](int corners) {
        const auto entry = makeEntry(familyTemplate(Family::Prism, corners));
        const auto facts = aspectFacts(*entry, TemplateLibrary(), true);
        return std::count_if(facts.begin(), facts.end(), [](const AspectFacts& f) {
            return f.aspect.kind != AspectKind::Explicit;
        });
    };
    EXPECT_GT(cuts(6), 100);
    EXPECT_EQ(cuts(9), 0);  // 27 edges
}

TEST(SameTemplate, IsFoundWhateverItsVerticesAreCalled) {
    for (const char* id : {"cube", "triangular-prism", "wedge-frustum"}) {
        Template other = relabelled(shippedTemplate(id));
        other.id = "mine";
        for (Vec3& v : other.shape.vertices) v.z() *= 1.7;
        ASSERT_TRUE(checkTemplate(other, "mine")) << checkTemplate(other, "mine").error().message;
        EXPECT_EQ(sameTemplate(*makeEntry(other), shipped()), id);
    }
}

TEST(SameTemplate, IsAnotherOneWithOtherRelations) {
    Template box = shippedTemplate("cube");
    box.id = "mine";
    ASSERT_FALSE(box.relations.perpendicular.empty());
    box.relations.perpendicular.pop_back();
    EXPECT_EQ(sameTemplate(*makeEntry(box), shipped()), "");
}

TEST(TemplateLibrary, ReplacesOneInItsPlace) {
    Template cube = shippedTemplate("cube");
    const int place = shipped().find("cube");
    cube.name = "Crate";
    const auto changed = shipped().withReplaced(cube);
    ASSERT_TRUE(changed) << changed.error().message;
    EXPECT_EQ(changed->find("cube"), place);
    EXPECT_EQ(changed->at(static_cast<std::size_t>(place)).name, "Crate");
    EXPECT_EQ(changed->size(), shipped().size());
    EXPECT_EQ(shippedTemplate("cube").name, "Cube");
    cube.id = "crate";
    EXPECT_EQ(shipped().withReplaced(cube).error().code, Errc::UnknownTemplate);
    EXPECT_EQ(shipped().without("cube").find("cube"), -1);
    EXPECT_EQ(shipped().without("cube").size(), shipped().size() - 1);
    EXPECT_TRUE(shipped().without("crate").sharesDataWith(shipped()));
}

}  // namespace
}  // namespace ew::test
