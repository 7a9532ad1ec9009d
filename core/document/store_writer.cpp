// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <unordered_map>

#include "core/document/json_text.h"
#include "core/document/recorder.h"
#include "core/document/sketch_script_json.h"
#include "core/document/store.h"
#include "core/document/store_surface.h"
#include "core/tlib/template_io.h"

namespace ew {

namespace {

/// Texts that are written once and referred to by their index.
class Table {
  public:
    int index(const std::string& text) {
        const auto [it, isNew] = indices_.try_emplace(text, static_cast<int>(texts_.size()));
        if (isNew) texts_.push_back(text);
        return it->second;
    }
    std::string list() const {
        std::string out = "[";
        for (const std::string& text : texts_) {
            out += out.size() > 1 ? ",\n    " : "\n    ";
            out += text;
        }
        return out + "]";
    }

  private:
    std::map<std::string, int> indices_;
    std::vector<std::string> texts_;
};

/// A comma before every item but the first of a list.
void separate(std::string& list) {
    if (list.size() > 1) list += ", ";
}

std::string numbers(const double* begin, const double* end) {
    std::string out = "[";
    for (const double* p = begin; p != end; ++p) {
        separate(out);
        out += numberText(*p);
    }
    return out + "]";
}

std::string fullCamera(const OrthographicCamera& c) {
    CameraStep all;
    all.direction = c.direction;
    all.up = c.up;
    all.center = c.center;
    all.worldPerPixel = c.worldPerPixel;
    all.viewport = Vec2(c.width, c.height);
    return "{" + cameraJson(all) + "}";
}

class DocumentWriter {
  public:
    std::string write(const DocumentFile& file);

  private:
    int solid(const Solid& s) {
        // Snapshots share their solids, so most are known by address without serializing.
        const auto [it, isNew] = solidIndex_.try_emplace(&s.impl(), -1);
        if (isNew) it->second = solids_.index(jsonQuoted(s.serialize()));
        return it->second;
    }

    int stroke(const PendingStroke& s) {
        const auto [it, isNew] = strokeIndex_.try_emplace(s.id, strokeIndex_.size());
        if (isNew) {
            std::string text = "{\"id\": " + std::to_string(s.id) + ", \"camera\": " +
                               std::to_string(cameras_.index(fullCamera(s.camera))) +
                               ", \"samples\": [";
            bool first = true;
            for (const PenSample& p : s.stroke.samples) {
                if (!first) text += ',';
                first = false;
                text += numberText(p.position.x()) + ',' + numberText(p.position.y()) + ',' +
                        numberText(p.pressure) + ',' + numberText(p.timeMs);
            }
            strokes_ += strokes_.size() > 1 ? ",\n    " : "\n    ";
            strokes_ += text + "]}";
        }
        return static_cast<int>(it->second);
    }

    std::string strokeList(const std::vector<PendingStroke>& strokes) {
        std::string out = "[";
        for (const PendingStroke& s : strokes) {
            separate(out);
            out += std::to_string(stroke(s));
        }
        return out + "]";
    }

    std::string mapped(const std::vector<MappedStroke>& strokes) {
        std::string out = "[";
        for (const MappedStroke& s : strokes) {
            separate(out);
            const int index = stroke({s.id, s.stroke, s.camera});
            out += "{\"stroke\": " + std::to_string(index) +
                   ", \"color\": " + jsonQuoted(colorText(s.color)) + "}";
        }
        return out + "]";
    }

    std::string state(const DocumentState& s) {
        std::string bodies = "[";
        for (const Body& b : s.bodies) {
            separate(bodies);
            const Mat3 rows = b.pose.rotation.transpose();  // column-major data, written by rows
            bodies += "{\"solid\": " + std::to_string(solid(b.solid)) +
                      ", \"rotation\": " + numbers(rows.data(), rows.data() + 9) +
                      ", \"translation\": " + vecText(b.pose.translation) + "}";
        }
        std::string templates = "[";
        for (const std::string& id : s.addedTemplates) {
            separate(templates);
            const Template& tmpl = s.library.at(static_cast<std::size_t>(s.library.find(id)));
            templates += std::to_string(
                templates_.index(nlohmann::ordered_json::parse(writeTemplate(tmpl)).dump()));
        }
        std::string out = "{\"bodies\": " + bodies + "], \"templates\": " + templates + "]";
        if (s.surface != SurfaceSettings{}) out += ", \"surface\": " + surfaceText(s.surface);
        if (!s.mapped.empty()) out += ", \"mapped\": " + mapped(s.mapped);
        return out + "}";
    }

    Table solids_;
    Table cameras_;
    Table templates_;
    std::string strokes_ = "[";
    std::unordered_map<const Solid::Impl*, int> solidIndex_;
    std::map<int, std::size_t> strokeIndex_;
};

std::string DocumentWriter::write(const DocumentFile& file) {
    // States and history first: they fill the tables, which come first in the file.
    std::string states = "[";
    for (const auto& s : file.states) {
        states += states.size() > 1 ? ",\n    " : "\n    ";
        states += state(*s);
    }
    std::string history = "[";
    for (const StoredCommand& c : file.commands) {
        history += history.size() > 1 ? ",\n    " : "\n    ";
        history += "{\"name\": " + jsonQuoted(c.name) + ", \"strokes\": " + strokeList(c.consumed);
        if (!c.left.empty()) history += ", \"left\": " + strokeList(c.left);
        history += "}";
    }
    const std::string pending = strokeList(file.pending);

    std::string out = "{\n  \"format\": \"edgewright-document\",\n  \"version\": 1,\n";
    out += "  \"camera\": " + fullCamera(file.camera) + ",\n";
    out += "  \"thresholds\": {\"distance_px\": " + numberText(file.thresholds.distancePx) +
           ", \"angle_deg\": " + numberText(file.thresholds.angleDeg) + "},\n";
    out += "  \"oblique_factor\": " + numberText(file.obliqueFactor) + ",\n";
    out += "  \"templates\": " + templates_.list() + ",\n";
    out += "  \"solids\": " + solids_.list() + ",\n";
    out += "  \"cameras\": " + cameras_.list() + ",\n";
    out += "  \"strokes\": " + strokes_ + "],\n";
    out += "  \"states\": " + states + "],\n";
    out += "  \"history\": " + history + "],\n";
    out += "  \"index\": " + std::to_string(file.index) + ",\n";
    out += "  \"pending\": " + pending + ",\n";
    out += "  \"next_stroke\": " + std::to_string(file.nextStrokeId) + ",\n";
    out += "  \"script\": " + writeSketchScript(file.script) + "}\n";
    return out;
}

}  // namespace

std::string writeDocument(const DocumentFile& file) { return DocumentWriter().write(file); }

}  // namespace ew
