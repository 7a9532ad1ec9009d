// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/aspects.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/tlib/library.h"
#include "core/tlib/library_index.h"

namespace ew {
namespace {

class ShippedAspects : public ::testing::Test {
  protected:
    void SetUp() override {
        auto load = loadLibrary(std::string(EDGEWRIGHT_SOURCE_DIR) + "/resources/templates");
        ASSERT_TRUE(load);
        EXPECT_TRUE(load->problems.empty());
        library_ = load->library;
    }
    const LibraryEntry& entry(const std::string& id) const {
        return *library_.index().entries[static_cast<std::size_t>(library_.find(id))];
    }
    /// (vertices, edges) of each aspect in general position, or of those seen edge-on.
    std::multiset<std::pair<std::size_t, std::size_t>> sizes(const std::string& id,
                                                             bool edgeOn = false) const {
        std::multiset<std::pair<std::size_t, std::size_t>> s;
        for (const Aspect& a : entry(id).aspects) {
            if (a.edgeOn == edgeOn) s.emplace(a.vertex.size(), a.edge.size());
        }
        return s;
    }
    TemplateLibrary library_;
};

TEST_F(ShippedAspects, ABoxShowsThreeFacesFromEverywhere) {
    EXPECT_EQ(entry("cube").symmetries.size(), 48u);
    EXPECT_EQ(sizes("cube"), (std::multiset<std::pair<std::size_t, std::size_t>>{{7, 9}}));
    EXPECT_EQ(entry("cube").aspects[0].name, "explicit-3");
}

// Two faces that share an edge: what people draw of a box when they draw no more.
TEST_F(ShippedAspects, ABoxMayShowTwoFacesEdgeOn) {
    EXPECT_EQ(sizes("cube", true), (std::multiset<std::pair<std::size_t, std::size_t>>{{6, 7}}));
    EXPECT_TRUE(sizes("wedge-frustum", true).empty());
    EXPECT_TRUE(sizes("triangular-pyramid", true).empty());
    // On a solid nothing is seen edge-on by chance.
    for (const auto& e : onSolidIndex(library_.index()).entries) {
        for (const Aspect& a : e->aspects) EXPECT_FALSE(a.edgeOn) << e->tmpl.id << " " << a.name;
    }
}

TEST_F(ShippedAspects, APrismShowsItsTriangleWithOneOrTwoSides) {
    EXPECT_EQ(entry("triangular-prism").symmetries.size(), 12u);
    EXPECT_EQ(sizes("triangular-prism"),
              (std::multiset<std::pair<std::size_t, std::size_t>>{{5, 6}, {6, 8}}));
}

TEST_F(ShippedAspects, APyramidShowsTwoOrThreeFaces) {
    EXPECT_EQ(entry("triangular-pyramid").symmetries.size(), 24u);
    EXPECT_EQ(sizes("triangular-pyramid"),
              (std::multiset<std::pair<std::size_t, std::size_t>>{{4, 5}, {4, 6}}));
}

TEST_F(ShippedAspects, AFrustumFromAboveShowsFiveFaces) {
    const auto s = sizes("wedge-frustum");
    EXPECT_EQ(s.count({8, 12}), 1u);
    EXPECT_EQ(s.count({8, 11}), 1u);
}

TEST_F(ShippedAspects, OcclusionMakesTJunctions) {
    bool stem = false;
    for (const Aspect& a : entry("l-prism").aspects) {
        for (std::size_t v = 0; v < a.vertex.size(); ++v) {
            if (a.vertex[v] >= 0) continue;
            stem = true;
            // Two halves of one bar and a stem.
            std::map<int, int> edges;
            for (std::size_t e = 0; e < a.edge.size(); ++e) {
                for (const int w : a.graph.edges[e])
                    edges[a.edge[e]] += w == static_cast<int>(v) ? 1 : 0;
            }
            std::multiset<int> counts;
            for (const auto& [e, c] : edges) {
                if (c > 0) counts.insert(c);
            }
            EXPECT_EQ(counts, (std::multiset<int>{1, 2}));
        }
    }
    EXPECT_TRUE(stem);
}

TEST_F(ShippedAspects, EveryAspectIsConnectedAndEveryEdgeBordersARegion) {
    for (std::size_t i = 0; i < library_.size(); ++i) {
        for (const Aspect& a : library_.index().entries[i]->aspects) {
            EXPECT_FALSE(a.form.code.empty());
            std::map<int, int> degree;
            for (const auto& e : a.graph.edges) {
                ++degree[e[0]];
                ++degree[e[1]];
            }
            for (const auto& [v, d] : degree) EXPECT_GE(d, 2) << library_.at(i).id;
            EXPECT_FALSE(a.directions.empty());
        }
    }
}

TEST_F(ShippedAspects, TakingAnEdgeAwayLeavesNothingDangling) {
    for (const Aspect& a : entry("l-prism").aspects) {
        for (std::size_t e = 0; e < a.edge.size(); ++e) {
            const Aspect less = withoutEdge(a, static_cast<int>(e));
            EXPECT_LT(less.edge.size(), a.edge.size());
            std::map<int, int> degree;
            for (const auto& f : less.graph.edges) {
                ++degree[f[0]];
                ++degree[f[1]];
            }
            for (const auto& [v, d] : degree) EXPECT_GE(d, 2);
        }
    }
}

TEST(LoadLibrary, AFolderThatIsNotThereIsAnError) {
    const auto load = loadLibrary("/nowhere/at/all");
    ASSERT_FALSE(load);
    EXPECT_EQ(load.error().code, Errc::FileNotFound);
}

TEST_F(ShippedAspects, AnIdIsTakenOnce) {
    const auto again = library_.with(entry("cube").tmpl);
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().code, Errc::DuplicateId);
}

}  // namespace
}  // namespace ew
