// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/template_pack.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "core/document/json_text.h"
#include "core/document/zip_file.h"
#include "core/tlib/template_io.h"

namespace ew {

using nlohmann::json;

namespace {

constexpr std::string_view kManifest = "manifest.json";
constexpr std::string_view kFolder = "templates/";
constexpr std::string_view kEnding = ".json";
constexpr std::string_view kFormat = "edgewright-templates";
constexpr std::size_t kMostTemplates = 1'000;
constexpr std::size_t kLongestText = 500;

Result<void> checkText(const std::string& text, const char* what) {
    const bool oneLine = std::none_of(text.begin(), text.end(),
                                      [](char c) { return static_cast<unsigned char>(c) < ' '; });
    if (oneLine && text.size() <= kLongestText) return {};
    return fail(Errc::BadValue, std::string("The pack's ") + what +
                                    " must be one line of at most " + std::to_string(kLongestText) +
                                    " bytes.");
}

Result<void> checkPack(const TemplatePack& pack) {
    for (const auto& [text, what] :
         std::vector<std::pair<std::string, const char*>>{{pack.name, "name"},
                                                          {pack.author, "author"},
                                                          {pack.licence, "licence"},
                                                          {pack.version, "version"}}) {
        if (auto ok = checkText(text, what); !ok) return ok;
    }
    if (pack.name.empty()) return fail(Errc::BadValue, "The pack has no name.");
    if (pack.templates.empty()) return fail(Errc::BadValue, "The pack holds no template.");
    if (pack.templates.size() > kMostTemplates) {
        return fail(Errc::TooLarge,
                    "The pack holds more than " + std::to_string(kMostTemplates) + " templates.");
    }
    std::set<std::string> ids;
    for (const Template& t : pack.templates) {
        if (ids.insert(t.id).second) continue;
        return fail(Errc::DuplicateId, "The id " + nameQuoted(t.id) + " comes twice in the pack.");
    }
    return {};
}

std::string manifestText(const TemplatePack& pack) {
    nlohmann::ordered_json out{{"format", kFormat}, {"version", 1}, {"name", pack.name}};
    if (!pack.author.empty()) out["author"] = pack.author;
    if (!pack.licence.empty()) out["licence"] = pack.licence;
    if (!pack.version.empty()) out["pack_version"] = pack.version;
    return out.dump(2) + "\n";
}

void readManifest(const std::string& text, const std::string& place, TemplatePack& pack) {
    const auto tree = parseJson(text, {});
    if (!tree) throwRead(tree.error().code, place + ": " + tree.error().message);
    const ObjectReader manifest(*tree, place);
    manifest.allowOnly({"format", "version", "name", "author", "licence", "pack_version"});
    if (readString(manifest.require("format"), manifest.at("format")) != kFormat) {
        throwRead(Errc::WrongFormat, place + ": /format: this is no pack of templates");
    }
    if (manifest.require("version") != 1) {
        throwRead(Errc::WrongVersion, place + ": /version: this program reads version 1");
    }
    pack.name = readString(manifest.require("name"), manifest.at("name"));
    const auto optional = [&](const char* key, std::string& to) {
        if (const json* v = manifest.find(key)) to = readString(*v, manifest.at(key));
    };
    optional("author", pack.author);
    optional("licence", pack.licence);
    optional("pack_version", pack.version);
}

/// Is a file of the archive a template? Its name says which one.
bool isTemplateName(const std::string& name) {
    return name.starts_with(kFolder) && name.ends_with(kEnding) &&
           name.find('/', kFolder.size()) == std::string::npos;
}

TemplatePack readEntries(const std::vector<ZipEntry>& entries, const std::string& source) {
    TemplatePack pack;
    bool known = false;
    for (const ZipEntry& entry : entries) {
        const std::string place = source + ": " + entry.name;
        if (entry.name == kManifest) {
            readManifest(entry.content, place, pack);
            known = true;
            continue;
        }
        if (!isTemplateName(entry.name)) {
            throwRead(Errc::BadValue, place + " does not belong into a pack of templates");
        }
        auto tmpl = readTemplate(entry.content, place);
        if (!tmpl) throw ReadError{std::move(tmpl).error()};
        pack.templates.push_back(*std::move(tmpl));
    }
    if (!known) throwRead(Errc::MissingKey, source + ": manifest.json is missing");
    if (auto ok = checkPack(pack); !ok) {
        throwRead(ok.error().code, source + ": " + ok.error().message);
    }
    return pack;
}

}  // namespace

Result<std::string> writeTemplatePack(const TemplatePack& pack) {
    if (auto ok = checkPack(pack); !ok) return fail(ok.error());
    std::vector<ZipEntry> entries;
    entries.push_back({std::string(kManifest), manifestText(pack)});
    for (const Template& t : pack.templates) {
        if (auto ok = checkTemplate(t, t.id); !ok) return fail(ok.error());
        std::string name(kFolder);
        name.append(t.id).append(kEnding);
        entries.push_back({std::move(name), writeTemplate(t)});
    }
    return zipBytes(entries);
}

Result<TemplatePack> readTemplatePack(const std::string& bytes, const std::string& source) {
    const auto entries = readZip(bytes, {});
    if (!entries) return fail(entries.error().code, source + ": " + entries.error().message);
    try {
        return readEntries(*entries, source);
    } catch (ReadError& e) {
        return fail(std::move(e.error));
    }
}

}  // namespace ew
