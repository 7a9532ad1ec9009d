// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/practice/practice_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "core/solid/visibility.h"

namespace ew {
namespace {

constexpr double kMargin = 16.0;
constexpr double kGap = 34.0;       // between views, with room for a name
constexpr double kLargest = 150.0;  // view
constexpr double kAlone = 300.0;    // the only view

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof(text), "%.1f", value);
    return text;
}

std::string lineSvg(const Vec2& a, const Vec2& b, const std::string& style) {
    return "<line x1=\"" + number(a.x()) + "\" y1=\"" + number(a.y()) + "\" x2=\"" + number(b.x()) +
           "\" y2=\"" + number(b.y()) + "\" " + style + "/>\n";
}

using Line = std::array<Vec2, 2>;

/// Where one line lies over another one, along it from 0 to 1; nothing where it does not.
std::optional<std::array<double, 2>> overlap(const Line& line, const Line& over) {
    constexpr double kOnePx = 0.7;
    const Vec2 along = line[1] - line[0];
    const double length = along.norm();
    const Vec2 normal(-along.y() / length, along.x() / length);
    std::array<double, 2> t{};
    for (std::size_t k = 0; k < 2; ++k) {
        const Vec2 off = over[k] - line[0];
        if (std::abs(off.dot(normal)) > kOnePx) return std::nullopt;
        t[k] = std::clamp(off.dot(along) / (length * length), 0.0, 1.0);
    }
    if (t[0] > t[1]) std::swap(t[0], t[1]);
    return t;
}

/// What of a line none of the others covers.
void addUncovered(const Line& line, const std::vector<Line>& seen, std::vector<Line>& out) {
    constexpr double kLeastPx = 2.0;
    const double length = (line[1] - line[0]).norm();
    if (length < kLeastPx) return;
    std::vector<std::array<double, 2>> covered;
    for (const std::vector<Line>* lines : {&seen, static_cast<const std::vector<Line>*>(&out)}) {
        for (const Line& other : *lines) {
            if (const auto t = overlap(line, other)) covered.push_back(*t);
        }
    }
    std::sort(covered.begin(), covered.end());
    covered.push_back({1.0, 1.0});
    double from = 0.0;
    for (const auto& [begin, end] : covered) {
        if ((begin - from) * length >= kLeastPx) {
            out.push_back(
                {line[0] + from * (line[1] - line[0]), line[0] + begin * (line[1] - line[0])});
        }
        from = std::max(from, end);
    }
}

/// One view of the solid, with its top left corner at the origin.
struct View {
    std::vector<Line> seen, hidden;
    Vec2 size = Vec2::Zero();
};

View viewOf(const Solid& solid, OrthographicCamera camera, double worldPerPixel) {
    camera.worldPerPixel = worldPerPixel;
    View out;
    const auto view = SolidView::make(solid, {}, camera);
    if (!view) return out;
    Eigen::AlignedBox2d box;
    for (const Vec2& p : view->points()) box.extend(p);
    out.size = box.sizes();
    for (const VisiblePiece& piece : view->visiblePieces()) {
        if (!piece.point) out.seen.push_back({piece.px[0] - box.min(), piece.px[1] - box.min()});
    }
    for (const SolidEdge& edge : solid.edges()) {
        const auto end = [&](int k) -> Vec2 {
            return view->points()[static_cast<std::size_t>(
                       edge.ends[static_cast<std::size_t>(k)])] -
                   box.min();
        };
        addUncovered({end(0), end(1)}, out.seen, out.hidden);
    }
    return out;
}

OrthographicCamera along(const Vec3& direction, const Vec3& up) {
    OrthographicCamera camera;
    camera.direction = direction;
    camera.up = up;
    return camera;
}

class Picture {
  public:
    explicit Picture(const PracticePaint& paint) : paint_(paint) {}

    void add(const View& view, const Vec2& at, bool withHidden) {
        const std::string common = "stroke-linecap=\"round\" fill=\"none\" ";
        const std::string hidden =
            common + "stroke=\"" + paint_.hidden + "\" stroke-width=\"1\" stroke-dasharray=\"4 4\"";
        const std::string seen = common + "stroke=\"" + paint_.line + "\" stroke-width=\"1.8\"";
        if (withHidden) {
            for (const auto& l : view.hidden) body_ += lineSvg(l[0] + at, l[1] + at, hidden);
        }
        for (const auto& l : view.seen) body_ += lineSvg(l[0] + at, l[1] + at, seen);
        size_ = size_.cwiseMax(at + view.size);
    }
    void name(const std::string& text, const Vec2& at) {
        body_ += "<text x=\"" + number(at.x()) + "\" y=\"" + number(at.y()) +
                 "\" font-family=\"sans-serif\" font-size=\"13\" fill=\"" + paint_.hidden + "\">" +
                 text + "</text>\n";
    }
    std::string svg() const {
        const Vec2 all = size_ + Vec2(kMargin, kMargin);
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(all.x()) +
               "\" height=\"" + number(all.y()) + "\" viewBox=\"0 0 " + number(all.x()) + " " +
               number(all.y()) + "\">\n" + body_ + "</svg>\n";
    }

  private:
    const PracticePaint& paint_;
    std::string body_;
    Vec2 size_ = Vec2::Zero();
};

}  // namespace

std::string practiceSvg(const PracticeTask& task, const PracticePaint& paint) {
    const Solid& solid = task.shape.solid;
    Picture picture(paint);
    if (task.kind == PracticeKind::View) {
        View view = viewOf(solid, task.shape.camera, task.shape.camera.worldPerPixel);
        const double shrink = view.size.maxCoeff() / kAlone;
        view = viewOf(solid, task.shape.camera, task.shape.camera.worldPerPixel * shrink);
        picture.add(view, {kMargin, kMargin}, false);
        return picture.svg();
    }
    const auto bounds = solid.bounds();
    const double scale = (bounds[1] - bounds[0]).maxCoeff() / kLargest;
    const View front = viewOf(solid, along(Vec3::UnitY(), Vec3::UnitZ()), scale);
    const View right = viewOf(solid, along(-Vec3::UnitX(), Vec3::UnitZ()), scale);
    const View top = viewOf(solid, along(-Vec3::UnitZ(), Vec3::UnitY()), scale);
    const double x = kMargin;
    const double lower = kMargin + kGap / 2 + top.size.y() + kGap;
    const double beside = x + std::max(front.size.x(), top.size.x()) + kGap;
    picture.add(top, {x, kMargin + kGap / 2}, true);
    picture.add(front, {x, lower}, true);
    picture.add(right, {beside, lower}, true);
    constexpr double kAbove = 8.0;
    picture.name(paint.names[2], {x, kMargin + kGap / 2 - kAbove});
    picture.name(paint.names[0], {x, lower - kAbove});
    picture.name(paint.names[1], {beside, lower - kAbove});
    return picture.svg();
}

}  // namespace ew
