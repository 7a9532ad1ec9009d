// SPDX-License-Identifier: GPL-3.0-or-later
// edgewright-replay: replays a sketch script without a window. The contract is in
// docs/sketch-script.md.
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <cstdio>

#include "app/screenshot_process.h"
#include "core/document/file_names.h"
#include "core/document/replay.h"
#include "core/document/replay_arguments.h"
#include "core/document/report.h"
#include "core/document/resources.h"
#include "core/document/store.h"

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

ew::Result<ew::SketchScript> readScript(const ew::ReplayArguments& arguments) {
    auto text = ew::readFileBytes(arguments.script, ew::kMaxScriptBytes);
    if (!text) return ew::fail(text.error());
    const std::string name = QFileInfo(arguments.script).fileName().toStdString();
    if (auto ok = ew::refuseOtherKinds(name, *text); !ok) return ew::fail(ok.error());
    auto script = ew::readSketchScript(*text);
    if (!script || arguments.until.isEmpty()) return script;
    const auto end = ew::findStep(*script, arguments.until.toStdString());
    if (!end) return ew::fail(end.error());
    script->steps.resize(*end);
    return script;
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
    const bool failedBefore = report.firstFailure() != nullptr;
    for (const QString& name : arguments.exports) {
        const auto note = document.exportTo(here.absoluteFilePath(name), arguments.faces);
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

int run(const ew::ReplayArguments& arguments) {
    const auto script = readScript(arguments);
    if (!script) return unusable(script.error());
    const auto library = templates(arguments);
    if (!library) return unusable(library.error());
    if (!QDir().mkpath(arguments.outFolder)) {
        return unusable({ew::Errc::CannotWrite,
                         "The folder " + arguments.outFolder.toStdString() + " cannot be made.",
                         {}});
    }
    ew::Document document(*library);
    ew::ReplayOptions options;
    options.scriptFolder = QFileInfo(arguments.script).absolutePath();
    options.outFolder = arguments.outFolder;
    options.keepGoing = arguments.keepGoing;
    options.allowOutside = arguments.allowOutside;
    const ew::ReplayReport report =
        ew::replay(document, *script, options, [](const ew::StepReport& step) {
            tell(step);
            return true;
        });
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
    return run(*arguments);
}
