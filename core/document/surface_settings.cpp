// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/surface_settings.h"

#include <QColor>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/tolerance.h"

namespace ew {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double valueOf(const std::vector<double>& list, int edge, double otherwise) {
    return at(edge) < list.size() ? list[at(edge)] : otherwise;
}

void setValue(std::vector<double>& list, const Solid& solid, int edge, double value,
              double otherwise) {
    if (list.empty()) list.assign(solid.edges().size(), otherwise);
    list[at(edge)] = value;
}

void dropIfAll(std::vector<double>& list, double value) {
    if (std::all_of(list.begin(), list.end(), [&](double x) { return x == value; })) list.clear();
}

EdgeSettings& settingsOf(std::vector<EdgeSettings>& edges, int body) {
    if (edges.size() <= at(body)) edges.resize(at(body) + 1);
    return edges[at(body)];
}

const Vec3& end(const Solid& solid, const SolidEdge& edge, std::size_t which) {
    return solid.vertices()[at(edge.ends[which])];
}

double distanceToEdge(const Solid& solid, const SolidEdge& edge, const Vec3& p) {
    const Vec3& a = end(solid, edge, 0);
    const Vec3 along = end(solid, edge, 1) - a;
    const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (a + t * along - p).norm();
}

bool samePlane(const SolidFace& a, const SolidFace& b, double reach) {
    return a.normal.cross(b.normal).norm() < tol::kSameEdgeRelative && a.normal.dot(b.normal) > 0 &&
           std::abs(a.offset - b.offset) < reach;
}

/// How much of a new edge is the old one [mm], 0 where they are different edges.
double shared(const Solid& before, const SolidEdge& old, const Solid& after, const SolidEdge& now,
              double reach) {
    if (old.convex != now.convex) return 0.0;
    const Vec3& a = end(before, old, 0);
    const Vec3 along = end(before, old, 1) - a;
    const double length = along.norm();
    const Vec3 dir = along / length;
    std::array<double, 2> span{};
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        const Vec3 offset = end(after, now, i) - a;
        span[i] = offset.dot(dir);
        if ((offset - span[i] * dir).norm() > reach) return 0.0;
    }
    const double low = std::max(0.0, std::min(span[0], span[1]));
    const double high = std::min(length, std::max(span[0], span[1]));
    if (high - low <= reach) return 0.0;
    const auto face = [](const Solid& solid, int f) -> const SolidFace& {
        return solid.faces()[at(f)];
    };
    const bool turned = span[0] > span[1];
    const int left = now.faces[turned ? 1 : 0];
    const int right = now.faces[turned ? 0 : 1];
    const bool same = samePlane(face(before, old.faces[0]), face(after, left), reach) &&
                      samePlane(face(before, old.faces[1]), face(after, right), reach);
    return same ? high - low : 0.0;
}

}  // namespace

bool SurfaceSettings::hasFillet() const {
    return std::any_of(edges.begin(), edges.end(), [](const EdgeSettings& body) {
        return std::any_of(body.radii.begin(), body.radii.end(), [](double r) { return r > 0.0; });
    });
}

double SurfaceSettings::radius(const EdgeRef& e) const {
    return at(e.body) < edges.size() ? valueOf(edges[at(e.body)].radii, e.edge, 0.0) : 0.0;
}

double SurfaceSettings::sharpness(const EdgeRef& e) const {
    if (at(e.body) >= edges.size()) return kAutomaticSharpness;
    return valueOf(edges[at(e.body)].sharpness, e.edge, kAutomaticSharpness);
}

void SurfaceSettings::setRadius(const std::vector<Body>& bodies, const EdgeRef& e, double radius) {
    setValue(settingsOf(edges, e.body).radii, bodies[at(e.body)].solid, e.edge, radius, 0.0);
}

void SurfaceSettings::setSharpness(const std::vector<Body>& bodies, const EdgeRef& e,
                                   double sharpness) {
    setValue(settingsOf(edges, e.body).sharpness, bodies[at(e.body)].solid, e.edge, sharpness,
             kAutomaticSharpness);
}

void SurfaceSettings::tidy() {
    for (EdgeSettings& body : edges) {
        dropIfAll(body.radii, 0.0);
        dropIfAll(body.sharpness, kAutomaticSharpness);
    }
    while (!edges.empty() && edges.back() == EdgeSettings{}) edges.pop_back();
}

Result<StrokeColor> parseColor(const std::string& text) {
    const QColor color(QString::fromStdString(text));
    constexpr int kOpaque = 255;
    if (!color.isValid() || color.alpha() != kOpaque) {
        return fail(Errc::BadValue,
                    "A colour is written as #rrggbb, e.g. #1f4e9c, or by its name.");
    }
    return StrokeColor{static_cast<std::uint8_t>(color.red()),
                       static_cast<std::uint8_t>(color.green()),
                       static_cast<std::uint8_t>(color.blue())};
}

std::string colorText(const StrokeColor& color) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string out = "#";
    for (const std::uint8_t part : color) {
        out += kDigits[part >> 4U];
        out += kDigits[part & 15U];
    }
    return out;
}

// Each is written so that NaN fails too.
Result<void> checkRadius(double radius) {
    if (radius > 0.0 && radius <= kMaxRadiusMm) return {};
    return fail(Errc::BadValue, "The radius of a fillet must be a number greater than 0 mm.");
}

Result<void> checkSegments(int segments) {
    if (segments >= 1 && segments <= kMaxFilletSegments) return {};
    return fail(Errc::BadValue, "A fillet has from 1 to " + std::to_string(kMaxFilletSegments) +
                                    " segments across.");
}

Result<void> checkSharpness(double sharpness) {
    if (sharpness >= 0.0 && sharpness <= kInfiniteSharpness) return {};
    return fail(Errc::BadValue, "The sharpness of an edge must be from 0 (smooth) to 10 (sharp).");
}

Result<void> checkSubdivision(const SubdivisionSettings& s) {
    if (!s.on) return {};
    if (!(s.tolerance >= 0.0 && s.tolerance <= kMaxToleranceMm)) {
        return fail(Errc::BadValue, "The tolerance of the surface must be greater than 0 mm.");
    }
    if (s.tolerance == 0.0 && (s.levels < 1 || s.levels > kMaxSubdivisionLevels)) {
        return fail(Errc::BadValue, "The surface has from 1 to " +
                                        std::to_string(kMaxSubdivisionLevels) + " levels.");
    }
    if (s.sharpness) return checkSharpness(*s.sharpness);
    return {};
}

Result<std::vector<EdgeRef>> chosenEdges(const std::vector<Body>& bodies,
                                         const EdgeChoice& choice) {
    if (bodies.empty()) return fail(Errc::NoSolid, "There is no solid yet.");
    std::vector<EdgeRef> out;
    if (choice.which == EdgeChoice::Which::Picked) {
        for (const EdgeRef& e : choice.picked) {
            const bool exists = e.body >= 0 && at(e.body) < bodies.size() && e.edge >= 0 &&
                                at(e.edge) < bodies[at(e.body)].solid.edges().size();
            if (!exists) return fail(Errc::BadValue, "An edge that was chosen does not exist.");
            out.push_back(e);
        }
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
        if (out.empty()) return fail(Errc::NoEdge, "No edge is chosen.");
        return out;
    }
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const auto& edges = bodies[b].solid.edges();
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const bool wanted = choice.which == EdgeChoice::Which::All ||
                                edges[e].convex == (choice.which == EdgeChoice::Which::Convex);
            if (wanted) out.push_back({static_cast<int>(b), static_cast<int>(e)});
        }
    }
    if (out.empty()) {
        return fail(Errc::NoEdge, choice.which == EdgeChoice::Which::Concave
                                      ? "The solid has no concave edge."
                                      : "The solid has no such edge.");
    }
    return out;
}

Result<EdgeRef> nearestEdge(const std::vector<Body>& bodies, const Vec3& world, int body) {
    if (bodies.empty()) return fail(Errc::NoSolid, "There is no solid yet.");
    if (!world.allFinite()) return fail(Errc::BadValue, "The place of an edge is not a number.");
    EdgeRef best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (body >= 0 && static_cast<std::size_t>(body) != b) continue;
        const Solid& solid = bodies[b].solid;
        const Vec3 p = bodies[b].pose.toBody(world);
        for (std::size_t e = 0; e < solid.edges().size(); ++e) {
            const double distance = distanceToEdge(solid, solid.edges()[e], p);
            if (!(distance < least)) continue;
            least = distance;
            best = {static_cast<int>(b), static_cast<int>(e)};
        }
    }
    if (best.edge < 0) return fail(Errc::NoEdge, "There is no edge at this place.");
    return best;
}

std::optional<Vec3> pointNaming(const std::vector<Body>& bodies, const EdgeRef& e) {
    const Body& body = bodies[at(e.body)];
    const SolidEdge& edge = body.solid.edges()[at(e.edge)];
    // The middle first; other places where an edge of another body lies there too.
    for (const double t : {0.5, 0.375, 0.6875, 0.21875, 0.84375}) {
        const Vec3 p =
            body.pose.toWorld((1.0 - t) * end(body.solid, edge, 0) + t * end(body.solid, edge, 1));
        const auto named = nearestEdge(bodies, p);
        if (named && *named == e) return p;
    }
    return std::nullopt;
}

EdgeSettings carriedOver(const Solid& before, const EdgeSettings& settings, const Solid& after) {
    EdgeSettings out;
    if (settings == EdgeSettings{}) return out;
    const auto box = before.bounds();
    const double reach = tol::kSameEdgeRelative * (box[1] - box[0]).norm();
    const std::size_t count = after.edges().size();
    if (!settings.radii.empty()) out.radii.assign(count, 0.0);
    if (!settings.sharpness.empty()) out.sharpness.assign(count, kAutomaticSharpness);
    for (std::size_t n = 0; n < count; ++n) {
        double most = 0.0;
        for (std::size_t o = 0; o < before.edges().size(); ++o) {
            const double part = shared(before, before.edges()[o], after, after.edges()[n], reach);
            if (!(part > most)) continue;
            most = part;
            const int old = static_cast<int>(o);
            if (!out.radii.empty()) out.radii[n] = valueOf(settings.radii, old, 0.0);
            if (!out.sharpness.empty()) {
                out.sharpness[n] = valueOf(settings.sharpness, old, kAutomaticSharpness);
            }
        }
    }
    return out;
}

}  // namespace ew
