// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/cutting_plane.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "core/reading/score/probability.h"
#include "core/solid/boolean.h"
#include "core/solid/exact_tool.h"
#include "core/solid/visibility.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double kStepPx = 3.0;  // between the places at which it is asked what lies under the ink
constexpr std::size_t kMostSteps = 4000;
constexpr std::size_t kFewestPlaces = 8;
constexpr double kHandPx = 2.0;     ///< how far a hand strays from the line that it means
constexpr double kBendPx = 6.0;     ///< farther from the plane than this on the whole, and it bends
constexpr double kExactDeg = 0.05;  ///< nearer to a direction of the solid than this is that

/// A place under the ink.
struct Place {
    int face = -1;
    Vec3 p = Vec3::Zero();  ///< body frame [mm]
};

/// The plane normal . p = offset.
struct Plane {
    Vec3 normal = Vec3::UnitZ();
    double offset = 0.0;
    std::vector<ToolFaceRule> rules = {};  ///< of the tool's first face
    bool square = false;                   ///< to an edge, or parallel to a face
};

std::vector<Vec2> walked(const std::vector<Stroke>& strokes) {
    std::vector<Vec2> out;
    double length = 0.0;
    for (const Stroke& s : strokes) {
        for (std::size_t i = 1; i < s.samples.size(); ++i) {
            length += (s.samples[i].position - s.samples[i - 1].position).norm();
        }
    }
    const double step = std::max(kStepPx, length / static_cast<double>(kMostSteps));
    for (const Stroke& s : strokes) {
        out.push_back(s.samples.front().position);
        for (std::size_t i = 1; i < s.samples.size(); ++i) {
            const Vec2 from = s.samples[i - 1].position;
            const Vec2 to = s.samples[i].position;
            const int count = static_cast<int>((to - from).norm() / step);
            for (int k = 1; k <= count; ++k) out.push_back(from + (to - from) * k / (count + 1));
            if ((to - out.back()).norm() >= 0.5 * step) out.push_back(to);
        }
    }
    return out;
}

class CuttingLine {
  public:
    CuttingLine(const std::vector<Stroke>& strokes, const InterpretOptions& options)
        : strokes_(strokes), options_(options) {}

    Interpretation read() {
        addGraph();
        if (auto ok = findBody(); !ok) return refused(ok.error());
        if (const auto end = endInside()) {
            return refused({Errc::OpenEnd,
                            "A line that cuts a solid runs from one side of it to the other; this "
                            "one ends inside a face.",
                            {*end}});
        }
        const auto drawn = fit();
        if (!drawn) {
            return refused({Errc::CurvedStroke,
                            "The line lies in no plane, and a cut is plane; draw it straight on "
                            "every face.",
                            {strokes_.front().samples.front().position}});
        }
        std::vector<Plane> planes;
        double off = 0.0;
        if (const auto regular = snapped(*drawn, off)) planes.push_back(*regular);
        if (planes.empty() || off > kExactDeg) planes.push_back(*drawn);
        for (Plane& plane : planes) takeCorners(plane);
        std::optional<Error> why;
        for (const Plane& plane : planes) {
            auto c = cut(plane);
            if (!c) {
                why = why.value_or(c.error());
                continue;
            }
            c->score = out_.candidates.empty() ? 1.0 : 0.8;
            out_.candidates.push_back(*std::move(c));
        }
        if (out_.candidates.empty()) return refused(*why);
        out_.accepted = 0;
        tellProbabilities(out_.candidates, out_.graph.edges.size());
        return std::move(out_);
    }

  private:
    Interpretation refused(Error error) {
        out_.problem = std::move(error);
        return std::move(out_);
    }

    /// The strokes as they were drawn, from end to end.
    void addGraph() {
        for (std::size_t i = 0; i < strokes_.size(); ++i) {
            const auto& samples = strokes_[i].samples;
            const int first = static_cast<int>(out_.graph.junctions.size());
            out_.graph.junctions.push_back({samples.front().position});
            out_.graph.junctions.push_back({samples.back().position});
            GraphEdge edge;
            edge.ends = {first, first + 1};
            edge.tips = {samples.front().position, samples.back().position};
            edge.strokes = {static_cast<int>(i)};
            out_.graph.edges.push_back(std::move(edge));
        }
    }

    /// The body that most of the ink runs over, and the places on it.
    Result<void> findBody() {
        std::vector<SolidView> views;
        for (const Body& body : options_.bodies) {
            auto view = SolidView::make(body.solid, body.pose, options_.camera);
            if (!view) return fail(view.error());
            views.push_back(*std::move(view));
        }
        std::map<int, std::vector<Place>> places;
        ink_ = walked(strokes_);
        for (const Vec2& px : ink_) {
            int nearest = -1;
            std::optional<Pick> best;
            for (std::size_t b = 0; b < views.size(); ++b) {
                const auto pick = views[b].pick(px);
                if (!pick || (best && best->depthPx <= pick->depthPx)) continue;
                best = pick;
                nearest = static_cast<int>(b);
            }
            if (best) places[nearest].push_back({best->face, best->body});
        }
        for (auto& [body, list] : places) {
            if (list.size() <= places_.size()) continue;
            places_ = std::move(list);
            body_ = body;
        }
        if (places_.size() < kFewestPlaces) {
            return fail(Errc::NoSurface, "The line runs over no solid.",
                        {strokes_.front().samples.front().position});
        }
        view_ = std::move(views[at(body_)]);
        return {};
    }

    const Solid& solid() const { return options_.bodies[at(body_)].solid; }

    /// An end of the line that lies well inside a face, and at which no other stroke goes on.
    std::optional<Vec2> endInside() const {
        std::vector<Vec2> ends;
        for (const Stroke& s : strokes_) {
            ends.push_back(s.samples.front().position);
            ends.push_back(s.samples.back().position);
        }
        const double reach = options_.thresholds.distancePx;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            bool goesOn = false;
            for (std::size_t k = 0; k < ends.size(); ++k) {
                goesOn = goesOn || (k != i && (ends[k] - ends[i]).norm() <= reach);
            }
            const auto pick = view_->pick(ends[i]);
            if (goesOn || !pick) continue;
            // An edge of the face under it, near enough to be what it was to meet.
            const auto& loops = solid().faces()[at(pick->face)].loops;
            const bool atEdge = std::any_of(loops.begin(), loops.end(), [&](const auto& loop) {
                for (std::size_t k = 0; k < loop.size(); ++k) {
                    const Vec2& a = view_->points()[at(loop[k])];
                    const Vec2& b = view_->points()[at(loop[(k + 1) % loop.size()])];
                    if (distanceToSegment(ends[i], a, b) <= reach) return true;
                }
                return false;
            });
            if (!atEdge) return ends[i];
        }
        return std::nullopt;
    }

    /// The plane through the places; nothing where they bend out of every plane.
    std::optional<Plane> fit() const {
        Vec3 middle = Vec3::Zero();
        for (const Place& q : places_) middle += q.p / static_cast<double>(places_.size());
        Mat3 spread = Mat3::Zero();
        for (const Place& q : places_) {
            spread +=
                (q.p - middle) * (q.p - middle).transpose() / static_cast<double>(places_.size());
        }
        const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
        const auto rms = [&](int k) { return std::sqrt(std::max(0.0, axes.eigenvalues()[k])); };
        const double px = options_.camera.worldPerPixel;
        if (rms(0) > kBendPx * px) return std::nullopt;
        Plane out;
        const bool oneFace = std::all_of(places_.begin(), places_.end(), [&](const Place& q) {
            return q.face == places_.front().face;
        });
        // A line tells no plane.
        if (oneFace || rms(1) < kHandPx * px) {
            if (rms(1) > kBendPx * px) return std::nullopt;
            const Vec3& face = solid().faces()[at(mostCommonFace())].normal;
            out.normal = face.cross(Vec3(axes.eigenvectors().col(2)));
            if (out.normal.norm() < 0.1) return std::nullopt;
            out.normal.normalize();
            out.rules = {{0, ToolFaceRule::Kind::AlongNormal, mostCommonFace()}};
        } else {
            out.normal = axes.eigenvectors().col(0);
        }
        out.offset = out.normal.dot(middle);
        return out;
    }

    int mostCommonFace() const {
        std::map<int, int> count;
        for (const Place& q : places_) ++count[q.face];
        return std::max_element(count.begin(), count.end(),
                                [](const auto& a, const auto& b) { return a.second < b.second; })
            ->first;
    }

    /// The plane square to the edge, or parallel to the face, that it nearly is.
    /// \param off  receives by how much it is not [degrees].
    std::optional<Plane> snapped(const Plane& plane, double& off) const {
        std::optional<Plane> best;
        off = options_.thresholds.angleDeg;
        const auto consider = [&](const Vec3& direction, ToolFaceRule::Kind kind, int index) {
            const double sine = std::min(1.0, plane.normal.cross(direction).norm());
            const double angle = std::asin(sine) * 180.0 / std::numbers::pi;
            constexpr double kSame = 1e-6;  // degrees
            if (angle > off - (best ? kSame : 0.0)) return;
            off = angle;
            best = Plane{direction, 0.0, {{0, kind, index}}, true};
        };
        for (std::size_t f = 0; f < solid().faces().size(); ++f) {
            consider(solid().faces()[f].normal, ToolFaceRule::Kind::ParallelToFace,
                     static_cast<int>(f));
        }
        for (std::size_t e = 0; e < solid().edges().size(); ++e) {
            const auto& ends = solid().edges()[e].ends;
            consider(
                (solid().vertices()[at(ends[1])] - solid().vertices()[at(ends[0])]).normalized(),
                ToolFaceRule::Kind::NormalToEdge, static_cast<int>(e));
        }
        if (!best) return best;
        for (const Place& q : places_) {
            best->offset += best->normal.dot(q.p) / static_cast<double>(places_.size());
        }
        return best;
    }

    /// Lets the plane run through corners of the solid that the line runs over, as far as it is
    /// free.
    void takeCorners(Plane& plane) const {
        struct Corner {
            int vertex;
            double px;  // from the ink
        };
        std::vector<Corner> near;
        const double reach = kBendPx * options_.camera.worldPerPixel;
        for (std::size_t v = 0; v < solid().vertices().size(); ++v) {
            if (std::abs(plane.normal.dot(solid().vertices()[v]) - plane.offset) > reach) continue;
            double off = std::numeric_limits<double>::infinity();
            for (const Vec2& q : ink_) off = std::min(off, (q - view_->points()[v]).norm());
            if (off <= kBendPx) near.push_back({static_cast<int>(v), off});
        }
        std::sort(near.begin(), near.end(),
                  [](const Corner& a, const Corner& b) { return a.px < b.px; });
        const std::size_t free = plane.square ? 1 : plane.rules.empty() ? 3 : 2;
        const auto keep = [&near](std::size_t count) {
            near.erase(near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
        };
        if (near.size() > free) keep(free);
        if (near.empty()) return;
        const auto p = [&](std::size_t k) { return solid().vertices()[at(near[k].vertex)]; };
        if (near.size() == free && free == 2) {
            const Vec3& face = solid().faces()[at(plane.rules.front().index)].normal;
            plane.normal = face.cross(p(1) - p(0)).normalized();
        } else if (near.size() == free && free == 3) {
            const Vec3 normal = (p(1) - p(0)).cross(p(2) - p(0));
            if (normal.norm() < 1e-6 * (p(1) - p(0)).norm() * (p(2) - p(0)).norm()) return;
            plane.normal = normal.normalized();
        } else {
            keep(1);
        }
        plane.offset = plane.normal.dot(p(0));
        for (const Corner& c : near) {
            plane.rules.push_back({0, ToolFaceRule::Kind::ThroughVertex, c.vertex});
        }
    }

    /// A box with one face in the plane that reaches so far from its middle, and so deep.
    PolyhedronSpec slab(const Plane& plane, double reach, double depth) const {
        const auto [low, high] = solid().bounds();
        const Vec3 middle = 0.5 * (low + high);
        const Vec3 center = middle + (plane.offset - plane.normal.dot(middle)) * plane.normal;
        const Vec3 u = plane.normal.unitOrthogonal();
        const Vec3 v = plane.normal.cross(u);
        PolyhedronSpec spec;
        for (const double z : {0.0, -depth}) {
            spec.vertices.push_back(center - reach * u - reach * v + z * plane.normal);
            spec.vertices.push_back(center + reach * u - reach * v + z * plane.normal);
            spec.vertices.push_back(center + reach * u + reach * v + z * plane.normal);
            spec.vertices.push_back(center - reach * u + reach * v + z * plane.normal);
        }
        spec.faces = {{0, 1, 2, 3}, {7, 6, 5, 4}, {1, 0, 4, 5},
                      {2, 1, 5, 6}, {3, 2, 6, 7}, {0, 3, 7, 4}};
        return spec;
    }

    Result<Candidate> cut(const Plane& plane) const {
        const double size = (solid().bounds()[1] - solid().bounds()[0]).norm();
        ToolSpec tool;
        tool.shape = slab(plane, 2.0 * size, 2.0 * size);
        tool.faces = plane.rules;
        const auto half = makeTool(solid(), tool);
        if (!half) return fail(half.error());
        auto one = combine(solid(), *half, BooleanKind::Intersect);
        if (!one) return fail(missed(one.error()));
        auto other = combine(solid(), *half, BooleanKind::Cut);
        if (!other) return fail(missed(other.error()));
        Candidate c;
        c.templateId = "cutting-plane";
        c.templateName = "Cut in two";
        c.aspect = "plane";
        c.readingId = plane.square ? "square" : "default";
        c.readingName = plane.square ? "square" : "";
        c.operation = Operation::Split;
        c.body = body_;
        constexpr double kBeyond = 0.6;   // of the size: the plate that shows where
        constexpr double kThick = 0.001;  // of the size
        c.spec = slab(plane, kBeyond * size, kThick * size);
        c.pose = options_.bodies[at(body_)].pose;
        c.junctionVertex.assign(out_.graph.junctions.size(), -1);
        const bool first = one->solid.volume() >= other->solid.volume();
        c.result = first ? one->solid : other->solid;
        c.rest = first ? other->solid : one->solid;
        return c;
    }

    static Error missed(Error error) {
        if (error.code == Errc::NothingLeft || error.code == Errc::NoChange) {
            error.message = "The plane through this line misses the solid.";
        }
        return error;
    }

    const std::vector<Stroke>& strokes_;
    const InterpretOptions& options_;
    Interpretation out_;
    int body_ = -1;
    std::optional<SolidView> view_;
    std::vector<Place> places_;
    std::vector<Vec2> ink_;  ///< [px]
};

}  // namespace

Interpretation readCuttingPlane(const std::vector<Stroke>& strokes,
                                const InterpretOptions& options) {
    return CuttingLine(strokes, options).read();
}

}  // namespace ew
