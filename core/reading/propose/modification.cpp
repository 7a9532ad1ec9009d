// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/modification.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "core/base/tolerance.h"
#include "core/base/words.h"
#include "core/edge_graph/canonical.h"
#include "core/reading/evidence/accidental.h"
#include "core/reading/evidence/hand_noise.h"
#include "core/reading/evidence/ink_extent.h"
#include "core/reading/extract/joint_graph.h"
#include "core/reading/overlay/box_on_solid.h"
#include "core/reading/propose/cracking.h"
#include "core/reading/propose/ink_on_solid.h"
#include "core/reading/propose/placement.h"
#include "core/reading/propose/placement_price.h"
#include "core/reading/score/probability.h"
#include "core/reading/solve/general_fit.h"
#include "core/reading/types/reading_params.h"
#include "core/solid/boolean.h"
#include "core/tlib/matcher.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A placement with where it comes from.
struct Option {
    Placement placement;
    GraphMatch match;
    std::shared_ptr<const JointGraph> joint;
    JointReading reading;
    int body = -1;
    int shells = 0;  ///< more than before
    double cost = 0.0;
    double leftOutPx = 0.0;  ///< ink that it does not explain
    bool plain = true;       ///< found among the model's directions
    std::optional<Solid> result;
    std::vector<int> cracked;  ///< faces of the solid that it meets, not drawn on
    bool adjusted = false;     ///< moved off one of those
};

class Modification {
  public:
    Modification(const InkReading& ink, const TemplateLibrary& library,
                 const InterpretOptions& options)
        : ink_(ink),
          index_(onSolidIndex(library.index())),
          options_(options),
          distance_(options.thresholds.distancePx) {
        noise_ =
            std::max({tol::kNoiseFloorPx, handNoisePx(ink), endSpread(ink.segments, distance_)});
        spread_ = tol::kSpreadPerWobble / tol::kMissPerWobble * noise_;
    }

    ModificationReading run() {
        for (std::size_t b = 0; b < options_.bodies.size(); ++b) {
            auto view = ModelView::make(options_.bodies[b], options_.camera);
            if (!view) {
                problem_ = view.error();
                continue;
            }
            views_.emplace(static_cast<int>(b), std::move(*view));
            out_.touches = out_.touches ||
                           shareOver(ink_, views_.at(static_cast<int>(b))) > params::kTouchingInk;
            read(views_.at(static_cast<int>(b)), static_cast<int>(b));
        }
        std::stable_sort(found_.begin(), found_.end(),
                         [](const Option& a, const Option& b) { return a.cost < b.cost; });
        carryOut();
        conclude();
        return std::move(out_);
    }

  private:
    /// A matched part of a joint graph.
    struct Match {
        std::shared_ptr<const JointGraph> joint;
        JointReading reading;
        GraphMatch match;
        double price;
    };

    void read(const ModelView& view, int body) {
        static const std::vector<ReadingOptions> kReadings{{},
                                                           {1.0, 1.3, 0.7},
                                                           {0.72, 0.6, 0.2},
                                                           {1.3, 1.0, 0.4, 1.8},
                                                           {1.3, 1.6, 0.7, 1.8},
                                                           {1.6, 1.3, 0.7, 2.2},
                                                           {1.6, 0.8, 0.2, 2.2}};
        // What fits with the model's directions is quick to find and needs no other.
        std::vector<std::vector<Match>> looks;
        for (std::size_t i = 0; i < kReadings.size(); ++i) {
            // Reaching past the distance threshold is for unsteady hands.
            if (kReadings[i].joinScale > 1.0 && spread_ < 0.25 * distance_) continue;
            const double price = i == 0 ? 0.0 : tol::kSecondLookCost;
            std::vector<Match>& matches = looks.emplace_back();
            if (readJoint(view, {options_.thresholds, kReadings[i]}, price, matches)) {
                // A line beside a model edge may be one of its own.
                readJoint(view, {options_.thresholds, kReadings[i], false},
                          price + tol::kSecondLookCost, matches);
            }
            place(matches, view, body, true);
            if (understood(tol::kPlainMisfit)) return;
        }
        // Ends of an unsteady hand join wrongly, and between parts of the solid sides that every
        // aspect shows are out of sight, while the whole of the lines still tells.
        const bool unsteady = spread_ >= kUnsteadySpread * distance_;
        if (unsteady || found_.empty()) placeLaidBoxes(view, body, unsteady);
        if (understood(tol::kUnderstoodMisfit)) return;
        placeFreely(looks, view, body);
    }

    /// What turns freely is solved by iteration: a bounded number of those, for nobody waits a
    /// second for a reading. Those that leave out the least ink and run most nearly parallel first.
    void placeFreely(const std::vector<std::vector<Match>>& looks, const ModelView& view,
                     int body) {
        std::vector<std::pair<double, const Match*>> order;
        for (const auto& matches : looks) {
            for (const Match& m : matches) {
                order.emplace_back(m.price +
                                       tol::kExtraEdgeCost * m.reading.strayPx / (4.0 * distance_) +
                                       m.match.parallelDeg,
                                   &m);
            }
        }
        std::stable_sort(order.begin(), order.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        if (order.size() > kMostIterated) order.resize(kMostIterated);
        for (std::size_t i = 0; i < order.size(); ++i) {
            place({*order[i].second}, view, body, false);
            // The first that fits has rivals.
            if ((i + 1) % kRivals == 0 && understood(tol::kUnderstoodMisfit)) return;
        }
    }

    /// Does the best option explain all of the ink closely?
    /// \param misfit  at most, on average over its line ends.
    bool understood(double misfit) const {
        const auto best =
            std::min_element(found_.begin(), found_.end(),
                             [](const Option& a, const Option& b) { return a.cost < b.cost; });
        return best != found_.end() && best->leftOutPx < distance_ &&
               best->placement.misfit <=
                   2.0 * misfit * static_cast<double>(best->reading.graph.edges.size());
    }

    /// True where strokes were taken for model edges.
    bool readJoint(const ModelView& view, const ExtractOptions& extract, double price,
                   std::vector<Match>& matches) {
        const auto joint =
            std::make_shared<const JointGraph>(extractJointGraph(ink_, view, extract));
        out_.touches = out_.touches || joint->touches;
        out_.redraws = out_.redraws || (joint->redraws && joint->lines.empty());
        if (joint->edges.empty() || joint->inkEdges > kMostInkEdges) return false;
        const auto known = [this](const PlaneGraph& g) {
            const CanonicalForm form = canonicalForm(g);
            return !form.code.empty() && index_.byCode.contains(form.code);
        };
        MatchOptions m;
        m.distancePx = distance_;
        m.templateId = options_.templateId;
        m.spreadPx = spread_;
        for (const JointReading& r : closedReadings(*joint, known, distance_, kMostReadings)) {
            for (GraphMatch& found : matchGraph(r.graph, index_, m)) {
                const bool adds = found.aspect->kind == AspectKind::Explicit;
                const Operation asked = options_.operation;
                // Where an edge of the solid goes on in the air nothing is cut.
                if (adds ? asked == Operation::Cut : asked == Operation::Add || r.goesOn) continue;
                matches.push_back({joint, r, std::move(found), price});
            }
        }
        return joint->redraws;
    }

    void place(const std::vector<Match>& matches, const ModelView& view, int body, bool plain) {
        for (const Match& m : matches) {
            for (Placement& p : placementsOf(*m.joint, m.reading, m.match, view,
                                             {options_.thresholds, noise_, plain})) {
                consider(m, std::move(p), view, body, plain, 0.0);
            }
        }
    }

    /// \param strayPx  ink that is known to be left out [px].
    void consider(const Match& m, Placement placement, const ModelView& view, int body, bool plain,
                  double strayPx) {
        const int freedoms = templateFreedoms(m.match.entry->tmpl, m.match.entry->analysis);
        Option o;
        o.leftOutPx =
            std::max(strayPx, unexplainedInk(ink_, placement, m.match, view, distance_, noise_));
        o.cost = placement.cost + m.price + tol::kTemplateFreedomCost * freedoms +
                 tol::kExtraEdgeCost * o.leftOutPx / (4.0 * distance_);
        o.placement = std::move(placement);
        o.match = m.match;
        o.joint = m.joint;
        o.reading = m.reading;
        o.body = body;
        o.plain = plain;
        found_.push_back(std::move(o));
    }

    /// \param all  not only those that stand between two walls.
    void placeLaidBoxes(const ModelView& view, int body, bool all) {
        for (const auto& entry : index_.entries) {
            if (!isBox(*entry)) continue;
            if (!options_.templateId.empty() && entry->tmpl.id != options_.templateId) continue;
            for (LaidBox& laid : layBoxes(ink_, view, entry, {options_.thresholds, noise_})) {
                if (!all && !laid.betweenWalls) continue;
                if (options_.operation != Operation::Auto && options_.operation != laid.operation) {
                    continue;
                }
                // Ink beside a box that was laid over it was drawn for something.
                const double beside =
                    tol::kBesideOutline * tol::kExtraEdgeCost * laid.strayPx / (4.0 * distance_);
                const Match m{laid.joint, std::move(laid.reading), std::move(laid.match),
                              laid.price + beside + tol::kSecondLookCost};
                for (Placement& p :
                     placementsOn({laid.operation, laid.pairs}, *m.joint, m.reading, m.match, view,
                                  {options_.thresholds, noise_, true})) {
                    consider(m, std::move(p), view, body, true, laid.strayPx);
                }
            }
        }
    }

    /// Makes the change of the most promising options; what cannot be made is dropped.
    void carryOut() {
        std::vector<Option> done;
        std::size_t tried = 0;
        for (Option& o : found_) {
            if (done.size() >= at(options_.maxCandidates) || tried == kMostTried) break;
            // What costs that much more is no other reading.
            if (!done.empty() && o.cost > done.front().cost + kFarDearer) break;
            if (repeats(o, done)) continue;
            ++tried;
            if (make(o, done)) done.push_back(std::move(o));
        }
        if (!done.empty()) adjust(done);
        found_ = std::move(done);
    }

    /// Makes an option's change; false where it cannot be or is one of those that are done.
    bool make(Option& o, const std::vector<Option>& done) {
        const Solid& target = options_.bodies[at(o.body)].solid;
        const bool adds = o.placement.operation == Operation::Add;
        auto tool = makeTool(target, o.placement.tool);
        if (!tool) {
            note(tool.error(), o);
            return false;
        }
        auto outcome = combine(target, *tool, adds ? BooleanKind::Add : BooleanKind::Cut);
        if (!outcome) {
            note(outcome.error(), o);
            return false;
        }
        // A body that is added stands on the solid; one beside it is another body.
        if (adds && outcome->report.shells > outcome->report.shellsBefore &&
            outcome->solid.area() > (1.0 - kTouching) * (target.area() + tool->area())) {
            return false;
        }
        const bool known = std::any_of(done.begin(), done.end(), [&](const Option& d) {
            return d.body == o.body && sameResult(o, *d.result, outcome->solid);
        });
        if (known) return false;
        o.shells = outcome->report.shells - outcome->report.shellsBefore;
        o.cracked = crackedFaces(target, outcome->report, o.placement);
        o.result = std::move(outcome->solid);
        return true;
    }

    /// Cracking (paper 5.2.3): where the best change meets faces that were not drawn on, the next
    /// candidate is the one that is adjusted to stay out of one of them, or of all.
    void adjust(std::vector<Option>& done) {
        const Option best = done.front();
        const ModelView& view = views_.at(best.body);
        const PlacementOptions options{options_.thresholds, noise_};
        const auto better = [&](std::optional<Placement> moved) {
            if (!moved) return false;
            Option o = best;
            o.placement = std::move(*moved);
            o.cost = best.cost + kAdjustCost;
            o.adjusted = true;
            if (!make(o, done) || o.cracked.size() >= best.cracked.size()) return false;
            done.insert(done.begin() + 1, std::move(o));
            return true;
        };
        for (const int face : best.cracked) {
            if (better(adjustedPlacement(*best.joint, best.reading, best.match, view, options,
                                         best.placement, face))) {
                return;
            }
        }
        // No hidden face is parallel: one ends before what it would meet.
        if (best.cracked.empty()) return;
        (void)better(clearPlacement(*best.joint, best.reading, best.match, view, options,
                                    best.placement, best.cracked));
    }

    /// Is it a body that was made already? Several looks at the strokes often end in the same, or
    /// in one that lies in the same faces and whose corners no hand can tell apart.
    bool repeats(const Option& o, const std::vector<Option>& done) const {
        constexpr double kSamePx = 0.01;
        return std::any_of(done.begin(), done.end(), [&](const Option& d) {
            const CameraPoints& p = o.placement.points;
            const CameraPoints& q = d.placement.points;
            const double reach = liesIn(o.placement) == liesIn(d.placement) ? distance_ : kSamePx;
            return d.body == o.body && d.placement.operation == o.placement.operation &&
                   d.match.entry == o.match.entry &&
                   std::all_of(p.begin(), p.end(), [&](const Vec3& x) {
                       return std::any_of(q.begin(), q.end(),
                                          [&](const Vec3& y) { return (x - y).norm() < reach; });
                   });
        });
    }

    /// Faces of the solid that sides of the body lie in.
    static std::multiset<int> liesIn(const Placement& p) {
        const std::vector<int> faces = solidFacesOf(p.coinciding);
        return {faces.begin(), faces.end()};
    }

    /// The reason that is told is that of the best option.
    void note(const Error& error, const Option& o) {
        if (problem_) return;
        problem_ = error;
        for (const Junction& j : o.reading.graph.junctions) {
            if (problem_->where.empty()) problem_->where.push_back(j.position);
        }
    }

    /// The same change but for what no hand can tell apart.
    bool sameResult(const Option& o, const Solid& a, const Solid& b) const {
        if (a.faces().size() != b.faces().size() || a.edges().size() != b.edges().size()) {
            return false;
        }
        const double before = options_.bodies[at(o.body)].solid.volume();
        const double change = a.volume() - before;
        const double off = std::abs(a.volume() - b.volume());
        if (off <= tol::kSameChange * std::abs(change)) return true;
        if (change * (b.volume() - before) < 0) return false;
        // Corner by corner within the distance threshold.
        const double reach = distance_ * options_.camera.worldPerPixel;
        return std::all_of(a.vertices().begin(), a.vertices().end(), [&](const Vec3& p) {
            return std::any_of(b.vertices().begin(), b.vertices().end(),
                               [&](const Vec3& q) { return (p - q).norm() <= reach; });
        });
    }

    void conclude() {
        Interpretation& r = out_.interpretation;
        if (found_.empty()) {
            r.graph = buildEdgeGraph(ink_, distance_);
            r.problem = problem_ ? *problem_ : whyNothing();
            return;
        }
        r.graph = found_.front().reading.graph;
        for (std::size_t i = 0; i < found_.size(); ++i) r.candidates.push_back(candidate(i));
        tellProbabilities(r.candidates, r.graph.edges.size());
        const Option& best = found_.front();
        const std::size_t rival = rivalOfBest();
        const double ink = inkLengthPx(ink_);
        // An unsteady hand's lines fit many bodies that turn freely.
        const bool likely =
            best.plain || noise_ < kSteadyPx || best.placement.parameters <= kFewParameters;
        const bool accidental =
            hidesItsTaper(*best.match.entry, *best.match.aspect, best.placement.points);
        // Most of what is drawn to be cut out lies over what it is cut out of.
        const bool beside = best.placement.operation == Operation::Cut &&
                            shareOver(ink_, views_.at(best.body)) < params::kCutInk;
        if (rival == 0 && likely && !beside && !accidental &&
            best.leftOutPx <= tol::kMostUnexplained * ink) {
            r.accepted = 0;
            return;
        }
        explainChoice(rival, accidental);
    }

    /// The first reading that is as likely as the best one and changes the solid otherwise; 0 where
    /// there is none. An adjusted one is the best one's own.
    std::size_t rivalOfBest() const {
        for (std::size_t i = 1; i < found_.size(); ++i) {
            if (found_[i].adjusted) continue;
            return found_[i].cost < found_[0].cost + tol::kClearMargin ? i : 0;
        }
        return 0;
    }

    Error whyNothing() const {
        if (out_.redraws) {
            return {Errc::NoChange,
                    "These lines are edges of the solid already: nothing would change.",
                    firstInk(ink_)};
        }
        return {Errc::NoMatch,
                "These lines and the edges that they meet show no template on the solid.",
                firstInk(ink_)};
    }

    void explainChoice(std::size_t rival, bool accidental) {
        Interpretation& r = out_.interpretation;
        std::vector<std::size_t> choice{0};
        if (rival > 0) choice.push_back(rival);
        std::string names;
        for (const std::size_t i : choice) {
            names += (names.empty() ? "" : " or ") + sentence(r.candidates[i]);
            Repair use;
            use.kind = Repair::Kind::UseCandidate;
            use.candidate = static_cast<int>(i);
            use.label = "Take: " + sentence(r.candidates[i]);
            r.repairs.push_back(std::move(use));
        }
        std::string message = "This could be " + names +
                              ", but only without some of the lines; choose it, or draw on.";
        if (rival > 0) {
            message = "This can be read as " + names + "; choose one.";
        } else if (accidental) {
            message = "Seen from here this could be " + names +
                      ", or something simpler; choose it, or turn the view and draw again.";
        }
        r.problem = Error{Errc::Ambiguous, std::move(message), firstInk(ink_)};
    }

    static std::string sentence(const Candidate& c) {
        return std::string(c.operation == Operation::Add ? "adding " : "cutting ") +
               withArticle(c.templateName);
    }

    Candidate candidate(std::size_t i) const {
        const Option& o = found_[i];
        Candidate c;
        c.templateId = o.match.entry->tmpl.id;
        c.templateName = o.match.entry->tmpl.name;
        c.aspect = o.match.aspect->name;
        c.operation = o.placement.operation;
        c.readingId = o.adjusted ? "adjusted" : "default";
        if (o.adjusted) {
            c.readingName = "Adjusted";
            c.notes.push_back("A hidden face was moved so that it meets nothing undrawn.");
        } else if (!o.cracked.empty()) {
            c.notes.push_back("Hidden faces meet faces that were not drawn on.");
        }
        c.residualPx = o.placement.residualPx;
        c.junctionVertex = o.match.vertex;
        c.spec = o.placement.tool.shape;
        c.pose = options_.bodies[at(o.body)].pose;
        c.body = o.body;
        c.result = o.result;
        c.unusedStrokes = strokesBeside(ink_, o.placement, o.match, views_.at(o.body), distance_);
        c.evidence = evidenceOf(o.placement, o.cost);
        const double off = c.residualPx / distance_;
        c.score = std::exp(-2.0 * off * off) *
                  (i == 0 ? 1.0 : std::exp(-std::max(0.0, o.cost - found_.front().cost) / 30.0));
        if (o.shells > 0 && c.operation == Operation::Add) {
            c.notes.push_back("It closes off a hollow inside the solid.");
        } else if (o.shells > 0) {
            c.notes.push_back("The solid falls into " + std::to_string(o.shells + 1) +
                              " separate pieces.");
        }
        return c;
    }

    static constexpr double kFarDearer = 40.0;
    static constexpr double kTouching = 1e-9;    ///< share of the area that is enough to touch in
    static constexpr double kAdjustCost = 16.0;  // never a rival
    static constexpr double kSteadyPx = 2.5;
    static constexpr int kFewParameters = 5;
    static constexpr std::size_t kMostInkEdges = 60;
    static constexpr std::size_t kMostReadings = 12;
    static constexpr std::size_t kMostTried = 12;
    static constexpr std::size_t kMostIterated = 30;
    static constexpr std::size_t kRivals = 10;

    const InkReading& ink_;
    const LibraryIndex& index_;
    const InterpretOptions& options_;
    double distance_;
    double noise_ = 1.0;              ///< how far this hand's line ends miss, per axis [px]
    double spread_ = 1.4;             ///< and two of them each other
    std::map<int, ModelView> views_;  ///< by body
    std::vector<Option> found_;
    std::optional<Error> problem_;
    ModificationReading out_;
};
}  // namespace

ModificationReading readModification(const InkReading& ink, const TemplateLibrary& library,
                                     const InterpretOptions& options) {
    return Modification(ink, library, options).run();
}

}  // namespace ew
