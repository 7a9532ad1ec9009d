// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/library_index.h"

#include <algorithm>
#include <set>

#include "core/tlib/symmetry.h"

namespace ew {
namespace {

/// The outlines of a cut are as many as there are connected sets of faces: a frustum over eight
/// corners has 2,000 in 2 s, one over twelve 12,000 in 26 s. Nobody draws such a one into a solid.
constexpr std::size_t kMostEdgesOnSolid = 24;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<Aspect> uniteSymmetric(std::vector<Aspect> aspects, const TemplateAnalysis& analysis,
                                   const std::vector<std::vector<int>>& symmetries) {
    std::vector<Aspect> kept;
    std::set<ShownEdges> known;
    for (Aspect& a : aspects) {
        if (known.contains(shownEdges(a, analysis, symmetries.front()))) continue;
        for (const auto& map : symmetries) known.insert(shownEdges(a, analysis, map));
        kept.push_back(std::move(a));
    }
    return kept;
}

}  // namespace

ShownEdges shownEdges(const Aspect& aspect, const TemplateAnalysis& analysis,
                      const std::vector<int>& symmetry) {
    ShownEdges result;
    for (std::size_t e = 0; e < aspect.edge.size(); ++e) {
        const auto& ends = analysis.edges[at(aspect.edge[e])].ends;
        const int image = analysis.edgeBetween(symmetry[at(ends[0])], symmetry[at(ends[1])]);
        auto label = [&](int graphVertex) {
            const int v = aspect.vertex[at(graphVertex)];
            return v < 0 ? -1 : symmetry[at(v)];
        };
        const int u = label(aspect.graph.edges[e][0]);
        const int v = label(aspect.graph.edges[e][1]);
        result.insert({std::min(u, v), std::max(u, v), image});
    }
    return result;
}

void addEntry(LibraryIndex& index, std::shared_ptr<const LibraryEntry> entry) {
    const int id = static_cast<int>(index.entries.size());
    for (std::size_t a = 0; a < entry->aspects.size(); ++a) {
        const Aspect& aspect = entry->aspects[a];
        index.byCode[aspect.form.code].push_back({id, static_cast<int>(a), -1});
        if (aspect.kind != AspectKind::Explicit || aspect.edgeOn) continue;
        for (std::size_t e = 0; e < aspect.edge.size(); ++e) {
            const Aspect less = withoutEdge(aspect, static_cast<int>(e));
            if (less.graph.edges.size() < 5) continue;
            index.bySignature[graphSignature(less.graph)].push_back(
                {id, static_cast<int>(a), static_cast<int>(e)});
        }
    }
    index.byId.emplace(entry->tmpl.id, id);
    index.entries.push_back(std::move(entry));
    index.onSolid = std::make_shared<LazyIndex>();
}

Aspect withoutEdge(const Aspect& aspect, int edge) {
    std::vector<bool> alive(aspect.edge.size(), true);
    alive[at(edge)] = false;
    std::vector<int> degree(aspect.vertex.size(), 0);
    auto recount = [&] {
        std::fill(degree.begin(), degree.end(), 0);
        for (std::size_t e = 0; e < alive.size(); ++e) {
            if (!alive[e]) continue;
            ++degree[at(aspect.graph.edges[e][0])];
            ++degree[at(aspect.graph.edges[e][1])];
        }
    };
    for (bool changed = true; changed;) {
        changed = false;
        recount();
        for (std::size_t e = 0; e < alive.size(); ++e) {
            if (!alive[e]) continue;
            const auto& ends = aspect.graph.edges[e];
            if (degree[at(ends[0])] == 1 || degree[at(ends[1])] == 1) {
                alive[e] = false;
                changed = true;
            }
        }
    }
    Aspect out;
    out.name = aspect.name;
    out.visibleFaces = aspect.visibleFaces;
    out.directions = aspect.directions;
    std::vector<std::array<int, 2>> edges;
    for (std::size_t e = 0; e < alive.size(); ++e) {
        if (!alive[e]) continue;
        edges.push_back(aspect.graph.edges[e]);
        out.edge.push_back(aspect.edge[e]);
    }
    // A T junction with two edges left is just a point on its bar.
    for (std::size_t v = 0; v < aspect.vertex.size(); ++v) {
        if (aspect.vertex[v] >= 0 || degree[v] != 2) continue;
        std::vector<std::size_t> at2;
        for (std::size_t e = 0; e < edges.size(); ++e) {
            if (edges[e][0] == static_cast<int>(v) || edges[e][1] == static_cast<int>(v))
                at2.push_back(e);
        }
        if (at2.size() != 2 || out.edge[at2[0]] != out.edge[at2[1]]) continue;
        auto far = [&](std::size_t e) {
            return edges[e][0] == static_cast<int>(v) ? edges[e][1] : edges[e][0];
        };
        edges[at2[0]] = {far(at2[0]), far(at2[1])};
        edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(at2[1]));
        out.edge.erase(out.edge.begin() + static_cast<std::ptrdiff_t>(at2[1]));
        degree[v] = 0;
    }
    std::vector<int> number(aspect.vertex.size(), -1);
    for (auto& e : edges) {
        for (int& v : e) {
            if (number[at(v)] < 0) {
                number[at(v)] = static_cast<int>(out.vertex.size());
                out.vertex.push_back(aspect.vertex[at(v)]);
                out.graph.points.push_back(aspect.graph.points[at(v)]);
            }
            v = number[at(v)];
        }
    }
    out.graph.edges = std::move(edges);
    indexAspect(out);
    return out;
}

std::shared_ptr<const LibraryEntry> makeEntry(Template tmpl) {
    auto entry = std::make_shared<LibraryEntry>();
    entry->tmpl = std::move(tmpl);
    entry->analysis = analyse(entry->tmpl);
    entry->symmetries = symmetries(entry->tmpl, entry->analysis);
    std::vector<Aspect> aspects = explicitAspects(entry->tmpl, entry->analysis);
    for (Aspect& a : edgeOnAspects(entry->tmpl, entry->analysis)) aspects.push_back(std::move(a));
    entry->aspects = uniteSymmetric(std::move(aspects), entry->analysis, entry->symmetries);
    return entry;
}

std::shared_ptr<const LibraryEntry> entryOnSolid(const LibraryEntry& known) {
    auto entry = std::make_shared<LibraryEntry>(known);
    std::erase_if(entry->aspects, [](const Aspect& a) { return a.edgeOn; });
    if (entry->analysis.edges.size() > kMostEdgesOnSolid) return entry;
    std::vector<Aspect> mouths;
    std::vector<Aspect> cavities;
    for (Aspect& a : implicitAspects(entry->tmpl, entry->analysis)) {
        (a.kind == AspectKind::Mouth ? mouths : cavities).push_back(std::move(a));
    }
    for (std::vector<Aspect>* some : {&mouths, &cavities}) {
        for (Aspect& a : uniteSymmetric(std::move(*some), entry->analysis, entry->symmetries)) {
            entry->aspects.push_back(std::move(a));
        }
    }
    return entry;
}

const LibraryIndex& onSolidIndex(const LibraryIndex& index) {
    static const LibraryIndex kEmpty;
    if (!index.onSolid) return kEmpty;
    LazyIndex& lazy = *index.onSolid;
    std::call_once(lazy.once, [&] {
        for (const auto& known : index.entries) addEntry(lazy.index, entryOnSolid(*known));
    });
    return lazy.index;
}

}  // namespace ew
