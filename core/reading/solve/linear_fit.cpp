// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/linear_fit.h"

#include <Eigen/Dense>
#include <cmath>
#include <numeric>

#include "core/base/tolerance.h"
#include "core/reading/solve/solver_rows.h"

namespace ew {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Edges of a face with four corners whose opposite sides are parallel by the template's relations.
std::optional<std::array<int, 4>> parallelogram(const TemplateAnalysis& analysis,
                                                const std::vector<int>& loop) {
    if (loop.size() != 4) return std::nullopt;
    std::array<int, 4> e{};
    for (std::size_t i = 0; i < 4; ++i) e[i] = analysis.edgeBetween(loop[i], loop[(i + 1) % 4]);
    const auto of = [&](std::size_t i) { return analysis.edges[at(e[i])].directionClass; };
    if (of(0) != of(2) || of(1) != of(3)) return std::nullopt;
    return e;
}

/// The edges in sets that are one vector.
std::vector<int> sameVector(const Template& tmpl, const TemplateAnalysis& analysis) {
    std::vector<int> set(analysis.edges.size());
    std::iota(set.begin(), set.end(), 0);
    const auto find = [&](int e) {
        while (set[at(e)] != e) e = set[at(e)] = set[at(set[at(e)])];
        return e;
    };
    for (const auto& loop : tmpl.shape.faces) {
        if (const auto e = parallelogram(analysis, loop)) {
            set[at(find((*e)[0]))] = find((*e)[2]);
            set[at(find((*e)[1]))] = find((*e)[3]);
        }
    }
    for (std::size_t e = 0; e < set.size(); ++e) set[e] = find(static_cast<int>(e));
    return set;
}

class LinearFit {
  public:
    LinearFit(const Template& tmpl, const TemplateAnalysis& analysis, const Sighting& sighting,
              const Anchors& anchors, const KnownDirections& known)
        : tmpl_(tmpl),
          analysis_(analysis),
          s_(sighting),
          anchors_(anchors),
          known_(known),
          columns_(static_cast<Index>(3 * tmpl.shape.vertices.size())) {
        Eigen::AlignedBox2d box;
        for (const DrawnEdge& d : s_.edges) {
            box.extend(d.tips[0]);
            box.extend(d.tips[1]);
        }
        center_ = Vec3(box.center().x(), box.center().y(), anchors.depth());
    }

    std::optional<GeneralSolution> run() {
        if (!constrain()) return std::nullopt;
        GeneralSolution out;
        out.parameters = static_cast<int>(free_.cols());
        // Where an edge goes on behind another its line is known only as well as its direction.
        const int rounds = bendable() ? 3 : 1;
        for (int i = 0; i < rounds; ++i) out.freedoms = fit(i);
        out.cost = inkRows(1).values().squaredNorm();
        for (Index v = 0; v < columns_; v += 3) {
            out.points.emplace_back(x_.segment<3>(v) * s_.sizePx + center_);
        }
        return out;
    }

  private:
    const std::optional<Vec3>& directionOf(int edge) const {
        return known_[at(analysis_.edges[at(edge)].directionClass)];
    }
    void addEdge(Rows& rows, int e, const Vec3& gradient) const {
        rows.add(analysis_.edges[at(e)].ends[0], -gradient);
        rows.add(analysis_.edges[at(e)].ends[1], gradient);
    }
    void plane(Rows& rows, int v, const Vec3& n, double offset) const {
        rows.begin((offset - n.dot(center_)) / s_.sizePx);
        rows.add(v, n);
    }

    /// Row times x is to be its value.
    Rows constraints() const {
        Rows rows(columns_);
        for (std::size_t e = 0; e < analysis_.edges.size(); ++e) {
            const int ei = static_cast<int>(e);
            if (const auto& d = directionOf(ei)) {
                const Vec3 n = d->unitOrthogonal();
                for (const Vec3& k : {n, Vec3(d->cross(n))}) {
                    rows.begin(0.0);
                    addEdge(rows, ei, k);
                }
            }
        }
        for (const auto& loop : tmpl_.shape.faces) {
            const auto e = parallelogram(analysis_, loop);
            if (!e || (directionOf((*e)[0]) && directionOf((*e)[1]))) continue;
            for (int k = 0; k < 3; ++k) {
                rows.begin(0.0);
                for (std::size_t i = 0; i < 4; ++i) {
                    rows.add(loop[i], (i % 2 == 0 ? 1.0 : -1.0) * Vec3::Unit(k));
                }
            }
        }
        for (const auto& pair : analysis_.perpendicularClasses) {
            for (std::size_t s = 0; s < 2; ++s) {
                const auto& given = known_[at(pair[s])];
                if (!given || known_[at(pair[1 - s])]) continue;
                for (std::size_t e = 0; e < analysis_.edges.size(); ++e) {
                    if (analysis_.edges[e].directionClass != pair[1 - s]) continue;
                    rows.begin(0.0);
                    addEdge(rows, static_cast<int>(e), *given);
                }
            }
        }
        anchorRows(rows);
        rows.normalise();
        return rows;
    }

    void anchorRows(Rows& rows) const {
        for (const Anchors::Plane& a : anchors_.planes) plane(rows, a.vertex, a.normal, a.offset);
        for (const Anchors::Line& a : anchors_.lines) {
            const Vec3 n = a.direction.unitOrthogonal();
            for (const Vec3& k : {n, Vec3(a.direction.cross(n))}) {
                plane(rows, a.vertex, k, k.dot(a.point));
            }
        }
        for (const Anchors::Median& a : anchors_.medians) {
            const Vec3 n = a.direction.unitOrthogonal();
            for (const Vec3& k : {n, Vec3(a.direction.cross(n))}) {
                rows.begin(0.0);
                rows.add(a.apex, k);
                for (const int v : a.base) rows.add(v, -0.5 * k);
            }
        }
        for (const Anchors::Point& a : anchors_.points) {
            for (int i = 0; i < 3; ++i) plane(rows, a.vertex, Vec3::Unit(i), a.point(i));
        }
    }

    /// Particular solution and basis of what the constraints leave free.
    bool constrain() {
        const Rows rows = constraints();
        const MatrixXd j = rows.jacobian();
        const VectorXd c = rows.values();
        Eigen::ColPivHouseholderQR<MatrixXd> qr(j.transpose());
        qr.setThreshold(tol::kLinearRank);
        const Index rank = qr.rank();
        const MatrixXd q = qr.householderQ() * MatrixXd::Identity(columns_, columns_);
        free_ = q.rightCols(columns_ - rank);
        const VectorXd permuted = qr.colsPermutation().transpose() * c;
        const VectorXd y = qr.matrixR()
                               .topLeftCorner(rank, rank)
                               .template triangularView<Eigen::Upper>()
                               .transpose()
                               .solve(permuted.head(rank));
        x_ = q.leftCols(rank) * y;
        return (j * x_ - c).cwiseAbs().maxCoeff() < tol::kAnchorResidual;
    }

    bool bendable() const {
        return std::any_of(s_.edges.begin(), s_.edges.end(), [&](const DrawnEdge& d) {
            return (d.vertex[0] < 0 || d.vertex[1] < 0) && !directionOf(d.edge);
        });
    }

    /// Direction of a template edge on the screen.
    Vec2 shown(const DrawnEdge& d, int round) const {
        const auto& given = directionOf(d.edge);
        Vec2 u = d.direction();
        if (given && given->head<2>().norm() > tol::kEndOnSine) {
            u = given->head<2>();
        } else if (round > 0) {
            const auto& ends = analysis_.edges[at(d.edge)].ends;
            const Vec2 drawn =
                x_.segment<2>(3 * Index{ends[1]}) - x_.segment<2>(3 * Index{ends[0]});
            if (drawn.norm() > 1e-6) u = drawn;
        }
        return u.normalized();
    }

    /// Weighted distances of the drawn line ends at x_.
    Rows inkRows(int round) const {
        Rows rows(columns_);
        const double across = s_.sizePx / s_.acrossPx;
        const double along = stopWeight(s_) * s_.sizePx / s_.alongPx;
        for (const DrawnEdge& d : s_.edges) {
            const Vec2 dir = d.direction();
            const Vec2 side(-dir.y(), dir.x());
            for (std::size_t end = 0; end < 2; ++end) {
                const Vec2 tip = (d.tips[end] - center_.head<2>()) / s_.sizePx;
                const auto row = [&](int v, const Vec2& n, double weight) {
                    rows.begin(weight * n.dot(x_.segment<2>(3 * Index{v}) - tip));
                    rows.add(v, weight * Vec3(n.x(), n.y(), 0));
                };
                if (d.vertex[end] >= 0) {
                    row(d.vertex[end], side, across);
                    if (d.penEnd[end]) row(d.vertex[end], dir, along);
                } else {
                    const Vec2 u = shown(d, round);
                    row(analysis_.edges[at(d.edge)].ends[0], Vec2(-u.y(), u.x()), across);
                }
            }
        }
        return rows;
    }

    /// Moves to the best of what is free; returns how much of that the ink does not see.
    int fit(int round) {
        if (free_.cols() == 0) return 0;
        const Rows ink = inkRows(round);
        const MatrixXd jz = ink.jacobian() * free_;
        const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(jz.transpose() * jz);
        const VectorXd& values = eigen.eigenvalues();  // ascending
        Index unseen = 0;
        while (unseen < values.size() &&
               values(unseen) <= tol::kUnseenDirection * values(values.size() - 1)) {
            ++unseen;
        }
        const Index seen = values.size() - unseen;
        if (seen > 0) {
            const MatrixXd v = eigen.eigenvectors().rightCols(seen);
            const VectorXd b = v.transpose() * (jz.transpose() * ink.values());
            x_ -= free_ * (v * b.cwiseQuotient(values.tail(seen)));
        }
        if (unseen > 0) settle(free_ * eigen.eigenvectors().leftCols(unseen));
        return static_cast<int>(unseen);
    }

    Vec3 edgeVector(std::size_t e) const {
        const auto& ends = analysis_.edges[e].ends;
        return x_.segment<3>(3 * Index{ends[1]}) - x_.segment<3>(3 * Index{ends[0]});
    }

    /// Edges whose length is open become as long as the mean of the drawn ones.
    void settle(const MatrixXd& open) {
        double length = 0;
        for (const DrawnEdge& d : s_.edges) length += d.length() / s_.sizePx;
        length /= static_cast<double>(std::max<std::size_t>(1, s_.edges.size()));
        Rows rows(columns_);
        for (std::size_t e = 0; e < analysis_.edges.size(); ++e) {
            const Vec3 u = edgeVector(e);
            const auto& given = directionOf(static_cast<int>(e));
            Vec3 d = given ? *given : u.norm() > 1e-9 ? Vec3(u.normalized()) : Vec3::UnitZ();
            if (d.dot(u) < 0) d = -d;
            rows.begin(d.dot(u) - length);
            addEdge(rows, static_cast<int>(e), d);
        }
        const MatrixXd a = rows.jacobian() * open;
        x_ -= open * (a.transpose() * a + 1e-12 * MatrixXd::Identity(open.cols(), open.cols()))
                         .ldlt()
                         .solve(a.transpose() * rows.values());
    }

    const Template& tmpl_;
    const TemplateAnalysis& analysis_;
    const Sighting& s_;
    const Anchors& anchors_;
    const KnownDirections& known_;
    Index columns_;
    Vec3 center_ = Vec3::Zero();
    VectorXd x_;  ///< unit size, centred
    MatrixXd free_;
};

}  // namespace

bool isLinear(const Template& tmpl, const TemplateAnalysis& analysis,
              const KnownDirections& known) {
    const auto given = [&](int e) {
        return known[at(analysis.edges[at(e)].directionClass)].has_value();
    };
    const std::vector<int> set = sameVector(tmpl, analysis);
    std::vector<int> setOfClass(at(analysis.classCount), -1);
    for (std::size_t e = 0; e < set.size(); ++e) {
        if (given(static_cast<int>(e))) continue;
        int& s = setOfClass[at(analysis.edges[e].directionClass)];
        if (s >= 0 && s != set[e]) return false;
        s = set[e];
    }
    for (const auto& pair : analysis.perpendicularClasses) {
        if (!known[at(pair[0])] && !known[at(pair[1])]) return false;
    }
    return std::all_of(tmpl.shape.faces.begin(), tmpl.shape.faces.end(), [&](const auto& loop) {
        if (loop.size() == 3 || parallelogram(analysis, loop)) return true;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (!given(analysis.edgeBetween(loop[i], loop[(i + 1) % loop.size()]))) return false;
        }
        return true;
    });
}

std::optional<GeneralSolution> solveLinearly(const Template& tmpl, const TemplateAnalysis& analysis,
                                             const Sighting& sighting, const Anchors& anchors,
                                             const KnownDirections& known) {
    return LinearFit(tmpl, analysis, sighting, anchors, known).run();
}

}  // namespace ew
