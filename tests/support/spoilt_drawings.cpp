// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/spoilt_drawings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/vec.h"
#include "core/solid/solid.h"
#include "tests/support/whole_shapes.h"

namespace ew::test {
namespace {

constexpr double kSamePx = 1e-6;

double lengthOf(const Line2& l) { return (l[1] - l[0]).norm(); }
Vec2 middleOf(const Line2& l) { return 0.5 * (l[0] + l[1]); }

std::size_t pick(std::size_t count, Random& random) {
    return static_cast<std::size_t>(random.index(static_cast<int>(count)));
}

Eigen::AlignedBox2d boundsOf(const std::vector<Line2>& lines) {
    Eigen::AlignedBox2d box;
    for (const Line2& l : lines) box.extend(l[0]).extend(l[1]);
    return box;
}

std::vector<Vec2> cornersOf(const std::vector<Line2>& lines) {
    std::vector<Vec2> corners;
    for (const Line2& l : lines) {
        for (const Vec2& end : l) {
            const bool known = std::any_of(corners.begin(), corners.end(), [&](const Vec2& c) {
                return (c - end).norm() < kSamePx;
            });
            if (!known) corners.push_back(end);
        }
    }
    return corners;
}

int linesAt(const std::vector<Line2>& lines, const Vec2& corner) {
    return static_cast<int>(std::count_if(lines.begin(), lines.end(), [&](const Line2& l) {
        return (l[0] - corner).norm() < kSamePx || (l[1] - corner).norm() < kSamePx;
    }));
}

/// A line that is long enough to be spoilt.
std::size_t longLine(const std::vector<Line2>& lines, double atLeastPx, Random& random) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lengthOf(lines[i]) >= atLeastPx) found.push_back(i);
    }
    if (!found.empty()) return found[pick(found.size(), random)];
    const auto longest =
        std::max_element(lines.begin(), lines.end(),
                         [](const Line2& a, const Line2& b) { return lengthOf(a) < lengthOf(b); });
    return static_cast<std::size_t>(longest - lines.begin());
}

std::vector<Line2> hiddenLines(const SketchCase& sketch) {
    const auto solid = Solid::fromSpec(sketch.spec);
    return solid ? wholeCase(*solid, sketch.camera).hidden : std::vector<Line2>{};
}

/// Is a line one of those drawn, or nearly along one?
bool alongAny(const std::vector<Line2>& lines, const Line2& wanted) {
    return std::any_of(lines.begin(), lines.end(), [&](const Line2& l) {
        const auto ends = [&](const Vec2& p) {
            return (l[0] - p).norm() < kSamePx || (l[1] - p).norm() < kSamePx;
        };
        if (ends(wanted[0]) && ends(wanted[1])) return true;
        const Vec2 d = (l[1] - l[0]).normalized();
        const Vec2 e = (wanted[1] - wanted[0]).normalized();
        return (ends(wanted[0]) || ends(wanted[1])) && std::abs(cross2(d, e)) < 0.2;
    });
}

/// An arc as one stroke, a sample every 4 px.
Stroke arc(const Line2& line, double sagitta) {
    const Vec2 along = line[1] - line[0];
    const Vec2 across(-along.y() / along.norm(), along.x() / along.norm());
    const auto steps = std::max(8, static_cast<int>(along.norm() / 4.0));
    Stroke out;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const double bend = 4.0 * t * (1.0 - t) * sagitta;
        out.samples.push_back({line[0] + t * along + bend * across, 0.7, 8.0 * i});
    }
    return out;
}

Stroke scribble(const Vec2& middle, double sizePx, Random& random) {
    Stroke out;
    Vec2 at = middle + random.inDisc(sizePx);
    Vec2 to = middle + random.inDisc(sizePx);
    double time = 0.0;
    for (int turn = 0; turn < 24; ++turn) {
        const int steps = std::max(2, static_cast<int>((to - at).norm() / 5.0));
        const Vec2 side = random.inDisc(0.5 * sizePx);
        for (int i = 0; i < steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            out.samples.push_back({at + t * (to - at) + t * (1.0 - t) * side, 0.6, time += 8.0});
        }
        at = to;
        to = middle + random.inDisc(sizePx);
    }
    return out;
}

SketchCase anySketch(Random& random) {
    const auto& ids = sketchTemplates();
    return randomSketch(random.chance(0.5) ? ids.front() : ids[pick(ids.size(), random)], random);
}

/// The lines that have the outside of the drawing on one side.
std::vector<Line2> outlineOf(const SketchCase& sketch) {
    const std::vector<SpecEdge> edges = specEdges(sketch.spec);
    const auto seen = [&](int face) {
        return specFaceNormal(sketch.spec, static_cast<std::size_t>(face))
                   .dot(sketch.camera.direction) < 0.0;
    };
    std::vector<Line2> out;
    for (const VisibleEdge& e : sketch.drawing.edges) {
        const SpecEdge& edge = edges[static_cast<std::size_t>(e.edge)];
        if (seen(edge.faces[0]) != seen(edge.faces[1])) out.push_back(e.line);
    }
    return out;
}

/// A box of three visible faces whose corner in the middle is none that a right angle shows.
SketchCase boxWithY(Random& random, std::optional<Vec2>& corner) {
    while (true) {
        SketchCase box = randomSketch("cube", random);
        const auto lines = box.drawing.lines();
        const auto all = cornersOf(lines);
        for (const Vec2& c : all) {
            const bool inner =
                std::count_if(lines.begin(), lines.end(), [&](const Line2& l) {
                    return (l[0] - c).norm() < kSamePx || (l[1] - c).norm() < kSamePx;
                }) == 3;
            const auto& y = box.truth.yAnglesDeg;
            if (!inner || !y) continue;
            // The Y corner is the one that no outline passes.
            const auto outline = outlineOf(box);
            if (linesAt(outline, c) == 0) {
                corner = c;
                return box;
            }
        }
    }
}

/// Shears and squeezes the drawing of a box until one angle at its Y is under 75 degrees: the faces
/// stay parallelograms, but no right-angled corner looks like that.
std::vector<Line2> withImpossibleY(const SketchCase& box, const Vec2& corner, Random& random) {
    std::array<Vec2, 3> away;
    std::size_t n = 0;
    for (const Line2& l : box.drawing.lines()) {
        if ((l[0] - corner).norm() < kSamePx && n < 3) away[n++] = l[1] - l[0];
        if ((l[1] - corner).norm() < kSamePx && n < 3) away[n++] = l[0] - l[1];
    }
    const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
    // Angles of 70, 140 and 150 degrees or so, in the order in which the lines lie.
    std::array<double, 3> angle{};
    for (std::size_t a = 0; a < 3; ++a) angle[a] = std::atan2(away[a].y(), away[a].x());
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return angle[a] < angle[b]; });
    const double narrow = random.uniform(55.0, 72.0);
    const double second = random.uniform(140.0, 360.0 - narrow - 140.0);
    const std::array<double, 3> target{0.0, narrow, narrow + second};
    std::array<Vec2, 3> moved;
    for (std::size_t k = 0; k < 3; ++k) {
        const double t = turn + target[k] * std::numbers::pi / 180.0;
        moved[order[k]] = away[order[k]].norm() * Vec2(std::cos(t), std::sin(t));
    }
    std::vector<Line2> out;
    for (Line2 l : box.drawing.lines()) {
        for (Vec2& end : l) {
            // Each corner of a parallelepiped is a sum of its three edges.
            const Vec2 off = end - corner;
            Vec2 best = Vec2::Zero();
            double least = 1e9;
            for (int bits = 0; bits < 8; ++bits) {
                Vec2 before = Vec2::Zero();
                Vec2 after = Vec2::Zero();
                for (std::size_t a = 0; a < 3; ++a) {
                    if ((bits >> a & 1) == 0) continue;
                    before += away[a];
                    after += moved[a];
                }
                if ((before - off).norm() >= least) continue;
                least = (before - off).norm();
                best = after;
            }
            end = corner + best;
        }
        out.push_back(l);
    }
    return out;
}

void moveCorner(std::vector<Line2>& lines, SpoiltDrawing& out, Random& random) {
    const auto corners = cornersOf(lines);
    const Vec2 from = corners[pick(corners.size(), random)];
    Vec2 to = from;
    for (int attempt = 0; attempt < 50; ++attempt) {
        to = from + 60.0 * random.direction();
        // It is to stay a corner of its own.
        const bool apart = std::all_of(corners.begin(), corners.end(), [&](const Vec2& c) {
            return (c - from).norm() < kSamePx || (c - to).norm() > 25.0;
        });
        if (apart) break;
    }
    for (Line2& l : lines) {
        for (Vec2& end : l) {
            if ((end - from).norm() < kSamePx) end = to;
        }
    }
    out.places = {to};
    for (const Line2& l : lines) {
        if ((l[0] - to).norm() < kSamePx || (l[1] - to).norm() < kSamePx) {
            out.places.push_back(middleOf(l));
        }
    }
}

void addExtra(std::vector<Line2>& lines, SpoiltDrawing& out, Random& random) {
    const auto corners = cornersOf(lines);
    const auto hidden = hiddenLines(out.meant);
    for (int attempt = 0; attempt < 200; ++attempt) {
        const Line2 extra{corners[pick(corners.size(), random)],
                          corners[pick(corners.size(), random)]};
        if (lengthOf(extra) < 50.0 || alongAny(lines, extra) || alongAny(hidden, extra)) continue;
        lines.push_back(extra);
        out.places = {middleOf(extra)};
        return;
    }
}

void shrink(std::vector<Line2>& lines, double toPx) {
    const Eigen::AlignedBox2d box = boundsOf(lines);
    const double share = toPx / box.diagonal().norm();
    for (Line2& l : lines) {
        for (Vec2& end : l) end = box.center() + share * (end - box.center());
    }
}

}  // namespace

const std::vector<SpoilingName>& spoilings() {
    static const std::vector<SpoilingName> all{
        {Spoiling::OpenCorner, "open-corner"},   {Spoiling::MissingEdge, "missing-edge"},
        {Spoiling::ExtraEdge, "extra-edge"},     {Spoiling::CurvedEdge, "curved-edge"},
        {Spoiling::HiddenLine, "hidden-line"},   {Spoiling::MovedCorner, "moved-corner"},
        {Spoiling::TwoDrawings, "two-drawings"}, {Spoiling::Scribble, "scribble"},
        {Spoiling::OutlineOnly, "outline-only"}, {Spoiling::ImpossibleCorner, "impossible-corner"},
        {Spoiling::TooSmall, "too-small"}};
    return all;
}

SpoiltDrawing spoiltDrawing(Spoiling kind, const HandLevel& hand, Random& random) {
    SpoiltDrawing out;
    std::optional<Vec2> corner;
    out.meant = kind == Spoiling::ImpossibleCorner ? boxWithY(random, corner) : anySketch(random);
    if (kind == Spoiling::HiddenLine) {
        while (hiddenLines(out.meant).empty()) out.meant = anySketch(random);
    }
    std::vector<Line2> lines = out.meant.drawing.lines();
    std::vector<Stroke> more;
    switch (kind) {
        case Spoiling::OpenCorner: {
            Line2& line = lines[longLine(lines, 90.0, random)];
            if (random.chance(0.5)) std::swap(line[0], line[1]);
            const double gap = std::min(random.uniform(30.0, 45.0), 0.5 * lengthOf(line));
            line[1] -= gap * (line[1] - line[0]).normalized();
            out.places = {line[1]};
            out.codes = {"open-end"};
            out.mayBeRead = true;
            break;
        }
        case Spoiling::MissingEdge: {
            const std::size_t gone = longLine(lines, 40.0, random);
            out.places = {middleOf(lines[gone])};
            lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(gone));
            out.codes = {"missing-edge"};
            out.mayBeRead = true;
            break;
        }
        case Spoiling::ExtraEdge:
            addExtra(lines, out, random);
            out.codes = {"extra-edge"};
            out.mayBeRead = true;
            break;
        case Spoiling::CurvedEdge: {
            const std::size_t bent = longLine(lines, 60.0, random);
            const double side = random.chance(0.5) ? 1.0 : -1.0;
            const double sagitta = side * random.uniform(0.2, 0.33) * lengthOf(lines[bent]);
            more.push_back(arc(lines[bent], sagitta));
            out.places = {more.back().samples[more.back().samples.size() / 2].position};
            lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(bent));
            out.codes = {"curved-edge"};
            out.mayBeRead = true;
            break;
        }
        case Spoiling::HiddenLine: {
            std::vector<Line2> hidden = hiddenLines(out.meant);
            if (random.chance(0.5)) hidden = {hidden[pick(hidden.size(), random)]};
            for (const Line2& l : hidden) {
                lines.push_back(l);
                out.places.push_back(middleOf(l));
            }
            out.codes = {"hidden-line"};
            out.mayBeRead = true;
            break;
        }
        case Spoiling::MovedCorner:
            moveCorner(lines, out, random);
            out.codes = {"not-parallel", "impossible-corner", "ambiguous"};
            out.mayBeRead = out.meant.truth.templateId != "cube";
            break;
        case Spoiling::TwoDrawings: {
            const SketchCase other = anySketch(random);
            const double shift =
                boundsOf(lines).max().x() - boundsOf(other.drawing.lines()).min().x() + 60.0;
            for (Line2 l : other.drawing.lines()) {
                for (Vec2& end : l) end.x() += shift;
                lines.push_back(l);
            }
            out.codes = {"separate-drawings"};
            out.mayBeRead = true;
            break;
        }
        case Spoiling::Scribble:
            more.push_back(scribble(boundsOf(lines).center(), 90.0, random));
            lines.clear();
            out.codes = {"scribble", "curved-stroke"};
            break;
        case Spoiling::OutlineOnly:
            lines = outlineOf(out.meant);
            out.codes = {"flat-drawing"};
            break;
        case Spoiling::ImpossibleCorner:
            lines = withImpossibleY(out.meant, *corner, random);
            out.places = {*corner};
            out.codes = {"impossible-corner"};
            break;
        case Spoiling::TooSmall:
            shrink(lines, 10.0);
            out.codes = {"too-small"};
            break;
    }
    // A drawing of 10 px is drawn by as good a hand as it can be.
    const bool small = kind == Spoiling::TooSmall;
    out.strokes = lines.empty() ? std::vector<Stroke>{}
                                : drawByHand(lines, small ? kExactHand : hand, random);
    out.strokes.insert(out.strokes.end(), more.begin(), more.end());
    return out;
}

}  // namespace ew::test
