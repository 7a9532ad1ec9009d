// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/template_drawing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/reading/solve/body_frame.h"
#include "core/reading/solve/general_fit.h"
#include "core/solid/solid.h"
#include "core/solid/visibility.h"

namespace ew {
namespace {

constexpr int kMostShapes = 30;
constexpr int kMostViews = 40;  // of a shape
constexpr double kShortestEdgePx = 18.0;
constexpr double kNearestCornersPx = 18.0;
constexpr double kNearestLinePx = 12.0;
constexpr double kSharpestDeg = 9.0;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Where along an axis the planes of a rectilinear shape lie: in the same order, their distances
/// 0.4 to 1.6 times what they are.
std::vector<double> randomPlanes(const std::vector<double>& reference, Random& random) {
    std::vector<std::size_t> order(reference.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return reference[a] < reference[b]; });
    std::vector<double> out(reference.size(), 0.0);
    for (std::size_t k = 1; k < order.size(); ++k) {
        const double gap = reference[order[k]] - reference[order[k - 1]];
        out[order[k]] = out[order[k - 1]] + gap * random.uniform(0.4, 1.6);
    }
    return out;
}

PolyhedronSpec rectilinearShape(const LibraryEntry& entry, Random& random) {
    const RectilinearStructure& r = *entry.analysis.rectilinear;
    PolyhedronSpec spec = entry.tmpl.shape;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<double> planes = randomPlanes(r.reference[axis], random);
        for (std::size_t v = 0; v < spec.vertices.size(); ++v) {
            spec.vertices[v][static_cast<int>(axis)] = planes[at(r.planes[axis][v])];
        }
    }
    // The axes may stand left-handed, which turns the shape inside out.
    if (signedVolume(spec) < 0.0) {
        for (Vec3& v : spec.vertices) v.x() = -v.x();
    }
    return spec;
}

/// Stretched along the axes of its file, as far as what must hold goes on holding.
PolyhedronSpec stretchedShape(const LibraryEntry& entry, Random& random) {
    const SolverRelations relations = solverRelations(entry.analysis);
    const PolyhedronSpec& shape = entry.tmpl.shape;
    const double before = violation(relations, entry.analysis, shape.vertices);
    constexpr double kHolds = 1e-9;
    // All three freely, then one at a time: a right prism may grow along its height.
    for (int attempt = 0; attempt < 8; ++attempt) {
        Vec3 scale(1, 1, 1);
        for (int axis = 0; axis < 3; ++axis) {
            if (attempt >= 2 && axis != attempt % 3) continue;
            scale[axis] = random.uniform(0.6, 1.5);
        }
        PolyhedronSpec spec = shape;
        for (Vec3& v : spec.vertices) v = v.cwiseProduct(scale);
        if (violation(relations, entry.analysis, spec.vertices) <= before + kHolds) return spec;
    }
    return shape;
}

/// Some way up: any face may be the one that it stands on, or lies on.
Mat3 randomAttitude(Random& random) {
    const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
    Mat3 stand = Mat3::Identity();
    const int side = random.index(3);
    if (side == 1) stand = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitX()).matrix();
    if (side == 2) stand = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitY()).matrix();
    return Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix() * stand;
}

OrthographicCamera randomCamera(const PolyhedronSpec& spec, Random& random) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    OrthographicCamera camera;
    const double tilt = random.uniform(15.0, 65.0) * kDegree;
    camera.direction = Vec3(-std::cos(tilt), 0.0, -std::sin(tilt)).normalized();
    camera.up = Vec3::UnitZ();
    camera.center = Vec3::Zero();
    camera.worldPerPixel = 1.0;
    Eigen::AlignedBox2d box;
    for (const Vec3& v : spec.vertices) box.extend(camera.project(v));
    camera.worldPerPixel = box.diagonal().norm() / random.uniform(150.0, 500.0);
    return camera;
}

/// The visible stretches of the edges; pieces of one edge that follow each other are one.
std::vector<Line2> visibleLines(const SolidView& view) {
    std::map<int, std::vector<VisiblePiece>> byEdge;
    for (const VisiblePiece& p : view.visiblePieces()) {
        if (!p.point) byEdge[p.edge].push_back(p);
    }
    std::vector<Line2> lines;
    for (auto& [edge, pieces] : byEdge) {
        std::sort(pieces.begin(), pieces.end(),
                  [](const VisiblePiece& a, const VisiblePiece& b) { return a.t0 < b.t0; });
        double end = -1.0;
        for (const VisiblePiece& p : pieces) {
            if (end >= 0.0 && p.t0 - end < 1e-9) {
                lines.back()[1] = p.px[1];
            } else {
                lines.push_back({p.px[0], p.px[1]});
            }
            end = p.t1;
        }
    }
    return lines;
}

/// Ends of lines that are one place to rounding.
void unite(std::vector<Line2>& lines) {
    constexpr double kSamePx = 1e-6;
    std::vector<Vec2> known;
    for (Line2& l : lines) {
        for (Vec2& end : l) {
            const auto same = std::find_if(known.begin(), known.end(), [&](const Vec2& k) {
                return (k - end).norm() < kSamePx;
            });
            if (same != known.end()) {
                end = *same;
            } else {
                known.push_back(end);
            }
        }
    }
}

/// The direction away from an end that two lines share; nothing where they share none.
std::optional<std::array<Vec2, 2>> fromCommonEnd(const Line2& a, const Line2& b) {
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            if (a[i] == b[k]) return std::array<Vec2, 2>{a[1 - i] - a[i], b[1 - k] - b[k]};
        }
    }
    return std::nullopt;
}

/// Could a person tell corners and lines of this drawing apart?
bool isReadable(const std::vector<Line2>& lines) {
    if (lines.size() < 5) return false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if ((lines[i][1] - lines[i][0]).norm() < kShortestEdgePx) return false;
        for (std::size_t k = 0; k < lines.size(); ++k) {
            if (k == i) continue;
            if (const auto away = fromCommonEnd(lines[i], lines[k])) {
                const double angle =
                    std::atan2(cross2((*away)[0], (*away)[1]), (*away)[0].dot((*away)[1]));
                if (std::abs(angle) * 180.0 / std::numbers::pi < kSharpestDeg) return false;
            }
            for (const Vec2& end : lines[k]) {
                const bool own = end == lines[i][0] || end == lines[i][1];
                if (own) continue;
                const double off = distanceToSegment(end, lines[i][0], lines[i][1]);
                const double corner =
                    std::min((end - lines[i][0]).norm(), (end - lines[i][1]).norm());
                if (corner < kNearestCornersPx) return false;
                // A line that runs behind ends on what hides it.
                if (off > 1e-6 && off < kNearestLinePx) return false;
            }
        }
    }
    return true;
}

int facesSeen(const SolidView& view, std::size_t count) {
    int seen = 0;
    for (std::size_t f = 0; f < count; ++f) {
        seen += view.facing(static_cast<int>(f)) == Facing::Front ? 1 : 0;
    }
    return seen;
}

}  // namespace

std::optional<TemplateDrawing> randomDrawing(const LibraryEntry& entry, Random& random) {
    for (int shape = 0; shape < kMostShapes; ++shape) {
        const PolyhedronSpec base = entry.analysis.rectilinear ? rectilinearShape(entry, random)
                                                               : stretchedShape(entry, random);
        for (int view = 0; view < kMostViews; ++view) {
            PolyhedronSpec spec = base;
            const Mat3 attitude = randomAttitude(random);
            Vec3 middle = Vec3::Zero();
            for (Vec3& v : spec.vertices) middle += v = attitude * v;
            middle /= static_cast<double>(spec.vertices.size());
            for (Vec3& v : spec.vertices) v -= middle;
            const auto solid = Solid::fromSpec(spec);
            if (!solid) break;
            const OrthographicCamera camera = randomCamera(spec, random);
            const auto seen = SolidView::make(*solid, Pose{}, camera);
            if (!seen || facesSeen(*seen, solid->faces().size()) < 2) continue;
            std::vector<Line2> lines = visibleLines(*seen);
            unite(lines);
            if (!isReadable(lines)) continue;
            return TemplateDrawing{std::move(spec), camera, std::move(lines)};
        }
    }
    return std::nullopt;
}

}  // namespace ew
