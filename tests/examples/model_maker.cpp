// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/examples/model_maker.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "core/solid/boolean.h"
#include "core/solid/exact_tool.h"
#include "core/solid/visibility.h"
#include "tests/support/modification_cases.h"

namespace ew::test {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }
constexpr int kMostAttempts = 12;
constexpr double kSpanPx = 640.0;     // of the whole solid
constexpr double kShortestPx = 12.0;  // nobody draws a line as short as its corners are wide
constexpr double kOffPx = 12.0;       // how far a corner may come to lie from where it was meant
constexpr double kGridPx = 0.1;       // what a pen tablet tells apart
constexpr double kPressureStep = 0.01;
constexpr double kHairMm = 1e-6;
constexpr double kTouchMm = 0.3;  // a corner this near to an edge is on it
constexpr double kStrayMm = 2.0;  // an edge that is named is no farther from the place

/// The axis of the body that a world axis runs along, and its sense.
std::pair<int, double> bodyAxis(const Pose& pose, int world) {
    int best = 0;
    for (int k = 1; k < 3; ++k) {
        if (std::abs(pose.rotation(world, k)) > std::abs(pose.rotation(world, best))) best = k;
    }
    return {best, pose.rotation(world, best) < 0 ? -1.0 : 1.0};
}

template <class T>
T need(Result<T> result, const std::string& what) {
    if (!result) throw std::runtime_error(what + ": " + result.error().message);
    return std::move(*result);
}

void need(const Result<void>& result, const std::string& what) {
    if (!result) throw std::runtime_error(what + ": " + result.error().message);
}

double toStep(double value, double step) { return step * std::round(value / step); }

/// The distance of a point from an edge of a solid.
double offEdge(const Solid& solid, int edge, const Vec3& p) {
    const auto& ends = solid.edges()[at(edge)].ends;
    const Vec3& a = solid.vertices()[at(ends[0])];
    const Vec3 d = solid.vertices()[at(ends[1])] - a;
    const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
    return (p - a - t * d).norm();
}

bool isBox(const PolyhedronSpec& shape) {
    const auto& v = shape.vertices;
    if (v.size() != 8) return false;
    const Vec3 up = v[4] - v[0];
    const auto along = [&](std::size_t i) { return (v[i + 4] - v[i] - up).norm() < kHairMm; };
    return along(1) && along(2) && along(3);
}

/// A body that touches the solid wherever it was meant to, exactly.
ToolSpec onTheBody(const PolyhedronSpec& shape, const Solid& solid) {
    ToolSpec tool;
    tool.shape = shape;
    tool.snap = true;
    for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
        const Vec3& p = shape.vertices[i];
        const bool corner = std::any_of(solid.vertices().begin(), solid.vertices().end(),
                                        [&](const Vec3& v) { return (v - p).norm() < kTouchMm; });
        if (corner) continue;
        for (int e = 0; at(e) < solid.edges().size(); ++e) {
            if (offEdge(solid, e, p) > kTouchMm) continue;
            tool.vertices.push_back(
                {static_cast<int>(i), ToolVertexRule::Kind::OnEdge, e, -1, 0.0});
            break;
        }
    }
    return tool;
}

/// What a tablet tells of a stroke.
Stroke asTold(Stroke stroke) {
    for (PenSample& s : stroke.samples) {
        for (int k = 0; k < 2; ++k) s.position(k) = toStep(s.position(k), kGridPx);
        s.pressure = toStep(s.pressure, kPressureStep);
    }
    return stroke;
}

HandHabits habits() {
    HandHabits h;
    h.samplePeriodMs = 10.0;
    h.cruisePx = {7.0, 12.0};  // a large drawing is drawn with long strokes
    return h;
}

/// One stroke along a curve: the hand misses both ends, sways in between, and presses less where it
/// starts and stops.
Stroke curveByHand(const std::vector<Vec2>& points, const HandLevel& hand, Random& random) {
    constexpr double kStepPx = 6.0;
    constexpr double kPressPx = 30.0;
    constexpr double kPeriodMs = 10.0;
    std::vector<double> length{0.0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        length.push_back(length.back() + (points[i] - points[i - 1]).norm());
    }
    const double total = length.back();
    const double reach = std::min(hand.endErrorPx, 0.08 * total);
    const Vec2 start = random.inDisc(reach);
    const Vec2 end = random.inDisc(reach);
    const double sway = std::min(hand.wobblePx, 0.02 * total);
    const std::array<double, 2> waves{random.uniform(70, 140), random.uniform(140, 260)};
    const std::array<double, 4> phases{random.uniform(0, 6), random.uniform(0, 6),
                                       random.uniform(0, 6), random.uniform(0, 6)};
    const int pieces = std::max(4, static_cast<int>(std::lround(total / kStepPx)));
    Stroke stroke;
    std::vector<double> stops;
    for (int i = 0; i <= pieces; ++i) stops.push_back(total * i / pieces);
    // Corners are drawn, not cut.
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Vec2 in = (points[i] - points[i - 1]).normalized();
        const Vec2 out = (points[i + 1] - points[i]).normalized();
        if (in.dot(out) < 0.8) stops.push_back(length[i]);
    }
    std::sort(stops.begin(), stops.end());
    std::size_t k = 1;
    for (const double s : stops) {
        while (k + 1 < points.size() && length[k] < s) ++k;
        const double t = (s - length[k - 1]) / std::max(1e-9, length[k] - length[k - 1]);
        Vec2 p = points[k - 1] + t * (points[k] - points[k - 1]);
        p += (1.0 - s / total) * start + s / total * end;
        for (std::size_t w = 0; w < 2; ++w) {
            const double turn = 2.0 * std::numbers::pi * s / waves[w];
            p += sway * Vec2(std::sin(turn + phases[w]), std::sin(turn + phases[w + 2]));
        }
        const double toEnd = std::min(s, total - s) / kPressPx;
        const double pressure = 0.45 + 0.35 * std::min(1.0, toEnd);
        stroke.samples.push_back(
            {p, pressure, kPeriodMs * static_cast<double>(stroke.samples.size())});
    }
    return stroke;
}

}  // namespace

ModelMaker::ModelMaker(TemplateLibrary library, const HandLevel& hand, std::uint64_t seed)
    : document_(std::move(library)), hand_(hand), seed_(seed) {}

// View --------------------------------------------------------------------------------------------

void ModelMaker::lookFrom(double azimuthDeg, double tiltDeg) {
    azimuthDeg_ = azimuthDeg;
    tiltDeg_ = tiltDeg;
    focus_.reset();
    if (!document_.state().bodies.empty()) aim();
}

void ModelMaker::lookFrom(double azimuthDeg, double tiltDeg, const Vec3& place, double heightMm) {
    lookFrom(azimuthDeg, tiltDeg);
    focus_ = place;
    heightMm_ = heightMm;
    aim();
}

void ModelMaker::aim() {
    const double azimuth = azimuthDeg_ * std::numbers::pi / 180.0;
    const double tilt = tiltDeg_ * std::numbers::pi / 180.0;
    OrthographicCamera camera = document_.camera();
    camera.direction = Vec3(-std::cos(azimuth) * std::cos(tilt), std::sin(azimuth) * std::cos(tilt),
                            -std::sin(tilt))
                           .normalized();
    camera.up = Vec3::UnitZ();
    if (focus_) {
        camera.center = worldPlace(*focus_);
        camera.worldPerPixel = heightMm_ / camera.height;
    } else if (!document_.state().bodies.empty()) {
        const auto bounds = body().solid.bounds();
        camera.center = body().pose.toWorld(0.5 * (bounds[0] + bounds[1]));
        camera.worldPerPixel = (bounds[1] - bounds[0]).norm() / kSpanPx;
    }
    need(document_.setCamera(camera), "camera");
}

// Places ------------------------------------------------------------------------------------------

Vec3 ModelMaker::place(const Vec3& meant) const {
    Vec3 p = Vec3::Zero();
    for (int world = 0; world < 3; ++world) {
        const auto& known = known_[at(world)];
        const double x = meant(world);
        // Between two that are known; beyond the last one by their scale.
        auto upper = known.lower_bound(x);
        if (upper != known.end() && upper->first == x) {
            p(bodyAxis(body().pose, world).first) = upper->second;
            continue;
        }
        if (upper == known.begin()) ++upper;
        if (upper == known.end()) --upper;
        auto lower = std::prev(upper);
        double scale = (upper->second - lower->second) / (upper->first - lower->first);
        if (x < known.begin()->first || x > known.rbegin()->first) {
            scale = (known.rbegin()->second - known.begin()->second) /
                    (known.rbegin()->first - known.begin()->first);
            if (x > known.rbegin()->first) lower = upper;
        }
        p(bodyAxis(body().pose, world).first) = lower->second + scale * (x - lower->first);
    }
    // What is flush is so to the bit.
    for (int k = 0; k < 3; ++k) {
        for (const Vec3& v : body().solid.vertices()) {
            if (std::abs(v(k) - p(k)) < kHairMm) p(k) = v(k);
        }
    }
    return p;
}

Vec3 ModelMaker::worldPlace(const Vec3& meant) const { return body().pose.toWorld(place(meant)); }

PolyhedronSpec ModelMaker::placed(PolyhedronSpec meant) const {
    for (Vec3& v : meant.vertices) v = place(v);
    if (!Solid::fromSpec(meant)) {
        // The body's axes may be a mirror image of the meant ones.
        for (auto& f : meant.faces) std::reverse(f.begin(), f.end());
    }
    return meant;
}

void ModelMaker::learn(const PolyhedronSpec& meant, const PolyhedronSpec& placed,
                       const PolyhedronSpec& found) {
    for (std::size_t i = 0; i < meant.vertices.size(); ++i) {
        const auto nearest = std::min_element(
            found.vertices.begin(), found.vertices.end(), [&](const Vec3& a, const Vec3& b) {
                return (a - placed.vertices[i]).norm() < (b - placed.vertices[i]).norm();
            });
        for (int world = 0; world < 3; ++world) {
            known_[at(world)].insert_or_assign(meant.vertices[i](world),
                                               (*nearest)(bodyAxis(body().pose, world).first));
        }
    }
}

// Sketches ----------------------------------------------------------------------------------------

std::vector<Stroke> ModelMaker::byHand(const std::vector<Line2>& lines,
                                       std::uint64_t attempt) const {
    Random random(Random::mix(seed_, at(sketches_) + 1, attempt));
    std::vector<Stroke> strokes;
    for (Stroke& s : drawByHand(lines, hand_, random, habits())) {
        strokes.push_back(asTold(std::move(s)));
    }
    return strokes;
}

void ModelMaker::startBox(const Vec3& size) {
    OrthographicCamera camera = document_.camera();
    camera.center = Vec3::Zero();
    camera.worldPerPixel = size.norm() / kSpanPx;
    need(document_.setCamera(camera), "camera");
    aim();
    const Body box{solidOf(boxSpec(-0.5 * size, 0.5 * size)), {}};
    const auto view = SolidView::make(box.solid, box.pose, document_.camera());
    std::vector<Line2> lines;
    for (const VisiblePiece& p : view->visiblePieces()) lines.push_back({p.px[0], p.px[1]});
    for (int i = 0; i < kMostAttempts; ++i) {
        const auto strokes = byHand(lines, at(i));
        InterpretOptions o;
        o.camera = document_.camera();
        const Interpretation r = interpret(strokes, document_.state().library, o);
        if (!r.accepted || r.candidates[at(*r.accepted)].templateId != "cube") continue;
        for (const Stroke& s : strokes) need(document_.addStroke(s), "stroke");
        need(document_.apply(), "first box");
        const auto bounds = body().solid.bounds();
        for (int world = 0; world < 3; ++world) {
            const auto [k, sense] = bodyAxis(body().pose, world);
            known_[at(world)][0.0] = sense > 0 ? bounds[0](k) : bounds[1](k);
            known_[at(world)][size(world)] = sense > 0 ? bounds[1](k) : bounds[0](k);
        }
        ++sketches_;
        const Vec3 made = bounds[1] - bounds[0];
        std::printf("  sketch 1: cube of %.1f x %.1f x %.1f\n", made.x(), made.y(), made.z());
        return;
    }
    throw std::runtime_error("the first box is not read");
}

bool ModelMaker::isMeant(const Candidate& found, Operation operation, const Solid& wanted,
                         std::string& why) const {
    why = "read as " + std::string(operationName(found.operation)) + " " + found.templateId + " " +
          found.aspect;
    if (found.operation != operation || !found.result) return false;
    const Solid& made = *found.result;
    if (made.faces().size() != wanted.faces().size() ||
        made.edges().size() != wanted.edges().size()) {
        why += ", " + std::to_string(made.faces().size()) + " faces instead of " +
               std::to_string(wanted.faces().size());
        return false;
    }
    const double reach = kOffPx * document_.camera().worldPerPixel;
    for (const Vec3& v : wanted.vertices()) {
        double off = (made.vertices().front() - v).norm();
        for (const Vec3& w : made.vertices()) off = std::min(off, (w - v).norm());
        if (off <= reach) continue;
        why += ", " + std::to_string(off) + " mm off";
        return false;
    }
    return true;
}

void ModelMaker::change(Operation operation, const PolyhedronSpec& meant) {
    aim();
    const std::string name = "sketch " + std::to_string(sketches_ + 1);
    const PolyhedronSpec spec = placed(meant);
    const Solid tool = need(makeTool(body().solid, onTheBody(spec, body().solid)), name);
    const auto kind = operation == Operation::Add ? BooleanKind::Add : BooleanKind::Cut;
    const Solid wanted = need(combine(body().solid, tool, kind), name).solid;
    std::vector<Line2> lines;
    for (const auto& l : newVisibleLines(body(), wanted, document_.camera())) {
        const Line2 line{document_.camera().project(body().pose.toWorld(l[0])),
                         document_.camera().project(body().pose.toWorld(l[1]))};
        if ((line[1] - line[0]).norm() > kShortestPx) lines.push_back(line);
    }
    std::string why;
    for (int i = 0; i < kMostAttempts; ++i) {
        const auto strokes = byHand(lines, at(i));
        InterpretOptions o;
        o.camera = document_.camera();
        o.bodies = document_.state().bodies;
        const Interpretation r = interpret(strokes, document_.state().library, o);
        if (!r.accepted) {
            why = r.problem ? r.problem->message : "";
            std::printf("  %s, attempt %d: %s\n", name.c_str(), i + 1, why.c_str());
            continue;
        }
        const Candidate& found = r.candidates[at(*r.accepted)];
        if (!isMeant(found, operation, wanted, why) ||
            isBox(meant) != (found.templateId == "cube")) {
            std::printf("  %s, attempt %d: %s\n", name.c_str(), i + 1, why.c_str());
            continue;
        }
        std::printf("  %s: %s %s %s, attempt %d\n", name.c_str(),
                    std::string(operationName(operation)).c_str(), found.templateId.c_str(),
                    found.aspect.c_str(), i + 1);
        const PolyhedronSpec made = found.spec;
        for (const Stroke& s : strokes) need(document_.addStroke(s), name);
        need(document_.apply(), name);
        learn(meant, spec, made);
        ++sketches_;
        return;
    }
    for (const Stroke& s : byHand(lines, 0)) need(document_.addStroke(s), name);
    throw std::runtime_error(name + ": " + why);
}

// Surface -----------------------------------------------------------------------------------------

EdgeChoice ModelMaker::edgesAt(const std::vector<Vec3>& places) const {
    EdgeChoice choice;
    choice.which = EdgeChoice::Which::Picked;
    for (const Vec3& meant : places) {
        const Vec3 world = worldPlace(meant);
        const EdgeRef edge = need(nearestEdge(document_.state().bodies, world), "edge");
        const double off = offEdge(body().solid, edge.edge, place(meant));
        if (off > kStrayMm) {
            std::printf("  no edge at (%g, %g, %g), the nearest is %.2f mm away\n", meant.x(),
                        meant.y(), meant.z(), off);
        }
        choice.picked.push_back(edge);
    }
    return choice;
}

void ModelMaker::fillet(EdgeChoice::Which which, double radiusMm, int segments) {
    FilletRequest request;
    request.edges.which = which;
    request.radius = radiusMm;
    request.segments = segments;
    const auto outcome = need(document_.fillet(request), "fillet");
    std::printf("  fillet of %d edges, %zu clamped\n", outcome.edges, outcome.clamped.size());
    for (const auto& c : outcome.clamped) {
        std::printf("    %s\n", clampText(document_.state().bodies, c).c_str());
    }
}

void ModelMaker::fillet(const std::vector<Vec3>& places, double radiusMm, int segments) {
    FilletRequest request;
    request.edges = edgesAt(places);
    request.radius = radiusMm;
    request.segments = segments;
    const auto outcome = need(document_.fillet(request), "fillet");
    std::printf("  fillet of %d edges, %zu clamped\n", outcome.edges, outcome.clamped.size());
    for (const auto& c : outcome.clamped) {
        std::printf("    %s\n", clampText(document_.state().bodies, c).c_str());
    }
}

void ModelMaker::sharpen(const std::vector<Vec3>& places) {
    need(document_.sharpen(edgesAt(places)), "sharpen");
}

void ModelMaker::crease(const std::vector<Vec3>& places, double sharpness) {
    need(document_.crease(edgesAt(places), sharpness), "crease");
}

void ModelMaker::subdivide(int levels, std::optional<double> sharpness) {
    SubdivisionSettings settings;
    settings.on = true;
    settings.levels = levels;
    settings.sharpness = sharpness;
    need(document_.subdivide(settings), "surface");
}

void ModelMaker::drawOn(const std::vector<std::vector<Vec3>>& curves, const std::string& color) {
    aim();
    Random random(Random::mix(seed_, 1000, curves_++));
    for (const auto& curve : curves) {
        std::vector<Vec2> points;
        for (const Vec3& p : curve) points.push_back(document_.camera().project(worldPlace(p)));
        need(document_.addStroke(asTold(curveByHand(points, hand_, random))), "ink");
    }
    const auto outcome =
        need(document_.mapStrokes(need(parseColor(color), color)), "strokes on the surface");
    if (outcome.missed > 0) std::printf("  %d strokes missed the surface\n", outcome.missed);
}

}  // namespace ew::test
