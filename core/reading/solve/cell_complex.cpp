// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/cell_complex.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/reading/extract/plane_geometry.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The closed walk over segments that each end where another starts; empty where they are not one.
std::vector<int> oneLoop(const std::vector<std::array<int, 2>>& segments) {
    if (segments.size() < 3) return {};
    std::map<int, std::vector<int>> next;
    for (const auto& s : segments) {
        next[s[0]].push_back(s[1]);
        next[s[1]].push_back(s[0]);
    }
    std::vector<int> loop{segments.front()[0]};
    int before = -1;
    do {
        const std::vector<int>& to = next[loop.back()];
        if (to.size() != 2) return {};
        const int step = to[0] == before ? to[1] : to[0];
        before = loop.back();
        loop.push_back(step);
    } while (loop.back() != loop.front() && loop.size() <= segments.size());
    loop.pop_back();
    return loop.size() == segments.size() ? loop : std::vector<int>{};
}

}  // namespace

CellComplex::CellComplex(const Vec3& low, const Vec3& high) {
    for (int i = 0; i < 8; ++i) {
        vertices_.emplace_back(i % 2 == 0 ? low.x() : high.x(), i / 2 % 2 == 0 ? low.y() : high.y(),
                               i / 4 == 0 ? low.z() : high.z());
    }
    for (const auto& loop : {std::vector<int>{0, 1, 3, 2},
                             {4, 5, 7, 6},
                             {0, 1, 5, 4},
                             {2, 3, 7, 6},
                             {0, 2, 6, 4},
                             {1, 3, 7, 5}}) {
        facets_.push_back({loop, -1, {0, -1}});
    }
    sides_ = {0};
    cellFacets_ = {{0, 1, 2, 3, 4, 5}};
}

bool CellComplex::cut(const DrawnPlane& plane, double nearPx) {
    if (static_cast<int>(planes_.size()) == kMostPlanes) return false;
    planes_.push_back(plane);
    signs_.clear();
    for (const Vec3& v : vertices_) {
        const double d = plane.normal.dot(v) - plane.offset;
        signs_.push_back(static_cast<signed char>(d > nearPx ? 1 : (d < -nearPx ? -1 : 0)));
    }
    cells_.clear();
    return splitFacets() && splitCells();
}

bool CellComplex::splitFacets() {
    const DrawnPlane& plane = planes_.back();
    std::map<std::array<int, 2>, int> crossings;
    const std::size_t before = facets_.size();
    for (std::size_t f = 0; f < before; ++f) {
        const std::vector<int> loop = facets_[f].loop;
        const auto has = [&](int sign) {
            return std::any_of(loop.begin(), loop.end(), [&](int v) { return side(v) == sign; });
        };
        if (!has(1) || !has(-1)) continue;
        std::vector<int> plus, minus;
        int changes = 0;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const int v = loop[k];
            const int w = loop[(k + 1) % loop.size()];
            if (side(v) >= 0) plus.push_back(v);
            if (side(v) <= 0) minus.push_back(v);
            if (side(v) == 0) ++changes;
            if (side(v) * side(w) != -1) continue;
            ++changes;
            const std::array<int, 2> key{std::min(v, w), std::max(v, w)};
            auto known = crossings.find(key);
            if (known == crossings.end()) {
                const Vec3& a = vertices_[at(key[0])];
                const Vec3& b = vertices_[at(key[1])];
                const double da = plane.normal.dot(a) - plane.offset;
                const double db = plane.normal.dot(b) - plane.offset;
                vertices_.push_back(a + (b - a) * (da / (da - db)));
                signs_.push_back(0);
                known = crossings.emplace(key, static_cast<int>(vertices_.size()) - 1).first;
            }
            plus.push_back(known->second);
            minus.push_back(known->second);
        }
        if (changes != 2) return false;
        facets_[f].loop = std::move(plus);
        Facet other = facets_[f];
        other.loop = std::move(minus);
        for (const int c : other.cells) {
            if (c >= 0) cellFacets_[at(c)].push_back(static_cast<int>(facets_.size()));
        }
        facets_.push_back(std::move(other));
    }
    return true;
}

int CellComplex::cellSide(int cell) const {
    int found = 0;
    for (const int f : cellFacets_[at(cell)]) {
        for (const int v : facets_[at(f)].loop) {
            if (side(v) == 0) continue;
            if (found == -side(v)) return 2;
            found = side(v);
        }
    }
    return found;
}

bool CellComplex::splitCells() {
    const std::uint64_t bit = std::uint64_t{1} << (planes_.size() - 1);
    const int before = cellCount();
    for (int c = 0; c < before; ++c) {
        const int where = cellSide(c);
        if (where == 0) return false;  // thinner than what counts as on a plane
        if (where == 1) sides_[at(c)] |= bit;
        if (where != 2) continue;
        const int other = cellCount();
        if (sides_.size() == kMostCells) return false;
        sides_.push_back(sides_[at(c)]);
        sides_[at(c)] |= bit;
        std::vector<int> plus, minus;
        std::vector<std::array<int, 2>> rim;
        for (const int f : cellFacets_[at(c)]) {
            Facet& facet = facets_[at(f)];
            const auto& loop = facet.loop;
            const auto it =
                std::find_if(loop.begin(), loop.end(), [&](int v) { return side(v) != 0; });
            if (it == loop.end()) return false;
            if (side(*it) > 0) {
                plus.push_back(f);
                for (std::size_t k = 0; k < loop.size(); ++k) {
                    const int v = loop[k];
                    const int w = loop[(k + 1) % loop.size()];
                    if (side(v) == 0 && side(w) == 0) rim.push_back({v, w});
                }
            } else {
                minus.push_back(f);
                for (int& cell : facet.cells) {
                    if (cell == c) cell = other;
                }
            }
        }
        Facet cap;
        cap.loop = oneLoop(rim);
        if (cap.loop.empty()) return false;
        cap.plane = static_cast<int>(planes_.size()) - 1;
        cap.cells = {c, other};
        plus.push_back(static_cast<int>(facets_.size()));
        minus.push_back(static_cast<int>(facets_.size()));
        facets_.push_back(std::move(cap));
        cellFacets_[at(c)] = std::move(plus);
        cellFacets_.push_back(std::move(minus));
    }
    return true;
}

int CellComplex::cellAt(std::uint64_t sides) const {
    if (cells_.empty()) {
        for (int c = 0; c < cellCount(); ++c) cells_.emplace(sides_[at(c)], c);
    }
    const auto it = cells_.find(sides);
    return it == cells_.end() ? -1 : it->second;
}

double CellComplex::area(int facet) const {
    return 0.5 * doubleArea(vertices_, facets_[at(facet)].loop).norm();
}

}  // namespace ew
