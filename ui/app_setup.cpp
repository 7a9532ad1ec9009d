// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app_setup.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QIcon>
#include <QLibraryInfo>
#include <QLocale>
#include <QSurfaceFormat>
#include <QTranslator>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string_view>

// A static library's resources are linked in only where something names them. Outside any
// namespace, as the macro wants it.
static void initialiseResources() {
    Q_INIT_RESOURCE(icons);
    Q_INIT_RESOURCE(translations);
}

namespace ew {

namespace {

bool installTranslation(const QLocale& locale, const QString& name, const QString& folder) {
    auto* translator = new QTranslator(qApp);
    if (translator->load(locale, name, QStringLiteral("_"), folder)) {
        return QCoreApplication::installTranslator(translator);
    }
    delete translator;
    return false;
}

/// What the message handler knows; it is a plain function.
struct Guarded {
    const char* program = "";
    QtMessageHandler before = nullptr;
};
Guarded guarded;

void onMessage(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (type == QtFatalMsg) {
        constexpr int kUnusable = 2;
        std::fprintf(stderr, "%s: There is no display to show a window on.\n", guarded.program);
        std::_Exit(kUnusable);
    }
    if (guarded.before != nullptr) guarded.before(type, context, text);
}

}  // namespace

void prepareApplication() {
    // On Wayland floating panels cannot be docked again (Qt 6.4) and GLEW complains.
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM") && qEnvironmentVariableIsSet("DISPLAY")) {
        qputenv("QT_QPA_PLATFORM", "xcb");
    }
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setAlphaBufferSize(8);
    format.setSamples(0);
    QSurfaceFormat::setDefaultFormat(format);
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
}

DisplayGuard::DisplayGuard(const char* program) {
    guarded.program = program;
    guarded.before = qInstallMessageHandler(onMessage);
}

DisplayGuard::~DisplayGuard() { qInstallMessageHandler(guarded.before); }

bool asksForWords(int argc, char** argv) {
    constexpr std::string_view kWords[] = {"--help", "-h", "--help-all", "--version", "-v"};
    return std::any_of(argv + 1, argv + argc, [&](const char* argument) {
        return std::find(std::begin(kWords), std::end(kWords), argument) != std::end(kWords);
    });
}

void nameProgram() {
    QCoreApplication::setApplicationName(QStringLiteral("Edgewright"));
    QCoreApplication::setOrganizationName(QStringLiteral("Edgewright"));
    QCoreApplication::setApplicationVersion(QStringLiteral(EDGEWRIGHT_VERSION));
}

void nameApplication() {
    initialiseResources();
    // Here and not before: the xcb plugin turns it on when it starts. A stroke would have one
    // sample a frame, and no corners where frames are slow.
    QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    QCoreApplication::setAttribute(Qt::AA_CompressTabletEvents, false);
    nameProgram();
    QGuiApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/edgewright.svg")));
    QGuiApplication::setDesktopFileName(QStringLiteral("edgewright"));
}

Result<void> chooseLanguage(const QString& language) {
    const QString name = QStringLiteral("edgewright");
    const QString folder = QStringLiteral(":/translations");
    QLocale locale = language.isEmpty() ? QLocale() : QLocale(language);
    const bool nonsense = !language.isEmpty() && locale.language() == QLocale::C;
    if (nonsense || !installTranslation(locale, name, folder)) {
        if (!language.isEmpty()) {
            return fail(Errc::BadValue, "There is no translation for the language \"" +
                                            language.toStdString() + "\".");
        }
        locale = QLocale(QLocale::English);
        installTranslation(locale, name, folder);
    }
    if (!language.isEmpty()) QLocale::setDefault(locale);
    // Qt's own texts; it has no file for English.
    installTranslation(locale, QStringLiteral("qtbase"),
                       QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    return {};
}

}  // namespace ew
