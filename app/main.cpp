// SPDX-License-Identifier: GPL-3.0-or-later
// The window. Usage: edgewright [FILE...] [--language de|en] [--theme light|dark] [--size WxH]
// [--start-page] [--screenshot FILE.png]. Exit 0: ended by the person, or the picture is there; 2:
// the arguments or the file are unusable, there is no display, or the picture cannot be written.
#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QPixmap>
#include <QSettings>
#include <QTimer>
#include <cstdio>
#include <functional>
#include <optional>
#include <utility>

#include "core/document/recent_files.h"
#include "core/document/replay_arguments.h"
#include "core/document/resources.h"
#include "ui/actions/file_actions.h"
#include "ui/app_setup.h"
#include "ui/live_reading.h"
#include "ui/panels/message_bar.h"
#include "ui/session_end.h"
#include "ui/theme/appearance.h"
#include "ui/viewport/picture_file.h"
#include "ui/viewport/viewport_widget.h"
#include "ui/window_list.h"
#include "ui/work_keeper.h"

namespace {

struct Arguments {
    QStringList files;
    QString language;
    QString theme;
    QSize size;
    QString screenshot;
    QString lesson;
    bool firstFrame = false;
    bool startPage = false;
};

constexpr int kUnusable = 2;

int complain(const std::string& message) {
    std::fprintf(stderr, "edgewright: %s\n", message.c_str());
    return kUnusable;
}

void describe(QCommandLineParser& parser) {
    // Read before the language is known, so this is English like the messages on the terminal.
    parser.setApplicationDescription("Turns pen strokes into solids.");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("FILE",
                                 "Documents (.edgewright) or sketch scripts (.json), as paths or "
                                 "file URLs; each has a window of its own.",
                                 "[FILE...]");
    parser.addOption({"language", "de or en; otherwise the system's.", "CODE"});
    parser.addOption({"theme", "light, dark or system.", "NAME"});
    parser.addOption({"size", "Size of the window.", "WxH"});
    parser.addOption(
        {"screenshot", "Write a picture of the window (.png, .jpg), then quit.", "FILE"});
    parser.addOption({"lesson", "Begin a lesson: its folder, or its .edgewright-lesson.", "FILE"});
    parser.addOption({"start-page", "Show recent documents and examples at first."});
    parser.addOption({"first-frame", "Print the time to the first picture [ms], then quit."});
}

/// Answers --help and --version.
int sayWords(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    ew::nameProgram();
    QCommandLineParser parser;
    describe(parser);
    parser.parse(QCoreApplication::arguments());
    if (parser.isSet("version")) parser.showVersion();
    parser.showHelp();
}

ew::Result<Arguments> readArguments() {
    QCommandLineParser parser;
    describe(parser);
    if (!parser.parse(QCoreApplication::arguments())) {
        return ew::fail(ew::Errc::UnknownKey, parser.errorText().toStdString());
    }
    Arguments arguments;
    arguments.files = parser.positionalArguments();
    arguments.startPage = parser.isSet("start-page");
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
    if (!arguments.screenshot.isEmpty()) {
        if (auto ok = ew::checkPictureName(arguments.screenshot); !ok) return ew::fail(ok.error());
    }
    arguments.lesson = parser.value("lesson");
    arguments.firstFrame = parser.isSet("first-frame");
    return arguments;
}

/// Does something once the window's first picture stands and the files are open: those are read
/// while the window is alive already, and a program that quits meanwhile would not hear of it.
class WhenShown : public QObject {
  public:
    WhenShown(ew::MainWindow& window, std::function<void()> deed)
        : QObject(&window), deed_(std::move(deed)), drawn_(window.startShown()) {
        connect(&window.viewport(), &ew::ViewportWidget::firstFrame, this, [this] {
            drawn_ = true;
            look();
        });
    }
    void filesAreOpen() {
        open_ = true;
        look();
    }

  private:
    void look() {
        if (drawn_ && open_) QTimer::singleShot(0, this, [this] { std::exchange(deed_, [] {})(); });
    }
    std::function<void()> deed_;
    bool drawn_;
    bool open_ = false;
};

/// Grabs the window and quits; exit code 2 where the picture cannot be written.
/// \param status  the exit code else; it is read then.
std::function<void()> screenshotDeed(ew::MainWindow& window, const QString& path,
                                     const int& status) {
    return [&window, &status, path] {
        window.reading().refreshNow();
        window.reading().settleNow();
        // One turn of the event loop for the panels that follow the reading.
        QTimer::singleShot(0, &window, [&window, &status, path] {
            QCoreApplication::processEvents();
            QCoreApplication::processEvents();  // layouts ask for a second turn
            const auto written = ew::writePicture(window.picture().toImage(), path);
            QCoreApplication::exit(written ? status : complain(written.error().message));
        });
    };
}

std::function<void()> firstFrameDeed(const QElapsedTimer& clock, const int& status) {
    return [&clock, &status] {
        std::printf("%lld\n", static_cast<long long>(clock.elapsed()));
        QCoreApplication::exit(status);
    };
}

/// What is kept and shown over runs; pictures for others are made without any of it.
ew::MainWindowOptions windowOptions(const Arguments& arguments) {
    ew::MainWindowOptions options;
    options.remember = arguments.screenshot.isEmpty() && !arguments.firstFrame;
    if (options.remember || arguments.startPage) {
        options.workFolder = ew::WorkFolder::standardPath();
        options.recentList = ew::RecentFiles::standardPath();
    }
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    QElapsedTimer clock;
    clock.start();
    if (ew::asksForWords(argc, argv)) return sayWords(argc, argv);
    ew::prepareApplication();
    auto guard = std::make_optional<ew::DisplayGuard>("edgewright");
    QApplication application(argc, argv);
    guard.reset();
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
    const ew::MainWindowOptions options = windowOptions(*arguments);
    ew::WindowList windows(load->library, appearance, options);
    ew::MainWindow& window = *windows.make();
    if (arguments->size.isValid()) window.resize(arguments->size);
    if (!load->problems.empty()) window.messages().showError(load->problems.front());
    const bool start = arguments->startPage || (options.remember && ew::MainWindow::wantsStart());
    if (arguments->files.isEmpty() && arguments->lesson.isEmpty() && start) window.showStart();
    int status = 0;
    WhenShown* deed = nullptr;
    if (!arguments->screenshot.isEmpty()) {
        deed = new WhenShown(window, screenshotDeed(window, arguments->screenshot, status));
    } else if (arguments->firstFrame) {
        deed = new WhenShown(window, firstFrameDeed(clock, status));
    }
    new ew::SessionEnd(windows, [&windows] { return windows.mayCloseAll(); });
    window.show();
    if (!arguments->files.isEmpty() && !windows.open(arguments->files, window)) {
        // A person sees it in the window; for a picture that nobody is there for, it is said here.
        if (!options.remember) status = complain(window.messages().text().toStdString());
    }
    if (!arguments->lesson.isEmpty() && !window.beginLesson(arguments->lesson)) {
        if (!options.remember) status = complain(window.messages().text().toStdString());
    }
    if (deed != nullptr) deed->filesAreOpen();
    // Once the window is there to be asked in; the start page lists it by itself.
    ew::WorkKeeper* work = window.workKeeper();
    if (work != nullptr && !window.startShown()) {
        QTimer::singleShot(0, work, [work] { work->offerLost(); });
    }
    return QApplication::exec();
}
