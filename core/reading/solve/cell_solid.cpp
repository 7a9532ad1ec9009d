// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/cell_solid.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/reading/extract/plane_geometry.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Joins the facets between solid and empty cells to faces.
class Surface {
  public:
    Surface(const CellComplex& complex, const std::vector<bool>& solid) : complex_(complex) {
        for (const CellComplex::Facet& f : complex.facets()) {
            if (f.cells[0] < 0 || f.cells[1] < 0) continue;
            if (solid[at(f.cells[0])] == solid[at(f.cells[1])]) continue;
            add(f, solid[at(f.cells[1])]);
        }
    }

    std::optional<CellSolid> faces() {
        if (!group()) return std::nullopt;
        findCorners();
        CellSolid out;
        out.faces.resize(count_);
        for (std::size_t g = 0; g < count_; ++g) {
            if (!loopsOf(static_cast<int>(g), out.faces[g])) return std::nullopt;
        }
        for (const int v : used_) out.vertices.push_back(complex_.vertices()[at(v)]);
        return out.faces.empty() ? std::nullopt : std::optional(std::move(out));
    }

  private:
    struct Piece {
        std::vector<int> loop;  ///< counter-clockwise from outside
        int plane = -1;
        bool outward = true;  ///< the plane's normal points out of the solid
        int group = -1;
    };

    void add(const CellComplex::Facet& f, bool outward) {
        Piece piece{f.loop, f.plane, outward, -1};
        const Vec3 area = doubleArea(complex_.vertices(), f.loop);
        const bool along = area.dot(complex_.planes()[at(f.plane)].normal) > 0.0;
        // Camera space is right-handed, so loops turn as in any other space.
        if (along != outward) std::reverse(piece.loop.begin(), piece.loop.end());
        pieces_.push_back(std::move(piece));
    }

    bool group() {
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const auto& loop = pieces_[i].loop;
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const bool isNew =
                    edges_
                        .emplace(std::array<int, 2>{loop[k], loop[(k + 1) % loop.size()]},
                                 static_cast<int>(i))
                        .second;
                if (!isNew) return false;  // four faces at an edge
            }
        }
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (pieces_[i].group >= 0) continue;
            const int g = static_cast<int>(count_++);
            std::vector<int> open{static_cast<int>(i)};
            pieces_[i].group = g;
            while (!open.empty()) {
                const Piece& piece = pieces_[at(open.back())];
                open.pop_back();
                for (std::size_t k = 0; k < piece.loop.size(); ++k) {
                    const auto next =
                        edges_.find({piece.loop[(k + 1) % piece.loop.size()], piece.loop[k]});
                    if (next == edges_.end()) return false;
                    Piece& other = pieces_[at(next->second)];
                    if (other.group >= 0 || other.plane != piece.plane ||
                        other.outward != piece.outward) {
                        continue;
                    }
                    other.group = g;
                    open.push_back(next->second);
                }
            }
        }
        return true;
    }

    void findCorners() {
        std::map<int, std::set<int>> groups;
        for (const Piece& p : pieces_) {
            for (const int v : p.loop) groups[v].insert(p.group);
        }
        for (const auto& [v, found] : groups) {
            if (found.size() < 3) continue;
            number_[v] = static_cast<int>(used_.size());
            used_.push_back(v);
        }
    }

    bool loopsOf(int group, CellSolid::Face& face) const {
        std::map<int, int> next;
        for (const Piece& p : pieces_) {
            if (p.group != group) continue;
            face.plane = p.plane;
            for (std::size_t k = 0; k < p.loop.size(); ++k) {
                const int v = p.loop[k];
                const int w = p.loop[(k + 1) % p.loop.size()];
                const auto other = edges_.find({w, v});
                if (pieces_[at(other->second)].group == group) continue;
                if (!next.emplace(v, w).second) return false;  // touches itself in a corner
            }
        }
        double widest = 0.0;
        while (!next.empty()) {
            std::vector<int> loop;
            std::vector<int> all;
            int v = next.begin()->first;
            for (auto it = next.find(v); it != next.end(); it = next.find(v)) {
                all.push_back(v);
                const auto corner = number_.find(v);
                if (corner != number_.end()) loop.push_back(corner->second);
                v = it->second;
                next.erase(it);
            }
            if (loop.size() < 3) return false;
            const double area = doubleArea(complex_.vertices(), all).norm();
            face.loops.push_back(std::move(loop));
            if (area > widest) {
                widest = area;
                std::swap(face.loops.front(), face.loops.back());
            }
        }
        return !face.loops.empty();
    }

    const CellComplex& complex_;
    std::vector<Piece> pieces_;
    std::map<std::array<int, 2>, int> edges_;  ///< directed, to the piece on its left
    std::size_t count_ = 0;
    std::map<int, int> number_;  ///< vertex of the complex to corner
    std::vector<int> used_;
};

}  // namespace

std::optional<CellSolid> cellSolid(const CellComplex& complex, const std::vector<bool>& solid) {
    return Surface(complex, solid).faces();
}

}  // namespace ew
