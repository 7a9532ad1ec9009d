// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/derived_shape.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <mutex>
#include <numeric>
#include <string>

#include "core/document/json_text.h"
#include "core/document/polygons.h"

namespace ew {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double kStrokeWidthPx = 3.0;    // of a mapped stroke under full pressure
constexpr std::size_t kCagesKept = 24;    // small beside surfaces
constexpr std::size_t kCanvasesKept = 2;  // each as large as the surface
constexpr std::size_t kSurfacesKept = 12;

std::size_t bytesOf(const SurfaceMesh& s) {
    return surfaceBytes(s.positions.size(), s.triangles.size(), !s.normalTriangles.empty());
}

}  // namespace

// The cache --------------------------------------------------------------------------------------

struct ShapeCache::Impl {
    struct Cage {
        Solid solid;  // keeps the address that is compared alive
        std::vector<double> radii;
        int segments = 1;
        std::shared_ptr<const FilletedCage> cage;
    };
    struct Surface {
        Solid solid;
        std::shared_ptr<const FilletedCage> cage;
        std::vector<double> sharpness;
        SubdivisionSettings settings;
        std::shared_ptr<const SurfaceMesh> surface;
    };
    struct Canvas {
        std::vector<Solid> solids;
        std::vector<Pose> poses;
        std::vector<bool> hidden;
        std::vector<BodyShape> shapes;
        OrthographicCamera camera;
        StrokeCanvas canvas;
    };

    std::mutex mutex;
    std::list<Cage> cages;  // the newest first, in each
    std::list<Surface> surfaces;
    std::list<Canvas> canvases;

    template <class Entry, class Same>
    std::optional<Entry> find(std::list<Entry>& entries, const Same& same) {
        const std::lock_guard lock(mutex);
        const auto it = std::find_if(entries.begin(), entries.end(), same);
        if (it == entries.end()) return std::nullopt;
        entries.splice(entries.begin(), entries, it);
        return entries.front();
    }
    template <class Entry>
    void keep(std::list<Entry>& entries, Entry entry, std::size_t most) {
        const std::lock_guard lock(mutex);
        entries.push_front(std::move(entry));
        while (entries.size() > most) entries.pop_back();
    }
    /// Surfaces are large: no more are kept than what a document may show at a time.
    void limitSurfaces(std::size_t bytes) {
        const std::lock_guard lock(mutex);
        std::size_t sum = 0;
        auto it = surfaces.begin();
        while (it != surfaces.end() && (sum += bytesOf(*it->surface)) <= bytes) ++it;
        surfaces.erase(it, surfaces.end());
    }
};

ShapeCache::ShapeCache() : impl_(std::make_unique<Impl>()) {}
ShapeCache::~ShapeCache() = default;

namespace {

Result<std::shared_ptr<const FilletedCage>> makeCage(const Solid& solid,
                                                     const std::vector<double>& radii, int segments,
                                                     ShapeCache::Impl& cache) {
    using Entry = ShapeCache::Impl::Cage;
    const auto known = cache.find(cache.cages, [&](const Entry& e) {
        return e.solid.sharesDataWith(solid) && e.segments == segments && e.radii == radii;
    });
    if (known) return known->cage;
    FilletOptions options;
    options.segments = segments;
    for (std::size_t e = 0; e < radii.size(); ++e) {
        const int edge = static_cast<int>(e);
        if (radii[e] > 0.0)
            options.edges.push_back({edge, setbackForRadius(solid, edge, radii[e])});
    }
    auto made = fillet(solid, options);
    if (!made) return fail(made.error());
    auto cage = std::make_shared<const FilletedCage>(*std::move(made));
    cache.keep(cache.cages, Entry{solid, radii, segments, cage}, kCagesKept);
    return cage;
}

/// One sharpness an edge of the solid, as controlCage() wants them.
std::vector<double> sharpnessOf(const ShapeInput& input, std::size_t body) {
    const SurfaceSettings& s = input.settings;
    const double otherwise =
        s.subdivision.sharpness.value_or(s.hasFillet() ? kInfiniteSharpness : 0.0);
    std::vector<double> out(input.bodies[body].solid.edges().size(), otherwise);
    if (body >= s.edges.size()) return out;
    const std::vector<double>& own = s.edges[body].sharpness;
    for (std::size_t e = 0; e < own.size(); ++e) {
        if (own[e] != kAutomaticSharpness) out[e] = own[e];
    }
    return out;
}

Result<std::shared_ptr<const SurfaceMesh>> makeSurface(const ShapeInput& input, std::size_t body,
                                                       const BodyShape& shape, std::size_t limit,
                                                       ShapeCache::Impl& cache) {
    using Entry = ShapeCache::Impl::Surface;
    const Solid& solid = input.bodies[body].solid;
    const SubdivisionSettings& settings = input.settings.subdivision;
    ControlOptions control;
    control.scheme = settings.scheme;
    control.edgeSharpness = sharpnessOf(input, body);
    control.sharpCorners = settings.sharpCorners;
    const auto tooMuch = [] {
        return fail(Errc::TooMuchMemory,
                    "The surface would need more memory than is allowed; choose fewer levels or a "
                    "larger tolerance.");
    };
    const auto known = cache.find(cache.surfaces, [&](const Entry& e) {
        return e.solid.sharesDataWith(solid) && e.cage == shape.cage && e.settings == settings &&
               e.sharpness == control.edgeSharpness;
    });
    if (known) {
        if (bytesOf(*known->surface) > limit) return tooMuch();
        return known->surface;
    }
    if (limit == 0) return tooMuch();
    const auto cage =
        shape.cage ? controlCage(*shape.cage, control) : controlCage(sharpCage(solid), control);
    if (!cage) return fail(cage.error());
    SubdivisionOptions options;
    options.scheme = settings.scheme;
    options.levels = settings.levels;
    options.tolerance = settings.tolerance;
    options.memoryLimit = limit;
    auto made = subdivide(*cage, options);
    if (!made) return fail(made.error());
    auto surface = std::make_shared<const SurfaceMesh>(*std::move(made));
    cache.keep(cache.surfaces, Entry{solid, shape.cage, control.edgeSharpness, settings, surface},
               kSurfacesKept);
    return surface;
}

void noteClamped(const ShapeInput& input, std::size_t body, DerivedShape& out) {
    const Solid& solid = input.bodies[body].solid;
    for (const FilletClamp& c : out.bodies[body].cage->clamped) {
        const EdgeRef edge{static_cast<int>(body), c.edge};
        const double used = c.used > 0.0 ? radiusForSetback(solid, c.edge, c.used) : 0.0;
        out.clamped.push_back(
            {edge, input.settings.radius(edge), used, c.limitingEdge, c.limitingVertex});
    }
}

bool samePose(const Pose& a, const Pose& b) {
    return a.rotation == b.rotation && a.translation == b.translation;
}

Result<StrokeCanvas> canvasFor(const ShapeInput& input, const std::vector<BodyShape>& shapes,
                               const OrthographicCamera& camera, ShapeCache::Impl& cache) {
    using Entry = ShapeCache::Impl::Canvas;
    const auto known = cache.find(cache.canvases, [&](const Entry& e) {
        bool same = e.camera == camera && e.shapes.size() == shapes.size();
        for (std::size_t b = 0; same && b < shapes.size(); ++b) {
            same = e.solids[b].sharesDataWith(input.bodies[b].solid) &&
                   samePose(e.poses[b], input.bodies[b].pose) &&
                   e.hidden[b] == input.bodies[b].hidden && e.shapes[b].cage == shapes[b].cage &&
                   e.shapes[b].surface == shapes[b].surface;
        }
        return same;
    });
    if (known) return known->canvas;
    std::vector<Vec3> positions;
    std::vector<std::array<int, 3>> triangles;
    std::vector<Solid> solids;
    std::vector<Pose> poses;
    std::vector<bool> hidden;
    for (std::size_t b = 0; b < shapes.size(); ++b) {
        solids.push_back(input.bodies[b].solid);
        poses.push_back(input.bodies[b].pose);
        hidden.push_back(input.bodies[b].hidden);
        if (hidden.back()) continue;  // strokes lie on what is seen
        const ShapeMesh mesh = shapeMesh(input.bodies[b], shapes[b]);
        const int base = static_cast<int>(positions.size());
        positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (const auto& t : mesh.triangles) {
            triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
        }
    }
    auto canvas = StrokeCanvas::create(positions, triangles, camera);
    if (!canvas) return fail(canvas.error());
    cache.keep(
        cache.canvases,
        Entry{std::move(solids), std::move(poses), std::move(hidden), shapes, camera, *canvas},
        kCanvasesKept);
    return canvas;
}

void mapStrokes(const ShapeInput& input, DerivedShape& out, ShapeCache::Impl& cache) {
    std::vector<bool> done(input.mapped.size(), false);
    for (std::size_t first = 0; first < input.mapped.size(); ++first) {
        if (done[first]) continue;
        // All strokes that were drawn through one camera share its canvas.
        const OrthographicCamera& camera = input.mapped[first].camera;
        std::vector<Stroke> strokes;
        std::vector<int> indices;
        for (std::size_t i = first; i < input.mapped.size(); ++i) {
            if (!(input.mapped[i].camera == camera)) continue;
            done[i] = true;
            strokes.push_back(input.mapped[i].stroke);
            indices.push_back(static_cast<int>(i));
        }
        const auto canvas = canvasFor(input, out.bodies, camera, cache);
        const auto mapped =
            canvas ? canvas->map(strokes) : Result<MappedStrokes>(fail(canvas.error()));
        if (!mapped) {
            out.missed.insert(out.missed.end(), indices.begin(), indices.end());
            if (mapped.error().code != Errc::NoSurface && !out.problem)
                out.problem = mapped.error();
            continue;
        }
        for (MappedCurve curve : mapped->curves) {
            curve.stroke = indices[at(curve.stroke)];
            out.curves.push_back(std::move(curve));
        }
        for (const int i : mapped->missed) out.missed.push_back(indices[at(i)]);
    }
    std::sort(out.missed.begin(), out.missed.end());
    std::stable_sort(out.curves.begin(), out.curves.end(),
                     [](const auto& a, const auto& b) { return a.stroke < b.stroke; });
}

}  // namespace

double MappedStroke::widthMm() const { return kStrokeWidthPx * camera.worldPerPixel; }

bool DerivedShape::hasCage() const {
    return std::any_of(bodies.begin(), bodies.end(), [](const BodyShape& b) { return !!b.cage; });
}

bool DerivedShape::hasSurface() const {
    return std::any_of(bodies.begin(), bodies.end(),
                       [](const BodyShape& b) { return !!b.surface; });
}

DerivedShape deriveShape(const ShapeInput& input, ShapeCache& keeper) {
    ShapeCache::Impl& cache = keeper.impl();
    DerivedShape out;
    out.bodies.resize(input.bodies.size());
    const auto note = [&](const Error& error) {
        if (!out.problem) out.problem = error;
    };
    for (std::size_t b = 0; b < input.bodies.size() && b < input.settings.edges.size(); ++b) {
        const std::vector<double>& radii = input.settings.edges[b].radii;
        if (std::none_of(radii.begin(), radii.end(), [](double r) { return r > 0.0; })) continue;
        auto cage = makeCage(input.bodies[b].solid, radii, input.settings.segments, cache);
        if (cage) {
            out.bodies[b].cage = *cage;
            noteClamped(input, b, out);
        } else {
            note(cage.error());
        }
    }
    if (input.settings.subdivision.on) {
        std::size_t left = input.memoryLimit;
        for (std::size_t b = 0; b < input.bodies.size(); ++b) {
            auto surface = makeSurface(input, b, out.bodies[b], left, cache);
            if (!surface) {
                // One body as a solid beside others that are smooth would look like a mistake.
                note(surface.error());
                for (BodyShape& body : out.bodies) body.surface.reset();
                break;
            }
            left -= std::min(left, bytesOf(**surface));
            out.bodies[b].surface = *surface;
        }
        cache.limitSurfaces(input.memoryLimit);
    }
    if (!input.mapped.empty()) mapStrokes(input, out, cache);
    return out;
}

// Meshes -----------------------------------------------------------------------------------------

ShapeMesh shapeMesh(const Body& body, const BodyShape& shape) {
    ShapeMesh out;
    const std::vector<Vec3>& points = shape.surface ? shape.surface->positions
                                      : shape.cage  ? shape.cage->mesh.points
                                                    : body.solid.vertices();
    out.positions.reserve(points.size());
    for (const Vec3& p : points) out.positions.push_back(body.pose.toWorld(p));
    if (shape.surface) {
        out.triangles = shape.surface->triangles;
        out.normalTriangles = shape.surface->normalTriangles;
        out.normals.reserve(shape.surface->normals.size());
        for (const Eigen::Vector3f& n : shape.surface->normals) {
            out.normals.push_back(body.pose.directionToWorld(n.cast<double>()));
        }
        return out;
    }
    if (shape.cage) {
        // fillet() passed its own check, so every face can be split.
        std::vector<int> broken;
        auto split = triangulate(shape.cage->mesh, &broken);
        if (split) {
            out.triangles = std::move(split->triangles);
            out.faces = std::move(split->face);
        }
        return out;
    }
    for (const SolidTriangle& t : body.solid.triangles()) {
        out.triangles.push_back(t.vertices);
        out.faces.push_back(t.face);
    }
    return out;
}

std::vector<std::vector<int>> shapePolygons(const Body& body, const BodyShape& shape) {
    if (!shape.cage) return facePolygons(body.solid);
    const PolyMesh& mesh = shape.cage->mesh;
    std::vector<std::vector<std::vector<int>>> pieces(at(mesh.faceCount()));
    std::vector<int> broken;
    if (const auto split = triangulate(mesh, &broken)) {
        for (std::size_t t = 0; t < split->triangles.size(); ++t) {
            const auto& corners = split->triangles[t];
            pieces[at(split->face[t])].push_back({corners.begin(), corners.end()});
        }
    }
    std::vector<std::vector<int>> out;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const auto outline = mesh.outline(f);
        std::vector<int> sorted(outline.begin(), outline.end());
        std::sort(sorted.begin(), sorted.end());
        const bool simple = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
        if (mesh.loopCount(f) == 1 && simple) {
            out.emplace_back(outline.begin(), outline.end());
            continue;
        }
        for (auto& polygon : joinTriangles(std::move(pieces[at(f)]))) {
            out.push_back(std::move(polygon));
        }
    }
    return out;
}

double estimatedDeviation(const SurfaceMesh& surface) {
    double most = 0.0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const Vec3 side = surface.positions[at(surface.triangles[t][next])] -
                              surface.positions[at(surface.triangles[t][k])];
            const double turn = side.dot(surface.normal(t, next) - surface.normal(t, k));
            most = std::max(most, std::abs(turn));
        }
    }
    // A parabola rises by an eighth of chord times change of slope; inside an equilateral triangle
    // on a paraboloid it is a third more.
    constexpr double kShare = 1.0 / 6.0;
    return kShare * most;
}

std::string clampText(const std::vector<Body>& bodies, const ClampedEdge& clamp) {
    const auto shortly = [](double mm) {
        constexpr double kRounded = 100.0;
        return numberText(std::round(mm * kRounded) / kRounded) + " mm";
    };
    const Solid& solid = bodies[at(clamp.edge.body)].solid;
    const SolidEdge& edge = solid.edges()[at(clamp.edge.edge)];
    const double length =
        (solid.vertices()[at(edge.ends[0])] - solid.vertices()[at(edge.ends[1])]).norm();
    std::string out =
        "Edge " + std::to_string(clamp.edge.edge + 1) + " (" + shortly(length) + " long): ";
    out += clamp.used > 0.0 ? "radius " + shortly(clamp.used) : std::string("stays sharp");
    out += " instead of " + shortly(clamp.requested);
    if (clamp.limitingEdge == clamp.edge.edge) {
        out += ", its own length leaves no more room";
    } else if (clamp.limitingEdge >= 0) {
        out += ", edge " + std::to_string(clamp.limitingEdge + 1) + " leaves no more room";
    } else if (clamp.limitingVertex >= 0) {
        out += ", corner " + std::to_string(clamp.limitingVertex + 1) + " leaves no more room";
    }
    return out;
}

}  // namespace ew
