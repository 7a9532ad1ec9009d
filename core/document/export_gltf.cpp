// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/export_gltf.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "core/document/export_place.h"
#include "core/document/little_endian.h"

namespace ew {
namespace {

using nlohmann::ordered_json;

constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kLineStrip = 3;
constexpr int kTriangles = 4;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool fitsFloat(const Vec3& p) {
    return p.allFinite() && p.cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max();
}

/// Points with one normal each, as the format wants them.
struct SplitMesh {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;
    std::vector<std::array<int, 3>> triangles;
};

SplitMesh flatMesh(const TriangleMeshView& body) {
    SplitMesh out;
    for (const auto& t : body.triangles) {
        const Vec3& a = body.positions[at(t[0])];
        const Vec3& b = body.positions[at(t[1])];
        const Vec3& c = body.positions[at(t[2])];
        const Vec3 area = (b - a).cross(c - a);
        const double length = area.norm();
        // The format allows unit normals only, also on a triangle without area.
        const Vec3 normal = length > 0.0 ? Vec3(area / length) : Vec3(Vec3::UnitZ());
        const int first = static_cast<int>(out.positions.size());
        out.triangles.push_back({first, first + 1, first + 2});
        for (const Vec3* p : {&a, &b, &c}) {
            out.positions.push_back(*p);
            out.normals.push_back(normal);
        }
    }
    return out;
}

SplitMesh splitMesh(const TriangleMeshView& body) {
    if (body.normals.empty()) return flatMesh(body);
    SplitMesh out;
    if (body.normalTriangles.empty()) {
        out.positions.assign(body.positions.begin(), body.positions.end());
        out.normals.assign(body.normals.begin(), body.normals.end());
        out.triangles.assign(body.triangles.begin(), body.triangles.end());
        return out;
    }
    std::unordered_map<std::uint64_t, int> ids;
    ids.reserve(body.normals.size());
    for (std::size_t t = 0; t < body.triangles.size(); ++t) {
        std::array<int, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const int p = body.triangles[t][k];
            const int n = body.normalTriangles[t][k];
            const auto key = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(p)) << 32U) |
                             static_cast<std::uint32_t>(n);
            const auto [it, isNew] = ids.emplace(key, static_cast<int>(out.positions.size()));
            if (isNew) {
                out.positions.push_back(body.positions[at(p)]);
                out.normals.push_back(body.normals[at(n)]);
            }
            triangle[k] = it->second;
        }
        out.triangles.push_back(triangle);
    }
    return out;
}

class Writer {
  public:
    explicit Writer(const Vec3& origin) {
        json_["asset"] = {{"version", "2.0"}, {"generator", "Edgewright"}};
        json_["scene"] = 0;
        json_["scenes"] = {{{"nodes", {0}}}};
        // z up and mm to y up and metres.
        constexpr double kMetres = 0.001;
        constexpr double kHalf = 0.70710678118654752;
        json_["nodes"] = {{{"name", "Edgewright"},
                           {"rotation", {-kHalf, 0.0, 0.0, kHalf}},
                           {"scale", {kMetres, kMetres, kMetres}},
                           {"children", ordered_json::array()}}};
        if (!origin.isZero(0.0)) {
            const Vec3 metres = kMetres * origin;
            json_["nodes"][0]["translation"] = {metres.x(), metres.z(), -metres.y()};
        }
        for (const char* list : {"meshes", "materials", "accessors", "bufferViews"}) {
            json_[list] = ordered_json::array();
        }
    }

    void addBody(const TriangleMeshView& body) {
        SplitMesh mesh = splitMesh(body);
        Extent extent;
        extent.add(mesh.positions);
        const Vec3 place = fileOrigin(extent);
        for (Vec3& p : mesh.positions) p -= place;
        ordered_json primitive;
        primitive["attributes"]["POSITION"] = addPoints(mesh.positions, true);
        primitive["attributes"]["NORMAL"] = addPoints(mesh.normals, false);
        primitive["indices"] = addIndices(mesh.triangles);
        primitive["material"] = addMaterial(body.color, 0.0, 0.55);
        primitive["mode"] = kTriangles;
        addMesh(body.name, {primitive}, place);
    }

    void addLines(std::span<const PolylineView> lines) {
        ordered_json primitives = ordered_json::array();
        for (const PolylineView& line : lines) {
            if (line.points.size() < 2) continue;
            const std::vector<Vec3> points(line.points.begin(), line.points.end());
            ordered_json primitive;
            primitive["attributes"]["POSITION"] = addPoints(points, true);
            primitive["material"] = addMaterial(line.color, 0.0, 1.0);
            primitive["mode"] = kLineStrip;
            primitives.push_back(primitive);
        }
        if (!primitives.empty()) addMesh("strokes", primitives);
    }

    Result<std::string> take() {
        json_["buffers"] = {{{"byteLength", bin_.size()}}};
        std::string text;
        try {
            text = json_.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
        } catch (const nlohmann::json::exception&) {
            return fail(Errc::Internal, "The file's description could not be written.");
        }
        text.resize((text.size() + 3) / 4 * 4, ' ');
        bin_.resize((bin_.size() + 3) / 4 * 4, '\0');
        const std::size_t total = 12 + 8 + text.size() + 8 + bin_.size();
        if (total > std::numeric_limits<std::uint32_t>::max()) {
            return fail(Errc::BadValue, "The surface is too large for a glTF file of 4 GiB.");
        }
        std::string out;
        out.reserve(total);
        appendLittleEndian(out, std::uint32_t{0x46546C67});  // "glTF"
        appendLittleEndian(out, std::uint32_t{2});
        appendLittleEndian(out, static_cast<std::uint32_t>(total));
        appendLittleEndian(out, static_cast<std::uint32_t>(text.size()));
        appendLittleEndian(out, std::uint32_t{0x4E4F534A});  // "JSON"
        out += text;
        appendLittleEndian(out, static_cast<std::uint32_t>(bin_.size()));
        appendLittleEndian(out, std::uint32_t{0x004E4942});  // "BIN"
        out += bin_;
        return out;
    }

  private:
    int addAccessor(int target, ordered_json accessor, std::size_t from) {
        json_["bufferViews"].push_back({{"buffer", 0},
                                        {"byteOffset", from},
                                        {"byteLength", bin_.size() - from},
                                        {"target", target}});
        accessor["bufferView"] = json_["bufferViews"].size() - 1;
        json_["accessors"].push_back(std::move(accessor));
        return static_cast<int>(json_["accessors"].size()) - 1;
    }

    int addPoints(const std::vector<Vec3>& points, bool withBounds) {
        const std::size_t from = bin_.size();
        Eigen::Vector3f low = points[0].cast<float>();
        Eigen::Vector3f high = low;
        for (const Vec3& p : points) {
            const Eigen::Vector3f f = p.cast<float>();
            low = low.cwiseMin(f);
            high = high.cwiseMax(f);
            for (int k = 0; k < 3; ++k) appendLittleEndian(bin_, f[k]);
        }
        ordered_json accessor{
            {"componentType", kFloat}, {"count", points.size()}, {"type", "VEC3"}};
        if (withBounds) {
            accessor["min"] = {low.x(), low.y(), low.z()};
            accessor["max"] = {high.x(), high.y(), high.z()};
        }
        return addAccessor(kArrayBuffer, std::move(accessor), from);
    }

    int addIndices(const std::vector<std::array<int, 3>>& triangles) {
        const std::size_t from = bin_.size();
        for (const auto& t : triangles) {
            for (const int i : t) appendLittleEndian(bin_, static_cast<std::uint32_t>(i));
        }
        return addAccessor(
            kElementArrayBuffer,
            {{"componentType", kUnsignedInt}, {"count", 3 * triangles.size()}, {"type", "SCALAR"}},
            from);
    }

    int addMaterial(const std::array<double, 3>& color, double metallic, double roughness) {
        const ordered_json material{{"pbrMetallicRoughness",
                                     {{"baseColorFactor", {color[0], color[1], color[2], 1.0}},
                                      {"metallicFactor", metallic},
                                      {"roughnessFactor", roughness}}}};
        auto& all = json_["materials"];
        const auto it = std::find(all.begin(), all.end(), material);
        if (it != all.end()) return static_cast<int>(it - all.begin());
        all.push_back(material);
        return static_cast<int>(all.size()) - 1;
    }

    void addMesh(const std::string& name, const ordered_json& primitives,
                 const Vec3& place = Vec3::Zero()) {
        ordered_json list = primitives.is_array() ? primitives : ordered_json::array({primitives});
        json_["meshes"].push_back({{"name", name}, {"primitives", std::move(list)}});
        json_["nodes"][0]["children"].push_back(json_["nodes"].size());
        json_["nodes"].push_back({{"name", name}, {"mesh", json_["meshes"].size() - 1}});
        if (!place.isZero(0.0)) {
            json_["nodes"].back()["translation"] = {place.x(), place.y(), place.z()};
        }
    }

    ordered_json json_;
    std::string bin_;
};

Unexpected<Error> badMesh(const TriangleMeshView& body, const std::string& why) {
    return fail(Errc::BadValue, "The mesh " + body.name + " cannot be written: " + why + ".");
}

Result<void> checkIndices(const TriangleMeshView& body) {
    const auto inside = [](std::span<const std::array<int, 3>> triangles, std::size_t count) {
        return std::all_of(triangles.begin(), triangles.end(), [&](const auto& t) {
            return std::all_of(t.begin(), t.end(), [&](int i) { return i >= 0 && at(i) < count; });
        });
    };
    if (!inside(body.triangles, body.positions.size())) {
        return badMesh(body, "a triangle has no such corner");
    }
    if (body.normals.empty()) return {};
    if (body.normalTriangles.empty() && body.normals.size() != body.positions.size()) {
        return badMesh(body, "there is not one normal for each point");
    }
    if (!body.normalTriangles.empty() && (body.normalTriangles.size() != body.triangles.size() ||
                                          !inside(body.normalTriangles, body.normals.size()))) {
        return badMesh(body, "a triangle has no such normal");
    }
    return {};
}

}  // namespace

Result<void> checkMeshes(std::span<const TriangleMeshView> bodies) {
    const bool empty = std::all_of(bodies.begin(), bodies.end(),
                                   [](const auto& body) { return body.triangles.empty(); });
    if (empty) return fail(Errc::NoSolid, "There is nothing to export yet.");
    for (const TriangleMeshView& body : bodies) {
        if (!std::all_of(body.positions.begin(), body.positions.end(), fitsFloat)) {
            return badMesh(body, "a point lies too far out or is not a number");
        }
        if (!std::all_of(body.normals.begin(), body.normals.end(), fitsFloat)) {
            return badMesh(body, "a normal is not a number");
        }
        if (auto ok = checkIndices(body); !ok) return ok;
    }
    return {};
}

Result<std::string> gltfBytes(std::span<const TriangleMeshView> bodies,
                              std::span<const PolylineView> lines, const Vec3& origin) {
    if (auto ok = checkMeshes(bodies); !ok) return fail(ok.error());
    for (const PolylineView& line : lines) {
        if (std::all_of(line.points.begin(), line.points.end(), fitsFloat)) continue;
        return fail(Errc::BadValue, "A line on the surface lies too far out or is not a number.");
    }
    Writer writer(origin);
    for (const TriangleMeshView& body : bodies) {
        if (!body.triangles.empty()) writer.addBody(body);
    }
    writer.addLines(lines);
    return writer.take();
}

}  // namespace ew
