// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/modification_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/solid/visibility.h"
#include "tests/support/case_list.h"

namespace ew::test {
namespace {

void addCuts(CaseList& cases) {
    const auto cut = Operation::Cut;
    using V = Vec3;
    cases.add("corner cut by a triangle", cut, "triangular-pyramid",
              pyramidSpec(V(50, 0, 40), V(80, 25, 40), V(80, 0, 20), V(80, 0, 40)));
    cases.add("corner notch with its inner Y", cut, "cube", boxSpec(V(50, 0, 20), V(80, 25, 40)));
    cases.add("corner notch by its outline", cut, "cube", boxSpec(V(50, 0, 20), V(80, 25, 40)),
              polyline({V(50, 0, 40), V(50, 25, 40), V(80, 25, 40), V(80, 25, 20), V(80, 0, 20),
                        V(50, 0, 20), V(50, 0, 40)}));
    Lines3 notch = polyline({V(20, 0, 40), V(20, 20, 40), V(50, 20, 40), V(50, 0, 40)});
    notch = joined(notch, polyline({V(20, 0, 40), V(20, 0, 25), V(50, 0, 25), V(50, 0, 40)}));
    cases.add("edge notch by its outline", cut, "cube", boxSpec(V(20, 0, 25), V(50, 20, 40)),
              notch);
    cases.add("edge notch with its inside", cut, "cube", boxSpec(V(20, 0, 25), V(50, 20, 40)));
    Lines3 rabbet =
        polyline({V(0, 0, 25), V(80, 0, 25), V(80, 20, 25), V(80, 20, 40), V(0, 20, 40)});
    cases.add("rabbet by its outline", cut, "cube", boxSpec(V(0, 0, 25), V(80, 20, 40)), rabbet);
    cases.add("rabbet with its inside", cut, "cube", boxSpec(V(0, 0, 25), V(80, 20, 40)));
    cases.add("chamfer of a whole edge", cut, "triangular-prism",
              prismSpec({V(0, 0, 40), V(0, 20, 40), V(0, 0, 25)}, V(80, 0, 0)));
    cases.add("chamfer of part of an edge", cut, "triangular-prism",
              prismSpec({V(20, 0, 40), V(20, 20, 40), V(20, 0, 20)}, V(40, 0, 0)));
    cases.add("chamfer that ends in the next edge", cut, "triangular-prism",
              prismSpec({V(0, 0, 40), V(0, 25, 40), V(0, 0, 0)}, V(80, 0, 0)));
    Lines3 groove =
        polyline({V(30, 60, 40), V(30, 0, 40), V(40, 0, 25), V(50, 0, 40), V(50, 60, 40)});
    cases.add("V groove by its outline", cut, "triangular-prism",
              prismSpec({V(30, 0, 40), V(50, 0, 40), V(40, 0, 25)}, V(0, 60, 0)), groove);
    cases.add("V groove with its inside", cut, "triangular-prism",
              prismSpec({V(30, 0, 40), V(50, 0, 40), V(40, 0, 25)}, V(0, 60, 0)));
    Lines3 slot = polyline(
        {V(30, 60, 40), V(30, 0, 40), V(30, 0, 25), V(50, 0, 25), V(50, 0, 40), V(50, 60, 40)});
    cases.add("square slot by its outline", cut, "cube", boxSpec(V(30, 0, 25), V(50, 60, 40)),
              slot);
    cases.add("square slot with its inside", cut, "cube", boxSpec(V(22, 0, 25), V(60, 60, 40)));
    cases.add("pocket with its inside", cut, "cube", boxSpec(V(20, 12, 25), V(65, 48, 40)), {}, 7);
    cases.add("pocket in the front", cut, "cube", boxSpec(V(20, 0, 10), V(60, 15, 30)), {}, 7);
    cases.add("shallow pocket on the right", cut, "cube", boxSpec(V(72, 10, 8), V(80, 50, 32)), {},
              7);
    cases.add("through hole", cut, "cube", boxSpec(V(15, 10, 0), V(70, 52, 40)));
}

void addAdds(CaseList& cases) {
    const auto add = Operation::Add;
    using V = Vec3;
    cases.add("box inside a face", add, "cube", boxSpec(V(20, 15, 40), V(55, 45, 60)));
    cases.add("box flush with one edge", add, "cube", boxSpec(V(20, 0, 40), V(50, 30, 60)));
    cases.add("box flush with two edges", add, "cube", boxSpec(V(50, 0, 40), V(80, 25, 58)));
    cases.add("box over the whole face", add, "cube", boxSpec(V(0, 0, 40), V(80, 60, 60)));
    cases.add("box hanging over the border", add, "cube", boxSpec(V(50, 20, 40), V(105, 50, 58)));
    cases.add("box on a side face", add, "cube", boxSpec(V(80, 15, 10), V(105, 45, 30)));
    cases.add("box on the front", add, "cube", boxSpec(V(20, -22, 8), V(60, 0, 30)));
    cases.add("roof over the whole face", add, "triangular-prism",
              prismSpec({V(0, 0, 40), V(80, 0, 40), V(40, 0, 65)}, V(0, 60, 0)));
    cases.add("roof over a part", add, "triangular-prism",
              prismSpec({V(15, 10, 40), V(55, 10, 40), V(35, 10, 60)}, V(0, 40, 0)));
    cases.add("pyramid on a face", add, "triangular-pyramid",
              // Regular, which is how its height is told.
              pyramidSpec(V(20, 12, 40), V(60, 12, 40), V(40, 12 + 20 * std::sqrt(3.0), 40),
                          V(40, 12 + 20 / std::sqrt(3.0), 40 + 40 * std::sqrt(2.0 / 3.0))));
}

constexpr BooleanKind kAdd = BooleanKind::Add;
constexpr BooleanKind kCut = BooleanKind::Cut;

/// Ten changes that leave alone what the cases on the box draw on.
Solid workedBox() {
    using V = Vec3;
    return changed(solidOf(boxSpec(V(0, 0, 0), V(80, 60, 40))),
                   {{kCut, boxSpec(V(0, 50, 30), V(10, 60, 40))},
                    {kCut, boxSpec(V(71, 50, 33), V(78, 57, 40))},
                    {kCut, boxSpec(V(0, 15, 5), V(6, 40, 25))},
                    {kCut, boxSpec(V(6, 20, 15), V(10, 30, 20))},
                    {kCut, boxSpec(V(20, 54, 8), V(46, 60, 22))},
                    {kCut, prismSpec({V(0, 60, 0), V(0, 55, 0), V(0, 60, 4)}, V(80, 0, 0))},
                    {kCut, boxSpec(V(4, 5, 0), V(12, 45, 4))},
                    {kAdd, boxSpec(V(55, 60, 10), V(70, 66, 30))},
                    {kCut, pyramidSpec(V(0, 60, 10), V(0, 50, 10), V(8, 60, 10), V(0, 60, 25))},
                    {kCut, boxSpec(V(58, 62, 20), V(66, 66, 30))}});
}

/// Is a point neither on a line nor well away from it, or neither at its end nor well away from
/// that?
bool tooNear(const Vec2& p, const Line2& line, double far) {
    const Vec2 d = line[1] - line[0];
    const double t = std::clamp((p - line[0]).dot(d) / d.squaredNorm(), 0.0, 1.0);
    const double off = (p - line[0] - t * d).norm();
    const double end = std::min((p - line[0]).norm(), (p - line[1]).norm());
    return (off > 1e-6 && off < far) || (end > 1e-6 && end < far);
}

bool meet(const Line2& l, const Line2& m) {
    for (const Vec2& p : l) {
        for (const Vec2& q : m) {
            if ((p - q).norm() < 1e-6) return true;
        }
    }
    return false;
}

}  // namespace

bool ModificationCase::legible() const {
    const double far = Thresholds{}.distancePx;
    const auto drawn = linesOnPlane(*this);
    if (!told) return false;
    for (const Line2& l : drawn) {
        if ((l[1] - l[0]).norm() < 2.0 * far) return false;
    }
    std::vector<Line2> all = drawn;
    const auto picture = SolidView::make(target.solid, target.pose, camera);
    for (const VisiblePiece& p : picture->visiblePieces()) {
        if (!p.point) all.push_back({p.px[0], p.px[1]});
    }
    for (const Line2& l : drawn) {
        for (const Vec2& p : l) {
            for (const Line2& m : all) {
                if (tooNear(p, m, 1.3 * far)) return false;
            }
        }
        // Lines of different directions in space that look like one, or side by side.
        const Vec2 u = (l[1] - l[0]).normalized();
        for (const Line2& m : all) {
            const Vec2 w = m[1] - m[0];
            if (std::abs(cross2(u, w)) > 0.17 * w.norm()) continue;
            const double lo = std::min((m[0] - l[0]).dot(u), (m[1] - l[0]).dot(u));
            const double hi = std::max((m[0] - l[0]).dot(u), (m[1] - l[0]).dot(u));
            const double overlap = std::min(hi, (l[1] - l[0]).norm()) - std::max(lo, 0.0);
            const double apart = std::abs(cross2(u, 0.5 * (m[0] + m[1]) - l[0]));
            if (overlap > 2.0 * far && apart < far && apart > 1e-6) return false;
            if (std::abs(overlap) < 1.0 && apart > 1e-6 && meet(l, m)) return false;
        }
    }
    return true;
}

OrthographicCamera modificationCamera(int view, const Vec3& center, const Pose& pose) {
    // Azimuth of the eye from the x axis towards -y, and tilt [degrees].
    static constexpr std::array<std::array<double, 2>, kModificationDirections> kViews{
        {{44.06, 31.07},
         {32, 30},
         {57, 33},
         {45, 43},
         {38, 24},
         {25, 35},
         {65, 28},
         {36, 38},
         {52, 48},
         {28, 45},
         {62, 42},
         {48, 22},
         {40, 52},
         {20, 25}}};
    const auto& seenFrom = kViews[static_cast<std::size_t>(view % kModificationDirections)];
    const double azimuth = seenFrom[0] * std::numbers::pi / 180.0;
    const double tilt = seenFrom[1] * std::numbers::pi / 180.0;
    OrthographicCamera camera;
    camera.direction = pose.directionToWorld(Vec3(
        -std::cos(azimuth) * std::cos(tilt), std::sin(azimuth) * std::cos(tilt), -std::sin(tilt)));
    camera.up = pose.directionToWorld(Vec3::UnitZ());
    camera.center = pose.toWorld(center);
    camera.worldPerPixel = view < kModificationDirections ? 0.25 : 0.16;
    return camera;
}

OrthographicCamera defaultBoxCamera(const Pose& pose) {
    return modificationCamera(0, Vec3(40, 30, 20), pose);
}

std::vector<ModificationCase> boxModifications(const Pose& pose, int view) {
    CaseList cases("box", solidOf(boxSpec(Vec3::Zero(), Vec3(80, 60, 40))), Vec3(40, 30, 20), view,
                   pose);
    addCuts(cases);
    addAdds(cases);
    return cases.take();
}

std::vector<ModificationCase> workedBoxModifications(int view) {
    CaseList cases("worked box", workedBox(), Vec3(40, 30, 20), view);
    addCuts(cases);
    addAdds(cases);
    auto all = cases.take();
    for (ModificationCase& c : all) {
        // Its floor is flush with a pocket out of sight, behind which a line ends for no reason
        // that the person who draws could know.
        if (c.name == "rabbet with its inside") c.told = false;
    }
    return all;
}

ModificationCase caseNamed(const std::vector<ModificationCase>& cases, const std::string& name) {
    const auto found = std::find_if(cases.begin(), cases.end(),
                                    [&](const ModificationCase& c) { return c.name == name; });
    if (found == cases.end()) std::abort();
    return *found;
}

std::vector<Line2> linesOnPlane(const ModificationCase& c) {
    std::vector<Line2> lines;
    for (const auto& l : c.lines) {
        lines.push_back({c.camera.project(c.target.pose.toWorld(l[0])),
                         c.camera.project(c.target.pose.toWorld(l[1]))});
    }
    return lines;
}

std::vector<Stroke> exactStrokes(const std::vector<Line2>& lines) {
    std::vector<Stroke> strokes;
    for (const Line2& l : lines) {
        Stroke s;
        const int n = std::max(8, static_cast<int>((l[1] - l[0]).norm() / 4.0));
        for (int i = 0; i <= n; ++i) {
            s.samples.push_back({l[0] + (l[1] - l[0]) * i / n, 0.5, 8.0 * i});
        }
        strokes.push_back(std::move(s));
    }
    return strokes;
}

}  // namespace ew::test
