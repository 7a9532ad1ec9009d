// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/extract/joint_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }
constexpr double kRadian = 180.0 / std::numbers::pi;

struct Span {
    double lo, hi;
};

class Extraction {
  public:
    Extraction(const InkReading& ink, const ModelView& model, const ExtractOptions& options)
        : model_(model),
          distance_(options.thresholds.distancePx),
          angle_(options.thresholds.angleDeg),
          options_(options),
          redrawn_(model.pieces().size()),
          stops_(model.pieces().size()) {
        for (const Segment& s : ink.segments) reach_.extend(s.a).extend(s.b);
        near_ = model_.piecesNear(withinReach());
        for (InkLine& line : consolidate(ink.segments, {distance_, options.reading.mergeScale})) {
            if (!options.redraws || !runsAlong(line)) out_.lines.push_back(std::move(line));
        }
    }

    JointGraph run() {
        const JoinOptions join{distance_, options_.reading.joinScale, options_.reading.breakReach};
        const auto clusters = joinEnds(out_.lines, join);
        raw_ = planarize(out_.lines, clusters, {join, options_.reading.throughReach});
        for (const Vec2& v : raw_.vertices) reach_.extend(v);
        near_ = model_.piecesNear(withinReach());
        inkEdges();
        modelEdges();
        keepShortWays();
        return std::move(out_);
    }

  private:
    /// What ink may touch.
    Eigen::AlignedBox2d withinReach() const {
        const Vec2 more = Vec2::Constant(2.0 * distance_);
        return {reach_.min() - more, reach_.max() + more};
    }

    /// What ink may touch, and the edges that go on from there: those between two that it touches
    /// are among them.
    std::vector<std::size_t> nearAndNext() const {
        std::vector<bool> ended(model_.solid().vertices().size(), false);
        const auto eachCorner = [&](std::size_t q, auto&& what) {
            for (const PieceEnd& end : model_.pieces()[q].ends) {
                if (end.kind == PieceEnd::Kind::Vertex) what(at(end.index));
            }
        };
        std::vector<bool> taken(model_.pieces().size(), false);
        for (const std::size_t q : near_) {
            taken[q] = true;
            eachCorner(q, [&](std::size_t v) { ended[v] = true; });
        }
        std::vector<std::size_t> all;
        for (std::size_t q = 0; q < taken.size(); ++q) {
            bool take = taken[q];
            eachCorner(q, [&](std::size_t v) { take = take || ended[v]; });
            if (take) all.push_back(q);
        }
        return all;
    }

    /// A stroke along a model edge is that edge.
    bool runsAlong(const InkLine& line) {
        int best = -1;
        double least = std::numeric_limits<double>::infinity();
        Span span{};
        const double slack = std::atan(0.5 * distance_ / std::max(line.length(), 1.0)) * kRadian;
        for (const std::size_t p : near_) {
            const VisiblePiece& piece = model_.pieces()[p];
            const Vec2 u = piece.px[1] - piece.px[0];
            const double len = u.norm();
            if (piece.point || len < 1e-6) continue;
            const Vec2 d = u / len;
            const double off = std::max(std::abs(cross2(d, line.a - piece.px[0])),
                                        std::abs(cross2(d, line.b - piece.px[0])));
            const double turn =
                std::asin(std::min(1.0, std::abs(cross2(d, line.direction())))) * kRadian;
            if (off > tol::kAlongModel * distance_ || turn > angle_ + slack) continue;
            const double ta = (line.a - piece.px[0]).dot(d);
            const double tb = (line.b - piece.px[0]).dot(d);
            const double lo = std::max(0.0, std::min(ta, tb));
            const double hi = std::min(len, std::max(ta, tb));
            // Most of the stroke has to lie beside the edge.
            if (hi - lo < std::max(0.0, line.length() - 2 * distance_) || hi - lo <= 0) continue;
            if (hi - lo < 0.5 * line.length()) continue;
            if (off < least) {
                least = off;
                best = static_cast<int>(p);
                span = {lo / len, hi / len};
            }
        }
        if (best < 0) return false;
        redrawn_[at(best)].push_back(span);
        out_.touches = true;
        out_.redraws = true;
        return true;
    }

    void inkEdges() {
        node_.assign(raw_.vertices.size(), -1);
        const auto incidence = raw_.incidence();
        for (std::size_t v = 0; v < incidence.size(); ++v) {
            if (!incidence[v].empty()) node_[v] = anchored(static_cast<int>(v), incidence[v]);
        }
        for (const RawGraph::Edge& e : raw_.edges) {
            if (!e.alive) continue;
            JointEdge edge;
            edge.nodes = {node_[at(e.v[0])], node_[at(e.v[1])]};
            edge.pieces = e.pieces;
            if (edge.nodes[0] != edge.nodes[1]) out_.edges.push_back(std::move(edge));
        }
        out_.inkEdges = out_.edges.size();
    }

    /// The node of an ink vertex: at a corner of the solid, on an edge, or by itself.
    int anchored(int v, const std::vector<int>& around) {
        const Vec2 p = raw_.vertices[at(v)];
        int corner = -1;
        double nearest = distance_;
        for (const std::size_t q : near_) {
            const VisiblePiece& piece = model_.pieces()[q];
            for (std::size_t s = 0; s < 2; ++s) {
                if (piece.ends[s].kind != PieceEnd::Kind::Vertex) continue;
                const double d = (piece.px[s] - p).norm();
                if (d <= nearest) {
                    nearest = d;
                    corner = piece.ends[s].index;
                }
            }
        }
        if (corner >= 0) {
            const int n = cornerNode(corner);
            out_.nodes[at(n)].ink = true;
            out_.touches = true;
            return n;
        }
        int best = -1;
        double least = std::numeric_limits<double>::infinity();
        double share = 0;
        for (const std::size_t q : near_) {
            const auto hit = onPiece(model_.pieces()[q], p, around);
            if (!hit || hit->cost >= least) continue;
            least = hit->cost;
            best = static_cast<int>(q);
            share = hit->share;
        }
        JointNode node;
        node.ink = true;
        node.px = p;
        const int n = static_cast<int>(out_.nodes.size());
        if (best >= 0) {
            const VisiblePiece& piece = model_.pieces()[at(best)];
            node.px = piece.px[0] + share * (piece.px[1] - piece.px[0]);
            node.modelEdge = piece.edge;
            stops_[at(best)].push_back({share, n});
            out_.touches = true;
        }
        out_.nodes.push_back(node);
        return n;
    }

    struct Hit {
        double cost, share;
    };
    /// Where on a model edge strokes meet that end near p: each stroke is precise across its line.
    std::optional<Hit> onPiece(const VisiblePiece& piece, const Vec2& p,
                               const std::vector<int>& around) const {
        const Vec2 u = piece.px[1] - piece.px[0];
        const double len = u.norm();
        if (piece.point || len < 1e-6) return std::nullopt;
        const Vec2 d = u / len;
        if (std::abs(cross2(d, p - piece.px[0])) > distance_) return std::nullopt;
        const double wAcross = 1.0 / std::pow(tol::kEndSpreadAcross * distance_, 2);
        const double wAlong = 1.0 / std::pow(tol::kEndSpreadAlong * distance_, 2);
        double a = 0;
        double b = 0;
        for (const int e : around) {
            const RawGraph::Edge& edge = raw_.edges[at(e)];
            const InkLine& line = out_.lines[at(edge.pieces.front().line)];
            const Vec2 dir = line.direction();
            const Vec2 side(-dir.y(), dir.x());
            const Vec2 tip = (line.a - p).norm() < (line.b - p).norm() ? line.a : line.b;
            const Eigen::Matrix2d w =
                wAcross * side * side.transpose() + wAlong * dir * dir.transpose();
            a += d.dot(w * d);
            b += d.dot(w * (tip - piece.px[0]));
        }
        if (a <= 0) return std::nullopt;
        const double t = b / a;
        const Vec2 x = piece.px[0] + t * d;
        const double off = (x - p).norm();
        if (t < 0 || t > len || off > 1.5 * distance_) return std::nullopt;
        return Hit{off, t / len};
    }

    int cornerNode(int vertex) {
        const auto [it, added] = corner_.emplace(vertex, static_cast<int>(out_.nodes.size()));
        if (added) {
            JointNode node;
            node.px = model_.view().points()[at(vertex)];
            node.modelVertex = vertex;
            out_.nodes.push_back(node);
        }
        return it->second;
    }

    void modelEdges() {
        for (const std::size_t q : nearAndNext()) {
            const VisiblePiece& piece = model_.pieces()[q];
            if (piece.point) continue;
            auto& stops = stops_[q];
            for (std::size_t s = 0; s < 2; ++s) {
                int n = -1;
                if (piece.ends[s].kind == PieceEnd::Kind::Vertex) {
                    n = cornerNode(piece.ends[s].index);
                } else {
                    n = static_cast<int>(out_.nodes.size());
                    JointNode node;
                    node.px = piece.px[s];
                    node.modelEdge = piece.edge;
                    out_.nodes.push_back(node);
                }
                stops.push_back({static_cast<double>(s), n});
            }
            std::sort(stops.begin(), stops.end());
            for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
                if (stops[i].second == stops[i + 1].second) continue;
                JointEdge edge;
                edge.nodes = {stops[i].second, stops[i + 1].second};
                edge.modelEdge = piece.edge;
                const double width = std::max(stops[i + 1].first - stops[i].first, 1e-9);
                for (const Span& s : redrawn_[q]) {
                    const double covered =
                        std::min(s.hi, stops[i + 1].first) - std::max(s.lo, stops[i].first);
                    edge.redrawn = std::max(edge.redrawn, covered / width);
                }
                out_.edges.push_back(std::move(edge));
            }
        }
    }

    /// Drops model edges that lie on no way of up to three between two places where strokes meet
    /// the solid.
    void keepShortWays() {
        std::vector<std::vector<int>> around(out_.nodes.size());
        for (std::size_t e = out_.inkEdges; e < out_.edges.size(); ++e) {
            for (const int n : out_.edges[e].nodes) around[at(n)].push_back(static_cast<int>(e));
        }
        std::set<std::vector<int>> ways;
        std::vector<int> way;
        const std::function<void(int, int)> walk = [&](int start, int n) {
            if (!way.empty() && out_.nodes[at(n)].ink) {
                if (n == start) return;
                std::vector<int> found = way;
                std::sort(found.begin(), found.end());
                ways.insert(std::move(found));
                return;
            }
            if (way.size() == kLongestWay) return;
            for (const int e : around[at(n)]) {
                if (std::find(way.begin(), way.end(), e) != way.end()) continue;
                const auto& ends = out_.edges[at(e)].nodes;
                way.push_back(e);
                walk(start, ends[0] == n ? ends[1] : ends[0]);
                way.pop_back();
            }
        };
        for (std::size_t n = 0; n < out_.nodes.size(); ++n) {
            if (out_.nodes[n].ink) walk(static_cast<int>(n), static_cast<int>(n));
        }
        std::vector<int> number(out_.edges.size(), -1);
        for (const auto& w : ways) {
            for (const int e : w) number[at(e)] = 0;
        }
        std::vector<JointEdge> kept;
        for (std::size_t e = 0; e < out_.edges.size(); ++e) {
            if (e >= out_.inkEdges && number[e] < 0) continue;
            number[e] = static_cast<int>(kept.size());
            kept.push_back(std::move(out_.edges[e]));
        }
        out_.edges = std::move(kept);
        for (std::vector<int> w : ways) {
            for (int& e : w) e = number[at(e)];
            out_.ways.push_back(std::move(w));
        }
        std::stable_sort(out_.ways.begin(), out_.ways.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
    }

    static constexpr std::size_t kLongestWay = 3;

    const ModelView& model_;
    double distance_;
    double angle_;
    const ExtractOptions& options_;
    JointGraph out_;
    RawGraph raw_;
    Eigen::AlignedBox2d reach_;      ///< of the ink and its joints
    std::vector<std::size_t> near_;  ///< pieces that it may touch
    std::vector<int> node_;
    std::map<int, int> corner_;
    std::vector<std::vector<Span>> redrawn_;
    std::vector<std::vector<std::pair<double, int>>> stops_;
};

}  // namespace

JointGraph extractJointGraph(const InkReading& ink, const ModelView& model,
                             const ExtractOptions& options) {
    return Extraction(ink, model, options).run();
}

}  // namespace ew
