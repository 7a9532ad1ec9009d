// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/face_classes.h"

#include <bit>

#include "core/surface/key_hash.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

FaceClasses::FaceClasses(const ControlCage& cage, const CageEdges& edges)
    : mesh_(cage.mesh),
      edges_(edges),
      seen_(cage.mesh.points.size(), -1),
      place_(cage.mesh.points.size(), -1) {
    class_.reserve(at(mesh_.faceCount()));
    hullStart_.reserve(at(mesh_.faceCount()) + 1);
    hull_.reserve(20 * at(mesh_.faceCount()));
    for (int f = 0; f < mesh_.faceCount(); ++f) {
        describe(f);
        hullStart_.push_back(hull_.size());
        class_.push_back(classify());
        ++size_[at(class_.back())];
    }
}

/// Walks round every corner of the face, over every face there.
void FaceClasses::describe(int face) {
    key_.clear();
    const std::size_t base = hull_.size();
    const auto note = [&](int point) {
        if (seen_[at(point)] != face) {
            seen_[at(point)] = face;
            place_[at(point)] = static_cast<int>(hull_.size() - base);
            hull_.push_back(point);
        }
        key_.push_back(static_cast<std::uint32_t>(place_[at(point)]));
    };
    const int first = edges_.firstSide(face);
    const int end = edges_.firstSide(face + 1);
    key_.push_back(static_cast<std::uint32_t>(end - first));
    for (int s = first; s < end; ++s) note(mesh_.corners[at(s)]);
    for (int corner = first; corner < end; ++corner) {
        key_.push_back(
            std::bit_cast<std::uint32_t>(edges_.pointSharpness(mesh_.corners[at(corner)])));
        int side = corner;
        do {
            const int f = edges_.faceOf(side);
            const int from = edges_.firstSide(f);
            const int to = edges_.firstSide(f + 1);
            // No face has so many corners that this is a point's place in the hull.
            key_.push_back(0x80000000U | static_cast<std::uint32_t>(to - from));
            key_.push_back(std::bit_cast<std::uint32_t>(edges_.sharpness(edges_.edge(side))));
            // All its points but the last, which the next face has as its first.
            int s = side;
            for (int k = 0; k + 2 < to - from; ++k) {
                s = s + 1 < to ? s + 1 : from;
                note(mesh_.corners[at(s)]);
            }
            side = edges_.twin(side > from ? side - 1 : to - 1);
        } while (side != corner);
    }
}

int FaceClasses::classify() {
    for (std::uint64_t hash = keyHash(key_);; ++hash) {
        const auto [it, isNew] = byHash_.try_emplace(hash, count());
        if (isNew) {
            keys_.push_back(key_);
            size_.push_back(0);
            return it->second;
        }
        if (keys_[at(it->second)] == key_) return it->second;
    }
}

}  // namespace ew
