// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/sketch_script_bodies.h"

#include <limits>

#include "core/document/sketch_script_json.h"

namespace ew {

using nlohmann::json;

namespace {

/// An index or a name.
BodyWord readBody(const ObjectReader& step, const char* key) {
    const json& value = step.require(key);
    if (value.is_string()) {
        BodyWord word{-1, value.get<std::string>()};
        if (word.name.empty()) throwRead(Errc::BadValue, step.at(key) + " must name a solid");
        return word;
    }
    return {readInt(value, step.at(key), 0, std::numeric_limits<int>::max()), {}};
}

/// One number for all directions, or one for each axis.
Vec3 readScale(const json& value, const std::string& place) {
    if (value.is_number()) return Vec3::Constant(readNumber(value, place));
    return readVec3(value, place);
}

}  // namespace

ScriptStep readPullStep(const ObjectReader& step) {
    step.allowOnly({"do", "at", "distance", "walls", "body", "whole"});
    PullStep pull;
    pull.at = readVec3(step.require("at"), step.at("at"));
    pull.distance = readNumber(step.require("distance"), step.at("distance"));
    if (const json* v = step.find("walls")) {
        const std::string& word = readString(*v, step.at("walls"));
        if (word != "follow" && word != "straight") {
            throwRead(Errc::BadValue, step.at("walls") + " must be follow or straight");
        }
        if (word == "straight") pull.walls = PullWalls::Straight;
    }
    if (step.find("body") != nullptr) pull.body = readBody(step, "body");
    if (const json* v = step.find("whole")) pull.whole = boolFromJson(*v, step.at("whole"));
    return pull;
}

ScriptStep readMoveBodyStep(const ObjectReader& step) {
    step.allowOnly({"do", "body", "scale", "rotate", "mirror", "translate", "center", "copy"});
    MoveBodyStep out;
    out.body = readBody(step, "body");
    BodyMove& m = out.move;
    if (const json* v = step.find("scale")) m.scale = readScale(*v, step.at("scale"));
    if (const json* v = step.find("rotate")) {
        const ObjectReader rotate(*v, step.at("rotate"));
        rotate.allowOnly({"axis", "degrees"});
        m.axis = readVec3(rotate.require("axis"), rotate.at("axis"));
        m.degrees = readNumber(rotate.require("degrees"), rotate.at("degrees"));
    }
    if (const json* v = step.find("mirror")) {
        const ObjectReader mirror(*v, step.at("mirror"));
        mirror.allowOnly({"point", "normal"});
        m.mirror.emplace();
        m.mirror->point = readVec3(mirror.require("point"), mirror.at("point"));
        m.mirror->normal = readVec3(mirror.require("normal"), mirror.at("normal"));
    }
    if (const json* v = step.find("translate")) m.translate = readVec3(*v, step.at("translate"));
    if (const json* v = step.find("center")) m.center = readVec3(*v, step.at("center"));
    if (const json* v = step.find("copy")) m.copy = boolFromJson(*v, step.at("copy"));
    return out;
}

ScriptStep readNameBodyStep(const ObjectReader& step) {
    step.allowOnly({"do", "body", "name"});
    return NameBodyStep{readBody(step, "body"), readString(step.require("name"), step.at("name"))};
}

ScriptStep readShowBodyStep(const ObjectReader& step) {
    step.allowOnly({"do", "body", "visible"});
    ShowBodyStep out{readBody(step, "body"), true};
    if (const json* v = step.find("visible")) out.visible = boolFromJson(*v, step.at("visible"));
    return out;
}

ScriptStep readDeleteBodyStep(const ObjectReader& step) {
    step.allowOnly({"do", "body"});
    return DeleteBodyStep{readBody(step, "body")};
}

ScriptStep readCombineBodiesStep(const ObjectReader& step) {
    step.allowOnly({"do", "body", "with", "how"});
    CombineBodiesStep out{readBody(step, "body"), readBody(step, "with"), BooleanKind::Add};
    const std::string& how = readString(step.require("how"), step.at("how"));
    if (how != "join" && how != "subtract") {
        throwRead(Errc::BadValue, step.at("how") + " must be join or subtract");
    }
    if (how == "subtract") out.kind = BooleanKind::Cut;
    return out;
}

ScriptStep readMirrorPlaneStep(const ObjectReader& step) {
    step.allowOnly({"do", "point", "normal", "off"});
    const json* off = step.find("off");
    if (off != nullptr && boolFromJson(*off, step.at("off"))) {
        if (step.find("point") != nullptr || step.find("normal") != nullptr) {
            throwRead(Errc::BadValue, step.at("off") + " and a plane exclude each other");
        }
        return MirrorPlaneStep{};
    }
    MirrorPlane plane;
    plane.point = readVec3(step.require("point"), step.at("point"));
    plane.normal = readVec3(step.require("normal"), step.at("normal"));
    auto usable = mirrorPlane(plane.point, plane.normal);
    if (!usable) throwRead(usable.error().code, step.at("normal") + ": " + usable.error().message);
    return MirrorPlaneStep{*usable};
}

}  // namespace ew
