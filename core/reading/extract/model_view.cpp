// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/extract/model_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/tolerance.h"

namespace ew {
namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

Result<ModelView> ModelView::make(const Body& body, const OrthographicCamera& camera) {
    auto view = SolidView::make(body.solid, body.pose, camera);
    if (!view) return fail(view.error());
    return ModelView(body, camera, std::move(*view));
}

ModelView::ModelView(const Body& body, const OrthographicCamera& camera, SolidView view)
    : body_(body), camera_(camera), view_(std::move(view)), pieces_(view_.visiblePieces()) {
    toCamera_ = camera_.cameraToWorld().transpose() * body_.pose.rotation;
    const auto bounds = body_.solid.bounds();
    faceEdges_.resize(body_.solid.faces().size());
    for (std::size_t e = 0; e < body_.solid.edges().size(); ++e) {
        for (const int f : body_.solid.edges()[e].faces) {
            faceEdges_[at(f)].push_back(static_cast<int>(e));
        }
    }
    outlined_.resize(body_.solid.faces().size(), false);
    for (const VisiblePiece& piece : pieces_) {
        for (const int f : body_.solid.edges()[at(piece.edge)].faces) outlined_[at(f)] = true;
    }
    planes_.reserve(body_.solid.faces().size());
    for (const SolidFace& f : body_.solid.faces()) {
        const Vec3 n = toCamera_ * f.normal;
        planes_.push_back({n, n.dot(vertex(f.loops.front().front()))});
    }
    tolerance_ = tol::kPlanarRelative * (bounds[1] - bounds[0]).norm();
}

Vec3 ModelView::vertex(int v) const {
    const Vec2& p = view_.points()[at(v)];
    return {p.x(), p.y(), view_.depths()[at(v)]};
}

Vec3 ModelView::direction(const Vec3& body) const { return (toCamera_ * body).normalized(); }

Vec3 ModelView::edgeDirection(int edge) const {
    const SolidEdge& e = body_.solid.edges()[at(edge)];
    const auto& v = body_.solid.vertices();
    return direction(v[at(e.ends[1])] - v[at(e.ends[0])]);
}

Vec3 ModelView::toBody(const Vec3& camera) const {
    return body_.pose.toBody(camera_.unproject(camera.head<2>(), camera.z()));
}

std::optional<int> ModelView::faceAt(const Vec2& px) const {
    const auto pick = view_.pick(px);
    return pick ? std::optional<int>(pick->face) : std::nullopt;
}

bool ModelView::vertexInFace(int vertex, int face) const {
    const SolidFace& f = body_.solid.faces()[at(face)];
    return std::abs(f.normal.dot(body_.solid.vertices()[at(vertex)]) - f.offset) <= tolerance_;
}

std::vector<std::size_t> ModelView::piecesNear(const Eigen::AlignedBox2d& part) const {
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        Eigen::AlignedBox2d piece(pieces_[i].px[0]);
        piece.extend(pieces_[i].px[1]);
        if (piece.intersects(part)) near.push_back(i);
    }
    return near;
}

bool ModelView::known(int face) const {
    if (outlined_[at(face)]) return true;
    const SolidFace& f = body_.solid.faces()[at(face)];
    const auto& vertices = body_.solid.vertices();
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](const Vec3& v) { return f.normal.dot(v) <= f.offset + tolerance_; });
}

bool ModelView::edgeInFace(int edge, int face) const {
    const SolidEdge& e = body_.solid.edges()[at(edge)];
    return vertexInFace(e.ends[0], face) && vertexInFace(e.ends[1], face);
}

}  // namespace ew
