// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/examples/model_maker.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "core/solid/boolean.h"
#include "core/solid/visibility.h"
#include "tests/support/modification_cases.h"

namespace ew::test {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }
constexpr int kMostAttempts = 12;
constexpr double kSnapShare = 0.03;
constexpr double kSpanPx = 430.0;  // of the whole solid

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

}  // namespace

ModelMaker::ModelMaker(TemplateLibrary library, const HandLevel& hand, std::uint64_t seed)
    : document_(std::move(library)), hand_(hand), seed_(seed) {}

void ModelMaker::lookFrom(double azimuthDeg, double tiltDeg) {
    azimuthDeg_ = azimuthDeg;
    tiltDeg_ = tiltDeg;
}

void ModelMaker::aim() {
    const double azimuth = azimuthDeg_ * std::numbers::pi / 180.0;
    const double tilt = tiltDeg_ * std::numbers::pi / 180.0;
    OrthographicCamera camera = document_.camera();
    camera.direction = Vec3(-std::cos(azimuth) * std::cos(tilt), std::sin(azimuth) * std::cos(tilt),
                            -std::sin(tilt))
                           .normalized();
    camera.up = Vec3::UnitZ();
    if (!document_.state().bodies.empty()) {
        const auto bounds = body().solid.bounds();
        camera.center = body().pose.toWorld(0.5 * (bounds[0] + bounds[1]));
        camera.worldPerPixel = (bounds[1] - bounds[0]).norm() / kSpanPx;
    }
    if (const auto ok = document_.setCamera(camera); !ok) {
        throw std::runtime_error(ok.error().message);
    }
}

void ModelMaker::startBox(const Vec3& size) {
    OrthographicCamera camera = document_.camera();
    camera.center = Vec3::Zero();
    camera.worldPerPixel = size.norm() / kSpanPx;
    if (const auto ok = document_.setCamera(camera); !ok) {
        throw std::runtime_error(ok.error().message);
    }
    aim();
    const Body box{solidOf(boxSpec(-0.5 * size, 0.5 * size)), {}};
    const auto view = SolidView::make(box.solid, box.pose, document_.camera());
    std::vector<Line2> lines;
    for (const VisiblePiece& p : view->visiblePieces()) lines.push_back({p.px[0], p.px[1]});
    for (int i = 0; i < kMostAttempts; ++i) {
        Random random(Random::mix(seed_, at(steps_), at(i)));
        const auto strokes = drawByHand(lines, hand_, random);
        InterpretOptions o;
        o.camera = document_.camera();
        const Interpretation r = interpret(strokes, document_.state().library, o);
        if (!r.accepted || r.candidates[at(*r.accepted)].templateId != "cube") continue;
        for (const Stroke& s : strokes) need(document_.addStroke(s), "stroke");
        need(document_.apply(), "first box");
        bounds_ = body().solid.bounds();
        ++steps_;
        return;
    }
    throw std::runtime_error("the first box is not read");
}

Vec3 ModelMaker::place(const Vec3& share, bool snap) const {
    Vec3 p = Vec3::Zero();
    for (int world = 0; world < 3; ++world) {
        const auto [k, sense] = bodyAxis(body().pose, world);
        const double size = bounds_[1](k) - bounds_[0](k);
        double x =
            sense > 0 ? bounds_[0](k) + share(world) * size : bounds_[1](k) - share(world) * size;
        double nearest = kSnapShare * size;
        double best = x;
        for (const Vec3& v : body().solid.vertices()) {
            if (!snap || std::abs(v(k) - x) >= nearest) continue;
            nearest = std::abs(v(k) - x);
            best = v(k);
        }
        p(k) = best;
    }
    return p;
}

void ModelMaker::change(Operation operation, const PolyhedronSpec& shares) {
    aim();
    ++steps_;
    const std::string name = "step " + std::to_string(steps_);
    PolyhedronSpec spec = shares;
    for (Vec3& v : spec.vertices) v = place(v, true);
    auto tool = Solid::fromSpec(spec);
    if (!tool) {
        // The body's axes may be a mirror image of the shares'.
        for (auto& f : spec.faces) std::reverse(f.begin(), f.end());
        tool = Solid::fromSpec(spec);
    }
    const Solid target = body().solid;
    const Solid made = need(tool, name);
    const auto wanted = need(
        combine(target, made, operation == Operation::Add ? BooleanKind::Add : BooleanKind::Cut),
        name);
    const ModificationCase c{"",
                             name,
                             0,
                             body(),
                             document_.camera(),
                             operation,
                             "",
                             newVisibleLines(body(), wanted.solid, document_.camera())};
    std::string why;
    for (int i = 0; i < kMostAttempts; ++i) {
        Random random(Random::mix(seed_, at(steps_), at(i)));
        const auto strokes = drawByHand(linesOnPlane(c), hand_, random);
        InterpretOptions o;
        o.camera = document_.camera();
        o.bodies = document_.state().bodies;
        const Interpretation r = interpret(strokes, document_.state().library, o);
        if (!r.accepted) {
            why = r.problem ? r.problem->message : "";
            continue;
        }
        const Candidate& k = r.candidates[at(*r.accepted)];
        if (k.operation != operation || !k.result ||
            k.result->faces().size() != wanted.solid.faces().size() ||
            k.result->edges().size() != wanted.solid.edges().size()) {
            why = "read as " + k.templateId + " " + k.aspect;
            continue;
        }
        for (const Stroke& s : strokes) need(document_.addStroke(s), name);
        need(document_.apply(), name);
        return;
    }
    throw std::runtime_error(name + ": " + why);
}

void ModelMaker::addBox(const Vec3& low, const Vec3& high) {
    change(Operation::Add, boxSpec(low, high));
}
void ModelMaker::cutBox(const Vec3& low, const Vec3& high) {
    change(Operation::Cut, boxSpec(low, high));
}
void ModelMaker::addPrism(const std::vector<Vec3>& triangle, const Vec3& along) {
    change(Operation::Add, prismSpec(triangle, along));
}
void ModelMaker::cutPrism(const std::vector<Vec3>& triangle, const Vec3& along) {
    change(Operation::Cut, prismSpec(triangle, along));
}

void ModelMaker::fillet(EdgeChoice::Which which, double share, int segments) {
    const auto [k, sense] = bodyAxis(body().pose, 2);
    FilletRequest request;
    request.edges.which = which;
    request.radius = share * (bounds_[1](k) - bounds_[0](k));
    request.segments = segments;
    const auto outcome = need(document_.fillet(request), "fillet");
    std::printf("  fillet of %d edges, %zu clamped\n", outcome.edges, outcome.clamped.size());
}

void ModelMaker::subdivide(int levels) {
    SubdivisionSettings settings;
    settings.on = true;
    settings.levels = levels;
    if (const auto ok = document_.subdivide(settings); !ok) {
        throw std::runtime_error(ok.error().message);
    }
}

void ModelMaker::drawOn(const std::vector<std::vector<Vec3>>& lines, const std::string&) {
    aim();
    Random random(Random::mix(seed_, 1000));
    for (const auto& line : lines) {
        std::vector<Line2> drawn;
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const auto seen = [&](const Vec3& share) {
                return document_.camera().project(body().pose.toWorld(place(share, false)));
            };
            drawn.push_back({seen(line[i]), seen(line[i + 1])});
        }
        for (const Stroke& s : drawByHand(drawn, hand_, random))
            need(document_.addStroke(s), "ink");
    }
    need(document_.mapStrokes(), "strokes on the surface");
}

}  // namespace ew::test
