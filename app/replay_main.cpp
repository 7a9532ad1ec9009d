// SPDX-License-Identifier: GPL-3.0-or-later
// edgewright-replay: replays a sketch script, or tells of a document, without a window. The
// contract is in docs/sketch-script.md.
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <cstdio>
#include <optional>

#include "app/screenshot_process.h"
#include "core/document/document_compare.h"
#include "core/document/file_names.h"
#include "core/document/history_change.h"
#include "core/document/recovery.h"
#include "core/document/replay.h"
#include "core/document/replay_arguments.h"
#include "core/document/report.h"
#include "core/document/resources.h"
#include "core/document/store.h"
#include "core/document/work_copy.h"

namespace {

constexpr int kDone = 0;
constexpr int kStepFailed = 1;
constexpr int kUnusable = 2;

int unusable(const ew::Error& error) {
    std::fprintf(stderr, "edgewright-replay: %s (%s)\n", error.message.c_str(),
                 std::string(ew::errcName(error.code)).c_str());
    return kUnusable;
}

ew::Result<ew::TemplateLibrary> templates(const ew::ReplayArguments& arguments) {
    auto load = arguments.templates ? ew::loadTemplates(*arguments.templates, QString())
                                    : ew::loadTemplates();
    if (!load) return ew::fail(load.error());
    for (const ew::Error& problem : load->problems) {
        std::fprintf(stderr, "edgewright-replay: template left out: %s\n", problem.message.c_str());
    }
    return std::move(load->library);
}

/// What the command line names: a script, or a document with what was done in it as a script.
struct Input {
    ew::SketchScript script;
    bool isDocument = false;
};

ew::Result<Input> readInput(const ew::ReplayArguments& arguments, ew::Document& document) {
    auto bytes = ew::readFileBytes(arguments.script, ew::kMaxDocumentBytes);
    if (!bytes) return ew::fail(bytes.error());
    const std::string name = QFileInfo(arguments.script).fileName().toStdString();
    if (auto ok = ew::refuseOtherKinds(name, *bytes); !ok) return ew::fail(ok.error());
    Input input;
    input.isDocument = ew::fileKind(*bytes) == ew::FileKind::Document;
    if (input.isDocument) {
        bytes = std::string();
        if (auto ok = document.open(arguments.script); !ok) return ew::fail(ok.error());
        input.script = document.recordedScript();
    } else {
        auto script = ew::readSketchScript(*bytes);
        if (!script) return ew::fail(script.error());
        input.script = *std::move(script);
    }
    if (arguments.until.isEmpty()) return input;
    const auto end = ew::findStep(input.script, arguments.until.toStdString());
    if (!end) return ew::fail(end.error());
    input.script.steps.resize(*end);
    return input;
}

/// One line for every step but the strokes, of which there are many.
void tell(const ew::StepReport& step) {
    if (!step.ok) {
        std::printf("step %d %s: failed, %s\n", step.index, step.name.c_str(),
                    std::string(ew::errcName(step.error->code)).c_str());
    } else if (step.chosen >= 0) {
        const auto& c = step.interpretation->candidates[static_cast<std::size_t>(step.chosen)];
        std::printf("step %d %s: %s %s, %s, score %.3f\n", step.index, step.name.c_str(),
                    std::string(ew::operationName(c.operation)).c_str(), c.templateId.c_str(),
                    c.aspect.c_str(), c.score);
    } else if (step.name != "stroke" && step.name != "camera") {
        std::printf("step %d %s: done\n", step.index, step.name.c_str());
    }
    for (const std::string& note : step.notes) std::printf("  %s\n", note.c_str());
}

void tellSolid(const ew::Document& document) {
    const auto& bodies = document.state().bodies;
    if (bodies.empty()) {
        std::printf("no solid\n");
        return;
    }
    const ew::SolidSummary s = ew::summarize(bodies);
    std::printf("solid: %d vertices, %d edges, %d faces, volume %.6g, area %.6g\n", s.vertices,
                s.edges, s.faces, s.volume, s.area);
}

/// The files that the command line asked for. A solid that is not there is a failed step where all
/// steps went well, and no news where one had failed.
ew::Result<void> writeFiles(ew::Document& document, const ew::ReplayArguments& arguments,
                            const ew::ReplayReport& report) {
    // Named on the command line, so relative to where it was typed; --out is for the script's
    // steps.
    const QDir here = QDir::current();
    if (!arguments.report.isEmpty()) {
        const std::string name = QFileInfo(arguments.script).fileName().toStdString();
        const std::string text = ew::writeReport(document, report, name);
        const QString path = here.absoluteFilePath(arguments.report);
        if (auto ok = ew::writeFileBytes(path, text); !ok) return ok;
    }
    if (!arguments.saveScript.isEmpty()) {
        const std::string text = ew::writeSketchScript(document.recordedScript());
        const QString path = here.absoluteFilePath(arguments.saveScript);
        if (auto ok = ew::writeFileBytes(path, text); !ok) return ok;
    }
    if (!arguments.save.isEmpty()) {
        if (auto ok = document.saveCopy(here.absoluteFilePath(arguments.save)); !ok) return ok;
    }
    const bool failedBefore = report.firstFailure() != nullptr;
    for (const QString& name : arguments.exports) {
        ew::ExportOptions options(arguments.faces);
        options.unit = arguments.unit;
        options.bodies = arguments.bodies;
        const auto note = document.exportTo(here.absoluteFilePath(name), options);
        if (note && !note->empty()) std::printf("%s: %s\n", qPrintable(name), note->c_str());
        const bool noNews = !note && note.error().code == ew::Errc::NoSolid && failedBefore;
        if (!note && !noNews) return ew::fail(note.error());
    }
    if (!arguments.screenshot.isEmpty()) {
        const auto& camera = document.camera();
        const QSize viewport(static_cast<int>(camera.width), static_cast<int>(camera.height));
        return ew::takeScreenshot(
            document, {here.absoluteFilePath(arguments.screenshot),
                       arguments.size.value_or(viewport), arguments.templates, arguments.look});
    }
    return {};
}

/// Replays into a document, with a working copy of it where that was asked for.
ew::Result<ew::ReplayReport> replayInto(ew::Document& document, const ew::SketchScript& script,
                                        const ew::ReplayArguments& arguments) {
    ew::ReplayOptions options;
    options.scriptFolder = QFileInfo(arguments.script).absolutePath();
    options.outFolder = arguments.outFolder;
    options.keepGoing = arguments.keepGoing;
    options.allowOutside = arguments.allowOutside;
    std::optional<ew::WorkCopy> copy;
    if (!arguments.workCopy.isEmpty()) {
        copy.emplace(document,
                     ew::WorkFolder(QDir::current().absoluteFilePath(arguments.workCopy)));
        copy->keepIdle();  // a camera that was set is a step that was told as done
    }
    ew::Result<void> kept;
    ew::ReplayReport report =
        ew::replay(document, script, options, [&](const ew::StepReport& step) {
            if (copy) kept = copy->flush();
            if (!kept) return false;
            tell(step);
            if (arguments.progress && step.ok) {
                std::printf("done %d\n", step.index);
                std::fflush(stdout);
            }
            return true;
        });
    if (!kept) return ew::fail(kept.error());
    return report;
}

/// Changes the step of the history that the command line names.
ew::Result<void> changeHistory(ew::Document& document, const ew::ReplayArguments& arguments) {
    bool isNumber = false;
    ew::StepChange change;
    change.place = arguments.changedStep.toInt(&isNumber);
    if (!isNumber) return ew::fail(ew::Errc::BadValue, "--change-step needs a number.");
    auto step = ew::readScriptStep(arguments.stepText.toStdString());
    if (!step) return ew::fail(step.error());
    change.step = *std::move(step);
    auto changed = ew::changeStep(document.contents(), document.state().library, change);
    if (!changed) return ew::fail(changed.error());
    std::printf("step %d changed, %d done again\n", change.place, changed->redone);
    for (const ew::MisfitStep& misfit : changed->misfits) {
        std::printf("step %d (%s) no longer fits: %s; %d stroke(s) kept\n", misfit.place,
                    misfit.name.c_str(), misfit.error.message.c_str(), misfit.strokes);
    }
    document.replaceHistory(*std::move(changed));
    return {};
}

int recover(const ew::ReplayArguments& arguments) {
    const auto library = templates(arguments);
    if (!library) return unusable(library.error());
    std::optional<QString> out;
    if (arguments.namesOut) out = arguments.outFolder;
    const ew::WorkFolder folder(QDir::current().absoluteFilePath(arguments.recover));
    const auto list = ew::recoverCopies(folder, out, *library);
    if (!list) return unusable(list.error());
    std::fputs(list->c_str(), stdout);
    return kDone;
}

int run(const ew::ReplayArguments& arguments) {
    const auto library = templates(arguments);
    if (!library) return unusable(library.error());
    ew::Document opened(*library);
    const auto input = readInput(arguments, opened);
    if (!input) return unusable(input.error());
    if (!QDir().mkpath(arguments.outFolder)) {
        return unusable({ew::Errc::CannotWrite,
                         "The folder " + arguments.outFolder.toStdString() + " cannot be made.",
                         {}});
    }
    ew::Document replayed(*library);
    const auto done = replayInto(replayed, input->script, arguments);
    if (!done) return unusable(done.error());
    const ew::ReplayReport& report = *done;
    // A document is told of as it stands; its steps as they are when they are done again.
    const bool asItStands = input->isDocument && arguments.until.isEmpty();
    ew::Document& document = asItStands ? opened : replayed;
    if (asItStands && !ew::identicalDocuments(opened, replayed)) {
        std::printf("replayed by this version, the document comes out differently\n");
    }
    if (!arguments.changedStep.isEmpty()) {
        if (auto ok = changeHistory(document, arguments); !ok) return unusable(ok.error());
    }
    tellSolid(document);
    std::fflush(stdout);
    const ew::StepReport* failed = report.firstFailure();
    if (failed != nullptr) {
        std::fprintf(stderr, "edgewright-replay: step %d (%s) failed: %s (%s)\n", failed->index,
                     failed->name.c_str(), failed->error->message.c_str(),
                     std::string(ew::errcName(failed->error->code)).c_str());
    }
    if (auto ok = writeFiles(document, arguments, report); !ok) {
        const int status = unusable(ok.error());
        return ok.error().code == ew::Errc::NoSolid ? kStepFailed : status;
    }
    // What was told may have gone to a file on a full disk.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        return unusable({ew::Errc::CannotWrite, "What was done could not be told on stdout.", {}});
    }
    return failed == nullptr ? kDone : kStepFailed;
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName("edgewright-replay");
    const auto arguments = ew::parseReplayArguments(QCoreApplication::arguments().mid(1));
    if (!arguments) {
        const int status = unusable(arguments.error());
        std::fputs("Try edgewright-replay --help.\n", stderr);
        return status;
    }
    if (arguments->help) {
        std::fputs(qPrintable(ew::replayHelp()), stdout);
        return kDone;
    }
    if (arguments->version) {
        std::printf("edgewright-replay %s\n", EDGEWRIGHT_VERSION);
        return kDone;
    }
    return arguments->recover.isEmpty() ? run(*arguments) : recover(*arguments);
}
