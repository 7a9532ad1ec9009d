// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/anchor_start.h"

#include <Eigen/Dense>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Normal equations of weighted linear rows over all coordinates.
class LeastSquares {
  public:
    explicit LeastSquares(std::size_t vertices)
        : n_(static_cast<Eigen::Index>(3 * vertices)),
          a_(1e-9 * Eigen::MatrixXd::Identity(n_, n_)),
          b_(Eigen::VectorXd::Zero(n_)) {}

    struct Term {
        int vertex;
        Vec3 gradient;
    };
    void row(const std::vector<Term>& terms, double value, double weight) {
        for (const Term& s : terms) {
            b_.segment<3>(3 * s.vertex) += weight * weight * value * s.gradient;
            for (const Term& t : terms) {
                a_.block<3, 3>(3 * s.vertex, 3 * t.vertex) +=
                    weight * weight * s.gradient * t.gradient.transpose();
            }
        }
    }
    CameraPoints solve() const {
        const Eigen::VectorXd x = a_.ldlt().solve(b_);
        CameraPoints points;
        for (Eigen::Index i = 0; i < n_; i += 3) points.emplace_back(x.segment<3>(i));
        return points;
    }

  private:
    Eigen::Index n_;
    Eigen::MatrixXd a_;
    Eigen::VectorXd b_;
};

}  // namespace

CameraPoints anchoredStart(const Template& tmpl, const TemplateAnalysis& analysis,
                           const Sighting& sighting, const Anchors& anchors) {
    constexpr double kExact = 1e3;
    constexpr double kDirection = 30.0;
    constexpr double kAlike = 3.0;
    constexpr double kShape = 0.03;
    LeastSquares ls(tmpl.shape.vertices.size());
    for (std::size_t v = 0; v < tmpl.shape.vertices.size(); ++v) {
        if (!sighting.seen[v]) continue;
        const int i = static_cast<int>(v);
        ls.row({{i, Vec3::UnitX()}}, sighting.vertexPx[v].x(), 1.0);
        ls.row({{i, Vec3::UnitY()}}, sighting.vertexPx[v].y(), 1.0);
    }
    for (const Anchors::Plane& a : anchors.planes) ls.row({{a.vertex, a.normal}}, a.offset, kExact);
    for (const Anchors::Line& a : anchors.lines) {
        const Vec3 n = a.direction.unitOrthogonal();
        const Vec3 m = a.direction.cross(n);
        ls.row({{a.vertex, n}}, n.dot(a.point), kExact);
        ls.row({{a.vertex, m}}, m.dot(a.point), kExact);
    }
    for (const Anchors::Point& a : anchors.points) {
        for (int k = 0; k < 3; ++k) ls.row({{a.vertex, Vec3::Unit(k)}}, a.point(k), kExact);
    }
    for (const Anchors::Direction& a : anchors.directions) {
        const auto& ends = analysis.edges[at(a.edge)].ends;
        const Vec3 n = a.direction.unitOrthogonal();
        const Vec3 m = a.direction.cross(n);
        for (const Vec3& k : {n, m}) ls.row({{ends[1], k}, {ends[0], -k}}, 0.0, kDirection);
    }
    for (const auto& loop : tmpl.shape.faces) {
        if (loop.size() != 4) continue;
        const auto parallel = [&](std::size_t i) {
            const int e = analysis.edgeBetween(loop[i], loop[i + 1]);
            const int f = analysis.edgeBetween(loop[i + 2], loop[(i + 3) % 4]);
            return analysis.edges[at(e)].directionClass == analysis.edges[at(f)].directionClass;
        };
        const double weight = parallel(0) && parallel(1) ? kAlike : kShape;
        for (int k = 0; k < 3; ++k) {
            const Vec3 u = Vec3::Unit(k);
            ls.row({{loop[0], u}, {loop[1], -u}, {loop[2], u}, {loop[3], -u}}, 0.0, weight);
        }
    }
    // What is left keeps near the rest of the body.
    for (const AnalysedEdge& e : analysis.edges) {
        ls.row({{e.ends[0], Vec3::UnitZ()}, {e.ends[1], -Vec3::UnitZ()}}, 0.0, 1e-3);
    }
    return ls.solve();
}

}  // namespace ew
