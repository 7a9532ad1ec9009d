// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/pyramid_proposals.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/reading/solve/base_tilt.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The corners of a base that are seen, in order round the apex.
struct Chain {
    int apex = -1;
    std::vector<int> nodes;
    bool closed = false;  ///< the triangles go all round: it is looked at from above
};

class Pyramids {
  public:
    Pyramids(const LineDrawing& drawing, double spreadPx) : drawing_(drawing), spread_(spreadPx) {}

    std::vector<ShapeHypothesis> all() {
        for (std::size_t v = 0; v < drawing_.nodes.size(); ++v) {
            for (const Chain& chain : chainsAt(static_cast<int>(v))) propose(chain);
        }
        return std::move(out_);
    }

  private:
    static constexpr int kMostCorners = 12;

    /// The far end of a region's other line at this node, where the region is a triangle.
    std::optional<std::array<int, 2>> triangleAt(int d) const {
        const int region = drawing_.left[at(d)];
        if (region < 0) return std::nullopt;
        const LineDrawing::Region& r = drawing_.regions[at(region)];
        if (r.corners.size() != 3 || r.partly) return std::nullopt;
        const int apex = drawing_.from[at(d)];
        const auto own = std::find(r.corners.begin(), r.corners.end(), apex);
        if (own == r.corners.end()) return std::nullopt;
        const std::size_t k = static_cast<std::size_t>(own - r.corners.begin());
        return std::array<int, 2>{r.corners[(k + 1) % 3], r.corners[(k + 2) % 3]};
    }

    using Triangles = std::vector<std::optional<std::array<int, 2>>>;

    /// Runs of triangles round a node that share their lines.
    std::vector<Chain> chainsAt(int apex) const {
        const auto& lines = drawing_.nodes[at(apex)].out;
        const std::size_t n = lines.size();
        if (n < 3) return {};
        Triangles triangles;
        for (const int d : lines) triangles.push_back(triangleAt(d));
        const bool closed = std::all_of(triangles.begin(), triangles.end(),
                                        [](const auto& t) { return t.has_value(); });
        std::vector<Chain> out;
        for (std::size_t k = 0; k < n; ++k) {
            if (!triangles[k] || (triangles[(k + n - 1) % n] && !(closed && k == 0))) continue;
            // Which end of a triangle comes first round the apex depends on the sense of its loop.
            for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {
                Chain chain = run(triangles, k, first);
                if (chain.nodes.size() < 3) continue;
                chain.apex = apex;
                chain.closed = closed && chain.nodes.front() == chain.nodes.back();
                if (chain.closed) chain.nodes.pop_back();
                if (!closed || chain.closed) out.push_back(std::move(chain));
                break;
            }
        }
        return out;
    }

    static Chain run(const Triangles& triangles, std::size_t from, std::size_t first) {
        const std::size_t n = triangles.size();
        Chain chain;
        for (std::size_t k = from; k < from + n && triangles[k % n]; ++k) {
            const auto& ends = *triangles[k % n];
            if (chain.nodes.empty()) chain.nodes.push_back(ends[first]);
            if (chain.nodes.back() != ends[first]) break;
            chain.nodes.push_back(ends[1 - first]);
        }
        return chain;
    }

    Vec2 px(int node) const { return drawing_.nodes[at(node)].at; }

    void propose(const Chain& chain) {
        const auto m = static_cast<int>(chain.nodes.size());
        if (m > 3 || chain.closed) {
            // All of the base is seen; where the run is open one face is not.
            std::vector<Vec2> base;
            for (const int v : chain.nodes) base.push_back(px(v));
            build(chain, base, px(chain.apex));
            if (chain.closed) return;
        }
        if (m == 3) {
            // The fourth corner of a parallelogram.
            std::vector<Vec2> base{px(chain.nodes[0]), px(chain.nodes[1]), px(chain.nodes[2])};
            base.push_back(base[0] + base[2] - base[1]);
            build(chain, base, px(chain.apex));
        }
        for (int n = std::max(m + 1, 5); n <= std::min(2 * m, kMostCorners); ++n) {
            if (m < 4) break;
            if (const auto base = regularBase(chain, n)) build(chain, *base, px(chain.apex));
        }
    }

    /// The affine picture of a regular polygon through the corners that are seen.
    std::optional<std::vector<Vec2>> regularBase(const Chain& chain, int n) const {
        const auto m = static_cast<Eigen::Index>(chain.nodes.size());
        Eigen::MatrixXd a(m, 3);
        Eigen::MatrixXd b(m, 2);
        const auto corner = [&](int k) {
            const double t = 2.0 * std::numbers::pi * k / n;
            return Vec3(std::cos(t), std::sin(t), 1.0);
        };
        for (Eigen::Index k = 0; k < m; ++k) {
            a.row(k) = corner(static_cast<int>(k)).transpose();
            b.row(k) = px(chain.nodes[at(static_cast<int>(k))]).transpose();
        }
        const Eigen::MatrixXd map = a.colPivHouseholderQr().solve(b);
        const double rms = std::sqrt((a * map - b).squaredNorm() / static_cast<double>(m));
        if (rms > 2.5 * spread_) return std::nullopt;
        std::vector<Vec2> base;
        for (int k = 0; k < n; ++k) base.emplace_back(map.transpose() * corner(k));
        return base;
    }

    /// \param base  the whole base; its first corners are those of the chain.
    void build(const Chain& chain, const std::vector<Vec2>& base, const Vec2& apex) {
        Vec2 middle = Vec2::Zero();
        for (const Vec2& p : base) middle += p / static_cast<double>(base.size());
        const Vec2 up = apex - middle;
        if (up.norm() < 3.0 * spread_) return;
        const Vec2 along = up.normalized();
        const auto factor = foreshortening(base, along, spread_);
        if (!factor) return;
        const double sine = 1.0 / *factor;
        const double cosine = std::sqrt(1.0 - sine * sine);
        ShapeHypothesis h;
        h.family = "pyramid";
        const int n = static_cast<int>(base.size());
        h.sides = n;
        // The base is not seen, so the apex is nearer to the eye.
        const Vec3 axis(along.x() * cosine, along.y() * cosine, -sine);
        const auto lift = [&](const Vec2& p) {
            const Vec2 d = p - middle;
            return Vec3(p.x(), p.y(), d.dot(along) * cosine / sine);
        };
        for (const Vec2& p : base) h.rough.vertices.push_back(lift(p));
        h.rough.vertices.push_back(Vec3(middle.x(), middle.y(), 0.0) + up.norm() / cosine * axis);
        h.node = chain.nodes;
        h.node.resize(at(n), -1);
        h.node.push_back(chain.apex);
        addFaces(h, axis);
        h.frame = frameAlong(axis, h.rough.vertices[1] - h.rough.vertices[0]);
        out_.push_back(std::move(h));
    }

    void addFaces(ShapeHypothesis& h, const Vec3& axis) const {
        const int n = h.sides;
        std::vector<int> base;
        Vec3 area = Vec3::Zero();
        for (int k = 0; k < n; ++k) {
            base.push_back(k);
            area += h.rough.vertices[at(k)].cross(h.rough.vertices[at((k + 1) % n)]);
        }
        // Counter-clockwise from outside, which is away from the apex.
        if (area.dot(axis) > 0.0) std::reverse(base.begin(), base.end());
        h.rough.faces = {base};
        for (int k = n - 1; k >= 0; --k) {
            const int a = base[at(k)];
            const int b = base[at((k + 1) % n)];
            h.rough.faces.push_back({b, a, n});
            h.ring.push_back(static_cast<int>(h.rough.faces.size()) - 1);
        }
    }

    const LineDrawing& drawing_;
    double spread_;
    std::vector<ShapeHypothesis> out_;
};

}  // namespace

std::vector<ShapeHypothesis> pyramidProposals(const LineDrawing& drawing, double spreadPx) {
    return Pyramids(drawing, spreadPx).all();
}

}  // namespace ew
