// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/explain/diagnose.h"

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

std::vector<int> degrees(const EdgeGraph& g) {
    std::vector<int> d(g.junctions.size(), 0);
    for (const GraphEdge& e : g.edges) {
        ++d[at(e.ends[0])];
        ++d[at(e.ends[1])];
    }
    return d;
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
        } else if (f_.candidates->empty() || f_.onlyOutlines || f_.blockedByOpenEnd) {
            if (!openEnds() && !impossibleCorner() && !selfCrossing()) noMatch();
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
            if (!n.polyline.empty()) where.push_back(n.polyline[n.polyline.size() / 2]);
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

    bool impossibleCorner() {
        if (!f_.impossibleCorner) return false;
        const Vec2 p = *f_.impossibleCorner;
        r_.culprits.push_back({Culprit::Kind::ImpossibleCorner, p, p,
                               "no right-angled corner looks like this", -1, -1});
        problem(Errc::ImpossibleCorner,
                "This corner cannot be right-angled: at a Y all three angles must be over 90 "
                "degrees, at an "
                "arrow both inner angles under 90 with a sum over 90.",
                {p});
        return true;
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

    /// An aspect, and how far its corners are from those drawn.
    struct Similar {
        double off = 0.0;
        const LibraryEntry* entry = nullptr;
        const Aspect* aspect = nullptr;
        std::array<int, 6> degrees{};  ///< corners by how many lines meet there
    };
    static constexpr std::size_t kMostCompared = 6;

    void nearest() {
        if (r_.graph.empty()) return;
        auto histogram = [](const std::vector<int>& d) {
            std::array<int, 6> h{};
            for (const int x : d) ++h[at(std::min(x, 5))];
            return h;
        };
        std::vector<int> mine = degrees(r_.graph);
        // A line with an open end is one that is drawn.
        for (const DanglingEdge& d : r_.graph.dangling) {
            if (d.junction >= 0) ++mine[at(d.junction)];
            mine.push_back(2);
        }
        const auto ours = histogram(mine);
        const std::size_t linesDrawn = r_.graph.edges.size() + r_.graph.dangling.size();
        std::vector<Similar> similar;
        for (const auto& entry : library_.index().entries) {
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
                const auto count = [](std::size_t n) { return static_cast<double>(n); };
                off += 0.5 * std::abs(count(a.graph.edges.size()) - count(linesDrawn)) +
                       0.5 * std::abs(count(a.vertex.size()) - count(mine.size()));
                similar.push_back({off, entry.get(), &a, theirs});
            }
        }
        std::stable_sort(similar.begin(), similar.end(),
                         [](const Similar& a, const Similar& b) { return a.off < b.off; });
        if (similar.size() > kMostCompared) similar.resize(kMostCompared);
        tellNearest(similar);
    }

    /// Of aspects with much the same corners, the one that differs by the fewest lines.
    void tellNearest(const std::vector<Similar>& similar) {
        std::size_t fewest = std::numeric_limits<std::size_t>::max();
        double offPx = 0.0;
        for (const Similar& s : similar) {
            auto d = compare(r_.graph, *s.entry, *s.aspect, options_.thresholds.distancePx);
            if (!d) continue;
            const std::size_t lines =
                d->missing.size() + d->extra.size() + static_cast<std::size_t>(d->strays);
            if (lines > fewest || (lines == fewest && d->offPx >= offPx)) continue;
            fewest = lines;
            offPx = d->offPx;
            r_.nearest = NearestTemplate{s.entry->tmpl.id, s.entry->tmpl.name, s.aspect->name,
                                         std::move(d->missing), std::move(d->extra)};
            nearestDegrees_ = s.degrees;
            difference_ = tellDifference(r_.nearest->missing.size(), r_.nearest->extra.size());
        }
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
        const std::vector<int> mine = degrees(r_.graph);
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
