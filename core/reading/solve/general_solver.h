// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"
#include "core/reading/solve/general_fit.h"
#include "core/reading/solve/solver_rows.h"

namespace ew::general {

inline std::size_t at(int i) { return static_cast<std::size_t>(i); }
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Sequential quadratic programming over all vertex positions of a template; see solveGeneral and
/// solveAnchored. Used by general_fit.cpp only.
class Solver {
  public:
    Solver(const Template& tmpl, const TemplateAnalysis& analysis, const Sighting& sighting,
           const SolverRelations& relations, const Anchors* anchors = nullptr)
        : tmpl_(tmpl),
          analysis_(analysis),
          s_(sighting),
          relations_(relations),
          anchors_(anchors),
          columns_(static_cast<Index>(3 * tmpl.shape.vertices.size())) {
        Eigen::AlignedBox2d box;
        for (const DrawnEdge& d : s_.edges) {
            box.extend(d.tips[0]);
            box.extend(d.tips[1]);
        }
        center_ = Vec3(box.center().x(), box.center().y(), anchors ? anchors->depth() : 0.0);
        for (const auto& loop : tmpl_.shape.faces) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int before = loop[(i + loop.size() - 1) % loop.size()];
                const int after = loop[(i + 1) % loop.size()];
                corners_.push_back({before, loop[i], after, cornerAngle(before, loop[i], after)});
            }
        }
    }

    /// Dimensions of the relations' solution set at the reference shape, depth excluded.
    int freedoms() {
        points_ = tmpl_.shape.vertices;
        return static_cast<int>(linearise().free.cols());
    }

    /// From a start that obeys the anchors nearly: they and directions are linear, so few steps do.
    std::optional<GeneralSolution> runAnchored(const CameraPoints& start) {
        points_.clear();
        for (const Vec3& p : start) points_.emplace_back((p - center_) / s_.sizePx);
        // Steps as long as the drawing after several rounds lead nowhere.
        constexpr int kPatience = 7;
        for (int i = 0; i < 25; ++i) {
            const double step = polish();
            if (step < 1e-10) break;
            if (i >= kPatience && step > 1.0) return std::nullopt;
        }
        return solution(tol::kAnchorResidual);
    }

    std::optional<GeneralSolution> run(const CameraPoints& start) {
        points_.clear();
        for (const Vec3& p : start) {
            points_.emplace_back((p - center_) / s_.sizePx);
        }
        // Far from a solution redundant relations contradict each other, so they begin as a growing
        // penalty; near it their rank is plain, and the null-space steps end at full precision.
        for (const double weight : {10.0, 100.0, 1e4}) descend(weight);
        for (int i = 0; i < 40; ++i) {
            if (polish() < 1e-11) break;
        }
        return finish();
    }

  private:
    struct Corner {
        int before, at, after;
        double reference;
    };

    double cornerAngle(int before, int here, int after) const {
        const Vec3 p = tmpl_.shape.vertices[at(before)] - tmpl_.shape.vertices[at(here)];
        const Vec3 q = tmpl_.shape.vertices[at(after)] - tmpl_.shape.vertices[at(here)];
        return std::atan2(p.cross(q).norm(), p.dot(q));
    }
    Vec3 edgeVector(const CameraPoints& x, int e) const {
        const auto& ends = analysis_.edges[at(e)].ends;
        return x[at(ends[1])] - x[at(ends[0])];
    }
    void addEdge(Rows& rows, int e, const Vec3& gradient) const {
        rows.add(analysis_.edges[at(e)].ends[0], -gradient);
        rows.add(analysis_.edges[at(e)].ends[1], gradient);
    }

    Rows constraints(const CameraPoints& x) const {
        Rows rows(columns_);
        for (const auto& group : relations_.parallel) {
            const int lead = *std::max_element(group.begin(), group.end(), [&](int a, int b) {
                return edgeVector(x, a).squaredNorm() < edgeVector(x, b).squaredNorm();
            });
            for (const int e : group) {
                if (e == lead) continue;
                const Vec3 u = edgeVector(x, lead);
                const Vec3 w = edgeVector(x, e);
                const Vec3 c = u.cross(w);
                for (int i = 0; i < 3; ++i) {
                    const Vec3 axis = Vec3::Unit(i);
                    rows.begin(c(i));
                    addEdge(rows, lead, w.cross(axis));
                    addEdge(rows, e, axis.cross(u));
                }
            }
        }
        for (const auto& pair : relations_.perpendicular) {
            const Vec3 u = edgeVector(x, pair[0]);
            const Vec3 w = edgeVector(x, pair[1]);
            rows.begin(u.dot(w));
            addEdge(rows, pair[0], w);
            addEdge(rows, pair[1], u);
        }
        for (const auto& group : relations_.equalLength) {
            for (std::size_t i = 1; i < group.size(); ++i) {
                const Vec3 u = edgeVector(x, group[0]);
                const Vec3 w = edgeVector(x, group[i]);
                rows.begin(0.5 * (u.squaredNorm() - w.squaredNorm()));
                addEdge(rows, group[0], u);
                addEdge(rows, group[i], -w);
            }
        }
        for (const auto& loop : tmpl_.shape.faces) {
            for (std::size_t i = 3; i < loop.size(); ++i) {
                const Vec3& o = x[at(loop[0])];
                const Vec3 a = x[at(loop[1])] - o;
                const Vec3 b = x[at(loop[2])] - o;
                const Vec3 c = x[at(loop[i])] - o;
                rows.begin(a.cross(b).dot(c));
                rows.add(loop[1], b.cross(c));
                rows.add(loop[2], c.cross(a));
                rows.add(loop[i], a.cross(b));
                rows.add(loop[0], -(b.cross(c) + c.cross(a) + a.cross(b)));
            }
        }
        if (anchors_ != nullptr) {
            anchorRows(rows, x);
            rows.normalise();
            return rows;
        }
        // Depth as a whole cannot be seen in a parallel projection.
        double z = 0;
        for (const Vec3& p : x) z += p.z();
        rows.begin(z);
        for (std::size_t v = 0; v < x.size(); ++v) rows.add(static_cast<int>(v), Vec3::UnitZ());
        rows.normalise();
        return rows;
    }

    void anchorRows(Rows& rows, const CameraPoints& x) const {
        const double size = s_.sizePx;
        const auto plane = [&](int v, const Vec3& n, double offset) {
            rows.begin(n.dot(x[at(v)]) - (offset - n.dot(center_)) / size);
            rows.add(v, n);
        };
        for (const Anchors::Plane& a : anchors_->planes) plane(a.vertex, a.normal, a.offset);
        for (const Anchors::Line& a : anchors_->lines) {
            const Vec3 n = a.direction.unitOrthogonal();
            const Vec3 m = a.direction.cross(n);
            plane(a.vertex, n, n.dot(a.point));
            plane(a.vertex, m, m.dot(a.point));
        }
        for (const Anchors::Point& a : anchors_->points) {
            for (int i = 0; i < 3; ++i) plane(a.vertex, Vec3::Unit(i), a.point(i));
        }
        for (const Anchors::Direction& a : anchors_->directions) {
            const Vec3 n = a.direction.unitOrthogonal();
            const Vec3 m = a.direction.cross(n);
            const Vec3 e = edgeVector(x, a.edge);
            for (const Vec3& k : {n, m}) {
                rows.begin(k.dot(e));
                addEdge(rows, a.edge, k);
            }
        }
    }

    Rows inkResiduals(const CameraPoints& x) const {
        Rows rows(columns_);
        const double across = s_.sizePx / s_.acrossPx;
        const double along = stopWeight(s_) * s_.sizePx / s_.alongPx;
        for (const DrawnEdge& d : s_.edges) {
            const Vec2 dir = d.direction();
            const Vec2 side(-dir.y(), dir.x());
            for (std::size_t end = 0; end < 2; ++end) {
                const Vec2 tip = (d.tips[end] - center_.head<2>()) / s_.sizePx;
                if (d.vertex[end] >= 0) {
                    const Vec2 off = x[at(d.vertex[end])].head<2>() - tip;
                    rows.begin(across * side.dot(off));
                    rows.add(d.vertex[end], across * Vec3(side.x(), side.y(), 0));
                    if (!d.penEnd[end]) continue;
                    rows.begin(along * dir.dot(off));
                    rows.add(d.vertex[end], along * Vec3(dir.x(), dir.y(), 0));
                } else {
                    // Only known to lie on the edge's line.
                    const auto& ends = analysis_.edges[at(d.edge)].ends;
                    const Vec2 a = x[at(ends[0])].head<2>();
                    const Vec2 u = x[at(ends[1])].head<2>() - a;
                    const double len = std::max(u.norm(), 1e-9);
                    const double t = u.dot(tip - a) / (len * len);
                    const Vec2 n = Vec2(-u.y(), u.x()) / len;
                    rows.begin(across * n.dot(a + t * u - tip));
                    rows.add(ends[0], across * (1 - t) * Vec3(n.x(), n.y(), 0));
                    rows.add(ends[1], across * t * Vec3(n.x(), n.y(), 0));
                }
            }
        }
        return rows;
    }

    Rows regularity(const CameraPoints& x) const {
        Rows rows(columns_);
        const double weight = tol::kRegularityWeight * std::max(s_.doubt, tol::kLeastDoubt);
        for (const Corner& c : corners_) {
            const Vec3 p = x[at(c.before)] - x[at(c.at)];
            const Vec3 q = x[at(c.after)] - x[at(c.at)];
            const double lp = std::max(p.norm(), 1e-9);
            const double lq = std::max(q.norm(), 1e-9);
            const double cosine = std::clamp(p.dot(q) / (lp * lq), -1.0, 1.0);
            const double sine = std::max(std::sqrt(1 - cosine * cosine), 1e-3);
            rows.begin(weight * (std::acos(cosine) - c.reference));
            const Vec3 gp = weight * (cosine * p / lp - q / lq) / (lp * sine);
            const Vec3 gq = weight * (cosine * q / lq - p / lp) / (lq * sine);
            rows.add(c.before, gp);
            rows.add(c.after, gq);
            rows.add(c.at, -(gp + gq));
        }
        return rows;
    }

    double costOf(const CameraPoints& x) const {
        return inkResiduals(x).values().squaredNorm() + regularity(x).values().squaredNorm();
    }
    /// Levenberg-Marquardt on ink, regularity and weighted relations together.
    void descend(double weight) {
        auto merit = [&](const CameraPoints& x) {
            return costOf(x) + weight * weight * constraints(x).values().squaredNorm();
        };
        double damping = 1e-3;
        double value = merit(points_);
        for (int i = 0; i < 25; ++i) {
            MatrixXd a = MatrixXd::Zero(columns_, columns_);
            VectorXd b = VectorXd::Zero(columns_);
            auto add = [&](const Rows& rows, double w) {
                const MatrixXd j = rows.jacobian();
                a.noalias() += w * w * j.transpose() * j;
                b.noalias() -= w * w * (j.transpose() * rows.values());
            };
            add(inkResiduals(points_), 1.0);
            add(regularity(points_), 1.0);
            add(constraints(points_), weight);
            bool accepted = false;
            for (int attempt = 0; attempt < 8 && !accepted; ++attempt) {
                MatrixXd damped = a;
                damped.diagonal() *= 1.0 + damping;
                damped.diagonal().array() += 1e-9;
                const CameraPoints next = moved(points_, damped.ldlt().solve(b));
                const double nextValue = merit(next);
                accepted = nextValue < value;
                if (accepted) {
                    const bool done = value - nextValue < 1e-4 * value;
                    points_ = next;
                    value = nextValue;
                    damping = std::max(damping * 0.1, 1e-9);
                    if (done) return;
                } else {
                    damping *= 10;
                }
            }
            if (!accepted) return;
        }
    }

    static CameraPoints moved(const CameraPoints& x, VectorXd move) {
        const double longest = move.cwiseAbs().maxCoeff();
        if (longest > 0.3) move *= 0.3 / longest;
        CameraPoints next = x;
        for (std::size_t v = 0; v < next.size(); ++v) {
            next[v] += move.segment<3>(static_cast<Index>(3 * v));
        }
        return next;
    }

    struct Linearised {
        VectorXd toFeasible;  ///< least step that meets the linearised constraints
        MatrixXd free;        ///< orthonormal basis of the steps that keep them
    };
    Linearised linearise() const {
        const Rows rows = constraints(points_);
        Eigen::ColPivHouseholderQR<MatrixXd> qr(rows.jacobian().transpose());
        qr.setThreshold(tol::kRelationRank);
        const Index rank = qr.rank();
        const MatrixXd q = qr.householderQ() * MatrixXd::Identity(columns_, columns_);
        Linearised l;
        l.free = q.rightCols(columns_ - rank);
        // J^T P = Q R: the pivoted rows determine the step, the others follow from them.
        const VectorXd c = qr.colsPermutation().transpose() * rows.values();
        const MatrixXd r11 = qr.matrixR().topLeftCorner(rank, rank);
        const VectorXd y =
            r11.triangularView<Eigen::Upper>().transpose().solve(VectorXd(-c.head(rank)));
        l.toFeasible = q.leftCols(rank) * y;
        return l;
    }

    /// Directions that keep the relations: those that the ink determines and those that it does
    /// not.
    struct FreeDirections {
        MatrixXd seen;
        MatrixXd unseen;
    };
    FreeDirections freeDirections(const Linearised& l) const {
        if (l.free.cols() == 0) return {l.free, l.free};
        const MatrixXd jz = inkResiduals(points_).jacobian() * l.free;
        const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(jz.transpose() * jz);
        const VectorXd& values = eigen.eigenvalues();  // ascending
        Index unseen = 0;
        while (unseen < values.size() &&
               values(unseen) < tol::kUnseenDirection * values(values.size() - 1)) {
            ++unseen;
        }
        return {l.free * eigen.eigenvectors().rightCols(values.size() - unseen),
                l.free * eigen.eigenvectors().leftCols(unseen)};
    }

    /// Gauss-Newton step within a subspace, halved until `cost` does not rise; returns its size.
    template <class Cost>
    double stepWithin(const MatrixXd& basis, const std::vector<Rows>& residuals, const Cost& cost) {
        if (basis.cols() == 0) return 0.0;
        MatrixXd a = 1e-14 * MatrixXd::Identity(basis.cols(), basis.cols());
        VectorXd b = VectorXd::Zero(basis.cols());
        for (const Rows& rows : residuals) {
            const MatrixXd jz = rows.jacobian() * basis;
            a.noalias() += jz.transpose() * jz;
            b.noalias() -= jz.transpose() * rows.values();
        }
        VectorXd move = basis * a.ldlt().solve(b);
        if (!move.allFinite()) return 0.0;
        const double before = cost(points_);
        for (int halving = 0; halving < 8; ++halving, move *= 0.5) {
            const CameraPoints next = moved(points_, move);
            if (cost(next) <= before * (1 + 1e-12) + 1e-20) {
                points_ = next;
                return move.cwiseAbs().maxCoeff();
            }
        }
        return 0.0;
    }

    /// One round of sequential quadratic programming: back onto the relations, then the ink, then,
    /// along what the ink leaves open, regularity. Returns the size of the largest step.
    double polish() {
        const Linearised l = linearise();
        points_ = moved(points_, l.toFeasible);
        const FreeDirections free = freeDirections(l);
        const double ink = stepWithin(free.seen, {inkResiduals(points_), regularity(points_)},
                                      [this](const CameraPoints& x) { return costOf(x); });
        const double shape = stepWithin(
            free.unseen, {regularity(points_)},
            [this](const CameraPoints& x) { return regularity(x).values().squaredNorm(); });
        return std::max({ink, shape, l.toFeasible.cwiseAbs().maxCoeff()});
    }

    std::optional<GeneralSolution> solution(double tolerance) {
        // Relations to the last digit.
        for (int i = 0; i < 2; ++i) points_ = moved(points_, linearise().toFeasible);
        GeneralSolution out;
        out.constraint = constraints(points_).values().cwiseAbs().maxCoeff();
        if (!(out.constraint < tolerance)) return std::nullopt;
        const Linearised l = linearise();
        out.freedoms = static_cast<int>(freeDirections(l).unseen.cols());
        // All of them, seen or not: at a special shape (a frustum that is a box) some vanish from
        // sight only.
        out.parameters = static_cast<int>(l.free.cols());
        out.cost = costOf(points_);
        for (const Vec3& p : points_) out.points.emplace_back(p * s_.sizePx + center_);
        return out;
    }

    std::optional<GeneralSolution> finish() {
        auto found = solution(1e-9);
        if (!found) return std::nullopt;
        GeneralSolution& out = *found;
        bool mirrored = false;
        if (facesLookRight(tmpl_, s_, out.points, mirrored)) return out;
        // The other Necker root: mirrored in depth the solid has the same picture and the same
        // relations.
        for (Vec3& p : out.points) p.z() = -p.z();
        if (facesLookRight(tmpl_, s_, out.points, mirrored)) return out;
        return std::nullopt;
    }

    const Template& tmpl_;
    const TemplateAnalysis& analysis_;
    const Sighting& s_;
    const SolverRelations& relations_;
    const Anchors* anchors_;
    Index columns_;
    Vec3 center_ = Vec3::Zero();
    std::vector<Corner> corners_;
    CameraPoints points_;  ///< unit size, centred
};

}  // namespace ew::general
