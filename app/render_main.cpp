// SPDX-License-Identifier: GPL-3.0-or-later
// edgewright-render DOCUMENT PICTURE.png WxH [LOOK...] [TEMPLATES]: draws the viewport of a
// document, read with the templates of a folder or the usual ones. LOOK is any of --transparent,
// --cage, --hidden-edges, --dark, --occlusion. Needs a display; edgewright-replay starts it for
// --screenshot. Exit 0: drawn; 2: cannot be drawn; 3: cannot be written.
#include <QApplication>
#include <cstdio>
#include <optional>

#include "core/document/document.h"
#include "core/document/replay_arguments.h"
#include "core/document/resources.h"
#include "ui/app_setup.h"
#include "ui/viewport/offscreen.h"

namespace {

constexpr int kUnusable = 2;
constexpr int kCannotWrite = 3;
constexpr const char* kUsage =
    "Usage: edgewright-render DOCUMENT PICTURE.png WxH [LOOK...] [TEMPLATES]";

int complain(const std::string& message, int status = kUnusable) {
    std::fprintf(stderr, "%s\n", message.c_str());
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    if (ew::asksForWords(argc, argv)) {
        std::printf("edgewright-render %s\n%s\n", EDGEWRIGHT_VERSION, kUsage);
        return 0;
    }
    ew::prepareApplication();
    auto guard = std::make_optional<ew::DisplayGuard>("edgewright-render");
    const QApplication application(argc, argv);
    guard.reset();
    QStringList arguments = QCoreApplication::arguments().mid(1);
    ew::PictureLook look;
    arguments.removeIf([&](const QString& option) { return ew::readLookOption(option, look); });
    if (arguments.size() != 3 && arguments.size() != 4) {
        return complain(kUsage);
    }
    const auto size = ew::parseSize(arguments[2]);
    if (!size) return complain(size.error().message);
    // Pending ink is shown as it is read, for which the templates are needed.
    const auto load =
        arguments.size() == 4 ? ew::loadTemplates(arguments[3], QString()) : ew::loadTemplates();
    if (!load) return complain(load.error().message);
    ew::Document document(load->library);
    if (auto ok = document.open(arguments[0]); !ok) return complain(ok.error().message);
    if (auto ok = ew::renderScreenshot(document, arguments[1], *size, look); !ok) {
        const bool unwritable = ok.error().code == ew::Errc::CannotWrite ||
                                ok.error().code == ew::Errc::UnknownExtension;
        return complain(ok.error().message, unwritable ? kCannotWrite : kUnusable);
    }
    return 0;
}
