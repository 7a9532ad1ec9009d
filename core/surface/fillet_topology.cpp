// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/fillet_topology.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "core/surface/side_key.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

FilletTopology::FilletTopology(const Solid& solid) : solid_(solid) {
    addLoops();
    link();
    measure();
    makeRings();
}

void FilletTopology::addLoops() {
    for (std::size_t f = 0; f < solid_.faces().size(); ++f) {
        for (const std::vector<int>& loop : solid_.faces()[f].loops) {
            const int first = halfCount();
            const int count = static_cast<int>(loop.size());
            loops_.push_back(first);
            for (int k = 0; k < count; ++k) {
                FilletHalfEdge h;
                h.origin = loop[at(k)];
                h.face = static_cast<int>(f);
                h.next = first + (k + 1) % count;
                h.prev = first + (k + count - 1) % count;
                half_.push_back(h);
            }
        }
        loopStart_.push_back(loops_.size());
    }
}

void FilletTopology::link() {
    std::unordered_map<std::uint64_t, int> byEnds;
    byEnds.reserve(half_.size());
    for (int h = 0; h < halfCount(); ++h) {
        byEnds.emplace(sideKey(half(h).origin, half(half(h).next).origin), h);
    }
    const auto& edges = solid_.edges();
    ofEdge_.resize(edges.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const int h = byEnds.at(sideKey(edges[e].ends[0], edges[e].ends[1]));
        const int t = byEnds.at(sideKey(edges[e].ends[1], edges[e].ends[0]));
        half_[at(h)].twin = t;
        half_[at(t)].twin = h;
        half_[at(h)].edge = half_[at(t)].edge = static_cast<int>(e);
        ofEdge_[e] = h;
    }
}

void FilletTopology::measure() {
    for (FilletHalfEdge& h : half_) {
        const Vec3 d = position(half(h.next).origin) - position(h.origin);
        h.length = d.norm();
        h.dir = d / h.length;
        h.inward = solid_.faces()[at(h.face)].normal.cross(h.dir).normalized();
    }
    for (FilletHalfEdge& h : half_) {
        const Vec3 other = -half(h.prev).dir;
        double angle = std::atan2(other.dot(h.inward), other.dot(h.dir));
        if (angle <= 0.0) angle += 2.0 * std::numbers::pi;
        h.angle = angle;
    }
}

void FilletTopology::makeRings() {
    std::vector<int> start(solid_.vertices().size(), -1);
    for (int h = 0; h < halfCount(); ++h) {
        if (start[at(half(h).origin)] < 0) start[at(half(h).origin)] = h;
    }
    ring_.reserve(half_.size());
    for (const int first : start) {
        int h = first;
        do {
            ring_.push_back(h);
            h = ccw(h);
        } while (h != first);
        ringStart_.push_back(ring_.size());
    }
}

double foldCosine(const FilletTopology& topology, int edge) {
    const FilletHalfEdge& h = topology.half(topology.ofEdge(edge));
    return std::clamp(h.inward.dot(topology.half(h.twin).inward), -1.0, 1.0);
}

}  // namespace ew
