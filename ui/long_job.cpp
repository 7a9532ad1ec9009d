// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/long_job.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QFileInfo>
#include <QProgressDialog>
#include <QTimer>
#include <atomic>
#include <optional>
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

namespace {

/// Runs a task that is made with a progress to tell.
template <class Make>
auto taskWithProgress(const QString& title, QWidget* window, const Make& make) {
    JobProgress progress;
    const auto task = make([&progress](double share) { return progress(share); });
    std::optional<decltype(task())> result;
    runLongJob(
        title,
        [&](const JobProgress& told) {
            progress = told;
            result = task();
        },
        window);
    return *std::move(result);
}

}  // namespace

Result<std::string> exportWithProgress(const Document& document, const QString& path,
                                       ExportOptions options, QWidget* window) {
    const QString title = QCoreApplication::translate("ew::LongJob", "Exporting %1\u2026")
                              .arg(QFileInfo(path).fileName());
    return taskWithProgress(title, window, [&](const JobProgress& progress) {
        options.progress = progress;
        return document.exportTask(path, options);
    });
}

Result<OpenedFile> readWithProgress(const Document& document, const QString& path,
                                    QWidget* window) {
    const QString title = QCoreApplication::translate("ew::LongJob", "Opening %1\u2026")
                              .arg(QFileInfo(path).fileName());
    return taskWithProgress(title, window, [&](const JobProgress& progress) {
        return document.openTask(path, progress);
    });
}

}  // namespace ew
