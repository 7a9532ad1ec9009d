// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/start_points.h"

#include <algorithm>
#include <cmath>

namespace ew {

std::vector<CameraPoints> startPoints(const Template& tmpl, const Sighting& sighting,
                                      const Aspect& aspect, bool mirrored) {
    struct Start {
        double misfit;
        CameraPoints points;
    };
    std::vector<Start> starts;
    for (const Vec3& direction : aspect.directions) {
        const Vec3 helper = std::abs(direction.z()) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
        const Vec3 right = direction.cross(helper).normalized();
        const Vec3 down = direction.cross(right);
        CameraPoints view;
        for (const Vec3& p : tmpl.shape.vertices) {
            view.emplace_back((mirrored ? -1.0 : 1.0) * p.dot(right), p.dot(down),
                              p.dot(direction));
        }
        // Similarity (complex numbers): drawn = c * view + shift.
        Vec2 meanV = Vec2::Zero();
        Vec2 meanD = Vec2::Zero();
        double n = 0;
        for (std::size_t v = 0; v < view.size(); ++v) {
            if (!sighting.seen[v]) continue;
            meanV += view[v].head<2>();
            meanD += sighting.vertexPx[v];
            n += 1;
        }
        meanV /= n;
        meanD /= n;
        Vec2 c = Vec2::Zero();
        double norm = 0;
        for (std::size_t v = 0; v < view.size(); ++v) {
            if (!sighting.seen[v]) continue;
            const Vec2 a = view[v].head<2>() - meanV;
            const Vec2 b = sighting.vertexPx[v] - meanD;
            c += Vec2(a.dot(b), cross2(a, b));
            norm += a.squaredNorm();
        }
        c /= std::max(norm, 1e-12);
        Start s{0.0, {}};
        for (std::size_t v = 0; v < view.size(); ++v) {
            const Vec2 a = view[v].head<2>() - meanV;
            const Vec2 p =
                meanD + Vec2(c.x() * a.x() - c.y() * a.y(), c.y() * a.x() + c.x() * a.y());
            if (sighting.seen[v]) s.misfit += (p - sighting.vertexPx[v]).squaredNorm();
            const Vec2 xy = sighting.seen[v] ? sighting.vertexPx[v] : p;
            s.points.emplace_back(xy.x(), xy.y(), c.norm() * view[v].z());
        }
        starts.push_back(std::move(s));
    }
    std::stable_sort(starts.begin(), starts.end(),
                     [](const Start& a, const Start& b) { return a.misfit < b.misfit; });
    std::vector<CameraPoints> points;
    for (Start& s : starts) points.push_back(std::move(s.points));
    return points;
}

}  // namespace ew
