// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/explain/diagnose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/base/words.h"
#include "core/edge_graph/closable_ends.h"
#include "core/reading/explain/nearest_template.h"
#include "core/tlib/library_index.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::string px(double value) { return std::to_string(static_cast<int>(std::ceil(value))) + " px"; }
std::string count(std::size_t n, const std::string& one, const std::string& many) {
    return n == 1 ? "one " + one : std::to_string(n) + " " + many;
}

/// The middle of what a line covers.
Vec2 middleOf(const std::vector<Vec2>& polyline) {
    Eigen::AlignedBox2d box;
    for (const Vec2& p : polyline) box.extend(p);
    return box.isEmpty() ? Vec2(Vec2::Zero()) : Vec2(box.center());
}

/// Junctions where two lines run straight through each other.
std::vector<int> crossings(const EdgeGraph& g) {
    std::vector<std::vector<double>> around(g.junctions.size());
    for (const GraphEdge& e : g.edges) {
        const Vec2 d = g.junctions[at(e.ends[1])].position - g.junctions[at(e.ends[0])].position;
        around[at(e.ends[0])].push_back(std::atan2(d.y(), d.x()));
        around[at(e.ends[1])].push_back(std::atan2(-d.y(), -d.x()));
    }
    std::vector<int> result;
    for (std::size_t j = 0; j < around.size(); ++j) {
        if (around[j].size() != 4) continue;
        std::sort(around[j].begin(), around[j].end());
        const double straight1 = around[j][2] - around[j][0];
        const double straight2 = around[j][3] - around[j][1];
        if (std::abs(straight1 - std::numbers::pi) < 0.2 &&
            std::abs(straight2 - std::numbers::pi) < 0.2) {
            result.push_back(static_cast<int>(j));
        }
    }
    return result;
}

class Explainer {
  public:
    Explainer(Interpretation& reading, const Findings& findings, const TemplateLibrary& library,
              const InterpretOptions& options)
        : r_(reading), f_(findings), library_(library), options_(options) {}

    void run() {
        markNoise();
        if (f_.flat) {
            flatDrawing();
        } else if (r_.graph.empty()) {
            if (!openEnds()) nothingClosed();
        } else if (!f_.otherParts.empty()) {
            separateDrawings();
        } else if (f_.slip != nullptr && !f_.leavesInk && !f_.blockedByOpenEnd) {
            if (!openEnds()) slip();
        } else if (f_.candidates->empty() || f_.onlyOutlines || f_.blockedByOpenEnd) {
            if (!openEnds() && !slip() && !selfCrossing()) noMatch();
        } else if (!f_.candidates->front().withinThresholds) {
            outsideThresholds();
        } else if (f_.ambiguous || f_.leavesInk || f_.accidental || f_.absurd || f_.twoFaces) {
            ambiguous();
        }
        if (!r_.problem) noMatch();
    }

  private:
    void problem(Errc code, std::string message, std::vector<Vec2> where) {
        r_.problem = Error{code, std::move(message), std::move(where)};
    }

    void markNoise() {
        std::set<int> strokes;
        for (const NoiseItem& n : r_.graph.noise) {
            if (n.kind == NoiseKind::Overshoot || n.polyline.empty()) continue;
            // Where there is no face yet, no line is to blame.
            if (n.kind == NoiseKind::Stray && r_.graph.empty()) continue;
            if (!strokes.insert(n.stroke).second) continue;
            std::string label = "is part of no face";
            if (n.kind == NoiseKind::Dot) label = "a dot";
            if (n.kind == NoiseKind::Scribble) label = "a scribble";
            if (n.kind == NoiseKind::Curve) label = "a curve";
            const Vec2 p = n.polyline[n.polyline.size() / 2];
            r_.culprits.push_back({Culprit::Kind::Stray, p, p, label, -1, -1});
        }
    }

    void flatDrawing() {
        std::vector<Vec2> where;
        if (!r_.graph.junctions.empty()) where.push_back(r_.graph.junctions.front().position);
        problem(Errc::FlatDrawing,
                "This is one flat outline; a solid needs the lines inside it too, where its faces "
                "meet.",
                std::move(where));
    }

    bool openEnds() {
        std::vector<Vec2> where;
        const double threshold = options_.thresholds.distancePx;
        double widest = 0;
        std::vector<OpenEnd> ends = closableEnds(r_.graph);
        // That a match needs a line gone is the reading's own reason.
        if (ends.empty() && f_.blockedByOpenEnd) ends = r_.graph.openEnds;
        // What is nearer than the threshold was bridged already, and that changed nothing.
        std::erase_if(ends, [&](const OpenEnd& o) { return o.gapPx <= threshold; });
        if (ends.empty()) return false;
        std::sort(ends.begin(), ends.end(),
                  [](const OpenEnd& a, const OpenEnd& b) { return a.gapPx < b.gapPx; });
        std::set<int> lines;
        for (const OpenEnd& o : ends) {
            where.push_back(o.tip);
            const bool openToo =
                std::any_of(r_.graph.openEnds.begin(), r_.graph.openEnds.end(),
                            [&](const OpenEnd& other) { return other.tip == o.target; });
            if (openToo) where.push_back(o.target);
            widest = std::max(widest, o.gapPx);
            r_.culprits.push_back({Culprit::Kind::OpenEnd, o.tip, o.target,
                                   "gap " + px(o.gapPx) + ", threshold " + px(threshold), -1, -1});
            Repair join;
            join.kind = Repair::Kind::JoinEnds;
            join.label = ends.size() == 1 ? "Join these ends" : "Join the nearest ends";
            join.from = o.tip;
            join.to = o.target;
            join.strokes = r_.graph.dangling[at(o.edge)].strokes;
            r_.repairs.push_back(join);
            lines.insert(o.edge);
        }
        if (widest > threshold && widest <= 60) {
            Repair raise;
            raise.kind = Repair::Kind::RaiseDistance;
            raise.value = std::ceil(widest + 1);
            raise.label = "Raise the threshold to " + px(raise.value);
            r_.repairs.push_back(raise);
        }
        for (const int line : lines) {
            Repair drop;
            drop.kind = Repair::Kind::DropStrokes;
            drop.label = "Drop this line";
            drop.from = drop.to = r_.graph.dangling[at(line)].ends[1];
            drop.strokes = r_.graph.dangling[at(line)].strokes;
            r_.repairs.push_back(drop);
        }
        problem(
            Errc::OpenEnd,
            (ends.size() == 1
                 ? "A line ends " + px(ends.front().gapPx) + " from what it should meet"
                 : std::to_string(ends.size()) + " line ends meet nothing; the nearest gap is " +
                       px(ends.front().gapPx)) +
                " (the distance threshold is " + px(threshold) + ").",
            std::move(where));
        nearest();
        return true;
    }

    void nothingClosed() {
        std::size_t curves = 0;
        std::size_t scribbles = 0;
        std::size_t dots = 0;
        std::vector<Vec2> where;
        for (const NoiseItem& n : r_.graph.noise) {
            curves += n.kind == NoiseKind::Curve ? 1 : 0;
            scribbles += n.kind == NoiseKind::Scribble ? 1 : 0;
            dots += n.kind == NoiseKind::Dot ? 1 : 0;
            // Where there are curves among lines, they are why.
            if (n.kind == NoiseKind::Curve && curves == 1) where.clear();
            if (curves > 0 && n.kind != NoiseKind::Curve) continue;
            if (n.kind == NoiseKind::Scribble) {
                where.push_back(middleOf(n.polyline));
            } else if (!n.polyline.empty()) {
                where.push_back(n.polyline[n.polyline.size() / 2]);
            }
        }
        const std::size_t lines = r_.graph.noise.size() - curves - scribbles - dots;
        if (lines > 0 && curves == 0) {
            problem(Errc::NoRegion, "The lines enclose nothing: a solid needs closed outlines.",
                    std::move(where));
        } else if (curves > 0) {
            problem(
                Errc::CurvedStroke,
                "This is a curve; solids are drawn with straight lines (round them afterwards).",
                std::move(where));
        } else if (scribbles > 0) {
            problem(Errc::Scribble,
                    "This looks like a scribble; no straight lines were found in it.",
                    std::move(where));
        } else {
            problem(Errc::OnlyNoise, "There are only dots here; draw the edges of a solid.",
                    std::move(where));
        }
    }

    void separateDrawings() {
        std::vector<Vec2> where;
        std::vector<const EdgeGraph*> parts{&r_.graph};
        for (const EdgeGraph& g : f_.otherParts) parts.push_back(&g);
        for (std::size_t keep = 0; keep < parts.size(); ++keep) {
            where.push_back(parts[keep]->junctions.front().position);
            Repair drop;
            drop.kind = Repair::Kind::DropStrokes;
            drop.label =
                keep == 0 ? "Keep the largest drawing" : "Keep drawing " + std::to_string(keep + 1);
            drop.from = drop.to = where.back();
            std::set<int> kept;
            for (const GraphEdge& e : parts[keep]->edges)
                kept.insert(e.strokes.begin(), e.strokes.end());
            std::set<int> gone;
            for (std::size_t p = 0; p < parts.size(); ++p) {
                if (p == keep) continue;
                for (const GraphEdge& e : parts[p]->edges) {
                    for (const int s : e.strokes) {
                        if (!kept.contains(s)) gone.insert(s);
                    }
                }
            }
            drop.strokes.assign(gone.begin(), gone.end());
            if (r_.repairs.size() < 4) r_.repairs.push_back(drop);
        }
        problem(Errc::SeparateDrawings,
                "These are " + std::to_string(parts.size()) +
                    " separate drawings; apply them one at a time.",
                std::move(where));
    }

    /// One corner is wrong, and all else fits.
    bool slip() {
        if (f_.slip == nullptr) return false;
        const Slip& slip = *f_.slip;
        if (slip.code == Errc::ImpossibleCorner) {
            r_.culprits.push_back({Culprit::Kind::ImpossibleCorner, slip.at, slip.at,
                                   "no right-angled corner looks like this", -1, -1});
            problem(Errc::ImpossibleCorner,
                    "This corner cannot be right-angled: at a Y all three angles must be over 90 "
                    "degrees, at an "
                    "arrow both inner angles under 90 with a sum over 90.",
                    {slip.at});
        } else {
            r_.culprits.push_back({Culprit::Kind::NotParallel, slip.at, slip.meant,
                                   px((slip.meant - slip.at).norm()) + " out of place", -1, -1});
            r_.repairs.push_back(cornerMoved(slip));
            problem(Errc::NotParallel,
                    "All but this corner fits " + withArticle(slip.templateName) + "; it is " +
                        px((slip.meant - slip.at).norm()) + " from where it would be.",
                    {slip.at});
        }
        if (!f_.candidates->empty() && f_.candidates->front().withinThresholds) {
            useCandidate(0, "Take the " + f_.candidates->front().candidate.templateName);
        }
        return true;
    }

    /// The lines at a corner, drawn again to where it is meant to be.
    Repair cornerMoved(const Slip& slip) const {
        int junction = -1;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < r_.graph.junctions.size(); ++j) {
            const double off = (r_.graph.junctions[j].position - slip.at).norm();
            if (off >= nearest) continue;
            nearest = off;
            junction = static_cast<int>(j);
        }
        std::set<int> strokes;
        for (const GraphEdge& e : r_.graph.edges) {
            if (e.ends[0] == junction || e.ends[1] == junction) {
                strokes.insert(e.strokes.begin(), e.strokes.end());
            }
        }
        Repair redraw;
        redraw.kind = Repair::Kind::Redraw;
        redraw.label = "Move this corner";
        redraw.from = slip.at;
        redraw.to = slip.meant;
        redraw.strokes.assign(strokes.begin(), strokes.end());
        for (const GraphEdge& e : r_.graph.edges) {
            const bool gone = std::any_of(e.strokes.begin(), e.strokes.end(),
                                          [&](int s) { return strokes.contains(s); });
            if (!gone) continue;
            std::array<Vec2, 2> line;
            for (std::size_t side = 0; side < 2; ++side) {
                line[side] = e.ends[side] == junction
                                 ? slip.meant
                                 : r_.graph.junctions[at(e.ends[side])].position;
            }
            redraw.lines.push_back(line);
        }
        return redraw;
    }

    bool selfCrossing() {
        const std::vector<int> found = crossings(r_.graph);
        if (found.empty()) return false;
        std::vector<Vec2> where;
        for (const int j : found) {
            const Vec2 p = r_.graph.junctions[at(j)].position;
            where.push_back(p);
            r_.culprits.push_back({Culprit::Kind::Crossing, p, p, "lines cross", j, -1});
        }
        problem(Errc::SelfCrossing,
                "Lines cross at " + count(found.size(), "place", "places") +
                    " where no corner is; draw visible edges only, or drop a line.",
                std::move(where));
        nearest();
        return true;
    }

    void outsideThresholds() {
        const RatedCandidate& best = f_.candidates->front();
        const Candidate& c = best.candidate;
        std::vector<Vec2> where;
        const double angle = options_.thresholds.angleDeg;
        if (best.parallelDeg > angle) {
            const int worst = worstParallel(best);
            const GraphEdge& e = r_.graph.edges[at(worst)];
            const Vec2 middle = 0.5 * (e.tips[0] + e.tips[1]);
            where.push_back(middle);
            const int deg = static_cast<int>(std::ceil(best.parallelDeg));
            r_.culprits.push_back({Culprit::Kind::NotParallel, middle, middle,
                                   std::to_string(deg) + " degrees off its parallels", -1, worst});
            if (deg < 40) {
                Repair raise;
                raise.kind = Repair::Kind::RaiseAngle;
                raise.value = deg + 1;
                raise.label =
                    "Raise the angle threshold to " + std::to_string(deg + 1) + " degrees";
                r_.repairs.push_back(raise);
            }
            problem(Errc::NotParallel,
                    "This could be " + withArticle(c.templateName) + ", but an edge is " +
                        std::to_string(deg) +
                        " degrees off its parallels (the angle threshold is " +
                        std::to_string(static_cast<int>(std::lround(angle))) + ").",
                    std::move(where));
        } else {
            for (const GraphEdge& e : r_.graph.edges)
                where.push_back(0.5 * (e.tips[0] + e.tips[1]));
            problem(Errc::NoSolution,
                    "The lines fit no " + c.templateName + " closely: they are " +
                        px(c.residualPx) + " off on average.",
                    std::move(where));
        }
        useCandidate(0, "Take it as " + withArticle(c.templateName) + " all the same");
    }

    int worstParallel(const RatedCandidate& best) const {
        const TemplateAnalysis& a = best.entry->analysis;
        std::vector<Vec2> mean(at(a.classCount), Vec2::Zero());
        auto doubled = [](const GraphEdge& e) {
            const Vec2 d = e.tips[1] - e.tips[0];
            const double t = 2 * std::atan2(d.y(), d.x());
            return Vec2(Vec2(std::cos(t), std::sin(t)) * d.norm());
        };
        const std::size_t n = std::min(best.match.edge.size(), r_.graph.edges.size());
        for (std::size_t e = 0; e < n; ++e) {
            mean[at(a.edges[at(best.match.edge[e])].directionClass)] += doubled(r_.graph.edges[e]);
        }
        int worst = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t e = 0; e < n; ++e) {
            const Vec2 m = mean[at(a.edges[at(best.match.edge[e])].directionClass)].normalized();
            const double agreement = doubled(r_.graph.edges[e]).normalized().dot(m);
            if (agreement < least) {
                least = agreement;
                worst = static_cast<int>(e);
            }
        }
        return worst;
    }

    void useCandidate(int index, const std::string& label) {
        Repair use;
        use.kind = Repair::Kind::UseCandidate;
        use.candidate = index;
        use.label = label;
        r_.repairs.push_back(use);
    }

    void ambiguous() {
        const auto& all = *f_.candidates;
        std::vector<Vec2> where{r_.graph.junctions.front().position};
        std::string names = all[0].candidate.templateName;
        std::string withArticles = withArticle(names);
        std::set<std::string> told{all[0].candidate.templateId};
        useCandidate(0, "Take the " + all[0].candidate.templateName);
        for (std::size_t i = 1; i < all.size() && told.size() < 3; ++i) {
            if (!told.insert(all[i].candidate.templateId).second) continue;
            names += " or " + all[i].candidate.templateName;
            withArticles += " or " + withArticle(all[i].candidate.templateName);
            useCandidate(static_cast<int>(i), "Take the " + all[i].candidate.templateName);
        }
        std::string message = "This can be read as " + names + "; choose one.";
        if (f_.leavesInk) {
            message = "This could be " + withArticles +
                      ", but only without some of the lines; choose it, or draw on.";
        } else if (f_.twoFaces) {
            message = "Just two faces are drawn here; this could be " + withArticles +
                      ". Choose it, or draw the third face.";
        } else if (f_.absurd) {
            message = "As it is drawn " + withArticles +
                      " would be far deeper than it is wide, or hardly thicker than a line; choose "
                      "it, or draw it from another side.";
        } else if (f_.accidental) {
            message = "Seen from here " + withArticles +
                      " looks like simpler solids; choose it, or turn the view and draw again.";
        }
        problem(Errc::Ambiguous, std::move(message), std::move(where));
    }

    void noMatch() {
        nearest();
        markBadJunctions();
        std::vector<Vec2> where;
        for (const Culprit& c : r_.culprits) {
            if (c.kind == Culprit::Kind::BadJunction || c.kind == Culprit::Kind::ExtraEdge)
                where.push_back(c.at);
        }
        if (where.empty() && !r_.graph.junctions.empty())
            where.push_back(r_.graph.junctions.front().position);
        std::string message = "No template shows " +
                              count(r_.graph.junctions.size(), "corner", "corners") + " and " +
                              count(r_.graph.edges.size(), "edge", "edges") + " like this.";
        if (r_.nearest) {
            message += " The nearest is " + r_.nearest->templateName + difference_ + ".";
        }
        problem(Errc::NoMatch, message, std::move(where));
    }

    void nearest() {
        if (r_.nearest || r_.graph.empty()) return;
        auto found = nearestTemplate(r_.graph, library_, options_.thresholds.distancePx);
        if (!found) return;
        r_.nearest = std::move(found->shown);
        nearestDegrees_ = found->degrees;
        difference_ = tellDifference(r_.nearest->missing.size(), r_.nearest->extra.size());
    }

    static std::string tellDifference(std::size_t missing, std::size_t extra) {
        if (missing == 0 && extra == 0) return ", but the lines meet in another way";
        std::string s = " (";
        if (missing > 0) s += count(missing, "line", "lines") + " missing";
        if (missing > 0 && extra > 0) s += ", ";
        if (extra > 0) s += count(extra, "line", "lines") + " too many";
        return s + ")";
    }

    /// Corners of a degree that the nearest template has fewer of.
    void markBadJunctions() {
        if (!r_.nearest) return;
        const std::vector<int> mine = junctionDegrees(r_.graph);
        std::array<int, 6> left = nearestDegrees_;
        for (std::size_t j = 0; j < mine.size(); ++j) {
            if (--left[at(std::min(mine[j], 5))] >= 0) continue;
            const Vec2 p = r_.graph.junctions[j].position;
            r_.culprits.push_back({Culprit::Kind::BadJunction, p, p,
                                   std::to_string(mine[j]) + " lines meet here",
                                   static_cast<int>(j), -1});
        }
    }

    Interpretation& r_;
    const Findings& f_;
    const TemplateLibrary& library_;
    const InterpretOptions& options_;
    std::array<int, 6> nearestDegrees_{};
    std::string difference_;
};

}  // namespace

void explain(Interpretation& reading, const Findings& findings, const TemplateLibrary& library,
             const InterpretOptions& options) {
    Explainer(reading, findings, library, options).run();
}

}  // namespace ew
