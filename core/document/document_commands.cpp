// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/document/applied_state.h"
#include "core/document/document.h"
#include "core/document/document_private.h"
#include "core/document/json_text.h"
#include "core/document/level.h"
#include "core/document/step_names.h"
#include "core/document/template_from_solid.h"

namespace ew {

// The command ------------------------------------------------------------------------------------

StateCommand::StateCommand(Document::Private& document, const QString& name,
                           std::shared_ptr<const DocumentState> stateBefore,
                           std::shared_ptr<const DocumentState> stateAfter)
    : QUndoCommand(shownStepName(name)),
      english(name),
      before(std::move(stateBefore)),
      after(std::move(stateAfter)),
      document_(document) {
    place = document.stack.index();
}

void StateCommand::undo() {
    document_.stepChanged(place);
    document_.state = before;
    inkAfter = document_.ink.restore(consumed, inkBefore);
}

void StateCommand::redo() {
    document_.stepChanged(place);
    document_.state = after;
    document_.ink.consume(consumed, inkBefore, std::exchange(inkAfter, {}));
}

// Private: the stack -----------------------------------------------------------------------------

void Document::Private::push(const QString& name, std::shared_ptr<const DocumentState> after,
                             std::vector<PendingStroke> consumed,
                             std::shared_ptr<ApplyMemory> memory) {
    const std::shared_ptr<const DocumentState> before = state;
    auto* command = new StateCommand(*this, name, before, std::move(after));  // the stack owns it
    const bool tookInk = !consumed.empty();
    command->consumed = std::move(consumed);
    command->inkBefore = ink.takeHistory();
    if (memory) {
        const auto chosen = static_cast<std::size_t>(memory->outcome.chosen);
        command->templateId = memory->outcome.interpretation.candidates[chosen].templateId;
    }
    command->memory = std::move(memory);
    movingStack = true;
    stack.push(command);
    movingStack = false;
    stackIndex = stack.index();
    reading.reset();
    touch();
    if (tookInk) emitChange(DocumentChange::Ink);
    stateChanged(*before);
}

namespace {

bool sameStroke(const MappedStroke& a, const MappedStroke& b) {
    return a.id == b.id && a.color == b.color;
}

}  // namespace

void Document::Private::stateChanged(const DocumentState& before) {
    if (!before.library.sharesDataWith(state->library)) emitChange(DocumentChange::Library);
    const bool sameBodies = before.bodies.size() == state->bodies.size() &&
                            std::equal(before.bodies.begin(), before.bodies.end(),
                                       state->bodies.begin(), [](const Body& a, const Body& b) {
                                           return a.solid.sharesDataWith(b.solid) &&
                                                  a.hidden == b.hidden && a.name == b.name &&
                                                  a.pose.rotation == b.pose.rotation &&
                                                  a.pose.translation == b.pose.translation;
                                       });
    if (!sameBodies) emitChange(DocumentChange::Bodies);
    const bool sameStrokes =
        before.mapped.size() == state->mapped.size() &&
        std::equal(before.mapped.begin(), before.mapped.end(), state->mapped.begin(), sameStroke);
    if (!sameBodies || !sameStrokes || before.surface != state->surface) {
        emitChange(DocumentChange::Shape);
    }
    emitChange(DocumentChange::Reading);
    emitChange(DocumentChange::History);
}

void Document::Private::onStackMoved(int index) {
    if (movingStack || index == stackIndex) return;
    const int moved = index - stackIndex;
    // The commands have run; what they exchanged is found at the two ends of the way.
    const auto* nearest =
        static_cast<const StateCommand*>(stack.command(moved < 0 ? stackIndex - 1 : stackIndex));
    const std::shared_ptr<const DocumentState> before =
        moved < 0 ? nearest->after : nearest->before;
    stackIndex = index;
    if (moved < 0)
        record(UndoStep{-moved});
    else
        record(RedoStep{moved});
    reading.reset();
    touch();
    suitDistance();
    emitChange(DocumentChange::Ink);
    stateChanged(*before);
}

// Applying ---------------------------------------------------------------------------------------

namespace {

Result<int> choose(const Interpretation& reading, const std::optional<int>& wanted) {
    const Error noReading{Errc::NoMatch, "No template matches this drawing.", {}};
    if (reading.candidates.empty()) return fail(reading.problem.value_or(noReading));
    if (!wanted) {
        if (reading.accepted) return *reading.accepted;
        return fail(reading.problem.value_or(noReading));
    }
    const int count = static_cast<int>(reading.candidates.size());
    if (*wanted < 0 || *wanted >= count) {
        return fail(Errc::UnknownCandidate, "There is no reading number " +
                                                std::to_string(*wanted) + "; this drawing has " +
                                                std::to_string(count) + ", counted from 0.");
    }
    return *wanted;
}

std::vector<int> idsOf(const std::vector<PendingStroke>& strokes) {
    std::vector<int> ids;
    for (const PendingStroke& s : strokes) ids.push_back(s.id);
    return ids;
}

/// The strokes that a candidate explains; the others stay.
/// \param readIds  of the strokes that it was read from.
std::vector<PendingStroke> explainedBy(const Candidate& candidate, const std::vector<int>& readIds,
                                       std::vector<PendingStroke> strokes) {
    std::vector<int> stay;
    for (const int i : candidate.unusedStrokes) {
        const bool known = i >= 0 && static_cast<std::size_t>(i) < readIds.size();
        if (known) stay.push_back(readIds[static_cast<std::size_t>(i)]);
    }
    std::erase_if(strokes, [&](const PendingStroke& s) {
        return std::find(stay.begin(), stay.end(), s.id) != stay.end();
    });
    return strokes;
}

ApplyStep applyStep(const ApplyRequest& request) {
    ApplyStep step{request.candidate, request.templateId, request.operation,
                   std::nullopt,      request.keep,       request.level};
    if (request.obliqueFactor != kDefaultObliqueFactor) step.obliqueFactor = request.obliqueFactor;
    return step;
}

Result<void> checkRequest(const ApplyRequest& request, const DocumentState& state) {
    if (!request.templateId.empty() && state.library.find(request.templateId) < 0) {
        return fail(Errc::UnknownTemplate,
                    "There is no template with the id " + nameQuoted(request.templateId) + ".");
    }
    const double k = *request.obliqueFactor;
    if (!(k >= kMinObliqueFactor && k <= kMaxObliqueFactor)) {
        return fail(Errc::BadValue, "The oblique factor must be from 0.1 to 2.");
    }
    const bool modifies = request.operation == Operation::Add ||
                          request.operation == Operation::Cut ||
                          request.operation == Operation::Split;
    const bool isCut = request.operation != Operation::Add;
    if (modifies && state.bodies.empty()) {
        return fail(Errc::OperationImpossible,
                    isCut ? "There is no solid to cut." : "There is no solid to add to.");
    }
    return {};
}

/// A candidate that makes a solid of its own, set level.
/// \param camera  that it was read through.
/// \param moved   receives what the whole view has to go along with.
Candidate setLevel(Candidate candidate, const DocumentState& before, const Thresholds& thresholds,
                   const OrthographicCamera& camera, Motion& moved) {
    if (candidate.operation != Operation::Create) return candidate;
    const bool first = before.bodies.empty();
    const auto motion =
        first ? levelled(candidate.spec, candidate.pose, thresholds.angleDeg)
              : setBeside(candidate.spec, candidate.pose, before.bodies, camera, thresholds);
    if (!motion) return candidate;
    candidate.pose = (*motion)(candidate.pose);
    // Others are seen as they are: the camera stays.
    if (first) moved = *motion;
    return candidate;
}

}  // namespace

Result<ApplyOutcome> Document::apply(const ApplyRequest& wanted) {
    ApplyRequest request = wanted;
    request.obliqueFactor = wanted.obliqueFactor.value_or(d_->obliqueFactor);
    if (d_->ink.strokes().empty()) return fail(Errc::EmptySketch, "Nothing is drawn yet.");
    if (auto ok = checkRequest(request, *d_->state); !ok) return fail(ok.error());

    const Interpretation& reading = interpretationFor(request);
    const auto chosen = choose(reading, request.candidate);
    if (!chosen) return fail(chosen.error());
    const Candidate& candidate = reading.candidates[static_cast<std::size_t>(*chosen)];
    if (request.operation != Operation::Auto && candidate.operation != request.operation) {
        return fail(Errc::OperationImpossible,
                    "This drawing cannot be read as that operation; let the program choose it.");
    }
    auto memory = std::make_shared<ApplyMemory>();
    memory->seen = d_->ink.strokes().back().camera;
    const Candidate made =
        request.level ? setLevel(candidate, *d_->state, thresholds(), memory->seen, memory->moved)
                      : candidate;
    auto after = withCandidate(*d_->state, made, request.keep,
                               thresholds().distancePx * memory->seen.worldPerPixel);
    if (!after) return fail(after.error());

    memory->request = request;
    memory->outcome = {reading, *chosen};
    memory->thresholds = d_->view.thresholds;
    memory->appliedFactor = memory->readFactor = *request.obliqueFactor;
    memory->strokeIds = idsOf(d_->ink.strokes());
    ApplyOutcome outcome = memory->outcome;
    const QString name = commandName(candidate);
    auto consumed = explainedBy(candidate, memory->strokeIds, d_->ink.strokes());

    d_->record(applyStep(request));
    d_->obliqueFactor = *request.obliqueFactor;
    const Motion moved = memory->moved;
    d_->push(name, *std::move(after), std::move(consumed), std::move(memory));
    if (request.level) (void)setCamera(moved(d_->view.camera));
    return outcome;
}

const ApplyOutcome* Document::lastApply() const {
    if (d_->stackIndex == 0 || !d_->ink.strokes().empty()) return nullptr;
    const auto* command = static_cast<const StateCommand*>(d_->stack.command(d_->stackIndex - 1));
    ApplyMemory* memory = command->memory.get();
    if (memory == nullptr || memory->thresholds != d_->view.thresholds) return nullptr;
    if (memory->readFactor != d_->obliqueFactor) {
        ApplyRequest request = memory->request;
        request.obliqueFactor = d_->obliqueFactor;
        memory->outcome.interpretation =
            d_->read(command->consumed, request, command->before->bodies);
        memory->readFactor = d_->obliqueFactor;
        memory->strokeIds = idsOf(command->consumed);
        const auto count = memory->outcome.interpretation.candidates.size();
        if (memory->outcome.chosen >= static_cast<int>(count)) memory->outcome.chosen = -1;
    }
    return &memory->outcome;
}

Result<ApplyOutcome> Document::chooseReading(int candidate) {
    const ApplyOutcome* last = lastApply();
    if (last == nullptr) {
        return fail(Errc::UnknownCandidate,
                    "There is no newest solid whose readings could change.");
    }
    const auto chosen = choose(last->interpretation, candidate);
    if (!chosen) return fail(chosen.error());
    const auto* command = static_cast<const StateCommand*>(d_->stack.command(d_->stackIndex - 1));
    if (*chosen == last->chosen && command->memory->appliedFactor == d_->obliqueFactor)
        return *last;
    const Candidate& reading = last->interpretation.candidates[static_cast<std::size_t>(*chosen)];
    auto memory = std::make_shared<ApplyMemory>(*command->memory);
    const Motion before = memory->moved;
    memory->moved = {};
    const Candidate made =
        memory->request.level
            ? setLevel(reading, *command->before, memory->thresholds, memory->seen, memory->moved)
            : reading;
    auto after = withCandidate(*command->before, made, memory->request.keep,
                               thresholds().distancePx * memory->seen.worldPerPixel);
    if (!after) return fail(after.error());

    memory->request.candidate = *chosen;
    memory->request.obliqueFactor = d_->obliqueFactor;
    memory->outcome.chosen = *chosen;
    memory->appliedFactor = d_->obliqueFactor;
    ApplyOutcome outcome = memory->outcome;
    const QString name = commandName(reading);

    d_->movingStack = true;
    d_->stack.undo();
    d_->movingStack = false;
    d_->record(UndoStep{});
    d_->record(applyStep(memory->request));
    auto consumed = explainedBy(reading, memory->strokeIds, d_->ink.strokes());
    const bool level = memory->request.level;
    const Motion moved = memory->moved;
    d_->push(name, *std::move(after), std::move(consumed), std::move(memory));
    if (level) (void)setCamera(moved(before.inverse()(d_->view.camera)));
    // push() compared with the state before the solid; the one on screen changed in any case.
    return outcome;
}

// Repairs ----------------------------------------------------------------------------------------

namespace {

/// The stroke with the end nearest to `from` drawn on to `to`.
Stroke extended(Stroke stroke, const Vec2& from, const Vec2& to) {
    const PenSample& first = stroke.samples.front();
    const PenSample& last = stroke.samples.back();
    const bool atStart = (first.position - from).norm() < (last.position - from).norm();
    PenSample more = atStart ? first : last;
    more.position = to;
    if (atStart)
        stroke.samples.insert(stroke.samples.begin(), more);
    else
        stroke.samples.push_back(more);
    return stroke;
}

}  // namespace

Result<void> Document::repair(const Repair& repair) {
    const auto& strokes = d_->ink.strokes();
    std::vector<int> ids;
    const int count = static_cast<int>(strokes.size());
    for (const int i : repair.strokes) {
        if (i < 0 || i >= count) return fail(Errc::BadValue, "The stroke to repair is gone.");
        ids.push_back(strokes[static_cast<std::size_t>(i)].id);
    }
    Thresholds t = thresholds();
    switch (repair.kind) {
        case Repair::Kind::DropStrokes:
            removeStrokes(ids);
            return {};
        case Repair::Kind::RaiseDistance:
            t.distancePx = repair.value;
            return setThresholds(t);
        case Repair::Kind::RaiseAngle:
            t.angleDeg = repair.value;
            return setThresholds(t);
        case Repair::Kind::UseCandidate: {
            auto applied =
                apply({.candidate = repair.candidate, .templateId = {}, .obliqueFactor = {}});
            if (!applied) return fail(applied.error());
            return {};
        }
        case Repair::Kind::Redraw:
            break;
        case Repair::Kind::JoinEnds:
            break;
    }
    std::vector<std::pair<Stroke, OrthographicCamera>> add;
    if (repair.kind == Repair::Kind::Redraw) {
        const OrthographicCamera& seen =
            ids.empty() ? camera()
                        : strokes[static_cast<std::size_t>(repair.strokes.front())].camera;
        for (const auto& line : repair.lines) {
            add.emplace_back(straightStroke(line[0], line[1]), seen);
            if (auto ok = validateStroke(add.back().first); !ok) return ok;
        }
        d_->editInk(ids, std::move(add));
        return {};
    }
    if (ids.size() != 1) return fail(Errc::BadValue, "One stroke at a time can be joined.");
    const PendingStroke& old = strokes[static_cast<std::size_t>(repair.strokes.front())];
    Stroke joined = extended(old.stroke, repair.from, repair.to);
    if (auto ok = validateStroke(joined); !ok) return ok;
    add.emplace_back(std::move(joined), old.camera);
    d_->editInk(ids, std::move(add));
    return {};
}

// Templates, deleting, undo ----------------------------------------------------------------------

namespace {

Result<std::shared_ptr<const DocumentState>> withTemplate(const DocumentState& before,
                                                          const Template& tmpl, bool replace) {
    const auto& own = before.addedTemplates;
    if (replace && std::find(own.begin(), own.end(), tmpl.id) == own.end()) {
        return fail(Errc::UnknownTemplate, "This document has no template of its own with the id " +
                                               nameQuoted(tmpl.id) + ".");
    }
    auto library = replace ? before.library.withReplaced(tmpl) : before.library.with(tmpl);
    if (!library) return fail(library.error());
    auto after = std::make_shared<DocumentState>(before);
    after->library = *std::move(library);
    if (!replace) after->addedTemplates.push_back(tmpl.id);
    return std::shared_ptr<const DocumentState>(std::move(after));
}

QString defineName(const std::string& name, bool replace) {
    const QString step = replace ? QStringLiteral("Change template \u201c%1\u201d")
                                 : QStringLiteral("Define template \u201c%1\u201d");
    return step.arg(QString::fromStdString(name));
}

}  // namespace

Result<void> Document::defineTemplate(Template tmpl, bool replace) {
    auto after = withTemplate(*d_->state, tmpl, replace);
    if (!after) return fail(after.error());
    const QString name = defineName(tmpl.name, replace);
    DefineTemplateStep step{tmpl.id, tmpl.name, std::nullopt, replace};
    step.tmpl = std::move(tmpl);
    d_->record(std::move(step));
    d_->push(name, *std::move(after), {});
    return {};
}

Result<void> Document::defineTemplateFromSolid(const std::string& id, const std::string& name) {
    auto tmpl = templateFromBodies(d_->state->bodies, id, name);
    if (!tmpl) return fail(tmpl.error());
    auto after = withTemplate(*d_->state, *tmpl, false);
    if (!after) return fail(after.error());
    d_->record(DefineTemplateStep{id, name, std::nullopt});
    d_->push(defineName(name, false), *std::move(after), {});
    return {};
}

Result<void> Document::deleteBodies() {
    if (d_->state->bodies.empty()) return fail(Errc::NoSolid, "There is no solid to delete.");
    auto after = std::make_shared<DocumentState>(*d_->state);
    after->bodies.clear();
    after->surface = {};
    after->mapped.clear();
    d_->record(DeleteSolidStep{});
    d_->push(QStringLiteral("Delete solid"), std::move(after), {});
    return {};
}

namespace {

std::string onlySo(int steps) {
    return steps == 1 ? "There is only one step"
                      : "There are only " + std::to_string(steps) + " steps";
}

}  // namespace

Result<void> Document::undo(int count) {
    if (count < 1) return fail(Errc::BadValue, "Undo needs a count of at least 1.");
    if (count > d_->stackIndex) {
        return fail(Errc::NothingToUndo, d_->stackIndex == 0
                                             ? "There is nothing to undo."
                                             : onlySo(d_->stackIndex) + " to undo.");
    }
    if (auto ok = loadState(*stateAt(d_->stackIndex - count)); !ok) return ok;
    d_->stack.setIndex(d_->stackIndex - count);
    return {};
}

Result<void> Document::redo(int count) {
    if (count < 1) return fail(Errc::BadValue, "Redo needs a count of at least 1.");
    const int left = d_->stack.count() - d_->stackIndex;
    if (count > left) {
        return fail(Errc::NothingToRedo,
                    left == 0 ? "There is nothing to redo." : onlySo(left) + " to redo.");
    }
    if (auto ok = loadState(*stateAt(d_->stackIndex + count)); !ok) return ok;
    d_->stack.setIndex(d_->stackIndex + count);
    return {};
}

Result<void> Document::goToStep(int index) {
    if (index < 0 || index > d_->stack.count()) {
        return fail(Errc::BadValue, "There is no such step in the history.");
    }
    while (d_->stackIndex > index) {
        while (undoInk()) {
        }
        if (auto ok = undo(); !ok) return ok;
    }
    while (d_->stackIndex < index) {
        while (redoInk()) {
        }
        if (auto ok = redo(); !ok) return ok;
    }
    return {};
}

QUndoStack& Document::undoStack() const { return d_->stack; }

}  // namespace ew
