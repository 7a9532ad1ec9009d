// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/prism_proposals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/reading/extract/plane_geometry.h"
#include "core/reading/solve/base_tilt.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A line that leaves a corner of the base.
struct Side {
    std::size_t corner = 0;
    Vec2 vector = Vec2::Zero();  ///< from the corner to its end [px]
    int end = -1;                ///< node
    bool whole = true;           ///< false where it ends behind something
};

/// Follows a line straight on through the nodes that others end at.
Side follow(const LineDrawing& drawing, int d) {
    Side side;
    const Vec2 from = drawing.nodes[at(drawing.from[at(d)])].at;
    for (std::size_t steps = 0; steps < drawing.from.size(); ++steps) {
        const auto& out = drawing.nodes[at(drawing.to(d))].out;
        const auto next = std::find_if(out.begin(), out.end(), [&](int o) {
            return o != LineDrawing::twin(d) && drawing.straightThrough(d, o);
        });
        if (next == out.end()) break;
        d = *next;
    }
    side.end = drawing.to(d);
    side.vector = drawing.nodes[at(side.end)].at - from;
    side.whole = drawing.nodes[at(side.end)].stem != LineDrawing::twin(d);
    return side;
}

/// Is a direction outside the corner between two sides of a polygon?
bool leavesPolygon(const std::vector<Vec2>& polygon, std::size_t k, const Vec2& direction) {
    const std::size_t n = polygon.size();
    const Vec2 p = polygon[k] + 0.02 * direction.normalized() *
                                    std::min((polygon[(k + 1) % n] - polygon[k]).norm(),
                                             (polygon[(k + n - 1) % n] - polygon[k]).norm());
    return !insidePolygon(polygon, p);
}

class Bases {
  public:
    Bases(const LineDrawing& drawing, double spreadPx) : drawing_(drawing), spread_(spreadPx) {}

    std::vector<ShapeHypothesis> all() {
        std::vector<ShapeHypothesis> out;
        for (const LineDrawing::Region& region : drawing_.regions) {
            if (region.partly || region.corners.size() < 3) continue;
            if (region.corners.size() > kMostCorners) continue;
            begin(region);
            const std::vector<Side> sides = sidesOf(region);
            for (const auto& far : {straight(sides), tapered(sides)}) {
                if (!far) continue;
                const auto factor = foreshortening(base_, far->axis, spread_);
                if (factor) out.push_back(build(*far, *factor));
            }
        }
        return out;
    }

  private:
    static constexpr std::size_t kMostCorners = 24;
    static constexpr double kParallelDeg = 10.0;

    /// The other base: corner k of the region becomes scale * corner + shift.
    struct FarBase {
        double scale = 1.0;
        Vec2 shift = Vec2::Zero();
        Vec2 axis = Vec2::Zero();  ///< from the middle of the region to that of the other base
        std::vector<Side> sides;   ///< that it is told by
    };

    void begin(const LineDrawing::Region& region) {
        corners_ = region.corners;
        base_.clear();
        middle_ = Vec2::Zero();
        for (const int c : corners_) {
            base_.push_back(drawing_.nodes[at(c)].at);
            middle_ += base_.back() / static_cast<double>(corners_.size());
        }
    }

    /// Of a prism: parallel lines leave the corners.
    std::optional<FarBase> straight(const std::vector<Side>& sides) const {
        FarBase far;
        far.sides = parallelGroup(sides);
        if (far.sides.size() < 2) return std::nullopt;
        far.axis = far.shift = extrusion(far.sides);
        if (far.axis.norm() < 3.0 * spread_) return std::nullopt;
        return far;
    }

    /// Of a frustum: the lines from the corners would meet in one point, and end at the same share
    /// of the way to it. The pair of lines that most others agree with tells it, then all that
    /// agree.
    std::optional<FarBase> tapered(const std::vector<Side>& sides) const {
        std::optional<FarBase> best;
        for (std::size_t a = 0; a < sides.size(); ++a) {
            for (std::size_t b = a + 1; b < sides.size(); ++b) {
                if (sides[a].corner == sides[b].corner || !sides[a].whole || !sides[b].whole) {
                    continue;
                }
                FarBase far = fitFar({sides[a], sides[b]});
                far.sides = agreeing(sides, far);
                if (far.sides.size() < 3) continue;
                if (!best || far.sides.size() > best->sides.size()) best = std::move(far);
            }
        }
        if (!best) return std::nullopt;
        std::vector<Side> group = best->sides;
        best = fitFar(group);
        best->sides = std::move(group);
        const double size = (base_[0] - middle_).norm();
        if (std::abs(best->scale - 1.0) * size < 2.0 * spread_ || best->scale < 0.1) {
            return std::nullopt;
        }
        if (best->axis.norm() < 3.0 * spread_) return std::nullopt;
        return best;
    }

    /// Least squares of scale and shift.
    FarBase fitFar(const std::vector<Side>& sides) const {
        Vec2 from = Vec2::Zero();
        Vec2 to = Vec2::Zero();
        double n = 0.0;
        for (const Side& s : sides) {
            if (!s.whole) continue;
            from += base_[s.corner];
            to += base_[s.corner] + s.vector;
            n += 1.0;
        }
        from /= n;
        to /= n;
        double dot = 0.0;
        double square = 0.0;
        for (const Side& s : sides) {
            if (!s.whole) continue;
            const Vec2 p = base_[s.corner] - from;
            dot += p.dot(base_[s.corner] + s.vector - to);
            square += p.squaredNorm();
        }
        FarBase far;
        far.scale = square > 0.0 ? dot / square : 1.0;
        far.shift = to - far.scale * from;
        far.axis = (far.scale - 1.0) * middle_ + far.shift;
        return far;
    }

    /// One line a corner at most, and only where it ends, or points, where this base has the
    /// corner.
    std::vector<Side> agreeing(const std::vector<Side>& sides, const FarBase& far) const {
        std::vector<Side> out;
        for (const Side& s : sides) {
            const Vec2 end = far.scale * base_[s.corner] + far.shift;
            const Vec2 drawn = base_[s.corner] + s.vector;
            const double off =
                s.whole ? (drawn - end).norm() : distanceToSegment(drawn, base_[s.corner], end);
            if (off > 4.0 * spread_) continue;
            const bool known = std::any_of(out.begin(), out.end(),
                                           [&](const Side& o) { return o.corner == s.corner; });
            if (!known) out.push_back(s);
        }
        return out;
    }

    std::vector<Side> sidesOf(const LineDrawing::Region& region) const {
        std::vector<Side> out;
        for (std::size_t k = 0; k < corners_.size(); ++k) {
            for (const int d : drawing_.nodes[at(corners_[k])].out) {
                const bool own = std::any_of(region.loop.begin(), region.loop.end(), [&](int l) {
                    return l == d || l == LineDrawing::twin(d);
                });
                if (own || !leavesPolygon(base_, k, drawing_.vector(d))) continue;
                Side side = follow(drawing_, d);
                side.corner = k;
                out.push_back(side);
            }
        }
        return out;
    }

    /// The largest set of sides that are parallel within what hands miss; of equally large ones the
    /// one with most ink.
    std::vector<Side> parallelGroup(const std::vector<Side>& sides) const {
        std::vector<Side> best;
        double bestPx = 0.0;
        for (const Side& seed : sides) {
            std::vector<Side> group;
            double px = 0.0;
            for (const Side& s : sides) {
                const double excuse =
                    std::atan2(2.0 * spread_, s.vector.norm()) * 180.0 / std::numbers::pi;
                if (angleBetweenDeg(seed.vector, s.vector) > kParallelDeg + 0.5 * excuse) continue;
                group.push_back(s);
                px += s.vector.norm();
            }
            if (group.size() < best.size()) continue;
            if (group.size() == best.size() && px <= bestPx) continue;
            best = std::move(group);
            bestPx = px;
        }
        return best;
    }

    /// Mean of the whole sides; where all end behind something, the direction of all and the
    /// longest length.
    static Vec2 extrusion(const std::vector<Side>& group) {
        Vec2 sum = Vec2::Zero();
        Vec2 all = Vec2::Zero();
        int whole = 0;
        double longest = 0.0;
        for (const Side& s : group) {
            all += s.vector;
            longest = std::max(longest, s.vector.norm());
            if (!s.whole) continue;
            sum += s.vector;
            ++whole;
        }
        if (whole > 0) return sum / whole;
        return longest * all.normalized();
    }

    ShapeHypothesis build(const FarBase& far, double factor) const {
        ShapeHypothesis h;
        h.family = far.scale == 1.0 ? "prism" : "frustum";
        const int n = static_cast<int>(base_.size());
        h.sides = n;
        const double sine = 1.0 / factor;
        const double cosine = std::sqrt(1.0 - sine * sine);
        const Vec2 along = far.axis.normalized();
        const Vec3 axis(along.x() * cosine, along.y() * cosine, sine);  // away from the eye
        // From the middle of the region, in its plane.
        const auto lift = [&](const Vec2& p) {
            const Vec2 d = p - middle_;
            return Vec3(d.x(), d.y(), -d.dot(along) * cosine / sine);
        };
        const Vec3 origin(middle_.x(), middle_.y(), 0.0);
        const double length = far.axis.norm() / cosine;
        for (const Vec2& p : base_) h.rough.vertices.push_back(origin + lift(p));
        for (const Vec2& p : base_) {
            h.rough.vertices.push_back(origin + length * axis + far.scale * lift(p));
        }
        h.node = corners_;
        h.node.resize(at(2 * n), -1);
        for (const Side& s : far.sides) {
            if (s.whole) {
                h.node[at(n) + s.corner] = s.end;
                continue;
            }
            const int k = static_cast<int>(s.corner);
            h.stretches.push_back({{k, k + n}, drawing_.nodes[at(s.end)].at, spread_});
        }
        takeNearNodes(h, far);
        addFaces(h, n);
        frame(h, axis);
        return h;
    }

    /// Corners of the far base that are seen although the line to them is not.
    void takeNearNodes(ShapeHypothesis& h, const FarBase& far) const {
        const std::size_t n = base_.size();
        for (std::size_t k = 0; k < n; ++k) {
            if (h.node[n + k] >= 0) continue;
            const Vec2 p = far.scale * base_[k] + far.shift;
            double least = 4.0 * spread_;
            for (std::size_t v = 0; v < drawing_.nodes.size(); ++v) {
                const double off = (drawing_.nodes[v].at - p).norm();
                const bool taken =
                    std::find(h.node.begin(), h.node.end(), static_cast<int>(v)) != h.node.end();
                if (off >= least || taken || drawing_.nodes[v].stem >= 0) continue;
                least = off;
                h.node[n + k] = static_cast<int>(v);
            }
        }
    }

    void addFaces(ShapeHypothesis& h, int n) const {
        double area = 0.0;
        for (std::size_t k = 0; k < base_.size(); ++k) {
            area += cross2(base_[k], base_[(k + 1) % base_.size()]);
        }
        // y is down and z away from the eye: a face that looks at the eye has negative area.
        const bool forwards = area < 0.0;
        std::vector<int> near, far;
        for (int k = 0; k < n; ++k) {
            near.push_back(forwards ? k : n - 1 - k);
            far.push_back(forwards ? 2 * n - 1 - k : n + k);
        }
        h.rough.faces = {near, far};
        for (int i = 0; i < n; ++i) {
            const int a = near[at(i)];
            const int b = near[at((i + 1) % n)];
            h.rough.faces.push_back({b, a, a + n, b + n});
            h.ring.push_back(static_cast<int>(h.rough.faces.size()) - 1);
        }
    }

    /// Third axis towards the eye along the prism, the first along the edge of the base that most
    /// others are parallel or perpendicular to.
    void frame(ShapeHypothesis& h, const Vec3& axis) const {
        const std::size_t n = base_.size();
        Vec3 best = Vec3::Zero();
        double most = -1.0;
        for (std::size_t k = 0; k < n; ++k) {
            const Vec3 u = (h.rough.vertices[(k + 1) % n] - h.rough.vertices[k]).normalized();
            double score = 0.0;
            for (std::size_t j = 0; j < n; ++j) {
                const Vec3 w = h.rough.vertices[(j + 1) % n] - h.rough.vertices[j];
                const double c = std::abs(u.dot(w.normalized()));
                const double off =
                    std::min(std::acos(std::min(c, 1.0)), std::asin(std::min(c, 1.0)));
                score += w.norm() * std::exp(-0.5 * off * off / (0.08 * 0.08));
            }
            if (score <= most) continue;
            most = score;
            best = u;
        }
        h.frame = frameAlong(-axis, best);
    }

    const LineDrawing& drawing_;
    double spread_;
    std::vector<int> corners_;
    std::vector<Vec2> base_;
    Vec2 middle_ = Vec2::Zero();  ///< of the region's corners
};

}  // namespace

std::vector<ShapeHypothesis> prismProposals(const LineDrawing& drawing, double spreadPx) {
    return Bases(drawing, spreadPx).all();
}

}  // namespace ew
