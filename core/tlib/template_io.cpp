// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/template_io.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>

namespace ew {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxBytes = 4U << 20U;
constexpr int kMaxDepth = 32;
constexpr int kVersion = 1;

/// Where a value stands: the source's name and the JSON path, for messages.
struct Place {
    std::string source;
    std::string path;

    Place operator/(std::string_view key) const { return {source, path + "/" + std::string(key)}; }
    Place operator/(std::size_t index) const { return *this / std::to_string(index); }
    std::string say(const std::string& text) const {
        return source + ": " + (path.empty() ? std::string("/") : path) + ": " + text;
    }
};

/// A text of the file for a message, cut to a length that can be read.
std::string shown(std::string text) {
    constexpr std::size_t kMaxShown = 60;
    if (text.size() > kMaxShown) {
        std::size_t end = kMaxShown;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
        text = text.substr(0, end) + "...";
    }
    return "\"" + text + "\"";
}

/// Refuses deep nesting before a tree is built, so that no input can exhaust the stack.
Result<void> checkDepth(std::string_view json, const Place& root) {
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (inString) {
            if (c == '\\') {
                ++i;
            } else if (c == '"') {
                inString = false;
            }
        } else if (c == '"') {
            inString = true;
        } else if (c == '[' || c == '{') {
            if (++depth > kMaxDepth) {
                return fail(Errc::TooDeep, root.say("nested more than " +
                                                    std::to_string(kMaxDepth) + " levels deep."));
            }
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    return {};
}

/// Parses the text; a key that comes twice in one object is refused, since one of the two values
/// would be lost in silence.
Result<Json> parse(std::string_view text, const Place& root) {
    if (text.size() > kMaxBytes) {
        return fail(Errc::TooLarge, root.say("larger than the 4 MiB that a template may have."));
    }
    if (auto ok = checkDepth(text, root); !ok) return fail(ok.error());
    std::vector<std::set<std::string>> open;
    std::string twice;
    const auto watch = [&](int, Json::parse_event_t event, Json& value) {
        if (event == Json::parse_event_t::object_start) {
            open.emplace_back();
        } else if (event == Json::parse_event_t::object_end) {
            open.pop_back();
        } else if (event == Json::parse_event_t::key) {
            const auto& key = value.get_ref<const std::string&>();
            if (!open.back().insert(key).second && twice.empty()) twice = key;
        }
        return true;
    };
    try {
        Json json = Json::parse(text.begin(), text.end(), watch);
        if (!twice.empty()) {
            return fail(Errc::Syntax,
                        root.say("the key " + shown(twice) + " stands twice in one object."));
        }
        return json;
    } catch (const Json::out_of_range&) {
        return fail(Errc::BadValue, root.say("a number is too large."));
    } catch (const Json::parse_error& e) {
        const std::size_t at = std::min(e.byte > 0 ? e.byte - 1 : 0, text.size());
        const auto line =
            1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        return fail(Errc::Syntax, root.say("not JSON from line " + std::to_string(line) + " on."));
    }
}

/// An object with exactly these keys; those from `optional` may be absent.
Result<void> checkKeys(const Json& json, const Place& at,
                       std::initializer_list<const char*> required,
                       std::initializer_list<const char*> optional) {
    if (!json.is_object()) return fail(Errc::WrongType, at.say("must be an object."));
    const auto among = [](std::initializer_list<const char*> names, const std::string& key) {
        return std::any_of(names.begin(), names.end(), [&](const char* n) { return key == n; });
    };
    for (const auto& item : json.items()) {
        if (!among(required, item.key()) && !among(optional, item.key())) {
            return fail(Errc::UnknownKey, at.say("unknown key " + shown(item.key()) + "."));
        }
    }
    for (const char* key : required) {
        if (!json.contains(key)) {
            return fail(Errc::MissingKey,
                        at.say("the key \"" + std::string(key) + "\" is missing."));
        }
    }
    return {};
}

Result<std::string> readText(const Json& json, const Place& at) {
    if (!json.is_string()) return fail(Errc::WrongType, at.say("must be a string."));
    return json.get<std::string>();
}

Result<int> readIndex(const Json& json, const Place& at) {
    if (!json.is_number_integer()) {
        return fail(Errc::WrongType, at.say("must be a vertex index (a whole number)."));
    }
    // The comparison runs on the widest types, so no 64-bit value can wrap into range.
    const bool low = !json.is_number_unsigned() && json.get<std::int64_t>() < 0;
    if (low || json.get<std::uint64_t>() >= kMaxTemplateVertices) {
        return fail(Errc::BadTemplate, at.say("vertex " + json.dump() + " does not exist."));
    }
    return json.get<int>();
}

Result<Vec3> readPoint(const Json& json, const Place& at) {
    if (!json.is_array() || json.size() != 3) {
        return fail(Errc::WrongType, at.say("must be three numbers [x, y, z]."));
    }
    Vec3 p;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!json[k].is_number()) return fail(Errc::WrongType, (at / k).say("must be a number."));
        p[static_cast<Eigen::Index>(k)] = json[k].get<double>();
        if (!std::isfinite(json[k].get<double>())) {
            return fail(Errc::BadValue, (at / k).say("must be a finite number."));
        }
    }
    return p;
}

/// Reads an array with `readItem(json, place)`, which returns a Result<T>.
template <class T, class F>
Result<std::vector<T>> readArray(const Json& json, const Place& at, const char* what, F readItem) {
    if (!json.is_array()) {
        return fail(Errc::WrongType, at.say("must be a list of " + std::string(what) + "."));
    }
    std::vector<T> out;
    out.reserve(json.size());
    for (std::size_t i = 0; i < json.size(); ++i) {
        auto item = readItem(json[i], at / i);
        if (!item) return fail(item.error());
        out.push_back(std::move(*item));
    }
    return out;
}

Result<TemplateEdge> readEdge(const Json& json, const Place& at) {
    if (!json.is_array() || json.size() != 2) {
        return fail(Errc::WrongType, at.say("must be an edge: two vertex indices [a, b]."));
    }
    TemplateEdge edge{};
    for (std::size_t k = 0; k < 2; ++k) {
        auto index = readIndex(json[k], at / k);
        if (!index) return fail(index.error());
        edge[k] = *index;
    }
    return edge;
}

Result<std::vector<TemplateEdge>> readEdges(const Json& json, const Place& at) {
    return readArray<TemplateEdge>(json, at, "edges", readEdge);
}

Result<std::array<TemplateEdge, 2>> readEdgePair(const Json& json, const Place& at) {
    auto edges = readEdges(json, at);
    if (!edges) return fail(edges.error());
    if (edges->size() != 2) return fail(Errc::WrongType, at.say("must be two edges."));
    return std::array<TemplateEdge, 2>{(*edges)[0], (*edges)[1]};
}

Result<TemplateRelations> readRelations(const Json& json, const Place& at) {
    if (auto ok = checkKeys(json, at, {}, {"parallel", "perpendicular", "equal_length"}); !ok) {
        return fail(ok.error());
    }
    TemplateRelations out;
    if (json.contains("parallel")) {
        auto classes = readArray<std::vector<TemplateEdge>>(json["parallel"], at / "parallel",
                                                            "classes of edges", readEdges);
        if (!classes) return fail(classes.error());
        out.parallel = std::move(*classes);
    }
    if (json.contains("perpendicular")) {
        auto pairs = readArray<std::array<TemplateEdge, 2>>(
            json["perpendicular"], at / "perpendicular", "pairs of edges", readEdgePair);
        if (!pairs) return fail(pairs.error());
        out.perpendicular = std::move(*pairs);
    }
    if (json.contains("equal_length")) {
        auto classes = readArray<std::vector<TemplateEdge>>(
            json["equal_length"], at / "equal_length", "classes of edges", readEdges);
        if (!classes) return fail(classes.error());
        out.equalLength = std::move(*classes);
    }
    return out;
}

Result<TemplateReading> readReading(const Json& json, const Place& at) {
    if (auto ok = checkKeys(json, at, {"id", "name", "relations"}, {}); !ok)
        return fail(ok.error());
    TemplateReading out;
    auto id = readText(json["id"], at / "id");
    if (!id) return fail(id.error());
    auto name = readText(json["name"], at / "name");
    if (!name) return fail(name.error());
    auto relations = readRelations(json["relations"], at / "relations");
    if (!relations) return fail(relations.error());
    out.id = std::move(*id);
    out.name = std::move(*name);
    out.relations = std::move(*relations);
    return out;
}

/// A text under a key, empty where there is none.
Result<void> readTextIf(const Json& json, const Place& at, const char* key, std::string& out) {
    if (!json.contains(key)) return {};
    auto text = readText(json[key], at / key);
    if (!text) return fail(text.error());
    out = std::move(*text);
    return {};
}

Result<void> readLanguages(const Json& json, const Place& at, TemplateAbout& out) {
    if (!json.is_object()) return fail(Errc::WrongType, at.say("must be an object."));
    for (const auto& item : json.items()) {
        const Place here = at / item.key();
        if (auto ok = checkKeys(item.value(), here, {}, {"name", "description"}); !ok) return ok;
        TemplateWords& words = out.inLanguage[item.key()];
        if (auto ok = readTextIf(item.value(), here, "name", words.name); !ok) return ok;
        if (auto ok = readTextIf(item.value(), here, "description", words.description); !ok) {
            return ok;
        }
    }
    return {};
}

Result<void> readAbout(const Json& json, const Place& root, TemplateAbout& out) {
    if (auto ok = readTextIf(json, root, "category", out.category); !ok) return ok;
    if (auto ok = readTextIf(json, root, "author", out.author); !ok) return ok;
    if (auto ok = readTextIf(json, root, "licence", out.licence); !ok) return ok;
    if (auto ok = readTextIf(json, root, "template_version", out.version); !ok) return ok;
    if (json.contains("tags")) {
        auto tags = readArray<std::string>(json["tags"], root / "tags", "texts", readText);
        if (!tags) return fail(tags.error());
        out.tags = std::move(*tags);
    }
    if (!json.contains("languages")) return {};
    return readLanguages(json["languages"], root / "languages", out);
}

Result<void> readHeader(const Json& json, const Place& root) {
    if (!json.is_object()) return fail(Errc::WrongFormat, root.say("must be an object."));
    if (!json.contains("format") || json["format"] != "edgewright-template") {
        return fail(Errc::WrongFormat,
                    (root / "format").say("must be \"edgewright-template\"; this is no template."));
    }
    if (!json.contains("version")) {
        return fail(Errc::MissingKey, root.say("the key \"version\" is missing."));
    }
    if (!json["version"].is_number_integer()) {
        return fail(Errc::WrongType, (root / "version").say("must be a whole number."));
    }
    if (json["version"] != kVersion) {
        return fail(Errc::WrongVersion,
                    (root / "version")
                        .say("this program reads version 1, not " + json["version"].dump() + "."));
    }
    return {};
}

Result<void> readShape(const Json& json, const Place& root, PolyhedronSpec& shape) {
    auto vertices = readArray<Vec3>(json["vertices"], root / "vertices", "points", readPoint);
    if (!vertices) return fail(vertices.error());
    const auto readFace = [](const Json& face, const Place& at) {
        return readArray<int>(face, at, "vertex indices", readIndex);
    };
    auto faces = readArray<std::vector<int>>(json["faces"], root / "faces", "faces", readFace);
    if (!faces) return fail(faces.error());
    shape.vertices = std::move(*vertices);
    shape.faces = std::move(*faces);
    return {};
}

Result<Template> readBody(const Json& json, const Place& root) {
    if (auto ok = readHeader(json, root); !ok) return fail(ok.error());
    if (auto ok = checkKeys(json, root, {"format", "version", "id", "name", "vertices", "faces"},
                            {"description", "relations", "readings", "category", "tags", "author",
                             "licence", "template_version", "languages"});
        !ok) {
        return fail(ok.error());
    }
    Template out;
    auto id = readText(json["id"], root / "id");
    if (!id) return fail(id.error());
    out.id = std::move(*id);
    auto name = readText(json["name"], root / "name");
    if (!name) return fail(name.error());
    out.name = std::move(*name);
    if (auto ok = readTextIf(json, root, "description", out.description); !ok) {
        return fail(ok.error());
    }
    if (auto ok = readAbout(json, root, out.about); !ok) return fail(ok.error());
    if (auto ok = readShape(json, root, out.shape); !ok) return fail(ok.error());
    if (json.contains("relations")) {
        auto relations = readRelations(json["relations"], root / "relations");
        if (!relations) return fail(relations.error());
        out.relations = std::move(*relations);
    }
    if (json.contains("readings")) {
        auto readings = readArray<TemplateReading>(json["readings"], root / "readings", "readings",
                                                   readReading);
        if (!readings) return fail(readings.error());
        out.readings = std::move(*readings);
    }
    return out;
}

// Writing -----------------------------------------------------------------------------------------

std::string quoted(const std::string& text) {
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string number(double value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value);
    return {buffer, end.ptr};
}

/// "[item, item]" on one line.
template <class Range, class F>
std::string list(const Range& range, F item) {
    std::string out = "[";
    const char* separator = "";
    for (const auto& x : range) {
        out += separator + item(x);
        separator = ", ";
    }
    return out + "]";
}

std::string edgeText(const TemplateEdge& e) {
    return list(e, [](int i) { return std::to_string(i); });
}

/// A list with one item a line, each indented by two more than `indent`.
template <class Range, class F>
std::string lines(const Range& range, const std::string& indent, F item) {
    if (range.empty()) return "[]";
    std::string out = "[";
    const char* separator = "\n";
    for (const auto& x : range) {
        out += separator + indent + "  " + item(x);
        separator = ",\n";
    }
    return out + "\n" + indent + "]";
}

std::string relationsText(const TemplateRelations& r, const std::string& indent) {
    std::vector<std::string> members;
    const auto edges = [](const auto& group) { return list(group, edgeText); };
    const std::string inner = indent + "  ";
    if (!r.parallel.empty()) {
        members.push_back("\"parallel\": " + lines(r.parallel, inner, edges));
    }
    if (!r.perpendicular.empty()) {
        members.push_back("\"perpendicular\": " + lines(r.perpendicular, inner, edges));
    }
    if (!r.equalLength.empty()) {
        members.push_back("\"equal_length\": " + lines(r.equalLength, inner, edges));
    }
    if (members.empty()) return "{}";
    std::string out = "{";
    const char* separator = "\n";
    for (const std::string& m : members) {
        out += separator + inner + m;
        separator = ",\n";
    }
    return out + "\n" + indent + "}";
}

std::string readingText(const TemplateReading& r) {
    const std::string indent = "      ";
    return "{\n" + indent + "\"id\": " + quoted(r.id) + ",\n" + indent +
           "\"name\": " + quoted(r.name) + ",\n" + indent +
           "\"relations\": " + relationsText(r.relations, indent) + "\n    }";
}

std::string aboutText(const TemplateAbout& a) {
    std::string out;
    const auto put = [&out](const char* key, const std::string& value) {
        if (!value.empty()) out += "  \"" + std::string(key) + "\": " + quoted(value) + ",\n";
    };
    put("category", a.category);
    if (!a.tags.empty()) out += "  \"tags\": " + list(a.tags, quoted) + ",\n";
    put("author", a.author);
    put("licence", a.licence);
    put("template_version", a.version);
    if (a.inLanguage.empty()) return out;
    const auto language = [](const auto& entry) {
        std::string words;
        const TemplateWords& w = entry.second;
        if (!w.name.empty()) words = "\"name\": " + quoted(w.name);
        if (!w.description.empty()) {
            words += (words.empty() ? "" : ", ") + ("\"description\": " + quoted(w.description));
        }
        return quoted(entry.first) + ": {" + words + "}";
    };
    std::string members = lines(a.inLanguage, "  ", language);
    members.front() = '{';
    members.back() = '}';
    return out + "  \"languages\": " + members + ",\n";
}

}  // namespace

Result<Template> readTemplate(std::string_view json, const std::string& source) {
    const Place root{source, ""};
    auto parsed = parse(json, root);
    if (!parsed) return fail(parsed.error());
    auto tmpl = readBody(*parsed, root);
    if (!tmpl) return tmpl;
    if (auto ok = checkTemplate(*tmpl, source); !ok) return fail(ok.error());
    return tmpl;
}

std::string writeTemplate(const Template& t) {
    const auto point = [](const Vec3& p) {
        return list(std::array<double, 3>{p.x(), p.y(), p.z()}, number);
    };
    const auto face = [](const std::vector<int>& f) {
        return list(f, [](int i) { return std::to_string(i); });
    };
    std::string out = "{\n  \"format\": \"edgewright-template\",\n  \"version\": 1,\n";
    out += "  \"id\": " + quoted(t.id) + ",\n  \"name\": " + quoted(t.name) + ",\n";
    if (!t.description.empty()) out += "  \"description\": " + quoted(t.description) + ",\n";
    out += aboutText(t.about);
    out += "  \"vertices\": " + lines(t.shape.vertices, "  ", point) + ",\n";
    out += "  \"faces\": " + lines(t.shape.faces, "  ", face);
    const TemplateRelations& r = t.relations;
    if (!r.parallel.empty() || !r.perpendicular.empty() || !r.equalLength.empty()) {
        out += ",\n  \"relations\": " + relationsText(r, "  ");
    }
    if (!t.readings.empty()) out += ",\n  \"readings\": " + lines(t.readings, "  ", readingText);
    return out + "\n}\n";
}

}  // namespace ew
