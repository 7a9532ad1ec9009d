// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/shape_reading.h"

#include "core/document/export_place.h"

namespace ew {

ReadingFaults readingFaults(std::span<const Vec3> points,
                            std::span<const std::array<int, 3>> triangles) {
    std::vector<Eigen::Vector3f> single;
    single.reserve(points.size());
    for (const Vec3& p : points) single.push_back(p.cast<float>());
    return faultsWhenRead(single, triangles);
}

bool readsAsClosed(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles) {
    const ReadingFaults faults = readingFaults(points, triangles);
    return faults.openEdges == 0 && faults.withoutArea < triangles.size();
}

bool readsAsClosed(const std::vector<Body>& bodies, const std::vector<BodyShape>& shapes) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const ShapeMesh mesh = shapeMesh(bodies[b], shapes[b]);
        if (!readsAsClosed(atOwnOrigin(mesh.positions), mesh.triangles)) return false;
    }
    return true;
}

}  // namespace ew
