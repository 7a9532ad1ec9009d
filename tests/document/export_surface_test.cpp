// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <zip.h>

#include <QXmlStreamReader>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/document/export_3mf.h"
#include "core/document/export_gltf.h"

namespace ew::test {
namespace {

using nlohmann::json;

/// A tetrahedron with a normal at each point.
struct Shape {
    std::vector<Vec3> positions{{0, 0, 0}, {10, 0, 0}, {0, 20, 0}, {0, 0, 30.125}};
    std::vector<std::array<int, 3>> triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    std::vector<Vec3> normals;

    Shape() {
        for (const Vec3& p : positions) normals.push_back((p - Vec3(2, 4, 6)).normalized());
    }
    TriangleMeshView view(const std::string& name = "body") const {
        TriangleMeshView out;
        out.name = name;
        out.positions = positions;
        out.triangles = triangles;
        out.normals = normals;
        return out;
    }
};

template <class T>
T read(const std::string& bytes, std::size_t from) {
    T value{};
    EXPECT_LE(from + sizeof(T), bytes.size());
    std::memcpy(&value, bytes.data() + from, sizeof(T));
    return value;
}

struct Glb {
    json document;
    std::string bin;
};

Glb parse(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(read<std::uint32_t>(bytes, 4), 2U);
    EXPECT_EQ(read<std::uint32_t>(bytes, 8), bytes.size());
    const auto textSize = read<std::uint32_t>(bytes, 12);
    EXPECT_EQ(textSize % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    Glb out;
    out.document = json::parse(bytes.substr(20, textSize));
    const std::size_t chunk = 20 + textSize;
    const auto binSize = read<std::uint32_t>(bytes, chunk);
    EXPECT_EQ(binSize % 4, 0U);
    EXPECT_EQ(std::memcmp(bytes.data() + chunk + 4, "BIN\0", 4), 0);
    out.bin = bytes.substr(chunk + 8);
    EXPECT_EQ(out.bin.size(), binSize);
    return out;
}

std::vector<Vec3> points(const Glb& glb, int accessor) {
    const json& a = glb.document["accessors"][static_cast<std::size_t>(accessor)];
    EXPECT_EQ(a["componentType"], 5126);
    EXPECT_EQ(a["type"], "VEC3");
    const json& view = glb.document["bufferViews"][a["bufferView"].get<std::size_t>()];
    const auto from = view["byteOffset"].get<std::size_t>();
    EXPECT_EQ(from % 4, 0U);
    EXPECT_EQ(view["byteLength"].get<std::size_t>(), 12 * a["count"].get<std::size_t>());
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < a["count"].get<std::size_t>(); ++i) {
        Vec3 p;
        for (int k = 0; k < 3; ++k) {
            p[k] = read<float>(glb.bin, from + 12 * i + 4 * static_cast<std::size_t>(k));
        }
        out.push_back(p);
    }
    return out;
}

std::vector<std::uint32_t> indices(const Glb& glb, int accessor) {
    const json& a = glb.document["accessors"][static_cast<std::size_t>(accessor)];
    EXPECT_EQ(a["componentType"], 5125);
    const json& view = glb.document["bufferViews"][a["bufferView"].get<std::size_t>()];
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i < a["count"].get<std::size_t>(); ++i) {
        out.push_back(read<std::uint32_t>(glb.bin, view["byteOffset"].get<std::size_t>() + 4 * i));
    }
    return out;
}

double volume(const std::vector<Vec3>& p, const std::vector<std::uint32_t>& t) {
    double six = 0.0;
    for (std::size_t i = 0; i + 2 < t.size(); i += 3) {
        six += p[t[i]].dot(p[t[i + 1]].cross(p[t[i + 2]]));
    }
    return six / 6.0;
}

TEST(ExportGltf, HoldsTheMeshAsTheSpecificationAsks) {
    const Shape shape;
    const std::vector<TriangleMeshView> bodies{shape.view("Gehäuse \"1\"")};
    const std::vector<Vec3> stroke{{0, 0, 0}, {5, 5, 5}, {6, 7, 8}};
    const std::vector<PolylineView> lines{{stroke, {1, 0, 0}}};
    const auto bytes = gltfBytes(bodies, lines);
    ASSERT_TRUE(bytes);
    const Glb glb = parse(*bytes);
    const json& d = glb.document;
    EXPECT_EQ(d["asset"]["version"], "2.0");
    EXPECT_EQ(d["buffers"].size(), 1U);
    EXPECT_EQ(d["scenes"][0]["nodes"], json::array({0}));
    EXPECT_EQ(d["nodes"][0]["children"], json::array({1, 2}));
    EXPECT_EQ(d["nodes"][1]["name"], "Gehäuse \"1\"");
    const json& primitive = d["meshes"][0]["primitives"][0];
    EXPECT_EQ(primitive["mode"], 4);
    const int at = primitive["attributes"]["POSITION"];
    const auto p = points(glb, at);
    ASSERT_EQ(p.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_LT((p[i] - shape.positions[i]).norm(), 1e-5);
    const json& accessor = d["accessors"][static_cast<std::size_t>(at)];
    EXPECT_EQ(accessor["max"], json::array({10.0, 20.0, 30.125}));
    EXPECT_EQ(accessor["min"], json::array({0.0, 0.0, 0.0}));
    for (const Vec3& n : points(glb, primitive["attributes"]["NORMAL"])) {
        EXPECT_NEAR(n.norm(), 1.0, 1e-6);
    }
    EXPECT_NEAR(volume(p, indices(glb, primitive["indices"])), 10 * 20 * 30.125 / 6, 1e-2);
    EXPECT_LT(primitive["material"].get<std::size_t>(), d["materials"].size());
    const json& strip = d["meshes"][1]["primitives"][0];
    EXPECT_EQ(strip["mode"], 3);
    EXPECT_EQ(points(glb, strip["attributes"]["POSITION"]).size(), 3U);
    // z up, mm -> y up, metres: the quarter turn about x and the scale.
    const json& root = d["nodes"][0];
    const double w = root["rotation"][3];
    const double x = root["rotation"][0];
    EXPECT_NEAR(2.0 * x * w, -1.0, 1e-6);  // z goes to +y
    EXPECT_EQ(root["scale"], json::array({0.001, 0.001, 0.001}));
}

TEST(ExportGltf, RepeatsPointsThatHaveSeveralNormals) {
    const Shape shape;
    TriangleMeshView view = shape.view();
    std::vector<Vec3> normals;
    std::vector<std::array<int, 3>> normalTriangles;
    for (const auto& t : shape.triangles) {
        const auto at = [&](std::size_t k) {
            return shape.positions[static_cast<std::size_t>(t[k])];
        };
        const int n = static_cast<int>(normals.size());
        normals.push_back((at(1) - at(0)).cross(at(2) - at(0)).normalized());
        normalTriangles.push_back({n, n, n});
    }
    view.normals = normals;
    view.normalTriangles = normalTriangles;
    const auto bytes = gltfBytes({&view, 1});
    ASSERT_TRUE(bytes);
    const Glb creased = parse(*bytes);
    const json& primitive = creased.document["meshes"][0]["primitives"][0];
    EXPECT_EQ(points(creased, primitive["attributes"]["POSITION"]).size(), 12U);
    // Without normals the faces are flat, which here is the same.
    view.normals = {};
    view.normalTriangles = {};
    const auto flat = gltfBytes({&view, 1});
    ASSERT_TRUE(flat);
    const Glb plain = parse(*flat);
    const auto a = points(creased, primitive["attributes"]["NORMAL"]);
    const auto b =
        points(plain, plain.document["meshes"][0]["primitives"][0]["attributes"]["NORMAL"]);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT((a[i] - b[i]).norm(), 1e-6);
}

template <class Write>
void refusesBadMeshes(Write write) {
    const Shape shape;
    const auto code = [&](const TriangleMeshView& view) {
        const auto bytes = write(std::span<const TriangleMeshView>(&view, 1));
        return bytes ? Errc::Cancelled : bytes.error().code;
    };
    TriangleMeshView view;
    EXPECT_EQ(code(view), Errc::NoSolid);
    EXPECT_EQ(write({}).error().code, Errc::NoSolid);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e300}) {
        Shape broken = shape;
        broken.positions[2].y() = bad;
        EXPECT_EQ(code(broken.view()), Errc::BadValue);
        broken = shape;
        broken.normals[2].y() = bad;
        EXPECT_EQ(code(broken.view()), Errc::BadValue);
    }
    for (const int bad : {-1, 4, std::numeric_limits<int>::max()}) {
        Shape broken = shape;
        broken.triangles[1][2] = bad;
        EXPECT_EQ(code(broken.view()), Errc::BadValue);
    }
    Shape broken = shape;
    broken.normals.pop_back();
    EXPECT_EQ(code(broken.view()), Errc::BadValue);
    view = shape.view();
    std::vector<std::array<int, 3>> normalTriangles(4, {0, 1, 9});
    view.normalTriangles = normalTriangles;
    EXPECT_EQ(code(view), Errc::BadValue);
}

TEST(ExportGltf, RefusesBadMeshes) {
    refusesBadMeshes([](std::span<const TriangleMeshView> bodies) { return gltfBytes(bodies); });
    const Shape shape;
    const TriangleMeshView view = shape.view();
    const std::vector<Vec3> stroke{{0, 0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}};
    const PolylineView line{stroke};
    EXPECT_EQ(gltfBytes({&view, 1}, {&line, 1}).error().code, Errc::BadValue);
}

/// One file of a package; empty where there is none.
std::string unpacked(const std::string& package, const char* name) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(package.data(), package.size(), 0, &error);
    zip_t* zip = zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error);
    EXPECT_NE(zip, nullptr);
    if (zip == nullptr) return {};
    std::string out;
    zip_stat_t stat;
    if (zip_stat(zip, name, 0, &stat) == 0) {
        zip_file_t* file = zip_fopen(zip, name, 0);
        out.resize(stat.size);
        EXPECT_EQ(zip_fread(file, out.data(), out.size()), static_cast<zip_int64_t>(out.size()));
        zip_fclose(file);
    }
    zip_close(zip);
    return out;
}

TEST(Export3mf, IsAPackageWithAModelInMillimetres) {
    Shape shape;
    shape.positions[1].x() = 0.1;  // comes back to the bit
    const std::vector<TriangleMeshView> bodies{shape.view("a<b>&\"c\""), shape.view("second")};
    const auto bytes = threeMfBytes(bodies);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(bytes->substr(0, 4), std::string("PK\x03\x04"));
    EXPECT_NE(unpacked(*bytes, "[Content_Types].xml").find("3dmanufacturing-3dmodel+xml"),
              std::string::npos);
    EXPECT_NE(unpacked(*bytes, "_rels/.rels").find("/3D/3dmodel.model"), std::string::npos);
    const std::string model = unpacked(*bytes, "3D/3dmodel.model");
    QXmlStreamReader xml(QByteArray(model.data(), static_cast<qsizetype>(model.size())));
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> triangles;
    int objects = 0;
    int items = 0;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement()) continue;
        const auto value = [&](const char* name) {
            return xml.attributes().value(QLatin1String(name));
        };
        if (xml.name() == QLatin1String("model")) {
            EXPECT_EQ(value("unit").toString(), QStringLiteral("millimeter"));
        } else if (xml.name() == QLatin1String("object")) {
            if (objects++ == 0) {
                EXPECT_EQ(value("name").toString(), QStringLiteral("a<b>&\"c\""));
            }
        } else if (xml.name() == QLatin1String("item")) {
            ++items;
        } else if (xml.name() == QLatin1String("vertex") && objects == 1) {
            vertices.emplace_back(value("x").toDouble(), value("y").toDouble(),
                                  value("z").toDouble());
        } else if (xml.name() == QLatin1String("triangle") && objects == 1) {
            for (const char* corner : {"v1", "v2", "v3"})
                triangles.push_back(value(corner).toUInt());
        }
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    EXPECT_EQ(objects, 2);
    EXPECT_EQ(items, 2);
    EXPECT_EQ(vertices, shape.positions);
    ASSERT_EQ(triangles.size(), 12U);
    EXPECT_NEAR(volume(vertices, triangles), 0.1 * 20 * 30.125 / 6, 1e-9);
    EXPECT_EQ(*threeMfBytes(bodies), *bytes);
}

/// A body at a place of the world, through the nodes of a glTF file or the items of a 3MF file.
struct Placed {
    std::vector<Vec3> own;  ///< its coordinates in the file
    Vec3 place = Vec3::Zero();
};

Placed placed(const Glb& glb, std::size_t body) {
    const auto translation = [&](const json& node) -> Vec3 {
        if (!node.contains("translation")) return Vec3::Zero();
        const json& t = node["translation"];
        return {t[0].get<double>(), t[1].get<double>(), t[2].get<double>()};
    };
    const json& root = glb.document["nodes"][0];
    const json& node = glb.document["nodes"][1 + body];
    const json& primitive =
        glb.document["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
    // Of the root: metres, y up.
    const Vec3 t = 1000.0 * translation(root);
    return {points(glb, primitive["attributes"]["POSITION"]),
            Vec3(t.x(), -t.z(), t.y()) + translation(node)};
}

Placed placed(const std::string& package, int body) {
    const std::string model = unpacked(package, "3D/3dmodel.model");
    QXmlStreamReader xml(QByteArray(model.data(), static_cast<qsizetype>(model.size())));
    Placed out;
    int objects = 0;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement()) continue;
        const auto value = [&](const char* name) {
            return xml.attributes().value(QLatin1String(name));
        };
        if (xml.name() == QLatin1String("object")) ++objects;
        if (xml.name() == QLatin1String("vertex") && objects == body + 1) {
            out.own.emplace_back(value("x").toDouble(), value("y").toDouble(),
                                 value("z").toDouble());
        }
        if (xml.name() == QLatin1String("item") && value("objectid").toInt() == body + 1) {
            const auto numbers = value("transform").toString().split(' ');
            if (numbers.size() != 12) continue;
            EXPECT_EQ(numbers.mid(0, 9).join(' '), QStringLiteral("1 0 0 0 1 0 0 0 1"));
            out.place = {numbers[9].toDouble(), numbers[10].toDouble(), numbers[11].toDouble()};
        }
    }
    EXPECT_FALSE(xml.hasError());
    return out;
}

TEST(ExportPlaces, FarBodiesAreNearTheOriginOfTheFileAndPutBack) {
    const Shape shape;
    Shape far = shape;
    for (Vec3& p : far.positions) p += Vec3(-3e8, 7e8, 11);
    const std::vector<TriangleMeshView> bodies{shape.view("near"), far.view("far")};
    const Vec3 origin(1e9, -2e9, 40);
    const auto gltf = gltfBytes(bodies, {}, origin);
    const auto threeMf = threeMfBytes(bodies, origin);
    ASSERT_TRUE(gltf && threeMf);
    for (int b = 0; b < 2; ++b) {
        const auto& wanted = b == 0 ? shape.positions : far.positions;
        for (const Placed& p :
             {placed(parse(*gltf), static_cast<std::size_t>(b)), placed(*threeMf, b)}) {
            ASSERT_EQ(p.own.size(), wanted.size());
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                EXPECT_LT(p.own[i].norm(), 100.0);
                EXPECT_LT((p.own[i] + p.place - origin - wanted[i]).norm(), 1e-5);
            }
        }
    }
    // Where all is near, nothing is said.
    const auto plain = gltfBytes({bodies.data(), 1});
    EXPECT_EQ(plain->find("translation"), std::string::npos);
    EXPECT_EQ(unpacked(*threeMfBytes({bodies.data(), 1}), "3D/3dmodel.model").find("transform"),
              std::string::npos);
}

TEST(Export3mf, RefusesBadMeshes) {
    refusesBadMeshes([](std::span<const TriangleMeshView> bodies) { return threeMfBytes(bodies); });
}

}  // namespace
}  // namespace ew::test
