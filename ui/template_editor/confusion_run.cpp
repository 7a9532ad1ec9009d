// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/confusion_run.h"

#include <QCoreApplication>
#include <QEvent>
#include <QMetaObject>
#include <algorithm>
#include <memory>

namespace ew {

ConfusionRun::ConfusionRun(TemplateModel& model, TemplateChecker& checker, QObject* parent)
    : QObject(parent), model_(model), checker_(checker) {
    thread_.setMaxThreadCount(1);
    connect(&model, &TemplateModel::changed, this, [this](DraftChange what) {
        if (!what.shape && !what.rules) return;
        changedMeanwhile_ = true;
        if (rows_.empty()) return;
        old_ = true;
        emit changed();
    });
}

ConfusionRun::~ConfusionRun() {
    stop_ = true;
    thread_.waitForDone();
}

void ConfusionRun::start(int drawings) {
    if (running_) return;
    const Template tmpl = readableDraft(model_.draft(), checker_.others());
    const auto library = checker_.others().with(tmpl);
    if (!library) return;
    std::vector<std::string> ids{tmpl.id};
    for (const AspectFacts& facts : checker_.aspects().aspects) {
        if (facts.aspect.kind != AspectKind::Explicit || facts.aspect.edgeOn) continue;
        for (const std::string& id : facts.alsoShownBy) {
            if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
        }
    }
    draftId_ = tmpl.id;
    running_ = true;
    changedMeanwhile_ = false;
    stop_ = false;
    done_ = 0.0;
    emit changed();
    thread_.start([this, library = *library, ids, drawings] {
        ConfusionOptions options;
        options.drawings = drawings;
        options.threads = 1;
        options.progress = [this](double share) {
            done_ = share;
            return !stop_;
        };
        auto rows = std::make_shared<std::vector<ConfusionRow>>(confusion(library, ids, options));
        const bool stopped = stop_;
        QMetaObject::invokeMethod(
            this, [this, rows, stopped] { take(std::move(*rows), stopped); }, Qt::QueuedConnection);
    });
}

void ConfusionRun::cancel() { stop_ = true; }

void ConfusionRun::take(std::vector<ConfusionRow> rows, bool stopped) {
    running_ = false;
    if (!stopped) {
        rows_ = std::move(rows);
        old_ = changedMeanwhile_;
    }
    emit changed();
}

void ConfusionRun::settle() {
    while (running_) {
        thread_.waitForDone();
        QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
    }
}

}  // namespace ew
