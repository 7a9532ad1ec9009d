// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "tests/examples/models.h"

namespace ew::test {
namespace {

using V = Vec3;
using Which = EdgeChoice::Which;

/// On the slope of the buttons: along x, up from the front, out of it.
Vec3 onTop(double x, double up, double out = 0.0) {
    const double length = std::hypot(60.0, 17.0);
    const double y = 60.0 / length;
    const double z = 17.0 / length;
    return {x, y * up - z * out, 19.0 + z * up + y * out};
}

PolyhedronSpec boxOnTop(double x0, double x1, double up0, double up1, double out0, double out1) {
    return prismSpec(
        {onTop(x0, up0, out0), onTop(x1, up0, out0), onTop(x1, up1, out0), onTop(x0, up1, out0)},
        onTop(0, 0, out1) - onTop(0, 0, out0));
}

void sketch(ModelMaker& m) {
    // The body falls from its back to the front and to the wrist.
    m.lookFrom(35, 28);
    m.startBox(V(62, 110, 36));
    m.lookFrom(25, 30);
    m.cut(prismSpec({V(0, 0, 36), V(0, 60, 36), V(0, 0, 19)}, V(62, 0, 0)));
    m.lookFrom(-25, 30);
    m.cut(prismSpec({V(0, 110, 36), V(0, 80, 36), V(0, 110, 16)}, V(62, 0, 0)));
    // The wheel in its slot.
    m.lookFrom(60, 50, onTop(31, 31), 54);
    m.cut(boxOnTop(23, 39, 13, 49, -7, 0));
    m.lookFrom(55, 52, onTop(31, 32), 46);
    m.add(boxOnTop(28, 34, 20, 42, -7, 4));
    // The cable, and hollows for thumb and finger.
    m.lookFrom(50, 25, V(31, 0, 8), 50);
    m.add(boxSpec(V(27.5, -16, 2), V(34.5, 0, 9)));
    m.lookFrom(35, 28, V(62, 62, 11), 48);
    m.cut(boxSpec(V(58, 44, 4), V(62, 84, 13)));
    m.lookFrom(145, 28, V(0, 62, 11), 48);
    m.cut(boxSpec(V(0, 44, 4), V(4, 84, 13)));
}

using Curve = std::vector<Vec3>;

/// Where the shell parts: between the keys, across behind them, and along the sides.
void drawOnIt(ModelMaker& m) {
    m.lookFrom(90, 88, V(31, 50, 30), 150);
    Curve front;
    Curve back;
    Curve across;
    for (double up = -2.0; up <= 12.5; up += 1.0) front.push_back(onTop(31, up));
    for (double up = 49.5; up <= 57.0; up += 1.0) back.push_back(onTop(31, up));
    for (double x = -4.0; x <= 66.0; x += 2.0) {
        const double off = (x - 31.0) / 35.0;
        across.push_back(onTop(x, 57.0 - 7.0 * off * off));
    }
    m.drawOn({front, back, across}, "#3a414b");
    m.lookFrom(90, 70, V(31, 95, 25), 150);
    Curve sign;
    for (int i = 0; i <= 20; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / 20.0;
        sign.push_back(V(31 + 4.0 * std::cos(turn), 92 + 4.0 * std::sin(turn), 28));
    }
    m.drawOn({sign, {V(31, 90, 29), V(31, 94, 27)}}, "#2f5f9e");
}

}  // namespace

void drawMouse(ModelMaker& m) {
    sketch(m);
    m.lookFrom(36, 34, V(31, 50, 16), 100);
    // The body: round in plan and from every side; its lower edge stays as it is.
    m.fillet(
        {V(0, 0, 10), V(62, 0, 10), V(0, 110, 8), V(62, 110, 8), V(0, 10, 20), V(62, 10, 20),
         V(0, 70, 36), V(62, 70, 36), V(0, 100, 22), V(62, 100, 22), V(50, 0, 19), V(30, 110, 16)},
        12, 4);
    m.fillet({V(30, 60, 36), V(30, 80, 36)}, 12, 4);
    // The wheel, the ends of its slot and of the hollows, the cable.
    m.fillet({onTop(31, 20, 4), onTop(31, 42, 4)}, 9.5, 4);
    m.fillet({onTop(23, 13, -4), onTop(39, 13, -4), onTop(23, 49, -4), onTop(39, 49, -4)}, 7.5, 4);
    m.fillet({V(60, 44, 4), V(60, 44, 13), V(60, 84, 4), V(60, 84, 13), V(2, 44, 4), V(2, 44, 13),
              V(2, 84, 4), V(2, 84, 13)},
             4.2, 4);
    m.fillet({V(27.5, -8, 2), V(27.5, -8, 9), V(34.5, -8, 2), V(34.5, -8, 9)}, 3.3, 4);
    m.subdivide(2);
    drawOnIt(m);
    m.lookFrom(36, 34, V(31, 50, 16), 100);
}

}  // namespace ew::test
