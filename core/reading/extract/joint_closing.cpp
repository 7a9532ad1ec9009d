// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "core/base/tolerance.h"
#include "core/edge_graph/canonical.h"
#include "core/reading/extract/joint_graph.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// An edge of a reading while it is being made.
struct Chain {
    std::array<int, 2> nodes{-1, -1};
    int modelEdge = -1;
    std::vector<LinePiece> pieces;
    double redrawn = 0.0;
    bool alive = true;
    bool goesOn = false;  ///< a model edge that ink goes on from, straight
};

class Closing {
  public:
    Closing(const JointGraph& joint, double distancePx) : joint_(joint), distance_(distancePx) {}

    /// How slight turns of ink are taken.
    enum class Bends {
        Fold,     ///< where it meets the model it has a corner
        Wobble,   ///< as it does elsewhere, it only wobbles
        Careless  ///< so do turns that a steady hand would not make
    };

    /// False where this choice of model edges closes nothing or is no better than a smaller one.
    bool take(const std::vector<int>& chosen, Bends bends) {
        bends_ = bends;
        folded_ = false;
        bent_ = false;
        chains_.clear();
        for (std::size_t e = 0; e < joint_.inkEdges; ++e) add(joint_.edges[e]);
        for (const int e : chosen) add(joint_.edges[at(e)]);
        stray_ = 0;
        modelEdges_ = static_cast<int>(chosen.size());
        return prune() && largestPart() && (dissolve(), true) && edgeCount() >= 5;
    }

    /// Did some slight turn on the model make a difference?
    bool folded() const { return folded_; }
    /// Was there some turn that only a careless hand makes?
    bool bent() const { return bent_; }

    PlaneGraph shape() {
        PlaneGraph plane;
        number_.assign(joint_.nodes.size(), -1);
        nodes_.clear();
        for (const Chain& c : chains_) {
            if (!c.alive) continue;
            std::array<int, 2> ends{};
            for (std::size_t s = 0; s < 2; ++s) {
                int& n = number_[at(c.nodes[s])];
                if (n < 0) {
                    n = static_cast<int>(plane.points.size());
                    plane.points.push_back(joint_.nodes[at(c.nodes[s])].px);
                    nodes_.push_back(c.nodes[s]);
                }
                ends[s] = n;
            }
            plane.edges.push_back(ends);
        }
        return plane;
    }

    JointReading reading() {
        JointReading r;
        const PlaneGraph plane = shape();
        for (const Vec2& p : plane.points) r.graph.junctions.push_back({p});
        std::size_t k = 0;
        for (const Chain& c : chains_) {
            if (!c.alive) continue;
            const Vec2 a = joint_.nodes[at(c.nodes[0])].px;
            const Vec2 b = joint_.nodes[at(c.nodes[1])].px;
            GraphEdge e;
            if (c.modelEdge < 0) {
                e = fitEdge(a, b, c.pieces, joint_.lines);
            } else {
                e.origin = EdgeOrigin::Model;
                e.tips = {a, b};
            }
            e.ends = plane.edges[k++];
            r.graph.edges.push_back(std::move(e));
            r.edgeModel.push_back(c.modelEdge);
            r.goesOn = r.goesOn || c.goesOn;
        }
        r.junctionNode = nodes_;
        r.strayPx = stray_;
        r.modelEdges = modelEdges_;
        return r;
    }

  private:
    void add(const JointEdge& e) {
        chains_.push_back({e.nodes, e.modelEdge, e.pieces, e.redrawn, true});
    }
    double inkLength(const Chain& c) const {
        double sum = 0;
        for (const LinePiece& p : c.pieces) sum += std::abs(p.t1 - p.t0);
        return sum;
    }
    std::vector<std::vector<int>> incidence() const {
        std::vector<std::vector<int>> around(joint_.nodes.size());
        for (std::size_t c = 0; c < chains_.size(); ++c) {
            if (!chains_[c].alive) continue;
            for (const int n : chains_[c].nodes) around[at(n)].push_back(static_cast<int>(c));
        }
        return around;
    }
    std::size_t edgeCount() const {
        return static_cast<std::size_t>(
            std::count_if(chains_.begin(), chains_.end(), [](const Chain& c) { return c.alive; }));
    }
    bool drop(Chain& c) {
        c.alive = false;
        if (c.modelEdge >= 0) return false;
        stray_ += inkLength(c);
        return true;
    }

    bool prune() {
        for (bool changed = true; changed;) {
            changed = false;
            for (const auto& around : incidence()) {
                if (around.size() != 1 || !chains_[at(around[0])].alive) continue;
                if (!drop(chains_[at(around[0])])) return false;
                changed = true;
            }
        }
        return true;
    }

    /// Keeps the connected part with the most ink.
    bool largestPart() {
        std::vector<int> part(joint_.nodes.size());
        std::iota(part.begin(), part.end(), 0);
        const auto find = [&](int n) {
            while (part[at(n)] != n) n = part[at(n)] = part[at(part[at(n)])];
            return n;
        };
        for (const Chain& c : chains_) {
            if (c.alive) part[at(find(c.nodes[0]))] = find(c.nodes[1]);
        }
        std::map<int, double> ink;
        for (const Chain& c : chains_) {
            if (c.alive) ink[find(c.nodes[0])] += inkLength(c);
        }
        if (ink.empty()) return false;
        const int best = std::max_element(ink.begin(), ink.end(), [](const auto& a, const auto& b) {
                             return a.second < b.second;
                         })->first;
        for (Chain& c : chains_) {
            if (c.alive && find(c.nodes[0]) != best && !drop(c)) return false;
        }
        return true;
    }

    static void reverse(Chain& c) {
        std::swap(c.nodes[0], c.nodes[1]);
        std::reverse(c.pieces.begin(), c.pieces.end());
        for (LinePiece& p : c.pieces) std::swap(p.t0, p.t1);
    }

    void dissolve() {
        while (uniteDoubles() || uniteStraight()) {
        }
    }

    bool uniteDoubles() {
        for (std::size_t i = 0; i < chains_.size(); ++i) {
            for (std::size_t j = i + 1; j < chains_.size(); ++j) {
                Chain& a = chains_[i];
                Chain& b = chains_[j];
                if (!a.alive || !b.alive ||
                    std::minmax(a.nodes[0], a.nodes[1]) != std::minmax(b.nodes[0], b.nodes[1])) {
                    continue;
                }
                if (a.modelEdge >= 0) {
                    b.alive = false;
                } else if (b.modelEdge >= 0) {
                    a.alive = false;
                } else {
                    if (a.nodes[0] != b.nodes[0]) reverse(b);
                    a.pieces.insert(a.pieces.end(), b.pieces.begin(), b.pieces.end());
                    b.alive = false;
                }
                return true;
            }
        }
        return false;
    }

    bool uniteStraight() {
        const auto around = incidence();
        for (std::size_t n = 0; n < around.size(); ++n) {
            if (around[n].size() != 2) continue;
            Chain& a = chains_[at(around[n][0])];
            Chain& b = chains_[at(around[n][1])];
            const int ni = static_cast<int>(n);
            const bool onward = a.modelEdge != b.modelEdge;
            if (onward && !mayGoOn(a, b)) continue;
            if (a.nodes[1] != ni) reverse(a);
            if (b.nodes[0] != ni) reverse(b);
            if (a.nodes[0] == b.nodes[1]) continue;
            const Vec2 u = joint_.nodes[n].px - joint_.nodes[at(a.nodes[0])].px;
            const Vec2 w = joint_.nodes[at(b.nodes[1])].px - joint_.nodes[n].px;
            const Vec2 chord = u + w;
            const double turn =
                std::abs(std::atan2(cross2(u, w), u.dot(w))) * 180.0 / std::numbers::pi;
            const double bend = chord.norm() < 1e-9 ? 0.0 : std::abs(cross2(chord.normalized(), u));
            const JointNode& node = joint_.nodes[n];
            const bool onModel = node.modelEdge >= 0 || node.modelVertex >= 0;
            if ((a.modelEdge < 0 || onward) && !straight(turn, bend, onModel)) continue;
            // What ends at a wall may be in line with the wall's own edge.
            folded_ = folded_ || onward;
            if (onward && bends_ == Bends::Fold) continue;
            a.goesOn = onward;
            // An edge of which the model has a part lies where that part does.
            a.modelEdge = std::max(a.modelEdge, b.modelEdge);
            a.nodes[1] = b.nodes[1];
            a.pieces.insert(a.pieces.end(), b.pieces.begin(), b.pieces.end());
            b.alive = false;
            return true;
        }
        return false;
    }

    /// May two chains be one edge of which the model has a part already, as where a body stands on
    /// two others and its edge goes on from one to the other? Two model edges only with ink
    /// between.
    static bool mayGoOn(const Chain& a, const Chain& b) {
        return a.modelEdge < 0 || b.modelEdge < 0 || a.goesOn || b.goesOn;
    }

    /// May ink that turns by so many degrees, so many px off its chord, be one line?
    bool straight(double turn, double bend, bool onModel) {
        if (turn > tol::kNearlyStraightDeg || bend > 2.0 * tol::kStraightBend * distance_) {
            if (onModel || turn > tol::kCarelessTurnDeg || bend > tol::kCarelessBend * distance_) {
                return false;
            }
            bent_ = true;
            if (bends_ != Bends::Careless) return false;
            stray_ += bend;
            return true;
        }
        if (!onModel || turn <= tol::kFoldDeg) return true;
        folded_ = true;
        return bends_ != Bends::Fold;
    }

    const JointGraph& joint_;
    double distance_;
    std::vector<Chain> chains_;
    std::vector<int> number_;
    std::vector<int> nodes_;
    double stray_ = 0.0;
    int modelEdges_ = 0;
    Bends bends_ = Bends::Fold;
    bool folded_ = false;
    bool bent_ = false;
};

/// A choice of model edges on the way to closing the ink.
struct Choice {
    std::vector<int> edges;    ///< ascending
    std::vector<int> leftOut;  ///< nodes whose open ends stay open, ascending
    int extra = 0;             ///< ways that no open end asked for
    double price = 0.0;
};

class ClosingSearch {
  public:
    ClosingSearch(const JointGraph& joint, const std::function<bool(const PlaneGraph&)>& known,
                  double distancePx)
        : joint_(joint), known_(known), closing_(joint, distancePx) {
        ends_.resize(joint.ways.size());
        for (std::size_t w = 0; w < joint.ways.size(); ++w) {
            std::map<int, int> degree;
            for (const int e : joint.ways[w]) {
                for (const int n : joint.edges[at(e)].nodes) ++degree[n];
            }
            for (const auto& [n, d] : degree) {
                if (d == 1) ends_[w].push_back(n);
            }
        }
    }

    std::vector<JointReading> run() {
        Choice redrawn;
        for (std::size_t e = joint_.inkEdges; e < joint_.edges.size(); ++e) {
            if (joint_.edges[e].redrawn >= 0.5) redrawn.edges.push_back(static_cast<int>(e));
        }
        push({});
        if (!redrawn.edges.empty()) push(std::move(redrawn));
        for (int i = 0; i < kMostChoices && !open_.empty(); ++i) {
            const Choice c = open_.begin()->second;
            open_.erase(open_.begin());
            expand(c);
        }
        return std::move(found_);
    }

  private:
    static constexpr int kMostChoices = 600;
    static constexpr int kMostExtra = 3;
    static constexpr double kLeftOutPrice = 3.0;
    static constexpr double kExtraPrice = 1.5;

    void push(Choice c) {
        if (seen_.insert({c.edges, c.leftOut}).second) open_.emplace(c.price, std::move(c));
    }

    /// An open end of ink that something can be said of.
    int openEnd(const Choice& c) const {
        std::vector<int> degree(joint_.nodes.size(), 0);
        for (std::size_t e = 0; e < joint_.inkEdges; ++e) {
            for (const int n : joint_.edges[e].nodes) ++degree[at(n)];
        }
        for (const int e : c.edges) {
            for (const int n : joint_.edges[at(e)].nodes) ++degree[at(n)];
        }
        for (std::size_t n = 0; n < degree.size(); ++n) {
            const int ni = static_cast<int>(n);
            if (degree[n] == 1 && joint_.nodes[n].ink &&
                !std::binary_search(c.leftOut.begin(), c.leftOut.end(), ni)) {
                return ni;
            }
        }
        return -1;
    }

    static bool goesFrom(const std::vector<int>& ends, int node) {
        return std::find(ends.begin(), ends.end(), node) != ends.end();
    }

    void expand(const Choice& c) {
        const int end = openEnd(c);
        if (end < 0) emit(c);
        if (end < 0 && c.extra == kMostExtra) return;
        for (std::size_t w = 0; w < joint_.ways.size(); ++w) {
            if (end >= 0 && !goesFrom(ends_[w], end)) continue;
            Choice next = c;
            next.edges.insert(next.edges.end(), joint_.ways[w].begin(), joint_.ways[w].end());
            std::sort(next.edges.begin(), next.edges.end());
            next.edges.erase(std::unique(next.edges.begin(), next.edges.end()), next.edges.end());
            if (next.edges.size() == c.edges.size()) continue;
            next.extra += end < 0 ? 1 : 0;
            next.price += 0.3 * static_cast<double>(next.edges.size() - c.edges.size()) +
                          (end < 0 ? kExtraPrice : 0.5);
            push(std::move(next));
        }
        if (end < 0) return;
        Choice next = c;
        next.leftOut.insert(std::upper_bound(next.leftOut.begin(), next.leftOut.end(), end), end);
        next.price += kLeftOutPrice;
        push(std::move(next));
    }

    void emit(const Choice& c) {
        using Bends = Closing::Bends;
        bool done = emit(c, Bends::Fold);
        if (closing_.folded()) done = emit(c, Bends::Wobble) || done;
        if (!done && closing_.bent()) emit(c, Bends::Careless);
    }

    bool emit(const Choice& c, Closing::Bends bends) {
        if (!closing_.take(c.edges, bends) || !known_(closing_.shape())) return false;
        JointReading r = closing_.reading();
        std::vector<std::array<int, 2>> key;
        for (const GraphEdge& e : r.graph.edges) {
            const int a = r.junctionNode[at(e.ends[0])];
            const int b = r.junctionNode[at(e.ends[1])];
            key.push_back({std::min(a, b), std::max(a, b)});
        }
        std::sort(key.begin(), key.end());
        if (shapes_.insert(std::move(key)).second) found_.push_back(std::move(r));
        return true;
    }

    const JointGraph& joint_;
    const std::function<bool(const PlaneGraph&)>& known_;
    Closing closing_;
    std::vector<std::vector<int>> ends_;  ///< per way: its two ends
    std::multimap<double, Choice> open_;
    std::set<std::pair<std::vector<int>, std::vector<int>>> seen_;
    std::set<std::vector<std::array<int, 2>>> shapes_;
    std::vector<JointReading> found_;
};

}  // namespace

std::vector<JointReading> closedReadings(const JointGraph& joint,
                                         const std::function<bool(const PlaneGraph&)>& known,
                                         double distancePx, std::size_t limit) {
    std::vector<JointReading> found = ClosingSearch(joint, known, distancePx).run();
    std::stable_sort(found.begin(), found.end(), [](const JointReading& a, const JointReading& b) {
        return std::pair(a.strayPx, a.modelEdges) < std::pair(b.strayPx, b.modelEdges);
    });
    if (found.size() > limit) found.resize(limit);
    return found;
}

}  // namespace ew
