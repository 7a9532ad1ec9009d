// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/simplify.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/tolerance.h"
#include "core/solid/tool_fixing.h"
#include "core/solid/validity.h"

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

/// Heavy planes and what hangs together with them.
struct Heavy {
    std::vector<int> points;                ///< on heavy planes, ascending
    std::vector<std::vector<int>> facesOf;  ///< by plane: faces that lie in it
    std::vector<std::shared_ptr<const RPlane>> planes;
    std::vector<bool> isHeavy;  ///< by plane
};

bool isHeavyFace(const ChangedBrep& changed, std::size_t f) {
    return changed.sameAs[f] < 0 && changed.planes[f] &&
           bitsOf(*changed.planes[f]) > tol::kLightBits;
}

/// False where a face that is planar within tolerance only has a part in it.
bool collect(const ChangedBrep& changed, Heavy& heavy) {
    const auto& faces = changed.brep.faces;
    std::vector<bool> on(changed.brep.points.size(), false);
    std::vector<std::shared_ptr<const RPlane>> bad;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (isHeavyFace(changed, f)) bad.push_back(changed.planes[f]);
    }
    if (bad.empty()) return false;
    const auto inBad = [&](std::size_t f) {
        return changed.planes[f] && std::any_of(bad.begin(), bad.end(), [&](const auto& p) {
                   return p == changed.planes[f] || *p == *changed.planes[f];
               });
    };
    std::vector<bool> moved(faces.size(), false);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        moved[f] = inBad(f);
        if (!moved[f]) continue;
        for (const auto& loop : faces[f]) {
            for (const int v : loop) on[idx(v)] = true;
        }
    }
    for (std::size_t v = 0; v < on.size(); ++v) {
        if (on[v]) heavy.points.push_back(static_cast<int>(v));
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
        bool touches = moved[f];
        for (std::size_t l = 0; l < faces[f].size() && !touches; ++l) {
            touches = std::any_of(faces[f][l].begin(), faces[f][l].end(),
                                  [&](int v) { return on[idx(v)]; });
        }
        if (!touches) continue;
        if (!changed.planes[f]) return false;
        std::size_t p = 0;
        while (p < heavy.planes.size() && !(*heavy.planes[p] == *changed.planes[f])) ++p;
        if (p == heavy.planes.size()) {
            heavy.planes.push_back(changed.planes[f]);
            heavy.isHeavy.push_back(moved[f]);
            heavy.facesOf.emplace_back();
        }
        heavy.facesOf[p].push_back(static_cast<int>(f));
    }
    return true;
}

double roundedTo(double value, double grid) { return std::round(value / grid) * grid; }

/// Short coefficients next to the exact ones; parallel planes get parallel ones.
FittedPlane lightWish(const RPlane& plane, double grid, const std::vector<Vec3>& points) {
    FittedPlane wish;
    for (int k = 0; k < 3; ++k) wish.normal[k] = roundedTo(plane.n[k], tol::kPlaneGrid);
    double middle = 0.0;
    for (const Vec3& p : points) middle += wish.normal.dot(p) / static_cast<double>(points.size());
    wish.offset = roundedTo(middle, grid);
    return wish;
}

/// The brep with short planes; nothing where they do not fit together.
std::optional<ChangedBrep> simplified(const ChangedBrep& changed) {
    Heavy heavy;
    if (!collect(changed, heavy)) return std::nullopt;
    std::vector<Vec3> all;
    for (const Point3& p : changed.brep.points) all.push_back(rounded(p));
    const double size = sizeOf(all);
    const double grid = tol::kPlaneGrid * std::exp2(std::floor(std::log2(size)));
    std::vector<int> local(all.size(), -1);
    std::vector<Vec3> points;
    for (const int v : heavy.points) {
        local[idx(v)] = static_cast<int>(points.size());
        points.push_back(all[idx(v)]);
    }
    std::vector<FittedPlane> wishes;
    for (std::size_t p = 0; p < heavy.planes.size(); ++p) {
        std::vector<int> inside;
        std::vector<Vec3> places;
        for (const int f : heavy.facesOf[p]) {
            for (const auto& loop : changed.brep.faces[idx(f)]) {
                for (const int v : loop) {
                    places.push_back(all[idx(v)]);
                    if (local[idx(v)] >= 0) inside.push_back(local[idx(v)]);
                }
            }
        }
        wishes.push_back(lightWish(*heavy.planes[p], grid, places));
        wishes.back().points = std::move(inside);
    }
    ToolFixing fixing(points, std::move(wishes), tol::kSliverRelative * size);
    for (std::size_t p = 0; p < heavy.planes.size(); ++p) {
        if (!heavy.isHeavy[p]) fixing.faceIn(static_cast<int>(p), *heavy.planes[p]);
    }
    const auto solved = fixing.solve();
    if (!solved) return std::nullopt;
    // Planes that were not one stay so; merging them would be another boolean.
    for (std::size_t p = 0; p < heavy.planes.size(); ++p) {
        for (std::size_t q = 0; q < p; ++q) {
            if (!heavy.isHeavy[p] && !heavy.isHeavy[q]) continue;
            const RPlane& a = fixing.plane(static_cast<int>(p));
            const RPlane& b = fixing.plane(static_cast<int>(q));
            if (a.d == b.d && a.n == b.n && a == b) return std::nullopt;
        }
    }
    ChangedBrep out = changed;
    for (std::size_t i = 0; i < solved->size(); ++i) {
        const RVec& q = (*solved)[i];
        out.brep.points[idx(heavy.points[i])] = Point3(Exact(q[0]), Exact(q[1]), Exact(q[2]));
    }
    for (std::size_t p = 0; p < heavy.planes.size(); ++p) {
        const auto plane = heavy.isHeavy[p]
                               ? std::make_shared<const RPlane>(fixing.plane(static_cast<int>(p)))
                               : heavy.planes[p];
        for (const int f : heavy.facesOf[p]) {
            out.planes[idx(f)] = plane;
            out.sameAs[idx(f)] = -1;
            for (const auto& loop : out.brep.faces[idx(f)]) {
                for (const int v : loop) out.changed.extend(all[idx(v)]);
            }
        }
    }
    return out;
}

}  // namespace

Result<std::shared_ptr<const Solid::Impl>> reassembleSimplified(const Solid::Impl& base,
                                                                ChangedBrep changed) {
    if (const auto light = simplified(changed)) {
        auto impl = reassemble(base, *light);
        if (impl) return impl;
    }
    for (const Point3& p : changed.brep.points) {
        if (bitsOf(p) <= tol::kMaxExactBits) continue;
        return fail(Errc::TooLarge,
                    "The part hangs on too many slanted parts to be placed exactly.");
    }
    return reassemble(base, changed);
}

}  // namespace ew
