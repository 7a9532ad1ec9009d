// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store_schema1.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>

#include "core/document/sketch_script_json.h"
#include "core/document/store_surface.h"
#include "core/document/store_values.h"
#include "core/stroke/suited_distance.h"
#include "core/tlib/template_io.h"

namespace ew {

using nlohmann::json;

namespace {

constexpr int kMaxInt = std::numeric_limits<int>::max();

Stroke readSamples(const json& value, const std::string& place) {
    const json::array_t& numbers = readArray(value, place);
    constexpr std::size_t kPerSample = 4;
    if (numbers.size() % kPerSample != 0) {
        throwRead(Errc::BadValue, place + " must hold four numbers a sample");
    }
    Stroke stroke;
    stroke.samples.reserve(numbers.size() / kPerSample);
    for (std::size_t i = 0; i < numbers.size(); i += kPerSample) {
        PenSample s;
        s.position = {readNumber(numbers[i], place), readNumber(numbers[i + 1], place)};
        s.pressure = readNumber(numbers[i + 2], place);
        s.timeMs = readNumber(numbers[i + 3], place);
        stroke.samples.push_back(s);
    }
    checkSamples(stroke, place);
    return stroke;
}

/// The line of time of the ink as far as schema 1 tells it: each stroke was drawn, by itself,
/// before the first step that used it or left it.
class InkTimes {
  public:
    /// Those among these that were not drawn before, each as a change.
    StoredInk drawn(std::vector<int> ids) {
        std::erase_if(ids, [&](int id) { return isDrawn(id); });
        std::sort(ids.begin(), ids.end());
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
        return changes(ids);
    }
    /// The changes that drew these.
    StoredInk changes(const std::vector<int>& ids) {
        StoredInk out;
        for (const int id : ids) {
            const auto [it, isNew] = serials_.try_emplace(id, next());
            out.push_back({it->second, {id}, {}, {}});
        }
        return out;
    }
    bool isDrawn(int id) const { return serials_.contains(id); }
    int next() const { return static_cast<int>(serials_.size()); }

  private:
    std::unordered_map<int, int> serials_;
};

class DocumentReader {
  public:
    explicit DocumentReader(const TemplateLibrary& shipped) : shipped_(shipped) {}
    DocumentFile read(const json& tree);

  private:
    void readTables(const ObjectReader& file);
    void readHistory(const ObjectReader& in, DocumentFile& file);
    std::shared_ptr<const DocumentState> readState(const json& value, const std::string& place);
    std::vector<MappedStroke> readMapped(const json& value, const std::string& place);
    std::vector<int> readStrokes(const json& value, const std::string& place);

    const TemplateLibrary& shipped_;
    std::optional<StoredLibraries> libraries_;
    std::vector<Solid> solids_;
    std::vector<OrthographicCamera> cameras_;
    std::vector<PendingStroke> strokes_;
};

void DocumentReader::readTables(const ObjectReader& file) {
    const json::array_t& templates = readArray(file.require("templates"), file.at("templates"));
    std::vector<Template> own;
    for (std::size_t i = 0; i < templates.size(); ++i) {
        auto tmpl = readTemplate(templates[i].dump(), itemPlace(file.at("templates"), i));
        if (!tmpl) throw ReadError{std::move(tmpl).error()};
        own.push_back(*std::move(tmpl));
    }
    libraries_.emplace(shipped_, std::move(own));
    const json::array_t& solids = readArray(file.require("solids"), file.at("solids"));
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const std::string place = itemPlace(file.at("solids"), i);
        auto solid = Solid::deserialize(readString(solids[i], place));
        if (!solid) throwRead(solid.error().code, place + ": " + solid.error().message);
        solids_.push_back(*std::move(solid));
    }
    const json::array_t& cameras = readArray(file.require("cameras"), file.at("cameras"));
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        cameras_.push_back(fullCameraFromJson(cameras[i], itemPlace(file.at("cameras"), i)));
    }
    const json::array_t& strokes = readArray(file.require("strokes"), file.at("strokes"));
    const int cameraCount = static_cast<int>(cameras_.size());
    std::map<int, bool> idTaken;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const ObjectReader s(strokes[i], itemPlace(file.at("strokes"), i));
        s.allowOnly({"id", "camera", "samples"});
        PendingStroke stroke;
        stroke.id = readInt(s.require("id"), s.at("id"), 0, kMaxInt - 1);
        const int camera = readInt(s.require("camera"), s.at("camera"), 0, cameraCount - 1);
        stroke.camera = cameras_[static_cast<std::size_t>(camera)];
        stroke.stroke = readSamples(s.require("samples"), s.at("samples"));
        if (!idTaken.try_emplace(stroke.id, true).second) {
            throwRead(Errc::DuplicateId, s.at("id") + " is taken by an earlier stroke");
        }
        strokes_.push_back(std::move(stroke));
    }
}

std::shared_ptr<const DocumentState> DocumentReader::readState(const json& value,
                                                               const std::string& place) {
    auto state = std::make_shared<DocumentState>();
    const ObjectReader s(value, place);
    s.allowOnly({"bodies", "templates", "surface", "mapped"});
    const json::array_t& bodies = readArray(s.require("bodies"), s.at("bodies"));
    const int solidCount = static_cast<int>(solids_.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const ObjectReader body(bodies[i], itemPlace(s.at("bodies"), i));
        body.allowOnly({"solid", "rotation", "translation"});
        const int solid = readInt(body.require("solid"), body.at("solid"), 0, solidCount - 1);
        const Pose pose = poseFromJson(body);
        state->bodies.push_back({solids_[static_cast<std::size_t>(solid)], pose});
    }
    const json::array_t& list = readArray(s.require("templates"), s.at("templates"));
    const std::vector<Template>& own = libraries_->templates();
    const int templateCount = static_cast<int>(own.size());
    if (list.size() > own.size()) {
        throwRead(Errc::BadValue, s.at("templates") + " names more templates than there are");
    }
    std::vector<int> templates;
    for (std::size_t i = 0; i < list.size(); ++i) {
        templates.push_back(
            readInt(list[i], itemPlace(s.at("templates"), i), 0, templateCount - 1));
        state->addedTemplates.push_back(own[static_cast<std::size_t>(templates.back())].id);
    }
    state->library = libraries_->with(templates, place);
    if (const json* v = s.find("surface")) {
        state->surface = surfaceFromJson(*v, s.at("surface"), state->bodies);
    }
    if (const json* v = s.find("mapped")) state->mapped = readMapped(*v, s.at("mapped"));
    return state;
}

std::vector<MappedStroke> DocumentReader::readMapped(const json& value, const std::string& place) {
    std::vector<MappedStroke> mapped;
    const json::array_t& list = readArray(value, place);
    const int count = static_cast<int>(strokes_.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        const ObjectReader s(list[i], itemPlace(place, i));
        s.allowOnly({"stroke", "color"});
        const int index = readInt(s.require("stroke"), s.at("stroke"), 0, count - 1);
        const PendingStroke& stroke = strokes_[static_cast<std::size_t>(index)];
        const auto color = parseColor(readString(s.require("color"), s.at("color")));
        if (!color) throwRead(Errc::BadValue, s.at("color") + ": " + color.error().message);
        mapped.push_back({stroke.id, stroke.stroke, stroke.camera, *color});
    }
    return mapped;
}

std::vector<int> DocumentReader::readStrokes(const json& value, const std::string& place) {
    std::vector<int> strokes;
    const json::array_t& list = readArray(value, place);
    const int count = static_cast<int>(strokes_.size());
    int newest = -1;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const int index = readInt(list[i], itemPlace(place, i), 0, count - 1);
        const PendingStroke& stroke = strokes_[static_cast<std::size_t>(index)];
        if (stroke.id <= newest) {
            throwRead(Errc::BadValue, itemPlace(place, i) + " is not in the order of drawing");
        }
        newest = stroke.id;
        strokes.push_back(stroke.id);
    }
    return strokes;
}

DocumentFile DocumentReader::read(const json& tree) {
    const ObjectReader in(tree, "document");
    const std::string& format = readString(in.require("format"), in.at("format"));
    if (format != "edgewright-document") {
        throwRead(Errc::WrongFormat,
                  "this is not an Edgewright document (its format is " + nameQuoted(format) + ")");
    }
    const json& version = in.require("version");
    if (!version.is_number_integer()) {
        throwRead(Errc::WrongType, in.at("version") + " must be a whole number");
    }
    if (version != 1) {
        throwRead(Errc::WrongVersion,
                  "version " + version.dump() + " is not known; this program reads version 1");
    }
    in.allowOnly({"format", "version", "camera", "thresholds", "oblique_factor", "templates",
                  "solids", "cameras", "strokes", "states", "history", "index", "pending",
                  "next_stroke", "script"});
    DocumentFile file;
    file.view.camera = fullCameraFromJson(in.require("camera"), in.at("camera"));
    const json& thresholds = in.require("thresholds");
    file.view.thresholds =
        withStep(Thresholds{}, thresholdsFromJson(thresholds, in.at("thresholds")));
    file.obliqueFactor =
        obliqueFactorFromJson(in.require("oblique_factor"), in.at("oblique_factor"));
    readTables(in);
    readHistory(in, file);
    int leastNext = 0;
    for (const PendingStroke& s : strokes_) leastNext = std::max(leastNext, s.id + 1);
    file.nextStrokeId =
        readInt(in.require("next_stroke"), in.at("next_stroke"), leastNext, kMaxInt);
    const SketchScript script = scriptFromJson(in.require("script"));
    file.title = script.title;
    file.script = Recorder::fromScript(script).entries();
    // What the strokes would have told was most likely told by them.
    std::vector<Stroke> ink;
    for (const PendingStroke& s : strokes_) {
        if (std::binary_search(file.pending.begin(), file.pending.end(), s.id)) {
            ink.push_back(s.stroke);
        }
    }
    file.automaticDistance = file.view.thresholds.distancePx == suitedDistancePx(ink);
    file.strokes = std::move(strokes_);
    return file;
}

void DocumentReader::readHistory(const ObjectReader& in, DocumentFile& file) {
    const json::array_t& states = readArray(in.require("states"), in.at("states"));
    const json::array_t& history = readArray(in.require("history"), in.at("history"));
    if (states.size() != history.size() + 1) {
        throwRead(Errc::BadValue, in.at("states") + " must be one more than the history has steps");
    }
    const auto state = [&](std::size_t i) {
        return readState(states[i], itemPlace(in.at("states"), i));
    };
    file.first = state(0);
    file.index = readInt(in.require("index"), in.at("index"), 0, static_cast<int>(history.size()));
    file.pending = readStrokes(in.require("pending"), in.at("pending"));
    InkTimes times;
    std::vector<int> waiting = file.pending;
    for (std::size_t i = 0; i < history.size(); ++i) {
        const ObjectReader step(history[i], itemPlace(in.at("history"), i));
        step.allowOnly({"name", "strokes", "left"});
        StoredCommand command;
        command.name = readString(step.require("name"), step.at("name"));
        command.consumed = readStrokes(step.require("strokes"), step.at("strokes"));
        std::vector<int> before = command.consumed;
        if (const json* v = step.find("left")) {
            const std::vector<int> left = readStrokes(*v, step.at("left"));
            before.insert(before.end(), left.begin(), left.end());
        }
        command.inkBefore = times.drawn(std::move(before));
        command.after = state(i + 1);
        const bool isDone = static_cast<int>(i) < file.index;
        if (isDone) std::erase_if(waiting, [&](int id) { return times.isDrawn(id); });
        file.commands.push_back(std::move(command));
    }
    file.inkDone = times.changes(waiting);
    file.nextInkSerial = times.next();
}

}  // namespace

Result<DocumentFile> readSchema1(std::string_view text, const TemplateLibrary& shipped) {
    constexpr std::size_t kMaxTree = std::size_t{3} << 30U;
    auto tree = parseJson(text, {.maxBytes = kMaxSchema1Bytes, .maxTreeBytes = kMaxTree});
    if (!tree) return fail(tree.error());
    try {
        return DocumentReader(shipped).read(*tree);
    } catch (ReadError& e) {
        return fail(std::move(e.error));
    }
}

}  // namespace ew
