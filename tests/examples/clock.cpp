// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/examples/models.h"

namespace ew::test {
namespace {

using V = Vec3;
using Which = EdgeChoice::Which;

// The dial: its middle, and the depth of its face.
constexpr double kMiddleX = 55.0;
constexpr double kMiddleZ = 76.0;
constexpr double kDialY = 12.5;

Vec3 onDial(double x, double z) { return {kMiddleX + x, kDialY, kMiddleZ + z}; }
Vec3 onDialAt(double hour, double radius) {
    const double turn = hour * std::numbers::pi / 6.0;
    return onDial(radius * std::sin(turn), radius * std::cos(turn));
}

using Curve = std::vector<Vec3>;

/// A roman numeral at its hour, its strokes as long as they are high; it stands upright.
std::vector<Curve> numeral(int hour) {
    static const std::array<const char*, 12> kText{"XII", "I",   "II",   "III", "IV", "V",
                                                   "VI",  "VII", "VIII", "IX",  "X",  "XI"};
    constexpr double kHigh = 3.2;
    const std::string text = kText[static_cast<std::size_t>(hour % 12)];
    const auto wide = [](char c) { return c == 'I' ? 0.9 : 2.1; };
    double width = 0.0;
    for (const char c : text) width += wide(c);
    const Vec3 middle = onDialAt(hour, 15.2);
    double left = -0.5 * width;
    std::vector<Curve> strokes;
    const auto stroke = [&](double x0, double z0, double x1, double z1) {
        strokes.push_back({middle + V(x0, 0, z0), middle + V(x1, 0, z1)});
    };
    for (const char c : text) {
        const double x0 = left + 0.2;
        const double x1 = left + wide(c) - 0.2;
        const double x = 0.5 * (x0 + x1);
        if (c == 'I') stroke(x, 0.5 * kHigh, x, -0.5 * kHigh);
        if (c == 'V') {
            strokes.push_back({middle + V(x0, 0, 0.5 * kHigh), middle + V(x, 0, -0.5 * kHigh),
                               middle + V(x1, 0, 0.5 * kHigh)});
        }
        if (c == 'X') {
            stroke(x0, 0.5 * kHigh, x1, -0.5 * kHigh);
            stroke(x1, 0.5 * kHigh, x0, -0.5 * kHigh);
        }
        left += wide(c);
    }
    return strokes;
}

Curve ring(double radius) {
    Curve points;
    for (int i = 0; i <= 48; ++i) points.push_back(onDialAt(i / 4.0, radius));
    return points;
}

/// A hand that tapers, there and back again.
Curve pointer(double hour, double length, double width) {
    const double turn = hour * std::numbers::pi / 6.0;
    const auto at = [&](double along, double aside) {
        return onDial(along * std::sin(turn) + aside * std::cos(turn),
                      along * std::cos(turn) - aside * std::sin(turn));
    };
    return {at(-2.5, 0), at(0.3 * length, width), at(length, 0), at(0.3 * length, -width),
            at(-2.5, 0)};
}

void drawDial(ModelMaker& m) {
    m.lookFrom(90, 0, onDial(0, 0), 130);
    std::vector<Curve> strokes{ring(19.0), ring(11.6)};
    for (int hour = 1; hour <= 12; ++hour) {
        for (Curve& c : numeral(hour)) strokes.push_back(std::move(c));
    }
    m.drawOn(strokes, "#2b2f36");
    m.lookFrom(90, 0, onDial(0, 0), 200);
    m.drawOn({pointer(10.15, 9.5, 0.7), pointer(1.9, 14.5, 0.5)}, "#9a2b1f");
    // The panel below: a wreath of two branches.
    m.lookFrom(90, 0, V(55, 18, 33), 110);
    std::vector<Curve> panel;
    for (const double side : {-1.0, 1.0}) {
        Curve branch;
        for (int i = 0; i <= 12; ++i) {
            const double t = i / 12.0;
            branch.emplace_back(55 + side * 16.0 * std::sin(1.5 * t), 18, 27.5 + 9.5 * t * t);
        }
        panel.push_back(branch);
        for (const int i : {4, 6, 8, 10}) {
            const Vec3& p = branch[static_cast<std::size_t>(i)];
            panel.push_back({p, p + V(side * 1.2, 0, -1.0), p + V(side * 2.6, 0, -0.9)});
            panel.push_back({p, p + V(-side * 0.9, 0, 1.1), p + V(-side * 0.9, 0, 2.6)});
        }
    }
    m.drawOn(panel, "#8a6a1f");
}

void sketch(ModelMaker& m) {
    // The plinth, whose sides lean, and the case on it.
    m.lookFrom(60, 28);
    m.startBox(V(110, 52, 8));
    m.lookFrom(50, 32);
    m.add(frustumSpec(V(0, 0, 8), V(110, 52, 17), 7, 6));
    m.add(boxSpec(V(23, 14, 17), V(87, 42, 100)));
    // The gable.
    m.lookFrom(60, 22);
    m.add(prismSpec({V(23, 14, 100), V(87, 14, 100), V(55, 14, 132)}, V(0, 28, 0)));
    // ... whose peak leans back.
    m.lookFrom(78, 35, V(55, 20, 120), 80);
    m.cut(pyramidSpec(V(55, 14, 132), V(55, 24, 132), V(45, 14, 122), V(65, 14, 122)));
    // A pillar with its spire on either side, a step in from its rim and from the case.
    m.lookFrom(45, 25, V(90, 17, 50), 105);
    m.add(boxSpec(V(87, 9, 17), V(99, 25, 84)));
    m.lookFrom(40, 30, V(93, 17, 92), 50);
    m.add(frustumSpec(V(89.5, 11.5, 84), V(96.5, 22.5, 112), 2, 3.5));
    m.lookFrom(135, 25, V(20, 17, 50), 105);
    m.add(boxSpec(V(11, 9, 17), V(23, 25, 84)));
    m.lookFrom(140, 30, V(17, 17, 92), 50);
    m.add(frustumSpec(V(13.5, 11.5, 84), V(20.5, 22.5, 112), 2, 3.5));
    // The bezel, the dial in it, and the panel below.
    m.lookFrom(47, 24, V(55, 10, 76), 80);
    m.add(boxSpec(V(29, 9, 50), V(81, 14, 102)));
    m.lookFrom(45, 22, V(55, 9, 76), 70);
    m.cut(boxSpec(V(33.5, 9, 54.5), V(76.5, 12.5, 97.5)));
    m.lookFrom(55, 28, V(55, 14, 33), 55);
    m.cut(boxSpec(V(33, 14, 23), V(77, 18, 43)));
}

}  // namespace

void drawClock(ModelMaker& m) {
    sketch(m);
    m.lookFrom(62, 17, V(55, 26, 63), 160);
    // Soft edges, but for the rims of dial and bezel, which are round and crisp.
    m.fillet(Which::All, 1.0, 8);
    m.sharpen({V(55, 9, 54.5), V(55, 9, 97.5), V(33.5, 9, 76), V(76.5, 9, 76), V(55, 12.5, 54.5),
               V(55, 12.5, 97.5), V(33.5, 12.5, 76), V(76.5, 12.5, 76), V(55, 9, 50), V(55, 9, 102),
               V(29, 9, 76), V(81, 9, 76), V(55, 14, 50), V(55, 14, 102), V(29, 14, 76),
               V(81, 14, 76)});
    m.fillet({V(33.5, 11, 54.5), V(76.5, 11, 54.5), V(33.5, 11, 97.5), V(76.5, 11, 97.5)}, 20.8, 8);
    m.fillet({V(29, 12, 50), V(81, 12, 50), V(29, 12, 102), V(81, 12, 102)}, 25.2, 8);
    m.subdivide(1);
    drawDial(m);
    m.lookFrom(62, 17, V(55, 26, 63), 160);
}

}  // namespace ew::test
