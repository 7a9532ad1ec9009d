// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <map>

#include "core/base/tolerance.h"
#include "core/document/json_text.h"
#include "core/document/recorder.h"
#include "core/document/sketch_script_json.h"
#include "core/document/store.h"
#include "core/document/store_surface.h"
#include "core/tlib/template_io.h"

namespace ew {

using nlohmann::json;

namespace {

constexpr int kMaxInt = std::numeric_limits<int>::max();

std::string item(const std::string& list, std::size_t i) { return list + "/" + std::to_string(i); }

OrthographicCamera readCamera(const json& value, const std::string& place) {
    const CameraStep step = cameraFromJson(value, place);
    if (!step.direction || !step.up || !step.center || !step.worldPerPixel || !step.viewport) {
        throwRead(Errc::MissingKey, place + ": a camera needs all of its keys");
    }
    const OrthographicCamera camera = withStep(OrthographicCamera{}, step);
    if (auto ok = camera.validate(); !ok) {
        throwRead(Errc::BadValue, place + ": " + ok.error().message);
    }
    return camera;
}

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
        if (!(s.pressure >= 0 && s.pressure <= 1)) {
            throwRead(Errc::BadValue, place + ": the pressure must be from 0 to 1");
        }
        stroke.samples.push_back(s);
    }
    if (auto ok = validateStroke(stroke); !ok) {
        throwRead(ok.error().code, place + ": " + ok.error().message);
    }
    return stroke;
}

Pose readPose(const ObjectReader& body) {
    Pose pose;
    const std::string place = body.at("rotation");
    const json::array_t& rows = readArray(body.require("rotation"), place);
    if (rows.size() != 9) throwRead(Errc::BadValue, place + " must be a list of 9 numbers");
    for (std::size_t i = 0; i < 9; ++i) {
        pose.rotation(static_cast<int>(i / 3), static_cast<int>(i % 3)) =
            readNumber(rows[i], item(place, i));
    }
    const Mat3 shouldBeOne = pose.rotation * pose.rotation.transpose();
    // Written so that an overflow to infinity or NaN fails too.
    if (!((shouldBeOne - Mat3::Identity()).cwiseAbs().maxCoeff() <= tol::kRotation) ||
        pose.rotation.determinant() < 0) {
        throwRead(Errc::BadValue, place + " is no rotation");
    }
    pose.translation = readVec3(body.require("translation"), body.at("translation"));
    if (pose.translation.cwiseAbs().maxCoeff() > kMaxCenterMm) {
        throwRead(Errc::BadValue, body.at("translation") + " is too far away");
    }
    return pose;
}

class DocumentReader {
  public:
    explicit DocumentReader(const TemplateLibrary& shipped) : shipped_(shipped) {}
    DocumentFile read(const json& tree);

  private:
    void readTables(const ObjectReader& file);
    std::shared_ptr<const DocumentState> readState(const json& value, const std::string& place);
    const TemplateLibrary& libraryFor(const std::vector<int>& templates, const std::string& place);
    std::vector<MappedStroke> readMapped(const json& value, const std::string& place);
    std::vector<PendingStroke> readStrokes(const json& value, const std::string& place);

    const TemplateLibrary& shipped_;
    TemplateLibrary base_;  ///< shipped, without those whose ids the document has taken
    std::vector<Template> templates_;
    std::vector<Solid> solids_;
    std::vector<OrthographicCamera> cameras_;
    std::vector<PendingStroke> strokes_;
    std::map<std::vector<int>, TemplateLibrary> libraries_;
};

void DocumentReader::readTables(const ObjectReader& file) {
    const json::array_t& templates = readArray(file.require("templates"), file.at("templates"));
    for (std::size_t i = 0; i < templates.size(); ++i) {
        auto tmpl = readTemplate(templates[i].dump(), item(file.at("templates"), i));
        if (!tmpl) throw ReadError{std::move(tmpl).error()};
        templates_.push_back(*std::move(tmpl));
    }
    const json::array_t& solids = readArray(file.require("solids"), file.at("solids"));
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const std::string place = item(file.at("solids"), i);
        auto solid = Solid::deserialize(readString(solids[i], place));
        if (!solid) throwRead(solid.error().code, place + ": " + solid.error().message);
        solids_.push_back(*std::move(solid));
    }
    const json::array_t& cameras = readArray(file.require("cameras"), file.at("cameras"));
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        cameras_.push_back(readCamera(cameras[i], item(file.at("cameras"), i)));
    }
    const json::array_t& strokes = readArray(file.require("strokes"), file.at("strokes"));
    const int cameraCount = static_cast<int>(cameras_.size());
    std::map<int, bool> idTaken;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const ObjectReader s(strokes[i], item(file.at("strokes"), i));
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

const TemplateLibrary& DocumentReader::libraryFor(const std::vector<int>& templates,
                                                  const std::string& place) {
    if (templates.empty()) return base_;
    const auto known = libraries_.find(templates);
    if (known != libraries_.end()) return known->second;
    // Histories add one template at a time, so that a shorter list is mostly known already.
    std::vector<int> before = templates;
    const TemplateLibrary* start = nullptr;
    while (start == nullptr) {
        before.pop_back();
        const auto shorter = libraries_.find(before);
        if (before.empty())
            start = &base_;
        else if (shorter != libraries_.end())
            start = &shorter->second;
    }
    std::vector<Template> more;
    for (std::size_t i = before.size(); i < templates.size(); ++i) {
        more.push_back(templates_[static_cast<std::size_t>(templates[i])]);
    }
    auto library = start->withAll(std::move(more));
    if (!library) throwRead(library.error().code, place + ": " + library.error().message);
    return libraries_.emplace(templates, *std::move(library)).first->second;
}

std::shared_ptr<const DocumentState> DocumentReader::readState(const json& value,
                                                               const std::string& place) {
    auto state = std::make_shared<DocumentState>();
    const ObjectReader s(value, place);
    s.allowOnly({"bodies", "templates", "surface", "mapped"});
    const json::array_t& bodies = readArray(s.require("bodies"), s.at("bodies"));
    const int solidCount = static_cast<int>(solids_.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const ObjectReader body(bodies[i], item(s.at("bodies"), i));
        body.allowOnly({"solid", "rotation", "translation"});
        const int solid = readInt(body.require("solid"), body.at("solid"), 0, solidCount - 1);
        const Pose pose = readPose(body);
        state->bodies.push_back({solids_[static_cast<std::size_t>(solid)], pose});
    }
    const json::array_t& list = readArray(s.require("templates"), s.at("templates"));
    const int templateCount = static_cast<int>(templates_.size());
    if (list.size() > templates_.size()) {
        throwRead(Errc::BadValue, s.at("templates") + " names more templates than there are");
    }
    std::vector<int> templates;
    for (std::size_t i = 0; i < list.size(); ++i) {
        templates.push_back(readInt(list[i], item(s.at("templates"), i), 0, templateCount - 1));
        state->addedTemplates.push_back(templates_[static_cast<std::size_t>(templates.back())].id);
    }
    state->library = libraryFor(templates, place);
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
        const ObjectReader s(list[i], item(place, i));
        s.allowOnly({"stroke", "color"});
        const int index = readInt(s.require("stroke"), s.at("stroke"), 0, count - 1);
        const PendingStroke& stroke = strokes_[static_cast<std::size_t>(index)];
        const auto color = parseColor(readString(s.require("color"), s.at("color")));
        if (!color) throwRead(Errc::BadValue, s.at("color") + ": " + color.error().message);
        mapped.push_back({stroke.id, stroke.stroke, stroke.camera, *color});
    }
    return mapped;
}

std::vector<PendingStroke> DocumentReader::readStrokes(const json& value,
                                                       const std::string& place) {
    std::vector<PendingStroke> strokes;
    const json::array_t& list = readArray(value, place);
    const int count = static_cast<int>(strokes_.size());
    int newest = -1;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const int index = readInt(list[i], item(place, i), 0, count - 1);
        const PendingStroke& stroke = strokes_[static_cast<std::size_t>(index)];
        if (stroke.id <= newest) {
            throwRead(Errc::BadValue, item(place, i) + " is not in the order of drawing");
        }
        newest = stroke.id;
        strokes.push_back(stroke);
    }
    return strokes;
}

/// The shipped templates without those that the document defines itself.
TemplateLibrary withoutTaken(const TemplateLibrary& shipped, const std::vector<Template>& own) {
    const auto isTaken = [&](const std::string& id) {
        return std::any_of(own.begin(), own.end(), [&](const Template& t) { return t.id == id; });
    };
    std::vector<Template> kept;
    for (std::size_t i = 0; i < shipped.size(); ++i) {
        if (!isTaken(shipped.at(i).id)) kept.push_back(shipped.at(i));
    }
    if (kept.size() == shipped.size()) return shipped;
    auto library = TemplateLibrary().withAll(std::move(kept));
    if (!library) throw ReadError{std::move(library).error()};
    return *std::move(library);
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
    file.camera = readCamera(in.require("camera"), in.at("camera"));
    const json& thresholds = in.require("thresholds");
    file.thresholds = withStep(Thresholds{}, thresholdsFromJson(thresholds, in.at("thresholds")));
    file.obliqueFactor =
        obliqueFactorFromJson(in.require("oblique_factor"), in.at("oblique_factor"));
    readTables(in);
    base_ = withoutTaken(shipped_, templates_);

    const json::array_t& states = readArray(in.require("states"), in.at("states"));
    for (std::size_t i = 0; i < states.size(); ++i) {
        file.states.push_back(readState(states[i], item(in.at("states"), i)));
    }
    const json::array_t& history = readArray(in.require("history"), in.at("history"));
    if (states.size() != history.size() + 1) {
        throwRead(Errc::BadValue, in.at("states") + " must be one more than the history has steps");
    }
    for (std::size_t i = 0; i < history.size(); ++i) {
        const ObjectReader step(history[i], item(in.at("history"), i));
        step.allowOnly({"name", "strokes", "left"});
        StoredCommand command;
        command.name = readString(step.require("name"), step.at("name"));
        command.consumed = readStrokes(step.require("strokes"), step.at("strokes"));
        if (const json* v = step.find("left")) command.left = readStrokes(*v, step.at("left"));
        file.commands.push_back(std::move(command));
    }
    const int steps = static_cast<int>(history.size());
    file.index = readInt(in.require("index"), in.at("index"), 0, steps);
    file.pending = readStrokes(in.require("pending"), in.at("pending"));
    int leastNext = 0;
    for (const PendingStroke& s : strokes_) leastNext = std::max(leastNext, s.id + 1);
    file.nextStrokeId =
        readInt(in.require("next_stroke"), in.at("next_stroke"), leastNext, kMaxInt);
    file.script = scriptFromJson(in.require("script"));
    return file;
}

}  // namespace

Result<DocumentFile> readDocument(std::string_view text, const TemplateLibrary& shipped) {
    constexpr std::size_t kMaxTree = std::size_t{3} << 30U;
    auto tree = parseJson(text, {.maxBytes = kMaxDocumentBytes, .maxTreeBytes = kMaxTree});
    if (!tree) return fail(tree.error());
    try {
        return DocumentReader(shipped).read(*tree);
    } catch (ReadError& e) {
        return fail(std::move(e.error));
    }
}

}  // namespace ew
