// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/work_keeper.h"

#include <QBuffer>
#include <QImage>
#include <algorithm>
#include <iterator>

#include "ui/core_text.h"
#include "ui/dialogs/recover_dialog.h"
#include "ui/panels/message_bar.h"
#include "ui/viewport/viewport_widget.h"

namespace ew {

namespace {

constexpr int kPictureRestMs = 1500;  // nothing is drawn meanwhile
constexpr int kPictureWidth = 240;
constexpr int kPictureHeight = 150;

}  // namespace

WorkKeeper::WorkKeeper(const WindowContext& context, const WorkFolder& folder, QWidget* window)
    : QObject(window),
      context_(context),
      folder_(folder),
      window_(window),
      copy_(context.document, folder),
      mayDiscard_([] { return true; }) {
    folder_.tidy({});
    pictureSoon_.setSingleShot(true);
    pictureSoon_.setInterval(kPictureRestMs);
    connect(&pictureSoon_, &QTimer::timeout, this, &WorkKeeper::takePicture);
    connect(&context_.document, &Document::changed, this, [this](DocumentChange what) {
        const bool seen = what == DocumentChange::Bodies || what == DocumentChange::Shape ||
                          what == DocumentChange::Ink;
        if (seen) pictureSoon_.start();
    });
    connect(&copy_, &WorkCopy::failed, this, [this](const Error& error) {
        context_.messages.showError({error.code,
                                     tr("What you do is not kept safe until it is saved: %1")
                                         .arg(coreText(error.message))
                                         .toStdString(),
                                     {}});
    });
}

void WorkKeeper::takePicture() {
    if (context_.document.untouched() && context_.document.state().bodies.empty()) return;
    const QImage image = context_.viewport.grabFramebuffer().scaled(
        kPictureWidth, kPictureHeight, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    const QRect middle((image.width() - kPictureWidth) / 2, (image.height() - kPictureHeight) / 2,
                       kPictureWidth, kPictureHeight);
    QBuffer buffer;
    buffer.open(QIODevice::ReadWrite);
    if (!image.copy(middle).convertToFormat(QImage::Format_RGB32).save(&buffer, "PNG")) return;
    context_.document.setThumbnail(buffer.data().toStdString());
    emit pictured();
}

void WorkKeeper::putAway(const WorkCopyEntry& entry) {
    if (auto ok = folder_.decline(entry); !ok) context_.messages.showError(ok.error());
}

bool WorkKeeper::offerLost() {
    std::vector<WorkCopyEntry> lost;
    for (const WorkCopyEntry& entry : folder_.list()) {
        if (entry.lost()) lost.push_back(entry);
    }
    if (!lost.empty()) offer(lost);
    return !lost.empty();
}

void WorkKeeper::offerAll() {
    context_.messages.clearNotice();
    std::vector<WorkCopyEntry> there;
    for (const WorkCopyEntry& entry : folder_.list()) {
        if (!entry.open && !entry.problem) there.push_back(entry);
    }
    if (there.empty()) {
        context_.messages.showNotice(tr("There is nothing to recover."));
        return;
    }
    offer(there);
}

void WorkKeeper::offer(const std::vector<WorkCopyEntry>& entries) {
    RecoverDialog dialog(entries, window_);
    dialog.exec();
    const auto chosen = dialog.chosen();
    for (const std::size_t i : dialog.declined()) putAway(entries[i]);
    if (chosen && mayDiscard_()) restore(entries[*chosen]);
}

bool WorkKeeper::restore(const WorkCopyEntry& entry) {
    auto file = folder_.read(entry, context_.document.state().library);
    if (!file) {
        context_.messages.showError(file.error());
        return false;
    }
    context_.document.restore(*std::move(file), entry.note.documentPath);
    copy_.replaces(entry);
    const int steps = entry.summary.steps;
    context_.messages.showNotice(tr("Recovered: %n step(s), as of %1.", "", steps)
                                     .arg(QLocale().toString(entry.time, QLocale::ShortFormat)));
    return true;
}

}  // namespace ew
