// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edge_selection.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "core/solid/visibility.h"

namespace ew {

namespace {

constexpr double kReachPx = 10.0;
// An edge that is not seen is meant only where no other is near: it counts as this much farther.
constexpr double kHiddenPx = 6.0;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Found {
    EdgeRef edge;
    double distance = std::numeric_limits<double>::infinity();
};

Found nearestInView(const std::vector<Body>& bodies, const std::vector<SolidView>& views,
                    const Vec2& px) {
    Found best;
    const auto consider = [&](int body, int edge, double distance) {
        if (distance < best.distance) best = {{body, edge}, distance};
    };
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].hidden) continue;
        const int body = static_cast<int>(b);
        for (const VisiblePiece& piece : views[b].visiblePieces()) {
            consider(body, piece.edge, distanceToSegment(px, piece.px[0], piece.px[1]));
        }
        const auto& points = views[b].points();
        const auto& edges = bodies[b].solid.edges();
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const double distance =
                distanceToSegment(px, points[at(edges[e].ends[0])], points[at(edges[e].ends[1])]);
            consider(body, static_cast<int>(e), distance + kHiddenPx);
        }
    }
    return best.distance <= kReachPx ? best : Found{};
}

/// The body and face that is seen at a point.
FaceHit faceAt(const std::vector<Body>& bodies, const std::vector<SolidView>& views,
               const Vec2& px) {
    FaceHit best;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < views.size(); ++b) {
        if (bodies[b].hidden) continue;
        const auto pick = views[b].pick(px);
        if (!pick || pick->depthPx >= nearest) continue;
        nearest = pick->depthPx;
        best = {{static_cast<int>(b), pick->face}, pick->world};
    }
    return best;
}

/// The edges of the loops of a face; only of those with `with` where that is an edge.
std::vector<EdgeRef> faceEdges(const Body& body, int bodyIndex, int face, int with = -1) {
    const auto& edges = body.solid.edges();
    std::vector<EdgeRef> out;
    for (const auto& loop : body.solid.faces()[at(face)].loops) {
        std::set<std::pair<int, int>> sides;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            sides.emplace(loop[k], loop[(k + 1) % loop.size()]);
        }
        std::vector<EdgeRef> found;
        bool wanted = with < 0;
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const auto& ends = edges[e].ends;
            // Along the loop on the left, against it on the right.
            const bool left = edges[e].faces[0] == face && sides.contains({ends[0], ends[1]});
            const bool right = edges[e].faces[1] == face && sides.contains({ends[1], ends[0]});
            if (!left && !right) continue;
            found.push_back({bodyIndex, static_cast<int>(e)});
            wanted = wanted || static_cast<int>(e) == with;
        }
        if (wanted) out.insert(out.end(), found.begin(), found.end());
    }
    return out;
}

/// Fewer than bodies where one cannot be seen through the camera at all.
std::vector<SolidView> viewsOf(const std::vector<Body>& bodies, const OrthographicCamera& camera) {
    std::vector<SolidView> views;
    for (const Body& body : bodies) {
        auto view = SolidView::make(body.solid, body.pose, camera);
        if (!view) break;
        views.push_back(*std::move(view));
    }
    return views;
}

}  // namespace

std::optional<FaceHit> faceUnder(const std::vector<Body>& bodies, const OrthographicCamera& camera,
                                 const Vec2& px) {
    const std::vector<SolidView> views = viewsOf(bodies, camera);
    if (views.size() < bodies.size()) return std::nullopt;
    const FaceHit face = faceAt(bodies, views, px);
    if (face.face < 0) return std::nullopt;
    return face;
}

std::vector<EdgeRef> edgesOfFace(const std::vector<Body>& bodies, const FaceRef& face) {
    return faceEdges(bodies[at(face.body)], face.body, face.face);
}

EdgeSelection::EdgeSelection(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    connect(&document, &Document::changed, this, [this](DocumentChange what) {
        if (what != DocumentChange::Bodies) return;
        choice_.picked.clear();
        emit changed();
    });
}

std::vector<EdgeRef> EdgeSelection::edges() const {
    auto chosen = chosenEdges(document_.state().bodies, choice_);
    return chosen ? *std::move(chosen) : std::vector<EdgeRef>();
}

void EdgeSelection::setWhich(EdgeChoice::Which which) {
    if (which == choice_.which) return;
    choice_.which = which;
    emit changed();
}

void EdgeSelection::pick(const std::vector<EdgeRef>& edges, bool add) {
    std::vector<EdgeRef> picked = add ? choice_.picked : std::vector<EdgeRef>();
    const auto isPicked = [&](const EdgeRef& e) {
        return std::find(picked.begin(), picked.end(), e) != picked.end();
    };
    if (add && !edges.empty() && std::all_of(edges.begin(), edges.end(), isPicked)) {
        std::erase_if(picked, [&](const EdgeRef& e) {
            return std::find(edges.begin(), edges.end(), e) != edges.end();
        });
    } else {
        for (const EdgeRef& e : edges) {
            if (!isPicked(e)) picked.push_back(e);
        }
    }
    choice_.which = EdgeChoice::Which::Picked;
    choice_.picked = std::move(picked);
    emit changed();
}

std::vector<EdgeRef> edgesAt(const std::vector<Body>& bodies, const OrthographicCamera& camera,
                             const Vec2& px, PickMode mode) {
    const std::vector<SolidView> views = viewsOf(bodies, camera);
    if (views.size() < bodies.size()) return {};
    const FaceRef face = faceAt(bodies, views, px);
    if (mode == PickMode::Face) {
        if (face.body < 0) return {};
        return faceEdges(bodies[at(face.body)], face.body, face.face);
    }
    const Found found = nearestInView(bodies, views, px);
    if (found.edge.edge < 0) return {};
    if (mode == PickMode::Edge) return {found.edge};
    // The loop of the face under the point; beside the solid, of the one that is seen.
    const Body& body = bodies[at(found.edge.body)];
    const auto& faces = body.solid.edges()[at(found.edge.edge)].faces;
    int of = faces[0];
    const bool underPoint =
        face.body == found.edge.body && (face.face == faces[0] || face.face == faces[1]);
    if (underPoint) {
        of = face.face;
    } else if (views[at(found.edge.body)].facing(of) != Facing::Front) {
        of = faces[1];
    }
    return faceEdges(body, found.edge.body, of, found.edge.edge);
}

}  // namespace ew
