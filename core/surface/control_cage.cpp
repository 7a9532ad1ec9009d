// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/control_cage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "core/base/tolerance.h"
#include "core/surface/face_split.h"
#include "core/surface/planar_triangulation.h"
#include "core/surface/side_key.h"

namespace ew {
namespace {

using Kind = CageOrigin::Kind;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Result<void> checkOptions(const FilletedCage& cage, const ControlOptions& options) {
    if (!(options.supportRatio >= 0.0 && options.supportRatio <= 1.0)) {
        return fail(Errc::BadValue, "The width of the support loop must be from 0 to 1.");
    }
    if (!options.edgeSharpness.empty() && options.edgeSharpness.size() != cage.setbacks.size()) {
        return fail(Errc::BadValue, "There must be one sharpness for each edge of the solid.");
    }
    for (std::size_t e = 0; e < options.edgeSharpness.size(); ++e) {
        const double s = options.edgeSharpness[e];
        if (!std::isnan(s) && s >= 0.0) continue;
        return fail(Errc::BadValue,
                    "The sharpness of edge " + std::to_string(e) + " must be 0 or more.");
    }
    return {};
}

class Preparation {
  public:
    Preparation(const FilletedCage& cage, const ControlOptions& options)
        : cage_(cage),
          options_(options),
          width_(at(cage.mesh.faceCount()), 0.0),
          stripless_(width_.size(), false) {
        out_.mesh.points = cage.mesh.points;
    }

    Result<ControlCage> run() {
        if (options_.supportRatio > 0.0) {
            findWidths();
            splitStrips();
            splitSharpEdges();
        }
        for (int f = 0; f < cage_.mesh.faceCount(); ++f) {
            if (auto ok = addFace(f); !ok) return fail(ok.error());
        }
        addSharpness();
        return std::move(out_);
    }

  private:
    using Loops = std::vector<std::vector<int>>;

    bool isPlanar(int face) const { return cage_.origins[at(face)].kind == Kind::Face; }
    bool isStrip(int face) const { return cage_.origins[at(face)].kind == Kind::Strip; }
    double setbackOf(int face) const { return cage_.setbacks[at(cage_.origins[at(face)].index)]; }
    double length(int a, int b) const { return (cage_.mesh.point(a) - cage_.mesh.point(b)).norm(); }

    /// The narrowest strip beside every planar face decides about its support loops.
    void findWidths() {
        std::unordered_map<std::uint64_t, double> strips;
        for (int f = 0; f < cage_.mesh.faceCount(); ++f) {
            if (!isStrip(f)) continue;
            const auto loop = cage_.mesh.outline(f);
            for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
                strips[sideKey(loop[(k + 1) % 4], loop[k])] = setbackOf(f);
            }
        }
        for (int f = 0; f < cage_.mesh.faceCount(); ++f) {
            if (!isPlanar(f)) continue;
            double& width = width_[at(f)];
            for (int l = 0; l < cage_.mesh.loopCount(f); ++l) {
                const auto loop = cage_.mesh.loop(f, l);
                for (std::size_t k = 0; k < loop.size(); ++k) {
                    const auto strip = strips.find(sideKey(loop[k], loop[(k + 1) % loop.size()]));
                    if (strip == strips.end()) continue;
                    width = width > 0.0 ? std::min(width, strip->second) : strip->second;
                }
            }
            if (width > 0.0 || !bendsInwards(f)) continue;
            width = kSharpWidth * shortestSide(f);
            stripless_[at(f)] = true;
        }
    }

    /// A flat face between sharp edges that is not convex: without support the points inside it
    /// would be drawn over its corners that bend inwards.
    bool bendsInwards(int face) {
        if (sharp_.empty()) {
            for (const auto* list : {&cage_.sharpEdges, &cage_.sharpEnds}) {
                for (const CageSharpEdge& e : *list) {
                    if (sharpness(e) >= kInfiniteSharpness) sharp_.insert(undirected(e));
                }
            }
        }
        for (int l = 0; l < cage_.mesh.loopCount(face); ++l) {
            const auto loop = cage_.mesh.loop(face, l);
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const int a = loop[k];
                const int b = loop[(k + 1) % loop.size()];
                if (!sharp_.contains(sideKey(std::min(a, b), std::max(a, b)))) return false;
            }
        }
        return cage_.mesh.loopCount(face) > 1 ||
               !isConvex(cage_.mesh.points, cage_.mesh.outline(face));
    }

    double shortestSide(int face) const {
        double least = std::numeric_limits<double>::infinity();
        for (int l = 0; l < cage_.mesh.loopCount(face); ++l) {
            const auto loop = cage_.mesh.loop(face, l);
            for (std::size_t k = 0; k < loop.size(); ++k) {
                least = std::min(least, length(loop[k], loop[(k + 1) % loop.size()]));
            }
        }
        return least;
    }

    /// Puts a point near each end of an edge, at this share of its length.
    void split(int a, int b, double share) {
        if (!splits_.try_emplace(sideKey(std::min(a, b), std::max(a, b))).second) return;
        const Vec3 p = cage_.mesh.point(std::min(a, b));
        const Vec3 q = cage_.mesh.point(std::max(a, b));
        auto& ids = splits_[sideKey(std::min(a, b), std::max(a, b))];
        ids[0] = out_.mesh.addPoint(p + share * (q - p));
        ids[1] = out_.mesh.addPoint(q - share * (q - p));
    }

    /// The points inside an edge from a to b, none where it is not split.
    std::vector<int> inside(int a, int b) const {
        const auto it = splits_.find(sideKey(std::min(a, b), std::max(a, b)));
        if (it == splits_.end()) return {};
        return a < b ? std::vector<int>{it->second[0], it->second[1]}
                     : std::vector<int>{it->second[1], it->second[0]};
    }

    double endShare(double supportWidth, double edgeLength) const {
        return std::min(kEndRows * supportWidth / edgeLength, kMostOfEdge);
    }

    /// Rows near both ends of every strip hold the corners of the flat faces in place.
    void splitStrips() {
        std::unordered_map<int, double> shortest;
        for (int f = 0; f < cage_.mesh.faceCount(); ++f) {
            if (!isStrip(f)) continue;
            const auto q = cage_.mesh.outline(f);
            const double least = std::min(length(q[0], q[1]), length(q[2], q[3]));
            const auto [it, isNew] = shortest.try_emplace(cage_.origins[at(f)].index, least);
            if (!isNew) it->second = std::min(it->second, least);
        }
        for (int f = 0; f < cage_.mesh.faceCount(); ++f) {
            if (!isStrip(f)) continue;
            const double share = endShare(options_.supportRatio * setbackOf(f),
                                          shortest.at(cage_.origins[at(f)].index));
            const auto q = cage_.mesh.outline(f);
            split(q[0], q[1], share);
            split(q[2], q[3], share);
        }
    }

    void splitSharpEdges() {
        std::unordered_map<std::uint64_t, double> widths;
        for (int f = 0; f < cage_.mesh.faceCount(); ++f) {
            if (width_[at(f)] <= 0.0) continue;
            const double rows = stripless_[at(f)] ? kSharpRows / kEndRows : 1.0;
            for (int l = 0; l < cage_.mesh.loopCount(f); ++l) {
                const auto loop = cage_.mesh.loop(f, l);
                for (std::size_t k = 0; k < loop.size(); ++k) {
                    widths[sideKey(loop[k], loop[(k + 1) % loop.size()])] = rows * width_[at(f)];
                }
            }
        }
        for (const CageSharpEdge& e : cage_.sharpEdges) {
            double width = 0.0;
            for (const auto& side : {sideKey(e.from, e.to), sideKey(e.to, e.from)}) {
                const auto it = widths.find(side);
                if (it != widths.end()) width = std::max(width, it->second);
            }
            if (width <= 0.0) continue;
            split(e.from, e.to, endShare(options_.supportRatio * width, length(e.from, e.to)));
        }
    }

    Result<void> addFace(int face) {
        if (isStrip(face) && options_.supportRatio > 0.0) {
            addStrip(face);
            return {};
        }
        Loops loops;
        for (int l = 0; l < cage_.mesh.loopCount(face); ++l) {
            const auto loop = cage_.mesh.loop(face, l);
            loops.emplace_back();
            for (std::size_t k = 0; k < loop.size(); ++k) {
                loops.back().push_back(loop[k]);
                const auto more = inside(loop[k], loop[(k + 1) % loop.size()]);
                loops.back().insert(loops.back().end(), more.begin(), more.end());
            }
        }
        if (width_[at(face)] > 0.0) {
            const auto rings = supportLoops(loops, width_[at(face)] * options_.supportRatio);
            for (const Loops& ring : rings) {
                addRing(face, loops, ring);
                if (stripless_[at(face)]) holdCorners(loops, ring);
                loops = ring;
            }
        }
        return addPieces(face, loops);
    }

    /// Divides a flat face at its corners that bend inwards: the rules for corners hold for sectors
    /// of less than half a turn, a wider one would fold over.
    void holdCorners(const Loops& outer, const Loops& inner) {
        const Vec3 normal = loopAreaVector(out_.mesh.points, outer[0]);
        for (std::size_t l = 0; l < outer.size(); ++l) {
            const std::size_t n = outer[l].size();
            for (std::size_t k = 0; k < n; ++k) {
                const Vec3 p = out_.mesh.point(outer[l][k]);
                const Vec3 in = (p - out_.mesh.point(outer[l][(k + n - 1) % n])).normalized();
                const Vec3 next = (out_.mesh.point(outer[l][(k + 1) % n]) - p).normalized();
                if (in.cross(next).dot(normal) >= 0.0 || in.dot(next) > kGentleBend) continue;
                out_.creases.push_back({outer[l][k], inner[l][k], kInfiniteSharpness});
            }
        }
    }

    void addRing(int face, const Loops& outer, const Loops& inner) {
        for (std::size_t l = 0; l < outer.size(); ++l) {
            for (std::size_t k = 0; k < outer[l].size(); ++k) {
                const std::size_t n = (k + 1) % outer[l].size();
                addPolygon(face, {outer[l][k], outer[l][n], inner[l][n], inner[l][k]});
            }
        }
    }

    void addStrip(int face) {
        const auto q = cage_.mesh.outline(face);
        const auto right = inside(q[0], q[1]);
        const auto left = inside(q[3], q[2]);
        addPolygon(face, {q[0], right[0], left[0], q[3]});
        addPolygon(face, {right[0], right[1], left[1], left[0]});
        addPolygon(face, {right[1], q[1], q[2], left[1]});
    }

    void addPolygon(int face, const std::vector<int>& polygon) {
        if (options_.scheme == SubdivisionScheme::CatmullClark || polygon.size() == 3) {
            out_.mesh.addFace(polygon);
            out_.origin.push_back(face);
            return;
        }
        PolyMesh one;
        for (const int i : polygon) one.addPoint(out_.mesh.point(i));
        std::vector<int> all(polygon.size());
        for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<int>(k);
        one.addFace(all);
        const auto triangles = triangulate(one);
        if (!triangles) return addFan(face, polygon);
        for (const auto& t : triangles->triangles) {
            out_.mesh.addFace({polygon[at(t[0])], polygon[at(t[1])], polygon[at(t[2])]});
            out_.origin.push_back(face);
        }
    }

    void addFan(int face, const std::vector<int>& polygon) {
        for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
            out_.mesh.addFace({polygon[0], polygon[k], polygon[k + 1]});
            out_.origin.push_back(face);
        }
    }

    Result<void> addPieces(int face, const Loops& loops) {
        const bool whole =
            loops.size() == 1 && (!isPlanar(face) || isConvex(out_.mesh.points, loops[0]));
        if (whole) {
            addPolygon(face, loops[0]);
            return {};
        }
        const std::vector<std::span<const int>> spans(loops.begin(), loops.end());
        const auto pieces = splitFace(out_.mesh.points, spans);
        if (pieces.empty()) {
            return fail(Errc::SelfIntersecting,
                        "The outline of face " + std::to_string(face) + " crosses itself.");
        }
        for (const auto& piece : pieces) addPolygon(face, piece);
        return {};
    }

    /// Two loops inside a face, one and two widths from its border: the outer one keeps its place
    /// because both its neighbours are one width away, so the surface is flat inside it. None where
    /// they do not fit, narrower ones where these do.
    std::vector<Loops> supportLoops(const Loops& loops, double width) {
        const Vec3 normal = loopAreaVector(out_.mesh.points, loops[0]).normalized();
        for (int attempt = 0; attempt < kAttempts; ++attempt, width *= 0.5) {
            const std::size_t before = out_.mesh.points.size();
            std::vector<Loops> rings(2);
            bool good = true;
            for (const auto& loop : loops) {
                for (std::size_t r = 0; r < 2; ++r) {
                    rings[r].push_back(inset(loop, normal, width * static_cast<double>(r + 1)));
                    good = good && keepsDirections(loop, rings[r].back());
                }
            }
            if (good) {
                const std::vector<std::span<const int>> spans(rings[1].begin(), rings[1].end());
                good = triangulatePlanar(out_.mesh.points, spans, normal).has_value();
            }
            if (good) return rings;
            out_.mesh.points.resize(before);
        }
        return {};
    }

    std::vector<int> inset(const std::vector<int>& loop, const Vec3& normal, double offset) {
        const std::size_t n = loop.size();
        std::vector<int> out;
        for (std::size_t k = 0; k < n; ++k) {
            const Vec3 p = out_.mesh.point(loop[k]);
            const Vec3 in = (p - out_.mesh.point(loop[(k + n - 1) % n])).normalized();
            const Vec3 next = (out_.mesh.point(loop[(k + 1) % n]) - p).normalized();
            const Vec3 a = normal.cross(in);
            const Vec3 b = normal.cross(next);
            // Both sides are met at one distance; 1 + a.b is 0 for a spike only.
            const double share = std::max(1.0 + a.dot(b), tol::kSharpestInset);
            out.push_back(out_.mesh.addPoint(p + offset / share * (a + b)));
        }
        return out;
    }

    bool keepsDirections(const std::vector<int>& loop, const std::vector<int>& inner) const {
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const std::size_t n = (k + 1) % loop.size();
            const Vec3 before = out_.mesh.point(loop[n]) - out_.mesh.point(loop[k]);
            const Vec3 after = out_.mesh.point(inner[n]) - out_.mesh.point(inner[k]);
            // A side that nearly vanishes would make slivers.
            if (before.dot(after) < 0.1 * before.squaredNorm()) return false;
        }
        return true;
    }

    static std::uint64_t undirected(const CageSharpEdge& e) {
        return sideKey(std::min(e.from, e.to), std::max(e.from, e.to));
    }

    double sharpness(const CageSharpEdge& e) const {
        return options_.edgeSharpness.empty()
                   ? kInfiniteSharpness
                   : std::min(options_.edgeSharpness[at(e.edge)], kInfiniteSharpness);
    }

    void addCrease(const CageSharpEdge& e) {
        const double s = sharpness(e);
        if (s <= 0.0) return;
        int from = e.from;
        for (const int middle : inside(e.from, e.to)) {
            out_.creases.push_back({from, middle, s});
            from = middle;
        }
        out_.creases.push_back({from, e.to, s});
    }

    void addSharpness() {
        for (const CageSharpEdge& e : cage_.sharpEdges) addCrease(e);
        // Two strips that end at one place name what they have in common twice.
        std::unordered_set<std::uint64_t> done;
        for (const CageSharpEdge& e : cage_.sharpEdges) done.insert(undirected(e));
        for (const CageSharpEdge& e : cage_.sharpEnds) {
            if (done.insert(undirected(e)).second) addCrease(e);
        }
        if (!options_.sharpCorners) return;
        for (const int point : cage_.vertexPoints) {
            if (point >= 0) out_.corners.push_back({point, kInfiniteSharpness});
        }
    }

    static constexpr double kEndRows = 4.0;      ///< rows' distance from the ends, in widths
    static constexpr double kMostOfEdge = 0.3;   ///< ... and in lengths of the edge
    static constexpr double kSharpRows = 1.0;    ///< rows' distance in faces without strips, near
                                                 ///< enough to hold corners that bend inwards
    static constexpr double kGentleBend = 0.9;   ///< cosine: on a curve, not at a corner
    static constexpr double kSharpWidth = 0.25;  ///< taken for a setback, in lengths of the
                                                 ///< shortest side of a face without strips
    static constexpr int kAttempts = 8;

    const FilletedCage& cage_;
    const ControlOptions& options_;
    ControlCage out_;
    std::vector<double> width_;                ///< by face [mm], 0 where it needs no support
    std::vector<bool> stripless_;              ///< by face: supported although it has no strips
    std::unordered_set<std::uint64_t> sharp_;  ///< edges of the mesh that are so for ever
    std::unordered_map<std::uint64_t, std::array<int, 2>> splits_;
};

}  // namespace

Result<ControlCage> controlCage(const FilletedCage& cage, const ControlOptions& options) {
    if (auto ok = checkOptions(cage, options); !ok) return fail(ok.error());
    return Preparation(cage, options).run();
}

}  // namespace ew
