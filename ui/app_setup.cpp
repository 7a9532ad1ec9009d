// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app_setup.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QIcon>
#include <QLibraryInfo>
#include <QLocale>
#include <QSurfaceFormat>
#include <QTranslator>

// A static library's resources are linked in only where something names them. Outside any
// namespace, as the macro wants it.
static void initialiseResources() {
    Q_INIT_RESOURCE(icons);
    Q_INIT_RESOURCE(translations);
}

namespace ew {

namespace {

/// The language of the system where there is a file for it, else English.
void installTranslation(const QString& name, const QString& folder) {
    auto* translator = new QTranslator(qApp);
    const bool found =
        translator->load(QLocale(), name, QStringLiteral("_"), folder) ||
        translator->load(QLocale(QLocale::English), name, QStringLiteral("_"), folder);
    if (found) {
        QCoreApplication::installTranslator(translator);
    } else {
        delete translator;
    }
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
    QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    QCoreApplication::setAttribute(Qt::AA_CompressTabletEvents, false);
}

void nameApplication() {
    initialiseResources();
    QCoreApplication::setApplicationName(QStringLiteral("Edgewright"));
    QCoreApplication::setOrganizationName(QStringLiteral("Edgewright"));
    QCoreApplication::setApplicationVersion(QStringLiteral(EDGEWRIGHT_VERSION));
    QGuiApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/edgewright.svg")));
    installTranslation(QStringLiteral("qtbase"),
                       QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    installTranslation(QStringLiteral("edgewright"), QStringLiteral(":/translations"));
    QGuiApplication::setDesktopFileName(QStringLiteral("edgewright"));
}

}  // namespace ew
