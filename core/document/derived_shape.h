// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/camera.h"
#include "core/document/surface_settings.h"
#include "core/stroke/stroke.h"
#include "core/surface/mapped_strokes.h"

namespace ew {

/// A stroke that was drawn onto the surface. Its curves are derived from the pen's samples.
struct MappedStroke {
    int id = -1;                ///< unique in the document's life, as of pending strokes
    Stroke stroke;              ///< Sketch Plane px of `camera`
    OrthographicCamera camera;  ///< what it was drawn through
    StrokeColor color = kDefaultStrokeColor;

    /// Width of its line where the pen pressed fully [mm].
    double widthMm() const;
};

/// What step 5 is made from; a copy shares the solids.
struct ShapeInput {
    std::vector<Body> bodies;
    SurfaceSettings settings;
    std::vector<MappedStroke> mapped;
    std::size_t memoryLimit = std::size_t{1} << 30U;  ///< of all surfaces together [bytes]
};

/// What became of one body.
struct BodyShape {
    std::shared_ptr<const FilletedCage> cage;    ///< nullptr where no edge is filleted
    std::shared_ptr<const SurfaceMesh> surface;  ///< nullptr where subdivision is off
};

/// An edge whose radius did not fit.
struct ClampedEdge {
    EdgeRef edge;
    double requested = 0.0;   ///< radius [mm]
    double used = 0.0;        ///< radius [mm], 0 where the edge had to stay sharp
    int limitingEdge = -1;    ///< of the same body, -1 where it is no edge
    int limitingVertex = -1;  ///< of the same body, -1 where it is none
};

/// Cage, surface and mapped strokes: derived from the document, never stored.
struct DerivedShape {
    std::vector<BodyShape> bodies;
    std::vector<ClampedEdge> clamped;  ///< in the order of bodies and edges
    std::vector<MappedCurve> curves;   ///< world [mm]; `stroke` is an index into `mapped`
    std::vector<int> missed;           ///< mapped strokes with no surface under any part of them
    std::optional<Error> problem;      ///< why cage or surface could not be made; those that are
                                       ///< missing then are nullptr

    bool hasCage() const;
    bool hasSurface() const;
};

/// Keeps what was derived before, so that a change makes only what it touches. Thread-safe; one
/// cache serves a document and a worker that makes previews.
class ShapeCache {
  public:
    ShapeCache();
    ~ShapeCache();
    ShapeCache(const ShapeCache&) = delete;
    ShapeCache& operator=(const ShapeCache&) = delete;

    struct Impl;
    Impl& impl() { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

/// Derives everything. What cannot be made is named in `problem` (the errors of fillet(),
/// controlCage() and subdivide(); TooMuchMemory where all surfaces together exceed the limit), the
/// rest stands. The same input gives the same shape.
/// \paper{3.2}
DerivedShape deriveShape(const ShapeInput& input, ShapeCache& cache);

/// The outermost shape of one body: its surface, else its cage, else the solid itself.
struct ShapeMesh {
    std::vector<Vec3> positions;                      ///< world [mm]
    std::vector<std::array<int, 3>> triangles;        ///< counter-clockwise from outside
    std::vector<Vec3> normals;                        ///< unit, world; empty: flat faces
    std::vector<std::array<int, 3>> normalTriangles;  ///< as in SurfaceMesh
    std::vector<int> faces;  ///< by triangle: planar face it is part of; empty for a surface
};

ShapeMesh shapeMesh(const Body& body, const BodyShape& shape);

/// Planar polygons of the outermost shape of one body where it has no surface: faces of the cage or
/// of the solid without holes, by index into shapeMesh().positions.
std::vector<std::vector<int>> shapePolygons(const Body& body, const BodyShape& shape);

/// How far the limit surface is from the triangles at most, judged by the exact normals at their
/// corners [mm].
double estimatedDeviation(const SurfaceMesh& surface);

/// "Edge 3 (12.5 mm): radius 4 mm instead of 9 mm, because of edge 7": for a person.
std::string clampText(const std::vector<Body>& bodies, const ClampedEdge& clamp);

}  // namespace ew
