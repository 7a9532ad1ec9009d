// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/trial_reading.h"

#include <QCoreApplication>
#include <QEvent>
#include <QMetaObject>
#include <algorithm>
#include <memory>

#include "core/reading/interpret.h"
#include "core/stroke/suited_distance.h"
#include "ui/core_text.h"

namespace ew {

TrialReading::TrialReading(TemplateModel& model, TemplateChecker& checker, QObject* parent)
    : QObject(parent), model_(model), checker_(checker) {
    thread_.setMaxThreadCount(1);
    connect(&model, &TemplateModel::changed, this, [this](DraftChange what) {
        if (what.trial) ask();
    });
    // A change of the template is worth reading once it is known to be usable.
    connect(&checker, &TemplateChecker::reportChanged, this, &TrialReading::ask);
}

TrialReading::~TrialReading() { thread_.waitForDone(); }

void TrialReading::setCanvasSize(const QSizeF& size) {
    camera_.width = size.width();
    camera_.height = size.height();
}

int TrialReading::candidate() const {
    const auto& all = reading_.candidates;
    const auto it = std::find_if(all.begin(), all.end(),
                                 [&](const Candidate& c) { return c.templateId == id_; });
    return it == all.end() ? -1 : static_cast<int>(it - all.begin());
}

bool TrialReading::isAccepted() const {
    return reading_.accepted && *reading_.accepted == candidate();
}

void TrialReading::settle() {
    while (busy_) {
        thread_.waitForDone();
        QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
    }
}

void TrialReading::ask() {
    ++revision_;
    if (busy_) {
        again_ = true;
        return;
    }
    start();
}

void TrialReading::start() {
    again_ = false;
    Template tmpl = readableDraft(model_.draft(), checker_.others());
    id_ = tmpl.id;
    if (model_.draft().trial.empty()) {
        take({}, revision_);
        return;
    }
    busy_ = true;
    thread_.start([this, tmpl = std::move(tmpl), strokes = model_.draft().trial,
                   others = checker_.others(), camera = camera_, revision = revision_] {
        InterpretOptions options;
        options.camera = camera;
        options.thresholds.distancePx = suitedDistancePx(strokes);
        const auto library = others.with(tmpl);
        auto reading = std::make_shared<Interpretation>(
            interpret(strokes, library ? *library : others, options));
        QMetaObject::invokeMethod(
            this, [this, reading, revision] { take(std::move(*reading), revision); },
            Qt::QueuedConnection);
    });
}

void TrialReading::take(Interpretation reading, long revision) {
    busy_ = false;
    if (revision != revision_ || again_) {
        start();
        return;
    }
    reading_ = std::move(reading);
    emit changed();
}

QString TrialReading::sentence() const {
    const std::vector<Candidate>& all = reading_.candidates;
    if (model_.draft().trial.empty()) return {};
    if (isAccepted()) return tr("It is read as this template.");
    if (reading_.accepted) {
        const Candidate& other = all[static_cast<std::size_t>(*reading_.accepted)];
        return tr("It is read as \u201c%1\u201d, not as this template.")
            .arg(coreText(other.templateName));
    }
    if (candidate() == 0) return tr("It is most likely this template, but that is not certain.");
    if (candidate() > 0) return tr("It could be this template, but another one is more likely.");
    if (reading_.problem) return coreText(reading_.problem->message);
    return tr("No template shows this.");
}

}  // namespace ew
