// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <map>

#include "core/base/tolerance.h"
#include "core/document/json_text.h"
#include "core/document/sketch_script.h"
#include "core/document/sketch_script_bodies.h"
#include "core/document/sketch_script_json.h"
#include "core/document/sketch_script_surface.h"
#include "core/tlib/template_io.h"

namespace ew {

using nlohmann::json;

namespace {

constexpr int kMaxInt = std::numeric_limits<int>::max();

double readRange(const json& value, const std::string& place, double least, double most) {
    const double x = readNumber(value, place);
    if (!(x >= least && x <= most)) {
        throwRead(Errc::BadValue,
                  place + " must be from " + numberText(least) + " to " + numberText(most));
    }
    return x;
}

Vec2 readViewport(const json& value, const std::string& place) {
    const Vec2 v = readVec2(value, place);
    if (!(v.minCoeff() >= kMinViewportPx && v.maxCoeff() <= kMaxViewportPx)) {
        throwRead(Errc::BadValue, place + " must be from " + numberText(kMinViewportPx) + " to " +
                                      numberText(kMaxViewportPx) + " pixels each way");
    }
    return v;
}

Vec3 readDirection(const json& value, const std::string& place) {
    const Vec3 v = readVec3(value, place);
    const double largest = v.cwiseAbs().maxCoeff();
    if (!(largest >= tol::kShortestDirection && largest <= 1.0 / tol::kShortestDirection)) {
        throwRead(Errc::BadValue, place + " must be a direction, not zero and not huge");
    }
    return v;
}

PenSample readSample(const json& value, const std::string& place, bool& hasPressure) {
    const json::array_t& numbers = readArray(value, place);
    if (numbers.size() != 2 && numbers.size() != 4) {
        throwRead(Errc::BadValue, place + " must be [x, y] or [x, y, pressure, time]");
    }
    for (const json& n : numbers) {
        if (!n.is_number()) throwRead(Errc::WrongType, place + " must hold numbers only");
    }
    PenSample sample;
    sample.position = {numbers[0].get<double>(), numbers[1].get<double>()};
    if (numbers.size() == 4) {
        hasPressure = true;
        sample.pressure = numbers[2].get<double>();
        sample.timeMs = numbers[3].get<double>();
        if (!(sample.pressure >= 0 && sample.pressure <= 1)) {
            throwRead(Errc::BadValue, place + ": the pressure must be from 0 to 1");
        }
    }
    return sample;
}

CameraStep readCamera(const ObjectReader& step) {
    CameraStep camera;
    if (const json* v = step.find("direction")) {
        camera.direction = readDirection(*v, step.at("direction"));
    }
    if (const json* v = step.find("up")) camera.up = readDirection(*v, step.at("up"));
    if (const json* v = step.find("center")) {
        camera.center = readVec3(*v, step.at("center"));
        if (!(camera.center->cwiseAbs().maxCoeff() <= kMaxCenterMm)) {
            throwRead(Errc::BadValue, step.at("center") + " is too far away");
        }
    }
    if (const json* v = step.find("world_per_pixel")) {
        camera.worldPerPixel =
            readRange(*v, step.at("world_per_pixel"), kMinWorldPerPixel, kMaxWorldPerPixel);
    }
    if (const json* v = step.find("viewport")) {
        camera.viewport = readViewport(*v, step.at("viewport"));
    }
    return camera;
}

ThresholdsStep readThresholds(const ObjectReader& step) {
    ThresholdsStep t;
    if (const json* v = step.find("distance_px")) {
        t.distancePx = readRange(*v, step.at("distance_px"), kMinDistancePx, kMaxDistancePx);
    }
    if (const json* v = step.find("angle_deg")) {
        t.angleDeg = readRange(*v, step.at("angle_deg"), kMinAngleDeg, kMaxAngleDeg);
    }
    return t;
}

ScriptStep readStroke(const ObjectReader& step) {
    step.allowOnly({"do", "points"});
    StrokeStep stroke;
    const json::array_t& points = readArray(step.require("points"), step.at("points"));
    stroke.stroke.samples.reserve(points.size());
    std::string place = step.at("points") + "/";
    const std::size_t stem = place.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
        place.resize(stem);
        place += std::to_string(i);
        stroke.stroke.samples.push_back(readSample(points[i], place, stroke.hasPressure));
    }
    return stroke;
}

ScriptStep readErase(const ObjectReader& step) {
    step.allowOnly({"do", "at"});
    return EraseStep{readVec2(step.require("at"), step.at("at"))};
}

ScriptStep readApply(const ObjectReader& step) {
    step.allowOnly({"do", "candidate", "template", "operation", "oblique_factor", "keep", "level"});
    ApplyStep apply;
    if (const json* v = step.find("candidate")) {
        apply.candidate = readInt(*v, step.at("candidate"), 0, kMaxInt);
    }
    if (const json* v = step.find("template")) {
        apply.templateId = readString(*v, step.at("template"));
        if (apply.templateId.empty()) {
            throwRead(Errc::BadValue, step.at("template") + " must name a template");
        }
    }
    if (const json* v = step.find("operation")) {
        const std::string& word = readString(*v, step.at("operation"));
        bool known = false;
        for (const Operation op : {Operation::Auto, Operation::Create, Operation::Add,
                                   Operation::Cut, Operation::Split}) {
            if (word != operationName(op)) continue;
            apply.operation = op;
            known = true;
        }
        if (!known) {
            throwRead(Errc::BadValue,
                      step.at("operation") + " must be auto, create, add, cut or split");
        }
    }
    if (const json* v = step.find("level")) apply.level = boolFromJson(*v, step.at("level"));
    if (const json* v = step.find("oblique_factor")) {
        apply.obliqueFactor = obliqueFactorFromJson(*v, step.at("oblique_factor"));
    }
    if (const json* v = step.find("keep")) {
        const std::string& word = readString(*v, step.at("keep"));
        bool known = false;
        for (const SplitKeep keep : {SplitKeep::Both, SplitKeep::Larger, SplitKeep::Smaller}) {
            if (word != splitKeepName(keep)) continue;
            apply.keep = keep;
            known = true;
        }
        if (!known) {
            throwRead(Errc::BadValue, step.at("keep") + " must be both, larger or smaller");
        }
    }
    return apply;
}

/// An inline template may leave out what the step says already.
Template readInlineTemplate(json object, const DefineTemplateStep& step, const std::string& place) {
    if (!object.is_object()) throwRead(Errc::WrongType, place + " must be an object");
    object.emplace("format", "edgewright-template");
    object.emplace("version", 1);
    object.emplace("id", step.id);
    object.emplace("name", step.name);
    // readTemplate is the one reader of templates; the text is small and numbers survive it.
    auto tmpl = readTemplate(object.dump(), place);
    if (!tmpl) throw ReadError{std::move(tmpl).error()};
    tmpl->id = step.id;
    tmpl->name = step.name;
    return *std::move(tmpl);
}

ScriptStep readDefineTemplate(const ObjectReader& step) {
    step.allowOnly({"do", "id", "name", "from", "template", "replace"});
    DefineTemplateStep define;
    define.id = readString(step.require("id"), step.at("id"));
    define.name = readString(step.require("name"), step.at("name"));
    const json* from = step.find("from");
    const json* tmpl = step.find("template");
    if (from != nullptr && tmpl != nullptr) {
        throwRead(Errc::BadValue, step.place() + ": either \"from\" or \"template\", not both");
    }
    if (from != nullptr) {
        if (readString(*from, step.at("from")) != "solid") {
            throwRead(Errc::BadValue, step.at("from") + " must be solid");
        }
    } else if (tmpl != nullptr) {
        define.tmpl = readInlineTemplate(*tmpl, define, step.at("template"));
        const json* replace = step.find("replace");
        define.replace = replace != nullptr && boolFromJson(*replace, step.at("replace"));
    } else {
        throwRead(Errc::MissingKey, step.place() + ": the key \"from\" or \"template\" is missing");
    }
    return define;
}

template <class Step>
ScriptStep readCounted(const ObjectReader& step) {
    step.allowOnly({"do", "count", "of"});
    Step s;
    if (const json* v = step.find("count")) s.count = readInt(*v, step.at("count"), 1, kMaxInt);
    if (const json* v = step.find("of")) {
        const std::string& of = readString(*v, step.at("of"));
        if (of != "steps" && of != "ink") {
            throwRead(Errc::BadValue, step.at("of") + " must be steps or ink");
        }
        s.ink = of == "ink";
    }
    return s;
}

std::string readPath(const ObjectReader& step) {
    std::string path = readString(step.require("path"), step.at("path"));
    if (path.empty()) throwRead(Errc::BadValue, step.at("path") + " must name a file");
    return path;
}

template <class Step>
ScriptStep readPathed(const ObjectReader& step) {
    step.allowOnly({"do", "path"});
    return Step{readPath(step)};
}

ScriptStep readExport(const ObjectReader& step) {
    step.allowOnly({"do", "path", "faces", "unit", "bodies"});
    ExportStep s;
    s.path = readPath(step);
    if (const json* v = step.find("faces")) {
        const auto faces = exportFacesFromName(readString(*v, step.at("faces")));
        if (!faces) {
            throwRead(Errc::BadValue, step.at("faces") + " must be simple, triangles or polygons");
        }
        s.faces = *faces;
    }
    if (const json* v = step.find("unit")) {
        const auto unit = exportUnitFromName(readString(*v, step.at("unit")));
        if (!unit) throwRead(Errc::BadValue, step.at("unit") + " must be mm, cm, m or inch");
        s.unit = *unit;
    }
    if (const json* v = step.find("bodies")) {
        for (const json& body : readArray(*v, step.at("bodies"))) {
            s.bodies.push_back(readInt(body, step.at("bodies"), 0, kMaxInt));
        }
        if (s.bodies.empty()) {
            throwRead(Errc::BadValue, step.at("bodies") + " must name at least one body");
        }
    }
    return s;
}

ScriptStep readName(const ObjectReader& step) {
    step.allowOnly({"do", "name", "state"});
    NameStep s{readString(step.require("name"), step.at("name")), std::nullopt};
    if (const json* v = step.find("state")) s.state = readInt(*v, step.at("state"), 0, kMaxInt);
    return s;
}

template <class Step>
ScriptStep readBare(const ObjectReader& step) {
    step.allowOnly({"do"});
    return Step{};
}

using StepReader = ScriptStep (*)(const ObjectReader&);

const std::map<std::string_view, StepReader>& stepReaders() {
    static const std::map<std::string_view, StepReader> readers{
        {"camera",
         [](const ObjectReader& s) -> ScriptStep {
             s.allowOnly({"do", "direction", "up", "center", "world_per_pixel", "viewport"});
             return readCamera(s);
         }},
        {"thresholds",
         [](const ObjectReader& s) -> ScriptStep {
             s.allowOnly({"do", "distance_px", "angle_deg"});
             return readThresholds(s);
         }},
        {"stroke", readStroke},
        {"erase", readErase},
        {"clear", readBare<ClearStep>},
        {"apply", readApply},
        {"fillet", readFilletStep},
        {"sharpen", readSharpenStep},
        {"crease", readCreaseStep},
        {"subdivide", readSubdivideStep},
        {"map_strokes", readMapStrokesStep},
        {"unmap_strokes", readBare<UnmapStrokesStep>},
        {"define_template", readDefineTemplate},
        {"delete_solid", readBare<DeleteSolidStep>},
        {"undo", readCounted<UndoStep>},
        {"redo", readCounted<RedoStep>},
        {"save", readPathed<SaveStep>},
        {"open", readPathed<OpenStep>},
        {"export", readExport},
        {"name", readName},
        {"compact", readBare<CompactStep>},
        {"pull", readPullStep},
        {"move_body", readMoveBodyStep},
        {"name_body", readNameBodyStep},
        {"show_body", readShowBodyStep},
        {"delete_body", readDeleteBodyStep},
        {"combine_bodies", readCombineBodiesStep},
        {"mirror_plane", readMirrorPlaneStep},
    };
    return readers;
}

}  // namespace

ScriptStep stepFromJson(const json& value, std::size_t index) {
    const std::string number = "step " + std::to_string(index);
    const ObjectReader unnamed(value, number);
    const std::string& word = readString(unnamed.require("do"), unnamed.at("do"));
    const auto found = stepReaders().find(word);
    if (found == stepReaders().end()) {
        throwRead(Errc::BadValue, number + ": there is no step called " + nameQuoted(word));
    }
    return found->second(ObjectReader(value, number + " (" + word + ")"));
}

bool boolFromJson(const json& value, const std::string& place) {
    if (!value.is_boolean()) throwRead(Errc::WrongType, place + " must be true or false");
    return value.get<bool>();
}

double obliqueFactorFromJson(const json& value, const std::string& place) {
    return readRange(value, place, kMinObliqueFactor, kMaxObliqueFactor);
}

CameraStep cameraFromJson(const json& value, const std::string& place) {
    const ObjectReader reader(value, place);
    reader.allowOnly({"direction", "up", "center", "world_per_pixel", "viewport"});
    return readCamera(reader);
}

ThresholdsStep thresholdsFromJson(const json& value, const std::string& place) {
    const ObjectReader reader(value, place);
    reader.allowOnly({"distance_px", "angle_deg"});
    return readThresholds(reader);
}

SketchScript scriptFromJson(const json& value) {
    const ObjectReader file(value, "script");
    const std::string& format = readString(file.require("format"), file.at("format"));
    if (format != "edgewright-sketch") {
        throwRead(Errc::WrongFormat,
                  "script: this is not a sketch script (its format is " + nameQuoted(format) + ")");
    }
    const json& version = file.require("version");
    if (!version.is_number_integer()) {
        throwRead(Errc::WrongType, file.at("version") + " must be a whole number");
    }
    if (version != 1) {
        throwRead(Errc::WrongVersion, "script: version " + version.dump() +
                                          " is not known; this program reads version 1");
    }
    file.allowOnly({"format", "version", "title", "viewport", "thresholds", "steps"});
    SketchScript script;
    if (const json* v = file.find("title")) script.title = readString(*v, file.at("title"));
    if (const json* v = file.find("viewport")) {
        const Vec2 size = readViewport(*v, file.at("viewport"));
        script.viewport = {size.x(), size.y()};
    }
    if (const json* v = file.find("thresholds")) {
        const ThresholdsStep t = thresholdsFromJson(*v, "script: thresholds");
        script.thresholds.distancePx = t.distancePx.value_or(script.thresholds.distancePx);
        script.namesDistance = t.distancePx.has_value();
        script.thresholds.angleDeg = t.angleDeg.value_or(script.thresholds.angleDeg);
    }
    const json::array_t& steps = readArray(file.require("steps"), file.at("steps"));
    if (steps.size() > kMaxScriptSteps) {
        throwRead(Errc::TooLarge,
                  "script: more than " + std::to_string(kMaxScriptSteps) + " steps");
    }
    script.steps.reserve(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
        script.steps.push_back(stepFromJson(steps[i], i));
    return script;
}

Result<ScriptStep> readScriptStep(std::string_view text) {
    auto tree = parseJson(text, JsonLimits{.maxBytes = kMaxScriptBytes});
    if (!tree) return fail(tree.error().code, "step: " + tree.error().message);
    try {
        return stepFromJson(*tree, 0);
    } catch (ReadError& e) {
        return fail(std::move(e.error));
    }
}

Result<SketchScript> readSketchScript(std::string_view text) {
    auto tree = parseJson(text, JsonLimits{.maxBytes = kMaxScriptBytes});
    if (!tree) {
        return fail(tree.error().code, "script: " + tree.error().message);
    }
    try {
        return scriptFromJson(*tree);
    } catch (ReadError& e) {
        return fail(std::move(e.error));
    }
}

}  // namespace ew
