// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/congruent_faces.h"

#include <cmath>

#include "core/surface/key_hash.h"

namespace ew {

bool CongruentFaces::describe(int face) {
    const auto outline = mesh_.outline(face);
    const Vec3& origin = mesh_.point(outline[0]);
    const Vec3 x = (mesh_.point(outline[1]) - origin).normalized();
    const Vec3 across = loopAreaVector(mesh_.points, outline);
    if (across.isZero(0.0)) return false;
    const Vec3 z = (across - x * x.dot(across)).normalized();
    const Vec3 y = z.cross(x);
    shape_.clear();
    shape_.push_back(classes_.of(face));
    const auto add = [&](double length) { shape_.push_back(std::llround(length / precision_)); };
    for (const int i : classes_.hull(face)) {
        const Vec3 d = mesh_.point(i) - origin;
        add(x.dot(d));
        add(y.dot(d));
        add(z.dot(d));
    }
    return true;
}

int CongruentFaces::first(int face) {
    if (!describe(face)) return face;
    const auto [it, isNew] = byHash_.try_emplace(keyHash(shape_));
    Known& known = it->second;
    if (isNew) known = {face, shape_};
    // Another shape of the same hash: so rare that not to know it does no harm.
    return known.shape == shape_ ? known.face : face;
}

}  // namespace ew
