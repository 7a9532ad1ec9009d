// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/perspective_fit.h"

#include <Eigen/Geometry>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include "core/reading/types/reading_params.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A point as it is seen; its depth is kept.
Vec3 seenAt(const Vec3& point, const Vec2& principal, double kappa) {
    const double scale = 1.0 + kappa * point.z() / kPerspectivePx;
    const Vec2 p = principal + (point.head<2>() - principal) / scale;
    return {p.x(), p.y(), point.z()};
}

/// The numbers that are fitted, and what they stand for.
class Parameters {
  public:
    Parameters(const RectilinearStructure& r, const AffinePicture& start,
               const std::array<double, 3>& depths, const Vec2& principal)
        : r_(r), base_(start), principal_(principal) {
        for (std::size_t a = 0; a < 3; ++a) {
            axes_.col(static_cast<Eigen::Index>(a)) =
                Vec3(start.axes[a].x(), start.axes[a].y(), depths[a]);
            for (std::size_t k = 0; k < start.position[a].size(); ++k) {
                const double p = start.position[a][k];
                if (p != 0.0 && p != 1.0) inner_.push_back({a, k});
            }
        }
    }

    /// Kappa, origin, turn, logarithms of the lengths' factors, inner plane positions.
    Eigen::Index count() const { return 9 + static_cast<Eigen::Index>(inner_.size()); }

    PerspectivePicture picture(const Eigen::VectorXd& x) const {
        PerspectivePicture out;
        out.parallel = base_;
        out.principal = principal_;
        out.kappa = x(0);
        out.parallel.origin += kPerspectivePx * x.segment<2>(1);
        const Vec3 turn = x.segment<3>(3);
        const double angle = turn.norm();
        const Mat3 rotation = angle > 0.0
                                  ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                                  : Mat3::Identity();
        for (Eigen::Index a = 0; a < 3; ++a) {
            const Vec3 axis = std::exp(x(6 + a)) * (rotation * axes_.col(a));
            out.axes[static_cast<std::size_t>(a)] = axis;
            out.parallel.axes[static_cast<std::size_t>(a)] = axis.head<2>();
        }
        for (std::size_t i = 0; i < inner_.size(); ++i) {
            out.parallel.position[inner_[i].first][inner_[i].second] +=
                x(9 + static_cast<Eigen::Index>(i));
        }
        return out;
    }

  private:
    const RectilinearStructure& r_;
    AffinePicture base_;
    Vec2 principal_;
    Mat3 axes_;
    std::vector<std::pair<std::size_t, std::size_t>> inner_;  ///< axis, plane
};

/// Distances of all drawn line ends from where the picture has them, over their spreads.
class Residuals {
  public:
    using Scalar = double;
    using InputType = Eigen::VectorXd;
    using ValueType = Eigen::VectorXd;
    using JacobianType = Eigen::MatrixXd;
    enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

    Residuals(const Sighting& sighting, const TemplateAnalysis& analysis,
              const Parameters& parameters)
        : s_(sighting), a_(analysis), parameters_(parameters) {}

    int inputs() const { return static_cast<int>(parameters_.count()); }
    int values() const { return static_cast<int>(4 * s_.edges.size()); }

    int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& out) const {
        const PerspectivePicture picture = parameters_.picture(x);
        const RectilinearStructure& r = *a_.rectilinear;
        const double along = stopWeight(s_) / s_.alongPx;
        Eigen::Index row = 0;
        for (const DrawnEdge& d : s_.edges) {
            const auto& ends = a_.edges[at(d.edge)].ends;
            const Vec2 dir = d.direction();
            for (std::size_t side = 0; side < 2; ++side) {
                Vec2 off = Vec2::Zero();
                double end = 0.0;
                if (d.vertex[side] >= 0) {
                    off = d.tips[side] - picture.at(r, at(d.vertex[side])).head<2>();
                    end = d.penEnd[side] ? dir.dot(off) * along : 0.0;
                } else {
                    off = d.tips[side] - picture.at(r, at(ends[0])).head<2>();
                    const Vec2 u = (picture.at(r, at(ends[1])) - picture.at(r, at(ends[0])))
                                       .head<2>()
                                       .normalized();
                    off -= u * u.dot(off);
                }
                out(row++) = cross2(dir, off) / s_.acrossPx;
                out(row++) = end;
            }
        }
        return 0;
    }

  private:
    const Sighting& s_;
    const TemplateAnalysis& a_;
    const Parameters& parameters_;
};

}  // namespace

Vec3 PerspectivePicture::at(const RectilinearStructure& r, std::size_t vertex) const {
    Vec3 p(parallel.origin.x(), parallel.origin.y(), 0.0);
    for (std::size_t a = 0; a < 3; ++a) {
        p += parallel.position[a][static_cast<std::size_t>(r.planes[a][vertex])] * axes[a];
    }
    return seenAt(p, principal, kappa);
}

std::optional<PerspectivePicture> fitPerspective(const Sighting& sighting,
                                                 const TemplateAnalysis& analysis,
                                                 const AffinePicture& start,
                                                 const std::array<double, 3>& depths) {
    Eigen::AlignedBox2d box;
    for (const DrawnEdge& d : sighting.edges) {
        box.extend(d.tips[0]);
        box.extend(d.tips[1]);
    }
    const Parameters parameters(*analysis.rectilinear, start, depths, box.center());
    Eigen::NumericalDiff<Residuals> residuals(Residuals(sighting, analysis, parameters));
    if (residuals.values() < residuals.inputs()) return std::nullopt;
    std::optional<PerspectivePicture> best;
    double least = 0.0;
    for (const double kappa : {0.15, 0.6}) {
        Eigen::VectorXd x = Eigen::VectorXd::Zero(parameters.count());
        x(0) = kappa;
        Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Residuals>> solver(residuals);
        solver.parameters.maxfev = 40 * static_cast<int>(parameters.count());
        solver.minimize(x);
        if (!x.allFinite() || x(0) < 0.0 || x(0) > params::kMostPerspective) continue;
        if (best && solver.fnorm >= least) continue;
        least = solver.fnorm;
        best = parameters.picture(x);
    }
    return best;
}

}  // namespace ew
