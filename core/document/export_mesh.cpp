// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/export_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <random>

namespace ew {
namespace {

namespace fs = std::filesystem;

/// A body's mesh in the world.
struct WorldMesh {
    std::vector<Vec3> points;
    std::vector<std::vector<int>> polygons;
    std::vector<std::array<int, 3>> triangles;
};

Result<std::vector<WorldMesh>> toWorld(const std::vector<Body>& bodies) {
    std::vector<WorldMesh> out;
    for (const Body& body : bodies) {
        WorldMesh mesh;
        for (const Vec3& p : body.solid.vertices()) {
            mesh.points.push_back(body.pose.toWorld(p));
            const Vec3& w = mesh.points.back();
            if (!w.allFinite() || w.cwiseAbs().maxCoeff() > std::numeric_limits<float>::max()) {
                return fail(Errc::BadValue,
                            "The solid lies too far out to be written to a mesh file.");
            }
        }
        mesh.polygons = facePolygons(body.solid);
        for (const SolidTriangle& t : body.solid.triangles()) mesh.triangles.push_back(t.vertices);
        out.push_back(std::move(mesh));
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

std::string objText(const std::vector<WorldMesh>& bodies) {
    std::string out = "# Edgewright\n";
    std::size_t base = 1;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        out.append("o body").append(std::to_string(b + 1)).append("\n");
        for (const Vec3& p : bodies[b].points) {
            out.append("v ").append(number(p.x())).append(" ").append(number(p.y()));
            out.append(" ").append(number(p.z())).append("\n");
        }
        for (const std::vector<int>& polygon : bodies[b].polygons) {
            out.append("f");
            for (const int i : polygon) {
                out.append(" ").append(std::to_string(base + static_cast<std::size_t>(i)));
            }
            out.append("\n");
        }
        base += bodies[b].points.size();
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

std::string stlBytes(const std::vector<WorldMesh>& bodies) {
    std::string out = "Edgewright, mm";
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

std::string plyBytes(const std::vector<WorldMesh>& bodies) {
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

// Holes -------------------------------------------------------------------------------------------

/// Joins two polygons along the edge a-b of the first; nothing where a point would come twice.
std::vector<int> joined(const std::vector<int>& first, std::size_t side,
                        const std::vector<int>& second) {
    const int a = first[side];
    const int b = first[(side + 1) % first.size()];
    std::vector<int> out;
    for (std::size_t k = 0; k < first.size(); ++k) {
        out.push_back(first[(side + 1 + k) % first.size()]);  // b ... a
    }
    const auto at = std::find(second.begin(), second.end(), a);
    auto k = static_cast<std::size_t>(at - second.begin());
    for (k = (k + 1) % second.size(); second[k] != b; k = (k + 1) % second.size()) {
        out.push_back(second[k]);
    }
    std::vector<int> sorted = out;
    std::sort(sorted.begin(), sorted.end());
    const bool twice = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
    return twice ? std::vector<int>() : out;
}

/// Joins triangles of one face into few simple polygons.
std::vector<std::vector<int>> joinTriangles(std::vector<std::vector<int>> pieces) {
    std::map<std::array<int, 2>, std::size_t> pieceAt;  // directed edge -> piece on its left
    std::vector<std::array<int, 2>> edges;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        for (std::size_t k = 0; k < pieces[p].size(); ++k) {
            edges.push_back({pieces[p][k], pieces[p][(k + 1) % pieces[p].size()]});
            pieceAt[edges.back()] = p;
        }
    }
    for (const auto& edge : edges) {
        const auto back = pieceAt.find({edge[1], edge[0]});
        const auto here = pieceAt.find(edge);
        if (here == pieceAt.end() || back == pieceAt.end() || here->second == back->second)
            continue;
        const std::size_t keep = here->second;
        const std::size_t drop = back->second;
        const auto& piece = pieces[keep];
        std::size_t side = 0;
        while (piece[side] != edge[0] || piece[(side + 1) % piece.size()] != edge[1]) ++side;
        std::vector<int> whole = joined(piece, side, pieces[drop]);
        if (whole.empty()) continue;
        pieceAt.erase(here);
        pieceAt.erase(back);
        pieces[keep] = std::move(whole);
        pieces[drop].clear();
        for (std::size_t k = 0; k < pieces[keep].size(); ++k) {
            pieceAt[{pieces[keep][k], pieces[keep][(k + 1) % pieces[keep].size()]}] = keep;
        }
    }
    std::erase_if(pieces, [](const std::vector<int>& p) { return p.empty(); });
    return pieces;
}

// Writing -----------------------------------------------------------------------------------------

Unexpected<Error> cannotWrite(const fs::path& path, const std::string& why) {
    std::string text = "The file ";
    text.append(path.string()).append(" could not be written: ").append(why).append(".");
    return fail(Errc::CannotWrite, std::move(text));
}

Result<void> writeWhole(const fs::path& target, const std::string& bytes) {
    std::error_code ec;
    if (fs::is_directory(target, ec)) return cannotWrite(target, "it is a folder");
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ec)) return cannotWrite(target, "its folder does not exist");
    // A short name of its own, so that a name at the system's limit can still be written.
    char name[24] = ".ew";
    std::random_device random;
    const auto end = std::to_chars(name + 3, name + sizeof(name) - 1, random(), 36);
    *end.ptr = '\0';
    const fs::path beside = folder / name;
    errno = 0;
    std::ofstream file(beside, std::ios::binary | std::ios::trunc);
    if (!file) {
        const int reason = errno;
        return cannotWrite(target, reason != 0 ? std::strerror(reason) : "no reason given");
    }
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
        const int reason = errno;
        fs::remove(beside, ec);
        return cannotWrite(target, reason != 0 ? std::strerror(reason) : "no reason given");
    }
    fs::rename(beside, target, ec);
    if (!ec) return {};
    const std::string why = ec.message();
    fs::remove(beside, ec);
    return cannotWrite(target, why);
}

}  // namespace

std::vector<std::vector<int>> facePolygons(const Solid& solid) {
    std::vector<std::vector<std::vector<int>>> triangles(solid.faces().size());
    for (const SolidTriangle& t : solid.triangles()) {
        triangles[static_cast<std::size_t>(t.face)].push_back(
            {t.vertices.begin(), t.vertices.end()});
    }
    std::vector<std::vector<int>> out;
    for (std::size_t f = 0; f < solid.faces().size(); ++f) {
        const auto& loops = solid.faces()[f].loops;
        std::vector<int> sorted = loops[0];
        std::sort(sorted.begin(), sorted.end());
        // An outline that meets itself in a point is no simple polygon either.
        const bool simple = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
        if (loops.size() == 1 && simple) {
            out.push_back(loops[0]);
            continue;
        }
        for (auto& polygon : joinTriangles(std::move(triangles[f]))) {
            out.push_back(std::move(polygon));
        }
    }
    return out;
}

Result<void> exportBodies(const std::vector<Body>& bodies, const std::string& path) {
    const fs::path target(std::u8string(path.begin(), path.end()));
    std::string extension = target.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension != ".obj" && extension != ".stl" && extension != ".ply") {
        std::string text =
            extension.empty() ? "A file name without an extension" : "The extension ";
        text.append(extension).append(" names no mesh format; use .obj, .stl or .ply.");
        return fail(Errc::UnknownExtension, std::move(text));
    }
    if (bodies.empty()) return fail(Errc::NoSolid, "There is no solid to export yet.");
    const auto meshes = toWorld(bodies);
    if (!meshes) return fail(meshes.error());
    const std::string bytes = extension == ".obj"   ? objText(*meshes)
                              : extension == ".stl" ? stlBytes(*meshes)
                                                    : plyBytes(*meshes);
    return writeWhole(target, bytes);
}

}  // namespace ew
