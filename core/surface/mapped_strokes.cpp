// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/mapped_strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "core/base/tolerance.h"
#include "core/surface/box_tree.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A point on a triangle seen in the picture.
struct Hit {
    int triangle = -1;
    Vec2 px = Vec2::Zero();
    double pressure = 1.0;
};

}  // namespace

struct StrokeCanvas::Impl {
    std::vector<Vec3> positions;
    std::vector<std::array<int, 3>> triangles;
    std::vector<Vec3> screen;                    ///< px, px, depth in px
    std::vector<std::array<int, 3>> neighbours;  ///< by triangle and side, -1 where there is none
    std::vector<bool> front;                     ///< looks towards the eye
    std::vector<int> fronts;                     ///< triangles, by item of the tree
    BoxTree tree;

    const Vec3& corner(int triangle, std::size_t k) const {
        return screen[at(triangles[at(triangle)][k % 3])];
    }

    /// Twice the signed area left of side k, positive inside a triangle that looks towards the eye.
    /// Both triangles of an edge get numbers that differ in sign only.
    double side(int triangle, std::size_t k, const Vec2& p) const {
        int a = triangles[at(triangle)][k];
        int b = triangles[at(triangle)][(k + 1) % 3];
        const double sign = a < b ? -1.0 : 1.0;  // y is down
        if (a > b) std::swap(a, b);
        const Vec2 pa = screen[at(a)].head<2>() - p;
        const Vec2 pb = screen[at(b)].head<2>() - p;
        return sign * cross2(pa, pb);
    }

    bool covers(int triangle, const Vec2& p) const {
        return side(triangle, 0, p) >= 0.0 && side(triangle, 1, p) >= 0.0 &&
               side(triangle, 2, p) >= 0.0;
    }

    Vec3 barycentric(int triangle, const Vec2& p) const {
        Vec3 w(side(triangle, 1, p), side(triangle, 2, p), side(triangle, 0, p));
        w = w.cwiseMax(0.0);
        const double sum = w.sum();
        return sum > 0.0 ? Vec3(w / sum) : Vec3(Vec3::Constant(1.0 / 3.0));
    }

    double depth(int triangle, const Vec2& p) const {
        const Vec3 w = barycentric(triangle, p);
        return w[0] * corner(triangle, 0).z() + w[1] * corner(triangle, 1).z() +
               w[2] * corner(triangle, 2).z();
    }

    /// The triangle seen at a pixel, -1 where there is none.
    int seen(const Vec2& p) const {
        int best = -1;
        double nearest = std::numeric_limits<double>::infinity();
        constexpr double kFar = std::numeric_limits<double>::max();
        const Box3 line(Vec3(p.x(), p.y(), -kFar), Vec3(p.x(), p.y(), kFar));
        tree.overlapping(line, [&](int item) {
            const int t = fronts[at(item)];
            if (!covers(t, p)) return;
            const double d = depth(t, p);
            if (d < nearest || (d == nearest && t < best)) {
                nearest = d;
                best = t;
            }
        });
        return best;
    }

    void linkNeighbours();
    MappedPoint point(const Hit& hit, const Vec3& towardsEye) const;
    Vec3 towardsEye = Vec3::Zero();
};

void StrokeCanvas::Impl::linkNeighbours() {
    struct Side {
        int low;
        int high;
        int triangle;
        int k;
    };
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = triangles[t][k];
            const int b = triangles[t][(k + 1) % 3];
            sides.push_back(
                {std::min(a, b), std::max(a, b), static_cast<int>(t), static_cast<int>(k)});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::pair(a.low, a.high) < std::pair(b.low, b.high);
    });
    neighbours.assign(triangles.size(), {-1, -1, -1});
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const Side& a = sides[i];
        const Side& b = sides[i + 1];
        if (a.low != b.low || a.high != b.high) continue;
        neighbours[at(a.triangle)][at(a.k)] = b.triangle;
        neighbours[at(b.triangle)][at(b.k)] = a.triangle;
    }
}

MappedPoint StrokeCanvas::Impl::point(const Hit& hit, const Vec3& eye) const {
    MappedPoint out;
    out.triangle = hit.triangle;
    out.barycentric = barycentric(hit.triangle, hit.px);
    out.pressure = hit.pressure;
    const auto& t = triangles[at(hit.triangle)];
    for (std::size_t k = 0; k < 3; ++k) {
        out.position += out.barycentric[static_cast<Eigen::Index>(k)] * positions[at(t[k])];
    }
    out.normal = (positions[at(t[1])] - positions[at(t[0])])
                     .cross(positions[at(t[2])] - positions[at(t[0])])
                     .normalized();
    if (out.normal.dot(eye) < 0.0) out.normal = -out.normal;
    return out;
}

namespace {

/// Follows one stroke.
class Follower {
  public:
    Follower(const StrokeCanvas::Impl& canvas, int stroke, std::vector<MappedCurve>& out)
        : canvas_(canvas), stroke_(stroke), out_(out) {}

    void follow(const Stroke& stroke) {
        here_ = look(stroke.samples[0].position, stroke.samples[0].pressure);
        if (here_) begin();
        for (std::size_t i = 1; i < stroke.samples.size(); ++i) {
            const PenSample& a = stroke.samples[i - 1];
            const PenSample& b = stroke.samples[i];
            const double length = (b.position - a.position).norm();
            if (length <= tol::kSamePointPx) continue;
            const int steps = static_cast<int>(std::ceil(length / kStepPx));
            for (int k = 1; k <= steps; ++k) {
                const double t = static_cast<double>(k) / steps;
                advance(
                    a.position + (static_cast<double>(k - 1) / steps) * (b.position - a.position),
                    a.position + t * (b.position - a.position),
                    (1.0 - t) * a.pressure + t * b.pressure);
            }
            keep_ = true;  // the pen's own samples stay
        }
        end();
    }

  private:
    static constexpr double kStepPx = 1.0;        ///< what is in front is asked this often
    static constexpr double kGapPx = 1.0 / 64.0;  ///< silhouettes are found to this
    static constexpr double kStepDepthPx = 0.25;  ///< deeper steps are silhouettes
    static constexpr int kMostCrossings = 100'000;

    std::optional<Hit> look(const Vec2& px, double pressure) const {
        const int t = canvas_.seen(px);
        if (t < 0) return std::nullopt;
        return Hit{t, px, pressure};
    }

    void begin() {
        curve_.stroke = stroke_;
        curve_.points = {canvas_.point(*here_, canvas_.towardsEye)};
        keep_ = true;
    }

    void end() {
        const bool dot = curve_.points.size() == 1 && here_ && !moved_;
        if (curve_.points.size() > 1 || dot) out_.push_back(std::move(curve_));
        curve_ = {};
    }

    void add(const Hit& hit) {
        // Of the points inside one triangle, those that the pen made and the last one are enough.
        auto& points = curve_.points;
        if (!keep_ && points.size() > 1 && points.back().triangle == hit.triangle &&
            points[points.size() - 2].triangle == hit.triangle) {
            points.pop_back();
        }
        points.push_back(canvas_.point(hit, canvas_.towardsEye));
        keep_ = false;
    }

    /// From where the stroke is to `to`, halving the way where something changes between.
    void advance(const Vec2& from, const Vec2& to, double pressure) {
        moved_ = true;
        const auto there = look(to, pressure);
        if (!here_ && !there) return;
        if (here_ && there && walk(from, *there)) {
            here_ = there;
            return;
        }
        if ((to - from).norm() > kGapPx) {
            const Vec2 middle = 0.5 * (from + to);
            const double before = here_ ? here_->pressure : pressure;
            advance(from, middle, 0.5 * (before + pressure));
            advance(middle, to, pressure);
            return;
        }
        if (here_ && there && touching(*here_, *there)) {
            add(*there);
            here_ = there;
            return;
        }
        end();
        here_ = there;
        if (here_) begin();
    }

    /// Two hits side by side on triangles that meet there: the way went through a corner.
    bool touching(const Hit& a, const Hit& b) const {
        const double step = canvas_.depth(a.triangle, a.px) - canvas_.depth(b.triangle, b.px);
        if (std::abs(step) > kStepDepthPx) return false;
        const auto& s = canvas_.triangles[at(a.triangle)];
        const auto& t = canvas_.triangles[at(b.triangle)];
        return std::any_of(s.begin(), s.end(),
                           [&](int v) { return std::find(t.begin(), t.end(), v) != t.end(); });
    }

    /// Crosses from triangle to triangle along the straight way to the hit; adds nothing and says
    /// false where the way does not lead there.
    bool walk(const Vec2& from, const Hit& to) {
        crossings_.clear();
        int triangle = here_->triangle;
        int cameFrom = -1;
        double reached = 0.0;
        const double before = here_->pressure;
        for (int n = 0; n < kMostCrossings; ++n) {
            if (triangle == to.triangle) {
                for (const Hit& hit : crossings_) add(hit);
                add(to);
                return true;
            }
            double leave = 2.0;
            int next = -1;
            for (std::size_t k = 0; k < 3; ++k) {
                const int neighbour = canvas_.neighbours[at(triangle)][k];
                if (neighbour >= 0 && neighbour == cameFrom) continue;
                const double here = canvas_.side(triangle, k, from);
                const double there = canvas_.side(triangle, k, to.px);
                if (there >= here || there > 0.0) continue;
                const double t = std::max(reached, here / (here - there));
                if (t >= leave) continue;
                leave = t;
                next = neighbour;
            }
            if (next < 0 || leave > 1.0 || !canvas_.front[at(next)]) return false;
            crossings_.push_back(
                {triangle, from + leave * (to.px - from), before + leave * (to.pressure - before)});
            cameFrom = triangle;
            triangle = next;
            reached = leave;
        }
        return false;
    }

    const StrokeCanvas::Impl& canvas_;
    int stroke_;
    std::vector<MappedCurve>& out_;
    MappedCurve curve_;
    std::optional<Hit> here_;
    std::vector<Hit> crossings_;
    bool keep_ = true;
    bool moved_ = false;
};

}  // namespace

Result<StrokeCanvas> StrokeCanvas::create(std::span<const Vec3> positions,
                                          std::span<const std::array<int, 3>> triangles,
                                          const OrthographicCamera& camera) {
    if (auto ok = camera.validate(); !ok) return fail(ok.error());
    auto impl = std::make_shared<Impl>();
    impl->positions.assign(positions.begin(), positions.end());
    impl->triangles.assign(triangles.begin(), triangles.end());
    impl->towardsEye = -camera.direction;
    impl->screen.reserve(positions.size());
    for (const Vec3& p : positions) {
        if (!p.allFinite()) return fail(Errc::BadValue, "A point of the surface is not a number.");
        const Vec2 px = camera.project(p);
        impl->screen.emplace_back(px.x(), px.y(), camera.depthPx(p));
    }
    const auto count = static_cast<int>(positions.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (const int i : triangles[t]) {
            if (i >= 0 && i < count) continue;
            return fail(Errc::BadValue, "Triangle " + std::to_string(t) + " has no such corner.");
        }
    }
    impl->linkNeighbours();
    impl->front.resize(triangles.size());
    std::vector<Box3> boxes;
    for (int t = 0; at(t) < triangles.size(); ++t) {
        const Vec2 first = impl->corner(t, 0).head<2>();
        impl->front[at(t)] = impl->side(t, 1, first) > 0.0;
        if (!impl->front[at(t)]) continue;
        Box3 box(impl->corner(t, 0));
        box.extend(impl->corner(t, 1));
        box.extend(impl->corner(t, 2));
        boxes.push_back(box);
        impl->fronts.push_back(t);
    }
    impl->tree = BoxTree(std::move(boxes));
    return StrokeCanvas(std::move(impl));
}

Result<MappedStrokes> StrokeCanvas::map(const std::vector<Stroke>& strokes) const {
    if (strokes.empty()) return fail(Errc::EmptySketch, "There are no strokes to map.");
    for (const Stroke& stroke : strokes) {
        if (auto ok = validateStroke(stroke); !ok) return fail(ok.error());
    }
    MappedStrokes out;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const std::size_t before = out.curves.size();
        Follower(*impl_, static_cast<int>(i), out.curves).follow(strokes[i]);
        if (out.curves.size() == before) out.missed.push_back(static_cast<int>(i));
    }
    if (out.curves.empty()) {
        std::vector<Vec2> where;
        for (const Stroke& stroke : strokes) where.push_back(stroke.samples[0].position);
        return fail(Errc::NoSurface, "There is no surface under the strokes.", std::move(where));
    }
    return out;
}

}  // namespace ew
