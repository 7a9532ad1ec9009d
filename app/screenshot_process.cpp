// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshot_process.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <memory>

namespace ew {

namespace {

constexpr int kStartMs = 20'000;
constexpr int kRenderMs = 120'000;
constexpr int kStopMs = 5'000;
constexpr int kCannotWrite = 3;  // exit status of edgewright-render

/// A virtual display that lives as long as this object.
class VirtualDisplay {
  public:
    VirtualDisplay() = default;
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;
    ~VirtualDisplay() {
        process_.terminate();
        if (!process_.waitForFinished(kStopMs)) process_.kill();
        process_.waitForFinished(kStopMs);
    }

    /// \return the display's name, e.g. ":99".
    Result<QString> start() {
        const QString program = QStandardPaths::findExecutable("Xvfb");
        if (program.isEmpty()) {
            return fail(Errc::NotAvailable,
                        "A screenshot needs a display, or the program Xvfb (package xvfb).");
        }
        process_.setStandardErrorFile(QProcess::nullDevice());
        process_.start(program,
                       {"-displayfd", "1", "-screen", "0", "1280x1024x24", "-nolisten", "tcp"});
        QByteArray number;
        while (!number.endsWith('\n')) {
            if (!process_.waitForReadyRead(kStartMs)) {
                return fail(Errc::NotAvailable, "The virtual display (Xvfb) did not start.");
            }
            number += process_.readAllStandardOutput();
        }
        return ":" + QString::fromLatin1(number.trimmed());
    }

  private:
    QProcess process_;
};

struct RenderCall {
    QString program;
    QStringList arguments;
};

Result<void> render(const RenderCall& call, const QString& display) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("DISPLAY", display);
    environment.insert("QT_QPA_PLATFORM", "xcb");
    // The picture has the size that was asked for, whatever the desktop is scaled by.
    for (const char* scale : {"QT_SCALE_FACTOR", "QT_SCREEN_SCALE_FACTORS", "QT_FONT_DPI"}) {
        environment.remove(scale);
    }
    environment.insert("QT_ENABLE_HIGHDPI_SCALING", "0");
    process.setProcessEnvironment(environment);
    process.start(call.program, call.arguments);
    if (!process.waitForFinished(kRenderMs)) {
        process.kill();
        process.waitForFinished(kStopMs);
        return fail(Errc::NotAvailable, "Drawing the screenshot took too long.");
    }
    if (process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0) return {};
    // Libraries may have said something before; the program's own sentence is the last line.
    const QString said = QString::fromLocal8Bit(process.readAllStandardError()).trimmed();
    const std::string why = said.mid(said.lastIndexOf('\n') + 1).toStdString();
    if (process.exitStatus() == QProcess::NormalExit && process.exitCode() == kCannotWrite) {
        return fail(Errc::CannotWrite, why);
    }
    return fail(Errc::NotAvailable, "The screenshot could not be drawn: " + why);
}

}  // namespace

Result<void> takeScreenshot(const Document& document, const Picture& picture) {
    RenderCall call;
    call.program = QCoreApplication::applicationDirPath() + "/edgewright-render";
    if (!QFileInfo(call.program).isExecutable()) {
        return fail(Errc::NotAvailable,
                    "This build has no edgewright-render, which draws screenshots.");
    }
    const QTemporaryDir folder;
    if (!folder.isValid()) {
        return fail(Errc::CannotWrite, "No temporary folder for the screenshot can be made.");
    }
    const QString copy = folder.filePath("document.edgewright");
    if (auto ok = document.saveCopy(copy); !ok) return ok;
    const QString size = QString("%1x%2").arg(picture.size.width()).arg(picture.size.height());
    call.arguments = {copy, picture.path, size};
    call.arguments << lookOptions(picture.look);
    if (picture.templates) call.arguments << QFileInfo(*picture.templates).absoluteFilePath();

    const QString display = qEnvironmentVariable("DISPLAY");
    if (!display.isEmpty()) {
        auto done = render(call, display);
        // A display that is named but not there: the virtual one is as good.
        const bool drawable = done || done.error().code == Errc::CannotWrite;
        if (drawable || QStandardPaths::findExecutable("Xvfb").isEmpty()) return done;
    }
    VirtualDisplay own;
    const auto started = own.start();
    if (!started) return fail(started.error());
    return render(call, *started);
}

}  // namespace ew
