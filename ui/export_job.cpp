// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export_job.h"

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

void showProgress(State& state, const QString& path, QWidget* window) {
    QProgressDialog dialog(QCoreApplication::translate("ew::ExportJob", "Exporting %1\u2026")
                               .arg(QFileInfo(path).fileName()),
                           QCoreApplication::translate("ew::ExportJob", "Cancel"), 0, kWhole,
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

Result<std::string> exportWithProgress(const Document& document, const QString& path,
                                       ExportOptions options, QWidget* window) {
    auto state = std::make_shared<State>();
    options.progress = [state](double share) {
        state->done = static_cast<int>(share * kWhole);
        return !state->stop;
    };
    const auto task = document.exportTask(path, options);
    Result<std::string> result = std::string();
    QEventLoop soon;
    std::thread worker([&, state] {
        result = task();
        state->finished = true;
        QMetaObject::invokeMethod(&soon, &QEventLoop::quit, Qt::QueuedConnection);
    });
    // What is typed meanwhile waits.
    QTimer::singleShot(kPatienceMs, &soon, &QEventLoop::quit);
    soon.exec(QEventLoop::ExcludeUserInputEvents);
    if (!state->finished) showProgress(*state, path, window);
    worker.join();
    return result;
}

}  // namespace ew
