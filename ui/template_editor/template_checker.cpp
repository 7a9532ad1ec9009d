// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/template_checker.h"

#include <QCoreApplication>
#include <QEvent>
#include <QMetaObject>
#include <memory>

namespace ew {

namespace {

bool sameLooks(const Template& a, const Template& b) {
    return a.shape.vertices == b.shape.vertices && a.shape.faces == b.shape.faces &&
           a.relations.parallel == b.relations.parallel &&
           a.relations.perpendicular == b.relations.perpendicular &&
           a.relations.equalLength == b.relations.equalLength;
}

}  // namespace

TemplateChecker::TemplateChecker(TemplateModel& model, TemplateLibrary others, QObject* parent)
    : QObject(parent), model_(model), others_(std::move(others)) {
    threads_.setMaxThreadCount(2);
    connect(&model, &TemplateModel::changed, this, [this](DraftChange what) {
        if (what.words || what.shape || what.rules) check();
    });
    check();
}

TemplateChecker::~TemplateChecker() { threads_.waitForDone(); }

void TemplateChecker::settle() {
    while (!upToDate()) {
        threads_.waitForDone();
        QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
    }
}

void TemplateChecker::check() {
    ++checking_;
    threads_.start([this, draft = model_.draft(), others = others_, revision = ++revision_] {
        auto report = std::make_shared<DraftReport>(checkDraft(draft, others));
        QMetaObject::invokeMethod(
            this, [this, report, revision] { takeReport(std::move(*report), revision); },
            Qt::QueuedConnection);
    });
}

void TemplateChecker::takeReport(DraftReport report, long revision) {
    --checking_;
    if (revision != revision_) return;
    report_ = std::move(report);
    emit reportChanged();
    if (report_.openFreedoms >= 0) {
        look();
    } else if (lookedAt_) {
        aspects_ = {};
        lookedAt_.reset();
        emit aspectsChanged();
    }
}

void TemplateChecker::look() {
    Template tmpl = templateOf(model_.draft());
    if (looking_ || (lookedAt_ && sameLooks(*lookedAt_, tmpl))) return;
    looking_ = true;
    emit aspectsChanged();
    threads_.start([this, draft = model_.draft(), others = others_, tmpl = std::move(tmpl)] {
        auto aspects = std::make_shared<AspectReport>(lookAtAspects(draft, others));
        QMetaObject::invokeMethod(
            this, [this, aspects, tmpl] { takeAspects(std::move(*aspects), tmpl); },
            Qt::QueuedConnection);
    });
}

void TemplateChecker::takeAspects(AspectReport aspects, const Template& tmpl) {
    looking_ = false;
    if (sameLooks(templateOf(model_.draft()), tmpl)) {
        aspects_ = std::move(aspects);
        lookedAt_ = tmpl;
    } else if (checking_ == 0 && report_.openFreedoms >= 0) {
        look();
    }
    emit aspectsChanged();
}

}  // namespace ew
