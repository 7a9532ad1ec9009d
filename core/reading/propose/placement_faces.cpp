// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/placement_faces.h"

#include <algorithm>
#include <map>

namespace ew {
namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

std::vector<int> facesUnder(int t, const JointReading& reading, const GraphMatch& match,
                            const ModelView& model, const Sighting& sighting, bool outside) {
    const PolyhedronSpec& shape = match.entry->tmpl.shape;
    const TemplateAnalysis& analysis = match.entry->analysis;
    Vec2 center = Vec2::Zero();
    for (const Junction& j : reading.graph.junctions) center += j.position;
    center /= static_cast<double>(reading.graph.junctions.size());
    constexpr double kAsidePx = 4.0;
    Vec2 middle = Vec2::Zero();
    int count = 0;
    for (const int v : shape.faces[at(t)]) {
        if (!sighting.seen[at(v)]) continue;
        middle += sighting.vertexPx[at(v)];
        ++count;
    }
    if (count > 0) middle /= count;
    std::map<int, int> votes;
    for (std::size_t g = 0; g < reading.graph.edges.size(); ++g) {
        const auto& faces = analysis.edges[at(match.edge[g])].faces;
        if (faces[0] != t && faces[1] != t) continue;
        if (const int m = reading.edgeModel[g]; m >= 0) {
            for (const int f : model.solid().edges()[at(m)].faces) votes[f] += 2;
        }
        const GraphEdge& e = reading.graph.edges[g];
        for (const double share : {0.3, 0.5, 0.7}) {
            const Vec2 p = (1 - share) * e.tips[0] + share * e.tips[1];
            const Vec2 d = (e.tips[1] - e.tips[0]).normalized();
            Vec2 aside(-d.y(), d.x());
            const bool away = aside.dot(p - (outside ? center : middle)) > 0;
            if (away != outside) aside = -aside;
            if (const auto f = model.faceAt(p + kAsidePx * aside)) ++votes[*f];
        }
    }
    std::vector<int> faces;
    for (const auto& [f, n] : votes) {
        if (model.view().facing(f) == Facing::Front) faces.push_back(f);
    }
    std::stable_sort(faces.begin(), faces.end(), [&](int a, int b) { return votes[a] > votes[b]; });
    if (faces.size() > 3) faces.resize(3);
    return faces;
}

}  // namespace ew
