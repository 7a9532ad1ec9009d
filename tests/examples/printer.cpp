// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/examples/models.h"

namespace ew::test {
namespace {

using V = Vec3;
using Which = EdgeChoice::Which;

/// On the control panel: along x, up the slope from the front, out of it.
Vec3 onPanel(double x, double up, double out = 0.0) {
    const double length = std::hypot(28.0, 16.0);
    const double y = 28.0 / length;
    const double z = 16.0 / length;
    return {x, y * up - z * out, 34.0 + z * up + y * out};
}

/// On the slope that the paper leans on.
Vec3 onSupport(double x, double up) {
    const double length = std::hypot(16.0, 42.0);
    return {x, 66.0 + 16.0 / length * up, 60.0 + 42.0 / length * up};
}

std::vector<Vec3> circleOnPanel(double x, double up, double radius) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 16; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / 16.0;
        points.push_back(onPanel(x + radius * std::cos(turn), up + radius * std::sin(turn)));
    }
    return points;
}

void sketch(ModelMaker& m) {
    m.lookFrom(58, 32);
    m.startBox(V(120, 90, 50));
    // The control panel: a slope along the upper front edge.
    m.cut(prismSpec({V(0, 0, 50), V(0, 28, 50), V(0, 0, 34)}, V(120, 0, 0)));
    // Where the paper comes out, and the tray that it falls on, with a lip in front.
    m.lookFrom(62, 18);
    m.cut(boxSpec(V(16, 0, 12), V(104, 30, 28)));
    m.lookFrom(50, 32);
    m.add(prismSpec(
        {V(22, 0, 4), V(22, 0, 12), V(22, -34, 12), V(22, -34, 20), V(22, -42, 20), V(22, -42, 4)},
        V(76, 0, 0)));
    // The paper's support at the back, which leans.
    m.lookFrom(58, 32);
    m.add(boxSpec(V(18, 66, 50), V(102, 90, 102)));
    m.lookFrom(40, 25);
    m.cut(prismSpec({V(18, 66, 60), V(18, 66, 102), V(18, 82, 102)}, V(84, 0, 0)));
    // The lid of the scanner.
    m.lookFrom(58, 38, V(60, 48, 54), 110);
    m.add(frustumSpec(V(8, 35, 50), V(112, 61, 60), 7, 7));
    // A hollow on the side to lift it by, and the duplex unit behind.
    m.lookFrom(38, 30, V(120, 52, 24), 75);
    m.cut(boxSpec(V(112, 30, 16), V(120, 74, 31)));
    m.lookFrom(-50, 30);
    m.add(boxSpec(V(22, 90, 6), V(98, 106, 33)));
    // The display.
    m.lookFrom(38, 14, V(80, 10, 40), 100);
    m.add(prismSpec({onPanel(66, 7), onPanel(104, 7), onPanel(104, 25), onPanel(66, 25)},
                    onPanel(0, 0, 5) - onPanel(0, 0)));
}

using Curve = std::vector<Vec3>;

Curve frame(Vec3 (*on)(double, double), double x0, double x1, double up0, double up1) {
    return {on(x0, up0), on(x1, up0), on(x1, up1), on(x0, up1), on(x0, up0)};
}

/// Lines of writing: small waves, a word at a time.
void write(std::vector<Curve>& ink, Vec3 (*on)(double, double), double x0, double x1, double up) {
    for (double x = x0; x < x1 - 3.0;) {
        const double word = std::min(x1 - x, 4.0 + std::fmod(7.3 * x + 3.1 * up, 9.0));
        Curve wave;
        for (double t = 0.0; t <= word; t += 0.5) {
            wave.push_back(on(x + t, up + 0.45 * std::sin(3.0 * t)));
        }
        ink.push_back(wave);
        x += word + 1.8;
    }
}

Vec3 onDisplay(double x, double up) { return onPanel(x, up, 5.0); }
Vec3 onTray(double x, double up) { return {x, -34.0 + up, 12.0}; }

void drawOnIt(ModelMaker& m) {
    // The sheet that waits in the support.
    m.lookFrom(90, 10, onSupport(60, 20), 170);
    std::vector<Curve> sheet{frame(onSupport, 28, 92, 0.5, 43)};
    m.drawOn(sheet, "#6b7480");
    // The page that has come out.
    m.lookFrom(90, 84, V(60, -10, 12), 150);
    std::vector<Curve> page{{onTray(32, 31), onTray(32, 5), onTray(88, 5), onTray(88, 31)}};
    m.drawOn(page, "#6b7480");
    std::vector<Curve> text;
    for (const double up : {9.0, 13.0, 17.0, 21.0, 25.0}) write(text, onTray, 38, 82, up);
    m.drawOn(text, "#2f5f9e");
    // What the display says, the keys beside it.
    m.lookFrom(90, 60, onPanel(60, 16), 120);
    std::vector<Curve> display{frame(onDisplay, 69, 101, 9.5, 22.5)};
    write(display, onDisplay, 72, 98, 18.5);
    write(display, onDisplay, 72, 92, 13.5);
    m.drawOn(display, "#1d5c4d");
    std::vector<Curve> keys;
    for (const double x : {16.0, 28.0, 40.0}) keys.push_back(circleOnPanel(x, 19, 3.6));
    keys.push_back(circleOnPanel(28, 9, 3.6));
    m.drawOn(keys, "#39414d");
    // Start and stop.
    m.drawOn({{onPanel(39, 17.2), onPanel(39, 20.8), onPanel(42, 19), onPanel(39, 17.2)}},
             "#1f7a4a");
    m.drawOn({{onPanel(14.7, 17.7), onPanel(17.3, 17.7), onPanel(17.3, 20.3), onPanel(14.7, 20.3),
               onPanel(14.7, 17.7)}},
             "#a3322a");
}

}  // namespace

void drawPrinter(ModelMaker& m) {
    sketch(m);
    m.lookFrom(56, 27, V(60, 28, 48), 178);
    m.fillet(Which::All, 1.5, 3);
    // Corners that hands touch are rounder.
    m.fillet({V(22, -42, 12), V(98, -42, 12)}, 5, 3);
    m.subdivide(2);
    drawOnIt(m);
    m.lookFrom(56, 27, V(60, 28, 48), 178);
}

}  // namespace ew::test
