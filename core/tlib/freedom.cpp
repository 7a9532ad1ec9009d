// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/freedom.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace ew {

namespace {

// What is left of a row of unit length once the others are taken out of it.
constexpr double kDependent = 1e-6;
// Place, attitude and size: nothing of them is a freedom of the shape.
constexpr int kAlwaysOpen = 7;

using Row = Eigen::VectorXd;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Rows that say something new, orthonormal.
class RowSpace {
  public:
    explicit RowSpace(const PolyhedronSpec& shape) : shape_(shape) {}

    Row zero() const { return Row::Zero(static_cast<Eigen::Index>(3 * shape_.vertices.size())); }
    static void put(Row& row, int vertex, const Vec3& gradient) {
        row.segment<3>(3 * vertex) += gradient;
    }
    Vec3 along(const TemplateEdge& e) const {
        return shape_.vertices[at(e[1])] - shape_.vertices[at(e[0])];
    }
    static void putEdge(Row& row, const TemplateEdge& e, const Vec3& gradient) {
        put(row, e[1], gradient);
        put(row, e[0], -gradient);
    }

    /// False where the rows so far say it already.
    bool add(Row row) {
        const double length = row.norm();
        if (!(length > 0.0)) return false;
        row /= length;
        for (int pass = 0; pass < 2; ++pass) {  // once leaves rounding errors behind
            for (const Row& known : rows_) row -= known.dot(row) * known;
        }
        const double left = row.norm();
        if (left < kDependent) return false;
        rows_.push_back(row / left);
        return true;
    }
    int rank() const { return static_cast<int>(rows_.size()); }

  private:
    const PolyhedronSpec& shape_;
    std::vector<Row> rows_;
};

/// Every corner of a face lies in the plane of three of them that are well apart.
void addFace(const PolyhedronSpec& shape, const std::vector<int>& loop, RowSpace& space) {
    if (loop.size() < 4) return;
    const auto point = [&](std::size_t k) -> const Vec3& { return shape.vertices[at(loop[k])]; };
    std::size_t a = 1;
    std::size_t b = 2;
    double largest = -1.0;
    for (std::size_t i = 1; i < loop.size(); ++i) {
        for (std::size_t k = i + 1; k < loop.size(); ++k) {
            const double area = (point(i) - point(0)).cross(point(k) - point(0)).norm();
            if (area <= largest) continue;
            largest = area;
            a = i;
            b = k;
        }
    }
    const Vec3 pa = point(a) - point(0);
    const Vec3 pb = point(b) - point(0);
    for (std::size_t i = 1; i < loop.size(); ++i) {
        if (i == a || i == b) continue;
        const Vec3 pi = point(i) - point(0);
        Row row = space.zero();
        const std::array<Vec3, 3> gradients{pb.cross(pi), pi.cross(pa), pa.cross(pb)};
        RowSpace::put(row, loop[a], gradients[0]);
        RowSpace::put(row, loop[b], gradients[1]);
        RowSpace::put(row, loop[i], gradients[2]);
        RowSpace::put(row, loop[0], -(gradients[0] + gradients[1] + gradients[2]));
        space.add(std::move(row));
    }
}

/// True where it says something new.
bool addParallel(RowSpace& space, const TemplateEdge& first, const TemplateEdge& other) {
    const Vec3 a = space.along(first);
    const Vec3 b = space.along(other);
    const Vec3 u = a.unitOrthogonal();
    bool news = false;
    for (const Vec3& w : {u, Vec3(a.normalized().cross(u))}) {
        Row row = space.zero();
        RowSpace::putEdge(row, other, a.cross(w));
        RowSpace::putEdge(row, first, w.cross(b));
        news = space.add(std::move(row)) || news;
    }
    return news;
}

bool addRows(RowSpace& space, const FoundRelation& relation) {
    bool news = false;
    const TemplateEdge& first = relation.edges.front();
    const Vec3 a = space.along(first);
    for (std::size_t i = 1; i < relation.edges.size(); ++i) {
        const TemplateEdge& other = relation.edges[i];
        if (relation.kind == RelationKind::Parallel) {
            news = addParallel(space, first, other) || news;
            continue;
        }
        const Vec3 b = space.along(other);
        const bool equal = relation.kind == RelationKind::EqualLength;
        Row row = space.zero();
        RowSpace::putEdge(row, first, equal ? Vec3(-a) : b);
        RowSpace::putEdge(row, other, equal ? b : a);
        news = space.add(std::move(row)) || news;
    }
    return news;
}

}  // namespace

TemplateFreedom countFreedom(const PolyhedronSpec& shape,
                             const std::vector<FoundRelation>& relations) {
    TemplateFreedom out;
    RowSpace space(shape);
    for (const std::vector<int>& loop : shape.faces) addFace(shape, loop, space);
    for (const FoundRelation& relation : relations)
        out.follows.push_back(!addRows(space, relation));
    out.open =
        std::max(0, static_cast<int>(3 * shape.vertices.size()) - space.rank() - kAlwaysOpen);
    return out;
}

}  // namespace ew
