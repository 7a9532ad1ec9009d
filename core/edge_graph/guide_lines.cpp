// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/guide_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/tolerance.h"
#include "core/edge_graph/alike_lines.h"
#include "core/edge_graph/wire_graph.h"
#include "core/stroke/consolidate.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr std::size_t kFewestLines = 6;
constexpr std::size_t kMostLines = 40;
constexpr std::size_t kMostSegments = 3 * kMostLines;
constexpr double kLeastSine = 0.1;        ///< lines that turn by less do not cross at a place
constexpr double kReach = 0.7;            ///< by which a line may stop short [distance thresholds]
constexpr double kOnePlace = 0.5;         ///< crossings so near are one place [distance thresholds]
constexpr double kOneRuledPlacePx = 0.8;  ///< ... where no hand errs
constexpr double kLeastEdge = 1.5;        ///< [distance thresholds]
constexpr double kLeastTail = 1.0;        ///< what runs on less is a slip of the pen [thresholds]
constexpr std::size_t kLinesAnUnused = 20;
constexpr double kFewestTails = 0.4;  ///< share of the lines that run past a corner

constexpr double kSlackWobbles = 2.0;  ///< by which an end runs on
constexpr double kMostSlack = 0.2;     ///< ... at most [distance thresholds]

// Prices, in mean lengths of a line that are cut off.
constexpr double kMissedPlace = 1.0;  ///< three lines meet, and this one has no end there
constexpr double kEndsOnLine = 0.5;
constexpr double kApart = 3.0;  ///< edges that do not meet the others
constexpr double kPassesCorner = 1.0;
constexpr double kLineUnused = 1.5;  ///< besides its length

struct Place {
    std::vector<Vec2> crossings;  ///< [px]
    std::set<int> lines;
};

/// The stretch of a line that is an edge; no places where the line is none.
struct Stretch {
    std::size_t from = 0, to = 0;  ///< of the places along the line
    bool used = false;
    double cost = 0.0;
};

struct PlaceOnLine {
    double t = 0.0;  ///< [px from InkLine::a]
    int place = -1;
};

class Trimmer {
  public:
    Trimmer(std::vector<InkLine> lines, double wobblePx, double distancePx)
        : lines_(std::move(lines)),
          distance_(distancePx),
          onePlacePx_(wobblePx < tol::kRuledPx ? kOneRuledPlacePx : kOnePlace * distancePx) {}

    const std::vector<InkLine>& lines() const { return lines_; }
    const std::vector<std::vector<PlaceOnLine>>& along() const { return along_; }

    struct Way {
        std::vector<Stretch> stretches;  ///< one a line
        double cost = 0.0;
    };

    std::vector<Way> run(std::size_t most) {
        findPlaces();
        findStretches();
        findOrder();
        most_ = most;
        chosen_.resize(lines_.size());
        const std::vector<Count> none(places_.size());
        choose(0, 0.0, none);
        return std::move(found_);
    }

  private:
    /// What the lines that were looked at do at a place.
    struct Count {
        int end = 0, pass = 0, seen = 0;
    };
    static constexpr int kMostWork = 60000;

    void findPlaces() {
        struct Crossing {
            Vec2 at;
            int a, b;
        };
        std::vector<Crossing> crossings;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                if (const auto p = crossing(lines_[i], lines_[k])) {
                    crossings.push_back({*p, static_cast<int>(i), static_cast<int>(k)});
                }
            }
        }
        DisjointSets groups(crossings.size());
        for (std::size_t i = 0; i < crossings.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                if ((crossings[i].at - crossings[k].at).norm() < onePlacePx_) {
                    groups.join(static_cast<int>(i), static_cast<int>(k));
                }
            }
        }
        std::vector<int> number(crossings.size(), -1);
        for (std::size_t i = 0; i < crossings.size(); ++i) {
            int& n = number[at(groups.root(static_cast<int>(i)))];
            if (n < 0) {
                n = static_cast<int>(places_.size());
                places_.emplace_back();
            }
            Place& place = places_[at(n)];
            place.crossings.push_back(crossings[i].at);
            place.lines.insert({crossings[i].a, crossings[i].b});
        }
        along_.resize(lines_.size());
        for (std::size_t p = 0; p < places_.size(); ++p) {
            Vec2 middle = Vec2::Zero();
            for (const Vec2& c : places_[p].crossings) middle += c;
            middle /= static_cast<double>(places_[p].crossings.size());
            for (const int i : places_[p].lines) {
                const InkLine& line = lines_[at(i)];
                along_[at(i)].push_back(
                    {(middle - line.a).dot(line.direction()), static_cast<int>(p)});
            }
        }
        for (auto& places : along_) {
            std::sort(places.begin(), places.end(),
                      [](const PlaceOnLine& a, const PlaceOnLine& b) { return a.t < b.t; });
        }
    }

    std::optional<Vec2> crossing(const InkLine& a, const InkLine& b) const {
        const Vec2 d = a.direction();
        const Vec2 e = b.direction();
        const double sine = cross2(d, e);
        if (std::abs(sine) < kLeastSine) return std::nullopt;
        const double reach = kReach * distance_;
        const double s = cross2(Vec2(b.a - a.a), e) / sine;
        const double t = cross2(Vec2(b.a - a.a), d) / sine;
        if (s < -reach || s > a.length() + reach) return std::nullopt;
        if (t < -reach || t > b.length() + reach) return std::nullopt;
        return Vec2(a.a + s * d);
    }

    bool isCorner(int place) const { return places_[at(place)].lines.size() >= 3; }

    void findStretches() {
        stretches_.resize(lines_.size());
        double mean = 0.0;
        for (const InkLine& l : lines_) mean += l.length() / static_cast<double>(lines_.size());
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const std::vector<PlaceOnLine>& places = along_[i];
            const auto corners = static_cast<double>(std::count_if(
                places.begin(), places.end(), [&](const auto& p) { return isCorner(p.place); }));
            for (std::size_t from = 0; from < places.size(); ++from) {
                for (std::size_t to = from + 1; to < places.size(); ++to) {
                    const double length = places[to].t - places[from].t;
                    if (length < kLeastEdge * distance_) continue;
                    const double tails = std::max(0.0, places[from].t) +
                                         std::max(0.0, lines_[i].length() - places[to].t);
                    const double ends = (isCorner(places[from].place) ? 1.0 : 0.0) +
                                        (isCorner(places[to].place) ? 1.0 : 0.0);
                    stretches_[i].push_back(
                        {from, to, true, tails / mean + kMissedPlace * (corners - ends)});
                }
            }
            stretches_[i].push_back({0, 0, false, kLineUnused + lines_[i].length() / mean});
            std::stable_sort(stretches_[i].begin(), stretches_[i].end(),
                             [](const Stretch& a, const Stretch& b) { return a.cost < b.cost; });
        }
    }

    /// Lines that share places with those before come next, so that a place which cannot be is
    /// found early.
    void findOrder() {
        std::vector<bool> taken(lines_.size(), false);
        std::set<int> reached;
        while (order_.size() < lines_.size()) {
            std::size_t best = 0;
            int most = -1;
            for (std::size_t i = 0; i < lines_.size(); ++i) {
                if (taken[i]) continue;
                int shared = 0;
                for (const PlaceOnLine& p : along_[i]) {
                    const int weight = isCorner(p.place) ? 2 : 1;
                    shared += weight * ((reached.contains(p.place) ? 4 : 0) + 1);
                }
                if (shared > most) {
                    most = shared;
                    best = i;
                }
            }
            taken[best] = true;
            order_.push_back(best);
            for (const PlaceOnLine& p : along_[best]) reached.insert(p.place);
        }
        least_.assign(lines_.size() + 1, 0.0);
        for (std::size_t k = lines_.size(); k-- > 0;) {
            least_[k] = least_[k + 1] + stretches_[order_[k]].front().cost;
        }
    }

    double bound() const {
        return found_.size() < most_ ? std::numeric_limits<double>::infinity() : found_.back().cost;
    }

    void choose(std::size_t k, double cost, const std::vector<Count>& counts) {
        if (cost + least_[k] >= bound() || ++work_ > kMostWork) return;
        if (k == order_.size()) {
            keep(cost);
            return;
        }
        const std::size_t i = order_[k];
        for (const Stretch& s : stretches_[i]) {
            if (cost + s.cost + least_[k + 1] >= bound()) return;
            std::vector<Count> next = counts;
            const auto more = priceOfPlaces(i, s, next);
            if (!more) continue;
            chosen_[i] = s;
            choose(k + 1, cost + s.cost + *more, next);
        }
    }

    /// What the places cost at which all lines are known now; nothing where one cannot be.
    std::optional<double> priceOfPlaces(std::size_t i, const Stretch& s,
                                        std::vector<Count>& counts) const {
        double price = 0.0;
        for (std::size_t n = 0; n < along_[i].size(); ++n) {
            const int place = along_[i][n].place;
            Count& c = counts[at(place)];
            ++c.seen;
            if (s.used && (n == s.from || n == s.to)) ++c.end;
            if (s.used && n > s.from && n < s.to) ++c.pass;
            if (c.pass > 1) return std::nullopt;
            if (c.seen < static_cast<int>(places_[at(place)].lines.size())) continue;
            if (c.end == 1 && c.pass == 0) return std::nullopt;
            if (c.end == 1) price += kEndsOnLine;
            if (c.end > 1 && c.pass > 0) price += kPassesCorner;
        }
        return price;
    }

    /// How many groups of edges there are that do not meet.
    std::size_t parts() const {
        DisjointSets groups(places_.size());
        std::set<int> ends;
        for (std::size_t i = 0; i < chosen_.size(); ++i) {
            const Stretch& s = chosen_[i];
            if (!s.used) continue;
            // A place inside may be the end of another line, or of none.
            for (std::size_t n = s.from; n <= s.to; ++n) {
                groups.join(along_[i][n].place, along_[i][s.from].place);
            }
            ends.insert(along_[i][s.from].place);
        }
        std::set<int> roots;
        for (const int place : ends) roots.insert(groups.root(place));
        return roots.size();
    }

    void keep(double cost) {
        const std::size_t apart = parts();
        if (apart == 0) return;
        cost += kApart * static_cast<double>(apart - 1);
        if (cost >= bound()) return;
        const auto after =
            std::upper_bound(found_.begin(), found_.end(), cost,
                             [](double value, const Way& way) { return value < way.cost; });
        found_.insert(after, {chosen_, cost});
        if (found_.size() > most_) found_.pop_back();
    }

    std::vector<InkLine> lines_;
    double distance_;
    double onePlacePx_;  ///< crossings so near are one place
    std::vector<Place> places_;
    std::vector<std::vector<PlaceOnLine>> along_;  ///< per line, ascending
    std::vector<std::vector<Stretch>> stretches_;  ///< per line, the cheapest first
    std::vector<std::size_t> order_;
    std::vector<double> least_;  ///< cost of the lines from there on, at least
    std::size_t most_ = 1;
    int work_ = 0;
    std::vector<Stretch> chosen_;
    std::vector<Way> found_;
};

/// The line that a segment is part of.
int lineOf(const Segment& s, const std::vector<InkLine>& lines) {
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const InkLine& line = lines[i];
        if (!std::binary_search(line.strokes.begin(), line.strokes.end(), s.stroke)) continue;
        const Vec2 d = line.direction();
        const double off =
            std::abs(cross2(d, Vec2(s.a - line.a))) + std::abs(cross2(d, Vec2(s.b - line.a)));
        if (off < least) {
            least = off;
            best = static_cast<int>(i);
        }
    }
    return best;
}

/// Cuts a segment off at both ends of a stretch of its line [px from InkLine::a].
std::optional<Segment> clipped(const Segment& s, const InkLine& line, double from, double to) {
    const Vec2 d = line.direction();
    const double ta = (s.a - line.a).dot(d);
    const double tb = (s.b - line.a).dot(d);
    const double span = tb - ta;
    if (std::abs(span) < 1e-9) return std::nullopt;
    const double lo = std::max(from, std::min(ta, tb));
    const double hi = std::min(to, std::max(ta, tb));
    if (hi <= lo) return std::nullopt;
    const auto point = [&](double t) { return Vec2(s.a + (s.b - s.a) * ((t - ta) / span)); };
    Segment out = s;
    out.a = point(span > 0.0 ? lo : hi);
    out.b = point(span > 0.0 ? hi : lo);
    out.joinedToNext = s.joinedToNext && out.b == s.b;
    out.inkPx = s.inkPx * (hi - lo) / std::abs(span);
    std::erase_if(out.points, [&](const Vec2& p) {
        const double t = (p - line.a).dot(d);
        return t < lo || t > hi;
    });
    return out;
}

/// Was a line drawn again beside one that is an edge?
bool isDrawnAgain(const InkLine& line, const Trimmer& trimmer, const Trimmer::Way& way,
                  double distancePx) {
    for (std::size_t i = 0; i < way.stretches.size(); ++i) {
        const InkLine& other = trimmer.lines()[i];
        if (!way.stretches[i].used || other.length() < line.length()) continue;
        if (std::abs(cross2(line.direction(), other.direction())) > kAlongSine) continue;
        if (distanceToSegment(line.a, other.a, other.b, distancePx) < distancePx &&
            distanceToSegment(line.b, other.a, other.b, distancePx) < distancePx) {
            return true;
        }
    }
    return false;
}

TrimmedInk trimmed(const InkReading& ink, const Trimmer& trimmer, const Trimmer::Way& way,
                   double distancePx) {
    TrimmedInk out;
    out.cost = way.cost;
    out.ink = ink;
    out.ink.segments.clear();
    // A hand's ends do not meet in a point; who reads them on takes their spread for the hand's.
    const double slack = std::min(kSlackWobbles * ink.wobblePx, kMostSlack * distancePx);
    std::set<int> kept;
    std::set<int> all;
    for (const Segment& s : ink.segments) {
        all.insert(s.stroke);
        const int i = lineOf(s, trimmer.lines());
        const Stretch stretch = i < 0 ? Stretch{} : way.stretches[at(i)];
        if (!stretch.used) {
            if (i >= 0 && isDrawnAgain(trimmer.lines()[at(i)], trimmer, way, distancePx)) {
                kept.insert(s.stroke);
            }
            out.tails.push_back({NoiseKind::Stray, s.stroke, {s.a, s.b}});
            continue;
        }
        const InkLine& line = trimmer.lines()[at(i)];
        const auto& places = trimmer.along()[at(i)];
        kept.insert(s.stroke);
        auto part = clipped(s, line, places[stretch.from].t - slack, places[stretch.to].t + slack);
        if (!part || (part->b - part->a).norm() < distancePx) {
            out.tails.push_back({NoiseKind::Overshoot, s.stroke, {s.a, s.b}});
            continue;
        }
        for (const auto& [whole, cut] : {std::pair(s.a, part->a), std::pair(s.b, part->b)}) {
            if ((whole - cut).norm() < 1.0) continue;
            out.tails.push_back({NoiseKind::Overshoot, s.stroke, {cut, whole}});
        }
        out.ink.segments.push_back(*std::move(part));
    }
    std::set_difference(all.begin(), all.end(), kept.begin(), kept.end(),
                        std::back_inserter(out.dropped));
    return out;
}

/// The share of the lines that run past the places where their edges end; 0 where too few lines
/// are edges, or too many are none.
double guideShare(const Trimmer& trimmer, const Trimmer::Way& way, double distancePx) {
    std::size_t used = 0;
    std::size_t past = 0;
    std::size_t unused = 0;
    for (std::size_t i = 0; i < way.stretches.size(); ++i) {
        const Stretch& s = way.stretches[i];
        if (!s.used) {
            unused += isDrawnAgain(trimmer.lines()[i], trimmer, way, distancePx) ? 0 : 1;
            continue;
        }
        ++used;
        const auto& places = trimmer.along()[i];
        const double tail =
            std::max(places[s.from].t, trimmer.lines()[i].length() - places[s.to].t);
        if (tail > kLeastTail * distancePx) ++past;
    }
    if (used < kFewestLines || unused > 1 + used / kLinesAnUnused) return 0.0;
    return static_cast<double>(past) / static_cast<double>(used);
}

}  // namespace

std::vector<TrimmedInk> trimGuideLines(const InkReading& ink, double distancePx, std::size_t most) {
    if (ink.segments.size() > kMostSegments || !crossesLikeWires(ink, distancePx)) return {};
    std::vector<TrimmedInk> out;
    std::size_t fewer = 0;
    for (const LineJoining& how : {kStrictJoining, kLooseJoining}) {
        std::vector<InkLine> lines;
        for (const Segment& s : ink.segments) {
            lines.push_back({s.a, s.b, {s.stroke}, s.points, s.inkPx});
        }
        joinAlike(lines, how, distancePx);
        if (lines.size() < kFewestLines || lines.size() > kMostLines) continue;
        if (lines.size() == fewer) break;
        fewer = lines.size();
        Trimmer trimmer(std::move(lines), ink.wobblePx, distancePx);
        for (const Trimmer::Way& way : trimmer.run(most)) {
            const double share = guideShare(trimmer, way, distancePx);
            if (share < kFewestTails) continue;
            out.push_back(trimmed(ink, trimmer, way, distancePx));
            out.back().share = share;
        }
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const TrimmedInk& a, const TrimmedInk& b) { return a.cost < b.cost; });
    if (out.size() > most) out.resize(most);
    return out;
}

}  // namespace ew
