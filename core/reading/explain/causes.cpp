// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/explain/causes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <set>

#include "core/base/words.h"
#include "core/edge_graph/build.h"
#include "core/reading/explain/convergence.h"
#include "core/reading/explain/nearest_template.h"

namespace ew {
namespace {

constexpr int kMostReadings = 4;
constexpr std::size_t kMostStrokes = 60;  // a larger drawing takes too long to read again

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Vec2 middleOf(const std::array<Vec2, 2>& line) { return 0.5 * (line[0] + line[1]); }

double pathLength(const Stroke& stroke) {
    double length = 0.0;
    for (std::size_t i = 1; i < stroke.samples.size(); ++i) {
        length += (stroke.samples[i].position - stroke.samples[i - 1].position).norm();
    }
    return length;
}

/// The point half way along.
Vec2 middleOf(const Stroke& stroke) {
    double left = 0.5 * pathLength(stroke);
    for (std::size_t i = 1; i < stroke.samples.size(); ++i) {
        const Vec2 from = stroke.samples[i - 1].position;
        const Vec2 step = stroke.samples[i].position - from;
        if (step.norm() >= left && step.norm() > 0.0) return from + step * (left / step.norm());
        left -= step.norm();
    }
    return stroke.samples.back().position;
}

/// The sample farthest from the line between the ends: the bend.
Vec2 bendOf(const Stroke& stroke) {
    const Vec2 a = stroke.samples.front().position;
    const Vec2 d = (stroke.samples.back().position - a).normalized();
    const auto farthest = std::max_element(
        stroke.samples.begin(), stroke.samples.end(), [&](const auto& p, const auto& q) {
            return std::abs(cross2(d, p.position - a)) < std::abs(cross2(d, q.position - a));
        });
    return farthest->position;
}

std::vector<Stroke> without(const std::vector<Stroke>& strokes, const std::set<int>& gone) {
    std::vector<Stroke> kept;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (!gone.contains(static_cast<int>(i))) kept.push_back(strokes[i]);
    }
    return kept;
}

/// May the reading be told better? What it says of an open end, a flat outline, too many strokes or
/// bad numbers is the cause itself.
bool mayBeTold(const Interpretation& reading) {
    if (reading.accepted || !reading.problem) return false;
    const Errc code = reading.problem->code;
    const auto any = {Errc::NoMatch,         Errc::NotParallel,  Errc::NoSolution,
                      Errc::SelfCrossing,    Errc::CurvedStroke, Errc::NoRegion,
                      Errc::ImpossibleCorner};
    if (std::find(any.begin(), any.end(), code) != any.end()) return true;
    if (code != Errc::Ambiguous || reading.candidates.empty()) return false;
    const Candidate& best = reading.candidates.front();
    return best.missingEdges > 0 || best.extraEdges > 0 || !best.unusedStrokes.empty() ||
           !reading.graph.dangling.empty() || !reading.graph.noise.empty();
}

class Search {
  public:
    Search(const std::vector<Stroke>& strokes, const TemplateLibrary& library,
           const InterpretOptions& options, const ReadAgain& read, Interpretation& reading)
        : strokes_(strokes), library_(library), options_(options), read_(read), r_(reading) {}

    void run() {
        if (tooSmall() || r_.accepted || strokes_.size() > kMostStrokes) return;
        // Three lines may converge by chance; that is no reason against what explains all of them.
        if (isQuestion()) inPerspective(4);
        if (!mayBeTold(r_)) return;
        if (curved()) return;
        if (nearest_ = nearestOf(); missing()) return;
        if (!extra()) inPerspective(3);
    }

  private:
    /// Of solids that have all of the lines.
    bool isQuestion() const {
        return r_.problem && r_.problem->code == Errc::Ambiguous && options_.bodies.empty() &&
               !mayBeTold(r_);
    }

    std::optional<Nearest> nearestOf() const {
        if (r_.graph.empty() || !options_.bodies.empty()) return std::nullopt;
        return nearestTemplate(r_.graph, library_, options_.thresholds.distancePx);
    }

    /// What the changed drawing is, where it is taken by itself; costs one of kMostReadings.
    std::optional<Candidate> readAs(const std::vector<Stroke>& strokes) {
        if (strokes.empty() || ++readings_ > kMostReadings) return std::nullopt;
        Interpretation again = read_(strokes);
        if (!again.accepted) return std::nullopt;
        Candidate taken = again.candidates[at(*again.accepted)];
        const bool clean = taken.missingEdges == 0 && taken.extraEdges == 0;
        if (!clean) return std::nullopt;
        return taken;
    }

    void tell(Errc code, std::string message, const std::vector<Vec2>& where, Repair repair) {
        r_.problem = Error{code, std::move(message), where};
        std::erase_if(r_.repairs, [](const Repair& p) {
            return p.kind != Repair::Kind::UseCandidate && p.kind != Repair::Kind::RaiseAngle &&
                   p.kind != Repair::Kind::RaiseDistance;
        });
        r_.repairs.insert(r_.repairs.begin(), std::move(repair));
    }

    void mark(Culprit::Kind kind, const Vec2& p, const char* label) {
        std::erase_if(r_.culprits, [kind](const Culprit& c) {
            return c.kind == kind || c.kind == Culprit::Kind::BadJunction ||
                   c.kind == Culprit::Kind::Crossing;
        });
        r_.culprits.push_back({kind, p, p, label, -1, -1});
    }

    /// Many lines so near together that all of them meet.
    bool tooSmall() {
        if (r_.accepted) return false;
        Eigen::AlignedBox2d box;
        double length = 0.0;
        for (const Stroke& s : strokes_) {
            length += pathLength(s);
            for (const PenSample& p : s.samples) box.extend(p.position);
        }
        const double across = box.diagonal().norm();
        // A dot or a tick is small, too, but no drawing.
        const bool isDrawing = strokes_.size() >= 3 || length > 3.0 * across;
        if (across > 2.0 * options_.thresholds.distancePx || !isDrawing || length < 8.0) {
            return false;
        }
        r_.candidates.clear();
        r_.repairs.clear();
        r_.culprits.clear();
        r_.problem = Error{Errc::TooSmall,
                           "This is too small to be read: it is " +
                               std::to_string(static_cast<int>(std::ceil(across))) +
                               " px across. Zoom in and draw it larger.",
                           {box.center()}};
        return true;
    }

    bool curved() {
        for (const NoiseItem& n : r_.graph.noise) {
            if (n.kind != NoiseKind::Curve || n.stroke < 0) continue;
            const Stroke& bent = strokes_[at(n.stroke)];
            const Vec2 from = bent.samples.front().position;
            const Vec2 to = bent.samples.back().position;
            if ((to - from).norm() < options_.thresholds.distancePx) continue;
            std::vector<Stroke> changed = strokes_;
            changed[at(n.stroke)] = straightStroke(from, to);
            if (!readAs(changed)) continue;
            Repair redraw;
            redraw.kind = Repair::Kind::Redraw;
            redraw.label = "Draw it straight";
            redraw.from = from;
            redraw.to = to;
            redraw.strokes = {n.stroke};
            redraw.lines = {{from, to}};
            const Vec2 bend = bendOf(bent);
            mark(Culprit::Kind::Stray, bend, "a curve");
            tell(Errc::CurvedEdge,
                 "This line is a curve; solids are drawn with straight lines (round them "
                 "afterwards).",
                 {bend}, std::move(redraw));
            return true;
        }
        return false;
    }

    bool missing() {
        if (!nearest_ || nearest_->shown.missing.size() != 1 || !nearest_->shown.extra.empty() ||
            nearest_->strays > 0) {
            return false;
        }
        const std::array<Vec2, 2> line = nearest_->shown.missing.front();
        std::vector<Stroke> changed = strokes_;
        changed.push_back(straightStroke(line[0], line[1]));
        if (!readAs(changed)) return false;
        Repair draw;
        draw.kind = Repair::Kind::Redraw;
        draw.label = "Draw the missing line";
        draw.from = line[0];
        draw.to = line[1];
        draw.lines = {line};
        const Vec2 middle = middleOf(line);
        tell(Errc::MissingEdge,
             "One line is missing here; with it this is " +
                 withArticle(nearest_->shown.templateName) + ".",
             {middle}, std::move(draw));
        r_.nearest = std::move(nearest_->shown);
        return true;
    }

    /// Strokes that may be too many, likeliest first: each of them is tried.
    std::vector<std::set<int>> suspects() const {
        std::vector<std::set<int>> all;
        const auto add = [&](const std::vector<int>& strokes) {
            std::set<int> some;
            for (const int s : strokes) {
                if (s >= 0) some.insert(s);
            }
            const bool known = std::find(all.begin(), all.end(), some) != all.end();
            if (!some.empty() && !known) all.push_back(some);
        };
        if (!r_.candidates.empty()) add(r_.candidates.front().unusedStrokes);
        std::vector<int> strays;
        for (const NoiseItem& n : r_.graph.noise) {
            if (n.kind == NoiseKind::Stray) strays.push_back(n.stroke);
        }
        add(strays);
        if (nearest_ && nearest_->shown.missing.empty() && nearest_->shown.extra.size() <= 2) {
            for (const int e : nearest_->shown.extra) add(r_.graph.edges[at(e)].strokes);
        }
        std::vector<int> dangling;
        for (const DanglingEdge& d : r_.graph.dangling) {
            dangling.insert(dangling.end(), d.strokes.begin(), d.strokes.end());
        }
        add(dangling);
        return all;
    }

    bool extra() {
        for (const std::set<int>& gone : suspects()) {
            const auto taken = readAs(without(strokes_, gone));
            if (!taken) continue;
            const bool one = gone.size() == 1;
            const bool hidden = std::all_of(gone.begin(), gone.end(), [&](int s) {
                return runsAlongHidden(strokes_[at(s)], *taken);
            });
            std::vector<Vec2> where;
            for (const int s : gone) {
                where.push_back(middleOf(strokes_[at(s)]));
            }
            Repair drop;
            drop.kind = Repair::Kind::DropStrokes;
            drop.label = one ? "Drop this line" : "Drop these lines";
            drop.from = drop.to = where.front();
            drop.strokes.assign(gone.begin(), gone.end());
            mark(Culprit::Kind::Stray, where.front(), hidden ? "cannot be seen" : "is no edge");
            const std::string name = withArticle(taken->templateName);
            const std::string lines = one ? "this line" : "these lines";
            if (hidden) {
                tell(Errc::HiddenLine,
                     "Without " + lines + " this is " + name +
                         "; edges that cannot be seen from here are not drawn.",
                     where, std::move(drop));
            } else {
                tell(Errc::ExtraEdge, "Without " + lines + " this is " + name + ".", where,
                     std::move(drop));
            }
            return true;
        }
        return false;
    }

    /// Right-angled templates are read in perspective, other solids are not.
    void inPerspective(std::size_t leastLines) {
        if (!r_.candidates.empty() && r_.candidates.front().depth == DepthRule::Perspective) return;
        // The reading may speak of a graph without some of the lines.
        const InkReading ink = readInk(strokes_, options_.thresholds.distancePx);
        const auto graphs = buildEdgeGraphs(ink, options_.thresholds.distancePx);
        const auto graph = std::max_element(graphs.begin(), graphs.end(), [](auto& a, auto& b) {
            return a.edges.size() < b.edges.size();
        });
        if (graph == graphs.end()) return;
        if (const auto found =
                findConvergence(*graph, ink, options_.thresholds.distancePx, leastLines))
            r_.problem = perspectiveError(*found);
    }

    /// Does a stroke run along edges of the candidate? Those that are seen have been drawn.
    bool runsAlongHidden(const Stroke& stroke, const Candidate& c) const {
        std::vector<std::array<Vec2, 2>> edges;
        for (const auto& face : c.spec.faces) {
            for (std::size_t k = 0; k < face.size(); ++k) {
                const Vec3 a = c.pose.toWorld(c.spec.vertices[at(face[k])]);
                const Vec3 b = c.pose.toWorld(c.spec.vertices[at(face[(k + 1) % face.size()])]);
                edges.push_back({options_.camera.project(a), options_.camera.project(b)});
            }
        }
        std::size_t near = 0;
        const double reach = options_.thresholds.distancePx;
        for (const PenSample& p : stroke.samples) {
            near +=
                std::any_of(edges.begin(), edges.end(),
                            [&](const auto& e) {
                                return distanceToSegment(p.position, e[0], e[1], reach) <= reach;
                            })
                    ? 1
                    : 0;
        }
        return near * 10 >= stroke.samples.size() * 8;
    }

    const std::vector<Stroke>& strokes_;
    const TemplateLibrary& library_;
    const InterpretOptions& options_;
    const ReadAgain& read_;
    Interpretation& r_;
    std::optional<Nearest> nearest_;
    int readings_ = 0;
};

}  // namespace

void findCause(const std::vector<Stroke>& strokes, const TemplateLibrary& library,
               const InterpretOptions& options, const ReadAgain& read, Interpretation& reading) {
    Search(strokes, library, options, read, reading).run();
}

}  // namespace ew
