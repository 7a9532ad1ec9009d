// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/brep.h"

#include <algorithm>

namespace ew {
namespace {

using He = Mesh::HalfedgeHandle;

class Tracer {
  public:
    explicit Tracer(const ExactMesh& surface) : surface_(surface), mesh_(surface.mesh) {}

    PersonView run(std::size_t regionCount) {
        floodFill();
        findCorners();
        traceLoops();
        renumber();
        view_.changed |= view_.brep.faces.size() != regionCount;
        return std::move(view_);
    }

  private:
    int faceOf(He h) const {
        return view_.faceOfTriangle[static_cast<std::size_t>(mesh_.face_handle(h).idx())];
    }
    bool isBoundary(He h) const { return faceOf(h) != faceOf(mesh_.opposite_halfedge_handle(h)); }
    const Point3& tip(He h) const { return surface_.point(mesh_.to_vertex_handle(h)); }

    bool joined(He h) const {
        const He o = mesh_.opposite_halfedge_handle(h);
        if (surface_.regionOf(mesh_.face_handle(h)) == surface_.regionOf(mesh_.face_handle(o))) {
            return true;
        }
        return CGAL::coplanar(tip(o), tip(h), tip(mesh_.next_halfedge_handle(h)),
                              tip(mesh_.next_halfedge_handle(o)));
    }

    void floodFill() {
        auto& face = view_.faceOfTriangle;
        face.assign(mesh_.n_faces(), -1);
        std::vector<Mesh::FaceHandle> pending;
        for (const auto seed : mesh_.faces()) {
            if (face[static_cast<std::size_t>(seed.idx())] >= 0) continue;
            face[static_cast<std::size_t>(seed.idx())] = faceCount_;
            pending.push_back(seed);
            while (!pending.empty()) {
                const auto f = pending.back();
                pending.pop_back();
                for (const auto h : mesh_.fh_range(f)) {
                    const auto g = mesh_.opposite_face_handle(h);
                    int& other = face[static_cast<std::size_t>(g.idx())];
                    if (other >= 0 || !joined(h)) continue;
                    other = faceCount_;
                    pending.push_back(g);
                }
            }
            ++faceCount_;
        }
    }

    void findCorners() {
        corner_.assign(mesh_.n_vertices(), false);
        for (const auto v : mesh_.vertices()) {
            std::vector<He> sides;
            for (const auto h : mesh_.voh_range(v)) {
                if (isBoundary(h)) sides.push_back(h);
            }
            const bool straight = sides.size() == 2 &&
                                  CGAL::collinear(tip(sides[0]), surface_.point(v), tip(sides[1]));
            const bool keep = !sides.empty() && !straight;
            corner_[static_cast<std::size_t>(v.idx())] = keep;
            view_.changed |= !keep;
        }
    }

    void traceLoops() {
        view_.brep.faces.assign(static_cast<std::size_t>(faceCount_), {});
        std::vector<bool> seen(mesh_.n_halfedges(), false);
        for (const auto start : mesh_.halfedges()) {
            if (seen[static_cast<std::size_t>(start.idx())] || !isBoundary(start)) continue;
            std::vector<int> loop;
            He h = start;
            do {
                seen[static_cast<std::size_t>(h.idx())] = true;
                const int v = mesh_.from_vertex_handle(h).idx();
                if (corner_[static_cast<std::size_t>(v)]) loop.push_back(v);
                h = mesh_.next_halfedge_handle(h);
                // Turn round the point inside the face until its next side.
                while (!isBoundary(h)) {
                    h = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(h));
                }
            } while (h != start);
            view_.brep.faces[static_cast<std::size_t>(faceOf(start))].push_back(std::move(loop));
        }
        for (FaceLoops& loops : view_.brep.faces) {
            if (loops.size() > 1) putOuterFirst(loops);
            orderLoops(loops);
        }
    }

    /// The outer loop bounds the others, so it holds the face's lowest point, whatever the order.
    void putOuterFirst(FaceLoops& loops) const {
        const auto lowest = [&](const std::vector<int>& loop) {
            const Point3* best = nullptr;
            for (const int i : loop) {
                const Point3& p = surface_.point(Mesh::VertexHandle(i));
                if (best == nullptr || CGAL::compare_xyz(p, *best) == CGAL::SMALLER) best = &p;
            }
            return *best;
        };
        std::size_t outer = 0;
        Point3 best = lowest(loops[0]);
        for (std::size_t k = 1; k < loops.size(); ++k) {
            const Point3 p = lowest(loops[k]);
            if (CGAL::compare_xyz(p, best) != CGAL::SMALLER) continue;
            best = p;
            outer = k;
        }
        std::swap(loops[0], loops[outer]);
    }

    void renumber() {
        std::vector<int> index(mesh_.n_vertices(), -1);
        for (const auto v : mesh_.vertices()) {
            if (!corner_[static_cast<std::size_t>(v.idx())]) continue;
            index[static_cast<std::size_t>(v.idx())] = static_cast<int>(view_.brep.points.size());
            view_.brep.points.push_back(surface_.point(v));
        }
        for (FaceLoops& loops : view_.brep.faces) {
            for (std::vector<int>& loop : loops) {
                for (int& i : loop) i = index[static_cast<std::size_t>(i)];
            }
        }
    }

    const ExactMesh& surface_;
    const Mesh& mesh_;
    PersonView view_;
    std::vector<bool> corner_;
    int faceCount_ = 0;
};

}  // namespace

void orderLoops(FaceLoops& loops) {
    for (std::vector<int>& loop : loops) {
        // A loop may pass its smallest index more than once (a hole that touches the outline).
        const int smallest = *std::min_element(loop.begin(), loop.end());
        std::vector<int> best;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            if (loop[k] != smallest) continue;
            std::vector<int> turned = loop;
            std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(k),
                        turned.end());
            if (best.empty() || turned < best) best = std::move(turned);
        }
        loop = std::move(best);
    }
    if (loops.size() > 2) std::sort(loops.begin() + 1, loops.end());
}

PersonView personView(const ExactMesh& surface, std::size_t regionCount) {
    return Tracer(surface).run(regionCount);
}

}  // namespace ew
