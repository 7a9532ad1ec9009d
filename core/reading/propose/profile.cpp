// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/profile.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

#include "core/edge_graph/build.h"
#include "core/edge_graph/edit.h"
#include "core/reading/extract/plane_geometry.h"
#include "core/solid/visibility.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double kHandPx = 2.0;      ///< how far a corner may be missed
constexpr double kLeastTilt = 0.05;  ///< sine; a face that is seen edge-on has no outline on it
constexpr double kRoundness = 0.12;  ///< rms distance from a circle, in radii
constexpr double kLeastRadiusPx = 3.0;

/// A line of the outline in the plane of the face: normal . p = offset.
struct SheetLine {
    Vec2 normal = Vec2::Zero();
    double offset = 0.0;
};

/// The plane of a face as a sheet to draw on.
class Sheet {
  public:
    Sheet(const Body& body, int face, const OrthographicCamera& camera)
        : body_(body), face_(body.solid.faces()[at(face)]), camera_(camera) {
        const auto& loop = face_.loops[0];
        const auto& v = body.solid.vertices();
        double longest = 0.0;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec3 side = v[at(loop[(k + 1) % loop.size()])] - v[at(loop[k])];
            if (side.norm() <= longest) continue;
            longest = side.norm();
            u_ = side.normalized();
        }
        w_ = face_.normal.cross(u_);
        origin_ = v[at(loop[0])];
        direction_ = body.pose.directionToBody(camera.direction);
    }

    bool isEdgeOn() const { return std::abs(direction_.dot(face_.normal)) < kLeastTilt; }

    /// Where the ray through a point of the picture meets the plane. [mm on the sheet]
    Vec2 onSheet(const Vec2& px) const {
        const Vec3 from = body_.pose.toBody(camera_.unproject(px));
        const double t = (face_.offset - face_.normal.dot(from)) / face_.normal.dot(direction_);
        const Vec3 p = from + t * direction_ - origin_;
        return {p.dot(u_), p.dot(w_)};
    }
    Vec2 onSheet(const Vec3& p) const { return {(p - origin_).dot(u_), (p - origin_).dot(w_)}; }
    Vec3 inBody(const Vec2& q) const { return origin_ + q.x() * u_ + q.y() * w_; }
    Vec2 inPicture(const Vec2& q) const { return camera_.project(body_.pose.toWorld(inBody(q))); }
    /// The loops of the face.
    std::vector<std::vector<Vec2>> loops() const {
        std::vector<std::vector<Vec2>> out;
        for (const auto& loop : face_.loops) {
            out.emplace_back();
            for (const int v : loop) out.back().push_back(onSheet(body_.solid.vertices()[at(v)]));
        }
        return out;
    }

  private:
    const Body& body_;
    const SolidFace& face_;
    const OrthographicCamera& camera_;
    Vec3 u_ = Vec3::UnitX();
    Vec3 w_ = Vec3::UnitY();
    Vec3 origin_ = Vec3::Zero();
    Vec3 direction_ = Vec3::UnitZ();
};

/// The corners of a graph that is one closed line, from one to the next.
std::vector<Vec2> cornersOf(const EdgeGraph& outline) {
    std::vector<Vec2> out;
    std::set<std::size_t> used;
    int junction = outline.edges.front().ends[0];
    while (used.size() < outline.edges.size()) {
        std::size_t next = outline.edges.size();
        for (std::size_t e = 0; e < outline.edges.size(); ++e) {
            const auto& ends = outline.edges[e].ends;
            if (!used.contains(e) && (ends[0] == junction || ends[1] == junction)) next = e;
        }
        if (next == outline.edges.size()) break;
        used.insert(next);
        out.push_back(outline.junctions[at(junction)].position);
        const auto& ends = outline.edges[next].ends;
        junction = ends[0] == junction ? ends[1] : ends[0];
    }
    return out;
}

class ProfileReader {
  public:
    ProfileReader(const std::vector<Stroke>& strokes, const InterpretOptions& options,
                  const Vec2& inside)
        : strokes_(strokes), options_(options), inside_(inside) {}

    Result<Profile> read() {
        if (auto ok = findFace(); !ok) return fail(ok.error());
        const InkReading ink = readInk(strokes_, options_.thresholds.distancePx);
        if (auto polygon = polygonRound(ink)) return rectified(*std::move(polygon));
        for (const NoiseItem& item : ink.noise) {
            if (item.kind != NoiseKind::Curve || item.stroke < 0) continue;
            if (isRound(strokes_[at(item.stroke)])) return circle(item.stroke);
        }
        return fail(Errc::NoRegion, "No closed outline runs round this place.", {inside_});
    }

  private:
    Result<void> findFace() {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t b = 0; b < options_.bodies.size(); ++b) {
            const Body& body = options_.bodies[b];
            const auto view = SolidView::make(body.solid, body.pose, options_.camera);
            if (!view) return fail(view.error());
            const auto pick = view->pick(inside_);
            if (!pick || pick->depthPx >= nearest) continue;
            nearest = pick->depthPx;
            out_.body = static_cast<int>(b);
            out_.face = pick->face;
        }
        if (out_.face >= 0) {
            sheet_.emplace(options_.bodies[at(out_.body)], out_.face, options_.camera);
        }
        if (!sheet_ || sheet_->isEdgeOn()) {
            return fail(Errc::NoSurface, "No face is seen there.", {inside_});
        }
        return {};
    }

    /// The outline of straight lines round the place. [px]
    std::optional<std::vector<Vec2>> polygonRound(const InkReading& ink) {
        const EdgeGraph graph = buildEdgeGraph(ink, options_.thresholds.distancePx);
        if (graph.empty()) return std::nullopt;
        for (const EdgeGraph& part : connectedParts(graph)) {
            if (part.edges.size() < 3 || !isOneOutline(part)) continue;
            std::vector<Vec2> corners = cornersOf(part);
            if (corners.size() < 3 || !insidePolygon(corners, inside_)) continue;
            std::set<int> strokes;
            for (const GraphEdge& e : part.edges)
                strokes.insert(e.strokes.begin(), e.strokes.end());
            out_.strokes.assign(strokes.begin(), strokes.end());
            return corners;
        }
        return std::nullopt;
    }

    /// Is a stroke closed, but for a gap or an overlap of its ends, and the place inside it?
    bool isRound(const Stroke& stroke) const {
        std::vector<Vec2> polygon;
        for (const PenSample& s : stroke.samples) polygon.push_back(s.position);
        const double gap = (polygon.back() - polygon.front()).norm();
        Vec2 low = polygon.front();
        Vec2 high = low;
        for (const Vec2& p : polygon) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        constexpr double kWidestGap = 0.25;  // of the size
        const bool closed =
            gap <= std::max(options_.thresholds.distancePx, kWidestGap * (high - low).norm());
        return closed && insidePolygon(polygon, inside_);
    }

    /// The circle on the face of which a stroke is the picture (least squares, Kasa).
    Result<Profile> circle(int stroke) {
        const auto& samples = strokes_[at(stroke)].samples;
        Eigen::MatrixX3d a(samples.size(), 3);
        Eigen::VectorXd b(samples.size());
        std::vector<Vec2> points;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Vec2 q = sheet_->onSheet(samples[i].position);
            const auto row = static_cast<Eigen::Index>(i);
            a.row(row) << q.x(), q.y(), 1.0;
            b[row] = q.squaredNorm();
            points.push_back(q);
        }
        const Eigen::Vector3d x = a.colPivHouseholderQr().solve(b);
        const Vec2 center(0.5 * x[0], 0.5 * x[1]);
        const double square = x[2] + center.squaredNorm();
        double off = 0.0;
        const double radius = square > 0.0 ? std::sqrt(square) : 0.0;
        for (const Vec2& q : points) off += std::pow((q - center).norm() - radius, 2);
        off = std::sqrt(off / static_cast<double>(points.size()));
        if (radius < kLeastRadiusPx * options_.camera.worldPerPixel || off > kRoundness * radius) {
            return fail(
                Errc::CurvedStroke,
                "This closed line is no circle on the face; draw it straighter, or rounder.",
                {samples.front().position});
        }
        std::vector<Vec2> corners;
        for (int k = 0; k < kRoundSides; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kRoundSides;
            corners.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
        }
        out_.round = true;
        out_.strokes = {stroke};
        return finished(corners);
    }

    Result<Profile> rectified(const std::vector<Vec2>& px) {
        std::vector<Vec2> corners;
        for (const Vec2& p : px) corners.push_back(sheet_->onSheet(p));
        if (areaOf(corners) < 0.0) std::reverse(corners.begin(), corners.end());
        const std::vector<Vec2> directions = regularDirections(corners);
        std::vector<SheetLine> lines;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            lines.push_back(lineOf(corners[k], corners[(k + 1) % corners.size()], directions));
        }
        std::vector<Vec2> out;
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const SheetLine& before = lines[(k + lines.size() - 1) % lines.size()];
            const double det = cross2(before.normal, lines[k].normal);
            constexpr double kParallel = 1e-3;
            // A corner between two lines that became one is none.
            if (std::abs(det) < kParallel) continue;
            out.emplace_back(
                (before.offset * lines[k].normal.y() - lines[k].offset * before.normal.y()) / det,
                (before.normal.x() * lines[k].offset - lines[k].normal.x() * before.offset) / det);
        }
        return finished(out);
    }

    /// Directions that lines of the outline may have been meant to have: those of the face's edges
    /// and square to them; where none of its lines has one, those of its longest line.
    std::vector<Vec2> regularDirections(const std::vector<Vec2>& corners) const {
        std::vector<Vec2> out;
        const auto add = [&](const Vec2& d) {
            for (const Vec2& one : {d, Vec2(-d.y(), d.x())}) {
                const bool known = std::any_of(out.begin(), out.end(), [&](const Vec2& o) {
                    return std::abs(cross2(o, one)) < 1e-9;
                });
                if (!known) out.push_back(one);
            }
        };
        for (const auto& loop : sheet_->loops()) {
            for (std::size_t k = 0; k < loop.size(); ++k) {
                add((loop[(k + 1) % loop.size()] - loop[k]).normalized());
            }
        }
        Vec2 longest = Vec2::Zero();
        bool any = false;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec2 d = corners[(k + 1) % corners.size()] - corners[k];
            if (d.norm() > longest.norm()) longest = d;
            any = any || nearest(corners[k], corners[(k + 1) % corners.size()], out).has_value();
        }
        if (!any) add(longest.normalized());
        return out;
    }

    /// The direction that a line was meant to have, within the angle threshold and what missing its
    /// ends does to it.
    std::optional<Vec2> nearest(const Vec2& a, const Vec2& b,
                                const std::vector<Vec2>& directions) const {
        const double px = (sheet_->inPicture(b) - sheet_->inPicture(a)).norm();
        const double excuse = std::atan2(2.0 * kHandPx, std::max(px, 1.0));
        double best = options_.thresholds.angleDeg * std::numbers::pi / 180.0 + excuse;
        std::optional<Vec2> out;
        for (const Vec2& d : directions) {
            const double off = std::asin(std::min(1.0, std::abs(cross2((b - a).normalized(), d))));
            if (off > best) continue;
            best = off;
            out = d;
        }
        return out;
    }

    SheetLine lineOf(const Vec2& a, const Vec2& b, const std::vector<Vec2>& directions) const {
        const auto regular = nearest(a, b, directions);
        Vec2 d = regular.value_or((b - a).normalized());
        if (d.dot(b - a) < 0.0) d = -d;
        SheetLine line;
        line.normal = Vec2(d.y(), -d.x());
        const Vec2 middle = 0.5 * (a + b);
        line.offset = line.normal.dot(middle);
        if (!regular) return line;
        // On an edge of the face that it runs along.
        const double reach = options_.thresholds.distancePx;
        for (const auto& loop : sheet_->loops()) {
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const Vec2& p = loop[k];
                const Vec2& q = loop[(k + 1) % loop.size()];
                if (std::abs(cross2((q - p).normalized(), d)) > 1e-9) continue;
                if (distanceToSegment(sheet_->inPicture(middle), sheet_->inPicture(p),
                                      sheet_->inPicture(q)) > reach) {
                    continue;
                }
                line.offset = line.normal.dot(p);
                return line;
            }
        }
        return line;
    }

    Result<Profile> finished(const std::vector<Vec2>& corners) {
        if (corners.size() < 3 || areaOf(corners) <= 0.0) {
            return fail(Errc::NoRegion, "This outline encloses nothing.", {inside_});
        }
        const auto outer = sheet_->loops().front();
        for (const Vec2& q : corners) {
            if (insidePolygon(outer, q)) continue;
            double off = std::numeric_limits<double>::infinity();
            const Vec2 px = sheet_->inPicture(q);
            for (std::size_t k = 0; k < outer.size(); ++k) {
                off = std::min(off,
                               distanceToSegment(px, sheet_->inPicture(outer[k]),
                                                 sheet_->inPicture(outer[(k + 1) % outer.size()])));
            }
            if (off <= options_.thresholds.distancePx) continue;
            return fail(Errc::OperationImpossible,
                        "This outline leaves the face; an outline to pull lies in one face.", {px});
        }
        for (const Vec2& q : corners) out_.corners.push_back(sheet_->inBody(q));
        return out_;
    }

    const std::vector<Stroke>& strokes_;
    const InterpretOptions& options_;
    Vec2 inside_;
    Profile out_;
    std::optional<Sheet> sheet_;
};

}  // namespace

Result<Profile> readProfile(const std::vector<Stroke>& strokes, const InterpretOptions& options,
                            const Vec2& inside) {
    return ProfileReader(strokes, options, inside).read();
}

}  // namespace ew
