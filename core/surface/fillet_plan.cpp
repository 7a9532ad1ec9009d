// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/fillet_plan.h"

#include <cmath>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

FilletPlan::FilletPlan(const FilletTopology& topology, std::vector<bool> filleted,
                       std::vector<CornerStyle> styles, std::vector<double> taper)
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
    for (int v = 0; at(v) < count_.size(); ++v) planVertex(v);
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
    const double cosine = std::abs(std::cos(angle)) < tol::kApartRelative ? 0.0 : std::cos(angle);
    if (own && other) {
        if (cosine < 0.0 && std::abs(sine) < tol::kFilletStraightSine) {
            s.kind = FilletSector::Kind::Step;
            s.firstOwn = s.lastOwn = std::cos(0.5 * angle) / std::sin(0.5 * angle);
            return;
        }
        s.kind = FilletSector::Kind::Miter;
        s.firstOwn = s.lastOwn = cosine / sine;
        s.firstOther = s.lastOther = 1.0 / sine;
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

double FilletPlan::start(int h, const std::vector<double>& setbacks) const {
    const FilletSector& s = sector(h);
    return s.firstOwn * setback(h, setbacks) + s.firstOther * setback(topology_.ccw(h), setbacks);
}

double FilletPlan::startAcross(int h, const std::vector<double>& setbacks) const {
    const int before = topology_.cw(h);
    const FilletSector& s = sector(before);
    return s.lastOwn * setback(h, setbacks) + s.lastOther * setback(before, setbacks);
}

}  // namespace ew
