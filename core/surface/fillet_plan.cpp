// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/fillet_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double cosineOf(double angle) {
    const double cosine = std::cos(angle);
    return std::abs(cosine) < tol::kApartRelative ? 0.0 : cosine;
}

}  // namespace

MiterWeights miterWeights(double angle) {
    const double sine = std::sin(angle);
    return {cosineOf(angle) / sine, 1.0 / sine};
}

FilletPlan::FilletPlan(const FilletTopology& topology, std::vector<bool> filleted,
                       std::vector<CornerStyle> styles, std::vector<double> taper,
                       const std::vector<bool>& arcs)
    : topology_(topology),
      filleted_(std::move(filleted)),
      styles_(std::move(styles)),
      taper_(std::move(taper)),
      sectors_(at(topology.halfCount())),
      count_(topology.solid().vertices().size(), 0),
      cap_(count_.size(), false),
      kept_(count_.size(), false) {
    for (int h = 0; h < topology_.halfCount(); ++h) {
        if (FilletPlan::filleted(h)) ++count_[at(topology_.half(h).origin)];
    }
    for (int h = 0; h < topology_.halfCount(); ++h) planSector(h);
    for (int v = 0; at(v) < count_.size(); ++v) {
        planVertex(v);
        planArcs(v, arcs);
    }
}

void FilletPlan::planSector(int h) {
    FilletSector& s = sectors_[at(h)];
    const bool own = filleted(h);
    const bool other = filleted(topology_.ccw(h));
    if (!own && !other) return;
    const int v = topology_.half(h).origin;
    if (styles_[at(v)] == CornerStyle::Taper) {
        s.kind = FilletSector::Kind::End;
        s.keepsCorner = true;
        s.firstOwn = own ? taper_[at(v)] : 0.0;
        s.lastOwn = other ? taper_[at(v)] : 0.0;
        return;
    }
    const double angle = topology_.half(h).angle;
    const double sine = std::sin(angle);
    const double cosine = cosineOf(angle);
    if (own && other) {
        if (cosine < 0.0 && std::abs(sine) < tol::kFilletStraightSine) {
            s.kind = FilletSector::Kind::Step;
            s.firstOwn = s.lastOwn = std::cos(0.5 * angle) / std::sin(0.5 * angle);
            return;
        }
        s.kind = FilletSector::Kind::Miter;
        const MiterWeights weights = miterWeights(angle);
        s.firstOwn = s.lastOwn = weights.own;
        s.firstOther = s.lastOther = weights.other;
        return;
    }
    // A narrow sector is cut far out because there is no other way; any other one in reach only.
    const bool narrow = cosine > 0.0 && sine > 0.0;
    if (!narrow && std::abs(sine) < tol::kFilletCutSine) {
        s.kind = FilletSector::Kind::End;
        s.keepsCorner = true;
        return;
    }
    s.kind = FilletSector::Kind::Cut;
    (own ? s.firstOwn : s.lastOwn) = cosine / sine;
    (own ? s.lastOther : s.firstOther) = 1.0 / sine;
}

void FilletPlan::planVertex(int vertex) {
    const auto ring = topology_.ring(vertex);
    if (count_[at(vertex)] == 0) {
        kept_[at(vertex)] = true;
        return;
    }
    using Kind = FilletSector::Kind;
    int cuts = 0;
    int behind = 0;  // cuts that prolong the sharp edge beyond the corner
    for (const int h : ring) {
        const FilletSector& s = sectors_[at(h)];
        if (s.kind != Kind::Cut) continue;
        ++cuts;
        if (s.firstOther < 0.0 || s.lastOther < 0.0) ++behind;
    }
    if (styles_[at(vertex)] == CornerStyle::Patch && ring.size() == 3 && count_[at(vertex)] == 1 &&
        cuts == 2 && behind < 2) {
        cap_[at(vertex)] = true;
        return;
    }
    bool kept = false;
    for (const int h : ring) {
        FilletSector& s = sectors_[at(h)];
        if (s.kind == Kind::Bare) s.keepsCorner = true;
        // The sharp edge of a prolonged cut, and its sector on the other side.
        if (s.kind == Kind::Cut && s.lastOther < 0.0) {
            const FilletSector& across = sectors_[at(topology_.ccw(h))];
            s.keepsCorner = across.kind != Kind::Cut || across.firstOther <= 0.0;
        } else if (s.kind == Kind::Cut && s.firstOther < 0.0) {
            const FilletSector& across = sectors_[at(topology_.cw(h))];
            s.keepsCorner = across.kind != Kind::Cut || across.lastOther <= 0.0;
        }
        kept = kept || s.keepsCorner;
    }
    if (!kept) return;
    kept_[at(vertex)] = true;
    // A prolonged cut beside a kept corner has to go through it.
    for (const int h : ring) {
        FilletSector& s = sectors_[at(h)];
        if (s.kind == Kind::Cut && (s.firstOther < 0.0 || s.lastOther < 0.0)) s.keepsCorner = true;
    }
}

bool goesRound(const FilletTopology& topology, int h, const std::vector<double>& setbacks) {
    const auto setback = [&](int g) { return setbacks[at(topology.half(g).edge)]; };
    const double angle = topology.half(h).angle;
    const int before = topology.cw(h);
    const int next = topology.ccw(h);
    const int after = topology.ccw(next);
    for (const int g : {before, h, next, after}) {
        if (setback(g) <= 0.0) return false;
    }
    // In a reflex corner the sides would meet behind the corner and pinch the strips.
    if (angle > std::numbers::pi) return true;
    if (before != after) return false;
    const auto& edges = topology.solid().edges();
    const auto convex = [&](int g) { return edges[at(topology.half(g).edge)].convex; };
    if (convex(h) != convex(next) || convex(h) != convex(before)) return false;
    if (setback(before) <= std::max(setback(h), setback(next))) return false;
    const MiterWeights own = miterWeights(angle);
    const auto ahead = [&](int g, int other, double side) {
        const MiterWeights across = miterWeights(side);
        return across.own * setback(g) + across.other * setback(before) - own.own * setback(g) -
               own.other * setback(other);
    };
    const double least = std::min(ahead(h, next, topology.half(before).angle),
                                  ahead(next, h, topology.half(next).angle));
    return least > tol::kFilletArcLeast * setback(before);
}

/// Where all edges of the corner are filleted and the neighbouring sectors have one point each.
void FilletPlan::planArcs(int vertex, const std::vector<bool>& arcs) {
    const auto ring = topology_.ring(vertex);
    if (styles_[at(vertex)] != CornerStyle::Patch || ring.size() < 3) return;
    if (at(count_[at(vertex)]) != ring.size()) return;
    using Kind = FilletSector::Kind;
    const auto mitered = [&](int h) {
        return sectors_[at(h)].kind == Kind::Miter && topology_.half(h).angle < std::numbers::pi;
    };
    for (const int h : ring) {
        const int before = topology_.cw(h);
        const int after = topology_.ccw(h);
        if (!arcs[at(h)] || !mitered(before) || !mitered(after)) continue;
        FilletSector& s = sectors_[at(h)];
        s.kind = Kind::Arc;
        s.firstOwn = sectors_[at(before)].lastOwn;
        s.firstOther = sectors_[at(before)].lastOther;
        s.lastOwn = sectors_[at(after)].firstOwn;
        s.lastOther = sectors_[at(after)].firstOther;
    }
}

double FilletPlan::start(int h, const std::vector<double>& setbacks) const {
    const FilletSector& s = sector(h);
    return s.firstOwn * setback(h, setbacks) + s.firstOther * setback(firstBeside(h), setbacks);
}

double FilletPlan::startAcross(int h, const std::vector<double>& setbacks) const {
    const int before = topology_.cw(h);
    const FilletSector& s = sector(before);
    return s.lastOwn * setback(h, setbacks) + s.lastOther * setback(lastBeside(before), setbacks);
}

}  // namespace ew
