// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store_surface.h"

#include "core/document/json_text.h"

namespace ew {

using nlohmann::json;

namespace {

std::string sparse(const std::vector<double>& list, double otherwise) {
    std::string out = "[";
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i] == otherwise) continue;
        if (out.size() > 1) out += ", ";
        out += "[" + std::to_string(i) + ", " + numberText(list[i]) + "]";
    }
    return out + "]";
}

/// \param check  says what is wrong with a number.
std::vector<double> readSparse(const json& value, const std::string& place, std::size_t size,
                               double otherwise, Result<void> (*check)(double)) {
    const json::array_t& items = readArray(value, place);
    std::vector<double> out(size, otherwise);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string here = place + "/" + std::to_string(i);
        const json::array_t& pair = readArray(items[i], here);
        if (pair.size() != 2) throwRead(Errc::BadValue, here + " must be an edge and a number");
        const int edge = readInt(pair[0], here + "/0", 0, static_cast<int>(size) - 1);
        const double number = readNumber(pair[1], here + "/1");
        if (auto ok = check(number); !ok) {
            throwRead(Errc::BadValue, here + "/1: " + ok.error().message);
        }
        out[static_cast<std::size_t>(edge)] = number;
    }
    return out;
}

const char* schemeName(SubdivisionScheme scheme) {
    return scheme == SubdivisionScheme::Loop ? "loop" : "catmull-clark";
}

bool readFlag(const ObjectReader& object, const char* key) {
    const json& value = object.require(key);
    if (!value.is_boolean()) throwRead(Errc::WrongType, object.at(key) + " must be true or false");
    return value.get<bool>();
}

SubdivisionSettings readSubdivision(const ObjectReader& in) {
    in.allowOnly({"on", "scheme", "levels", "tolerance", "crease", "sharp_corners"});
    SubdivisionSettings s;
    s.on = readFlag(in, "on");
    const std::string& scheme = readString(in.require("scheme"), in.at("scheme"));
    if (scheme == schemeName(SubdivisionScheme::Loop)) {
        s.scheme = SubdivisionScheme::Loop;
    } else if (scheme != schemeName(SubdivisionScheme::CatmullClark)) {
        throwRead(Errc::BadValue, in.at("scheme") + " must be catmull-clark or loop");
    }
    s.levels = readInt(in.require("levels"), in.at("levels"), 1, kMaxSubdivisionLevels);
    s.tolerance = readNumber(in.require("tolerance"), in.at("tolerance"));
    const json& crease = in.require("crease");
    if (!crease.is_null()) s.sharpness = readNumber(crease, in.at("crease"));
    s.sharpCorners = readFlag(in, "sharp_corners");
    if (auto ok = checkSubdivision(s); !ok) {
        throwRead(Errc::BadValue, in.place() + ": " + ok.error().message);
    }
    return s;
}

}  // namespace

std::string surfaceText(const SurfaceSettings& settings) {
    std::string edges = "[";
    for (const EdgeSettings& body : settings.edges) {
        if (edges.size() > 1) edges += ", ";
        edges += "{\"radii\": " + sparse(body.radii, 0.0) +
                 ", \"sharpness\": " + sparse(body.sharpness, kAutomaticSharpness) + "}";
    }
    const SubdivisionSettings& s = settings.subdivision;
    const auto flag = [](bool on) { return std::string(on ? "true" : "false"); };
    return "{\"segments\": " + std::to_string(settings.segments) + ", \"edges\": " + edges +
           "], \"subdivision\": {\"on\": " + flag(s.on) + ", \"scheme\": \"" +
           schemeName(s.scheme) + "\", \"levels\": " + std::to_string(s.levels) +
           ", \"tolerance\": " + numberText(s.tolerance) +
           ", \"crease\": " + (s.sharpness ? numberText(*s.sharpness) : "null") +
           ", \"sharp_corners\": " + flag(s.sharpCorners) + "}}";
}

SurfaceSettings surfaceFromJson(const json& value, const std::string& place,
                                const std::vector<Body>& bodies) {
    const ObjectReader in(value, place);
    in.allowOnly({"segments", "edges", "subdivision"});
    SurfaceSettings out;
    out.segments = readInt(in.require("segments"), in.at("segments"), 1, kMaxFilletSegments);
    const json::array_t& list = readArray(in.require("edges"), in.at("edges"));
    if (list.size() > bodies.size()) {
        throwRead(Errc::BadValue, in.at("edges") + " speaks of more bodies than there are");
    }
    for (std::size_t b = 0; b < list.size(); ++b) {
        const ObjectReader body(list[b], in.at("edges") + "/" + std::to_string(b));
        body.allowOnly({"radii", "sharpness"});
        if (auto ok = bodies[b].solid.load(); !ok) throwRead(ok.error().code, ok.error().message);
        const std::size_t count = bodies[b].solid.edges().size();
        EdgeSettings edges;
        edges.radii = readSparse(body.require("radii"), body.at("radii"), count, 0.0, &checkRadius);
        edges.sharpness = readSparse(body.require("sharpness"), body.at("sharpness"), count,
                                     kAutomaticSharpness, &checkSharpness);
        out.edges.push_back(std::move(edges));
    }
    const ObjectReader subdivision(in.require("subdivision"), in.at("subdivision"));
    out.subdivision = readSubdivision(subdivision);
    out.tidy();
    return out;
}

}  // namespace ew
