// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/rectilinear_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/tolerance.h"
#include "core/reading/extract/plane_geometry.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }
constexpr double kRadian = 180.0 / std::numbers::pi;

/// Rows of a linear least-squares problem, built up as normal equations.
class Normal {
  public:
    explicit Normal(int n) : a_(Eigen::MatrixXd::Zero(n, n)), b_(Eigen::VectorXd::Zero(n)) {}
    void add(const std::vector<std::pair<int, double>>& row, double rhs, double weight) {
        for (const auto& [i, u] : row) {
            for (const auto& [j, v] : row) a_(i, j) += weight * u * v;
            b_(i) += weight * u * rhs;
        }
    }
    void ridge(double value) { a_.diagonal().array() += value; }
    const Eigen::MatrixXd& matrix() const { return a_; }
    Eigen::VectorXd solve() const { return a_.ldlt().solve(b_); }

  private:
    Eigen::MatrixXd a_;
    Eigen::VectorXd b_;
};

/// Which planes of each axis some drawn vertex lies on.
std::array<std::vector<bool>, 3> seenPlanes(const Sighting& s, const RectilinearStructure& r) {
    std::array<std::vector<bool>, 3> seen;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        seen[axis].assign(at(r.planeCount[axis]), false);
        for (std::size_t v = 0; v < s.seen.size(); ++v) {
            if (s.seen[v]) seen[axis][at(r.planes[axis][v])] = true;
        }
    }
    return seen;
}

/// Fits a free offset vector per plane (linear), then reads axis vectors and positions off them.
class AffineFit {
  public:
    AffineFit(const Sighting& s, const TemplateAnalysis& a)
        : s_(s), a_(a), r_(*a.rectilinear), seen_(seenPlanes(s, r_)) {}

    std::optional<AffinePicture> run() {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            first_[axis] = last_[axis] = -1;
            for (int k = 0; k < r_.planeCount[axis]; ++k) {
                if (!seen_[axis][at(k)]) continue;
                const auto& ref = r_.reference[axis];
                if (first_[axis] < 0 || ref[at(k)] < ref[at(first_[axis])]) first_[axis] = k;
                if (last_[axis] < 0 || ref[at(k)] > ref[at(last_[axis])]) last_[axis] = k;
            }
            if (first_[axis] < 0 || first_[axis] == last_[axis]) return std::nullopt;
        }
        initialise();
        for (int i = 0; i < 6; ++i) {
            if (iterate() < 1e-13 * s_.sizePx) break;
        }
        placeUnseen();
        if (!picture_.origin.allFinite()) return std::nullopt;
        return picture_;
    }

  private:
    /// Free plane offsets: P_v = o + sum over axes of O[axis][plane], O = 0 for the first seen
    /// plane.
    void initialise() {
        std::array<std::vector<int>, 3> column;
        int n = 2;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            column[axis].assign(at(r_.planeCount[axis]), -1);
            for (int k = 0; k < r_.planeCount[axis]; ++k) {
                if (seen_[axis][at(k)] && k != first_[axis]) {
                    column[axis][at(k)] = n;
                    n += 2;
                }
            }
        }
        Normal normal(n);
        for (std::size_t v = 0; v < s_.seen.size(); ++v) {
            if (!s_.seen[v]) continue;
            for (int c = 0; c < 2; ++c) {
                std::vector<std::pair<int, double>> row{{c, 1.0}};
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const int col = column[axis][at(r_.planes[axis][v])];
                    if (col >= 0) row.emplace_back(col + c, 1.0);
                }
                normal.add(row, s_.vertexPx[v](c), 1.0);
            }
        }
        normal.ridge(1e-9);
        const Eigen::VectorXd x = normal.solve();
        picture_.origin = x.head<2>();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            picture_.position[axis].assign(at(r_.planeCount[axis]), 0.0);
            picture_.axes[axis] = x.segment<2>(column[axis][at(last_[axis])]);
            const Vec2 q = picture_.axes[axis];
            for (int k = 0; k < r_.planeCount[axis]; ++k) {
                const int col = column[axis][at(k)];
                if (col < 0) continue;
                picture_.position[axis][at(k)] =
                    k == last_[axis] ? 1.0
                                     : x.segment<2>(col).dot(q) / std::max(q.squaredNorm(), 1e-12);
            }
        }
    }

    /// One Gauss-Newton step over origin, axes and inner plane positions; returns its size.
    double iterate() {
        std::array<std::vector<int>, 3> column;
        int n = 8;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            column[axis].assign(at(r_.planeCount[axis]), -1);
            for (int k = 0; k < r_.planeCount[axis]; ++k) {
                if (seen_[axis][at(k)] && k != first_[axis] && k != last_[axis]) {
                    column[axis][at(k)] = n++;
                }
            }
        }
        Normal normal(n);
        const double wAcross = 1.0 / (s_.acrossPx * s_.acrossPx);
        const double wAlong = std::pow(stopWeight(s_) / s_.alongPx, 2);
        auto addRow = [&](const Vec2& dir, const Vec2& tip, std::size_t v, double weight,
                          std::size_t slideAxis, double slide) {
            const Vec2 p = picture_.at(r_, v) + slide * picture_.axes[slideAxis];
            std::vector<std::pair<int, double>> row{{0, dir.x()}, {1, dir.y()}};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const int plane = r_.planes[axis][v];
                double position = picture_.position[axis][at(plane)];
                if (axis == slideAxis) position += slide;
                row.emplace_back(static_cast<int>(2 + 2 * axis), position * dir.x());
                row.emplace_back(static_cast<int>(3 + 2 * axis), position * dir.y());
                if (column[axis][at(plane)] >= 0) {
                    row.emplace_back(column[axis][at(plane)], picture_.axes[axis].dot(dir));
                }
            }
            normal.add(row, dir.dot(tip - p), weight);
        };
        for (const DrawnEdge& d : s_.edges) {
            const Vec2 dir = d.direction();
            const Vec2 across(-dir.y(), dir.x());
            const std::size_t axis = at(a_.edges[at(d.edge)].directionClass);
            for (std::size_t end = 0; end < 2; ++end) {
                if (d.vertex[end] >= 0) {
                    addRow(across, d.tips[end], at(d.vertex[end]), wAcross, 0, 0.0);
                    const double along = d.penEnd[end] ? wAlong : 1e-6 * wAlong;
                    addRow(dir, d.tips[end], at(d.vertex[end]), along, 0, 0.0);
                } else {
                    // The edge goes on behind something: its tip is only known to lie on the line.
                    const std::size_t v = at(a_.edges[at(d.edge)].ends[0]);
                    const Vec2& q = picture_.axes[axis];
                    const double slide =
                        q.dot(d.tips[end] - picture_.at(r_, v)) / std::max(q.squaredNorm(), 1e-12);
                    if (placed(v)) addRow(across, d.tips[end], v, wAcross, axis, slide);
                }
            }
        }
        normal.ridge(1e-12);
        const Eigen::VectorXd x = normal.solve();
        picture_.origin += x.head<2>();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            picture_.axes[axis] += x.segment<2>(static_cast<Eigen::Index>(2 + 2 * axis));
            for (int k = 0; k < r_.planeCount[axis]; ++k) {
                if (column[axis][at(k)] >= 0) {
                    picture_.position[axis][at(k)] += x(column[axis][at(k)]);
                }
            }
        }
        const Eigen::MatrixXd covariance =
            normal.matrix().ldlt().solve(Eigen::MatrixXd::Identity(n, n));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<Eigen::Index>(2 + 2 * axis);
            const Vec2 q = picture_.axes[axis];
            const Vec2 across = Vec2(-q.y(), q.x()).normalized();
            const double variance = across.dot(covariance.block<2, 2>(i, i) * across);
            picture_.angleSpread[axis] =
                std::sqrt(std::max(0.0, variance)) / std::max(q.norm(), 1e-9);
        }
        return x.norm();
    }

    /// True where the planes of the vertex that a sliding row uses are all seen.
    bool placed(std::size_t v) const {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (!seen_[axis][at(r_.planes[axis][v])]) return false;
        }
        return true;
    }

    /// Planes on which nothing was drawn keep the reference shape's proportion between seen ones.
    void placeUnseen() {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto& ref = r_.reference[axis];
            auto& position = picture_.position[axis];
            for (int k = 0; k < r_.planeCount[axis]; ++k) {
                if (seen_[axis][at(k)]) continue;
                ++picture_.unseenPlanes;
                int below = -1;
                int above = -1;
                for (int m = 0; m < r_.planeCount[axis]; ++m) {
                    if (!seen_[axis][at(m)]) continue;
                    if (ref[at(m)] < ref[at(k)] && (below < 0 || ref[at(m)] > ref[at(below)]))
                        below = m;
                    if (ref[at(m)] > ref[at(k)] && (above < 0 || ref[at(m)] < ref[at(above)]))
                        above = m;
                }
                if (below < 0) {
                    below = first_[axis];
                    above = last_[axis];
                }
                if (above < 0) {
                    below = first_[axis];
                    above = last_[axis];
                }
                const double share =
                    (ref[at(k)] - ref[at(below)]) / (ref[at(above)] - ref[at(below)]);
                position[at(k)] =
                    position[at(below)] + share * (position[at(above)] - position[at(below)]);
            }
        }
    }

    const Sighting& s_;
    const TemplateAnalysis& a_;
    const RectilinearStructure& r_;
    std::array<std::vector<bool>, 3> seen_;
    std::array<int, 3> first_{}, last_{};
    AffinePicture picture_;
};

/// Turns axes j and k apart (positive) or together by `deg` in sum, the shorter one turning more.
double turnApart(AffinePicture& p, std::size_t j, std::size_t k, double deg) {
    const double lj = p.axes[j].norm();
    const double lk = p.axes[k].norm();
    const double shareJ = lk * lk / std::max(lj * lj + lk * lk, 1e-12);
    const double sense = cross2(p.axes[j], p.axes[k]) >= 0 ? 1.0 : -1.0;
    const double aj = -sense * shareJ * deg / kRadian;
    const double ak = sense * (1 - shareJ) * deg / kRadian;
    p.axes[j] = Eigen::Rotation2Dd(aj) * p.axes[j];
    p.axes[k] = Eigen::Rotation2Dd(ak) * p.axes[k];
    return std::max(std::abs(aj) * lj, std::abs(ak) * lk);
}

}  // namespace

Vec2 AffinePicture::at(const RectilinearStructure& r, std::size_t vertex) const {
    Vec2 p = origin;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        p += position[axis][static_cast<std::size_t>(r.planes[axis][vertex])] * axes[axis];
    }
    return p;
}

CameraPoints picturePoints(const AffinePicture& picture, const RectilinearStructure& r) {
    CameraPoints points;
    for (std::size_t v = 0; v < r.planes[0].size(); ++v) {
        const Vec2 p = picture.at(r, v);
        points.emplace_back(p.x(), p.y(), 0.0);
    }
    return points;
}

std::optional<AffinePicture> fitAffine(const Sighting& sighting, const TemplateAnalysis& analysis) {
    return AffineFit(sighting, analysis).run();
}

std::optional<std::array<double, 3>> cornerDepths(const std::array<Vec2, 3>& q) {
    const double d01 = q[0].dot(q[1]);
    const double d12 = q[1].dot(q[2]);
    const double d20 = q[2].dot(q[0]);
    const double product = -d01 * d12 * d20;
    if (!(product > 0)) return std::nullopt;
    // The largest depth first: dividing by it loses the least.
    const double root = std::sqrt(product);
    const std::array<double, 3> size{root / std::abs(d12), root / std::abs(d20),
                                     root / std::abs(d01)};
    const std::array<std::array<double, 3>, 3> d{
        {{0.0, d01, d20}, {d01, 0.0, d12}, {d20, d12, 0.0}}};
    const auto lead =
        static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    std::array<double, 3> t{};
    t[lead] = size[lead];
    for (std::size_t i = 0; i < 3; ++i) {
        if (i != lead) t[i] = -d[lead][i] / t[lead];
    }
    return t;
}

CriticalAngle criticalAngle(const AffinePicture& picture) {
    CriticalAngle best;
    best.offDeg = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t j = static_cast<std::size_t>((axis + 1) % 3);
        const std::size_t k = static_cast<std::size_t>((axis + 2) % 3);
        const double off = std::abs(angleBetweenDeg(picture.axes[j], picture.axes[k]) - 90.0);
        if (off < best.offDeg) {
            best = {axis, off,
                    std::hypot(picture.angleSpread[j], picture.angleSpread[k]) * kRadian};
        }
    }
    return best;
}

AffinePicture snapToSolvable(const AffinePicture& picture, double marginDeg, double& movedPx) {
    AffinePicture p = picture;
    const CriticalAngle c = criticalAngle(picture);
    const std::size_t j = static_cast<std::size_t>((c.axis + 1) % 3);
    const std::size_t k = static_cast<std::size_t>((c.axis + 2) % 3);
    const double angle = angleBetweenDeg(p.axes[j], p.axes[k]);
    const double target = angle < 90.0 ? 90.0 + marginDeg : 90.0 - marginDeg;
    movedPx = turnApart(p, j, k, target - angle);
    return p;
}

CameraPoints liftPicture(const AffinePicture& picture, const RectilinearStructure& r,
                         const std::array<double, 3>& depths) {
    CameraPoints points;
    for (std::size_t v = 0; v < r.planes[0].size(); ++v) {
        const Vec2 p = picture.at(r, v);
        double z = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            z += picture.position[axis][at(r.planes[axis][v])] * depths[axis];
        }
        points.emplace_back(p.x(), p.y(), z);
    }
    return points;
}

ObliqueBody obliqueAxes(const AffinePicture& picture, double factor, double& movedPx) {
    AffinePicture p = picture;
    const CriticalAngle c = criticalAngle(picture);
    const std::size_t i = at(c.axis);
    const std::size_t j = static_cast<std::size_t>((c.axis + 1) % 3);
    const std::size_t k = static_cast<std::size_t>((c.axis + 2) % 3);
    movedPx = turnApart(p, j, k, 90.0 - angleBetweenDeg(p.axes[j], p.axes[k]));
    ObliqueBody body;
    body.depthAxis = c.axis;
    body.axes[j] = Vec3(p.axes[j].x(), p.axes[j].y(), 0);
    body.axes[k] = Vec3(p.axes[k].x(), p.axes[k].y(), 0);
    body.axes[i] = Vec3(0, 0, factor * p.axes[i].norm());
    return body;
}

}  // namespace ew
