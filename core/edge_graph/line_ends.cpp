// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/line_ends.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Vec2 tip(const InkLine& line, int side) { return side == 0 ? line.a : line.b; }
/// Unit direction in which the line would go on past this end.
Vec2 outward(const InkLine& line, int side) {
    return side == 0 ? Vec2(-line.direction()) : line.direction();
}

struct Fit {
    Vec2 position;
    double cost;  ///< rms distance in units of the spread of a stroke end
};

/// The middle of a gap between two ends that point at each other: a line drawn in two strokes.
/// There the lines' directions say nothing about where they meet.
std::optional<Fit> tryBridge(const std::vector<InkLine>& lines, const LineEnd& a, const LineEnd& b,
                             const JoinOptions& options) {
    const InkLine& la = lines[at(a.line)];
    const InkLine& lb = lines[at(b.line)];
    if (outward(la, a.side).dot(outward(lb, b.side)) > -tol::kBreakCosine) return std::nullopt;
    const Vec2 gap = tip(lb, b.side) - tip(la, a.side);
    const Vec2 axis =
        (outward(la, a.side) * la.length() - outward(lb, b.side) * lb.length()).normalized();
    const double beside = std::abs(cross2(axis, gap));
    const double along = axis.dot(gap);  // negative where they overlap
    const double shorter = std::min(la.length(), lb.length());
    if (beside > std::min(tol::kBreakBeside * options.distancePx, 0.5 * shorter) ||
        std::abs(along) > options.breakReach * options.distancePx * options.scale ||
        along < -0.5 * shorter) {
        return std::nullopt;
    }
    const double cost = std::hypot(beside / (2 * tol::kEndSpreadAcross * options.distancePx),
                                   along / (2 * tol::kEndSpreadAlong * options.distancePx));
    return Fit{0.5 * (tip(la, a.side) + tip(lb, b.side)), cost};
}

/// The merged cluster's meeting point, or nothing where an end would be out of reach.
std::optional<Fit> tryJoin(const std::vector<InkLine>& lines, const EndCluster& a,
                           const EndCluster& b, const JoinOptions& options) {
    std::vector<LineEnd> ends = a.ends;
    ends.insert(ends.end(), b.ends.begin(), b.ends.end());
    for (std::size_t i = 0; i < ends.size(); ++i) {
        for (std::size_t j = i + 1; j < ends.size(); ++j) {
            if (ends[i].line == ends[j].line) return std::nullopt;
        }
    }
    Vec2 x = meetingPoint(lines, ends, options.distancePx);
    auto allReach = [&](double share) {
        return std::all_of(ends.begin(), ends.end(), [&](const LineEnd& e) {
            const InkLine& line = lines[at(e.line)];
            return endDistance(line, e.side, x) <= share * joinReach(line, options);
        });
    };
    double sum = 0;
    if (!allReach(1.0)) {
        // Ends that lie together although their lines, being short or wavy, point past each other.
        x = Vec2::Zero();
        for (const LineEnd& e : ends) x += tip(lines[at(e.line)], e.side);
        x /= static_cast<double>(ends.size());
        const double widest = tol::kTipsTogether * options.distancePx * options.scale;
        for (const LineEnd& e : ends) {
            for (const LineEnd& f : ends) {
                if ((tip(lines[at(e.line)], e.side) - tip(lines[at(f.line)], f.side)).norm() >
                    widest) {
                    return std::nullopt;
                }
            }
        }
        if (!allReach(0.75)) return std::nullopt;
        sum = 2.0 * static_cast<double>(ends.size());
    }
    for (const LineEnd& e : ends) {
        const InkLine& line = lines[at(e.line)];
        const Vec2 d = x - tip(line, e.side);
        const Vec2 dir = line.direction();
        const double across = cross2(dir, d) / (tol::kEndSpreadAcross * options.distancePx);
        const double along = dir.dot(d) / (tol::kEndSpreadAlong * options.distancePx);
        sum += across * across + along * along;
    }
    return Fit{x, std::sqrt(sum / static_cast<double>(ends.size()))};
}

struct Proposal {
    double cost;
    int a, b;
    int versionA, versionB;
    bool operator<(const Proposal& o) const { return cost > o.cost; }  // least cost on top
};

}  // namespace

double joinReach(const InkLine& line, const JoinOptions& options) {
    return std::min(options.distancePx * options.scale, tol::kJoinLengthShare * line.length());
}

double endDistance(const InkLine& line, int side, const Vec2& junction) {
    const Vec2 d = tip(line, side) - junction;
    const double past = d.dot(outward(line, side));
    const double across = cross2(line.direction(), d);
    return std::hypot(past > 0 ? tol::kOvershootDiscount * past : past, across);
}

Vec2 meetingPoint(const std::vector<InkLine>& lines, const std::vector<LineEnd>& ends,
                  double distancePx) {
    if (ends.size() == 1) return tip(lines[at(ends[0].line)], ends[0].side);
    const double wAcross = 1.0 / std::pow(tol::kEndSpreadAcross * distancePx, 2);
    const double wAlong = 1.0 / std::pow(tol::kEndSpreadAlong * distancePx, 2);
    Eigen::Matrix2d m = Eigen::Matrix2d::Zero();
    Vec2 r = Vec2::Zero();
    for (const LineEnd& e : ends) {
        const InkLine& line = lines[at(e.line)];
        const Vec2 d = line.direction();
        const Vec2 n(-d.y(), d.x());
        const Eigen::Matrix2d w = wAcross * n * n.transpose() + wAlong * d * d.transpose();
        m += w;
        r += w * tip(line, e.side);
    }
    return m.inverse() * r;
}

std::vector<EndCluster> joinEnds(const std::vector<InkLine>& lines, const JoinOptions& options) {
    std::vector<EndCluster> clusters;
    for (std::size_t l = 0; l < lines.size(); ++l) {
        for (int side = 0; side < 2; ++side) {
            clusters.push_back({tip(lines[l], side), {{static_cast<int>(l), side}}});
        }
    }
    const double pairReach =
        std::max(2.6, options.breakReach + 1.0) * options.distancePx * options.scale;
    std::vector<int> version(clusters.size(), 0);
    std::vector<std::vector<int>> near(clusters.size());
    std::priority_queue<Proposal> queue;
    auto propose = [&](int a, int b) {
        const EndCluster& ca = clusters[at(a)];
        const EndCluster& cb = clusters[at(b)];
        auto fit = tryJoin(lines, ca, cb, options);
        if (!fit && ca.ends.size() == 1 && cb.ends.size() == 1 &&
            ca.ends[0].line != cb.ends[0].line) {
            fit = tryBridge(lines, ca.ends[0], cb.ends[0], options);
        }
        if (fit) queue.push({fit->cost, a, b, version[at(a)], version[at(b)]});
    };
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        for (std::size_t j = i + 1; j < clusters.size(); ++j) {
            if ((clusters[i].position - clusters[j].position).norm() > pairReach) continue;
            near[i].push_back(static_cast<int>(j));
            near[j].push_back(static_cast<int>(i));
            propose(static_cast<int>(i), static_cast<int>(j));
        }
    }
    while (!queue.empty()) {
        const Proposal p = queue.top();
        queue.pop();
        if (p.versionA != version[at(p.a)] || p.versionB != version[at(p.b)]) continue;
        EndCluster& a = clusters[at(p.a)];
        EndCluster& b = clusters[at(p.b)];
        a.ends.insert(a.ends.end(), b.ends.begin(), b.ends.end());
        const auto meeting = tryJoin(lines, {a.position, a.ends}, {}, options);
        a.position = meeting ? meeting->position : Vec2(0.5 * (a.position + b.position));
        b.ends.clear();
        ++version[at(p.a)];
        ++version[at(p.b)];
        std::vector<int> around = near[at(p.a)];
        around.insert(around.end(), near[at(p.b)].begin(), near[at(p.b)].end());
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        std::erase(around, p.a);
        std::erase(around, p.b);
        near[at(p.a)] = around;
        for (const int c : around) {
            near[at(c)].push_back(p.a);
            if (!clusters[at(c)].ends.empty()) propose(p.a, c);
        }
    }
    std::erase_if(clusters, [](const EndCluster& c) { return c.ends.empty(); });
    return clusters;
}

}  // namespace ew
