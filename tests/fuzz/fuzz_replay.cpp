// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a sketch script that is replayed: a step works or says why not and leaves the
// document alone; undoing everything and redoing it ends where it began.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/document/document.h"
#include "core/document/replay.h"
#include "core/document/report.h"
#include "tests/fuzz/fuzz_strokes.h"

namespace {

constexpr std::size_t kMostSteps = 40;
constexpr std::size_t kSurfaceBytes = std::size_t{8} << 20U;  // a few levels of subdivision

void demand(bool kept) {
    if (!kept) std::abort();
}

/// Files are other targets' business.
bool namesAFile(const ew::ScriptStep& step) {
    return std::holds_alternative<ew::SaveStep>(step) ||
           std::holds_alternative<ew::OpenStep>(step) ||
           std::holds_alternative<ew::ExportStep>(step);
}

bool sameSolids(const std::vector<ew::Body>& a, const std::vector<ew::Body>& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(),
        [](const ew::Body& x, const ew::Body& y) { return x.solid.identicalTo(y.solid); });
}

void runAll(ew::Document& document, const ew::SketchScript& script) {
    if (!ew::beginReplay(document, script)) return;
    ew::ReplayReport report;
    for (std::size_t i = 0; i < script.steps.size() && i < kMostSteps; ++i) {
        if (namesAFile(script.steps[i])) continue;
        const auto* before = &document.state();
        const auto ink = document.pendingStrokes().size();
        report.steps.push_back(
            ew::runStep(document, script.steps[i], static_cast<int>(i), ew::ReplayOptions{}));
        const ew::StepReport& done = report.steps.back();
        demand(done.ok != done.error.has_value());
        if (done.ok) continue;
        demand(done.error->code != ew::Errc::Internal && !done.error->message.empty());
        demand(&document.state() == before && document.pendingStrokes().size() == ink);
    }
    demand(!ew::writeReport(document, report, "fuzz").empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto script = ew::readSketchScript({reinterpret_cast<const char*>(data), size});
    if (!script) return 0;
    ew::Document document(ew::fuzz::shippedTemplates());
    document.setSurfaceMemoryLimit(kSurfaceBytes);
    runAll(document, *script);
    const std::vector<ew::Body> bodies = document.state().bodies;
    int taken = 0;
    while (document.undo()) ++taken;
    demand(document.state().bodies.empty());
    demand(taken == 0 || document.redo(taken).has_value());
    demand(sameSolids(document.state().bodies, bodies));
    return 0;
}
