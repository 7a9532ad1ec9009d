// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/export_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>

#include "core/base/tolerance.h"
#include "core/document/export_3mf.h"
#include "core/document/export_gltf.h"
#include "core/document/export_place.h"
#include "core/document/file_bytes.h"
#include "core/document/shape_reading.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// A body's mesh in the world.
struct WorldMesh {
    std::vector<Vec3> points;
    std::vector<std::vector<int>> polygons;
    std::vector<std::array<int, 3>> triangles;
    std::vector<Vec3> normals;  // of a surface, else empty
    std::vector<std::array<int, 3>> normalTriangles;
};

/// A stroke on the surface.
struct WorldLine {
    std::vector<std::vector<Vec3>> pieces;
    StrokeColor color{};
};

struct WorldMeshes {
    std::vector<WorldMesh> bodies;
    std::vector<WorldLine> lines;
    Vec3 origin = Vec3::Zero();  // of these coordinates, in the world
};

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

Result<WorldMeshes> toWorld(const MeshSource& source, ExportFaces faces) {
    WorldMeshes out;
    for (std::size_t b = 0; b < source.bodies.size(); ++b) {
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
        mesh.triangles = std::move(shape.triangles);
        mesh.normals = std::move(shape.normals);
        mesh.normalTriangles = std::move(shape.normalTriangles);
        out.bodies.push_back(std::move(mesh));
    }
    if (auto ok = checkReach(out, tol::kDoublePrecisionReach, kTooFarOut); !ok) {
        return fail(ok.error());
    }
    out.lines.resize(source.mapped.size());
    for (std::size_t i = 0; i < source.mapped.size(); ++i) {
        out.lines[i].color = source.mapped[i].color;
    }
    for (const MappedCurve& curve : source.shape.curves) {
        if (curve.points.size() < 2) continue;  // no format has a line of one point
        auto& pieces = out.lines[static_cast<std::size_t>(curve.stroke)].pieces;
        std::vector<Vec3>& piece = pieces.emplace_back();
        for (const MappedPoint& p : curve.points) piece.push_back(p.position);
    }
    return out;
}

std::string number(double value) {
    char buffer[40];
    // -0 would be a difference between two exports of the same solid.
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value == 0.0 ? 0.0 : value,
                                   std::chars_format::general, 17);
    return {buffer, end.ptr};
}

void appendPoint(std::string& out, const char* word, const Vec3& p) {
    out.append(word).append(number(p.x())).append(" ").append(number(p.y()));
    out.append(" ").append(number(p.z())).append("\n");
}

void appendFaces(std::string& out, const WorldMesh& body, std::size_t base, std::size_t normals) {
    if (body.normals.empty()) {
        for (const std::vector<int>& polygon : body.polygons) {
            out.append("f");
            for (const int i : polygon) {
                out.append(" ").append(std::to_string(base + static_cast<std::size_t>(i)));
            }
            out.append("\n");
        }
        return;
    }
    const auto& corners = body.normalTriangles.empty() ? body.triangles : body.normalTriangles;
    for (std::size_t t = 0; t < body.triangles.size(); ++t) {
        out.append("f");
        for (std::size_t k = 0; k < 3; ++k) {
            out.append(" ").append(
                std::to_string(base + static_cast<std::size_t>(body.triangles[t][k])));
            out.append("//").append(
                std::to_string(normals + static_cast<std::size_t>(corners[t][k])));
        }
        out.append("\n");
    }
}

std::string objText(const WorldMeshes& meshes) {
    std::string out = "# Edgewright\n";
    std::size_t base = 1;
    std::size_t normals = 1;
    for (std::size_t b = 0; b < meshes.bodies.size(); ++b) {
        const WorldMesh& body = meshes.bodies[b];
        out.append("o body").append(std::to_string(b + 1)).append("\n");
        for (const Vec3& p : body.points) appendPoint(out, "v ", p);
        for (const Vec3& n : body.normals) appendPoint(out, "vn ", n);
        appendFaces(out, body, base, normals);
        base += body.points.size();
        normals += body.normals.size();
    }
    for (std::size_t i = 0; i < meshes.lines.size(); ++i) {
        if (meshes.lines[i].pieces.empty()) continue;
        out.append("o stroke").append(std::to_string(i + 1)).append("\n");
        for (const std::vector<Vec3>& piece : meshes.lines[i].pieces) {
            for (const Vec3& p : piece) appendPoint(out, "v ", p);
            out.append("l");
            for (std::size_t k = 0; k < piece.size(); ++k) {
                out.append(" ").append(std::to_string(base + k));
            }
            out.append("\n");
            base += piece.size();
        }
    }
    return out;
}

/// Appends a number in little endian order.
template <class T>
void put(std::string& out, T value) {
    std::array<char, sizeof(T)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof(T));
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    out.append(bytes.data(), bytes.size());
}

/// "1000000000 0 0"
std::string placeText(const Vec3& p) {
    return number(p.x()).append(" ").append(number(p.y())).append(" ").append(number(p.z()));
}

std::string stlBytes(const WorldMeshes& meshes) {
    const std::vector<WorldMesh>& bodies = meshes.bodies;
    std::string out = "Edgewright, mm";
    if (!meshes.origin.isZero(0.0)) out.append(", origin at ").append(placeText(meshes.origin));
    out.resize(80, ' ');
    std::size_t count = 0;
    for (const WorldMesh& body : bodies) count += body.triangles.size();
    put(out, static_cast<std::uint32_t>(count));
    const auto putVec = [&](const Vec3& v) {
        for (int k = 0; k < 3; ++k) put(out, static_cast<float>(v[k]));
    };
    for (const WorldMesh& body : bodies) {
        for (const auto& t : body.triangles) {
            const Vec3& a = body.points[static_cast<std::size_t>(t[0])];
            const Vec3& b = body.points[static_cast<std::size_t>(t[1])];
            const Vec3& c = body.points[static_cast<std::size_t>(t[2])];
            putVec((b - a).cross(c - a).normalized());
            putVec(a);
            putVec(b);
            putVec(c);
            put(out, std::uint16_t{0});
        }
    }
    return out;
}

std::string plyBytes(const WorldMeshes& meshes) {
    const std::vector<WorldMesh>& bodies = meshes.bodies;
    std::size_t points = 0;
    std::size_t polygons = 0;
    std::size_t longest = 0;
    for (const WorldMesh& body : bodies) {
        points += body.points.size();
        polygons += body.polygons.size();
        for (const auto& polygon : body.polygons) longest = std::max(longest, polygon.size());
    }
    const bool shortLists = longest <= std::numeric_limits<std::uint8_t>::max();
    std::string out = "ply\nformat binary_little_endian 1.0\ncomment Edgewright, mm\n";
    if (!meshes.origin.isZero(0.0)) {
        out.append("comment origin at ").append(placeText(meshes.origin)).append("\n");
    }
    out.append("element vertex ").append(std::to_string(points));
    out.append("\nproperty double x\nproperty double y\nproperty double z\n");
    out.append("element face ").append(std::to_string(polygons));
    out.append("\nproperty list ").append(shortLists ? "uchar" : "uint");
    out.append(" int vertex_indices\nend_header\n");
    for (const WorldMesh& body : bodies) {
        for (const Vec3& p : body.points) {
            for (int k = 0; k < 3; ++k) put(out, p[k]);
        }
    }
    std::int32_t base = 0;
    for (const WorldMesh& body : bodies) {
        for (const auto& polygon : body.polygons) {
            if (shortLists) {
                put(out, static_cast<std::uint8_t>(polygon.size()));
            } else {
                put(out, static_cast<std::uint32_t>(polygon.size()));
            }
            for (const int i : polygon) put(out, static_cast<std::int32_t>(base + i));
        }
        base += static_cast<std::int32_t>(body.points.size());
    }
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
std::optional<Result<std::string>> bytesFor(const std::string& extension,
                                            const WorldMeshes& meshes) {
    if (extension == ".obj") return objText(meshes);
    if (extension == ".stl") return stlBytes(meshes);
    if (extension == ".ply") return plyBytes(meshes);
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
std::string noteOn(const std::string& extension, const Vec3& origin) {
    if (extension == ".glb" || extension == ".3mf") return {};  // readers put it back
    return "It lies far out: in the file, the origin is at " + placeText(origin) + " mm.";
}

}  // namespace

Result<std::string> exportShape(const MeshSource& source, const std::string& path,
                                ExportFaces faces) {
    const fs::path target(std::u8string(path.begin(), path.end()));
    std::string extension = target.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (!bytesFor(extension, {})) {
        std::string text =
            extension.empty() ? "A file name without an extension" : "The extension ";
        text.append(extension).append(" names no mesh format; use .obj, .stl, .ply, .glb or .3mf.");
        return fail(Errc::UnknownExtension, std::move(text));
    }
    if (source.bodies.empty()) return fail(Errc::NoSolid, "There is no solid to export yet.");
    if (source.shape.problem) return fail(*source.shape.problem);
    auto meshes = toWorld(source, faces);
    if (!meshes) return fail(meshes.error());
    std::string note;
    if (extension != ".obj") {
        *meshes = moved(*std::move(meshes), fileOrigin(extentOf(*meshes)));
        const auto ok = checkFormat(extension, *meshes);
        if (!ok) return fail(ok.error());
        if (!meshes->origin.isZero(0.0)) note = noteOn(extension, meshes->origin);
    }
    const auto bytes = *bytesFor(extension, *meshes);
    if (!bytes) return fail(bytes.error());
    if (auto ok = writeFileBytes(QString::fromStdString(path), *bytes); !ok) {
        return fail(ok.error());
    }
    return note;
}

Result<std::string> exportBodies(const std::vector<Body>& bodies, const std::string& path,
                                 ExportFaces faces) {
    DerivedShape solids;
    solids.bodies.resize(bodies.size());
    const std::vector<MappedStroke> none;
    return exportShape({bodies, solids, none}, path, faces);
}

}  // namespace ew
