// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/overlay.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

/// A point of one surface near the other.
struct Node {
    int id = -1;  ///< point of the overlay
    PointView point;
    std::array<Spot, 2> spot;
    std::array<bool, 2> known{false, false};
};

/// A part of a line in which surfaces can meet, with no node between its ends.
struct Piece {
    int a = -1, b = -1;  ///< nodes
    std::array<Spot, 2> spot;
    std::array<bool, 2> known{false, false};
    std::vector<int> classes;  ///< planes in which it matters, each once
};

/// Is the solid there, in the wedges left and right of a piece, above and below a plane?
struct Wedges {
    std::array<std::array<bool, 2>, 2> in{};  ///< [0 left, 1 right][0 above, 1 below]
};

class Overlayer {
  public:
    Overlayer(const Operand& target, const Operand& tool, BooleanKind kind)
        : solid_{&target, &tool}, kind_(kind) {
        out_.firstTool = static_cast<int>(target.solid().vertices.size());
        out_.firstNew = out_.firstTool + static_cast<int>(tool.solid().vertices.size());
    }

    Overlay run() {
        nameClasses();
        for (const int x : {0, 1}) addCorners(x);
        for (const int x : {0, 1}) addCrossings(x);
        findSpots();
        for (const int x : {0, 1}) cutEdges(x);
        cutFacets();
        for (Piece& piece : pieces_) evaluate(piece);
        passThrough();
        finish();
        return std::move(out_);
    }

  private:
    // Planes -------------------------------------------------------------------------------------

    void nameClasses() {
        std::map<std::array<double, 4>, std::vector<int>> known;
        for (const int x : {0, 1}) {
            for (const Facet& f : solid_[idx(x)]->facets()) {
                auto& list = known[{f.plane->n.x(), f.plane->n.y(), f.plane->n.z(), f.plane->d}];
                const auto same = std::find_if(
                    list.begin(), list.end(), [&](int c) { return *classes_[idx(c)] == *f.plane; });
                if (same != list.end()) {
                    classOf_[idx(x)].push_back(*same);
                    continue;
                }
                classOf_[idx(x)].push_back(static_cast<int>(classes_.size()));
                list.push_back(static_cast<int>(classes_.size()));
                classes_.push_back(f.plane);
            }
        }
    }

    // Nodes --------------------------------------------------------------------------------------

    int nodeAt(const PointView& p) const {
        const auto range = byPlace_.equal_range({p.r.x(), p.r.y(), p.r.z()});
        for (auto it = range.first; it != range.second; ++it) {
            if (equal(nodes_[idx(it->second)].point, p)) return it->second;
        }
        return -1;
    }

    int addNode(int id, const PointView& p) {
        Node node;
        node.id = id;
        node.point = p;
        byPlace_.emplace(std::array<double, 3>{p.r.x(), p.r.y(), p.r.z()},
                         static_cast<int>(nodes_.size()));
        nodes_.push_back(node);
        return static_cast<int>(nodes_.size()) - 1;
    }

    void setSpot(int node, int x, const Spot& spot) {
        nodes_[idx(node)].spot[idx(x)] = spot;
        nodes_[idx(node)].known[idx(x)] = true;
    }

    void addCorners(int x) {
        const Operand& s = *solid_[idx(x)];
        auto& nodeOf = nodeOfVertex_[idx(x)];
        for (const OperandEdge& e : s.edges()) {
            for (const int v : e.ends) {
                if (nodeOf.contains(v)) continue;
                int node = x == 0 ? -1 : nodeAt(s.point(v));
                if (node < 0) node = addNode(x == 0 ? v : out_.firstTool + v, s.point(v));
                nodeOf.emplace(v, node);
                setSpot(node, x, {Spot::Kind::Vertex, v});
            }
        }
    }

    /// Points in which edges of one solid run through facets of the other.
    void addCrossings(int x) {
        const Operand& s = *solid_[idx(x)];
        const Operand& other = *solid_[idx(1 - x)];
        for (std::size_t g = 0; g < other.facets().size(); ++g) {
            const Facet& facet = other.facets()[g];
            for (std::size_t e = 0; e < s.edges().size(); ++e) {
                const OperandEdge& edge = s.edges()[e];
                if (!edge.box.intersects(facet.box)) continue;
                const PointView a = s.point(edge.ends[0]);
                const PointView b = s.point(edge.ends[1]);
                if (sideOf(*facet.plane, a) * sideOf(*facet.plane, b) >= 0) continue;
                OwnPoint p = crossing(*facet.plane, a, b);
                const Spot spot = other.inFacet(static_cast<int>(g), p.view());
                if (!spot.onSurface()) continue;
                int node = nodeAt(p.view());
                if (node < 0) {
                    fresh_.push_back(std::move(p));
                    const int id = out_.firstNew + static_cast<int>(fresh_.size()) - 1;
                    node = addNode(id, fresh_.back().view());
                }
                setSpot(node, x, {Spot::Kind::Edge, static_cast<int>(e)});
                setSpot(node, 1 - x, spot);
            }
        }
    }

    void findSpots() {
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            for (const int x : {0, 1}) {
                if (nodes_[n].known[idx(x)]) continue;
                setSpot(static_cast<int>(n), x, solid_[idx(x)]->onSurface(nodes_[n].point));
            }
            for (const int x : {0, 1}) {
                const Spot& spot = nodes_[n].spot[idx(x)];
                if (spot.kind == Spot::Kind::Edge) {
                    onEdge_[idx(x)][spot.index].push_back(static_cast<int>(n));
                }
                for (const int f : solid_[idx(x)]->facetsOf(spot)) {
                    onFacet_[idx(x)][f].push_back(static_cast<int>(n));
                }
            }
        }
    }

    // Pieces -------------------------------------------------------------------------------------

    /// Nodes of one line in order along it.
    void sortAlong(std::vector<int>& nodes) const {
        Box3 box;
        for (const int n : nodes) box.extend(nodes_[idx(n)].point.r);
        int axis = 0;
        box.sizes().maxCoeff(&axis);
        std::sort(nodes.begin(), nodes.end(), [&](int p, int q) {
            return compare(nodes_[idx(p)].point, nodes_[idx(q)].point, axis) < 0;
        });
    }

    Piece& pieceBetween(int a, int b) {
        const auto [it, fresh] =
            pieceAt_.emplace(std::minmax(a, b), static_cast<int>(pieces_.size()));
        if (fresh) {
            Piece piece;
            piece.a = a;
            piece.b = b;
            pieces_.push_back(piece);
        }
        return pieces_[idx(it->second)];
    }

    static void addClass(Piece& piece, int c) {
        if (std::find(piece.classes.begin(), piece.classes.end(), c) == piece.classes.end()) {
            piece.classes.push_back(c);
        }
    }

    void cutEdges(int x) {
        const Operand& s = *solid_[idx(x)];
        for (std::size_t e = 0; e < s.edges().size(); ++e) {
            const OperandEdge& edge = s.edges()[e];
            std::vector<int> line;
            for (const int v : edge.ends) line.push_back(nodeOfVertex_[idx(x)].at(v));
            const auto more = onEdge_[idx(x)].find(static_cast<int>(e));
            if (more != onEdge_[idx(x)].end()) {
                line.insert(line.end(), more->second.begin(), more->second.end());
                sortAlong(line);
            }
            for (std::size_t k = 0; k + 1 < line.size(); ++k) {
                Piece& piece = pieceBetween(line[k], line[k + 1]);
                piece.spot[idx(x)] = {Spot::Kind::Edge, static_cast<int>(e)};
                piece.known[idx(x)] = true;
                for (const int f : edge.facets) addClass(piece, classOf_[idx(x)][idx(f)]);
            }
        }
    }

    /// Lines in which a facet of one solid cuts a facet of the other.
    void cutFacets() {
        for (auto& lists : onFacet_) {
            for (auto& [f, list] : lists) std::sort(list.begin(), list.end());
        }
        std::vector<int> line;
        for (const auto& [f, list] : onFacet_[0]) {
            const Box3& box = solid_[0]->facets()[idx(f)].box;
            for (const auto& [g, other] : onFacet_[1]) {
                if (classOf_[0][idx(f)] == classOf_[1][idx(g)]) continue;
                if (!box.intersects(solid_[1]->facets()[idx(g)].box)) continue;
                line.clear();
                std::set_intersection(list.begin(), list.end(), other.begin(), other.end(),
                                      std::back_inserter(line));
                if (line.size() < 2) continue;
                sortAlong(line);
                for (std::size_t k = 0; k + 1 < line.size(); ++k) {
                    cutFacetPair(f, g, line[k], line[k + 1]);
                }
            }
        }
    }

    void cutFacetPair(int f, int g, int a, int b) {
        const std::array<int, 2> facet{f, g};
        const OwnPoint middle = midpoint(nodes_[idx(a)].point, nodes_[idx(b)].point);
        std::array<Spot, 2> spot;
        for (const int x : {0, 1}) {
            spot[idx(x)] = solid_[idx(x)]->inFacet(facet[idx(x)], middle.view());
            if (!spot[idx(x)].onSurface()) return;
        }
        Piece& piece = pieceBetween(a, b);
        for (const int x : {0, 1}) {
            piece.spot[idx(x)] = spot[idx(x)];
            piece.known[idx(x)] = true;
            addClass(piece, classOf_[idx(x)][idx(facet[idx(x)])]);
        }
    }

    // Evaluation ---------------------------------------------------------------------------------

    /// Sign of (normal of the plane x direction of the piece) . normal of a facet.
    int leftSign(const RPlane& plane, const Piece& piece, const RPlane& facet) const {
        const PointView& a = nodes_[idx(piece.a)].point;
        const PointView& b = nodes_[idx(piece.b)].point;
        const Vec3 along = b.r - a.r;
        const double value = plane.n.cross(along).dot(facet.n);
        const double reach = std::max(a.r.cwiseAbs().maxCoeff(), b.r.cwiseAbs().maxCoeff());
        if (std::abs(value) > tol::kTripleError * reach) return value > 0 ? 1 : -1;
        return sgn(dot(cross(plane.normal, minus(b, a)), facet.normal));
    }

    Wedges wedgesOf(int x, const Piece& piece, int c) const {
        Wedges out;
        const Spot& spot = piece.spot[idx(x)];
        if (!spot.onSurface()) {
            const bool inside = spot.kind == Spot::Kind::Inside;
            for (auto& side : out.in) side = {inside, inside};
            return out;
        }
        const Operand& s = *solid_[idx(x)];
        const std::vector<int> facets = s.facetsOf(spot);
        const bool all = spot.kind == Spot::Kind::Facet || s.edges()[idx(spot.index)].convex;
        for (auto& side : out.in) side = {all, all};
        for (const int f : facets) {
            const Facet& facet = s.facets()[idx(f)];
            const bool coplanar = classOf_[idx(x)][idx(f)] == c;
            const int left =
                coplanar ? 0 : facet.sign * leftSign(*classes_[idx(c)], piece, *facet.plane);
            for (const std::size_t side : {0U, 1U}) {
                for (const std::size_t below : {0U, 1U}) {
                    const int outward = left != 0 ? (side == 0 ? left : -left)
                                                  : (below == 0 ? facet.sign : -facet.sign);
                    bool& in = out.in[side][below];
                    in = all ? in && outward < 0 : in || outward < 0;
                }
            }
        }
        return out;
    }

    bool combined(bool inTarget, bool inTool) const {
        switch (kind_) {
            case BooleanKind::Add:
                return inTarget || inTool;
            case BooleanKind::Cut:
                return inTarget && !inTool;
            default:
                return inTarget && inTool;
        }
    }

    /// The facet of the plane that makes the surface on one side of a piece; the target's first.
    FaceOrigin originOf(const Piece& piece, int c, std::size_t side,
                        const std::array<Wedges, 2>& wedges, int& facet) const {
        FaceOrigin origin;
        for (const int x : {1, 0}) {
            const auto& in = wedges[idx(x)].in[side];
            if (in[0] == in[1]) continue;
            for (const int f : solid_[idx(x)]->facetsOf(piece.spot[idx(x)])) {
                if (classOf_[idx(x)][idx(f)] != c) continue;
                origin = {x == 1, solid_[idx(x)]->facets()[idx(f)].face};
                facet = f;
            }
        }
        return origin;
    }

    SideGroup& groupOf(int c, int sign, const FaceOrigin& origin, bool whole) {
        // Facets of a face that is planar within tolerance only are put together again.
        const auto key =
            whole ? std::tuple(0, c, sign) : std::tuple(origin.fromTool ? 2 : 1, origin.face, sign);
        const auto [it, fresh] = groupAt_.emplace(key, static_cast<int>(out_.groups.size()));
        if (fresh) {
            SideGroup group;
            group.plane = classes_[idx(c)];
            group.sign = sign;
            group.exact = whole;
            out_.groups.push_back(std::move(group));
        }
        return out_.groups[idx(it->second)];
    }

    void evaluate(Piece& piece) {
        for (const int x : {0, 1}) {
            if (piece.known[idx(x)]) continue;
            const OwnPoint middle =
                midpoint(nodes_[idx(piece.a)].point, nodes_[idx(piece.b)].point);
            piece.spot[idx(x)] = solid_[idx(x)]->locate(middle.view());
        }
        int uses = 0;
        for (const int c : piece.classes) uses += evaluateIn(piece, c);
        out_.touchesInEdge |= uses > 2;
    }

    /// Number of faces of the result in this plane that the piece borders; one that it runs through
    /// counts twice.
    int evaluateIn(const Piece& piece, int c) {
        const std::array<Wedges, 2> wedges{wedgesOf(0, piece, c), wedgesOf(1, piece, c)};
        std::array<std::array<bool, 2>, 2> in{};
        for (const std::size_t side : {0U, 1U}) {
            for (const std::size_t below : {0U, 1U}) {
                in[side][below] = combined(wedges[0].in[side][below], wedges[1].in[side][below]);
            }
        }
        int uses = 0;
        for (const int sign : {1, -1}) {
            const std::size_t outer = sign > 0 ? 0 : 1;
            std::array<bool, 2> face{};
            for (const std::size_t side : {0U, 1U}) {
                face[side] = in[side][1 - outer] && !in[side][outer];
                uses += face[side] ? 1 : 0;
            }
            if (face[0] == face[1]) continue;
            const std::size_t side = face[0] ? 0 : 1;
            int facet = -1;
            const FaceOrigin origin = originOf(piece, c, side, wedges, facet);
            const bool whole = solid_[origin.fromTool ? 1 : 0]->facets()[idx(facet)].whole;
            int from = nodes_[idx(piece.a)].id;
            int to = nodes_[idx(piece.b)].id;
            if ((side == 0) != (sign > 0)) std::swap(from, to);
            groupOf(c, sign, origin, whole).sides.push_back({from, to, origin});
        }
        return uses;
    }

    /// Edges of near facets that are out of the other solid's reach themselves.
    void passThrough() {
        for (const int x : {0, 1}) {
            const Operand& s = *solid_[idx(x)];
            auto& replaced = x == 0 ? out_.targetReplaced : out_.toolReplaced;
            replaced.assign(s.solid().faces.size(), false);
            const bool kept = kind_ == BooleanKind::Add || (x == 0 && kind_ == BooleanKind::Cut);
            const int first = x == 0 ? 0 : out_.firstTool;
            for (std::size_t f = 0; f < s.facets().size(); ++f) {
                const Facet& facet = s.facets()[f];
                replaced[idx(facet.face)] = true;
                if (!kept) continue;
                const FaceOrigin origin{x == 1, facet.face};
                for (const std::vector<int>& loop : *facet.loops) {
                    for (std::size_t i = 0; i < loop.size(); ++i) {
                        const int a = loop[i];
                        const int b = loop[(i + 1) % loop.size()];
                        if (s.edgeBetween(a, b) >= 0) continue;
                        groupOf(classOf_[idx(x)][f], facet.sign, origin, facet.whole)
                            .sides.push_back({idOf(x, a, first), idOf(x, b, first), origin});
                    }
                }
            }
        }
    }

    /// A vertex of the tool that lies on one of the target goes by the target's name.
    int idOf(int x, int v, int first) const {
        const auto it = nodeOfVertex_[idx(x)].find(v);
        return it == nodeOfVertex_[idx(x)].end() ? first + v : nodes_[idx(it->second)].id;
    }

    void finish() {
        for (const Node& node : nodes_) {
            const bool inFacet =
                node.spot[0].kind == Spot::Kind::Facet || node.spot[1].kind == Spot::Kind::Facet;
            if (inFacet && node.spot[0].onSurface() && node.spot[1].onSurface()) {
                out_.contacts.push_back(node.id);
            }
            out_.touched.insert(node.id);
            if (solid_[0]->reach().contains(node.point.r) &&
                solid_[1]->reach().contains(node.point.r)) {
                out_.complete.insert(node.id);
            }
        }
        out_.fresh.assign(std::make_move_iterator(fresh_.begin()),
                          std::make_move_iterator(fresh_.end()));
    }

    std::array<const Operand*, 2> solid_;
    BooleanKind kind_;
    Overlay out_;
    std::vector<std::shared_ptr<const RPlane>> classes_;
    std::array<std::vector<int>, 2> classOf_;  ///< by facet
    std::vector<Node> nodes_;
    std::multimap<std::array<double, 3>, int> byPlace_;
    std::array<std::unordered_map<int, int>, 2> nodeOfVertex_;
    std::deque<OwnPoint> fresh_;
    std::array<std::unordered_map<int, std::vector<int>>, 2> onEdge_;
    std::array<std::map<int, std::vector<int>>, 2> onFacet_;
    std::vector<Piece> pieces_;
    std::map<std::pair<int, int>, int> pieceAt_;
    std::map<std::tuple<int, int, int>, int> groupAt_;
};

}  // namespace

Overlay overlay(const Operand& target, const Operand& tool, BooleanKind kind) {
    return Overlayer(target, tool, kind).run();
}

}  // namespace ew
