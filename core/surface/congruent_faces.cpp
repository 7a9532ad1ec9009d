// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/congruent_faces.h"

#include <cmath>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void CongruentFaces::describe(int face) {
    const auto outline = mesh_.outline(face);
    const Vec3& origin = mesh_.point(outline[0]);
    const Vec3 x = (mesh_.point(outline[1]) - origin).normalized();
    const Vec3 across = loopAreaVector(mesh_.points, outline);
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
}

int CongruentFaces::first(int face) {
    // A face whose frame is none is like no other.
    if (loopAreaVector(mesh_.points, mesh_.outline(face)).isZero(0.0)) return face;
    describe(face);
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const std::int64_t s : shape_) {
        hash = (hash ^ static_cast<std::uint64_t>(s)) * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 29U;
    }
    const auto [it, isNew] = byHash_.try_emplace(hash, face);
    if (isNew) {
        shapes_.emplace(face, shape_);
        return face;
    }
    // Another shape of the same hash: so rare that not to know it does no harm.
    return shapes_.at(it->second) == shape_ ? it->second : face;
}

}  // namespace ew
