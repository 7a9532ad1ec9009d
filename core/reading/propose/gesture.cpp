// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/gesture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/edge_graph/line_ends.h"
#include "core/reading/extract/plane_geometry.h"
#include "core/stroke/consolidate.h"

namespace ew {
namespace {

constexpr std::size_t kMostLines = 25;
constexpr double kLeastLength = 2.0;  ///< of a line [distance thresholds]
constexpr double kLeastSine = 0.15;   ///< between two lines of a corner
constexpr double kSpacingPx = 1.6;    ///< of ink that is added
constexpr double kStraightSine = 0.14;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Lines and the places where their ends meet.
struct Wires {
    std::vector<InkLine> lines;
    std::vector<Vec2> nodes;               ///< [px]
    std::vector<std::array<int, 2>> ends;  ///< per line: nodes
    std::vector<std::vector<int>> around;  ///< per node: lines

    int other(int line, int node) const {
        return ends[at(line)][0] == node ? ends[at(line)][1] : ends[at(line)][0];
    }
    Vec2 along(int line, int from) const { return nodes[at(other(line, from))] - nodes[at(from)]; }
    int stroke(int line) const { return lines[at(line)].strokes.front(); }
};

/// What was drawn in two strokes, end to end, is one line.
void joinStraight(Wires& w) {
    for (std::size_t n = 0; n < w.nodes.size(); ++n) {
        if (w.around[n].size() != 2) continue;
        const int node = static_cast<int>(n);
        const int kept = std::min(w.around[n][0], w.around[n][1]);
        const int gone = std::max(w.around[n][0], w.around[n][1]);
        const Vec2 a = -w.along(kept, node).normalized();
        const Vec2 b = w.along(gone, node).normalized();
        const int end = w.other(gone, node);
        const bool straight = a.dot(b) > 0.0 && std::abs(cross2(a, b)) < kStraightSine;
        if (!straight || end == w.other(kept, node)) continue;
        w.ends[at(kept)] = {w.other(kept, node), end};
        std::replace(w.around[at(end)].begin(), w.around[at(end)].end(), gone, kept);
        w.around[n].clear();
        w.lines.erase(w.lines.begin() + gone);
        w.ends.erase(w.ends.begin() + gone);
        for (auto& lines : w.around) {
            for (int& l : lines) l -= l > gone ? 1 : 0;
        }
    }
    // Places where nothing ends any more.
    std::vector<int> number(w.nodes.size(), -1);
    std::size_t left = 0;
    for (std::size_t n = 0; n < w.nodes.size(); ++n) {
        if (w.around[n].empty()) continue;
        number[n] = static_cast<int>(left);
        w.nodes[left] = w.nodes[n];
        w.around[left] = w.around[n];
        ++left;
    }
    w.nodes.resize(left);
    w.around.resize(left);
    for (auto& ends : w.ends) {
        for (int& n : ends) n = number[at(n)];
    }
}

std::optional<Wires> wiresOf(const InkReading& ink, double distancePx) {
    Wires w;
    w.lines = consolidate(ink.segments, {distancePx});
    if (w.lines.size() < 3 || w.lines.size() > kMostLines) return std::nullopt;
    JoinOptions join;
    join.distancePx = distancePx;
    w.ends.assign(w.lines.size(), {-1, -1});
    for (const EndCluster& c : joinEnds(w.lines, join)) {
        w.around.emplace_back();
        for (const LineEnd& e : c.ends) {
            w.ends[at(e.line)][at(e.side)] = static_cast<int>(w.nodes.size());
            w.around.back().push_back(e.line);
        }
        w.nodes.push_back(c.position);
    }
    joinStraight(w);
    for (std::size_t i = 0; i < w.lines.size(); ++i) {
        const Vec2 d = w.nodes[at(w.ends[i][1])] - w.nodes[at(w.ends[i][0])];
        if (d.norm() < kLeastLength * distancePx) return std::nullopt;
    }
    return w;
}

class Completion {
  public:
    explicit Completion(const InkReading& ink) { out_.ink = ink; }

    void add(const Vec2& a, const Vec2& b, int stroke) {
        Segment s;
        s.a = a;
        s.b = b;
        s.stroke = stroke;
        s.inkPx = (b - a).norm();
        s.rmsPx = out_.ink.wobblePx;
        const int steps = std::max(1, static_cast<int>(s.inkPx / kSpacingPx));
        for (int k = 0; k <= steps; ++k) s.points.push_back(a + (b - a) * k / steps);
        out_.ink.segments.push_back(std::move(s));
        ++out_.added;
    }

    CompletedInk take() { return std::move(out_); }

  private:
    CompletedInk out_;
};

/// Do three directions point to all sides, as those from the near corner of a block do?
bool pointAllRound(const std::array<Vec2, 3>& d) {
    const double a = cross2(d[0], d[1]);
    const double b = cross2(d[1], d[2]);
    const double c = cross2(d[2], d[0]);
    return (a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0);
}

/// Three lines from a point.
std::optional<CompletedInk> block(const InkReading& ink, const Wires& w) {
    if (w.lines.size() != 3 || w.nodes.size() != 4) return std::nullopt;
    const auto corner = std::find_if(w.around.begin(), w.around.end(),
                                     [](const auto& lines) { return lines.size() == 3; });
    if (corner == w.around.end()) return std::nullopt;
    const int node = static_cast<int>(corner - w.around.begin());
    std::array<Vec2, 3> d;
    for (std::size_t k = 0; k < 3; ++k) d[k] = w.along((*corner)[k], node);
    for (std::size_t k = 0; k < 3; ++k) {
        const double sine = cross2(d[k].normalized(), d[(k + 1) % 3].normalized());
        if (std::abs(sine) < kLeastSine) return std::nullopt;
    }
    Completion completion(ink);
    const Vec2 p = w.nodes[at(node)];
    const auto stroke = [&](std::size_t k) { return w.stroke((*corner)[k]); };
    if (pointAllRound(d)) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (i != k) completion.add(p + d[i], p + d[i] + d[k], stroke(k));
            }
        }
        return completion.take();
    }
    // The point is on the outline; the line in the middle leads to the near corner.
    for (std::size_t m = 0; m < 3; ++m) {
        const std::size_t a = (m + 1) % 3;
        const std::size_t b = (m + 2) % 3;
        if (!pointAllRound({Vec2(-d[m]), d[a], d[b]})) continue;
        const Vec2 near = p + d[m];
        completion.add(near, near + d[a], stroke(a));
        completion.add(near, near + d[b], stroke(b));
        completion.add(near + d[a], p + d[a], stroke(m));
        completion.add(near + d[b], p + d[b], stroke(m));
        completion.add(near + d[a], near + d[a] + d[b], stroke(b));
        completion.add(near + d[b], near + d[a] + d[b], stroke(a));
        return completion.take();
    }
    return std::nullopt;
}

/// The corners of the one closed line, in order, and the lines between them.
struct Outline {
    std::vector<Vec2> corners;
    std::vector<int> strokes;  ///< of the line from each corner to the next one
};

std::optional<Outline> outlineOf(const Wires& w, int from, int without) {
    Outline out;
    std::vector<int> nodes;
    std::vector<int> lines;
    int node = from;
    int line = -1;
    do {
        int next = -1;
        for (const int l : w.around[at(node)]) {
            if (l != without && l != line) next = l;
        }
        if (next < 0 || nodes.size() > w.lines.size()) return std::nullopt;
        nodes.push_back(node);
        lines.push_back(next);
        line = next;
        node = w.other(line, node);
    } while (node != from);
    if (nodes.size() + 1 != w.lines.size()) return std::nullopt;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        out.corners.push_back(w.nodes[at(nodes[i])]);
        out.strokes.push_back(w.stroke(lines[i]));
    }
    if (out.corners.size() < 3) return std::nullopt;
    return out;
}

/// An outline and one line that leaves it.
std::optional<CompletedInk> prism(const InkReading& ink, const Wires& w) {
    int corner = -1;
    int tip = -1;
    for (std::size_t n = 0; n < w.nodes.size(); ++n) {
        const std::size_t degree = w.around[n].size();
        if (degree == 2) continue;
        int& place = degree == 3 ? corner : tip;
        if ((degree != 3 && degree != 1) || place >= 0) return std::nullopt;
        place = static_cast<int>(n);
    }
    if (corner < 0 || tip < 0 || w.other(w.around[at(tip)].front(), tip) != corner) {
        return std::nullopt;
    }
    const int depth = w.around[at(tip)].front();
    auto outline = outlineOf(w, corner, depth);
    if (!outline) return std::nullopt;
    const Vec2 d = w.along(depth, corner);
    const std::vector<Vec2>& p = outline->corners;
    if (insidePolygon(p, Vec2(w.nodes[at(corner)] + 0.25 * d))) return std::nullopt;
    // Seen are the sides that the outline does not hide: those behind an edge that looks along the
    // depth. What bends inwards may hide some of them in part.
    const double turn = areaOf(p) > 0.0 ? 1.0 : -1.0;
    const std::size_t n = p.size();
    std::vector<bool> seen(n, false);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 side = p[(i + 1) % n] - p[i];
        const Vec2 before = p[i] - p[(i + n - 1) % n];
        if (turn * cross2(before, side) < 0.0) return std::nullopt;
        seen[i] = turn * cross2(side, d) < -kLeastSine * side.norm() * d.norm();
        const bool along = std::abs(cross2(side, d)) <= kLeastSine * side.norm() * d.norm();
        if (along) return std::nullopt;
    }
    Completion completion(ink);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = (i + n - 1) % n;
        if (seen[i]) completion.add(p[i] + d, p[(i + 1) % n] + d, outline->strokes[i]);
        const bool isDrawn = (p[i] - w.nodes[at(corner)]).norm() < 1e-9;
        if ((seen[i] || seen[before]) && !isDrawn) completion.add(p[i], p[i] + d, w.stroke(depth));
        if (isDrawn && !seen[i] && !seen[before]) return std::nullopt;
    }
    return completion.take();
}

}  // namespace

std::vector<CompletedInk> completedGestures(const InkReading& ink, double distancePx) {
    std::vector<CompletedInk> out;
    // A curve or a scribble is one line more.
    const bool lines = std::all_of(ink.noise.begin(), ink.noise.end(),
                                   [](const NoiseItem& n) { return n.kind == NoiseKind::Dot; });
    if (!lines) return out;
    const auto wires = wiresOf(ink, distancePx);
    if (!wires) return out;
    for (auto&& way : {block(ink, *wires), prism(ink, *wires)}) {
        if (way) out.push_back(*way);
    }
    return out;
}

}  // namespace ew
