// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/canonical.h"

#include <algorithm>
#include <array>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Walks the graph breadth first from a directed edge, neighbours in rotation order from the edge
/// of arrival; appends to `code` the degree and the numbers of the neighbours of each vertex. Stops
/// early once the code is greater than `best`.
bool walk(const RotationSystem& r, int start, bool mirrored, const std::string& best,
          std::string& code, std::vector<int>& order) {
    std::vector<int> number(r.degree.size(), -1);
    std::vector<int> entry;  // per walked vertex: the directed edge that its list starts with
    order.clear();
    code.clear();
    auto visit = [&](int v, int first) {
        number[at(v)] = static_cast<int>(order.size());
        order.push_back(v);
        entry.push_back(first);
    };
    visit(r.origin[at(start)], start);
    bool below = best.empty();
    for (std::size_t i = 0; i < order.size(); ++i) {
        const int first = entry[i];
        int d = first;
        do {
            const int w = r.target(d);
            if (number[at(w)] < 0) visit(w, RotationSystem::twin(d));
            code.push_back(static_cast<char>(number[at(w)] + 1));
            d = mirrored ? r.prev[at(d)] : r.next[at(d)];
        } while (d != first);
        code.push_back('\0');
        if (!below) {
            const int c = code.compare(0, code.size(), best, 0, std::min(code.size(), best.size()));
            if (c > 0) return false;
            below = c < 0;
        }
    }
    return true;
}

}  // namespace

CanonicalForm canonicalForm(const PlaneGraph& graph) {
    CanonicalForm form;
    if (graph.edges.empty() || graph.points.size() > 120) return form;
    const RotationSystem r = rotationOf(graph);
    std::string code;
    std::vector<int> order;
    // A walk from a vertex of the rarest degree is as good as any other and there are fewer of
    // them.
    std::array<int, 128> histogram{};
    for (const int d : r.degree) {
        if (d == 0 || d > 120) return form;
        ++histogram[at(d)];
    }
    int rare = 0;
    for (int d = 1; d < 128; ++d) {
        const int count = histogram[at(d)] * d;
        if (count > 0 && (rare == 0 || count < histogram[at(rare)] * rare)) rare = d;
    }
    for (int start = 0; start < r.directedCount(); ++start) {
        if (r.degree[at(r.origin[at(start)])] != rare) continue;
        for (const bool mirrored : {false, true}) {
            if (!walk(r, start, mirrored, form.code, code, order)) continue;
            if (order.size() != graph.points.size()) return CanonicalForm{};  // not connected
            if (form.code.empty() || code < form.code) {
                form.code = code;
                form.walks.clear();
            }
            form.walks.push_back({order, mirrored});
        }
    }
    return form;
}

std::size_t graphSignature(const PlaneGraph& graph) {
    std::vector<int> degree(graph.points.size(), 0);
    for (const auto& e : graph.edges) {
        ++degree[at(e[0])];
        ++degree[at(e[1])];
    }
    std::array<std::size_t, 8> histogram{};
    for (const int d : degree) ++histogram[at(std::min(d, 7))];
    // Sum over edges of the product of degrees tells apart most that the histogram does not.
    std::size_t mixed = 0;
    for (const auto& e : graph.edges) {
        mixed += at(degree[at(e[0])] * degree[at(e[1])]);
    }
    std::size_t h = graph.edges.size() * 1315423911u + mixed * 2654435761u;
    for (const std::size_t c : histogram) h = h * 131 + c;
    return h;
}

}  // namespace ew
