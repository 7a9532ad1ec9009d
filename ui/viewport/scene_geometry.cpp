// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/scene_geometry.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ew {

namespace {

constexpr double kMinCellPx = 22.0;

}  // namespace

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
