// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/visibility.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"
#include "core/solid/view_grid.h"

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

/// A front face's depth over the picture: depth = slope . px + offset.
struct FaceDepth {
    Vec2 slope = Vec2::Zero();
    double offset = 0.0;
    double at(const Vec2& p) const { return slope.dot(p) + offset; }
};

/// A triangle of a front face in the picture, with the lines of its sides: inner side positive,
/// in px.
struct SeenTriangle {
    int face = -1;
    std::array<Vec2, 3> normals;
    std::array<double, 3> offsets{};

    bool holds(const Vec2& p, double slack) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (normals[k].dot(p) - offsets[k] < -slack) return false;
        }
        return true;
    }
};

}  // namespace

struct SolidView::Data {
    Solid solid;
    Pose pose;
    OrthographicCamera camera;
    std::vector<Vec2> points;
    std::vector<double> depths;
    std::vector<Facing> facing;
    std::vector<FaceDepth> depthOf;  ///< by face, of front faces
    std::vector<SeenTriangle> triangles;
    double samePx = 0.0;   ///< nearer than this is one place
    double depthPx = 0.0;  ///< what hides is nearer by more
    ViewGrid faceGrid;
    ViewGrid contourGrid;  ///< edges between a front face and another one

    explicit Data(Solid s) : solid(std::move(s)) {}

    void project();
    void faceEye();
    void addTriangles();
    void addContours();
    bool isContour(const SolidEdge& e) const {
        return (facing[idx(e.faces[0])] == Facing::Front) !=
               (facing[idx(e.faces[1])] == Facing::Front);
    }
    std::array<Vec2, 2> line(const SolidEdge& e) const {
        return {points[idx(e.ends[0])], points[idx(e.ends[1])]};
    }
    bool isHidden(const SolidEdge& edge, const Vec2& p, double depth) const;
};

void SolidView::Data::project() {
    const std::vector<Vec3>& vertices = solid.vertices();
    points.reserve(vertices.size());
    depths.reserve(vertices.size());
    // One matrix for all: camera.project would make its axes anew for every point.
    const Mat3 toCamera = camera.cameraToWorld().transpose() / camera.worldPerPixel;
    const Mat3 turn = toCamera * pose.rotation;
    const Vec3 shift = toCamera * (pose.translation - camera.center) +
                       Vec3(camera.width / 2, camera.height / 2, 0);
    Eigen::AlignedBox3d box;
    for (const Vec3& v : vertices) {
        const Vec3 p = turn * v + shift;
        points.emplace_back(p.x(), p.y());
        depths.push_back(p.z());
        box.extend(p);
    }
    const double size = box.sizes().maxCoeff() + 1e-4 * box.max().cwiseAbs().maxCoeff();
    samePx = tol::kViewSame * size;
    depthPx = tol::kViewDepth * size;
}

void SolidView::Data::faceEye() {
    const Mat3 turn = camera.cameraToWorld().transpose() * pose.rotation;
    facing.reserve(solid.faces().size());
    depthOf.resize(solid.faces().size());
    for (std::size_t f = 0; f < solid.faces().size(); ++f) {
        const Vec3 n = turn * solid.faces()[f].normal;
        const bool edgeOn = std::abs(n.z()) <= tol::kEdgeOnSine;
        facing.push_back(edgeOn ? Facing::EdgeOn : n.z() < 0.0 ? Facing::Front : Facing::Back);
        if (facing.back() != Facing::Front) continue;
        const int v = solid.faces()[f].loops[0][0];
        FaceDepth& d = depthOf[f];
        d.slope = -n.head<2>() / n.z();
        d.offset = depths[idx(v)] - d.slope.dot(points[idx(v)]);
    }
}

void SolidView::Data::addTriangles() {
    Eigen::AlignedBox2d area;
    for (const Vec2& p : points) area.extend(p);
    faceGrid = ViewGrid(area, solid.triangles().size(), 2.0 * samePx);
    for (const SolidTriangle& t : solid.triangles()) {
        if (facing[idx(t.face)] != Facing::Front) continue;
        std::array<Vec2, 3> corner;
        for (std::size_t k = 0; k < 3; ++k) corner[k] = points[idx(t.vertices[k])];
        SeenTriangle seen;
        seen.face = t.face;
        // Outward faces that look at the eye run counter-clockwise; with y down that is a
        // negative cross product.
        bool flat = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 side = corner[(k + 1) % 3] - corner[k];
            const double length = side.norm();
            flat |= length == 0.0;
            seen.normals[k] = Vec2(side.y(), -side.x()) / std::max(length, 1e-300);
            seen.offsets[k] = seen.normals[k].dot(corner[k]);
        }
        if (flat) continue;
        faceGrid.add(static_cast<int>(triangles.size()), corner);
        triangles.push_back(seen);
    }
    faceGrid.finish();
}

void SolidView::Data::addContours() {
    Eigen::AlignedBox2d area;
    for (const Vec2& p : points) area.extend(p);
    const std::vector<SolidEdge>& edges = solid.edges();
    contourGrid = ViewGrid(area, edges.size(), 2.0 * samePx);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (isContour(edges[e])) contourGrid.add(static_cast<int>(e), line(edges[e]));
    }
    contourGrid.finish();
}

/// Does a face other than the edge's own lie before a point of the edge?
bool SolidView::Data::isHidden(const SolidEdge& edge, const Vec2& p, double depth) const {
    for (const int t : faceGrid.at(p)) {
        const SeenTriangle& seen = triangles[idx(t)];
        if (seen.face == edge.faces[0] || seen.face == edge.faces[1]) continue;
        const FaceDepth& d = depthOf[idx(seen.face)];
        // On a steep face a hair beside its border is far off in depth.
        if (d.at(p) + 2.0 * samePx * d.slope.norm() > depth - depthPx) continue;
        if (seen.holds(p, samePx)) return true;
    }
    return false;
}

namespace {

/// Cuts one edge where a contour crosses it in front and keeps what is visible.
class EdgeCutter {
  public:
    explicit EdgeCutter(const SolidView::Data& view)
        : view_(view), stamp_(view.solid.edges().size(), -1) {}

    void run(int e, std::vector<VisiblePiece>& out) {
        const SolidEdge& edge = view_.solid.edges()[idx(e)];
        const Facing f = view_.facing[idx(edge.faces[0])];
        const Facing g = view_.facing[idx(edge.faces[1])];
        if (f == Facing::EdgeOn && g == Facing::EdgeOn) {
            endOn(e, edge, out);
            return;
        }
        if (f != Facing::Front && g != Facing::Front) return;
        const auto line = view_.line(edge);
        if ((line[1] - line[0]).norm() <= view_.samePx) {
            endOn(e, edge, out);
            return;
        }
        findCuts(e, edge, line);
        join(e, edge, line, out);
    }

  private:
    struct Cut {
        double t = 0.0;
        int edge = -1;  ///< contour, -1 at the ends
    };

    /// Only the end towards the eye can be seen.
    void endOn(int e, const SolidEdge& edge, std::vector<VisiblePiece>& out) const {
        const bool second = view_.depths[idx(edge.ends[1])] < view_.depths[idx(edge.ends[0])];
        const int near = edge.ends[second ? 1 : 0];
        const Vec2& p = view_.points[idx(near)];
        if (view_.isHidden(edge, p, view_.depths[idx(near)])) return;
        VisiblePiece piece;
        piece.edge = e;
        piece.t0 = piece.t1 = second ? 1.0 : 0.0;
        piece.px = {p, p};
        for (PieceEnd& end : piece.ends) end = {PieceEnd::Kind::Vertex, near};
        piece.point = true;
        out.push_back(piece);
    }

    void findCuts(int e, const SolidEdge& edge, const std::array<Vec2, 2>& line) {
        cuts_ = {{0.0, -1}, {1.0, -1}};
        const Vec2 d = line[1] - line[0];
        const double length = d.norm();
        const double z0 = view_.depths[idx(edge.ends[0])];
        const double z1 = view_.depths[idx(edge.ends[1])];
        view_.contourGrid.along(line, [&](ViewGrid::Range cell) {
            for (const int c : cell) {
                if (stamp_[idx(c)] == e || c == e) continue;
                stamp_[idx(c)] = e;
                const SolidEdge& other = view_.solid.edges()[idx(c)];
                const auto contour = view_.line(other);
                const Vec2 along = contour[1] - contour[0];
                const double reach = along.norm();
                const double det = cross2(d, along);
                // Parallel contours end in others, which cross.
                if (std::abs(det) <= view_.samePx * std::min(length, reach)) continue;
                const double t = cross2(contour[0] - line[0], along) / det;
                const double u = cross2(contour[0] - line[0], d) / det;
                const double slackT = view_.samePx / length;
                const double slackU = view_.samePx / reach;
                if (t < slackT || t > 1.0 - slackT || u < -slackU || u > 1.0 + slackU) continue;
                const double c0 = view_.depths[idx(other.ends[0])];
                const double c1 = view_.depths[idx(other.ends[1])];
                if (c0 + u * (c1 - c0) > z0 + t * (z1 - z0) + view_.depthPx) continue;
                cuts_.push_back({t, c});
            }
        });
        std::sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) {
            return a.t != b.t ? a.t < b.t : a.edge < b.edge;
        });
    }

    void join(int e, const SolidEdge& edge, const std::array<Vec2, 2>& line,
              std::vector<VisiblePiece>& out) const {
        const double slack = 2.0 * view_.samePx / (line[1] - line[0]).norm();
        const double z0 = view_.depths[idx(edge.ends[0])];
        const double z1 = view_.depths[idx(edge.ends[1])];
        const auto at = [&](double t) -> Vec2 { return line[0] + t * (line[1] - line[0]); };
        bool open = false;
        Cut last = cuts_[0];
        for (std::size_t k = 1; k < cuts_.size(); ++k) {
            // Cuts in one place are one; the ends of the edge stay what they are.
            if (cuts_[k].t - last.t <= slack && cuts_[k].edge >= 0) continue;
            const double middle = 0.5 * (last.t + cuts_[k].t);
            const bool seen = !view_.isHidden(edge, at(middle), z0 + middle * (z1 - z0));
            if (seen && !open) begin(e, edge, last, at(last.t), out);
            if (!seen && open) end(edge, last, at(last.t), out.back());
            open = seen;
            last = cuts_[k];
        }
        if (open) end(edge, last, at(last.t), out.back());
    }

    void begin(int e, const SolidEdge& edge, const Cut& cut, const Vec2& px,
               std::vector<VisiblePiece>& out) const {
        VisiblePiece piece;
        piece.edge = e;
        piece.t0 = cut.t;
        piece.px[0] = px;
        piece.ends[0] = endOf(edge, cut, 0);
        piece.silhouette = view_.isContour(edge);
        out.push_back(piece);
    }
    static void end(const SolidEdge& edge, const Cut& cut, const Vec2& px, VisiblePiece& piece) {
        piece.t1 = cut.t;
        piece.px[1] = px;
        piece.ends[1] = endOf(edge, cut, 1);
    }
    static PieceEnd endOf(const SolidEdge& edge, const Cut& cut, std::size_t side) {
        if (cut.edge >= 0) return {PieceEnd::Kind::Occluded, cut.edge};
        return {PieceEnd::Kind::Vertex, edge.ends[side]};
    }

    const SolidView::Data& view_;
    std::vector<int> stamp_;  ///< by contour: the edge that saw it last
    std::vector<Cut> cuts_;
};

}  // namespace

Result<SolidView> SolidView::make(const Solid& solid, const Pose& pose,
                                  const OrthographicCamera& camera) {
    if (auto ok = camera.validate(); !ok) return fail(ok.error());
    auto data = std::make_shared<Data>(solid);
    data->pose = pose;
    data->camera = camera;
    data->project();
    data->faceEye();
    data->addTriangles();
    data->addContours();
    return SolidView(std::move(data));
}

std::vector<VisiblePiece> SolidView::visiblePieces() const {
    std::vector<VisiblePiece> out;
    EdgeCutter cutter(*data_);
    const int count = static_cast<int>(data_->solid.edges().size());
    for (int e = 0; e < count; ++e) cutter.run(e, out);
    return out;
}

std::optional<Pick> SolidView::pick(const Vec2& px) const {
    std::optional<Pick> best;
    if (!px.allFinite()) return best;
    for (const int t : data_->faceGrid.at(px)) {
        const SeenTriangle& seen = data_->triangles[idx(t)];
        const double depth = data_->depthOf[idx(seen.face)].at(px);
        if (best && depth >= best->depthPx) continue;
        if (!seen.holds(px, data_->samePx)) continue;
        best = Pick{seen.face, depth, Vec3::Zero(), Vec3::Zero()};
    }
    if (best) {
        best->world = data_->camera.unproject(px, best->depthPx);
        best->body = data_->pose.toBody(best->world);
    }
    return best;
}

const std::vector<Vec2>& SolidView::points() const { return data_->points; }
const std::vector<double>& SolidView::depths() const { return data_->depths; }
Facing SolidView::facing(int face) const { return data_->facing[idx(face)]; }

}  // namespace ew
