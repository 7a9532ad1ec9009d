// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/colours.h"

#include <algorithm>
#include <cmath>

namespace ew {

namespace {

QColor hex(const char* text) { return QColor(QLatin1String(text)); }

ThemeColours makeLight() {
    ThemeColours c;
    c.dark = false;
    c.window = hex("#f3f4f6");
    c.surface = hex("#ffffff");
    c.raised = hex("#e9ecf0");
    c.border = hex("#d3d8de");
    c.text = hex("#1c2127");
    c.mutedText = hex("#57606b");
    c.accent = hex("#1f63ad");
    c.accentText = hex("#ffffff");
    c.warning = hex("#b23c0a");
    c.ok = hex("#1c6e46");
    c.background = hex("#fbfbf9");
    c.grid = hex("#e1e4e8");
    c.axis = hex("#c6ccd4");
    c.ink = hex("#1d2733");
    // Seen on a face in the shade, too; that it is dropped is told by its dashes.
    c.dropped = hex("#30363d");
    c.read = hex("#2a7bd0");
    c.extracted = hex("#8a5fc0");
    c.ghost = hex("#6f8fb3");
    c.added = hex("#1f8a55");
    c.removed = hex("#c53a36");
    c.body = hex("#dde3ea");
    c.bodyEdge = hex("#2b333d");
    c.hiddenEdge = hex("#8791a0");
    c.hover = hex("#5f6b79");
    return c;
}

ThemeColours makeDark() {
    ThemeColours c;
    c.dark = true;
    c.window = hex("#24282e");
    c.surface = hex("#1c1f24");
    c.raised = hex("#30353d");
    c.border = hex("#3b424c");
    c.text = hex("#e8ebef");
    c.mutedText = hex("#a7b0bb");
    c.accent = hex("#6fb1f2");
    c.accentText = hex("#10202f");
    c.warning = hex("#ff9f66");
    c.ok = hex("#74cf9f");
    c.background = hex("#191c20");
    c.grid = hex("#2a2f36");
    c.axis = hex("#3d444e");
    c.ink = hex("#f0eee8");
    c.dropped = hex("#bac1ca");
    c.read = hex("#58a6f2");
    c.extracted = hex("#bd97ec");
    c.ghost = hex("#7f9dbd");
    c.added = hex("#62cf97");
    c.removed = hex("#ff7d74");
    c.body = hex("#566271");
    c.bodyEdge = hex("#e2e7ed");
    c.hiddenEdge = hex("#8a95a3");
    c.hover = hex("#9aa5b2");
    return c;
}

double linear(double channel) {
    return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& c) {
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

}  // namespace

const ThemeColours& lightColours() {
    static const ThemeColours kColours = makeLight();
    return kColours;
}

const ThemeColours& darkColours() {
    static const ThemeColours kColours = makeDark();
    return kColours;
}

bool isDark(const QColor& background) { return background.lightness() < 128; }

double contrastRatio(const QColor& a, const QColor& b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

QColor onBody(const QColor& colour, const ThemeColours& colours) {
    constexpr double kSeen = 3.0;
    constexpr int kSteps = 20;
    if (!colours.dark) return colour;
    for (int i = 0; i < kSteps; ++i) {
        const QColor lighter = mixColours(colour, Qt::white, static_cast<double>(i) / kSteps);
        if (contrastRatio(lighter, colours.body) >= kSeen) return lighter;
    }
    return Qt::white;
}

QColor mixColours(const QColor& a, const QColor& b, double t) {
    const auto mix = [t](float x, float y) {
        return static_cast<float>((1.0 - t) * static_cast<double>(x) + t * static_cast<double>(y));
    };
    return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()),
                            mix(a.blueF(), b.blueF()), mix(a.alphaF(), b.alphaF()));
}

}  // namespace ew
