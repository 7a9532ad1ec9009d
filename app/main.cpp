// SPDX-License-Identifier: GPL-3.0-or-later
// The window. Usage: edgewright [FILE] [--language de|en] [--theme light|dark] [--size WxH]
// [--screenshot FILE.png]
#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QPixmap>
#include <QSettings>
#include <QTimer>
#include <cstdio>

#include "core/document/replay_arguments.h"
#include "core/document/resources.h"
#include "ui/actions/file_actions.h"
#include "ui/app_setup.h"
#include "ui/live_reading.h"
#include "ui/main_window.h"
#include "ui/panels/message_bar.h"
#include "ui/session_end.h"
#include "ui/theme/appearance.h"
#include "ui/viewport/viewport_widget.h"

namespace {

struct Arguments {
    QString file;
    QString language;
    QString theme;
    QSize size;
    QString screenshot;
    bool firstFrame = false;
};

int complain(const std::string& message) {
    std::fprintf(stderr, "edgewright: %s\n", message.c_str());
    return 2;
}

ew::Result<Arguments> readArguments() {
    QCommandLineParser parser;
    // Read before the language is known, so this is English like the messages on the terminal.
    parser.setApplicationDescription("Turns pen strokes into solids.");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("FILE", "A document (.edgewright) or a sketch script (.json).",
                                 "[FILE]");
    parser.addOption({"language", "de or en; otherwise the system's.", "CODE"});
    parser.addOption({"theme", "light, dark or system.", "NAME"});
    parser.addOption({"size", "Size of the window.", "WxH"});
    parser.addOption({"screenshot", "Write a picture of the window, then quit.", "FILE.png"});
    parser.addOption({"first-frame", "Print the time to the first picture [ms], then quit."});
    parser.process(*qApp);
    Arguments arguments;
    const QStringList files = parser.positionalArguments();
    if (files.size() > 1) return ew::fail(ew::Errc::BadValue, "Only one file can be opened.");
    if (!files.isEmpty()) arguments.file = files.front();
    arguments.language = parser.value("language");
    arguments.theme = parser.value("theme");
    if (!arguments.theme.isEmpty() && arguments.theme != "light" && arguments.theme != "dark" &&
        arguments.theme != "system") {
        return ew::fail(ew::Errc::BadValue, "The theme is light, dark or system.");
    }
    if (parser.isSet("size")) {
        const auto size = ew::parseSize(parser.value("size"));
        if (!size) return ew::fail(size.error());
        arguments.size = *size;
    }
    arguments.screenshot = parser.value("screenshot");
    arguments.firstFrame = parser.isSet("first-frame");
    return arguments;
}

/// Grabs the window once its first picture stands and quits; exit code 2 where it cannot be
/// written.
void quitAfterScreenshot(ew::MainWindow& window, const QString& path) {
    QObject::connect(&window.viewport(), &ew::ViewportWidget::firstFrame, &window, [&window, path] {
        window.reading().refreshNow();
        window.reading().settleNow();
        // One turn of the event loop for the panels that follow the reading.
        QTimer::singleShot(0, &window, [&window, path] {
            QCoreApplication::processEvents();
            QCoreApplication::processEvents();  // layouts ask for a second turn
            const bool written = window.picture().save(path, "PNG");
            if (!written) complain("The picture cannot be written to " + path.toStdString() + ".");
            QCoreApplication::exit(written ? 0 : 2);
        });
    });
}

}  // namespace

int main(int argc, char** argv) {
    QElapsedTimer clock;
    clock.start();
    ew::prepareApplication();
    QApplication application(argc, argv);
    ew::nameApplication();
    const auto arguments = readArguments();
    if (!arguments) return complain(arguments.error().message);
    if (const auto ok = ew::chooseLanguage(arguments->language); !ok) {
        return complain(ok.error().message);
    }
    const auto load = ew::loadTemplates();
    if (!load) return complain(load.error().message);

    ew::Appearance appearance;
    const QString remembered = QSettings().value("window/theme").toString();
    appearance.setMode(
        ew::Appearance::modeFromName(arguments->theme.isEmpty() ? remembered : arguments->theme));
    ew::MainWindowOptions options;
    options.remember = arguments->screenshot.isEmpty() && !arguments->firstFrame;
    ew::MainWindow window(load->library, appearance, options);
    if (arguments->size.isValid()) window.resize(arguments->size);
    if (!load->problems.empty()) window.messages().showError(load->problems.front());
    if (!arguments->screenshot.isEmpty()) quitAfterScreenshot(window, arguments->screenshot);
    if (arguments->firstFrame) {
        QObject::connect(&window.viewport(), &ew::ViewportWidget::firstFrame, &window, [&clock] {
            std::printf("%lld\n", static_cast<long long>(clock.elapsed()));
            QCoreApplication::quit();
        });
    }
    new ew::SessionEnd(window, [&window] { return window.mayClose(); });
    window.show();
    if (!arguments->file.isEmpty()) window.files().openPath(arguments->file);
    return QApplication::exec();
}
