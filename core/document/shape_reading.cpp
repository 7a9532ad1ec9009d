// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/shape_reading.h"

namespace ew {

ReadingFaults readingFaults(const ShapeMesh& mesh) {
    std::vector<Eigen::Vector3f> points;
    points.reserve(mesh.positions.size());
    for (const Vec3& p : mesh.positions) points.push_back(p.cast<float>());
    return faultsWhenRead(points, mesh.triangles);
}

bool readsAsClosed(const ShapeMesh& mesh) {
    const ReadingFaults faults = readingFaults(mesh);
    return faults.openEdges == 0 && faults.withoutArea < mesh.triangles.size();
}

bool readsAsClosed(const std::vector<Body>& bodies, const std::vector<BodyShape>& shapes) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (!readsAsClosed(shapeMesh(bodies[b], shapes[b]))) return false;
    }
    return true;
}

}  // namespace ew
