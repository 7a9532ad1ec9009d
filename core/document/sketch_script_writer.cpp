// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/json_text.h"
#include "core/document/sketch_script.h"
#include "core/document/sketch_script_json.h"
#include "core/tlib/template_io.h"

namespace ew {

namespace {

/// Appends `, "key": value` to an object that has a key already.
void put(std::string& out, const char* key, const std::string& value) {
    if (!out.empty()) out += ", ";
    out += '"';
    out += key;
    out += "\": ";
    out += value;
}

std::string body(const ThresholdsStep& s) {
    std::string out;
    if (s.distancePx) put(out, "distance_px", numberText(*s.distancePx));
    if (s.angleDeg) put(out, "angle_deg", numberText(*s.angleDeg));
    return out;
}

std::string body(const StrokeStep& s) {
    std::string out = "\"points\": [";
    bool first = true;
    for (const PenSample& p : s.stroke.samples) {
        if (!first) out += ", ";
        first = false;
        out += '[' + numberText(p.position.x()) + ", " + numberText(p.position.y());
        if (s.hasPressure) out += ", " + numberText(p.pressure) + ", " + numberText(p.timeMs);
        out += ']';
    }
    return out + "]";
}

std::string body(const CameraStep& s) { return cameraJson(s); }
std::string body(const EraseStep& s) { return "\"at\": " + vecText(s.at); }
std::string body(const ClearStep&) { return {}; }
std::string body(const DeleteSolidStep&) { return {}; }
std::string body(const UnmapStrokesStep&) { return {}; }

std::string body(const ApplyStep& s) {
    std::string out;
    if (s.candidate) put(out, "candidate", std::to_string(*s.candidate));
    if (!s.templateId.empty()) put(out, "template", jsonQuoted(s.templateId));
    if (s.operation != Operation::Auto)
        put(out, "operation", jsonQuoted(operationName(s.operation)));
    if (s.obliqueFactor) put(out, "oblique_factor", numberText(*s.obliqueFactor));
    if (s.keep != SplitKeep::Both) put(out, "keep", jsonQuoted(splitKeepName(s.keep)));
    if (s.level) put(out, "level", "true");
    return out;
}

std::string edgesText(const EdgeWords& s) {
    std::string edges;
    switch (s.which) {
        case EdgeWords::Which::All:
            edges = "\"all\"";
            break;
        case EdgeWords::Which::Convex:
            edges = "\"convex\"";
            break;
        case EdgeWords::Which::Concave:
            edges = "\"concave\"";
            break;
        case EdgeWords::Which::Near:
            for (std::size_t i = 0; i < s.near.size(); ++i) {
                std::string point = vecText(s.near[i]);
                const int ofBody = i < s.bodies.size() ? s.bodies[i] : -1;
                if (ofBody >= 0)
                    point.replace(point.size() - 1, 1, ", " + std::to_string(ofBody) + "]");
                edges += (edges.empty() ? "[" : ", ") + point;
            }
            edges += "]";
            break;
    }
    return edges;
}

std::string body(const SharpenStep& s) { return "\"edges\": " + edgesText(s); }

std::string body(const CreaseStep& s) {
    std::string out = "\"edges\": " + edgesText(s);
    put(out, "sharpness", s.sharpness ? numberText(*s.sharpness) : "\"auto\"");
    return out;
}

std::string body(const FilletStep& s) {
    std::string out;
    put(out, "edges", edgesText(s));
    put(out, "radius", numberText(s.radius));
    if (s.segments) put(out, "segments", std::to_string(*s.segments));
    return out;
}

std::string body(const SubdivideStep& s) {
    std::string out;
    put(out, "scheme", jsonQuoted(s.scheme));
    if (s.levels) put(out, "levels", std::to_string(*s.levels));
    if (s.tolerance) put(out, "tolerance", numberText(*s.tolerance));
    if (s.crease) put(out, "crease", numberText(*s.crease));
    if (s.sharpCorners) put(out, "corners", "\"sharp\"");
    return out;
}

std::string body(const MapStrokesStep& s) {
    std::string out;
    if (!s.color.empty()) put(out, "color", jsonQuoted(s.color));
    return out;
}

std::string body(const DefineTemplateStep& s) {
    std::string out;
    put(out, "id", jsonQuoted(s.id));
    put(out, "name", jsonQuoted(s.name));
    if (s.tmpl) {
        // One step a line: the template's own line breaks go.
        put(out, "template", nlohmann::ordered_json::parse(writeTemplate(*s.tmpl)).dump());
        if (s.replace) put(out, "replace", "true");
    } else {
        put(out, "from", "\"solid\"");
    }
    return out;
}

template <class Step>
std::string counted(const Step& s) {
    std::string out;
    if (s.ink) put(out, "of", "\"ink\"");
    if (s.count != 1) put(out, "count", std::to_string(s.count));
    return out;
}
std::string body(const UndoStep& s) { return counted(s); }
std::string body(const RedoStep& s) { return counted(s); }
std::string body(const SaveStep& s) { return "\"path\": " + jsonQuoted(s.path); }
std::string body(const OpenStep& s) { return "\"path\": " + jsonQuoted(s.path); }
std::string body(const ExportStep& s) {
    std::string text = "\"path\": " + jsonQuoted(s.path);
    if (s.faces != ExportFaces::Simple) {
        text.append(", \"faces\": \"").append(exportFacesName(s.faces)).append("\"");
    }
    if (s.unit != ExportUnit::Millimetre) {
        text.append(", \"unit\": \"").append(exportUnitName(s.unit)).append("\"");
    }
    std::string bodies;
    for (const int body : s.bodies) bodies += (bodies.empty() ? "" : ", ") + std::to_string(body);
    if (!bodies.empty()) put(text, "bodies", "[" + bodies + "]");
    return text;
}
std::string body(const NameStep& s) {
    std::string text = "\"name\": " + jsonQuoted(s.name);
    if (s.state) put(text, "state", std::to_string(*s.state));
    return text;
}
std::string body(const CompactStep&) { return {}; }

std::string bodyText(const BodyWord& word) {
    return word.index >= 0 ? std::to_string(word.index) : jsonQuoted(word.name);
}
std::string body(const PullStep& s) {
    std::string out;
    put(out, "at", vecText(s.at));
    put(out, "distance", numberText(s.distance));
    if (s.walls == PullWalls::Straight) put(out, "walls", "\"straight\"");
    if (s.body) put(out, "body", bodyText(*s.body));
    if (s.whole) put(out, "whole", "true");
    return out;
}
std::string body(const MoveBodyStep& s) {
    std::string out;
    put(out, "body", bodyText(s.body));
    const BodyMove& m = s.move;
    if (m.scale != Vec3::Ones()) put(out, "scale", vecText(m.scale));
    if (m.degrees != 0.0) {
        put(out, "rotate",
            "{\"axis\": " + vecText(m.axis) + ", \"degrees\": " + numberText(m.degrees) + "}");
    }
    if (m.mirror) {
        put(out, "mirror",
            "{\"point\": " + vecText(m.mirror->point) +
                ", \"normal\": " + vecText(m.mirror->normal) + "}");
    }
    if (m.translate != Vec3::Zero()) put(out, "translate", vecText(m.translate));
    if (m.center) put(out, "center", vecText(*m.center));
    if (m.copy) put(out, "copy", "true");
    return out;
}
std::string body(const NameBodyStep& s) {
    return "\"body\": " + bodyText(s.body) + ", \"name\": " + jsonQuoted(s.name);
}
std::string body(const ShowBodyStep& s) {
    return "\"body\": " + bodyText(s.body) + ", \"visible\": " + (s.visible ? "true" : "false");
}
std::string body(const DeleteBodyStep& s) { return "\"body\": " + bodyText(s.body); }
std::string body(const CombineBodiesStep& s) {
    return "\"body\": " + bodyText(s.body) + ", \"with\": " + bodyText(s.other) +
           ", \"how\": " + (s.kind == BooleanKind::Add ? "\"join\"" : "\"subtract\"");
}

std::string body(const MirrorPlaneStep& s) {
    if (!s.plane) return "\"off\": true";
    return "\"point\": " + vecText(s.plane->point) + ", \"normal\": " + vecText(s.plane->normal);
}

struct NameOf {
    std::string_view operator()(const CameraStep&) const { return "camera"; }
    std::string_view operator()(const ThresholdsStep&) const { return "thresholds"; }
    std::string_view operator()(const StrokeStep&) const { return "stroke"; }
    std::string_view operator()(const EraseStep&) const { return "erase"; }
    std::string_view operator()(const ClearStep&) const { return "clear"; }
    std::string_view operator()(const ApplyStep&) const { return "apply"; }
    std::string_view operator()(const FilletStep&) const { return "fillet"; }
    std::string_view operator()(const SharpenStep&) const { return "sharpen"; }
    std::string_view operator()(const CreaseStep&) const { return "crease"; }
    std::string_view operator()(const SubdivideStep&) const { return "subdivide"; }
    std::string_view operator()(const MapStrokesStep&) const { return "map_strokes"; }
    std::string_view operator()(const UnmapStrokesStep&) const { return "unmap_strokes"; }
    std::string_view operator()(const DefineTemplateStep&) const { return "define_template"; }
    std::string_view operator()(const DeleteSolidStep&) const { return "delete_solid"; }
    std::string_view operator()(const UndoStep&) const { return "undo"; }
    std::string_view operator()(const RedoStep&) const { return "redo"; }
    std::string_view operator()(const SaveStep&) const { return "save"; }
    std::string_view operator()(const OpenStep&) const { return "open"; }
    std::string_view operator()(const ExportStep&) const { return "export"; }
    std::string_view operator()(const NameStep&) const { return "name"; }
    std::string_view operator()(const CompactStep&) const { return "compact"; }
    std::string_view operator()(const PullStep&) const { return "pull"; }
    std::string_view operator()(const MoveBodyStep&) const { return "move_body"; }
    std::string_view operator()(const NameBodyStep&) const { return "name_body"; }
    std::string_view operator()(const ShowBodyStep&) const { return "show_body"; }
    std::string_view operator()(const DeleteBodyStep&) const { return "delete_body"; }
    std::string_view operator()(const CombineBodiesStep&) const { return "combine_bodies"; }
    std::string_view operator()(const MirrorPlaneStep&) const { return "mirror_plane"; }
};

}  // namespace

std::string_view splitKeepName(SplitKeep keep) {
    if (keep == SplitKeep::Both) return "both";
    return keep == SplitKeep::Larger ? "larger" : "smaller";
}

std::string_view stepName(const ScriptStep& step) { return std::visit(NameOf{}, step); }

std::string cameraJson(const CameraStep& s) {
    std::string out;
    if (s.direction) put(out, "direction", vecText(*s.direction));
    if (s.up) put(out, "up", vecText(*s.up));
    if (s.center) put(out, "center", vecText(*s.center));
    if (s.worldPerPixel) put(out, "world_per_pixel", numberText(*s.worldPerPixel));
    if (s.viewport) put(out, "viewport", vecText(*s.viewport));
    return out;
}

std::string stepJson(const ScriptStep& step) {
    std::string out = "{\"do\": \"";
    out += stepName(step);
    out += '"';
    const std::string rest = std::visit([](const auto& s) { return body(s); }, step);
    if (!rest.empty()) out += ", " + rest;
    return out + '}';
}

std::string writeSketchScript(const SketchScript& script) {
    std::string out = "{\n  \"format\": \"edgewright-sketch\",\n  \"version\": 1,\n";
    if (!script.title.empty()) out += "  \"title\": " + jsonQuoted(script.title) + ",\n";
    out += "  \"viewport\": " + vecText(Vec2(script.viewport[0], script.viewport[1])) + ",\n";
    out += "  \"thresholds\": {\"distance_px\": " + numberText(script.thresholds.distancePx) +
           ", \"angle_deg\": " + numberText(script.thresholds.angleDeg) + "},\n";
    out += "  \"steps\": [";
    bool first = true;
    for (const ScriptStep& step : script.steps) {
        out += first ? "\n    " : ",\n    ";
        first = false;
        out += stepJson(step);
    }
    out += first ? "]\n}\n" : "\n  ]\n}\n";
    return out;
}

}  // namespace ew
