// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/replay.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QUndoStack>
#include <algorithm>
#include <charconv>
#include <filesystem>

#include "core/document/json_text.h"
#include "core/document/recorder.h"

namespace ew {

namespace {

constexpr double kNsPerMs = 1e6;
constexpr double kScriptObliqueFactor = 0.5;  // where an apply step does not say another

/// Runs one step; what an apply read goes to the report.
class StepRunner {
  public:
    StepRunner(Document& document, const ReplayOptions& options, StepReport& report)
        : document_(document), options_(options), report_(report) {}

    Result<void> operator()(const CameraStep& s) {
        return document_.setCamera(withStep(document_.camera(), s));
    }
    Result<void> operator()(const ThresholdsStep& s) {
        return document_.setThresholds(withStep(document_.thresholds(), s));
    }
    Result<void> operator()(const StrokeStep& s) {
        return dropValue(document_.addStroke(s.stroke));
    }
    Result<void> operator()(const EraseStep& s) { return dropValue(document_.eraseAt(s.at)); }
    Result<void> operator()(const ClearStep&) {
        document_.clearStrokes();
        return {};
    }
    Result<void> operator()(const ApplyStep& s) {
        ApplyRequest request{s.candidate, s.templateId,
                             s.operation, s.obliqueFactor.value_or(kScriptObliqueFactor),
                             s.keep,      s.level};
        auto outcome = document_.apply(request);
        if (outcome) {
            report_.interpretation = std::move(outcome->interpretation);
            report_.chosen = outcome->chosen;
            return {};
        }
        const bool readable =
            request.templateId.empty() || document_.state().library.find(request.templateId) >= 0;
        if (readable) report_.interpretation = document_.interpretationFor(request);
        return fail(outcome.error());
    }
    Result<void> operator()(const FilletStep& s) {
        FilletRequest request;
        const auto edges = choice(s);
        if (!edges) return fail(edges.error());
        request.edges = *edges;
        request.radius = s.radius;
        request.segments = s.segments;
        auto outcome = document_.fillet(request);
        if (!outcome) return fail(outcome.error());
        for (const ClampedEdge& c : outcome->clamped) {
            report_.notes.push_back(clampText(document_.state().bodies, c));
        }
        return {};
    }
    Result<void> operator()(const SharpenStep& s) {
        const auto edges = choice(s);
        if (!edges) return fail(edges.error());
        return document_.sharpen(*edges);
    }
    Result<void> operator()(const CreaseStep& s) {
        const auto edges = choice(s);
        if (!edges) return fail(edges.error());
        return document_.crease(*edges, s.sharpness.value_or(kAutomaticSharpness));
    }
    Result<void> operator()(const SubdivideStep& s) {
        SubdivisionSettings settings;
        settings.on = s.tolerance || *s.levels > 0;
        settings.scheme =
            s.scheme == "loop" ? SubdivisionScheme::Loop : SubdivisionScheme::CatmullClark;
        settings.levels = s.levels.value_or(settings.levels);
        settings.tolerance = s.tolerance.value_or(0.0);
        settings.sharpness = s.crease;
        settings.sharpCorners = s.sharpCorners;
        return document_.subdivide(settings);
    }
    Result<void> operator()(const MapStrokesStep& s) {
        const auto color =
            s.color.empty() ? Result<StrokeColor>(kDefaultStrokeColor) : parseColor(s.color);
        if (!color) return fail(color.error());
        const auto outcome = document_.mapStrokes(*color);
        if (!outcome) return fail(outcome.error());
        if (outcome->missed > 0) {
            report_.notes.push_back(std::to_string(outcome->missed) +
                                    " strokes have no surface under them and stay as they are.");
        }
        return {};
    }
    Result<void> operator()(const UnmapStrokesStep&) { return document_.unmapStrokes(); }
    Result<void> operator()(const DefineTemplateStep& s) {
        if (s.tmpl) return document_.defineTemplate(*s.tmpl, s.replace);
        return document_.defineTemplateFromSolid(s.id, s.name);
    }
    Result<void> operator()(const DeleteSolidStep&) { return document_.deleteBodies(); }
    Result<void> operator()(const UndoStep& s) {
        if (!s.ink) return document_.undo(s.count);
        for (int i = 0; i < s.count; ++i) {
            if (!document_.undoInk()) {
                return fail(Errc::NothingToUndo, "There is no ink to undo since the last step.");
            }
        }
        return {};
    }
    Result<void> operator()(const RedoStep& s) {
        if (!s.ink) return document_.redo(s.count);
        for (int i = 0; i < s.count; ++i) {
            if (!document_.redoInk()) {
                return fail(Errc::NothingToRedo, "There is no ink to redo before the next step.");
            }
        }
        return {};
    }
    Result<void> operator()(const SaveStep& s) {
        const auto path = pathToWrite(s.path);
        if (!path) return fail(path.error());
        if (auto ok = document_.save(*path); !ok) return ok;
        options_.saved->insert(*path);
        return {};
    }
    Result<void> operator()(const OpenStep& s) {
        const auto path = pathToOpen(s.path);
        if (!path) return fail(path.error());
        return document_.open(*path);
    }
    Result<void> operator()(const ExportStep& s) {
        const auto path = pathToWrite(s.path);
        if (!path) return fail(path.error());
        ExportOptions options(s.faces);
        options.unit = s.unit;
        options.bodies = s.bodies;
        const auto note = document_.exportTo(*path, options);
        if (note && !note->empty()) report_.notes.push_back(*note);
        return dropValue(note);
    }
    Result<void> operator()(const NameStep& s) {
        return document_.nameState(s.state.value_or(document_.undoStack().index()), s.name);
    }
    Result<void> operator()(const CompactStep&) { return document_.compactHistory(); }
    Result<void> operator()(const PullStep& s) {
        int body = -1;
        if (s.body) {
            const auto named = bodyOf(*s.body);
            if (!named) return fail(named.error());
            body = *named;
        }
        const auto face = nearestFace(document_.state().bodies, s.at, body);
        if (!face) return fail(face.error());
        PullRequest request{*face, s.distance, s.walls};
        if (!s.whole && !document_.pendingStrokes().empty()) {
            auto outline = document_.outlineAt(s.at);
            if (outline && outline->profile.body == face->body &&
                outline->profile.face == face->face) {
                request.outline = *std::move(outline);
            } else if (!outline && outline.error().code != Errc::NoRegion &&
                       outline.error().code != Errc::NoSurface) {
                return fail(outline.error());
            }
        }
        return document_.pull(request);
    }
    Result<void> operator()(const MoveBodyStep& s) {
        return onBody(s.body, [&](int b) { return dropValue(document_.moveBody(b, s.move)); });
    }
    Result<void> operator()(const NameBodyStep& s) {
        return onBody(s.body, [&](int b) { return document_.nameBody(b, s.name); });
    }
    Result<void> operator()(const ShowBodyStep& s) {
        return onBody(s.body, [&](int b) { return document_.showBody(b, s.visible); });
    }
    Result<void> operator()(const DeleteBodyStep& s) {
        return onBody(s.body, [&](int b) { return document_.deleteBody(b); });
    }
    Result<void> operator()(const MirrorPlaneStep& s) { return document_.setMirror(s.plane); }
    Result<void> operator()(const CombineBodiesStep& s) {
        return onBody(s.body, [&](int b) -> Result<void> {
            const auto other = bodyOf(s.other);
            if (!other) return fail(other.error());
            return document_.combineBodies(b, *other, s.kind);
        });
    }

  private:
    /// The index of a body that a step names; one out of range is for the document to refuse.
    Result<int> bodyOf(const BodyWord& word) const {
        if (word.index >= 0) return word.index;
        return findBody(document_.state().bodies, word.name);
    }
    template <class Deed>
    Result<void> onBody(const BodyWord& word, const Deed& deed) const {
        const auto body = bodyOf(word);
        if (!body) return fail(body.error());
        return deed(*body);
    }
    Result<QString> pathIn(const QString& folder, const std::string& file) const {
        const QString path = QString::fromStdString(file);
        if (options_.allowOutside) return QDir::cleanPath(QDir(folder).absoluteFilePath(path));
        return pathInside(folder, path);
    }
    /// In the output folder, with the folder of the file made where it is not there.
    Result<QString> pathToWrite(const std::string& file) const {
        auto path = pathIn(options_.outFolder, file);
        if (path && !QDir().mkpath(QFileInfo(*path).path())) {
            return fail(Errc::CannotWrite,
                        "The folder of " + path->toStdString() + " cannot be made.");
        }
        return path;
    }
    /// What this replay saved; else a file beside the script; else one in the output folder.
    Result<QString> pathToOpen(const std::string& file) const {
        auto beside = pathIn(options_.scriptFolder, file);
        const auto written = pathIn(options_.outFolder, file);
        if (!beside || !written) return beside;
        if (options_.saved->contains(*written)) return written;
        return QFileInfo::exists(*beside) || !QFileInfo::exists(*written) ? beside : written;
    }
    template <class T>
    static Result<void> dropValue(const Result<T>& result) {
        if (!result) return fail(result.error());
        return {};
    }
    /// The edges that a step names.
    Result<EdgeChoice> choice(const EdgeWords& words) const {
        EdgeChoice out;
        switch (words.which) {
            case EdgeWords::Which::All:
                return out;
            case EdgeWords::Which::Convex:
                out.which = EdgeChoice::Which::Convex;
                return out;
            case EdgeWords::Which::Concave:
                out.which = EdgeChoice::Which::Concave;
                return out;
            case EdgeWords::Which::Near:
                break;
        }
        out.which = EdgeChoice::Which::Picked;
        for (std::size_t i = 0; i < words.near.size(); ++i) {
            const int body = i < words.bodies.size() ? words.bodies[i] : -1;
            const auto edge = nearestEdge(document_.state().bodies, words.near[i], body);
            if (!edge) return fail(edge.error());
            out.picked.push_back(*edge);
        }
        return out;
    }

    Document& document_;
    const ReplayOptions& options_;
    StepReport& report_;
};

/// Where a file is or would be made once all symbolic links on the way are followed, also one that
/// leads to what is not there yet.
std::filesystem::path realPath(const QString& path) {
    namespace fs = std::filesystem;
    constexpr int kMostLinks = 40;  // what the system itself follows
    std::error_code ec;
    fs::path at = QFileInfo(path).filesystemAbsoluteFilePath();
    for (int i = 0; i < kMostLinks; ++i) {
        at = fs::weakly_canonical(at, ec);
        if (!fs::is_symlink(at, ec)) break;
        at = at.parent_path() / fs::read_symlink(at, ec);
    }
    return at;
}

}  // namespace

const StepReport* ReplayReport::firstFailure() const {
    for (const StepReport& step : steps) {
        if (!step.ok) return &step;
    }
    return nullptr;
}

Result<std::size_t> findStep(const SketchScript& script, const std::string& name) {
    const auto none = [&] {
        return fail(Errc::BadValue, "The script has no step \"" + name + "\"; it has " +
                                        std::to_string(script.steps.size()) +
                                        " steps. Name one by its index or as in apply:3.");
    };
    const auto number = [](std::string_view text) -> std::optional<std::size_t> {
        std::size_t value = 0;
        const char* end = text.data() + text.size();
        const auto [last, error] = std::from_chars(text.data(), end, value);
        if (error != std::errc() || last != end) return std::nullopt;
        return value;
    };
    if (const auto index = number(name)) {
        if (*index > script.steps.size()) return none();
        return *index;
    }
    const std::size_t colon = name.find(':');
    const auto which = colon == std::string::npos ? 1 : number(name.substr(colon + 1));
    if (!which || *which == 0) return none();
    std::size_t left = *which;
    for (std::size_t i = 0; i < script.steps.size(); ++i) {
        if (stepName(script.steps[i]) == name.substr(0, colon) && --left == 0) return i;
    }
    return none();
}

Result<QString> pathInside(const QString& folder, const QString& path) {
    const QString clean = QDir::cleanPath(path);
    if (QDir::isAbsolutePath(path) || clean == ".." || clean.startsWith("../") || clean == "." ||
        path.endsWith('/') || clean.contains(QChar(0))) {
        return fail(Errc::BadValue, "The path " + nameQuoted(path.toStdString()) +
                                        " must name a file inside the folder it is relative to "
                                        "(edgewright-replay --allow-outside allows others).");
    }
    const QString base = QDir(folder.isEmpty() ? QStringLiteral(".") : folder).absolutePath();
    const QString whole = QDir(base).absoluteFilePath(clean);
    const auto inside = realPath(base);
    const auto real = realPath(whole);
    const auto [end, rest] = std::mismatch(inside.begin(), inside.end(), real.begin(), real.end());
    if (end != inside.end() || rest == real.end()) {
        return fail(Errc::BadValue, "The path " + nameQuoted(path.toStdString()) +
                                        " leads out of the folder it is relative to by a symbolic "
                                        "link (edgewright-replay --allow-outside allows it).");
    }
    return whole;
}

Result<void> beginReplay(Document& document, const SketchScript& script) {
    document.reset();
    document.setTitle(script.title);
    OrthographicCamera camera;
    camera.width = script.viewport[0];
    camera.height = script.viewport[1];
    if (auto ok = document.setCamera(camera); !ok) return ok;
    if (auto ok = document.setThresholds(script.thresholds); !ok) return ok;
    document.setAutomaticDistance(!script.namesDistance);
    return {};
}

std::optional<std::string> fileOfStep(const ScriptStep& step) {
    if (const auto* save = std::get_if<SaveStep>(&step)) return save->path;
    if (const auto* open = std::get_if<OpenStep>(&step)) return open->path;
    if (const auto* exported = std::get_if<ExportStep>(&step)) return exported->path;
    return std::nullopt;
}

StepReport runStep(Document& document, const ScriptStep& step, int index,
                   const ReplayOptions& options) {
    StepReport report;
    report.index = index;
    report.name = stepName(step);
    if (options.leaveOutFiles && fileOfStep(step)) {
        report.leftOut = true;
        return report;
    }
    QElapsedTimer clock;
    clock.start();
    const Result<void> result = std::visit(StepRunner(document, options, report), step);
    report.ms = static_cast<double>(clock.nsecsElapsed()) / kNsPerMs;
    report.ok = result.has_value();
    if (!result) report.error = result.error();
    return report;
}

ReplayReport replay(Document& document, const SketchScript& script, const ReplayOptions& options,
                    const std::function<bool(const StepReport&)>& onStep) {
    ReplayReport report;
    QElapsedTimer clock;
    clock.start();
    if (auto ok = beginReplay(document, script); !ok) {
        StepReport begin;
        begin.name = "begin";
        begin.ok = false;
        begin.error = ok.error();
        report.steps.push_back(std::move(begin));
        return report;
    }
    int index = 0;
    for (const ScriptStep& step : script.steps) {
        report.steps.push_back(runStep(document, step, index++, options));
        const StepReport& done = report.steps.back();
        if (onStep && !onStep(done)) break;
        if (!done.ok && !options.keepGoing) break;
    }
    report.msTotal = static_cast<double>(clock.nsecsElapsed()) / kNsPerMs;
    return report;
}

}  // namespace ew
