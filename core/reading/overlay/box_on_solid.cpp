// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/overlay/box_on_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "core/base/tolerance.h"
#include "core/reading/overlay/box_edges.h"
#include "core/reading/overlay/box_places.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Layer {
  public:
    Layer(const BoxFrame& frame, const ModelView& model, const BoxLayingOptions& options)
        : frame_(frame), options_(options), distance_(options.thresholds.distancePx) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            borders_[axis] = bordersAndWalls(frame, model, axis, distance_);
        }
    }

    /// All boxes worth a closer look, best first.
    std::vector<Box> boxes() {
        std::vector<Box> found;
        for (const double depth : depths()) {
            const auto us = pairsAlong(0, depth);
            const auto vs = pairsAlong(1, depth);
            std::vector<double> leastOfV;
            for (const auto& v : vs) leastOfV.push_back(leastCost(1, v, depth));
            const double worst = found.size() < kLookedAt ? std::numeric_limits<double>::infinity()
                                                          : found.back().cost;
            for (const auto& u : us) {
                const double leastOfU = leastCost(0, u, depth);
                for (std::size_t j = 0; j < vs.size(); ++j) {
                    const auto& v = vs[j];
                    if (leastOfU + leastOfV[j] > worst) continue;
                    Box box;
                    box.on[2][0] = frame_.face;
                    box.side[2] = {0.0, depth};
                    for (std::size_t k = 0; k < 2; ++k) {
                        set(box, 0, k, u[k]);
                        set(box, 1, k, v[k]);
                    }
                    if (rate(box, false)) found.push_back(box);
                }
            }
            keepBest(found, kLookedAt);
        }
        std::vector<Box> best;
        for (Box& b : found) {
            if (rate(b, true)) best.push_back(b);
        }
        keepBest(best, best.size());
        return best;
    }

    /// Edges with ink, fitted to it.
    std::optional<LaidBox> lay(const Box& box, const std::shared_ptr<const LibraryEntry>& entry);

    void seat(const Box& box, LaidBox& out, const LibraryEntry& entry) const;

    /// Are two boxes the same but for what this hand cannot tell apart?
    bool same(const Box& a, const Box& b) const {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 2; ++k) {
                if (std::abs(a.side[i][k] - b.side[i][k]) * frame_.seen[i] > options_.noisePx) {
                    return false;
                }
            }
        }
        return true;
    }

  private:
    static void keepBest(std::vector<Box>& boxes, std::size_t n) {
        std::stable_sort(boxes.begin(), boxes.end(),
                         [](const Box& a, const Box& b) { return a.cost < b.cost; });
        if (boxes.size() > n) boxes.resize(n);
    }

    static void set(Box& box, std::size_t axis, std::size_t k, const BoxPlace& p) {
        box.side[axis][k] = p.value;
        box.on[axis][k] = p.on;
        box.facesOn[axis][k] = p.on >= 0 && p.ahead == (k == 1);
    }

    /// Where sides across an axis of the face may be, and where they are in pairs: at its borders,
    /// and where lines along the other axis lie, in the face or at this depth.
    std::vector<std::array<BoxPlace, 2>> pairsAlong(std::size_t axis, double depth) const {
        const std::size_t other = 1 - axis;
        const double scale = frame_.across(other, axis);
        std::vector<BoxPlace> lines;
        for (const BoxLine& l : frame_.lines) {
            if (l.axis != static_cast<int>(other)) continue;
            for (const double at : {0.0, depth}) {
                lines.push_back({(l.offset - at * frame_.across(other, 2)) / scale, l.length});
            }
        }
        std::vector<BoxPlace> places = united(lines, std::abs(scale), kMostPlaces);
        places.insert(places.end(), borders_[axis].begin(), borders_[axis].end());
        std::vector<std::array<BoxPlace, 2>> pairs;
        for (const BoxPlace& a : places) {
            for (const BoxPlace& b : places) {
                if ((b.value - a.value) * frame_.seen[axis] >= 0.5 * distance_) {
                    pairs.push_back({a, b});
                }
            }
        }
        return pairs;
    }

    /// Places that differ by less than the hand's noise are one; those with the most ink.
    std::vector<BoxPlace> united(std::vector<BoxPlace> places, double pxPerUnit,
                                 std::size_t most) const {
        std::sort(places.begin(), places.end(),
                  [](const BoxPlace& a, const BoxPlace& b) { return a.value < b.value; });
        std::vector<BoxPlace> out;
        for (const BoxPlace& p : places) {
            if (!out.empty() && (p.value - out.back().value) * pxPerUnit < options_.noisePx) {
                BoxPlace& o = out.back();
                o.value = (o.value * o.weight + p.value * p.weight) / (o.weight + p.weight);
                o.weight += p.weight;
            } else {
                out.push_back(p);
            }
        }
        std::stable_sort(out.begin(), out.end(),
                         [](const BoxPlace& a, const BoxPlace& b) { return a.weight > b.weight; });
        if (out.size() > most) out.resize(most);
        return out;
    }

    /// Distances of the far side from the face, outwards positive, that some line speaks for: by
    /// its length along the normal, or by lying that far from another or from the face's border.
    std::vector<double> depths() const {
        std::vector<BoxPlace> found;
        const double least = 0.5 * distance_ / frame_.seen[2];
        const auto add = [&](double depth, double weight) {
            if (std::abs(depth) >= least) found.push_back({depth, weight});
        };
        for (const BoxLine& l : frame_.lines) {
            if (l.axis == 2) {
                for (const double sense : {1.0, -1.0})
                    add(sense * l.length / frame_.seen[2], l.length);
            }
            if (l.axis < 0 || l.axis == 2) continue;
            const auto axis = static_cast<std::size_t>(l.axis);
            const double scale = frame_.across(axis, 2);
            for (const BoxLine& m : frame_.lines) {
                if (m.axis == l.axis)
                    add((l.offset - m.offset) / scale, std::min(l.length, m.length));
            }
            for (const double border : frame_.border[1 - axis]) {
                add((l.offset - border * frame_.across(axis, 1 - axis)) / scale, l.length);
            }
        }
        std::vector<double> depths;
        for (const BoxPlace& p : united(found, frame_.seen[2], kMostDepths))
            depths.push_back(p.value);
        return depths;
    }

    /// Sets the cost; false where too little speaks for the box.
    /// \param closely  asks the model too: an edge of it needs no line.
    bool rate(Box& box, bool closely) const {
        auto edges = edgesOf(frame_, box);
        double strayPx = 0;
        double cost = takeLines(edges, strayPx);
        double deep = 0;
        for (const BoxEdge& e : edges) {
            const bool far = e.axis == 2 || (e.b == 2 && e.kb == 1) || (e.c == 2 && e.kc == 1);
            if (far) deep += e.covered;
            if (e.drawn != Drawn::Surely) continue;
            const double bare = std::max(0.0, e.to - e.from - e.covered - distance_);
            if (bare > 0 && !(closely && onModel(e))) cost += barePrice(bare);
        }
        box.cost = cost;
        return deep >= distance_;
    }

    /// No box with these two sides across an axis and this depth costs less: its lines along the
    /// other axis of the face are at least as far from all edges as this.
    double leastCost(std::size_t axis, const std::array<BoxPlace, 2>& pair, double depth) const {
        const std::size_t other = 1 - axis;
        const double scale = frame_.across(other, axis);
        const double deep = depth * frame_.across(other, 2);
        const double variance = options_.noisePx * options_.noisePx;
        double cost = 0;
        for (const BoxLine& l : frame_.lines) {
            if (l.axis != static_cast<int>(other)) continue;
            double least = std::min(kStray, l.modelOff * l.modelOff / variance);
            for (const BoxPlace& p : pair) {
                for (const double z : {0.0, deep}) {
                    const double off = l.offset - p.value * scale - z;
                    least = std::min(least, off * off / variance);
                }
            }
            cost += least * weightOf(l);
        }
        return cost;
    }

    /// What a line counts for.
    double weightOf(const BoxLine& l) const {
        return std::clamp(l.length / (4.0 * distance_), 0.25, 2.0);
    }

    double barePrice(double px) const { return tol::kExtraEdgeCost * px / (4.0 * distance_); }

    /// Gives every line to the edge that it is nearest to; the cost of how far they are.
    /// \param strayPx  receives the length of those that are far from all.
    double takeLines(std::array<BoxEdge, 12>& edges, double& strayPx) const {
        const double variance = options_.noisePx * options_.noisePx;
        const double near = std::min(distance_, std::max(0.5 * distance_, 3.0 * options_.noisePx));
        double cost = 0;
        strayPx = 0;
        for (std::size_t i = 0; i < frame_.lines.size(); ++i) {
            const BoxLine& l = frame_.lines[i];
            double least = std::min(kStray, l.modelOff * l.modelOff / variance);
            BoxEdge* best = nullptr;
            double overlap = 0;
            for (BoxEdge& e : edges) {
                if (static_cast<int>(e.axis) != l.axis || e.drawn == Drawn::Never) continue;
                const double off = l.offset - e.offset;
                if (off * off >= least * variance || std::abs(off) > distance_) continue;
                const double shared =
                    std::min(l.to, e.to + distance_) - std::max(l.from, e.from - distance_);
                if (shared < 0.7 * l.length) continue;
                least = off * off / variance;
                best = &e;
                overlap = std::min(l.to, e.to) - std::max(l.from, e.from);
            }
            if (best == nullptr ? l.modelOff > tol::kAlongModel * distance_
                                : least * variance > near * near) {
                strayPx += l.length;
            }
            cost += least * weightOf(l);
            if (best == nullptr) continue;
            best->covered += std::max(0.0, overlap);
            best->lines.push_back(i);
        }
        return cost;
    }

    /// Sides of the box that meet at an end of one of its edges, by axis: the template's planes.
    static std::array<std::size_t, 3> cornerOf(const Box& box, const BoxEdge& e, std::size_t end) {
        std::array<std::size_t, 3> sides{};
        sides[e.axis] = box.plane(e.axis, end);
        sides[e.b] = box.plane(e.b, e.kb);
        sides[e.c] = box.plane(e.c, e.kc);
        return sides;
    }
    std::array<Vec2, 2> endsOf(const Box& box, const BoxEdge& e) const {
        const Vec3 side = frame_.origin + box.side[e.b][e.kb] * frame_.axis[e.b] +
                          box.side[e.c][e.kc] * frame_.axis[e.c];
        std::array<Vec2, 2> ends;
        for (std::size_t s = 0; s < 2; ++s) {
            ends[s] = (side + box.side[e.axis][s] * frame_.axis[e.axis]).head<2>();
        }
        return ends;
    }

    /// Runs an edge of the box along edges of the solid that are seen?
    bool onModel(const BoxEdge& e) const {
        const Vec2 across = frame_.acrossOf(e.axis);
        const Vec2 base = frame_.origin.head<2>();
        for (const double share : {0.15, 0.5, 0.85}) {
            const double t = e.from + share * (e.to - e.from);
            const Vec2 p = base + t * frame_.screen[e.axis] + e.offset * across;
            if (frame_.modelDistance(p) > tol::kAlongModel * distance_) return false;
        }
        return true;
    }

    static constexpr std::size_t kMostPlaces = 7;
    static constexpr std::size_t kMostDepths = 14;
    static constexpr std::size_t kLookedAt = 60;
    static constexpr double kStray = 9.0;  ///< most that a line costs [variances]

    const BoxFrame& frame_;
    const BoxLayingOptions& options_;
    double distance_;
    std::array<std::vector<BoxPlace>, 2> borders_;  ///< by axis
};

/// The template's vertex, by the side of each axis.
int vertexAt(const RectilinearStructure& r, const std::array<std::size_t, 3>& sides) {
    for (std::size_t v = 0; v < r.planes[0].size(); ++v) {
        bool all = true;
        for (std::size_t a = 0; a < 3; ++a) {
            all = all && r.planes[a][v] == static_cast<int>(sides[a]);
        }
        if (all) return static_cast<int>(v);
    }
    return -1;
}

/// The template's face on one side across an axis.
int faceAcross(const LibraryEntry& entry, std::size_t axis, std::size_t side) {
    const auto& planes = entry.analysis.rectilinear->planes[axis];
    const auto& faces = entry.tmpl.shape.faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (std::all_of(faces[f].begin(), faces[f].end(),
                        [&](int v) { return planes[at(v)] == static_cast<int>(side); })) {
            return static_cast<int>(f);
        }
    }
    return -1;
}

/// Which of the template's faces lie in faces of the solid, and which others are seen.
void Layer::seat(const Box& box, LaidBox& out, const LibraryEntry& entry) const {
    Aspect aspect;
    aspect.kind = box.adds() ? AspectKind::Explicit : AspectKind::Cavity;
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t k = 0; k < 2; ++k) {
            const int t = faceAcross(entry, a, box.plane(a, k));
            if (box.coincides(a, k)) {
                out.pairs.push_back({t, box.on[a][k]});
                aspect.mouth.push_back(t);
            } else if (looksHere(frame_, box, a, k, true)) {
                aspect.visibleFaces.push_back(t);
            }
        }
    }
    // The frame's face comes first: it is the one that the box stands on or opens in.
    std::stable_partition(out.pairs.begin(), out.pairs.end(),
                          [&](const auto& p) { return p[1] == frame_.face; });
    std::sort(aspect.visibleFaces.begin(), aspect.visibleFaces.end());
    std::sort(aspect.mouth.begin(), aspect.mouth.end());
    aspect.name = box.adds() ? "explicit-" + std::to_string(aspect.visibleFaces.size())
                             : "cavity-" + std::to_string(aspect.mouth.size());
    if (box.adds()) aspect.mouth.clear();
    out.match.aspect = std::make_shared<const Aspect>(std::move(aspect));
}

std::optional<LaidBox> Layer::lay(const Box& box,
                                  const std::shared_ptr<const LibraryEntry>& entry) {
    LaidBox out;
    auto edges = edgesOf(frame_, box);
    takeLines(edges, out.strayPx);
    const RectilinearStructure& r = *entry->analysis.rectilinear;
    out.operation = box.adds() ? Operation::Add : Operation::Cut;
    out.betweenWalls = box.betweenWalls();
    JointGraph joint;
    std::map<int, int> junctionOf;
    const auto junction = [&](int vertex, const Vec2& p) {
        const int next = static_cast<int>(out.match.vertex.size());
        if (vertex >= 0) {
            const auto [it, added] = junctionOf.insert({vertex, next});
            if (!added) return it->second;
        }
        out.match.vertex.push_back(vertex);
        out.reading.graph.junctions.push_back({p});
        out.reading.junctionNode.push_back(static_cast<int>(joint.nodes.size()));
        joint.nodes.push_back({p, -1, -1, true});
        return next;
    };
    for (const BoxEdge& e : edges) {
        const double length = e.to - e.from;
        const bool drawn = !e.lines.empty() && e.covered >= std::min(distance_, 0.3 * length);
        if (e.drawn == Drawn::Surely && !onModel(e)) {
            out.price += barePrice(std::max(0.0, length - (drawn ? e.covered : 0.0) - distance_));
        }
        if (!drawn) continue;
        const auto ends = endsOf(box, e);
        GraphEdge edge = frame_.fitted(e.lines, ends[0], ends[1]);
        const auto inked = frame_.inked(e.lines, ends[0], ends[1]);
        std::array<int, 2> vertex{};
        for (std::size_t s = 0; s < 2; ++s) {
            vertex[s] = vertexAt(r, cornerOf(box, e, s));
            // An edge inside a pocket disappears behind its rim.
            const bool hides =
                !box.adds() && e.drawn == Drawn::Maybe && (inked[s] - ends[s]).norm() > distance_;
            if (hides) edge.tips[s] = inked[s];
            edge.ends[s] = hides ? junction(-1, inked[s]) : junction(vertex[s], ends[s]);
        }
        out.reading.graph.edges.push_back(std::move(edge));
        out.reading.edgeModel.push_back(-1);
        out.match.edge.push_back(entry->analysis.edgeBetween(vertex[0], vertex[1]));
    }
    if (out.reading.graph.edges.size() < 3) return std::nullopt;
    seat(box, out, *entry);
    out.match.entry = entry;
    out.joint = std::make_shared<const JointGraph>(std::move(joint));
    return out;
}

}  // namespace

namespace {
constexpr std::size_t kMostLines = 80;
}

bool isBox(const LibraryEntry& entry) {
    return entry.analysis.convex && entry.analysis.rectilinear &&
           entry.tmpl.shape.vertices.size() == 8;
}

std::vector<LaidBox> layBoxes(const InkReading& ink, const ModelView& model,
                              const std::shared_ptr<const LibraryEntry>& entry,
                              const BoxLayingOptions& options) {
    struct Found {
        double cost;
        LaidBox laid;
    };
    std::vector<Found> found;
    // A crowded sheet is no rough drawing of one box.
    if (ink.segments.size() > kMostLines) return {};
    for (const BoxFrame& frame : boxFrames(ink, model, options.thresholds, options.noisePx)) {
        Layer layer(frame, model, options);
        std::vector<Box> kept;
        for (const Box& b : layer.boxes()) {
            if (kept.size() == options.limit) break;
            const bool known = std::any_of(kept.begin(), kept.end(),
                                           [&](const Box& k) { return layer.same(k, b); });
            if (known) continue;
            kept.push_back(b);
            if (auto laid = layer.lay(b, entry)) found.push_back({b.cost, std::move(*laid)});
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.cost < b.cost; });
    std::vector<LaidBox> out;
    for (Found& f : found) {
        if (out.size() == options.limit) break;
        out.push_back(std::move(f.laid));
    }
    return out;
}

}  // namespace ew
