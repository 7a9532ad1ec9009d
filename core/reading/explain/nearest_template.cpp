// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/explain/nearest_template.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr int kNone = -1;
constexpr int kMostSteps = 20'000;  // of one comparison; a few hundred are usual

/// The drawing as corners and lines: the Edge Graph, and the lines that are attached at one end
/// only, which run to where they should have met.
struct Drawn {
    struct Line {
        int to = kNone;
        int edge = kNone;  ///< of the Edge Graph, kNone for a line with an open end
    };
    std::vector<Vec2> corners;
    std::vector<std::vector<Line>> lines;  ///< per corner
    int openLines = 0;

    Drawn(const EdgeGraph& graph, double distancePx) : reachPx(distancePx) {
        for (const Junction& j : graph.junctions) add(j.position);
        for (std::size_t e = 0; e < graph.edges.size(); ++e) {
            join(graph.edges[e].ends[0], graph.edges[e].ends[1], static_cast<int>(e));
        }
        for (std::size_t e = 0; e < graph.dangling.size(); ++e) {
            const DanglingEdge& d = graph.dangling[e];
            std::array<Vec2, 2> ends = d.ends;
            for (const OpenEnd& o : graph.openEnds) {
                if (o.edge != static_cast<int>(e)) continue;
                ends[(o.tip - d.ends[0]).norm() < (o.tip - d.ends[1]).norm() ? 0 : 1] = o.target;
            }
            const int a = d.junction >= 0 ? d.junction : cornerAt(ends[0]);
            const int b = cornerAt(ends[1]);
            if (a == b || joined(a, b)) continue;
            join(a, b, kNone);
            ++openLines;
        }
    }

    const Line* joined(int a, int b) const {
        for (const Line& l : lines[at(a)]) {
            if (l.to == b) return &l;
        }
        return nullptr;
    }

  private:
    int add(const Vec2& p) {
        corners.push_back(p);
        lines.emplace_back();
        return static_cast<int>(corners.size()) - 1;
    }
    int cornerAt(const Vec2& p) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if ((corners[i] - p).norm() <= reachPx) return static_cast<int>(i);
        }
        return add(p);
    }
    void join(int a, int b, int edge) {
        lines[at(a)].push_back({b, edge});
        lines[at(b)].push_back({a, edge});
    }

    double reachPx;
};

/// An affine map from points of any dimension to the sheet, by least squares.
class SheetMap {
  public:
    SheetMap(const std::vector<Eigen::VectorXd>& from, const std::vector<Vec2>& to) {
        if (from.empty()) return;
        const auto n = static_cast<Eigen::Index>(from.size());
        const Eigen::Index size = from.front().size() + 1;
        Eigen::MatrixXd a(n, size);
        Eigen::MatrixXd b(n, 2);
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto k = static_cast<std::size_t>(i);
            a.row(i) << from[k].transpose(), 1.0;
            b.row(i) = to[k].transpose();
        }
        // The shortest solution: few corners do not fix every direction.
        map_ = a.completeOrthogonalDecomposition().solve(b);
        rmsPx_ = std::sqrt((a * map_ - b).squaredNorm() / static_cast<double>(n));
    }
    Vec2 operator()(const Eigen::VectorXd& p) const {
        if (map_.size() == 0) return Vec2::Zero();
        return (map_.topRows(p.size()).transpose() * p + map_.bottomRows(1).transpose());
    }
    double rmsPx() const { return rmsPx_; }

  private:
    Eigen::MatrixXd map_;
    double rmsPx_ = 0.0;
};

/// Looks for the corners of an aspect among those that are drawn, so that as many of its edges as
/// can be are drawn lines.
class Laying {
  public:
    Laying(const Drawn& drawn, const LibraryEntry& entry, const Aspect& aspect)
        : drawn_(drawn), entry_(entry), aspect_(aspect), around_(aspect.graph.points.size()) {
        for (const auto& e : aspect.graph.edges) {
            around_[at(e[0])].push_back(e[1]);
            around_[at(e[1])].push_back(e[0]);
        }
        orderCorners();
        corner_.assign(around_.size(), kNone);
        used_.assign(drawn.corners.size(), false);
        // Few lines are missing where it is the nearest; then there is little to look through.
        const int all = static_cast<int>(aspect.graph.edges.size());
        for (mostLost_ = 0; mostLost_ <= all && best_.empty(); ++mostLost_) step(0, 0, 0);
    }

    std::optional<AspectDifference> difference(std::size_t graphEdges) const;

  private:
    void orderCorners();
    void step(std::size_t k, int lost, int lacking);
    void tryCorner(std::size_t k, int lost, int lacking, int corner);
    bool isWorthIt(int lost, int lacking) const {
        return lost <= mostLost_ && lacking <= 2 * mostLost_;
    }
    int gainOf(int v, int corner) const;
    SheetMap shapeMap(const std::vector<int>& corner) const;
    SheetMap flatMap() const;

    const Drawn& drawn_;
    const LibraryEntry& entry_;
    const Aspect& aspect_;
    std::vector<std::vector<int>> around_;
    std::vector<int> order_;
    std::vector<int> earlier_;  ///< per place in order_: edges to corners before it
    std::vector<int> corner_;   ///< per corner of the aspect: the drawn one
    std::vector<bool> used_;
    std::vector<int> best_;
    double bestOff_ = std::numeric_limits<double>::infinity();
    int mostLost_ = 0;
    int stepsLeft_ = kMostSteps;
};

/// Each corner after one that it is joined to, the one with most edges first.
void Laying::orderCorners() {
    const auto n = around_.size();
    std::vector<bool> listed(n, false);
    const auto busiest = [&](bool joinedOnly) {
        int found = kNone;
        for (std::size_t v = 0; v < n; ++v) {
            const bool joined = std::any_of(around_[v].begin(), around_[v].end(),
                                            [&](int u) { return listed[at(u)]; });
            if (listed[v] || (joinedOnly && !joined)) continue;
            if (found == kNone || around_[v].size() > around_[at(found)].size()) {
                found = static_cast<int>(v);
            }
        }
        return found;
    };
    while (order_.size() < n) {
        int next = busiest(true);
        if (next == kNone) next = busiest(false);
        listed[at(next)] = true;
        order_.push_back(next);
    }
    earlier_.assign(n, 0);
    std::fill(listed.begin(), listed.end(), false);
    for (std::size_t k = 0; k < n; ++k) {
        for (const int u : around_[at(order_[k])]) earlier_[k] += listed[at(u)] ? 1 : 0;
        listed[at(order_[k])] = true;
    }
}

int Laying::gainOf(int v, int corner) const {
    int gain = 0;
    for (const int u : around_[at(v)]) {
        const int other = corner_[at(u)];
        if (other != kNone && drawn_.joined(corner, other) != nullptr) ++gain;
    }
    return gain;
}

/// \param lost     edges so far that are not drawn.
/// \param lacking  lines that the corners so far lack; each edge that is lost has two ends.
void Laying::step(std::size_t k, int lost, int lacking) {
    if (!isWorthIt(lost, lacking) || stepsLeft_-- <= 0) return;
    if (k == order_.size()) {
        const double off = shapeMap(corner_).rmsPx();
        if (off >= bestOff_) return;
        bestOff_ = off;
        best_ = corner_;
        return;
    }
    const int v = order_[k];
    std::vector<std::array<int, 2>> choices;  // gain, corner
    for (std::size_t c = 0; c < used_.size(); ++c) {
        const int gain = used_[c] ? 0 : gainOf(v, static_cast<int>(c));
        // Also one without a line to the corners so far: that line may be missing.
        if (!used_[c] && lost + earlier_[k] - gain <= mostLost_) {
            choices.push_back({gain, static_cast<int>(c)});
        }
    }
    std::stable_sort(choices.begin(), choices.end(),
                     [](const auto& a, const auto& b) { return a[0] > b[0]; });
    for (const auto& [gain, corner] : choices) {
        tryCorner(k, lost + earlier_[k] - gain, lacking, corner);
    }
    const auto edges = static_cast<int>(around_[at(v)].size());
    step(k + 1, lost + earlier_[k], lacking + edges);  // it is not drawn
}

void Laying::tryCorner(std::size_t k, int lost, int lacking, int corner) {
    const int v = order_[k];
    const auto drawn = static_cast<int>(drawn_.lines[at(corner)].size());
    const auto wanted = static_cast<int>(around_[at(v)].size());
    corner_[at(v)] = corner;
    used_[at(corner)] = true;
    step(k + 1, lost, lacking + std::max(0, wanted - drawn));
    used_[at(corner)] = false;
    corner_[at(v)] = kNone;
}

/// A parallel view of the template: it keeps what is parallel, whatever its proportions are.
SheetMap Laying::shapeMap(const std::vector<int>& corner) const {
    std::vector<Eigen::VectorXd> from;
    std::vector<Vec2> to;
    for (std::size_t v = 0; v < corner.size(); ++v) {
        if (corner[v] == kNone || aspect_.vertex[v] < 0) continue;
        from.emplace_back(entry_.tmpl.shape.vertices[at(aspect_.vertex[v])]);
        to.push_back(drawn_.corners[at(corner[v])]);
    }
    return {from, to};
}

/// The same for corners that are no vertices of the template: a line ends on another one there.
SheetMap Laying::flatMap() const {
    std::vector<Eigen::VectorXd> from;
    std::vector<Vec2> to;
    for (std::size_t v = 0; v < best_.size(); ++v) {
        if (best_[v] == kNone) continue;
        from.emplace_back(aspect_.graph.points[v]);
        to.push_back(drawn_.corners[at(best_[v])]);
    }
    return {from, to};
}

std::optional<AspectDifference> Laying::difference(std::size_t graphEdges) const {
    if (best_.empty()) return std::nullopt;
    AspectDifference out;
    out.offPx = bestOff_;
    out.strays = drawn_.openLines;
    const SheetMap shape = shapeMap(best_);
    const SheetMap flat = flatMap();
    const auto placeOf = [&](int v) {
        if (best_[at(v)] != kNone) return drawn_.corners[at(best_[at(v)])];
        const int vertex = aspect_.vertex[at(v)];
        return vertex >= 0 ? shape(entry_.tmpl.shape.vertices[at(vertex)])
                           : flat(aspect_.graph.points[at(v)]);
    };
    std::vector<bool> explained(graphEdges, false);
    for (const auto& e : aspect_.graph.edges) {
        const int a = best_[at(e[0])];
        const int b = best_[at(e[1])];
        const Drawn::Line* line = a != kNone && b != kNone ? drawn_.joined(a, b) : nullptr;
        if (line == nullptr) {
            out.missing.push_back({placeOf(e[0]), placeOf(e[1])});
        } else if (line->edge != kNone) {
            explained[at(line->edge)] = true;
        } else {
            --out.strays;
        }
    }
    for (std::size_t e = 0; e < graphEdges; ++e) {
        if (!explained[e]) out.extra.push_back(static_cast<int>(e));
    }
    return out;
}

}  // namespace

std::optional<AspectDifference> compare(const EdgeGraph& graph, const LibraryEntry& entry,
                                        const Aspect& aspect, double distancePx) {
    const Drawn drawn(graph, distancePx);
    return Laying(drawn, entry, aspect).difference(graph.edges.size());
}

std::vector<int> junctionDegrees(const EdgeGraph& graph) {
    std::vector<int> degrees(graph.junctions.size(), 0);
    for (const GraphEdge& e : graph.edges) {
        ++degrees[at(e.ends[0])];
        ++degrees[at(e.ends[1])];
    }
    return degrees;
}

namespace {

/// An aspect, and how far its corners are from those drawn.
struct Similar {
    double off = 0.0;
    const LibraryEntry* entry = nullptr;
    const Aspect* aspect = nullptr;
    std::array<int, 6> degrees{};
};
constexpr std::size_t kMostCompared = 6;

std::array<int, 6> histogram(const std::vector<int>& degrees) {
    std::array<int, 6> h{};
    for (const int d : degrees) ++h[at(std::min(d, 5))];
    return h;
}

std::vector<Similar> similarAspects(const EdgeGraph& graph, const TemplateLibrary& library) {
    std::vector<int> mine = junctionDegrees(graph);
    // A line with an open end is one that is drawn.
    for (const DanglingEdge& d : graph.dangling) {
        if (d.junction >= 0) ++mine[at(d.junction)];
        mine.push_back(2);
    }
    const auto ours = histogram(mine);
    const auto linesDrawn = static_cast<double>(graph.edges.size() + graph.dangling.size());
    std::vector<Similar> similar;
    for (const auto& entry : library.index().entries) {
        for (const Aspect& a : entry->aspects) {
            if (a.edgeOn) continue;  // fits little ink, and is a question at best
            std::vector<int> d(a.vertex.size(), 0);
            for (const auto& e : a.graph.edges) {
                ++d[at(e[0])];
                ++d[at(e[1])];
            }
            const auto theirs = histogram(d);
            double off = 0;
            for (std::size_t i = 0; i < ours.size(); ++i) off += std::abs(ours[i] - theirs[i]);
            off += 0.5 * std::abs(static_cast<double>(a.graph.edges.size()) - linesDrawn) +
                   0.5 * std::abs(static_cast<double>(a.vertex.size()) -
                                  static_cast<double>(mine.size()));
            similar.push_back({off, entry.get(), &a, theirs});
        }
    }
    std::stable_sort(similar.begin(), similar.end(),
                     [](const Similar& a, const Similar& b) { return a.off < b.off; });
    if (similar.size() > kMostCompared) similar.resize(kMostCompared);
    return similar;
}

}  // namespace

std::optional<Nearest> nearestTemplate(const EdgeGraph& graph, const TemplateLibrary& library,
                                       double distancePx) {
    std::optional<Nearest> best;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    double offPx = 0.0;
    for (const Similar& s : similarAspects(graph, library)) {
        auto d = compare(graph, *s.entry, *s.aspect, distancePx);
        if (!d) continue;
        const std::size_t lines =
            d->missing.size() + d->extra.size() + static_cast<std::size_t>(d->strays);
        if (lines > fewest || (lines == fewest && d->offPx >= offPx)) continue;
        fewest = lines;
        offPx = d->offPx;
        best = Nearest{{s.entry->tmpl.id, s.entry->tmpl.name, s.aspect->name, std::move(d->missing),
                        std::move(d->extra)},
                       s.degrees,
                       d->strays};
    }
    return best;
}

}  // namespace ew
