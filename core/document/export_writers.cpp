// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/export_writers.h"

#include <charconv>
#include <cstdint>
#include <limits>

#include "core/document/little_endian.h"

namespace ew {

namespace {

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

void appendFaces(std::string& out, const WorldMesh& body, std::size_t base, std::size_t normals,
                 ExportProgress& progress) {
    if (body.normals.empty()) {
        for (const std::vector<int>& polygon : body.polygons) {
            if (!progress.did(1)) return;
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
        if (!progress.did(1)) return;
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

}  // namespace

std::string placeText(const Vec3& p) {
    return number(p.x()).append(" ").append(number(p.y())).append(" ").append(number(p.z()));
}

std::string objText(const WorldMeshes& meshes, ExportProgress& progress) {
    std::string out = "# Edgewright, " + meshes.unit + "\n";
    std::size_t base = 1;
    std::size_t normals = 1;
    for (std::size_t b = 0; b < meshes.bodies.size(); ++b) {
        const WorldMesh& body = meshes.bodies[b];
        out.append("o body").append(std::to_string(b + 1)).append("\n");
        for (const Vec3& p : body.points) appendPoint(out, "v ", p);
        for (const Vec3& n : body.normals) appendPoint(out, "vn ", n);
        appendFaces(out, body, base, normals, progress);
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

std::string stlBytes(const WorldMeshes& meshes, ExportProgress& progress) {
    const std::vector<WorldMesh>& bodies = meshes.bodies;
    std::string out = "Edgewright, " + meshes.unit;
    if (!meshes.origin.isZero(0.0)) out.append(", origin at ").append(placeText(meshes.origin));
    out.resize(80, ' ');
    appendLittleEndian(out, static_cast<std::uint32_t>(meshes.triangles()));
    const auto putVec = [&](const Vec3& v) {
        for (int k = 0; k < 3; ++k) appendLittleEndian(out, static_cast<float>(v[k]));
    };
    for (const WorldMesh& body : bodies) {
        for (const auto& t : body.triangles) {
            if (!progress.did(1)) return out;
            const Vec3& a = body.points[static_cast<std::size_t>(t[0])];
            const Vec3& b = body.points[static_cast<std::size_t>(t[1])];
            const Vec3& c = body.points[static_cast<std::size_t>(t[2])];
            putVec((b - a).cross(c - a).normalized());
            putVec(a);
            putVec(b);
            putVec(c);
            appendLittleEndian(out, std::uint16_t{0});
        }
    }
    return out;
}

std::string plyBytes(const WorldMeshes& meshes, ExportProgress& progress) {
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
    std::string out =
        "ply\nformat binary_little_endian 1.0\ncomment Edgewright, " + meshes.unit + "\n";
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
            for (int k = 0; k < 3; ++k) appendLittleEndian(out, p[k]);
        }
    }
    std::int32_t base = 0;
    for (const WorldMesh& body : bodies) {
        for (const auto& polygon : body.polygons) {
            if (!progress.did(1)) return out;
            if (shortLists) {
                appendLittleEndian(out, static_cast<std::uint8_t>(polygon.size()));
            } else {
                appendLittleEndian(out, static_cast<std::uint32_t>(polygon.size()));
            }
            for (const int i : polygon)
                appendLittleEndian(out, static_cast<std::int32_t>(base + i));
        }
        base += static_cast<std::int32_t>(body.points.size());
    }
    return out;
}

}  // namespace ew
