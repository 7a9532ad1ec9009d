// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/long_job.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QFileInfo>
#include <QProgressDialog>
#include <QTimer>
#include <atomic>
#include <memory>
#include <thread>

#include "core/document/document.h"

namespace ew {

namespace {

constexpr int kPatienceMs = 500;
constexpr int kLookMs = 50;  // how often it is asked how far it is
constexpr int kWhole = 1000;

struct State {
    std::atomic<int> done = 0;  ///< of kWhole
    std::atomic<bool> stop = false;
    std::atomic<bool> finished = false;
};

void showProgress(State& state, const QString& title, QWidget* window) {
    QProgressDialog dialog(title, QCoreApplication::translate("ew::LongJob", "Cancel"), 0, kWhole,
                           window);
    dialog.setWindowModality(Qt::WindowModal);
    dialog.setMinimumDuration(0);
    dialog.setAutoClose(false);
    dialog.setAutoReset(false);
    QEventLoop loop;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        if (state.finished) loop.quit();
        dialog.setValue(state.done);
    });
    QObject::connect(&dialog, &QProgressDialog::canceled, &loop, [&] { state.stop = true; });
    look.start(kLookMs);
    dialog.show();
    loop.exec();
}

}  // namespace

void runLongJob(const QString& title, const std::function<void(const JobProgress&)>& job,
                QWidget* window) {
    State state;
    QEventLoop soon;
    std::thread worker([&] {
        job([&state](double share) {
            state.done = static_cast<int>(share * kWhole);
            return !state.stop;
        });
        state.finished = true;
        QMetaObject::invokeMethod(&soon, &QEventLoop::quit, Qt::QueuedConnection);
    });
    QTimer::singleShot(kPatienceMs, &soon, &QEventLoop::quit);
    soon.exec(QEventLoop::ExcludeUserInputEvents);
    if (!state.finished) showProgress(state, title, window);
    worker.join();
}

Result<std::string> exportWithProgress(const Document& document, const QString& path,
                                       ExportOptions options, QWidget* window) {
    Result<std::string> result = std::string();
    JobProgress progress;
    options.progress = [&progress](double share) { return progress(share); };
    const auto task = document.exportTask(path, options);
    runLongJob(
        QCoreApplication::translate("ew::LongJob", "Exporting %1\u2026")
            .arg(QFileInfo(path).fileName()),
        [&](const JobProgress& told) {
            progress = told;
            result = task();
        },
        window);
    return result;
}

Result<OpenedFile> readWithProgress(const Document& document, const QString& path,
                                    QWidget* window) {
    Result<OpenedFile> result = OpenedFile{};
    JobProgress progress;
    const auto task =
        document.openTask(path, [&progress](double share) { return progress(share); });
    runLongJob(
        QCoreApplication::translate("ew::LongJob", "Opening %1\u2026")
            .arg(QFileInfo(path).fileName()),
        [&](const JobProgress& told) {
            progress = told;
            result = task();
        },
        window);
    return result;
}

}  // namespace ew
