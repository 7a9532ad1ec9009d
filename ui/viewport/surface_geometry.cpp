// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/surface_geometry.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <unordered_set>

namespace ew {

namespace {

constexpr int kMaxDashesPerEdge = 2000;
constexpr int kDiscCorners = 10;        // of the round ends of a stroke
constexpr double kLeastWidth = 0.3;     // share of the width that the lightest touch has
constexpr double kSameNormal = 0.9995;  // cosine: a fold of less than two degrees is no line
constexpr double kSameSide = 0.85;  // cosine up to which two pieces of a ribbon share their sides

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::uint64_t key(int a, int b) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32U) |
           static_cast<std::uint32_t>(b);
}

Vec3 worldPoint(const Body& body, const std::vector<Vec3>& points, int i) {
    return body.pose.toWorld(points[at(i)]);
}

/// Calls visit(from, to, face on the left, face on the right) once an edge of a mesh.
template <class Visit>
void eachEdge(const PolyMesh& mesh, const Visit& visit) {
    std::unordered_map<std::uint64_t, int> left;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        for (int l = 0; l < mesh.loopCount(f); ++l) {
            const auto loop = mesh.loop(f, l);
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const int a = loop[k];
                const int b = loop[(k + 1) % loop.size()];
                const auto twin = left.find(key(b, a));
                if (twin == left.end()) {
                    left.emplace(key(a, b), f);
                } else {
                    visit(b, a, twin->second, f);
                    left.erase(twin);
                }
            }
        }
    }
}

void addSolidLines(const Body& body, LinePieces& out) {
    for (const SolidEdge& edge : body.solid.edges()) {
        out.push_back({worldPoint(body, body.solid.vertices(), edge.ends[0]),
                       worldPoint(body, body.solid.vertices(), edge.ends[1])});
    }
}

/// More than one flat piece across a strip.
bool isRound(const FilletedCage& cage) {
    std::unordered_map<int, int> pieces;
    for (const CageOrigin& origin : cage.origins) {
        if (origin.kind == CageOrigin::Kind::Strip && ++pieces[origin.index] > 1) return true;
    }
    return false;
}

void addCageLines(const Body& body, const FilletedCage& cage, ShapeLines& out) {
    const bool round = isRound(cage);
    // A sharp edge goes on along the end of a strip: round the rim of a bezel, say.
    std::unordered_set<std::uint64_t> sharpEnds;
    for (const CageSharpEdge& e : cage.sharpEnds) {
        sharpEnds.insert(key(std::min(e.from, e.to), std::max(e.from, e.to)));
    }
    eachEdge(cage.mesh, [&](int a, int b, int left, int right) {
        const CageOrigin& l = cage.origins[at(left)];
        const CageOrigin& r = cage.origins[at(right)];
        if (l == r) return;
        const bool sharp = (l.kind == CageOrigin::Kind::Face && r.kind == CageOrigin::Kind::Face) ||
                           sharpEnds.contains(key(std::min(a, b), std::max(a, b)));
        // Two patches that meet are both round.
        const bool flat =
            l.kind == CageOrigin::Kind::Face || r.kind == CageOrigin::Kind::Face || !round;
        if (!flat && !sharp) return;
        (sharp || !round ? out.crisp : out.soft)
            .push_back(
                {worldPoint(body, cage.mesh.points, a), worldPoint(body, cage.mesh.points, b)});
    });
}

/// Edges of the triangles where both sides have their own normals.
void addCreases(const Body& body, const SurfaceMesh& surface, LinePieces& out) {
    if (surface.normalTriangles.empty()) return;
    // Most points have one normal, and no crease runs through these.
    std::vector<int> normalOf(surface.positions.size(), -1);
    std::vector<bool> several(surface.positions.size(), false);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto p = at(surface.triangles[t][k]);
            const int n = surface.normalTriangles[t][k];
            if (normalOf[p] >= 0 && normalOf[p] != n) several[p] = true;
            normalOf[p] = n;
        }
    }
    std::unordered_map<std::uint64_t, std::array<int, 2>> seen;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const int a = surface.triangles[t][k];
            const int b = surface.triangles[t][next];
            if (!several[at(a)] || !several[at(b)]) continue;
            const int na = surface.normalTriangles[t][k];
            const int nb = surface.normalTriangles[t][next];
            const auto twin = seen.find(key(b, a));
            if (twin == seen.end()) {
                seen.emplace(key(a, b), std::array<int, 2>{na, nb});
                continue;
            }
            // Faces of one smooth part have normals of their own at a crease's end, but the same.
            const auto differ = [&](int m, int n) {
                return static_cast<double>(surface.normals[at(m)].dot(surface.normals[at(n)])) <
                       kSameNormal;
            };
            if (differ(twin->second[0], nb) && differ(twin->second[1], na)) {
                out.push_back({worldPoint(body, surface.positions, a),
                               worldPoint(body, surface.positions, b)});
            }
            seen.erase(twin);
        }
    }
}

/// Points, cells and one array of the triangles that are gathered.
struct TriangleSet {
    vtkSmartPointer<vtkPoints> points = vtkSmartPointer<vtkPoints>::New();
    vtkSmartPointer<vtkCellArray> cells = vtkSmartPointer<vtkCellArray>::New();
    vtkSmartPointer<vtkFloatArray> normals = vtkSmartPointer<vtkFloatArray>::New();

    TriangleSet() { normals->SetNumberOfComponents(3); }
    vtkIdType add(const Vec3& p, const Vec3& n) {
        normals->InsertNextTuple3(n.x(), n.y(), n.z());
        return points->InsertNextPoint(p.x(), p.y(), p.z());
    }
    vtkSmartPointer<vtkPolyData> take() const {
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points);
        data->SetPolys(cells);
        data->GetPointData()->SetNormals(normals);
        return data;
    }
};

}  // namespace

// Lines ------------------------------------------------------------------------------------------

ShapeLines shapeLines(const std::vector<Body>& bodies, const DerivedShape& shape) {
    ShapeLines out;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].hidden) continue;
        const BodyShape& body = shape.bodies[b];
        if (body.surface)
            addCreases(bodies[b], *body.surface, out.crisp);
        else if (body.cage)
            addCageLines(bodies[b], *body.cage, out);
        else
            addSolidLines(bodies[b], out.crisp);
    }
    return out;
}

LinePieces cageLines(const std::vector<Body>& bodies, const DerivedShape& shape) {
    LinePieces out;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].hidden) continue;
        if (!shape.bodies[b].cage) {
            addSolidLines(bodies[b], out);
            continue;
        }
        const PolyMesh& mesh = shape.bodies[b].cage->mesh;
        eachEdge(mesh, [&](int from, int to, int, int) {
            out.push_back(
                {worldPoint(bodies[b], mesh.points, from), worldPoint(bodies[b], mesh.points, to)});
        });
    }
    return out;
}

vtkSmartPointer<vtkPolyData> linesGeometry(const LinePieces& lines, const Vec3& origin) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const auto& line : lines) {
        std::array<vtkIdType, 2> ids{};
        for (std::size_t k = 0; k < 2; ++k) {
            const Vec3 p = line[k] - origin;
            ids[k] = points->InsertNextPoint(p.x(), p.y(), p.z());
        }
        cells->InsertNextCell(2, ids.data());
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(cells);
    return data;
}

vtkSmartPointer<vtkPolyData> dashedGeometry(const LinePieces& lines, const Vec3& origin,
                                            double dashMm) {
    constexpr double kPeriod = 5.0 / 3.0;  // in dashes
    LinePieces dashes;
    for (const auto& [a, b] : lines) {
        const double length = (b - a).norm();
        // Whole dashes with one at either end, so that corners stay marked.
        const int gaps = std::clamp(
            static_cast<int>(std::lround((length / dashMm - 1.0) / kPeriod)), 0, kMaxDashesPerEdge);
        const double unit = 1.0 / (gaps * kPeriod + 1.0);
        for (int i = 0; i <= gaps; ++i) {
            const double start = i * unit * kPeriod;
            dashes.push_back({a + start * (b - a), a + std::min(1.0, start + unit) * (b - a)});
        }
    }
    return linesGeometry(dashes, origin);
}

// Faces ------------------------------------------------------------------------------------------

vtkSmartPointer<vtkPolyData> flatGeometry(const std::vector<Body>& bodies,
                                          const DerivedShape& shape, const Vec3& origin) {
    TriangleSet set;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (shape.bodies[b].surface || bodies[b].hidden) continue;
        const ShapeMesh mesh = shapeMesh(bodies[b], shape.bodies[b]);
        // All triangles of a face have its normal, however thin one of them is.
        std::vector<Vec3> normals;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto& c = mesh.triangles[t];
            const Vec3& a = mesh.positions[at(c[0])];
            if (normals.size() <= at(mesh.faces[t])) {
                normals.resize(at(mesh.faces[t]) + 1, Vec3::Zero());
            }
            normals[at(mesh.faces[t])] +=
                (mesh.positions[at(c[1])] - a).cross(mesh.positions[at(c[2])] - a);
        }
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const Vec3 n = normals[at(mesh.faces[t])].normalized();
            std::array<vtkIdType, 3> ids{};
            for (std::size_t k = 0; k < 3; ++k) {
                ids[k] = set.add(mesh.positions[at(mesh.triangles[t][k])] - origin, n);
            }
            set.cells->InsertNextCell(3, ids.data());
        }
    }
    return set.take();
}

namespace {

/// Three numbers for each of `count` points, to be written in place.
vtkSmartPointer<vtkFloatArray> triples(std::size_t count) {
    auto out = vtkSmartPointer<vtkFloatArray>::New();
    out->SetNumberOfComponents(3);
    out->SetNumberOfTuples(static_cast<vtkIdType>(count));
    return out;
}

void write(float* to, std::size_t index, const Vec3& p) {
    for (int k = 0; k < 3; ++k) to[3 * index + at(k)] = static_cast<float>(p[k]);
}

}  // namespace

vtkSmartPointer<vtkPolyData> smoothGeometry(const std::vector<Body>& bodies,
                                            const DerivedShape& shape, const Vec3& origin) {
    std::size_t points = 0;
    std::size_t triangles = 0;
    const auto isSmooth = [&](std::size_t b) {
        return shape.bodies[b].surface && !bodies[b].hidden;
    };
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (!isSmooth(b)) continue;
        points += shape.bodies[b].surface->normals.size();
        triangles += shape.bodies[b].surface->triangles.size();
    }
    const auto positions = triples(points);
    const auto normals = triples(points);
    vtkNew<vtkTypeInt32Array> corners;
    corners->SetNumberOfValues(static_cast<vtkIdType>(3 * triangles));
    std::size_t base = 0;
    std::size_t corner = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (!isSmooth(b)) continue;
        const SurfaceMesh& mesh = *shape.bodies[b].surface;
        const Pose& pose = bodies[b].pose;
        const bool own = mesh.normalTriangles.empty();
        // A normal belongs to one point, a point may have several.
        const auto& ids = own ? mesh.triangles : mesh.normalTriangles;
        for (std::size_t t = 0; t < ids.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto id = base + at(ids[t][k]);
                corners->SetValue(static_cast<vtkIdType>(corner++), static_cast<int>(id));
                if (own) continue;
                const Vec3& p = mesh.positions[at(mesh.triangles[t][k])];
                write(positions->GetPointer(0), id, pose.toWorld(p) - origin);
            }
        }
        for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
            const Vec3 n = pose.directionToWorld(mesh.normals[i].cast<double>());
            write(normals->GetPointer(0), base + i, n);
            if (own)
                write(positions->GetPointer(0), base + i, pose.toWorld(mesh.positions[i]) - origin);
        }
        base += mesh.normals.size();
    }
    vtkNew<vtkPoints> place;
    place->SetData(positions);
    vtkNew<vtkCellArray> cells;
    cells->SetData(3, corners);
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(place);
    data->SetPolys(cells);
    data->GetPointData()->SetNormals(normals);
    return data;
}

// Ribbons ----------------------------------------------------------------------------------------

namespace {

class Ribbons {
  public:
    Ribbons(const Vec3& origin, const ThemeColours& theme) : origin_(origin), theme_(theme) {
        colours_->SetNumberOfComponents(3);
    }

    void add(const MappedCurve& curve, const MappedStroke& stroke) {
        const auto& [red, green, blue] = stroke.color;
        colour_ = onBody(QColor(red, green, blue), theme_);
        const double width = stroke.widthMm();
        const auto half = [&](const MappedPoint& p) {
            return 0.5 * width * (kLeastWidth + (1.0 - kLeastWidth) * p.pressure);
        };
        const auto& points = curve.points;
        if (points.empty()) return;
        std::vector<Piece> pieces;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Vec3 along = points[i + 1].position - points[i].position;
            const double length = along.norm();
            if (length <= 0.0) continue;
            const Vec3 dir = along / length;
            // Both points name a triangle; the piece lies in the one that it is parallel to.
            const bool first =
                std::abs(points[i].normal.dot(dir)) <= std::abs(points[i + 1].normal.dot(dir));
            const Vec3& normal = points[first ? i : i + 1].normal;
            const Vec3 side = normal.cross(dir).normalized();
            pieces.push_back({i, normal, side, side, side});
        }
        disc(points.front().position, points.front().normal, half(points.front()));
        if (pieces.empty()) return;
        for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
            Piece& a = pieces[k];
            Piece& b = pieces[k + 1];
            if (a.own.dot(b.own) > kSameSide && a.normal.dot(b.normal) > kSameSide) {
                const Vec3 mean = (a.own + b.own).normalized();
                a.end = mean;
                b.start = mean;
            } else {
                const MappedPoint& corner = points[b.first];
                disc(corner.position, a.normal, half(corner));
                disc(corner.position, b.normal, half(corner));
            }
        }
        for (const Piece& piece : pieces) {
            const MappedPoint& p = points[piece.first];
            const MappedPoint& q = points[piece.first + 1];
            const std::array<vtkIdType, 4> ids{
                point(p.position - half(p) * piece.start), point(q.position - half(q) * piece.end),
                point(q.position + half(q) * piece.end), point(p.position + half(p) * piece.start)};
            cells_->InsertNextCell(4, ids.data());
        }
        disc(points.back().position, points.back().normal, half(points.back()));
    }

    vtkSmartPointer<vtkPolyData> take() const {
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points_);
        data->SetPolys(cells_);
        data->GetPointData()->SetScalars(colours_);
        return data;
    }

  private:
    struct Piece {
        std::size_t first;  // point that it starts at
        Vec3 normal, own, start, end;
    };

    vtkIdType point(const Vec3& world) {
        colours_->InsertNextTuple3(colour_.red(), colour_.green(), colour_.blue());
        const Vec3 p = world - origin_;
        return points_->InsertNextPoint(p.x(), p.y(), p.z());
    }

    void disc(const Vec3& centre, const Vec3& normal, double radius) {
        const Vec3 x = normal.unitOrthogonal();
        const Vec3 y = normal.cross(x);
        std::array<vtkIdType, kDiscCorners> ids{};
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / kDiscCorners;
            ids[i] = point(centre + radius * (std::cos(turn) * x + std::sin(turn) * y));
        }
        cells_->InsertNextCell(kDiscCorners, ids.data());
    }

    Vec3 origin_;
    const ThemeColours& theme_;
    QColor colour_;
    vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
    vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
    vtkSmartPointer<vtkUnsignedCharArray> colours_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
};

}  // namespace

vtkSmartPointer<vtkPolyData> ribbonGeometry(const DerivedShape& shape,
                                            const std::vector<MappedStroke>& mapped,
                                            const Vec3& origin, const ThemeColours& colours) {
    Ribbons ribbons(origin, colours);
    for (const MappedCurve& curve : shape.curves) {
        if (at(curve.stroke) < mapped.size()) ribbons.add(curve, mapped[at(curve.stroke)]);
    }
    return ribbons.take();
}

}  // namespace ew
