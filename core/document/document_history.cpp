// SPDX-License-Identifier: GPL-3.0-or-later
#include <QUndoStack>

#include "core/document/document.h"
#include "core/document/document_private.h"
#include "core/document/history_change.h"

namespace ew {

Result<void> Document::nameState(int steps, const std::string& name) {
    if (steps < 0 || steps > d_->stack.count()) {
        return fail(Errc::BadValue, "There is no such step in the history.");
    }
    if (name.size() > kMaxStateName) {
        return fail(Errc::BadValue,
                    "A name has at most " + std::to_string(kMaxStateName) + " characters.");
    }
    std::string& there =
        steps == 0 ? d_->firstName
                   : static_cast<const StateCommand*>(d_->stack.command(steps - 1))->stateName;
    if (there == name) return {};
    there = name;
    NameStep step{name, std::nullopt};
    if (steps != d_->stackIndex) step.state = steps;
    d_->record(std::move(step));
    d_->touch();
    d_->emitChange(DocumentChange::History);
    return {};
}

const std::string& Document::stateName(int steps) const {
    static const std::string none;
    if (steps == 0) return d_->firstName;
    if (steps < 0 || steps > d_->stack.count()) return none;
    return static_cast<const StateCommand*>(d_->stack.command(steps - 1))->stateName;
}

std::shared_ptr<const DocumentState> Document::stateAt(int steps) const {
    const int count = d_->stack.count();
    if (steps < 0 || steps > count) return nullptr;
    if (steps == d_->stackIndex) return d_->state;
    const auto* command =
        static_cast<const StateCommand*>(d_->stack.command(steps > 0 ? steps - 1 : 0));
    return steps > 0 ? command->after : command->before;
}

Result<void> Document::compactHistory() {
    DocumentFile file = compacted(contents());
    if (static_cast<int>(file.commands.size()) == d_->stack.count()) return {};
    d_->adopt(std::move(file));
    d_->record(CompactStep{});
    d_->touch();
    return {};
}

void Document::replaceHistory(HistoryChange change) {
    auto before = std::make_shared<const DocumentFile>(contents());
    d_->adopt(std::move(change.file));
    d_->touch();
    d_->replaced = std::move(before);
    d_->replacedAt = d_->revision;
    d_->emitChange(DocumentChange::History);
}

bool Document::canTakeBackHistory() const {
    return d_->replaced != nullptr && d_->replacedAt == d_->revision;
}

void Document::takeBackHistory() {
    if (!canTakeBackHistory()) return;
    DocumentFile before = *d_->replaced;
    d_->adopt(std::move(before));
    d_->touch();
}

}  // namespace ew
