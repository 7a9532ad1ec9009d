// SPDX-License-Identifier: GPL-3.0-or-later
// Cases on other targets than the box.
#include <cmath>

#include "tests/support/case_list.h"

namespace ew::test {
namespace {

constexpr auto add = Operation::Add;
constexpr auto cut = Operation::Cut;
using V = Vec3;

/// On the slope: along x, up the slope, out of it. Multiples of 5 give whole numbers.
Vec3 onSlope(double x, double up, double out = 0.0) {
    return {x, 0.8 * up - 0.6 * out, 0.6 * up + 0.8 * out};
}
PolyhedronSpec slopeBox(double x0, double x1, double up0, double up1, double out) {
    return prismSpec({onSlope(x0, up0), onSlope(x1, up0), onSlope(x1, up1), onSlope(x0, up1)},
                     onSlope(0, 0, out));
}

void addWallCases(std::vector<ModificationCase>& all, int view) {
    const Solid target = changed(solidOf(boxSpec(V(0, 0, 0), V(80, 60, 20))),
                                 {{BooleanKind::Add, boxSpec(V(0, 40, 20), V(80, 60, 55))}});
    CaseList cases("wall", target, V(40, 30, 28), view);
    cases.add("ramp against the wall", add, "triangular-prism",
              prismSpec({V(25, 10, 20), V(25, 40, 20), V(25, 40, 45)}, V(30, 0, 0)));
    cases.add("ramp over the whole width", add, "triangular-prism",
              prismSpec({V(0, 0, 20), V(0, 40, 20), V(0, 40, 45)}, V(80, 0, 0)));
    cases.add("box against the wall", add, "cube", boxSpec(V(20, 15, 20), V(50, 40, 40)));
    cases.add("box on the wall", add, "cube", boxSpec(V(20, 24, 33), V(52, 40, 48)));
    cases.add("box that makes the step higher", add, "cube", boxSpec(V(0, 0, 20), V(80, 40, 35)));
    cases.add("pocket at the foot of the wall", cut, "cube", boxSpec(V(20, 8, 10), V(65, 40, 20)),
              {}, 7);
    for (ModificationCase& c : cases.take()) all.push_back(std::move(c));
}

void addBossCases(std::vector<ModificationCase>& all, int view) {
    const Solid target = changed(solidOf(boxSpec(V(0, 0, 0), V(100, 60, 15))),
                                 {{BooleanKind::Add, boxSpec(V(10, 15, 15), V(35, 45, 35))},
                                  {BooleanKind::Add, boxSpec(V(65, 15, 15), V(90, 45, 35))}});
    CaseList cases("two bosses", target, V(50, 30, 15), view);
    cases.add("bridge on the bosses", add, "cube", boxSpec(V(10, 15, 35), V(90, 45, 55)));
    cases.add("bridge between the bosses", add, "cube", boxSpec(V(35, 15, 15), V(65, 45, 35)));
    cases.add("roof on one boss", add, "triangular-prism",
              prismSpec({V(65, 15, 35), V(90, 15, 35), V(77.5, 15, 60)}, V(0, 30, 0)));
    for (ModificationCase& c : cases.take()) all.push_back(std::move(c));
}

void addCrackCases(std::vector<ModificationCase>& all, int view) {
    const PolyhedronSpec box = boxSpec(V(0, 0, 0), V(80, 60, 40));
    const auto slotLines = [](double bottom) {
        return joined(
            joined(polyline({V(0, 20, 40), V(80, 20, 40)}),
                   polyline({V(80, 40, 40), V(0, 40, 40)})),
            polyline({V(80, 20, 40), V(80, 20, bottom), V(80, 40, bottom), V(80, 40, 40)}));
    };
    CaseList slots(
        "slotted box",
        changed(solidOf(box), {{BooleanKind::Cut, boxSpec(V(25, 0, 25), V(50, 60, 40))}}),
        V(40, 30, 20), view);
    slots.add("shallower crossing slot", cut, "cube", boxSpec(V(0, 20, 30), V(80, 40, 40)),
              slotLines(30));
    slots.add("deeper crossing slot", cut, "cube", boxSpec(V(0, 20, 15), V(80, 40, 40)),
              slotLines(15));
    for (ModificationCase& c : slots.take()) all.push_back(std::move(c));

    // What the hollows do to each other is not drawn.
    const auto asOnPlain = [&](const PolyhedronSpec& tool) {
        return newVisibleLines({solidOf(box), {}},
                               changed(solidOf(box), {{BooleanKind::Cut, tool}}),
                               modificationCamera(view, V(40, 30, 20)));
    };
    const PolyhedronSpec side = boxSpec(V(62, 6, 4), V(80, 54, 37));
    CaseList hollow(
        "hollow box",
        changed(solidOf(box), {{BooleanKind::Cut, boxSpec(V(25, 14, 20), V(67, 46, 40))}}),
        V(40, 30, 20), view);
    hollow.add("pocket into the pocket", cut, "cube", side, asOnPlain(side), 7);
    for (ModificationCase& c : hollow.take()) all.push_back(std::move(c));

    // The groove in the front breaks through the wall of the pocket, out of sight from above.
    const PolyhedronSpec pocket = boxSpec(V(15, 8, 20), V(65, 52, 40));
    CaseList groove(
        "grooved box",
        changed(solidOf(box), {{BooleanKind::Cut,
                                prismSpec({V(0, 0, 26), V(0, 15, 31), V(0, 0, 36)}, V(80, 0, 0))}}),
        V(40, 30, 20), view);
    groove.add("pocket into the groove", cut, "cube", pocket, asOnPlain(pocket), 7);
    for (ModificationCase& c : groove.take()) all.push_back(std::move(c));

    CaseList boss(
        "box with a boss",
        changed(solidOf(box), {{BooleanKind::Add, boxSpec(V(20, 10, 40), V(50, 40, 52))}}),
        V(40, 30, 20), view);
    boss.add("chamfer under the boss", cut, "triangular-prism",
             prismSpec({V(0, 0, 40), V(0, 20, 40), V(0, 0, 25)}, V(80, 0, 0)));
    for (ModificationCase& c : boss.take()) all.push_back(std::move(c));
}

}  // namespace

std::vector<ModificationCase> prismModifications(int view) {
    const Solid target = solidOf(prismSpec({V(0, 0, 0), V(0, 60, 45), V(0, 100, 0)}, V(90, 0, 0)));
    CaseList cases("prism", target, V(45, 40, 18), view);
    cases.add("box on the slope", add, "cube", slopeBox(25, 60, 20, 55, 15));
    cases.add("box over the whole slope", add, "cube", slopeBox(0, 90, 0, 75, 15));
    cases.add("pocket in the slope", cut, "cube", slopeBox(20, 65, 15, 60, -15), {}, 7);
    cases.add("notch in the slope's edge", cut, "cube", slopeBox(55, 90, 25, 50, -15));
    cases.add("slot along the slope", cut, "cube", slopeBox(0, 90, 30, 55, -15));
    cases.add("box on the end", add, "cube", boxSpec(V(90, 45, 8), V(110, 70, 22)));
    cases.add("corner cut by a triangle", cut, "triangular-pyramid",
              pyramidSpec(onSlope(90, 0), onSlope(60, 0), onSlope(90, 35), V(90, 30, 0)));
    cases.add(
        "roof on the slope", add, "triangular-prism",
        prismSpec({onSlope(20, 15), onSlope(60, 15), onSlope(40, 15, 20)}, onSlope(0, 40, 0)));
    return cases.take();
}

std::vector<ModificationCase> frustumModifications(int view) {
    CaseList cases("box", solidOf(boxSpec(V(0, 0, 0), V(80, 60, 40))), V(40, 30, 20), view);
    const auto frustum = [&](const std::string& name, const PolyhedronSpec& what) {
        cases.add(name, add, "wedge-frustum", what);
    };
    frustum("frustum inside a face", frustumSpec(V(20, 12, 40), V(60, 48, 70), 9, 10));
    frustum("low frustum inside a face", frustumSpec(V(12, 10, 40), V(68, 50, 56), 12, 10));
    frustum("frustum over the whole face", frustumSpec(V(0, 0, 40), V(80, 60, 70), 18, 15));
    frustum("frustum flush with the front", frustumSpec(V(20, 0, 40), V(60, 60, 68), 10, 14));
    return cases.take();
}

std::vector<ModificationCase> jointModifications(int view) {
    std::vector<ModificationCase> all;
    addWallCases(all, view);
    addBossCases(all, view);
    addCrackCases(all, view);
    return all;
}

}  // namespace ew::test
