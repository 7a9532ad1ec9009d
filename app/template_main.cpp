// SPDX-License-Identifier: GPL-3.0-or-later
// edgewright-template: checks, lists and packs templates without a window, e.g. in an author's own
// CI.
#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/tolerance.h"
#include "core/document/file_bytes.h"
#include "core/document/file_fault.h"
#include "core/document/read_mesh.h"
#include "core/document/replay.h"
#include "core/document/resources.h"
#include "core/document/template_from_solid.h"
#include "core/document/template_id.h"
#include "core/document/template_pack.h"
#include "core/document/tool_words.h"
#include "core/reading/confusion.h"
#include "core/tlib/found_relations.h"
#include "core/tlib/library.h"
#include "core/tlib/library_index.h"
#include "core/tlib/mesh_shape.h"
#include "core/tlib/template_io.h"

namespace {

using Json = nlohmann::ordered_json;

constexpr int kDone = 0;
constexpr int kFaults = 1;
constexpr int kUnusable = 2;
constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

constexpr const char* kHelp =
    "edgewright-template check FILE...        is each a template or a pack that can be used?\n"
    "edgewright-template aspects FILE...      the 2D Edge Graphs that each template can show\n"
    "edgewright-template confusion FILE...    what random drawings of each are read as, against "
    "all\n"
    "                    [--count N] [--level light|normal|rough] [--seed S]\n"
    "edgewright-template pack FILE... --out PACK --name NAME [--author A] [--licence L]\n"
    "                    [--pack-version V]   one file to pass on\n"
    "edgewright-template convert FILE --out TEMPLATE [--name NAME] [--id ID]\n"
    "                    a template of an OBJ or PLY mesh, or of the solid that a sketch script\n"
    "                    makes\n"
    "  --json      print JSON\n"
    "  --help, --version\n"
    "FILE is a template (.json) or a pack (.edgewright-templates).\n"
    "Exit status: 0 all is well, 1 there are faults (one line each: FILE: /json/path: sentence),\n"
    "2 the arguments or a file cannot be used.\n";

struct Arguments : ew::ToolWords {
    QString out, name, author, licence, packVersion;
    QString count, level, seed, id;
};

int unusable(const std::string& message) {
    std::fprintf(stderr, "edgewright-template: %s\n", message.c_str());
    return kUnusable;
}

/// The templates of files, and what is wrong with those that have none.
struct Loaded {
    std::vector<std::pair<QString, ew::Template>> templates;
    std::vector<ew::FileFault> faults;
};

bool isPack(const std::string& bytes) { return bytes.starts_with("PK"); }

ew::Result<Loaded> load(const QStringList& files) {
    Loaded out;
    for (const QString& file : files) {
        const auto bytes = ew::readFileBytes(file, kMostBytes);
        if (!bytes) return ew::fail(bytes.error());
        const std::string name = file.toStdString();
        if (isPack(*bytes)) {
            auto pack = ew::readTemplatePack(*bytes, name);
            if (!pack) {
                out.faults.push_back(ew::fileFault(file.toStdString(), pack.error()));
                continue;
            }
            for (ew::Template& t : pack->templates) out.templates.emplace_back(file, std::move(t));
            continue;
        }
        auto tmpl = ew::readTemplate(*bytes, name);
        if (tmpl)
            out.templates.emplace_back(file, *std::move(tmpl));
        else
            out.faults.push_back(ew::fileFault(file.toStdString(), tmpl.error()));
    }
    return out;
}

/// Two templates of one id cannot both be used.
void findTwins(Loaded& loaded) {
    for (std::size_t i = 0; i < loaded.templates.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const auto& [file, t] = loaded.templates[i];
            if (t.id != loaded.templates[k].second.id) continue;
            loaded.faults.push_back({file.toStdString(), "/id",
                                     "the id \"" + t.id + "\" is also that of " +
                                         loaded.templates[k].first.toStdString(),
                                     ew::Errc::DuplicateId});
            break;
        }
    }
}

int tellFaults(const Loaded& loaded, bool asJson) {
    if (asJson) {
        Json faults = Json::array();
        for (const ew::FileFault& f : loaded.faults) {
            faults.push_back({{"file", f.file},
                              {"path", f.path},
                              {"code", ew::errcName(f.code)},
                              {"message", f.message}});
        }
        Json templates = Json::array();
        for (const auto& [file, t] : loaded.templates) {
            templates.push_back({{"file", file.toStdString()}, {"id", t.id}, {"name", t.name}});
        }
        const Json out{{"format", "edgewright-template-check"},
                       {"version", 1},
                       {"templates", templates},
                       {"faults", faults}};
        std::printf("%s\n", out.dump(1, ' ', false, Json::error_handler_t::replace).c_str());
    } else {
        for (const ew::FileFault& f : loaded.faults) {
            std::printf("%s\n", f.line().c_str());
        }
    }
    return loaded.faults.empty() ? kDone : kFaults;
}

const char* kindName(ew::AspectKind kind) {
    switch (kind) {
        case ew::AspectKind::Mouth:
            return "mouth";
        case ew::AspectKind::Cavity:
            return "cavity";
        case ew::AspectKind::Explicit:
            break;
    }
    return "explicit";
}

int tellAspects(const Loaded& loaded, bool asJson) {
    Json list = Json::array();
    for (const auto& [file, t] : loaded.templates) {
        const auto library = ew::TemplateLibrary().with(t);
        if (!library) return unusable(library.error().message);
        Json aspects = Json::array();
        if (!asJson) std::printf("%s (%s)\n", t.id.c_str(), t.name.c_str());
        for (const ew::Aspect& a : library->index().entries.front()->aspects) {
            aspects.push_back({{"name", a.name},
                               {"kind", kindName(a.kind)},
                               {"vertices", a.graph.points.size()},
                               {"edges", a.graph.edges.size()},
                               {"visible_faces", a.visibleFaces.size()},
                               {"mouth_faces", a.mouth.size()}});
            if (asJson) continue;
            std::printf("  %-16s %-9s %2zu vertices %2zu edges %zu faces\n", a.name.c_str(),
                        kindName(a.kind), a.graph.points.size(), a.graph.edges.size(),
                        a.visibleFaces.size());
        }
        list.push_back({{"file", file.toStdString()}, {"id", t.id}, {"aspects", aspects}});
    }
    if (asJson) {
        const Json out{
            {"format", "edgewright-template-aspects"}, {"version", 1}, {"templates", list}};
        std::printf("%s\n", out.dump(1, ' ', false, Json::error_handler_t::replace).c_str());
    }
    return kDone;
}

/// Nothing where the words are none that can be used.
std::optional<ew::ConfusionOptions> confusionOptions(const Arguments& arguments) {
    constexpr int kMostDrawings = 100'000;
    ew::ConfusionOptions out;
    bool ok = true;
    if (!arguments.count.isEmpty()) out.drawings = arguments.count.toInt(&ok);
    if (!ok || out.drawings < 1 || out.drawings > kMostDrawings) return std::nullopt;
    if (!arguments.seed.isEmpty()) out.seed = arguments.seed.toULongLong(&ok);
    if (!ok) return std::nullopt;
    if (arguments.level == QStringLiteral("normal")) {
        out.hand = ew::kNormalHand;
    } else if (arguments.level == QStringLiteral("rough")) {
        out.hand = ew::kRoughHand;
    } else if (!arguments.level.isEmpty() && arguments.level != QStringLiteral("light")) {
        return std::nullopt;
    }
    out.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    return out;
}

/// The shipped templates, those of the files in the place of shipped ones with their ids.
ew::Result<ew::TemplateLibrary> withShipped(const Loaded& loaded) {
    std::vector<ew::Template> all;
    for (const auto& [file, t] : loaded.templates) all.push_back(t);
    if (const auto shipped = ew::loadTemplates()) {
        for (const auto& entry : shipped->library.index().entries) {
            const bool shadowed = std::any_of(all.begin(), all.end(), [&](const ew::Template& t) {
                return t.id == entry->tmpl.id;
            });
            if (!shadowed) all.push_back(entry->tmpl);
        }
    }
    ew::TemplateLibrary library;
    for (const ew::Template& t : all) {
        auto more = library.with(t);
        if (!more) return more;
        library = *std::move(more);
    }
    return library;
}

Json confusionJson(const std::vector<ew::ConfusionRow>& rows) {
    Json list = Json::array();
    for (const ew::ConfusionRow& row : rows) {
        Json readAs = Json::object();
        for (const auto& [id, count] : row.readAs) readAs[id] = count;
        list.push_back({{"id", row.templateId},
                        {"drawings", row.drawings},
                        {"right", row.right()},
                        {"asked", row.asked},
                        {"refused", row.refused},
                        {"read_as", readAs}});
    }
    return {{"format", "edgewright-template-confusion"}, {"version", 1}, {"templates", list}};
}

int tellConfusion(const Arguments& arguments, const Loaded& loaded) {
    const auto options = confusionOptions(arguments);
    if (!options) return unusable("--count is 1 to 100000, --level light, normal or rough");
    const auto library = withShipped(loaded);
    if (!library) return unusable(library.error().message);
    std::vector<std::string> ids;
    for (const auto& [file, t] : loaded.templates) ids.push_back(t.id);
    const std::vector<ew::ConfusionRow> rows = ew::confusion(*library, ids, *options);
    if (arguments.json) {
        std::printf(
            "%s\n",
            confusionJson(rows).dump(1, ' ', false, Json::error_handler_t::replace).c_str());
    } else {
        std::printf("%-24s drawings right asked refused  taken for something else\n", "template");
    }
    // More than one drawing in fifty that becomes another solid in silence is a fault.
    constexpr int kOneIn = 50;
    int status = kDone;
    for (const ew::ConfusionRow& row : rows) {
        if (row.drawings == 0 || row.wrong() * kOneIn > row.drawings) status = kFaults;
        if (arguments.json) continue;
        std::printf("%-24s %8d %5d %5d %7d ", row.templateId.c_str(), row.drawings, row.right(),
                    row.asked, row.refused);
        for (const auto& [id, count] : row.readAs) {
            if (id != row.templateId) std::printf(" %s %d", id.c_str(), count);
        }
        std::printf("%s\n", row.drawings == 0 ? " no view of it can be told" : "");
    }
    return status;
}

int pack(const Arguments& arguments, Loaded loaded) {
    if (arguments.out.isEmpty() || arguments.name.isEmpty()) {
        return unusable("pack needs --out and --name");
    }
    ew::TemplatePack made{arguments.name.toStdString(),
                          arguments.author.toStdString(),
                          arguments.licence.toStdString(),
                          arguments.packVersion.toStdString(),
                          {}};
    for (auto& [file, t] : loaded.templates) made.templates.push_back(std::move(t));
    const auto bytes = ew::writeTemplatePack(made);
    if (!bytes) return unusable(bytes.error().message);
    QString path = arguments.out;
    const QString ending = QStringLiteral(".edgewright-templates");
    if (!path.endsWith(ending)) path += ending;
    if (auto ok = ew::writeFileBytes(path, *bytes); !ok) return unusable(ok.error().message);
    return kDone;
}

/// The solid that a sketch script makes; its files are neither read nor written.
ew::Result<ew::Template> solidOfScript(const std::string& bytes) {
    const auto script = ew::readSketchScript(bytes);
    if (!script) return ew::fail(script.error());
    const auto shipped = ew::loadTemplates();
    if (!shipped) return ew::fail(shipped.error());
    ew::Document document(shipped->library);
    ew::ReplayOptions options;
    options.leaveOutFiles = true;
    const ew::ReplayReport report = ew::replay(document, *script, options);
    if (const ew::StepReport* failed = report.firstFailure(); failed != nullptr) {
        return ew::fail(failed->error->code, "step " + std::to_string(failed->index) + " (" +
                                                 failed->name + "): " + failed->error->message);
    }
    return ew::templateFromBodies(document.state().bodies, {}, {});
}

ew::Result<ew::Template> templateOfMesh(const std::string& bytes, const std::string& source) {
    const auto mesh = ew::readMesh(bytes, source);
    if (!mesh) return ew::fail(mesh.error());
    auto shape = ew::shapeOfMesh(*mesh);
    if (!shape) return ew::fail(shape.error());
    ew::Template out;
    out.shape = *std::move(shape);
    // Most files have numbers of seven digits.
    for (const ew::FoundRelation& found :
         ew::findRelations(out.shape, ew::tol::kTemplateRelation)) {
        if (found.kind != ew::RelationKind::EqualLength) ew::addRelation(out.relations, found);
    }
    return out;
}

/// 1 where the file can be read and makes no template, 2 where it cannot be read.
int convert(const Arguments& arguments) {
    if (arguments.files.size() != 1 || arguments.out.isEmpty()) {
        return unusable("convert needs one file and --out");
    }
    const QString& file = arguments.files.front();
    const auto bytes = ew::readFileBytes(file, kMostBytes);
    if (!bytes) return unusable(bytes.error().message);
    const std::string source = file.toStdString();
    const bool isScript = bytes->find_first_not_of(" \t\r\n") != std::string::npos &&
                          (*bytes)[bytes->find_first_not_of(" \t\r\n")] == '{';
    auto tmpl = isScript ? solidOfScript(*bytes) : templateOfMesh(*bytes, source);
    if (tmpl) {
        const QString base = QFileInfo(file).completeBaseName();
        tmpl->name = (arguments.name.isEmpty() ? base : arguments.name).toStdString();
        tmpl->id = arguments.id.isEmpty() ? ew::idFromName(tmpl->name) : arguments.id.toStdString();
        if (const auto ok = ew::checkTemplate(*tmpl, source); !ok) tmpl = ew::fail(ok.error());
    }
    if (!tmpl) {
        Loaded loaded;
        loaded.faults.push_back(ew::fileFault(source, tmpl.error()));
        return tellFaults(loaded, arguments.json);
    }
    const auto written = ew::writeFileBytes(arguments.out, ew::writeTemplate(*tmpl));
    return written ? kDone : unusable(written.error().message);
}

ew::Result<Arguments> readArguments(const QStringList& words) {
    Arguments out;
    auto said = ew::readToolWords(
        words,
        {QStringLiteral("check"), QStringLiteral("aspects"), QStringLiteral("confusion"),
         QStringLiteral("pack"), QStringLiteral("convert")},
        {{"--out", &out.out},
         {"--name", &out.name},
         {"--author", &out.author},
         {"--licence", &out.licence},
         {"--pack-version", &out.packVersion},
         {"--count", &out.count},
         {"--level", &out.level},
         {"--seed", &out.seed},
         {"--id", &out.id}});
    if (!said) return ew::fail(said.error());
    static_cast<ew::ToolWords&>(out) = *std::move(said);
    return out;
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    const QStringList words = QCoreApplication::arguments().mid(1);
    if (words.contains(QStringLiteral("--help"))) {
        std::printf("%s", kHelp);
        return kDone;
    }
    if (words.contains(QStringLiteral("--version"))) {
        std::printf("edgewright-template %s\n", EDGEWRIGHT_VERSION);
        return kDone;
    }
    const auto read = readArguments(words);
    if (!read) {
        std::fprintf(stderr, "edgewright-template: %s\n%s", read.error().message.c_str(), kHelp);
        return kUnusable;
    }
    const Arguments& arguments = *read;
    if (arguments.command == QStringLiteral("convert")) return convert(arguments);
    auto loaded = load(arguments.files);
    if (!loaded) return unusable(loaded.error().message);
    findTwins(*loaded);
    if (arguments.command == QStringLiteral("check")) return tellFaults(*loaded, arguments.json);
    if (!loaded->faults.empty()) return tellFaults(*loaded, arguments.json);
    if (arguments.command == QStringLiteral("confusion")) return tellConfusion(arguments, *loaded);
    return arguments.command == QStringLiteral("aspects") ? tellAspects(*loaded, arguments.json)
                                                          : pack(arguments, *std::move(loaded));
}
