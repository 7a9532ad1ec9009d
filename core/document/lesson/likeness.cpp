// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/lesson/likeness.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace ew {
namespace {

/// How many corners, edges and faces.
using Counts = std::array<std::size_t, 3>;

Counts countsOf(const Solid& solid) {
    return {solid.vertices().size(), solid.edges().size(), solid.faces().size()};
}

std::vector<const Body*> visibleBodies(const DocumentState& state) {
    std::vector<const Body*> out;
    for (const Body& body : state.bodies) {
        if (!body.hidden) out.push_back(&body);
    }
    return out;
}

/// Volume and its first moment, in the world.
struct Mass {
    double volume = 0.0;
    Vec3 moment = Vec3::Zero();

    Vec3 center() const { return moment / volume; }
    Mass operator-(const Mass& other) const {
        return {volume - other.volume, moment - other.moment};
    }
};

Mass massOf(const std::vector<const Body*>& bodies) {
    Mass out;
    for (const Body* body : bodies) {
        std::vector<Vec3> points;
        for (const Vec3& v : body->solid.vertices()) points.push_back(body->pose.toWorld(v));
        for (const SolidTriangle& t : body->solid.triangles()) {
            const auto corner = [&](std::size_t k) -> const Vec3& {
                return points[static_cast<std::size_t>(t.vertices[k])];
            };
            const double sixth = corner(0).dot(corner(1).cross(corner(2))) / 6.0;
            out.volume += sixth;
            out.moment += sixth * (corner(0) + corner(1) + corner(2)) / 4.0;
        }
    }
    return out;
}

double sizeOf(const std::vector<const Body*>& bodies) {
    Eigen::AlignedBox3d box;
    for (const Body* body : bodies) {
        for (const Vec3& v : body->solid.vertices()) box.extend(body->pose.toWorld(v));
    }
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

/// How far a solid reaches along its three main directions, the longest first.
Vec3 reaches(const Solid& solid) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& v : solid.vertices()) middle += v;
    middle /= static_cast<double>(solid.vertices().size());
    Mat3 spread = Mat3::Zero();
    for (const Vec3& v : solid.vertices()) spread += (v - middle) * (v - middle).transpose();
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(spread);
    return solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().reverse();
}

bool sameProportions(const Solid& a, const Solid& b, double tolerance) {
    const Vec3 p = reaches(a) / reaches(a).x();
    const Vec3 q = reaches(b) / reaches(b).x();
    const double most = 1.0 + tolerance;
    const auto near = [&](double x, double y) { return x <= most * y && y <= most * x; };
    return near(p.y(), q.y()) && near(p.z(), q.z());
}

/// Turns and mirrorings of the world that bring a body onto itself, as far as a drawn one is
/// regular: those along the axes of its own frame.
class Symmetries {
  public:
    explicit Symmetries(const Body& body) : body_(body) {
        Eigen::AlignedBox3d box;
        for (const Vec3& v : body.solid.vertices()) box.extend(v);
        middle_ = box.center();
        room_ = kRegular * box.diagonal().norm();
        std::array<int, 3> axis{0, 1, 2};
        do {
            for (int signs = 0; signs < 8; ++signs) {
                Mat3 m = Mat3::Zero();
                for (int k = 0; k < 3; ++k) {
                    m(k, axis[static_cast<std::size_t>(k)]) = (signs >> k & 1) != 0 ? -1.0 : 1.0;
                }
                if (keepsCorners(m)) maps_.push_back(m);
            }
        } while (std::next_permutation(axis.begin(), axis.end()));
    }
    /// The nearest that one of them brings a world point to another.
    double distance(const Vec3& from, const Vec3& to) const {
        double least = (from - to).norm();
        for (const Mat3& m : maps_) {
            const Vec3 local = m * (body_.pose.toBody(from) - middle_) + middle_;
            least = std::min(least, (body_.pose.toWorld(local) - to).norm());
        }
        return least;
    }

  private:
    static constexpr double kRegular = 0.08;  ///< share of the size that a corner may be off

    bool keepsCorners(const Mat3& m) const {
        const auto& corners = body_.solid.vertices();
        return std::all_of(corners.begin(), corners.end(), [&](const Vec3& v) {
            const Vec3 image = m * (v - middle_) + middle_;
            return std::any_of(corners.begin(), corners.end(),
                               [&](const Vec3& w) { return (w - image).norm() <= room_; });
        });
    }

    const Body& body_;
    Vec3 middle_ = Vec3::Zero();
    double room_ = 0.0;
    std::vector<Mat3> maps_;
};

bool sameSolids(const DocumentState& a, const DocumentState& b) {
    return std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(),
                      [](const Body& x, const Body& y) {
                          return x.solid.sharesDataWith(y.solid) && x.hidden == y.hidden &&
                                 x.pose.translation == y.pose.translation &&
                                 x.pose.rotation == y.pose.rotation;
                      });
}

std::vector<Counts> sortedCounts(const std::vector<const Body*>& bodies) {
    std::vector<Counts> out;
    for (const Body* body : bodies) out.push_back(countsOf(body->solid));
    std::sort(out.begin(), out.end());
    return out;
}

/// Of a step that makes solids where there were none, or more of them.
Unlike likenessOfNew(const std::vector<const Body*>& wanted, const std::vector<const Body*>& made,
                     double tolerance) {
    if (sortedCounts(wanted) != sortedCounts(made)) return Unlike::Shape;
    std::vector<const Body*> left = made;
    for (const Body* body : wanted) {
        const auto same = std::find_if(left.begin(), left.end(), [&](const Body* other) {
            return countsOf(other->solid) == countsOf(body->solid) &&
                   sameProportions(body->solid, other->solid, tolerance);
        });
        if (same == left.end()) return Unlike::Proportions;
        left.erase(same);
    }
    return Unlike::Nothing;
}

/// Of a step that changes the solids there are.
Unlike likenessOfChange(const std::vector<const Body*>& before,
                        const std::vector<const Body*>& wanted,
                        const std::vector<const Body*>& made, double tolerance) {
    constexpr double kNoChange = 1e-9;    // share of the volume
    constexpr double kPlaceShare = 0.25;  // of the tolerance, as a share of the size
    const Mass start = massOf(before);
    const Mass wish = massOf(wanted) - start;
    const Mass change = massOf(made) - start;
    const double room = kPlaceShare * tolerance * sizeOf(before);
    const double least = kNoChange * std::abs(start.volume);
    if (std::abs(wish.volume) <= least || std::abs(change.volume) <= least) {
        // Moved, or turned.
        if (sortedCounts(wanted) != sortedCounts(made)) return Unlike::Shape;
        const double off = (massOf(wanted).center() - massOf(made).center()).norm();
        return off <= room ? Unlike::Nothing : Unlike::Place;
    }
    if ((wish.volume > 0.0) != (change.volume > 0.0)) return Unlike::Side;
    if (sortedCounts(wanted) != sortedCounts(made)) return Unlike::Shape;
    double off = (change.center() - wish.center()).norm();
    if (before.size() == 1) {
        off = Symmetries(*before.front()).distance(change.center(), wish.center());
    }
    if (off > room) return Unlike::Place;
    // A volume is off as the product of three lengths is.
    const double most = std::pow(1.0 + tolerance, 3.0);
    const double ratio = change.volume / wish.volume;
    return ratio <= most && ratio >= 1.0 / most ? Unlike::Nothing : Unlike::Proportions;
}

/// How many edges are rounded, and by what on the average [mm].
std::pair<int, double> fillets(const SurfaceSettings& settings) {
    int count = 0;
    double sum = 0.0;
    for (const EdgeSettings& body : settings.edges) {
        for (const double radius : body.radii) {
            if (radius <= 0.0) continue;
            ++count;
            sum += radius;
        }
    }
    return {count, count > 0 ? sum / count : 0.0};
}

bool isSmooth(const SubdivisionSettings& s) { return s.on; }

Unlike likenessOfSettings(const DocumentState& before, const DocumentState& wanted,
                          const DocumentState& made, double tolerance) {
    const auto same = [&](const DocumentState& a, const DocumentState& b) {
        const auto [edges, radius] = fillets(a.surface);
        const auto [otherEdges, otherRadius] = fillets(b.surface);
        const double most = 1.0 + 2.0 * tolerance;
        const bool rounds = edges == otherEdges && radius <= most * otherRadius + 1e-12 &&
                            otherRadius <= most * radius + 1e-12;
        const bool smooth = isSmooth(a.surface.subdivision) == isSmooth(b.surface.subdivision) &&
                            (!isSmooth(a.surface.subdivision) ||
                             a.surface.subdivision.scheme == b.surface.subdivision.scheme);
        return rounds && smooth && a.addedTemplates.size() == b.addedTemplates.size() &&
               a.mapped.empty() == b.mapped.empty() && a.mirror.has_value() == b.mirror.has_value();
    };
    if (same(wanted, made)) return Unlike::Nothing;
    return same(before, made) ? Unlike::NotYet : Unlike::Settings;
}

struct Told {
    Unlike unlike;
    const char* name;
    const char* sentence;
};
constexpr Told kTold[] = {
    {Unlike::Nothing, "", ""},
    {Unlike::NotYet, "not-yet", "Nothing was made or changed yet."},
    {Unlike::Bodies, "separate-drawings",
     "More solids were made than are wanted; draw one at a time."},
    {Unlike::Side, "wrong-side",
     "It was done to the wrong side: what was to be added was cut, or the other way round."},
    {Unlike::Shape, "wrong-shape", "It became another kind of shape."},
    {Unlike::Place, "wrong-place", "The shape is right, but it is in the wrong place."},
    {Unlike::Proportions, "wrong-proportions",
     "The shape is right, but its proportions are far from the wanted ones."},
    {Unlike::Settings, "wrong-settings",
     "It was done with other edges, another size or another kind of surface."}};

const Told& told(Unlike unlike) {
    const auto* found = std::find_if(std::begin(kTold), std::end(kTold),
                                     [&](const Told& t) { return t.unlike == unlike; });
    return found == std::end(kTold) ? kTold[0] : *found;
}

}  // namespace

std::string unlikeName(Unlike unlike) { return told(unlike).name; }

std::string unlikeSentence(Unlike unlike) { return told(unlike).sentence; }

double proportionsOff(const DocumentState& wanted, const DocumentState& made) {
    const auto wish = visibleBodies(wanted);
    const auto is = visibleBodies(made);
    if (wish.size() != 1 || is.size() != 1) return 1.0;
    const Vec3 p = reaches(wish.front()->solid) / reaches(wish.front()->solid).x();
    const Vec3 q = reaches(is.front()->solid) / reaches(is.front()->solid).x();
    const auto off = [](double x, double y) { return std::max(x, y) / std::min(x, y) - 1.0; };
    return std::max(off(p.y(), q.y()), off(p.z(), q.z()));
}

Unlike likeness(const DocumentState& before, const DocumentState& wanted, const DocumentState& made,
                double tolerance) {
    if (sameSolids(before, wanted)) {
        if (!sameSolids(before, made)) return Unlike::Shape;
        return likenessOfSettings(before, wanted, made, tolerance);
    }
    if (sameSolids(before, made)) return Unlike::NotYet;
    const auto was = visibleBodies(before);
    const auto wish = visibleBodies(wanted);
    const auto are = visibleBodies(made);
    if (are.size() > wish.size()) return Unlike::Bodies;
    if (are.size() < wish.size()) return Unlike::Shape;
    if (was.empty() || wish.size() > was.size()) return likenessOfNew(wish, are, tolerance);
    return likenessOfChange(was, wish, are, tolerance);
}

}  // namespace ew
