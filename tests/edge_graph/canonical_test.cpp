// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/canonical.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/vf2_sub_graph_iso.hpp>
#include <cmath>
#include <numeric>

#include "tests/support/random.h"

namespace ew {
namespace {

/// A triangulated disc of random points with some inner edges taken out, still two-edge-connected
/// enough to be interesting; always connected.
PlaneGraph randomPlaneGraph(test::Random& random) {
    PlaneGraph g;
    const int n = 5 + random.index(5);
    for (int i = 0; i < n; ++i) {
        const double a = 6.283185307179586 * i / n + random.uniform(0.0, 0.2);
        g.points.emplace_back(100 * std::cos(a), 100 * std::sin(a));
        g.edges.push_back({i, (i + 1) % n});
    }
    const int hub = n;
    g.points.emplace_back(random.uniform(-20, 20), random.uniform(-20, 20));
    for (int i = 0; i < n; ++i) {
        if (i == 0 || random.chance(0.6)) g.edges.push_back({i, hub});
    }
    return g;
}

PlaneGraph relabelled(const PlaneGraph& g, bool mirror, test::Random& random) {
    std::vector<int> to(g.points.size());
    std::iota(to.begin(), to.end(), 0);
    random.shuffle(to);
    PlaneGraph out;
    out.points.resize(g.points.size());
    const double a = random.uniform(0, 6.28);
    for (std::size_t i = 0; i < to.size(); ++i) {
        const Vec2 p(mirror ? -g.points[i].x() : g.points[i].x(), g.points[i].y());
        out.points[static_cast<std::size_t>(to[i])] = Eigen::Rotation2Dd(a) * p;
    }
    for (const auto& e : g.edges) {
        out.edges.push_back(
            {to[static_cast<std::size_t>(e[1])], to[static_cast<std::size_t>(e[0])]});
    }
    random.shuffle(out.edges);
    return out;
}

using Boost = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
Boost boostOf(const PlaneGraph& g) {
    Boost b(g.points.size());
    for (const auto& e : g.edges) {
        boost::add_edge(static_cast<std::size_t>(e[0]), static_cast<std::size_t>(e[1]), b);
    }
    return b;
}

/// VF2 as the oracle for isomorphism of the abstract graphs.
bool isomorphic(const PlaneGraph& a, const PlaneGraph& b) {
    if (a.points.size() != b.points.size() || a.edges.size() != b.edges.size()) return false;
    bool found = false;
    const Boost ga = boostOf(a);
    const Boost gb = boostOf(b);
    boost::vf2_graph_iso(ga, gb, [&](const auto&, const auto&) {
        found = true;
        return false;
    });
    return found;
}

RC_GTEST_PROP(CanonicalForm, NamesRotationAndMirroringDoNotMatter, ()) {
    test::Random random(*rc::gen::inRange<std::uint64_t>(0, 1u << 20));
    const PlaneGraph g = randomPlaneGraph(random);
    const CanonicalForm a = canonicalForm(g);
    RC_ASSERT(!a.code.empty());
    for (const bool mirror : {false, true}) {
        const PlaneGraph other = relabelled(g, mirror, random);
        const CanonicalForm b = canonicalForm(other);
        RC_ASSERT(a.code == b.code);
        RC_ASSERT(a.walks.size() == b.walks.size());
        RC_ASSERT(graphSignature(g) == graphSignature(other));
        // Every pair of walks is an isomorphism.
        for (const CanonicalWalk& w : b.walks) {
            std::vector<int> map(g.points.size());
            for (std::size_t i = 0; i < map.size(); ++i) {
                map[static_cast<std::size_t>(a.walks[0].vertices[i])] = w.vertices[i];
            }
            for (const auto& e : g.edges) {
                const int u = map[static_cast<std::size_t>(e[0])];
                const int v = map[static_cast<std::size_t>(e[1])];
                const bool kept =
                    std::any_of(other.edges.begin(), other.edges.end(), [&](const auto& f) {
                        return (f[0] == u && f[1] == v) || (f[0] == v && f[1] == u);
                    });
                RC_ASSERT(kept);
            }
        }
    }
}

RC_GTEST_PROP(CanonicalForm, EqualCodesAreIsomorphicByVf2, ()) {
    test::Random random(*rc::gen::inRange<std::uint64_t>(0, 1u << 20));
    const PlaneGraph a = randomPlaneGraph(random);
    const PlaneGraph b = randomPlaneGraph(random);
    const bool same = canonicalForm(a).code == canonicalForm(b).code;
    if (same) RC_ASSERT(isomorphic(a, b));
    if (!isomorphic(a, b)) RC_ASSERT(!same);
}

TEST(CanonicalForm, DisconnectedGraphsHaveNone) {
    PlaneGraph g;
    g.points = {{0, 0}, {10, 0}, {0, 10}, {100, 0}, {110, 0}, {100, 10}};
    g.edges = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}};
    EXPECT_TRUE(canonicalForm(g).code.empty());
}

TEST(CanonicalForm, AWheelHasTheSymmetriesOfItsRim) {
    PlaneGraph g;
    for (int i = 0; i < 5; ++i) {
        g.points.emplace_back(std::cos(1.2566370614 * i), std::sin(1.2566370614 * i));
        g.edges.push_back({i, (i + 1) % 5});
        g.edges.push_back({i, 5});
    }
    g.points.emplace_back(0, 0);
    EXPECT_EQ(canonicalForm(g).walks.size(), 10u);
}

}  // namespace
}  // namespace ew
