// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/modification_cases.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/solid/boolean.h"
#include "core/solid/visibility.h"

namespace ew::test {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }
using Lines = std::vector<std::array<Vec3, 2>>;

Solid solidOf(const PolyhedronSpec& spec) {
    auto solid = Solid::fromSpec(spec);
    if (!solid) throw std::runtime_error(solid.error().message);
    return *solid;
}

PolyhedronSpec boxSpec(const Vec3& a, const Vec3& b) {
    PolyhedronSpec s;
    for (const double z : {a.z(), b.z()}) {
        s.vertices.emplace_back(a.x(), a.y(), z);
        s.vertices.emplace_back(b.x(), a.y(), z);
        s.vertices.emplace_back(b.x(), b.y(), z);
        s.vertices.emplace_back(a.x(), b.y(), z);
    }
    s.faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return s;
}

/// A prism over a triangle, counter-clockwise seen against `along`.
PolyhedronSpec prismSpec(const std::array<Vec3, 3>& t, const Vec3& along) {
    PolyhedronSpec s;
    for (const Vec3& p : t) s.vertices.push_back(p);
    for (const Vec3& p : t) s.vertices.emplace_back(p + along);
    s.faces = {{2, 1, 0}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
    if ((t[1] - t[0]).cross(t[2] - t[0]).dot(along) < 0) {
        for (auto& f : s.faces) std::reverse(f.begin(), f.end());
    }
    return s;
}

PolyhedronSpec pyramidSpec(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& apex) {
    PolyhedronSpec s;
    s.vertices = {a, b, c, apex};
    s.faces = {{2, 1, 0}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    if ((b - a).cross(c - a).dot(apex - a) < 0) {
        for (auto& f : s.faces) std::reverse(f.begin(), f.end());
    }
    return s;
}

/// The parts of a segment that lie on no edge of the solid.
Lines withoutEdges(const std::array<Vec3, 2>& line, const Solid& solid) {
    const Vec3 u = line[1] - line[0];
    const double len = u.norm();
    std::vector<std::array<double, 2>> left{{0.0, len}};
    for (const SolidEdge& e : solid.edges()) {
        const Vec3& a = solid.vertices()[at(e.ends[0])];
        const Vec3& b = solid.vertices()[at(e.ends[1])];
        if (u.cross(a - line[0]).norm() > 1e-6 * len || u.cross(b - line[0]).norm() > 1e-6 * len) {
            continue;
        }
        const double ta = (a - line[0]).dot(u) / len;
        const double tb = (b - line[0]).dot(u) / len;
        std::vector<std::array<double, 2>> next;
        for (const auto& l : left) {
            const double lo = std::min(ta, tb);
            const double hi = std::max(ta, tb);
            if (std::min(l[1], lo) > l[0]) next.push_back({l[0], std::min(l[1], lo)});
            if (l[1] > std::max(l[0], hi)) next.push_back({std::max(l[0], hi), l[1]});
        }
        left = std::move(next);
    }
    Lines lines;
    for (const auto& l : left) {
        if (l[1] - l[0] < 1e-6) continue;
        lines.push_back({line[0] + l[0] / len * u, line[0] + l[1] / len * u});
    }
    return lines;
}

/// What is new in the result and can be seen.
Lines newVisibleLines(const Body& target, const Solid& result, const OrthographicCamera& camera) {
    const auto view = SolidView::make(result, target.pose, camera);
    Lines lines;
    for (const VisiblePiece& p : view->visiblePieces()) {
        if (p.point) continue;
        const auto& ends = result.edges()[at(p.edge)].ends;
        const Vec3& a = result.vertices()[at(ends[0])];
        const Vec3& b = result.vertices()[at(ends[1])];
        for (const auto& l : withoutEdges({a + p.t0 * (b - a), a + p.t1 * (b - a)}, target.solid)) {
            // Nobody draws a line as short as its corners are wide.
            if ((l[1] - l[0]).norm() > 2.5) lines.push_back(l);
        }
    }
    return lines;
}

class Cases {
  public:
    explicit Cases(const Pose& pose)
        : target_{solidOf(boxSpec(Vec3::Zero(), Vec3(80, 60, 40))), pose},
          camera_(defaultBoxCamera(pose)) {}

    /// Lines empty: those that are new and visible.
    void add(const std::string& name, Operation op, const std::string& tmpl,
             const PolyhedronSpec& tool, Lines lines = {}) {
        ModificationCase c{name, target_, op, tmpl, std::move(lines)};
        const auto result = combine(target_.solid, solidOf(tool),
                                    op == Operation::Add ? BooleanKind::Add : BooleanKind::Cut);
        if (!result) throw std::runtime_error(name + ": " + result.error().message);
        if (c.lines.empty()) c.lines = newVisibleLines(target_, result->solid, camera_);
        c.volume = result->solid.volume();
        c.vertices = static_cast<int>(result->solid.vertices().size());
        c.edges = static_cast<int>(result->solid.edges().size());
        c.faces = static_cast<int>(result->solid.faces().size());
        all_.push_back(std::move(c));
    }
    std::vector<ModificationCase> take() { return std::move(all_); }

  private:
    Body target_;
    OrthographicCamera camera_;
    std::vector<ModificationCase> all_;
};

Lines polyline(const std::vector<Vec3>& p) {
    Lines lines;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) lines.push_back({p[i], p[i + 1]});
    return lines;
}

void addCuts(Cases& cases) {
    const auto cut = Operation::Cut;
    using V = Vec3;
    cases.add("corner cut by a triangle", cut, "triangular-pyramid",
              pyramidSpec(V(50, 0, 40), V(80, 25, 40), V(80, 0, 20), V(80, 0, 40)));
    cases.add("corner notch with its inner Y", cut, "cube", boxSpec(V(50, 0, 20), V(80, 25, 40)));
    cases.add("corner notch by its outline", cut, "cube", boxSpec(V(50, 0, 20), V(80, 25, 40)),
              polyline({V(50, 0, 40), V(50, 25, 40), V(80, 25, 40), V(80, 25, 20), V(80, 0, 20),
                        V(50, 0, 20), V(50, 0, 40)}));
    Lines notch = polyline({V(20, 0, 40), V(20, 20, 40), V(50, 20, 40), V(50, 0, 40)});
    for (const auto& l : polyline({V(20, 0, 40), V(20, 0, 25), V(50, 0, 25), V(50, 0, 40)})) {
        notch.push_back(l);
    }
    cases.add("edge notch by its outline", cut, "cube", boxSpec(V(20, 0, 25), V(50, 20, 40)),
              notch);
    cases.add("edge notch with its inside", cut, "cube", boxSpec(V(20, 0, 25), V(50, 20, 40)));
    Lines rabbet =
        polyline({V(0, 0, 25), V(80, 0, 25), V(80, 20, 25), V(80, 20, 40), V(0, 20, 40)});
    cases.add("rabbet by its outline", cut, "cube", boxSpec(V(0, 0, 25), V(80, 20, 40)), rabbet);
    cases.add("rabbet with its inside", cut, "cube", boxSpec(V(0, 0, 25), V(80, 20, 40)));
    cases.add("chamfer of a whole edge", cut, "triangular-prism",
              prismSpec({V(0, 0, 40), V(0, 20, 40), V(0, 0, 25)}, V(80, 0, 0)));
    Lines groove =
        polyline({V(30, 60, 40), V(30, 0, 40), V(40, 0, 25), V(50, 0, 40), V(50, 60, 40)});
    cases.add("V groove by its outline", cut, "triangular-prism",
              prismSpec({V(30, 0, 40), V(50, 0, 40), V(40, 0, 25)}, V(0, 60, 0)), groove);
    cases.add("V groove with its inside", cut, "triangular-prism",
              prismSpec({V(30, 0, 40), V(50, 0, 40), V(40, 0, 25)}, V(0, 60, 0)));
    Lines slot = polyline(
        {V(30, 60, 40), V(30, 0, 40), V(30, 0, 25), V(50, 0, 25), V(50, 0, 40), V(50, 60, 40)});
    cases.add("square slot by its outline", cut, "cube", boxSpec(V(30, 0, 25), V(50, 60, 40)),
              slot);
    cases.add("square slot with its inside", cut, "cube", boxSpec(V(22, 0, 25), V(60, 60, 40)));
    cases.add("pocket with its inside", cut, "cube", boxSpec(V(20, 12, 25), V(65, 48, 40)));
    cases.add("pocket in the front", cut, "cube", boxSpec(V(20, 0, 10), V(60, 15, 30)));
    cases.add("shallow pocket on the right", cut, "cube", boxSpec(V(72, 10, 8), V(80, 50, 32)));
    cases.add("through hole", cut, "cube", boxSpec(V(15, 10, 0), V(70, 52, 40)));
}

void addAdds(Cases& cases) {
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

}  // namespace

OrthographicCamera defaultBoxCamera(const Pose& pose) {
    OrthographicCamera camera;
    camera.direction = pose.directionToWorld(Vec3(-0.62, 0.6, -0.52).normalized());
    camera.up = pose.directionToWorld(Vec3::UnitZ());
    camera.center = pose.toWorld(Vec3(40, 30, 20));
    camera.worldPerPixel = 0.25;
    return camera;
}

std::vector<ModificationCase> boxModifications(const Pose& pose) {
    Cases cases(pose);
    addCuts(cases);
    addAdds(cases);
    return cases.take();
}

std::vector<Line2> linesOnPlane(const ModificationCase& c, const OrthographicCamera& camera) {
    std::vector<Line2> lines;
    for (const auto& l : c.lines) {
        lines.push_back({camera.project(c.target.pose.toWorld(l[0])),
                         camera.project(c.target.pose.toWorld(l[1]))});
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
