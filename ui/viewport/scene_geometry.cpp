// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/scene_geometry.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ew {

namespace {

constexpr double kMinCellPx = 22.0;
constexpr int kMaxDashesPerEdge = 2000;

/// Two-point lines, gathered.
class LineSet {
  public:
    void add(const Vec3& a, const Vec3& b) {
        const std::array<vtkIdType, 2> ids{point(a), point(b)};
        lines_->InsertNextCell(2, ids.data());
    }
    vtkIdType point(const Vec3& p) { return points_->InsertNextPoint(p.x(), p.y(), p.z()); }

    vtkSmartPointer<vtkPolyData> take() {
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points_);
        data->SetLines(lines_);
        return data;
    }

  private:
    vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
    vtkSmartPointer<vtkCellArray> lines_ = vtkSmartPointer<vtkCellArray>::New();
};

template <class Visit>
void eachEdge(const std::vector<Body>& bodies, const Vec3& origin, Visit visit) {
    for (const Body& body : bodies) {
        const auto& vertices = body.solid.vertices();
        for (const SolidEdge& edge : body.solid.edges()) {
            visit(
                Vec3(body.pose.toWorld(vertices[static_cast<std::size_t>(edge.ends[0])]) - origin),
                Vec3(body.pose.toWorld(vertices[static_cast<std::size_t>(edge.ends[1])]) - origin));
        }
    }
}

}  // namespace

vtkSmartPointer<vtkPolyData> facesGeometry(const std::vector<Body>& bodies, const Vec3& origin) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    auto normals = vtkSmartPointer<vtkFloatArray>::New();
    normals->SetNumberOfComponents(3);
    for (const Body& body : bodies) {
        const auto& vertices = body.solid.vertices();
        const auto& faces = body.solid.faces();
        for (const SolidTriangle& triangle : body.solid.triangles()) {
            const Vec3 n =
                body.pose.directionToWorld(faces[static_cast<std::size_t>(triangle.face)].normal);
            std::array<vtkIdType, 3> ids{};
            for (std::size_t i = 0; i < 3; ++i) {
                const auto v = static_cast<std::size_t>(triangle.vertices[i]);
                const Vec3 p = body.pose.toWorld(vertices[v]) - origin;
                ids[i] = points->InsertNextPoint(p.x(), p.y(), p.z());
                normals->InsertNextTuple3(n.x(), n.y(), n.z());
            }
            cells->InsertNextCell(3, ids.data());
        }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->SetNormals(normals);
    return data;
}

vtkSmartPointer<vtkPolyData> edgesGeometry(const std::vector<Body>& bodies, const Vec3& origin) {
    LineSet lines;
    eachEdge(bodies, origin, [&](const Vec3& a, const Vec3& b) { lines.add(a, b); });
    return lines.take();
}

vtkSmartPointer<vtkPolyData> dashedGeometry(const std::vector<Body>& bodies, const Vec3& origin,
                                            double dashMm) {
    LineSet lines;
    eachEdge(bodies, origin, [&](const Vec3& a, const Vec3& b) {
        const double length = (b - a).norm();
        const double period = dashMm * (5.0 / 3.0);
        // Whole dashes with one at either end, so that corners stay marked.
        const int gaps = std::clamp(static_cast<int>(std::lround((length - dashMm) / period)), 0,
                                    kMaxDashesPerEdge);
        const double unit = length / (gaps * (5.0 / 3.0) + 1.0);
        for (int i = 0; i <= gaps; ++i) {
            const double start = i * unit * (5.0 / 3.0) / length;
            lines.add(a + start * (b - a), a + std::min(1.0, start + unit / length) * (b - a));
        }
    });
    return lines.take();
}

GridLayout gridLayout(const OrthographicCamera& camera, double height) {
    GridLayout layout;
    const double wanted = kMinCellPx * camera.worldPerPixel;
    const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
    layout.spacing = decade * 10.0;
    for (const double step : {1.0, 2.0, 5.0}) {
        if (decade * step >= wanted) {
            layout.spacing = decade * step;
            break;
        }
    }
    layout.height = height;
    // Where the line of sight through the middle meets the ground; straight below where it is
    // nearly level.
    Vec3 at = camera.center;
    if (std::abs(camera.direction.z()) > 0.2) {
        at += camera.direction * ((height - camera.center.z()) / camera.direction.z());
    }
    layout.centre = {std::round(at.x() / layout.spacing) * layout.spacing,
                     std::round(at.y() / layout.spacing) * layout.spacing};
    return layout;
}

vtkSmartPointer<vtkPolyData> gridGeometry(const GridLayout& layout, const Vec3& origin,
                                          const ThemeColours& colours) {
    constexpr int kPieces = 16;  // per line, so that the fade is smooth
    const double reach = kGridCells * layout.spacing;
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    auto shades = vtkSmartPointer<vtkUnsignedCharArray>::New();
    shades->SetNumberOfComponents(3);
    const auto addPoint = [&](double x, double y, bool axis) {
        const double away = std::min(1.0, std::hypot(x, y) / reach);
        const QColor c =
            mixColours(axis ? colours.axis : colours.grid, colours.background, away * away);
        shades->InsertNextTuple3(c.red(), c.green(), c.blue());
        return points->InsertNextPoint(layout.centre.x() + x - origin.x(),
                                       layout.centre.y() + y - origin.y(),
                                       layout.height - origin.z());
    };
    for (int along = 0; along < 2; ++along) {
        for (int i = -kGridCells; i <= kGridCells; ++i) {
            const double offset = i * layout.spacing;
            const double world = (along == 0 ? layout.centre.y() : layout.centre.x()) + offset;
            const bool axis = std::abs(world) < layout.spacing / 2;
            std::array<vtkIdType, kPieces + 1> ids{};
            for (int k = 0; k <= kPieces; ++k) {
                const double t = reach * (2.0 * k / kPieces - 1.0);
                ids[static_cast<std::size_t>(k)] =
                    along == 0 ? addPoint(t, offset, axis) : addPoint(offset, t, axis);
            }
            cells->InsertNextCell(kPieces + 1, ids.data());
        }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(cells);
    data->GetPointData()->SetScalars(shades);
    return data;
}

}  // namespace ew
