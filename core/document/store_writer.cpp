// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store_writer.h"

#include <QByteArray>
#include <algorithm>
#include <iterator>

#include "core/document/sketch_script_json.h"
#include "core/document/store_blobs.h"
#include "core/document/store_schema.h"
#include "core/document/store_surface.h"
#include "core/document/store_values.h"
#include "core/tlib/template_io.h"

namespace ew {

namespace {

std::int64_t whole(std::size_t n) { return static_cast<std::int64_t>(n); }

Field optional(const std::optional<std::int64_t>& id) { return id ? Field(*id) : Field(); }

template <class Known>
std::int64_t nextId(const Known& known) {
    return static_cast<std::int64_t>(known.size()) + 1;
}

/// How many of the first changes are the same in both.
std::size_t sameBeginning(const StoredInk& a, const StoredInk& b) {
    const auto [end, other] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    return static_cast<std::size_t>(end - a.begin());
}

bool sameMapped(const MappedStroke& a, const MappedStroke& b) {
    return a.id == b.id && a.color == b.color;
}

}  // namespace

void DocumentWriter::put(const Table& table, const Row& row) {
    if (auto ok = db_.put(table, row); !ok) throw ReadError{ok.error()};
}

void DocumentWriter::remove(const Table& table, const Row& key) {
    if (auto ok = db_.remove(table, key); !ok) throw ReadError{ok.error()};
}

std::int64_t DocumentWriter::blob(const std::string& content) {
    const std::string sha = contentHash(content);
    const auto [it, isNew] = known_.blobs.try_emplace(sha, nextId(known_.blobs));
    if (isNew) {
        const auto [data, packed] = packBlob(content);
        put(schema::kBlob, {it->second, Bytes{sha}, whole(content.size()),
                            std::int64_t{packed ? 1 : 0}, Bytes{data}});
    }
    return it->second;
}

std::int64_t DocumentWriter::camera(const OrthographicCamera& c) {
    const std::string text = fullCamera(c);
    const auto [it, isNew] = known_.cameras.try_emplace(text, nextId(known_.cameras));
    if (isNew) put(schema::kCamera, {it->second, text});
    return it->second;
}

std::int64_t DocumentWriter::tmpl(const Template& t) {
    const std::string text = nlohmann::ordered_json::parse(writeTemplate(t)).dump();
    const auto [it, isNew] = known_.templates.try_emplace(text, nextId(known_.templates));
    if (isNew) put(schema::kTemplate, {it->second, text});
    return it->second;
}

std::int64_t DocumentWriter::samples(const Stroke& stroke) { return blob(samplesBlob(stroke)); }

void DocumentWriter::stroke(const PendingStroke& s) {
    if (!known_.strokes.insert(s.id).second) return;
    put(schema::kStroke, {std::int64_t{s.id}, camera(s.camera), samples(s.stroke)});
}

std::optional<std::int64_t> DocumentWriter::mapped(const DocumentState& s, const StateRow* before) {
    if (s.mapped.empty()) return std::nullopt;
    const std::vector<MappedStroke> none;
    const auto& old = before != nullptr && before->mapped ? before->state->mapped : none;
    const auto [end, other] =
        std::mismatch(s.mapped.begin(), s.mapped.end(), old.begin(), old.end(), &sameMapped);
    if (end == s.mapped.end() && other == old.end()) return before->mapped;
    std::string more = "[";
    for (auto m = end; m != s.mapped.end(); ++m) {
        stroke({m->id, m->stroke, m->camera});
        separate(more);
        more += "[" + std::to_string(m->id) + ", " + jsonQuoted(colorText(m->color)) + "]";
    }
    const std::int64_t id = ++known_.mappedRows;
    const std::int64_t kept = end - s.mapped.begin();
    put(schema::kMapped, {id, kept > 0 ? optional(before->mapped) : Field(), kept, more + "]"});
    return id;
}

std::int64_t DocumentWriter::state(const std::shared_ptr<const DocumentState>& s,
                                   const StateRow* before) {
    const auto known = known_.states.find(s.get());
    if (known != known_.states.end()) return known->second.id;
    StateRow row;
    row.state = s;
    std::string bodies = "[";
    for (std::size_t i = 0; i < s->bodies.size(); ++i) {
        const Body& body = s->bodies[i];
        // Steps share the solids that they leave alone, so most need not be serialized.
        const bool same = before != nullptr && i < before->solids.size() &&
                          before->state->bodies[i].solid.sharesDataWith(body.solid);
        row.solids.push_back(same ? before->solids[i] : blob(body.solid.serialize()));
        separate(bodies);
        bodies += "{\"solid\": " + std::to_string(row.solids.back()) + ", " + poseText(body.pose);
        if (!body.name.empty()) bodies += ", \"name\": " + jsonQuoted(body.name);
        if (body.hidden) bodies += ", \"hidden\": true";
        bodies += "}";
    }
    bodies += "]";
    if (s->mirror) {
        bodies = "{\"bodies\": " + bodies +
                 ", \"mirror\": {\"point\": " + vecText(s->mirror->point) +
                 ", \"normal\": " + vecText(s->mirror->normal) + "}}";
    }
    std::string templates = "[";
    for (const std::string& id : s->addedTemplates) {
        separate(templates);
        const auto index = static_cast<std::size_t>(s->library.find(id));
        templates += std::to_string(tmpl(s->library.at(index)));
    }
    if (before != nullptr && before->state->surface == s->surface) {
        row.surface = before->surface;
    } else if (s->surface != SurfaceSettings{}) {
        row.surface = blob(surfaceText(s->surface));
    }
    row.mapped = mapped(*s, before);
    row.id = ++known_.stateRows;
    put(schema::kState,
        {row.id, bodies, templates + "]", optional(row.surface), optional(row.mapped)});
    return known_.states.emplace(s.get(), std::move(row)).first->second.id;
}

void DocumentWriter::inkList(std::int64_t list, const StoredInk& changes, std::size_t keep) {
    for (std::size_t i = keep; i < changes.size(); ++i) {
        const StoredInkChange& c = changes[i];
        put(schema::kInk, {list, whole(i), std::int64_t{c.serial}, idsText(c.added),
                           idsText(c.removed), idsText(c.withdrawn)});
    }
    std::size_t& rows = known_.inkRows[list];
    for (std::size_t i = changes.size(); i < rows; ++i) remove(schema::kInk, {list, whole(i)});
    rows = changes.size();
    if (rows == 0) known_.inkRows.erase(list);
}

void DocumentWriter::setting(const std::string& key, const std::string& value) {
    std::string& known = known_.settings[key];
    if (known == value) return;
    put(schema::kSetting, {key, value});
    known = value;
}

void DocumentWriter::writeHistory(const DocumentUpdate& update) {
    const DocumentFile& file = update.file;
    auto& chain = known_.chain;
    const auto rowOf = [&](std::size_t place) { return &known_.states.at(chain[place].get()); };
    if (chain.empty()) {
        const std::int64_t id = state(file.first, nullptr);
        chain.push_back(file.first);
        setting("first_state", std::to_string(id));
    }
    for (std::size_t i = 0; i < file.commands.size(); ++i) {
        const StoredCommand& c = file.commands[i];
        const std::size_t place = update.firstCommand + i;
        const std::int64_t id = state(c.after, rowOf(place));
        if (place + 1 < chain.size() && chain[place + 1] != c.after)
            known_.states.erase(chain[place + 1].get());
        chain.resize(std::max(chain.size(), place + 2));
        chain[place + 1] = c.after;
        Field used;
        if (!c.templateId.empty()) {
            const TemplateLibrary& library = chain[place]->library;
            const int index = library.find(c.templateId);
            if (index >= 0) used = tmpl(library.at(static_cast<std::size_t>(index)));
        }
        put(schema::kStep, {whole(place), c.name, id, idsText(c.consumed), used, c.key});
        inkList(schema::inkBefore(place), c.inkBefore, 0);
        inkList(schema::inkAfter(place), c.inkAfter, 0);
    }
    while (chain.size() > update.commandCount + 1) {
        const std::size_t place = chain.size() - 2;
        remove(schema::kStep, {whole(place)});
        inkList(schema::inkBefore(place), {}, 0);
        inkList(schema::inkAfter(place), {}, 0);
        known_.states.erase(chain.back().get());
        chain.pop_back();
    }
}

void DocumentWriter::writeInk(const DocumentFile& file) {
    inkList(schema::kInkDone, file.inkDone, sameBeginning(file.inkDone, known_.inkDone));
    inkList(schema::kInkUndone, file.inkUndone, sameBeginning(file.inkUndone, known_.inkUndone));
    known_.inkDone = file.inkDone;
    known_.inkUndone = file.inkUndone;
    std::vector<int> changed;
    std::set_difference(known_.pending.begin(), known_.pending.end(), file.pending.begin(),
                        file.pending.end(), std::back_inserter(changed));
    for (const int id : changed) remove(schema::kPending, {std::int64_t{id}});
    changed.clear();
    std::set_difference(file.pending.begin(), file.pending.end(), known_.pending.begin(),
                        known_.pending.end(), std::back_inserter(changed));
    for (const int id : changed) put(schema::kPending, {std::int64_t{id}});
    known_.pending = file.pending;
}

Row DocumentWriter::scriptRow(std::int64_t list, std::size_t place, const Recorder::Entry& entry) {
    Field step;
    Field ink;
    std::int64_t pressure = 0;
    if (const auto* drawn = std::get_if<StrokeStep>(&entry.step)) {
        ink = samples(drawn->stroke);
        pressure = drawn->hasPressure ? 1 : 0;
    } else {
        step = stepJson(entry.step);
    }
    const Thresholds& t = entry.view.thresholds;
    return {list,           whole(place), std::move(step),
            std::move(ink), pressure,     camera(entry.view.camera),
            t.distancePx,   t.angleDeg,   std::int64_t{entry.inkSerial}};
}

void DocumentWriter::writeScript(const DocumentUpdate& update) {
    const auto list = [&](std::int64_t number, const std::vector<Recorder::Entry>& entries,
                          std::size_t from) {
        for (std::size_t i = 0; i < entries.size(); ++i) {
            put(schema::kScript, scriptRow(number, from + i, entries[i]));
        }
        std::size_t& rows = known_.scriptRows[number];
        const std::size_t now = from + entries.size();
        for (std::size_t i = now; i < rows; ++i) remove(schema::kScript, {number, whole(i)});
        rows = now;
        if (rows == 0) known_.scriptRows.erase(number);
    };
    list(schema::kScriptDone, update.file.script, update.firstEntry);
    for (const auto& [serial, entries] : update.file.takenBack) {
        list(schema::takenBack(serial), entries, 0);
    }
}

void DocumentWriter::writeSettings(const DocumentUpdate& update) {
    const DocumentFile& file = update.file;
    const Thresholds& t = file.view.thresholds;
    setting("camera", fullCamera(file.view.camera));
    setting("thresholds", "{\"distance_px\": " + numberText(t.distancePx) +
                              ", \"angle_deg\": " + numberText(t.angleDeg) + "}");
    setting("automatic_distance", file.automaticDistance ? "true" : "false");
    setting("oblique_factor", numberText(file.obliqueFactor));
    setting("title", jsonQuoted(file.title));
    setting("index", std::to_string(file.index));
    setting("next_stroke", std::to_string(file.nextStrokeId));
    setting("next_ink", std::to_string(file.nextInkSerial));
    // No blob: in a working copy the old one goes when the new one comes.
    if (!file.thumbnail.empty()) {
        const QByteArray png = QByteArray::fromStdString(file.thumbnail);
        setting("thumbnail", jsonQuoted(png.toBase64().toStdString()));
    }
    std::string names = "[";
    for (const auto& [steps, name] : file.names) {
        separate(names);
        names += "[" + std::to_string(steps) + ", " + jsonQuoted(name) + "]";
    }
    // Documents without names are as they were before there were any.
    if (!file.names.empty() || known_.settings.contains("names")) setting("names", names + "]");
    if (update.saved) setting("saved", *update.saved ? "true" : "false");
    setting("needs", jsonQuoted("0.1.0"));
    setting("program", jsonQuoted(EDGEWRIGHT_VERSION));
    // A row that is gone without a trace is missed by its number.
    std::size_t ink = 0;
    std::size_t script = 0;
    for (const auto& [list, rows] : known_.inkRows) ink += rows;
    for (const auto& [list, rows] : known_.scriptRows) script += rows;
    setting("rows", "{\"step\": " + std::to_string(known_.chain.size() - 1) +
                        ", \"ink\": " + std::to_string(ink) +
                        ", \"pending\": " + std::to_string(known_.pending.size()) +
                        ", \"script\": " + std::to_string(script) + "}");
}

void DocumentWriter::writeAll(const DocumentUpdate& update) {
    for (const PendingStroke& s : update.file.strokes) stroke(s);
    writeHistory(update);
    writeInk(update.file);
    writeScript(update);
    writeSettings(update);
}

Result<void> DocumentWriter::write(const DocumentUpdate& update) {
    if (needsWhole() && !update.whole) {
        return fail(Errc::Internal, "What was written last did not arrive.");
    }
    lost_ = true;  // until all of it is there, what is known is not what the database holds
    auto ok = db_.begin();
    if (!ok) return ok;
    try {
        if (update.whole) {
            known_ = {};
            ok = db_.clear();
        }
        if (ok) writeAll(update);
    } catch (ReadError& e) {
        ok = fail(std::move(e.error));
    }
    if (ok) ok = db_.commit();
    if (!ok) {
        db_.rollback();
        return ok;
    }
    lost_ = false;
    return {};
}

Result<std::string> writeDocument(const DocumentFile& file) {
    auto db = Database::inMemory(schema::kKind);
    if (!db) return fail(db.error());
    DocumentWriter writer(*db);
    if (auto ok = writer.write(wholeUpdate(file)); !ok) return fail(ok.error());
    return db->bytes();
}

DocumentUpdate wholeUpdate(DocumentFile file) {
    DocumentUpdate update;
    update.whole = true;
    update.commandCount = file.commands.size();
    update.entryCount = file.script.size();
    update.file = std::move(file);
    return update;
}

}  // namespace ew
