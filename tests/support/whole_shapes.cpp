// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/whole_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "core/solid/boolean.h"
#include "core/solid/visibility.h"
#include "tests/support/modification_shapes.h"
#include "tests/support/random_shapes.h"
#include "tests/support/whole_views.h"

namespace ew::test {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Polygon = std::vector<Vec2>;

Polygon regularPolygon(int n, double phase) {
    Polygon out;
    for (int i = 0; i < n; ++i) {
        const double a = phase + kTurn * i / n;
        out.emplace_back(0.5 * std::cos(a), 0.5 * std::sin(a));
    }
    return out;
}

/// Convex: corners on an ellipse, at least a third of their even share apart.
Polygon convexPolygon(int n, Random& random) {
    std::vector<double> gaps;
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        gaps.push_back(random.uniform(0.5, 1.5));
        sum += gaps.back();
    }
    const double squeeze = random.uniform(0.6, 1.0);
    double a = random.uniform(0.0, kTurn);
    Polygon out;
    for (const double gap : gaps) {
        out.emplace_back(0.5 * std::cos(a), 0.5 * squeeze * std::sin(a));
        a += kTurn * gap / sum;
    }
    return out;
}

/// \param isRegular  receives which it is.
Polygon anyPolygon(int n, double regular, Random& random, bool& isRegular) {
    isRegular = random.chance(regular);
    return isRegular ? regularPolygon(n, random.uniform(0.0, kTurn)) : convexPolygon(n, random);
}

/// Outlines with right angles, and a house.
Polygon concavePolygon(Random& random) {
    const auto share = [&] { return random.uniform(0.28, 0.4); };
    const double h = random.uniform(0.6, 1.0);
    const double a = share();
    const double b = share() * h;
    switch (random.index(6)) {
        case 0:  // T
            return {{a, 0}, {1 - a, 0}, {1 - a, h - b}, {1, h - b},
                    {1, h}, {0, h},     {0, h - b},     {a, h - b}};
        case 1:  // U
            return {{0, 0}, {1, 0}, {1, h}, {1 - a, h}, {1 - a, b}, {a, b}, {a, h}, {0, h}};
        case 2:  // L
            return {{0, 0}, {1, 0}, {1, b}, {a, b}, {a, h}, {0, h}};
        case 3:  // plus
            return {{a, 0},     {1 - a, 0}, {1 - a, b}, {1, b},     {1, h - b}, {1 - a, h - b},
                    {1 - a, h}, {a, h},     {a, h - b}, {0, h - b}, {0, b},     {a, b}};
        case 4: {  // stairs
            const int steps = 2 + random.index(3);
            Polygon out{{0, 0}, {1, 0}};
            for (int k = 0; k < steps; ++k) {
                const double x = 1.0 - static_cast<double>(k) / steps;
                const double y = h * (k + 1) / steps;
                out.emplace_back(x, y);
                out.emplace_back(x - 1.0 / steps, y);
            }
            return out;
        }
        default:  // house
            return {{0, 0}, {1, 0}, {1, 0.6 * h}, {0.5, h + 0.1}, {0, 0.6 * h}};
    }
}

PolyhedronSpec lying(PolyhedronSpec spec, Random& random) {
    if (random.chance(0.5)) return spec;
    for (Vec3& v : spec.vertices) v = Vec3(v.x(), -v.z(), v.y());
    return spec;
}

/// Bottom vertices first, then the top ones, drawn in round their middle; one apex for 0.
PolyhedronSpec taperedSpec(const Polygon& polygon, double height, double top) {
    PolyhedronSpec spec = ew::test::prismSpec(polygon, height);
    Vec2 middle = Vec2::Zero();
    for (const Vec2& p : polygon) middle += p / static_cast<double>(polygon.size());
    const std::size_t n = polygon.size();
    for (std::size_t i = n; i < 2 * n; ++i) {
        spec.vertices[i].head<2>() = middle + top * (spec.vertices[i].head<2>() - middle);
    }
    if (top > 0.0) return spec;
    spec.vertices.resize(n + 1);
    spec.faces.erase(spec.faces.begin() + 1);
    for (std::size_t i = 0; i < n; ++i) {
        spec.faces[i + 1] = {static_cast<int>(i), static_cast<int>((i + 1) % n),
                             static_cast<int>(n)};
    }
    return spec;
}

struct Box {
    Vec3 low, high;
    Vec3 size() const { return high - low; }
};

std::optional<Solid> changed(const Solid& solid, const PolyhedronSpec& tool, BooleanKind kind) {
    const auto made = Solid::fromSpec(tool);
    if (!made) return std::nullopt;
    auto out = combine(solid, *made, kind);
    if (!out || out->report.shells != 1) return std::nullopt;
    return std::move(out->solid);
}

/// A box that stands on one of the six faces of another, within it, or a bite out of one.
struct Part {
    PolyhedronSpec spec;
    Box box;
    bool cut = false;
};

Part partOn(const Box& on, Random& random) {
    Part part;
    const int axis = random.chance(0.5) ? 2 : random.index(2);
    part.cut = random.chance(0.35);
    part.box = on;
    for (int k = 0; k < 3; ++k) {
        if (k == axis) continue;
        const double size = on.size()[k];
        const double width = size * random.uniform(0.35, 0.65);
        // Flush with one side, or inside.
        const double room = size - width;
        const int place = random.index(3);
        const double from = place == 0   ? 0.0
                            : place == 1 ? room
                                         : room * random.uniform(0.35, 0.65);
        part.box.low[k] = on.low[k] + from;
        part.box.high[k] = on.low[k] + from + width;
    }
    const bool up = axis == 2 || random.chance(0.5);
    const double depth = on.size()[axis] * random.uniform(0.3, 0.6);
    if (part.cut) {
        (up ? part.box.low : part.box.high)[axis] =
            up ? on.high[axis] - depth : on.low[axis] + depth;
    } else if (up) {
        part.box.low[axis] = on.high[axis];
        part.box.high[axis] = on.high[axis] + depth;
    } else {
        part.box.high[axis] = on.low[axis];
        part.box.low[axis] = on.low[axis] - depth;
    }
    part.spec = ew::test::boxSpec(part.box.low, part.box.high);
    if (axis != 2 || part.cut || !random.chance(0.25)) return part;
    // A roof or a pyramid instead.
    const Vec3 s = part.box.size();
    const Vec3 o = part.box.low;
    if (random.chance(0.5)) {
        part.spec = ew::test::prismSpec({o, o + Vec3(s.x(), 0, 0), o + Vec3(s.x() / 2, 0, s.z())},
                                        Vec3(0, s.y(), 0));
    } else {
        part.spec = taperedSpec({{0, 0}, {s.x(), 0}, {s.x(), s.y()}, {0, s.y()}}, s.z(), 0.0);
        for (Vec3& v : part.spec.vertices) v += o;
    }
    part.box.high.z() = part.box.low.z();  // nothing stands on it
    return part;
}

Solid partsSolid(int count, Random& random) {
    while (true) {
        const Box first{Vec3::Zero(),
                        Vec3(1.0, random.uniform(0.5, 1.0), random.uniform(0.35, 0.8))};
        Solid solid = solidOf(ew::test::boxSpec(first.low, first.high));
        std::vector<Box> boxes{first};
        int made = 1;
        for (int tries = 0; made < count && tries < 40; ++tries) {
            const Box on = boxes[at(random.index(static_cast<int>(boxes.size())))];
            if (on.size().minCoeff() < 0.1) continue;
            const Part part = partOn(on, random);
            auto next = changed(solid, part.spec, part.cut ? BooleanKind::Cut : BooleanKind::Add);
            if (!next) continue;
            solid = *std::move(next);
            if (!part.cut) boxes.push_back(part.box);
            ++made;
        }
        if (made == count) return solid;
    }
}

/// Everything beyond a plane, as a box big enough.
PolyhedronSpec beyond(const Vec3& normal, const Vec3& point) {
    const Vec3 n = normal.normalized();
    const Vec3 u = n.unitOrthogonal();
    const Vec3 v = n.cross(u);
    PolyhedronSpec spec = ew::test::boxSpec(Vec3(-4, -4, 0), Vec3(4, 4, 4));
    for (Vec3& p : spec.vertices) p = point + p.x() * u + p.y() * v + p.z() * n;
    return spec;
}

Solid trihedralSolid(Random& random) {
    while (true) {
        const Vec3 size(1.0, random.uniform(0.6, 1.0), random.uniform(0.5, 0.9));
        Solid solid = random.chance(0.4) ? partsSolid(2, random)
                                         : solidOf(ew::test::boxSpec(Vec3::Zero(), size));
        const auto bounds = solid.bounds();
        const int cuts = 1 + random.index(2);
        int made = 0;
        for (int tries = 0; made < cuts && tries < 20; ++tries) {
            // Towards the seen corner: up, and to any side.
            Vec3 n(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.2, 1.0));
            if (random.chance(0.5)) n[random.index(2)] = 0.0;  // along an edge
            const Vec3 corner = (n.array() > 0).select(bounds[1], bounds[0]);
            const Vec3 reach = 0.35 * n.cwiseAbs().cwiseProduct(bounds[1] - bounds[0]);
            const Vec3 p = corner - n.normalized() * (reach.sum() / n.norm());
            auto next = changed(solid, beyond(n, p), BooleanKind::Cut);
            if (!next) continue;
            solid = *std::move(next);
            ++made;
        }
        if (made == cuts) return solid;
    }
}

Solid manyEdgesSolid(Random& random) {
    const double w = random.uniform(0.5, 1.0);
    const double h = random.uniform(0.3, 0.7);
    const double roof = random.uniform(0.3, 0.6);
    const Solid walls = solidOf(ew::test::boxSpec(1.0, w, h));
    switch (random.index(3)) {
        case 0: {  // a pyramid flush on a box
            PolyhedronSpec top = taperedSpec({{0, 0}, {1, 0}, {1, w}, {0, w}}, roof, 0.0);
            for (Vec3& v : top.vertices) v.z() += h;
            return *changed(walls, top, BooleanKind::Add);
        }
        case 1: {  // a hip roof on its walls
            const double in = 0.3;
            PolyhedronSpec top;
            top.vertices = {{0, 0, h},
                            {1, 0, h},
                            {1, w, h},
                            {0, w, h},
                            {in, w / 2, h + roof},
                            {1 - in, w / 2, h + roof}};
            top.faces = {{3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 5}, {2, 3, 4, 5}, {3, 0, 4}};
            return *changed(walls, top, BooleanKind::Add);
        }
        default: {  // a double pyramid
            const int n = 4 + random.index(2);
            const Polygon p = regularPolygon(n, random.uniform(0.0, kTurn));
            PolyhedronSpec up = taperedSpec(p, roof, 0.0);
            PolyhedronSpec spec;
            spec.vertices = up.vertices;
            spec.vertices.emplace_back(0, 0, -roof);
            for (std::size_t f = 1; f < up.faces.size(); ++f) {
                spec.faces.push_back(up.faces[f]);
                spec.faces.push_back({up.faces[f][1], up.faces[f][0], n + 1});
            }
            return solidOf(spec);
        }
    }
}

Solid bodiesSolid(Random& random) {
    while (true) {
        const int count = 2 + random.index(2);
        Solid solid = solidOf(ew::test::boxSpec(random.uniform(0.4, 0.8), random.uniform(0.4, 0.8),
                                                random.uniform(0.3, 0.9)));
        int made = 1;
        for (int tries = 0; made < count && tries < 30; ++tries) {
            PolyhedronSpec spec = ew::test::boxSpec(
                random.uniform(0.3, 0.7), random.uniform(0.3, 0.7), random.uniform(0.3, 0.9));
            const Vec3 shift(random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2), 0.0);
            for (Vec3& v : spec.vertices) v += shift;
            const auto next = Solid::fromSpec(spec);
            auto out = combine(solid, *next, BooleanKind::Add);
            if (!out || out->report.shells != made + 1) continue;
            solid = std::move(out->solid);
            ++made;
        }
        if (made == count) return solid;
    }
}

}  // namespace

const std::vector<std::string>& wholeKinds() {
    static const std::vector<std::string> kinds{"prism",      "concave", "pyramid", "frustum",
                                                "parts-2",    "parts-5", "parts-8", "trihedral",
                                                "many-edges", "bodies"};
    return kinds;
}

WholeShape randomWhole(const std::string& kind, Random& random) {
    bool told = true;
    if (kind == "prism") {
        const int n = 4 + random.index(7);
        const Polygon base = anyPolygon(n, 0.34, random, told);
        return {solidOf(lying(ew::test::prismSpec(base, random.uniform(0.3, 1.0)), random)), told};
    }
    if (kind == "concave") {
        return {solidOf(
            lying(ew::test::prismSpec(concavePolygon(random), random.uniform(0.3, 1.0)), random))};
    }
    if (kind == "pyramid" || kind == "frustum") {
        const int n = 4 + random.index(5);
        const double top = kind == "pyramid" ? 0.0 : random.uniform(0.35, 0.7);
        Polygon base = anyPolygon(n, kind == "pyramid" ? 1.0 : 0.5, random, told);
        if (n == 4) {
            const double w = random.uniform(0.5, 1.0);
            base = {{0, 0}, {1, 0}, {1, w}, {0, w}};
            // Other rectangles of other heights look the same within a pixel.
            told = kind == "frustum";
        }
        return {solidOf(taperedSpec(base, random.uniform(0.4, 1.0), top)), told};
    }
    if (kind == "parts-2") return {partsSolid(2, random)};
    if (kind == "parts-5") return {partsSolid(3 + random.index(3), random)};
    if (kind == "parts-8") return {partsSolid(6 + random.index(3), random)};
    if (kind == "trihedral") return {trihedralSolid(random)};
    if (kind == "many-edges") return {manyEdgesSolid(random)};
    return {bodiesSolid(random)};
}

WholeCase wholeCase(const Solid& solid, const OrthographicCamera& camera) {
    WholeCase out{solid, camera, {}, {}, true};
    const auto view = SolidView::make(solid, Pose{}, camera);
    std::map<int, std::vector<std::array<double, 2>>> seen;
    for (const VisiblePiece& piece : view->visiblePieces()) {
        if (piece.point) continue;
        out.lines.push_back(piece.px);
        seen[piece.edge].push_back({piece.t0, piece.t1});
    }
    for (std::size_t e = 0; e < solid.edges().size(); ++e) {
        const auto& ends = solid.edges()[e].ends;
        const Vec2 a = view->points()[at(ends[0])];
        const Vec2 b = view->points()[at(ends[1])];
        double from = 0.0;
        auto& pieces = seen[static_cast<int>(e)];
        pieces.push_back({1.0, 1.0});
        std::sort(pieces.begin(), pieces.end());
        for (const auto& [t0, t1] : pieces) {
            if ((t0 - from) * (b - a).norm() > 1.0) {
                out.hidden.push_back({a + from * (b - a), a + t0 * (b - a)});
            }
            from = t1;
        }
    }
    return out;
}

std::vector<Line2> withGuides(const std::vector<Line2>& lines, Random& random) {
    double mean = 0.0;
    for (const Line2& l : lines) mean += (l[1] - l[0]).norm() / static_cast<double>(lines.size());
    std::vector<Line2> out;
    for (const Line2& l : lines) {
        const Vec2 d = (l[1] - l[0]).normalized();
        const double before = random.uniform(0.1, 0.6) * mean;
        const double after = random.uniform(0.1, 0.6) * mean;
        out.push_back({Vec2(l[0] - before * d), Vec2(l[1] + after * d)});
    }
    return out;
}

WholeCase randomWholeCase(const std::string& kind, Random& random) {
    while (true) {
        const WholeShape whole = randomWhole(kind, random);
        const Solid& shape = whole.solid;
        for (int view = 0; view < 12; ++view) {
            const double tilt = random.uniform(18.0, 50.0) / 360.0 * kTurn;
            const double azimuth = random.uniform(0.0, kTurn);
            OrthographicCamera camera;
            camera.direction = Vec3(-std::cos(azimuth) * std::cos(tilt),
                                    -std::sin(azimuth) * std::cos(tilt), -std::sin(tilt));
            if (wellSeenFaces(shape, camera) < 3 || hasSliver(shape, camera)) continue;
            Vec2 low = Vec2::Constant(1e9);
            Vec2 high = -low;
            for (const Vec3& v : shape.vertices()) {
                low = low.cwiseMin(camera.project(v));
                high = high.cwiseMax(camera.project(v));
            }
            const double diagonal = random.uniform(320.0, 680.0);
            camera.worldPerPixel *= (high - low).norm() / diagonal;
            Vec2 middle = Vec2::Zero();
            for (const Vec3& v : shape.vertices()) {
                middle += camera.project(v) / static_cast<double>(shape.vertices().size());
            }
            camera.center = camera.unproject(middle);
            WholeCase drawn = wholeCase(shape, camera);
            drawn.tellsVolume = whole.tellsVolume;
            const bool told = showsItsParts(shape, camera) && showsItsFaces(shape, camera) &&
                              showsItsCorners(shape, camera);
            if (told && isReadable(drawn)) return drawn;
        }
    }
}

}  // namespace ew::test
