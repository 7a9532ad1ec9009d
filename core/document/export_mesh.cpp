// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/export_mesh.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>

#include "core/base/tolerance.h"
#include "core/document/export_3mf.h"
#include "core/document/export_gltf.h"
#include "core/document/export_place.h"
#include "core/document/export_writers.h"
#include "core/document/file_bytes.h"
#include "core/document/shape_reading.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// Do readers that cut a polygon into a fan from its first corner get it right, with area in each
/// triangle?
bool isConvex(const std::vector<int>& polygon, const std::vector<Vec3>& points) {
    const std::size_t n = polygon.size();
    const auto at = [&](std::size_t k) -> const Vec3& {
        return points[static_cast<std::size_t>(polygon[k % n])];
    };
    Vec3 area = Vec3::Zero();
    for (std::size_t k = 2; k < n; ++k) area += (at(k - 1) - at(0)).cross(at(k) - at(0));
    for (std::size_t k = 0; k < n; ++k) {
        const Vec3 in = at(k + 1) - at(k);
        const Vec3 out = at(k + 2) - at(k + 1);
        if (in.cross(out).dot(area) <= tol::kNoTurnSine * in.norm() * out.norm() * area.norm()) {
            return false;
        }
    }
    return true;
}

/// Faces of two triangles as one polygon where that is convex; all others as triangles.
std::vector<std::vector<int>> simpleFaces(const ShapeMesh& shape) {
    std::map<int, std::vector<std::vector<int>>> pieces;
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        pieces[shape.faces[t]].emplace_back(shape.triangles[t].begin(), shape.triangles[t].end());
    }
    std::vector<std::vector<int>> out;
    for (auto& [face, triangles] : pieces) {
        if (triangles.size() == 2) {
            auto joined = joinTriangles(triangles);
            if (joined.size() == 1 && isConvex(joined[0], shape.positions)) triangles = joined;
        }
        for (auto& polygon : triangles) out.push_back(std::move(polygon));
    }
    return out;
}

std::vector<std::vector<int>> trianglesOf(const ShapeMesh& shape) {
    std::vector<std::vector<int>> out;
    out.reserve(shape.triangles.size());
    for (const auto& t : shape.triangles) out.emplace_back(t.begin(), t.end());
    return out;
}

std::vector<std::vector<int>> facesOf(const Body& body, const BodyShape& bodyShape,
                                      const ShapeMesh& shape, ExportFaces faces) {
    if (bodyShape.surface || faces == ExportFaces::Triangles) return trianglesOf(shape);
    if (faces == ExportFaces::Polygons) return shapePolygons(body, bodyShape);
    return simpleFaces(shape);
}

Extent extentOf(const WorldMeshes& meshes) {
    Extent extent;
    for (const WorldMesh& body : meshes.bodies) extent.add(body.points);
    return extent;
}

/// Errors: BadValue where a body is too small for where it lies.
Result<void> checkReach(const WorldMeshes& meshes, double most, const char* sentence) {
    for (const WorldMesh& body : meshes.bodies) {
        Extent extent;
        extent.add(body.points);
        if (extent.reach() > most * extent.size()) return fail(Errc::BadValue, sentence);
    }
    return {};
}

/// The same meshes round an origin of their own.
WorldMeshes moved(WorldMeshes meshes, const Vec3& origin) {
    meshes.origin = origin;
    for (WorldMesh& body : meshes.bodies) {
        for (Vec3& p : body.points) p -= origin;
    }
    for (WorldLine& line : meshes.lines) {
        for (auto& piece : line.pieces) {
            for (Vec3& p : piece) p -= origin;
        }
    }
    return meshes;
}

constexpr const char* kTooFarOut = "The solid lies too far out to be written to a mesh file.";

/// The bodies that are wanted, by index. Errors: BadValue.
Result<std::vector<std::size_t>> wantedBodies(const MeshSource& source,
                                              const std::vector<int>& chosen) {
    std::vector<std::size_t> out;
    for (const int b : chosen) {
        if (b < 0 || static_cast<std::size_t>(b) >= source.bodies.size()) {
            return fail(Errc::BadValue,
                        "There is no body number " + std::to_string(b) + "; the document has " +
                            std::to_string(source.bodies.size()) + ", counted from 0.");
        }
        out.push_back(static_cast<std::size_t>(b));
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    for (std::size_t b = 0; chosen.empty() && b < source.bodies.size(); ++b) {
        if (!source.bodies[b].hidden) out.push_back(b);
    }
    return out;
}

std::vector<WorldLine> linesOf(const MeshSource& source, double scale) {
    std::vector<WorldLine> lines(source.mapped.size());
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i].color = source.mapped[i].color;
    for (const MappedCurve& curve : source.shape.curves) {
        if (curve.points.size() < 2) continue;  // no format has a line of one point
        auto& pieces = lines[static_cast<std::size_t>(curve.stroke)].pieces;
        std::vector<Vec3>& piece = pieces.emplace_back();
        for (const MappedPoint& p : curve.points) piece.push_back(p.position * scale);
    }
    return lines;
}

/// \param scale  units of the file in a mm.
Result<WorldMeshes> toWorld(const MeshSource& source, const std::vector<std::size_t>& bodies,
                            ExportFaces faces, double scale, ExportProgress& progress) {
    WorldMeshes out;
    for (const std::size_t b : bodies) {
        if (progress.stopped()) break;
        ShapeMesh shape = shapeMesh(source.bodies[b], source.shape.bodies[b]);
        for (const Vec3& p : shape.positions) {
            if (p.allFinite() && p.cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max()) {
                continue;
            }
            return fail(Errc::BadValue, kTooFarOut);
        }
        WorldMesh mesh;
        mesh.polygons = facesOf(source.bodies[b], source.shape.bodies[b], shape, faces);
        mesh.points = std::move(shape.positions);
        if (scale != 1.0) {
            for (Vec3& p : mesh.points) p *= scale;
        }
        mesh.triangles = std::move(shape.triangles);
        mesh.normals = std::move(shape.normals);
        mesh.normalTriangles = std::move(shape.normalTriangles);
        out.bodies.push_back(std::move(mesh));
        progress.did(1);
    }
    if (auto ok = checkReach(out, tol::kDoublePrecisionReach, kTooFarOut); !ok) {
        return fail(ok.error());
    }
    // Which body a stroke lies on is not known; on a hidden one lies none.
    const auto isIn = [&](std::size_t b) {
        return source.bodies[b].hidden || std::binary_search(bodies.begin(), bodies.end(), b);
    };
    bool all = true;
    for (std::size_t b = 0; b < source.bodies.size(); ++b) all &= isIn(b);
    if (all) out.lines = linesOf(source, scale);
    return out;
}

/// 8-bit sRGB to the linear numbers of glTF.
std::array<double, 3> linearColor(const StrokeColor& color) {
    std::array<double, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double c = color[i] / 255.0;
        out[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    return out;
}

Result<std::string> packageBytes(const WorldMeshes& meshes, bool gltf) {
    std::vector<TriangleMeshView> bodies;
    for (std::size_t b = 0; b < meshes.bodies.size(); ++b) {
        const WorldMesh& m = meshes.bodies[b];
        TriangleMeshView view;
        view.name = "body" + std::to_string(b + 1);
        view.positions = m.points;
        view.triangles = m.triangles;
        view.normals = m.normals;
        view.normalTriangles = m.normalTriangles;
        bodies.push_back(std::move(view));
    }
    if (!gltf) return threeMfBytes(bodies, meshes.origin);
    std::vector<PolylineView> lines;
    for (const WorldLine& line : meshes.lines) {
        for (const auto& piece : line.pieces) lines.push_back({piece, linearColor(line.color)});
    }
    return gltfBytes(bodies, lines, meshes.origin);
}

/// The bytes of the format that an extension names; nothing where it names none.
std::optional<Result<std::string>> bytesFor(const std::string& extension, const WorldMeshes& meshes,
                                            ExportProgress& progress) {
    if (extension == ".obj") return objText(meshes, progress);
    if (extension == ".stl") return stlBytes(meshes, progress);
    if (extension == ".ply") return plyBytes(meshes, progress);
    if (extension == ".glb" || extension == ".3mf") {
        return packageBytes(meshes, extension == ".glb");
    }
    return std::nullopt;
}

/// STL has one origin for all bodies and single precision only. A body of .glb has its own, and of
/// .3mf, whose digits slicers keep in single precision.
Result<void> checkFormat(const std::string& extension, const WorldMeshes& meshes) {
    if (extension == ".stl") {
        auto ok = checkReach(meshes, tol::kSinglePrecisionReach,
                             "The bodies lie too far apart for the single precision of STL; export "
                             "them as OBJ, 3MF or glTF.");
        if (!ok) return ok;
    }
    if (extension == ".obj" || extension == ".ply") return {};
    for (const WorldMesh& body : meshes.bodies) {
        const bool ownOrigin = extension != ".stl";
        if (readsAsClosed(ownOrigin ? atOwnOrigin(body.points) : body.points, body.triangles)) {
            continue;
        }
        return fail(Errc::NotClosed,
                    "In the single precision of this format the shape would not be closed: parts "
                    "are too thin for it, or too far from the origin. Use .obj or .ply, or change "
                    "the shape.");
    }
    return {};
}

/// What the person is told of a file with an origin of its own.
std::string noteOn(const std::string& extension, const WorldMeshes& meshes) {
    if (extension == ".glb" || extension == ".3mf") return {};  // readers put it back
    if (meshes.origin.isZero(0.0)) return {};
    return "It lies far out: in the file, the origin is at " + placeText(meshes.origin) + " " +
           meshes.unit + ".";
}

/// The extension in small letters. Errors: UnknownExtension.
Result<std::string> extensionOf(const std::string& path) {
    const fs::path target(std::u8string(path.begin(), path.end()));
    std::string extension = target.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    ExportProgress none({});
    if (bytesFor(extension, {}, none)) return extension;
    std::string text = extension.empty() ? "A file name without an extension" : "The extension ";
    text.append(extension).append(" names no mesh format; use .obj, .stl, .ply, .glb or .3mf.");
    return fail(Errc::UnknownExtension, std::move(text));
}

Unexpected<Error> cancelled() { return fail(Errc::Cancelled, "The export was given up."); }

}  // namespace

Result<std::string> exportShape(const MeshSource& source, const std::string& path,
                                const ExportOptions& options) {
    const auto extension = extensionOf(path);
    if (!extension) return fail(extension.error());
    if (source.bodies.empty()) return fail(Errc::NoSolid, "There is no solid to export yet.");
    if (source.shape.problem) return fail(*source.shape.problem);
    const auto bodies = wantedBodies(source, options.bodies);
    if (!bodies) return fail(bodies.error());
    if (bodies->empty()) {
        return fail(Errc::NoSolid, "All solids are hidden; show one to export it.");
    }
    const bool scaled = formatLacksUnit(path);

    constexpr double kMeshesShare = 0.3;
    constexpr double kBytesShare = 0.9;
    ExportProgress progress(options.progress);
    progress.part(0.0, kMeshesShare, bodies->size());
    auto meshes =
        toWorld(source, *bodies, options.faces, scaled ? unitsPerMm(options.unit) : 1.0, progress);
    if (!meshes) return fail(meshes.error());
    if (scaled) meshes->unit = exportUnitName(options.unit);
    if (*extension != ".obj") {
        const Vec3 origin = fileOrigin(extentOf(*meshes));
        *meshes = moved(*std::move(meshes), origin);
        if (auto ok = checkFormat(*extension, *meshes); !ok) return fail(ok.error());
    }
    progress.part(kMeshesShare, kBytesShare, meshes->triangles());
    if (progress.stopped()) return cancelled();
    const auto bytes = *bytesFor(*extension, *meshes, progress);
    if (!bytes) return fail(bytes.error());
    progress.part(kBytesShare, 1.0, 1);
    if (progress.stopped()) return cancelled();
    if (auto ok = writeFileBytes(QString::fromStdString(path), *bytes); !ok) {
        return fail(ok.error());
    }
    return *extension == ".obj" ? std::string() : noteOn(*extension, *meshes);
}

Result<std::string> exportBodies(const std::vector<Body>& bodies, const std::string& path,
                                 const ExportOptions& options) {
    DerivedShape solids;
    solids.bodies.resize(bodies.size());
    const std::vector<MappedStroke> none;
    return exportShape({bodies, solids, none}, path, options);
}

}  // namespace ew
