// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/sketch_script_surface.h"

#include <limits>

#include "core/document/surface_settings.h"

namespace ew {

using nlohmann::json;

namespace {

constexpr int kMaxInt = std::numeric_limits<int>::max();

double readPositive(const json& value, const std::string& place) {
    const double x = readNumber(value, place);
    if (!(x > 0)) throwRead(Errc::BadValue, place + " must be greater than 0");
    return x;
}

/// 0 to 10, or "auto" for nothing.
std::optional<double> readSharpness(const json& value, const std::string& place) {
    if (value.is_string()) {
        if (value.get_ref<const std::string&>() == "auto") return std::nullopt;
        throwRead(Errc::BadValue, place + " must be auto or a number from 0 to 10");
    }
    const double x = readNumber(value, place);
    if (auto ok = checkSharpness(x); !ok) {
        throwRead(Errc::BadValue, place + " must be auto or a number from 0 to 10");
    }
    return x;
}

/// [x, y, z], or [x, y, z, body].
void readPoint(const json& value, const std::string& place, EdgeWords& words) {
    const json::array_t& numbers = readArray(value, place);
    if (numbers.size() != 4) {
        words.near.push_back(readVec3(value, place));
        words.bodies.push_back(-1);
        return;
    }
    words.near.push_back(
        readVec3(json(json::array_t(numbers.begin(), numbers.begin() + 3)), place));
    words.bodies.push_back(readInt(numbers[3], place + "/3", 0, kMaxInt));
}

EdgeWords readEdges(const ObjectReader& step) {
    EdgeWords words;
    const json& edges = step.require("edges");
    if (edges.is_string()) {
        const std::string& word = edges.get_ref<const std::string&>();
        if (word == "all")
            words.which = EdgeWords::Which::All;
        else if (word == "convex")
            words.which = EdgeWords::Which::Convex;
        else if (word == "concave")
            words.which = EdgeWords::Which::Concave;
        else
            throwRead(Errc::BadValue, step.at("edges") + " must be all, convex, concave or points");
        return words;
    }
    words.which = EdgeWords::Which::Near;
    const json::array_t& points = readArray(edges, step.at("edges"));
    if (points.empty()) throwRead(Errc::BadValue, step.at("edges") + " names no edge");
    for (std::size_t i = 0; i < points.size(); ++i) {
        readPoint(points[i], step.at("edges") + "/" + std::to_string(i), words);
    }
    return words;
}

}  // namespace

ScriptStep readFilletStep(const ObjectReader& step) {
    step.allowOnly({"do", "edges", "radius", "segments"});
    FilletStep fillet;
    static_cast<EdgeWords&>(fillet) = readEdges(step);
    fillet.radius = readPositive(step.require("radius"), step.at("radius"));
    if (const json* v = step.find("segments")) {
        fillet.segments = readInt(*v, step.at("segments"), 1, kMaxInt);
    }
    return fillet;
}

ScriptStep readSharpenStep(const ObjectReader& step) {
    step.allowOnly({"do", "edges"});
    SharpenStep sharpen;
    static_cast<EdgeWords&>(sharpen) = readEdges(step);
    return sharpen;
}

ScriptStep readCreaseStep(const ObjectReader& step) {
    step.allowOnly({"do", "edges", "sharpness"});
    CreaseStep crease;
    static_cast<EdgeWords&>(crease) = readEdges(step);
    crease.sharpness = readSharpness(step.require("sharpness"), step.at("sharpness"));
    return crease;
}

ScriptStep readSubdivideStep(const ObjectReader& step) {
    step.allowOnly({"do", "scheme", "levels", "tolerance", "crease", "corners"});
    SubdivideStep subdivide;
    subdivide.scheme = readString(step.require("scheme"), step.at("scheme"));
    if (subdivide.scheme != "catmull-clark" && subdivide.scheme != "loop") {
        throwRead(Errc::BadValue, step.at("scheme") + " must be catmull-clark or loop");
    }
    if (const json* v = step.find("levels")) {
        subdivide.levels = readInt(*v, step.at("levels"), 0, kMaxSubdivisionLevels);
    }
    if (const json* v = step.find("tolerance")) {
        subdivide.tolerance = readPositive(*v, step.at("tolerance"));
    }
    if (const json* v = step.find("crease"))
        subdivide.crease = readSharpness(*v, step.at("crease"));
    if (const json* v = step.find("corners")) {
        const std::string& word = readString(*v, step.at("corners"));
        if (word != "smooth" && word != "sharp") {
            throwRead(Errc::BadValue, step.at("corners") + " must be smooth or sharp");
        }
        subdivide.sharpCorners = word == "sharp";
    }
    if (subdivide.levels && subdivide.tolerance) {
        throwRead(Errc::BadValue, step.place() + ": either \"levels\" or \"tolerance\", not both");
    }
    if (!subdivide.levels && !subdivide.tolerance) {
        throwRead(Errc::MissingKey,
                  step.place() + ": the key \"levels\" or \"tolerance\" is missing");
    }
    return subdivide;
}

ScriptStep readMapStrokesStep(const ObjectReader& step) {
    step.allowOnly({"do", "color"});
    MapStrokesStep map;
    if (const json* v = step.find("color")) {
        map.color = readString(*v, step.at("color"));
        if (!parseColor(map.color)) {
            throwRead(Errc::BadValue, step.at("color") + " must be a colour such as #1f4e9c");
        }
    }
    return map;
}

}  // namespace ew
