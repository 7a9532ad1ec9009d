// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/explain/convergence.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/reading/score/candidates.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double kRadian = std::numbers::pi / 180.0;
constexpr std::size_t kMostLines = 60;
/// A line farther from a direction than this is of another family [standard deviations].
constexpr double kOwn = 3.0;
/// Lines that are meant to be parallel converge by no more, seen from anywhere near.
constexpr double kMostDeg = 50.0;
constexpr double kLeastDeg = 4.0;
/// How much of all line length the families have.
constexpr double kLeastShare = 0.85;
/// Squared misfit of a line, in variances: of parallel ones at least, of converging ones at most.
constexpr double kParallelMisfit = 9.0;
constexpr double kMeetingMisfit = 2.5;

/// A point of the picture or, with a last coordinate of 0, a direction.
using Meeting = Vec3;

struct Line {
    std::array<int, 2> ends;
    Vec2 middle;
    Vec2 along;  ///< unit
    double length = 0.0;
    double error = 0.0;  ///< of its direction, standard deviation [rad]
};

struct Family {
    std::vector<int> lines;
    double px = 0.0;  ///< their lengths together, less where they miss it
};

class Families {
  public:
    Families(const EdgeGraph& graph, double spreadPx, std::size_t leastLines)
        : leastLines_(leastLines) {
        for (const GraphEdge& e : graph.edges) {
            const Vec2 a = graph.junctions[at(e.ends[0])].position;
            const Vec2 b = graph.junctions[at(e.ends[1])].position;
            box_.extend(a);
            box_.extend(b);
            const double length = (b - a).norm();
            if (length < 3.0 * spreadPx) continue;
            lines_.push_back({e.ends, 0.5 * (a + b), (b - a) / length, length,
                              std::numbers::sqrt2 * spreadPx / length});
        }
    }

    std::optional<Convergence> run() {
        if (lines_.size() < 8 || lines_.size() > kMostLines) return std::nullopt;
        std::vector<bool> used(lines_.size(), false);
        std::vector<Family> families;
        double px = 0.0;
        for (int k = 0; k < 3; ++k) {
            const Family family = largest(used);
            if (family.lines.size() < 2) break;
            for (const int l : family.lines) {
                used[at(l)] = true;
                px += lines_[at(l)].length;
            }
            families.push_back(family);
        }
        double all = 0.0;
        for (const Line& l : lines_) all += l.length;
        if (families.size() < 2 || px < kLeastShare * all) return std::nullopt;
        return told(families);
    }

  private:
    /// Angle between a line and the way from its middle to where it should meet others.
    double off(const Line& l, const Meeting& m) const {
        const Vec2 way = m.head<2>() - m.z() * l.middle;
        const double norm = way.norm();
        if (norm < 1e-9) return std::numbers::pi / 2.0;
        return std::asin(std::min(1.0, std::abs(cross2(l.along, way)) / norm));
    }

    bool joins(const Line& a, const Line& b) const {
        return a.ends[0] == b.ends[0] || a.ends[0] == b.ends[1] || a.ends[1] == b.ends[0] ||
               a.ends[1] == b.ends[1];
    }

    /// Where two lines meet; none where that is inside of the drawing.
    std::optional<Meeting> meetingOf(const Line& a, const Line& b) const {
        const double turn = cross2(a.along, b.along);
        const double angle = std::asin(std::min(1.0, std::abs(turn)));
        if (angle > kMostDeg * kRadian) return std::nullopt;
        if (angle < 1e-9) return Meeting(a.along.x(), a.along.y(), 0.0);
        const double t = cross2(Vec2(b.middle - a.middle), b.along) / turn;
        const Vec2 p = a.middle + t * a.along;
        if (box_.contains(p)) return std::nullopt;
        return Meeting(p.x(), p.y(), 1.0);
    }

    Family largest(const std::vector<bool>& used) const {
        Family best;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            for (std::size_t j = i + 1; j < lines_.size(); ++j) {
                if (used[i] || used[j] || joins(lines_[i], lines_[j])) continue;
                const auto meeting = meetingOf(lines_[i], lines_[j]);
                if (!meeting) continue;
                Family family = of(*meeting, used);
                if (family.px > best.px) best = std::move(family);
            }
        }
        return best;
    }

    /// Lines that point to a place, those that do best first; no two that share a corner.
    Family of(const Meeting& meeting, const std::vector<bool>& used) const {
        std::vector<std::pair<double, int>> near;
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            const double z = off(lines_[k], meeting) / lines_[k].error;
            if (!used[k] && z < kOwn) near.emplace_back(z, static_cast<int>(k));
        }
        std::sort(near.begin(), near.end());
        Family family;
        for (const auto& [z, k] : near) {
            const bool joined =
                std::any_of(family.lines.begin(), family.lines.end(),
                            [&](int other) { return joins(lines_[at(k)], lines_[at(other)]); });
            if (joined) continue;
            family.lines.push_back(k);
            family.px += lines_[at(k)].length * (1.0 - 0.5 * z / kOwn);
        }
        return family;
    }

    /// The point nearest to all lines of a family, by least squares; a direction where that fits
    /// better.
    Meeting fitted(const Family& f) const {
        Mat3 sum = Mat3::Zero();
        const double scale = box_.diagonal().norm();
        const Vec2 middle = box_.center();
        for (const int i : f.lines) {
            const Line& l = lines_[at(i)];
            const Vec2 p = (l.middle - middle) / scale;
            const Vec3 row(-l.along.y(), l.along.x(), cross2(p, l.along));
            sum += row * row.transpose() / (l.error * l.error);
        }
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(sum);
        Vec3 m = solver.eigenvectors().col(0);
        if (std::abs(m.z()) < 1e-6) return {m.x(), m.y(), 0.0};
        m /= m.z();
        const Vec2 p = middle + scale * m.head<2>();
        return {p.x(), p.y(), 1.0};
    }

    double misfit(const Family& f, const Meeting& m) const {
        double sum = 0.0;
        for (const int i : f.lines) {
            const double z = off(lines_[at(i)], m) / lines_[at(i)].error;
            sum += z * z;
        }
        return sum;
    }

    Meeting parallel(const Family& f) const {
        double c = 0.0;
        double s = 0.0;
        for (const int i : f.lines) {
            const Line& l = lines_[at(i)];
            const double twice = 2.0 * std::atan2(l.along.y(), l.along.x());
            const double weight = 1.0 / (l.error * l.error);
            c += weight * std::cos(twice);
            s += weight * std::sin(twice);
        }
        const double angle = 0.5 * std::atan2(s, c);
        return {std::cos(angle), std::sin(angle), 0.0};
    }

    void widen(Convergence& out, const Family& f) const {
        for (const int i : f.lines) {
            for (const int j : f.lines) {
                const Line& a = lines_[at(i)];
                const Line& b = lines_[at(j)];
                const double turn = std::min(1.0, std::abs(cross2(a.along, b.along)));
                const double degrees = std::asin(turn) / kRadian;
                if (degrees > out.degrees) out = {degrees, {a.middle, b.middle}};
            }
        }
    }

    /// Two lines always meet somewhere: only families of more say anything. One that converges may
    /// be the sides of a body that tapers.
    std::optional<Convergence> told(const std::vector<Family>& families) const {
        double meetingMisfit = 0.0;
        double lines = 0.0;
        int converge = 0;
        Convergence out;
        for (const Family& f : families) {
            if (f.lines.size() < leastLines_) continue;
            const double free = static_cast<double>(f.lines.size()) - 2.0;
            const Meeting meeting = fitted(f);
            meetingMisfit += misfit(f, meeting);
            lines += free;
            Convergence own;
            if (meeting.z() != 0.0) widen(own, f);
            if (own.degrees < kLeastDeg || misfit(f, parallel(f)) < kParallelMisfit * free)
                continue;
            ++converge;
            if (own.degrees > out.degrees) out = own;
        }
        if (converge < 2 || meetingMisfit > kMeetingMisfit * lines) return std::nullopt;
        return out;
    }

    std::size_t leastLines_;
    Eigen::AlignedBox2d box_;
    std::vector<Line> lines_;
};

}  // namespace

std::optional<Convergence> findConvergence(const EdgeGraph& graph, double spreadPx,
                                           std::size_t leastLines) {
    return Families(graph, spreadPx, leastLines).run();
}

std::optional<Convergence> findConvergence(const EdgeGraph& graph, const InkReading& ink,
                                           double distancePx, std::size_t leastLines) {
    const double noise = drawnNoisePx(graph, ink);
    return findConvergence(graph, std::hypot(noise, cornerSpread(ink, distancePx, noise)),
                           leastLines);
}

Error perspectiveError(const Convergence& found) {
    return {Errc::Perspective,
            "These lines converge as in perspective, by up to " +
                std::to_string(static_cast<int>(std::lround(found.degrees))) +
                " degrees. Only right-angled shapes are read so; draw edges that are parallel in "
                "space as parallel lines.",
            {found.where.begin(), found.where.end()}};
}

}  // namespace ew
