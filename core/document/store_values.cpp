// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store_values.h"

#include <algorithm>
#include <limits>

#include "core/base/tolerance.h"
#include "core/document/sketch_script_json.h"

namespace ew {

using nlohmann::json;

std::string itemPlace(const std::string& list, std::size_t i) {
    return list + "/" + std::to_string(i);
}

void separate(std::string& list) {
    if (list.size() > 1) list += ", ";
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

OrthographicCamera fullCameraFromJson(const json& value, const std::string& place) {
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

std::string poseText(const Pose& pose) {
    const Mat3 rows = pose.rotation.transpose();  // column-major data, written by rows
    std::string rotation = "[";
    for (const double* p = rows.data(); p != rows.data() + rows.size(); ++p) {
        separate(rotation);
        rotation += numberText(*p);
    }
    return "\"rotation\": " + rotation + "], \"translation\": " + vecText(pose.translation);
}

Pose poseFromJson(const ObjectReader& body) {
    Pose pose;
    const std::string place = body.at("rotation");
    const json::array_t& rows = readArray(body.require("rotation"), place);
    if (rows.size() != 9) throwRead(Errc::BadValue, place + " must be a list of 9 numbers");
    for (std::size_t i = 0; i < 9; ++i) {
        pose.rotation(static_cast<int>(i / 3), static_cast<int>(i % 3)) =
            readNumber(rows[i], itemPlace(place, i));
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

void checkSamples(const Stroke& stroke, const std::string& place) {
    for (const PenSample& s : stroke.samples) {
        if (!(s.pressure >= 0 && s.pressure <= 1)) {
            throwRead(Errc::BadValue, place + ": the pressure must be from 0 to 1");
        }
        if (!std::isfinite(s.timeMs)) {
            throwRead(Errc::BadValue, place + ": the time must be a finite number");
        }
    }
    if (auto ok = validateStroke(stroke); !ok) {
        throwRead(ok.error().code, place + ": " + ok.error().message);
    }
}

std::vector<int> idsFromJson(const json& value, const std::string& place) {
    std::vector<int> ids;
    const json::array_t& list = readArray(value, place);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const int least = ids.empty() ? 0 : ids.back() + 1;
        ids.push_back(
            readInt(list[i], itemPlace(place, i), least, std::numeric_limits<int>::max() - 1));
    }
    return ids;
}

std::string idsText(const std::vector<int>& ids) {
    std::string out = "[";
    for (const int id : ids) out.append(out.size() > 1 ? "," : "").append(std::to_string(id));
    return out + "]";
}

// StoredLibraries --------------------------------------------------------------------------------

namespace {

bool isAmong(const std::vector<Template>& templates, const std::string& id) {
    return std::any_of(templates.begin(), templates.end(),
                       [&](const Template& t) { return t.id == id; });
}

/// The shipped templates without those that the document defines itself, and with those that it
/// used and that are not there.
TemplateLibrary baseLibrary(const TemplateLibrary& shipped, const std::vector<Template>& own,
                            const std::vector<Template>& used) {
    std::vector<Template> kept;
    for (std::size_t i = 0; i < shipped.size(); ++i) {
        if (!isAmong(own, shipped.at(i).id)) kept.push_back(shipped.at(i));
    }
    const bool takesAway = kept.size() != shipped.size();
    std::vector<Template> more;
    for (const Template& t : used) {
        const bool known = shipped.find(t.id) >= 0 || isAmong(own, t.id) || isAmong(more, t.id);
        if (!known) more.push_back(t);
    }
    if (!takesAway && more.empty()) return shipped;
    auto library =
        takesAway ? TemplateLibrary().withAll(std::move(kept)) : Result<TemplateLibrary>(shipped);
    if (library && !more.empty()) library = library->withAll(std::move(more));
    if (!library) throw ReadError{std::move(library).error()};
    return *std::move(library);
}

}  // namespace

StoredLibraries::StoredLibraries(const TemplateLibrary& shipped, std::vector<Template> own,
                                 const std::vector<Template>& used)
    : own_(std::move(own)), base_(baseLibrary(shipped, own_, used)) {}

const TemplateLibrary& StoredLibraries::with(const std::vector<int>& added,
                                             const std::string& place) {
    if (added.empty()) return base_;
    const auto known = known_.find(added);
    if (known != known_.end()) return known->second;
    // Histories add one template at a time, so that a shorter list is mostly known already.
    std::vector<int> before = added;
    const TemplateLibrary* start = nullptr;
    while (start == nullptr) {
        before.pop_back();
        const auto shorter = known_.find(before);
        if (before.empty())
            start = &base_;
        else if (shorter != known_.end())
            start = &shorter->second;
    }
    std::vector<Template> more;
    for (std::size_t i = before.size(); i < added.size(); ++i) {
        more.push_back(own_[static_cast<std::size_t>(added[i])]);
    }
    auto library = start->withAll(std::move(more));
    if (!library) throwRead(library.error().code, place + ": " + library.error().message);
    return known_.emplace(added, *std::move(library)).first->second;
}

const nlohmann::json& bodyList(const nlohmann::json& tree) {
    const auto member = tree.is_object() ? tree.find("bodies") : tree.end();
    return tree.is_object() && member != tree.end() ? *member : tree;
}

}  // namespace ew
