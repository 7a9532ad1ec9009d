// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/extract/axis_frames.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double kPi = std::numbers::pi;
/// Lines within this are one direction, however short they are.
constexpr double kMostMerged = 9.0 * kPi / 180.0;
/// Lines that differ by more of their standard deviations are two directions.
constexpr double kMergeSigmas = 3.0;
constexpr std::size_t kMostFamilies = 12;

/// Difference of two directions without a sense, 0..pi/2.
double turn(double a, double b) { return std::abs(std::remainder(a - b, kPi)); }

/// Lines of one direction in the picture.
struct Family {
    double angle = 0.0;   ///< [rad], modulo pi
    double weight = 0.0;  ///< sum of 1 / variance of the angles
    double lengthPx = 0.0;
    std::vector<int> lines;
};

struct Triple {
    std::array<int, 3> families{};
    Mat3 axes = Mat3::Identity();
    double rank = 0.0;
};

class Frames {
  public:
    Frames(const LineDrawing& drawing, double spread) : drawing_(drawing), spread_(spread) {
        const int lines = static_cast<int>(drawing.from.size() / 2);
        for (int e = 0; e < lines; ++e) {
            Family f;
            const Vec2 d = drawing.vector(2 * e);
            f.lengthPx = std::max(d.norm(), 1e-6);
            f.angle = std::atan2(d.y(), d.x());
            f.weight = 1.0 / variance(f.lengthPx);
            f.lines = {e};
            total_ += f.lengthPx;
            families_.push_back(std::move(f));
        }
        merge();
    }

    std::vector<AxisFrame> all(std::size_t most) const {
        std::vector<Triple> triples;
        const int n = static_cast<int>(std::min(families_.size(), kMostFamilies));
        for (int i = 0; i < n; ++i) {
            for (int j = i + 1; j < n; ++j) {
                for (int k = j + 1; k < n; ++k) {
                    if (auto t = feasible({i, j, k})) triples.push_back(*t);
                }
            }
        }
        std::stable_sort(triples.begin(), triples.end(),
                         [](const Triple& a, const Triple& b) { return a.rank > b.rank; });
        std::vector<AxisFrame> out;
        for (const Triple& t : triples) {
            for (const bool mirrored : {false, true}) {
                if (out.size() == most) return out;
                out.push_back(frame(t, mirrored));
            }
        }
        return out;
    }

  private:
    double variance(double length) const {
        const double sigma = std::numbers::sqrt2 * spread_ / length;
        return sigma * sigma;
    }

    /// The closest pair becomes one as long as it may be one.
    void merge() {
        while (families_.size() > 1) {
            std::size_t a = 0;
            std::size_t b = 0;
            double least = 1.0;
            for (std::size_t i = 0; i < families_.size(); ++i) {
                for (std::size_t j = i + 1; j < families_.size(); ++j) {
                    const double d = turn(families_[i].angle, families_[j].angle);
                    const double sigma =
                        std::sqrt(1.0 / families_[i].weight + 1.0 / families_[j].weight);
                    if (d > kMostMerged || d > kMergeSigmas * sigma) continue;
                    if (d / sigma / kMergeSigmas >= least) continue;
                    least = d / sigma / kMergeSigmas;
                    a = i;
                    b = j;
                }
            }
            if (b == 0) break;
            unite(families_[a], families_[b]);
            families_.erase(families_.begin() + static_cast<std::ptrdiff_t>(b));
        }
        std::stable_sort(families_.begin(), families_.end(),
                         [](const Family& a, const Family& b) { return a.lengthPx > b.lengthPx; });
    }

    static void unite(Family& a, const Family& b) {
        const double off = std::remainder(b.angle - a.angle, kPi);
        a.angle += off * b.weight / (a.weight + b.weight);
        a.weight += b.weight;
        a.lengthPx += b.lengthPx;
        a.lines.insert(a.lines.end(), b.lines.begin(), b.lines.end());
    }

    /// Depth slopes of three perpendicular directions by their pictures: tan^2 of the angle out of
    /// the picture plane is -D_ij D_ik / D_jk, D the scalar products of the unit pictures.
    std::optional<Triple> feasible(const std::array<int, 3>& ids) const {
        std::array<Vec2, 3> u;
        for (std::size_t k = 0; k < 3; ++k) {
            const double a = families_[at(ids[k])].angle;
            u[k] = Vec2(std::cos(a), std::sin(a));
        }
        Triple out;
        out.families = ids;
        constexpr double kMostSlope = 6.0;  // about 80 degrees out of the picture plane
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const std::size_t k = (i + 2) % 3;
            const double square = -u[i].dot(u[j]) * u[i].dot(u[k]) / u[j].dot(u[k]);
            if (!(square > 0.0) || square > kMostSlope * kMostSlope) return std::nullopt;
            // The first axis goes away from the eye, the others so that they are across it.
            const double sense = i == 0 ? 1.0 : (u[0].dot(u[i]) < 0.0 ? 1.0 : -1.0);
            out.axes.col(static_cast<Eigen::Index>(i)) =
                Vec3(u[i].x(), u[i].y(), sense * std::sqrt(square)).normalized();
        }
        int upright = 0;
        for (int k = 1; k < 3; ++k) {
            if (std::abs(u[at(k)].y()) > std::abs(u[at(upright)].y())) upright = k;
        }
        // Seen from above, what goes up comes nearer; y is down.
        if (out.axes(1, upright) * out.axes(2, upright) < 0.0) out.axes.row(2) *= -1.0;
        double length = 0.0;
        for (const int id : ids) length += families_[at(id)].lengthPx;
        constexpr double kUpright = 0.97;
        out.rank = length / total_ + (std::abs(u[at(upright)].y()) > kUpright ? 0.3 : 0.0) +
                   (holdsLowest(ids) ? 0.3 : 0.0);
        return out;
    }

    bool holdsLowest(const std::array<int, 3>& ids) const {
        std::size_t lowest = 0;
        for (std::size_t v = 0; v < drawing_.nodes.size(); ++v) {
            if (drawing_.nodes[v].at.y() > drawing_.nodes[lowest].at.y()) lowest = v;
        }
        const auto& out = drawing_.nodes[lowest].out;
        return std::all_of(out.begin(), out.end(), [&](int d) {
            return std::any_of(ids.begin(), ids.end(), [&](int id) {
                const auto& lines = families_[at(id)].lines;
                return std::find(lines.begin(), lines.end(), d / 2) != lines.end();
            });
        });
    }

    AxisFrame frame(const Triple& t, bool mirrored) const {
        AxisFrame out;
        out.axes = t.axes;
        if (mirrored) out.axes.row(2) *= -1.0;
        if (out.axes.determinant() < 0.0) out.axes.col(2) *= -1.0;
        // The nearest rotation: means of families are not exactly across one another.
        const Eigen::JacobiSVD<Mat3> svd(out.axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
        out.axes = svd.matrixU() * svd.matrixV().transpose();
        const int lines = static_cast<int>(drawing_.from.size() / 2);
        out.axisOf.assign(at(lines), -1);
        double along = 0.0;
        for (int e = 0; e < lines; ++e) {
            const Vec2 d = drawing_.vector(2 * e);
            const double angle = std::atan2(d.y(), d.x());
            const double sigma = std::sqrt(variance(std::max(d.norm(), 1e-6)));
            double least = std::min(kMostMerged, std::max(kMergeSigmas * sigma, 1e-4));
            for (int k = 0; k < 3; ++k) {
                const Vec3 axis = out.axes.col(k);
                const double off = turn(angle, std::atan2(axis.y(), axis.x()));
                if (off > least) continue;
                least = off;
                out.axisOf[at(e)] = k;
            }
            if (out.axisOf[at(e)] >= 0) along += d.norm();
        }
        out.share = along / std::max(total_, 1e-6);
        return out;
    }

    const LineDrawing& drawing_;
    double spread_;
    double total_ = 0.0;
    std::vector<Family> families_;
};

}  // namespace

std::vector<AxisFrame> axisFrames(const LineDrawing& drawing, double spreadPx, std::size_t most) {
    return Frames(drawing, spreadPx).all(most);
}

}  // namespace ew
