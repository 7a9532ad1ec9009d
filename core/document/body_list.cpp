// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/body_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/tolerance.h"
#include "core/document/json_text.h"
#include "core/document/sketch_script.h"
#include "core/solid/transform.h"

namespace ew {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double distanceToTriangle(const Vec3& p, const std::array<Vec3, 3>& t) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double area = normal.squaredNorm();
    bool inside = area > 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& a = t[k];
        const Vec3 side = t[(k + 1) % 3] - a;
        inside &= normal.dot(side.cross(p - a)) >= 0.0;
        const double along = std::clamp((p - a).dot(side) / side.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (p - a - along * side).norm());
    }
    return inside ? std::abs(normal.dot(p - t[0])) / std::sqrt(area) : least;
}

std::array<Vec3, 3> cornersOf(const Solid& solid, const SolidTriangle& t) {
    return {solid.vertices()[at(t.vertices[0])], solid.vertices()[at(t.vertices[1])],
            solid.vertices()[at(t.vertices[2])]};
}

/// A rotation; one by quarter turns about an axis of the world has no rounding in it.
Mat3 turn(const Vec3& axis, double degrees) {
    Mat3 m =
        Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis.normalized()).toRotationMatrix();
    constexpr double kRounding = 1e-15;
    const bool quarters = m.unaryExpr([](double x) {
                               return std::min(std::abs(x), std::abs(std::abs(x) - 1.0));
                           }).maxCoeff() < kRounding;
    if (quarters) m = m.array().round().matrix();
    return m;
}

/// A rotation again, where many turns have left it somewhat askew.
Mat3 upright(const Mat3& m) {
    constexpr double kAskew = 1e-13;
    if ((m * m.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff() < kAskew) return m;
    return Eigen::Quaterniond(m).normalized().toRotationMatrix();
}

Result<void> checkMove(const BodyMove& m) {
    const auto bad = [](const char* what) { return fail(Errc::BadValue, what); };
    constexpr double kMostScale = 1e6;
    if (!(m.scale.minCoeff() >= 1.0 / kMostScale && m.scale.maxCoeff() <= kMostScale)) {
        return bad("A solid is scaled by numbers from 0.000001 to 1000000.");
    }
    if (!std::isfinite(m.degrees)) return bad("A solid is turned by a number of degrees.");
    const auto isDirection = [](const Vec3& d) {
        const double size = d.cwiseAbs().maxCoeff();
        return size >= tol::kShortestDirection && size <= 1.0 / tol::kShortestDirection;
    };
    if (!isDirection(m.axis)) return bad("The axis to turn about has no direction.");
    if (m.mirror && !isDirection(m.mirror->normal)) {
        return bad("The mirror plane has no direction.");
    }
    const auto isNear = [](const Vec3& p) {
        return p.allFinite() && p.cwiseAbs().maxCoeff() <= kMaxCenterMm;
    };
    if (!isNear(m.translate) || (m.center && !isNear(*m.center)) ||
        (m.mirror && !isNear(m.mirror->point))) {
        return bad("A solid cannot be moved so far.");
    }
    return {};
}

Result<void> scale(Body& body, const Vec3& by, const Vec3& about) {
    if (by == Vec3::Ones()) return {};
    const bool even = by.x() == by.y() && by.y() == by.z();
    const Mat3 world = by.asDiagonal();
    const Mat3 linear =
        even ? world : Mat3(body.pose.rotation.transpose() * world * body.pose.rotation);
    auto solid = transformed(body.solid, linear, Vec3::Zero());
    if (!solid) return fail(solid.error());
    body.solid = *std::move(solid);
    body.pose.translation = about + world * (body.pose.translation - about);
    return {};
}

Result<void> mirror(Body& body, const BodyMove::Mirror& plane) {
    const Vec3 n = plane.normal.normalized();
    const Mat3 reflect = Mat3::Identity() - 2.0 * n * n.transpose();
    const Mat3 flip = Vec3(-1, 1, 1).asDiagonal();
    auto solid = transformed(body.solid, flip, Vec3::Zero());
    if (!solid) return fail(solid.error());
    body.solid = *std::move(solid);
    body.pose.rotation = reflect * body.pose.rotation * flip;
    body.pose.translation = plane.point + reflect * (body.pose.translation - plane.point);
    return {};
}

}  // namespace

Result<void> checkBodyName(const std::string& name) {
    const bool printable = std::none_of(name.begin(), name.end(),
                                        [](char c) { return static_cast<unsigned char>(c) < ' '; });
    if (printable && name.size() <= kMaxBodyName) return {};
    return fail(Errc::BadValue,
                "A name is one line of at most " + std::to_string(kMaxBodyName) + " bytes.");
}

std::string bodyName(const std::vector<Body>& bodies, std::size_t body) {
    const std::string& name = bodies[body].name;
    return name.empty() ? "Solid " + std::to_string(body + 1) : name;
}

Result<int> findBody(const std::vector<Body>& bodies, const std::string& name) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodyName(bodies, b) == name) return static_cast<int>(b);
    }
    return fail(Errc::BadValue, "There is no solid called " + nameQuoted(name) + ".");
}

std::pair<std::vector<Body>, std::vector<int>> visibleBodies(const std::vector<Body>& bodies) {
    std::pair<std::vector<Body>, std::vector<int>> out;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].hidden) continue;
        out.first.push_back(bodies[b]);
        out.second.push_back(static_cast<int>(b));
    }
    return out;
}

Result<FaceRef> nearestFace(const std::vector<Body>& bodies, const Vec3& world, int body) {
    if (bodies.empty()) return fail(Errc::NoSolid, "There is no solid yet.");
    if (body >= static_cast<int>(bodies.size())) {
        return fail(Errc::BadValue, "There is no solid number " + std::to_string(body) +
                                        "; there are " + std::to_string(bodies.size()) +
                                        ", counted from 0.");
    }
    FaceRef best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (body >= 0 ? at(body) != b : bodies[b].hidden) continue;
        const Vec3 p = bodies[b].pose.toBody(world);
        for (const SolidTriangle& t : bodies[b].solid.triangles()) {
            const double off = distanceToTriangle(p, cornersOf(bodies[b].solid, t));
            if (off >= least) continue;
            least = off;
            best = {static_cast<int>(b), t.face};
        }
    }
    if (best.face < 0) return fail(Errc::NoSolid, "All solids are hidden.");
    return best;
}

Vec3 pointInFace(const Body& body, int face) {
    double largest = -1.0;
    Vec3 middle = Vec3::Zero();
    for (const SolidTriangle& t : body.solid.triangles()) {
        if (t.face != face) continue;
        const auto corners = cornersOf(body.solid, t);
        const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
        if (area <= largest) continue;
        largest = area;
        middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    }
    return body.pose.toWorld(middle);
}

std::array<Vec3, 2> worldBounds(const Body& body) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
    for (const Vec3& v : body.solid.vertices()) {
        const Vec3 p = body.pose.toWorld(v);
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return {low, high};
}

Vec3 middleOf(const Body& body) {
    const auto [low, high] = worldBounds(body);
    return 0.5 * (low + high);
}

Result<Body> movedBody(const Body& body, const BodyMove& move) {
    if (auto ok = checkMove(move); !ok) return fail(ok.error());
    Body out = body;
    const Vec3 about = move.center.value_or(middleOf(body));
    if (auto ok = scale(out, move.scale, about); !ok) return fail(ok.error());
    if (move.degrees != 0.0) {
        const Mat3 by = turn(move.axis, move.degrees);
        out.pose.rotation = upright(by * out.pose.rotation);
        out.pose.translation = about + by * (out.pose.translation - about);
    }
    if (move.mirror) {
        if (auto ok = mirror(out, *move.mirror); !ok) return fail(ok.error());
    }
    out.pose.translation += move.translate;
    if (out.pose.translation.cwiseAbs().maxCoeff() > kMaxCenterMm) {
        return fail(Errc::BadValue, "A solid cannot be moved so far.");
    }
    return out;
}

}  // namespace ew
