// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store_reader.h"

#include <QByteArray>
#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <unordered_map>

#include "core/document/body_list.h"
#include "core/document/sketch_script_json.h"
#include "core/document/store_blobs.h"
#include "core/document/store_schema.h"
#include "core/document/store_solids.h"
#include "core/document/store_surface.h"
#include "core/document/store_values.h"
#include "core/tlib/template_io.h"

namespace ew {

using nlohmann::json;

namespace {

constexpr int kMaxInt = std::numeric_limits<int>::max();

/// The fields of a row, by their place. Each throws ReadError where a field is of another kind.
class Fields {
  public:
    Fields(const Table& table, const Row& row) : row_(row) {
        place_ = std::string(table.name);
        for (int i = 0; i < table.keys; ++i) {
            if (const auto* n = std::get_if<std::int64_t>(&row[static_cast<std::size_t>(i)])) {
                place_ += " " + std::to_string(*n);
            }
        }
    }
    const std::string& place() const { return place_; }

    bool isNothing(std::size_t i) const { return std::holds_alternative<std::monostate>(row_[i]); }
    std::int64_t id(std::size_t i) const { return get<std::int64_t>(i); }
    int number(std::size_t i, int least, int most) const {
        const std::int64_t n = id(i);
        if (n < least || n > most) throwRead(Errc::BadValue, place_ + ": a number is out of range");
        return static_cast<int>(n);
    }
    double real(std::size_t i) const { return get<double>(i); }
    const std::string& text(std::size_t i) const { return get<std::string>(i); }
    const std::string& bytes(std::size_t i) const { return get<Bytes>(i).data; }
    json tree(std::size_t i) const {
        auto value = parseJson(text(i), {});
        if (!value) throwRead(value.error().code, place_ + ": " + value.error().message);
        return *std::move(value);
    }

  private:
    template <class T>
    const T& get(std::size_t i) const {
        const T* value = std::get_if<T>(&row_[i]);
        if (value == nullptr) throwRead(Errc::WrongType, place_ + ": a value of another kind");
        return *value;
    }
    const Row& row_;
    std::string place_;
};

template <class Map>
const auto& known(const Map& map, std::int64_t id, const std::string& place, const char* what) {
    const auto found = map.find(id);
    if (found == map.end()) {
        throwRead(Errc::Damaged, place + ": there is no " + what + " " + std::to_string(id));
    }
    return found->second;
}

class DatabaseReader {
  public:
    DatabaseReader(Database& database, const TemplateLibrary& shipped, ReadOptions options = {})
        : db_(database), shipped_(shipped), options_(std::move(options)) {}
    DocumentFile read();
    DocumentSummary summary();

  private:
    template <class Visit>
    void each(const Table& table, const Visit& visit) {
        const auto ok = db_.each(table, [&](const Row& row) -> Result<void> {
            visit(Fields(table, row));
            return {};
        });
        if (!ok) throw ReadError{ok.error()};
    }

    void readSettings();
    json setting(const std::string& key) const;
    int settingInt(const std::string& key, int least, int most) const;
    std::string thumbnail() const;
    void readBlobs();
    std::string blob(std::int64_t id, const std::string& place) const;
    void readTemplates();
    void readStrokes();
    void readMapped();
    void readSolids();
    void readState(const Fields& row);
    std::vector<Body> readBodies(const json& list, const std::string& place);
    void readBodiesOf(const Fields& row, DocumentState& state);
    void readSteps();
    void readNames();
    void readInk();
    void readPending();
    void readScript();
    void checkRows(const char* table, std::size_t found) const;
    std::vector<int> strokeIds(const Fields& row, std::size_t column) const;

    Database& db_;
    const TemplateLibrary& shipped_;
    ReadOptions options_;
    DocumentFile file_;
    std::map<std::string, json> settings_;
    std::unordered_map<std::int64_t, PackedBlob> blobs_;
    std::unordered_map<std::int64_t, OrthographicCamera> cameras_;
    std::unordered_map<std::int64_t, std::size_t> templates_;  // index into the libraries' list
    std::unordered_map<std::int64_t, std::string> templateIds_;
    std::optional<StoredLibraries> libraries_;
    std::unordered_map<std::int64_t, std::size_t> strokes_;  // index into file_.strokes
    std::unordered_map<std::int64_t, std::vector<MappedStroke>> mapped_;
    std::unordered_map<std::int64_t, Solid> solids_;
    std::unordered_map<std::int64_t, std::shared_ptr<const DocumentState>> states_;
};

void DatabaseReader::readSettings() {
    each(schema::kSetting, [&](const Fields& row) { settings_[row.text(0)] = row.tree(1); });
}

json DatabaseReader::setting(const std::string& key) const {
    const auto found = settings_.find(key);
    if (found == settings_.end()) throwRead(Errc::Damaged, "setting " + key + " is missing");
    return found->second;
}

int DatabaseReader::settingInt(const std::string& key, int least, int most) const {
    return readInt(setting(key), "setting " + key, least, most);
}

std::string DatabaseReader::thumbnail() const {
    if (!settings_.contains("thumbnail")) return {};
    const json text = setting("thumbnail");
    const auto& base64 = readString(text, "setting thumbnail");
    return QByteArray::fromBase64(QByteArray::fromStdString(base64)).toStdString();
}

void DatabaseReader::readBlobs() {
    each(schema::kBlob, [&](const Fields& row) {
        PackedBlob& blob = blobs_[row.id(0)];
        blob.sha = row.bytes(1);
        blob.size = static_cast<std::size_t>(row.number(2, 0, kMaxInt));
        blob.packed = row.number(3, 0, 1) == 1;
        blob.data = row.bytes(4);
    });
}

std::string DatabaseReader::blob(std::int64_t id, const std::string& place) const {
    auto content = unpackBlob(known(blobs_, id, place, "blob"));
    if (!content) throwRead(content.error().code, place + ": " + content.error().message);
    return *std::move(content);
}

void DatabaseReader::readTemplates() {
    std::vector<Template> own;
    each(schema::kTemplate, [&](const Fields& row) {
        auto tmpl = readTemplate(row.text(1), row.place());
        if (!tmpl) throw ReadError{std::move(tmpl).error()};
        templates_[row.id(0)] = own.size();
        templateIds_[row.id(0)] = tmpl->id;
        own.push_back(*std::move(tmpl));
    });
    // Those that states name were added here; the others were used by steps.
    std::vector<bool> isAdded(own.size(), false);
    each(schema::kState, [&](const Fields& row) {
        const json tree = row.tree(2);
        for (const json& id : readArray(tree, row.place())) {
            const int number = readInt(id, row.place(), 1, kMaxInt);
            isAdded[known(templates_, number, row.place(), "template")] = true;
        }
    });
    std::vector<Template> added;
    std::vector<Template> used;
    std::vector<std::size_t> newIndex;
    for (std::size_t i = 0; i < own.size(); ++i) {
        newIndex.push_back(added.size());
        (isAdded[i] ? added : used).push_back(own[i]);
    }
    for (auto& [id, index] : templates_) index = newIndex[index];
    libraries_.emplace(shipped_, std::move(added), used);
}

void DatabaseReader::readStrokes() {
    each(schema::kCamera, [&](const Fields& row) {
        cameras_[row.id(0)] = fullCameraFromJson(row.tree(1), row.place());
    });
    each(schema::kStroke, [&](const Fields& row) {
        PendingStroke s;
        s.id = row.number(0, 0, kMaxInt - 1);
        s.camera = known(cameras_, row.id(1), row.place(), "camera");
        auto stroke = strokeFromBlob(blob(row.id(2), row.place()));
        if (!stroke) throwRead(stroke.error().code, row.place() + ": " + stroke.error().message);
        s.stroke = *std::move(stroke);
        checkSamples(s.stroke, row.place());
        strokes_[s.id] = file_.strokes.size();
        file_.strokes.push_back(std::move(s));
    });
}

void DatabaseReader::readMapped() {
    each(schema::kMapped, [&](const Fields& row) {
        std::vector<MappedStroke> list;
        const auto kept = static_cast<std::size_t>(row.number(2, 0, kMaxInt));
        if (!row.isNothing(1)) {
            const auto& base = known(mapped_, row.id(1), row.place(), "list");
            if (kept > base.size()) throwRead(Errc::Damaged, row.place() + " keeps too much");
            list.assign(base.begin(), base.begin() + static_cast<std::ptrdiff_t>(kept));
        } else if (kept > 0) {
            throwRead(Errc::Damaged, row.place() + " keeps what is not there");
        }
        const json more = row.tree(3);
        for (const json& item : readArray(more, row.place())) {
            const json::array_t& pair = readArray(item, row.place());
            if (pair.size() != 2)
                throwRead(Errc::BadValue, row.place() + ": a stroke and a colour");
            const int id = readInt(pair[0], row.place(), 0, kMaxInt - 1);
            const auto& s = file_.strokes[known(strokes_, id, row.place(), "stroke")];
            const auto color = parseColor(readString(pair[1], row.place()));
            if (!color) throwRead(Errc::BadValue, row.place() + ": " + color.error().message);
            list.push_back({s.id, s.stroke, s.camera, *color});
        }
        mapped_[row.id(0)] = std::move(list);
    });
}

void DatabaseReader::readSolids() {
    std::set<std::int64_t> named;
    each(schema::kState, [&](const Fields& row) {
        const json tree = row.tree(1);
        for (const json& item : readArray(bodyList(tree), row.place())) {
            const ObjectReader body(item, row.place());
            named.insert(readInt(body.require("solid"), body.at("solid"), 1, kMaxInt));
        }
    });
    const std::vector<std::int64_t> ids(named.begin(), named.end());
    std::vector<const PackedBlob*> packed;
    packed.reserve(ids.size());
    for (const std::int64_t id : ids) packed.push_back(&known(blobs_, id, "state", "blob"));
    auto read = solidsFromBlobs(packed, options_.whole, options_.progress);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (!read[i]) {
            throwRead(read[i].error().code,
                      "blob " + std::to_string(ids[i]) + ": " + read[i].error().message);
        }
        solids_.emplace(ids[i], *std::move(read[i]));
    }
}

std::vector<Body> DatabaseReader::readBodies(const json& list, const std::string& place) {
    std::vector<Body> bodies;
    for (const json& item : readArray(list, place)) {
        const ObjectReader body(item, itemPlace(place, bodies.size()));
        body.allowOnly({"solid", "rotation", "translation", "name", "hidden"});
        const int id = readInt(body.require("solid"), body.at("solid"), 1, kMaxInt);
        const auto& solid = known(solids_, id, body.place(), "solid");
        bodies.push_back({solid, poseFromJson(body)});
        if (const json* name = body.find("name")) {
            bodies.back().name = readString(*name, body.at("name"));
            if (auto ok = checkBodyName(bodies.back().name); !ok) {
                throwRead(ok.error().code, body.at("name") + ": " + ok.error().message);
            }
        }
        const json* hidden = body.find("hidden");
        bodies.back().hidden = hidden != nullptr && boolFromJson(*hidden, body.at("hidden"));
    }
    return bodies;
}

/// A list, or an object with one and a mirror plane.
void DatabaseReader::readBodiesOf(const Fields& row, DocumentState& state) {
    const json tree = row.tree(1);
    state.bodies = readBodies(bodyList(tree), row.place());
    if (!tree.is_object()) return;
    const ObjectReader both(tree, row.place());
    both.allowOnly({"bodies", "mirror"});
    const ObjectReader mirror(both.require("mirror"), both.at("mirror"));
    mirror.allowOnly({"point", "normal"});
    auto plane = mirrorPlane(readVec3(mirror.require("point"), mirror.at("point")),
                             readVec3(mirror.require("normal"), mirror.at("normal")));
    if (!plane) throwRead(plane.error().code, mirror.place() + ": " + plane.error().message);
    state.mirror = *plane;
}

void DatabaseReader::readState(const Fields& row) {
    auto state = std::make_shared<DocumentState>();
    readBodiesOf(row, *state);
    std::vector<int> added;
    const json templates = row.tree(2);
    for (const json& id : readArray(templates, row.place())) {
        const int number = readInt(id, row.place(), 1, kMaxInt);
        added.push_back(static_cast<int>(known(templates_, number, row.place(), "template")));
        const auto index = static_cast<std::size_t>(added.back());
        state->addedTemplates.push_back(libraries_->templates()[index].id);
    }
    state->library = libraries_->with(added, row.place());
    if (!row.isNothing(3)) {
        const auto tree = parseJson(blob(row.id(3), row.place()), {});
        if (!tree) throwRead(tree.error().code, row.place() + ": " + tree.error().message);
        state->surface = surfaceFromJson(*tree, row.place(), state->bodies);
    }
    if (!row.isNothing(4)) state->mapped = known(mapped_, row.id(4), row.place(), "list");
    states_[row.id(0)] = std::move(state);
}

std::vector<int> DatabaseReader::strokeIds(const Fields& row, std::size_t column) const {
    std::vector<int> ids = idsFromJson(row.tree(column), row.place());
    for (const int id : ids) known(strokes_, id, row.place(), "stroke");
    return ids;
}

void DatabaseReader::readSteps() {
    const int first = settingInt("first_state", 1, kMaxInt);
    file_.first = known(states_, first, "setting first_state", "state");
    each(schema::kStep, [&](const Fields& row) {
        if (row.id(0) != static_cast<std::int64_t>(file_.commands.size())) {
            throwRead(Errc::Damaged, row.place() + ": the step before it is missing");
        }
        StoredCommand command;
        command.name = row.text(1);
        command.after = known(states_, row.id(2), row.place(), "state");
        command.consumed = strokeIds(row, 3);
        if (!row.isNothing(4)) {
            command.templateId = known(templateIds_, row.id(4), row.place(), "template");
        }
        command.key = row.text(5);
        file_.commands.push_back(std::move(command));
    });
    checkRows("step", file_.commands.size());
    file_.index = settingInt("index", 0, static_cast<int>(file_.commands.size()));
    if (auto ok = loadState(*file_.stateAt(file_.index)); !ok) {
        throwRead(ok.error().code, "state: " + ok.error().message);
    }
    readNames();
}

void DatabaseReader::readNames() {
    if (!settings_.contains("names")) return;
    const json names = setting("names");
    for (const json& item : readArray(names, "setting names")) {
        const json::array_t& pair = readArray(item, "setting names");
        if (pair.size() != 2) throwRead(Errc::BadValue, "setting names: a state and its name");
        const int most = static_cast<int>(file_.commands.size());
        file_.names[readInt(pair[0], "setting names", 0, most)] =
            readString(pair[1], "setting names");
    }
}

void DatabaseReader::readInk() {
    int least = 0;
    for (const PendingStroke& s : file_.strokes) least = std::max(least, s.id + 1);
    file_.nextStrokeId = settingInt("next_stroke", least, kMaxInt);
    file_.nextInkSerial = settingInt("next_ink", 0, kMaxInt);
    std::size_t rows = 0;
    each(schema::kInk, [&](const Fields& row) {
        ++rows;
        const auto steps = static_cast<int>(file_.commands.size());
        const int list = row.number(0, 0, 2 * steps + 1);
        StoredInk* changes = list == schema::kInkDone ? &file_.inkDone : &file_.inkUndone;
        if (list > schema::kInkUndone) {
            StoredCommand& command = file_.commands[static_cast<std::size_t>(list) / 2 - 1];
            changes = list % 2 == 0 ? &command.inkBefore : &command.inkAfter;
        }
        if (row.id(1) != static_cast<std::int64_t>(changes->size())) {
            throwRead(Errc::Damaged, row.place() + ": the change before it is missing");
        }
        StoredInkChange change;
        change.serial = row.number(2, 0, file_.nextInkSerial - 1);
        // These may be gone: taken back, and then something else was done.
        change.added = idsFromJson(row.tree(3), row.place());
        if (!change.added.empty() && change.added.back() >= file_.nextStrokeId) {
            throwRead(Errc::BadValue, row.place() + ": a stroke that was never drawn");
        }
        change.removed = strokeIds(row, 4);
        change.withdrawn = strokeIds(row, 5);
        changes->push_back(std::move(change));
    });
    checkRows("ink", rows);
}

void DatabaseReader::readPending() {
    each(schema::kPending, [&](const Fields& row) {
        file_.pending.push_back(row.number(0, 0, kMaxInt - 1));
        known(strokes_, file_.pending.back(), row.place(), "stroke");
    });
    checkRows("pending", file_.pending.size());
}

void DatabaseReader::readScript() {
    std::size_t rows = 0;
    each(schema::kScript, [&](const Fields& row) {
        ++rows;
        const int list = row.number(0, -kMaxInt, kMaxInt);
        const int serial = static_cast<int>(schema::serialTakenBack(list));
        auto& entries = list == schema::kScriptDone ? file_.script : file_.takenBack[serial];
        if (row.id(1) != static_cast<std::int64_t>(entries.size())) {
            throwRead(Errc::Damaged, row.place() + ": the step before it is missing");
        }
        Recorder::Entry entry;
        if (row.isNothing(2)) {
            auto stroke = strokeFromBlob(blob(row.id(3), row.place()));
            if (!stroke) {
                throwRead(stroke.error().code, row.place() + ": " + stroke.error().message);
            }
            checkSamples(*stroke, row.place());
            entry.step = StrokeStep{*std::move(stroke), row.number(4, 0, 1) == 1};
        } else {
            entry.step = stepFromJson(row.tree(2), entries.size());
        }
        entry.view.camera = known(cameras_, row.id(5), row.place(), "camera");
        entry.view.thresholds = {row.real(6), row.real(7)};
        entry.inkSerial = row.number(8, -kMaxInt, kMaxInt);
        entries.push_back(std::move(entry));
    });
    checkRows("script", rows);
}

void DatabaseReader::checkRows(const char* table, std::size_t found) const {
    const json rows = setting("rows");
    const ObjectReader told(rows, "setting rows");
    const int expected = readInt(told.require(table), told.at(table), 0, kMaxInt);
    if (static_cast<std::size_t>(expected) != found) {
        throwRead(Errc::Damaged, std::string("rows of the table ") + table + " are missing");
    }
}

DocumentFile DatabaseReader::read() {
    readSettings();
    readBlobs();
    readTemplates();
    readStrokes();
    readMapped();
    readSolids();
    each(schema::kState, [&](const Fields& row) { readState(row); });
    readSteps();
    readInk();
    readPending();
    readScript();
    const json camera = setting("camera");
    file_.view.camera = fullCameraFromJson(camera, "setting camera");
    const json thresholds = setting("thresholds");
    file_.view.thresholds =
        withStep(Thresholds{}, thresholdsFromJson(thresholds, "setting thresholds"));
    const json automatic = setting("automatic_distance");
    if (!automatic.is_boolean()) throwRead(Errc::WrongType, "setting automatic_distance");
    file_.automaticDistance = automatic.get<bool>();
    file_.obliqueFactor = obliqueFactorFromJson(setting("oblique_factor"), "oblique_factor");
    file_.title = readString(setting("title"), "setting title");
    file_.thumbnail = thumbnail();
    return std::move(file_);
}

DocumentSummary DatabaseReader::summary() {
    readSettings();
    DocumentSummary out;
    const json rows = setting("rows");
    const ObjectReader told(rows, "setting rows");
    out.steps = readInt(told.require("step"), told.at("step"), 0, kMaxInt);
    out.strokes = readInt(told.require("pending"), told.at("pending"), 0, kMaxInt);
    out.title = readString(setting("title"), "setting title");
    out.thumbnail = thumbnail();
    return out;
}

}  // namespace

Result<DocumentFile> readDatabase(Database& database, const TemplateLibrary& shipped,
                                  const ReadOptions& options) {
    try {
        return DatabaseReader(database, shipped, options).read();
    } catch (ReadError& e) {
        return fail(std::move(e.error));
    }
}

Result<DocumentSummary> summarizeDatabase(Database& database) {
    const TemplateLibrary none;
    try {
        return DatabaseReader(database, none).summary();
    } catch (ReadError& e) {
        return fail(std::move(e.error));
    }
}

}  // namespace ew
