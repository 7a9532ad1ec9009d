// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/subdivision.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "core/base/tolerance.h"
#include "core/surface/cage_edges.h"
#include "core/surface/chord_flips.h"
#include "core/surface/congruent_faces.h"
#include "core/surface/flat_parts.h"
#include "core/surface/side_key.h"
#include "core/surface/sliver_collapse.h"
#include "core/surface/surface_diagonal.h"
#include "core/surface/surface_evaluator.h"
#include "core/surface/surface_pattern.h"
#include "core/surface/surface_rates.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Result<void> checkInput(const ControlCage& cage, const SubdivisionOptions& options) {
    if (!std::isfinite(options.tolerance) || options.tolerance < 0.0) {
        return fail(Errc::BadValue, "The tolerance must be a positive number.");
    }
    if (options.levels < 0 || options.levels > kMaxSubdivisionLevels) {
        return fail(Errc::BadValue, "There are 0 to " + std::to_string(kMaxSubdivisionLevels) +
                                        " levels of subdivision, not " +
                                        std::to_string(options.levels) + ".");
    }
    if (cage.mesh.faceCount() == 0) return fail(Errc::NoSolid, "There is nothing to subdivide.");
    for (const Vec3& p : cage.mesh.points) {
        if (!p.allFinite()) return fail(Errc::BadValue, "A corner of the cage is not a number.");
    }
    for (int f = 0; f < cage.mesh.faceCount(); ++f) {
        if (cage.mesh.loopCount(f) != 1 || cage.mesh.outline(f).size() < 3) {
            return fail(Errc::BadValue,
                        "Face " + std::to_string(f) + " of the cage is no plain polygon.");
        }
        if (options.scheme == SubdivisionScheme::Loop && cage.mesh.outline(f).size() != 3) {
            return fail(Errc::BadValue, "Loop subdivision needs triangles, face " +
                                            std::to_string(f) + " is none.");
        }
    }
    return checkClosed(cage.mesh);
}

class Tessellator {
  public:
    Tessellator(const ControlCage& cage, const SubdivisionOptions& options, LimitSurface surface)
        : cage_(cage),
          options_(options),
          edges_(cage),
          evaluator_(cage, edges_, options.scheme, std::move(surface)) {}

    Result<SurfaceMesh> run() {
        if (auto ok = chooseRates(); !ok) return fail(ok.error());
        if (auto ok = reserve(); !ok) return fail(ok.error());
        Eigen::AlignedBox3d box;
        for (const Vec3& p : cage_.mesh.points) box.extend(p);
        room_ = tol::kSamePlaneRelative * box.diagonal().norm();
        leastHeight_ =
            leastHeight(std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()));
        vertexPositions_.assign(cage_.mesh.points.size(), -1);
        vertexNormals_.assign(cage_.mesh.points.size(), -1);
        edgePositions_.assign(at(edges_.count()), -1);
        edgeNormals_.assign(at(edges_.count()), -1);
        for (int f = 0; f < cage_.mesh.faceCount(); ++f) {
            addFace(f);
            if (lost_) return noSurface(f);
        }
        mendNormals();
        unfoldFlatParts(cage_, out_);
        flipBadTriangles(out_);
        collapseSlivers(out_);
        return std::move(out_);
    }

  private:
    /// A point of a pattern in the result.
    struct Slot {
        int position;
        int normal;
    };

    /// What a face is cut up by, and the weights that it shares with others of its class.
    struct Cut {
        SurfacePattern* pattern = nullptr;
        PointWeights* weights = nullptr;
    };

    bool adaptive() const { return options_.tolerance > 0.0; }

    static Unexpected<Error> noSurface(int face) {
        return fail(Errc::Internal,
                    "Face " + std::to_string(face) + " of the cage has no surface.");
    }

    Result<void> chooseRates() {
        edgeRates_.assign(at(edges_.count()), 1);
        if (!adaptive()) {
            edgeRates_.assign(at(edges_.count()), 1 << options_.levels);
            return {};
        }
        // Where one face needs more than this a side, the memory limit is exceeded anyway.
        constexpr double kMost = 30000.0;
        const auto whole = [&](double r) {
            return static_cast<int>(std::ceil(std::clamp(r, 1.0, kMost)));
        };
        const int faces = cage_.mesh.faceCount();
        innerRates_.resize(at(faces));
        std::vector<std::array<int, 2>> stitched(at(faces));
        constexpr double kSame = 1e-3;  // of the tolerance: no measure of the surface
        CongruentFaces shapes(cage_, evaluator_.classes(), kSame * options_.tolerance);
        std::unordered_map<int, FaceRates> measured;
        for (int f = 0; f < faces; ++f) {
            innerRates_[at(f)] = stitched[at(f)] = {1, 1};
            if (isPlain(f)) continue;
            const int first = shapes.first(f);
            FaceRates& rates = measured[first];
            if (first == f) {
                if (!sample(f)) return noSurface(f);
                rates = facePieces(evaluator_.parameterization(f), samples_, options_.tolerance);
            }
            innerRates_[at(f)] = {whole(rates.inner[0]), whole(rates.inner[1])};
            stitched[at(f)] = {whole(rates.stitched[0]), whole(rates.stitched[1])};
            const auto sides = edges_.of(f);
            for (std::size_t k = 0; k < sides.size(); ++k) {
                int& rate = edgeRates_[at(sides[k])];
                rate = std::max(rate, whole(rates.edges[k]));
            }
        }
        for (int f = 0; f < faces; ++f) {
            if (isStitched(f)) innerRates_[at(f)] = stitched[at(f)];
        }
        return {};
    }

    /// So flat that there is nothing to measure, and without a crease, whose curve would count.
    bool isPlain(int f) const {
        const auto sides = edges_.of(f);
        const auto hard = [&](int side) { return edges_.sharpness(side) > 0.0F; };
        constexpr double kNone = 0.02;
        return std::none_of(sides.begin(), sides.end(), hard) &&
               evaluator_.inPlane(f, kNone * options_.tolerance);
    }

    bool sample(int f) {
        const auto measured = evaluator_.measure(f);
        samples_.points = measured.points;
        samples_.regular = measured.regular;
        samples_.hard.clear();
        for (const int side : edges_.of(f)) samples_.hard.push_back(edges_.sharpness(side) > 0.0F);
        const int regular = options_.scheme == SubdivisionScheme::Loop ? 6 : 4;
        samples_.peaks.clear();
        for (const int point : cage_.mesh.outline(f)) {
            samples_.peaks.push_back(edges_.valence(point) > regular);
        }
        return !samples_.points.empty();
    }

    /// An edge of a quadrangle is not cut as its inside is.
    bool isStitched(int f) const {
        const auto sides = edges_.of(f);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            if (edgeRates_[at(sides[k])] != innerRates_[at(f)][k % 2]) return true;
        }
        return false;
    }

    /// Upper bounds of what face f adds.
    std::array<double, 2> sizes(int f) const {
        const auto sides = edges_.of(f);
        if (!adaptive()) {
            const double cells = std::pow(4.0, options_.levels);
            const auto n = static_cast<double>(sides.size());
            if (options_.scheme == SubdivisionScheme::Loop) return {0.5 * cells + 1.0, cells};
            if (sides.size() == 4) return {cells + 1.0, 2.0 * cells};
            return options_.levels == 0 ? std::array<double, 2>{n, n}
                                        : std::array<double, 2>{n * cells / 4 + 1, n * cells / 2};
        }
        double across = innerRates_[at(f)][0];
        double along = innerRates_[at(f)][1];
        for (std::size_t k = 0; k < sides.size(); ++k) {
            double& side = k % 2 == 0 ? across : along;
            side = std::max(side, static_cast<double>(edgeRates_[at(sides[k])]));
        }
        if (sides.size() == 4) return {across * along + across + along, 2.0 * across * along};
        const double rate = std::max(across, along);
        const double corners = sides.size() == 3 ? 1.0 : static_cast<double>(sides.size()) / 2.0;
        return {corners * rate * rate + 3.0 * rate, 2.0 * corners * rate * rate + 3.0 * rate};
    }

    Result<void> checkMemory(double positions, double triangles) const {
        const double perPosition = static_cast<double>(surfaceBytes(1, 0, edges_.anyHard()));
        const double perTriangle = static_cast<double>(surfaceBytes(0, 1, edges_.anyHard()));
        const double bytes = positions * perPosition + triangles * perTriangle;
        constexpr double kMiB = 1024.0 * 1024.0;
        constexpr double kMostTriangles = 5e8;  // indices are ints
        if (bytes <= static_cast<double>(options_.memoryLimit) && triangles <= kMostTriangles) {
            return {};
        }
        const auto mib = [](double b) {
            return std::to_string(static_cast<long long>(std::ceil(b / kMiB)));
        };
        return fail(Errc::TooMuchMemory, "The surface would need about " + mib(bytes) +
                                             " MiB, more than the limit of " +
                                             mib(static_cast<double>(options_.memoryLimit)) +
                                             " MiB. Choose fewer levels or a coarser tolerance.");
    }

    /// First bounds the size from above, so that no pattern gets out of hand, then counts it.
    Result<void> reserve() {
        double positions = static_cast<double>(cage_.mesh.points.size());
        double triangles = 0.0;
        for (int f = 0; f < cage_.mesh.faceCount(); ++f) {
            const auto size = sizes(f);
            positions += size[0];
            triangles += size[1];
        }
        // Stitched faces have about half of the bound.
        constexpr double kSlack = 0.25;
        if (auto ok = checkMemory(kSlack * positions, kSlack * triangles); !ok) return ok;
        std::size_t pointCount = cage_.mesh.points.size();
        std::size_t triangleCount = 0;
        for (const int rate : edgeRates_) pointCount += at(rate - 1);
        for (int f = 0; f < cage_.mesh.faceCount(); ++f) {
            const SurfacePattern& p = *chooseCut(f).pattern;
            std::size_t border = 0;
            for (const int side : edges_.of(f)) border += at(edgeRates_[at(side)]);
            pointCount += p.coords.size() - border;
            for (const auto& facet : p.facets) triangleCount += facet[3] < 0 ? 1 : 2;
        }
        if (auto ok =
                checkMemory(static_cast<double>(pointCount), static_cast<double>(triangleCount));
            !ok) {
            return ok;
        }
        out_.positions.reserve(pointCount);
        out_.normals.reserve(pointCount);
        out_.triangles.reserve(triangleCount);
        out_.origin.reserve(triangleCount);
        if (edges_.anyHard()) out_.normalTriangles.reserve(triangleCount);
        return {};
    }

    /// Finds or makes what a face is cut up by, and counts it.
    const Cut& chooseCut(int face) {
        const auto sides = edges_.of(face);
        key_.clear();
        if (adaptive()) {
            for (const int side : sides) key_.push_back(edgeRates_[at(side)]);
            key_.push_back(innerRates_[at(face)][0]);
            if (sides.size() == 4) key_.push_back(innerRates_[at(face)][1]);
        }
        // A quadrangle has as many rates as a pentagon.
        key_.push_back(static_cast<int>(sides.size()));
        const auto [it, isNew] = patterns_.try_emplace(key_);
        if (isNew) {
            const auto parameters = evaluator_.parameterization(face);
            const std::vector<int> rates(key_.begin(), key_.end() - 1);
            it->second = adaptive() ? adaptivePattern(parameters, rates)
                                    : uniformPattern(parameters, options_.levels);
        }
        SurfacePattern* pattern = &it->second;
        PointWeights* weights = &weights_[{evaluator_.classes().of(face), pattern}];
        ++weights->uses;
        return cuts_.emplace_back(Cut{pattern, weights});
    }

    void evaluate(std::size_t i, Vec3& position, Vec3& normal) {
        if (!evaluator_.evaluate(i, position, normal)) lost_ = true;
        // A corner straight on a crease; the plane that the surface lies in has a normal there too.
        if (normal.isZero(0.0) && evaluator_.inPlane(face_, room_)) normal = faceNormal_;
        // Beside slivers of a planar face the parameters of its surface may run backwards. The
        // surface is in the plane all the same, and so has its normal.
        if (normal.dot(faceNormal_) < -kBackwards) normal = -normal;
    }

    void addFace(int f) {
        const SurfacePattern& p = *cuts_[at(f)].pattern;
        face_ = f;
        evaluator_.begin(f, p.coords, *cuts_[at(f)].weights);
        faceNormal_ = loopAreaVector(cage_.mesh.points, cage_.mesh.outline(f)).normalized();
        slots_.assign(p.coords.size(), {-1, -1});
        std::size_t i = 0;
        const auto sides = edges_.of(f);
        const auto corners = cage_.mesh.outline(f);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            addVertex(i++, corners[k]);
            const int rate = edgeRates_[at(sides[k])];
            addEdge(i, sides[k], rate);
            i += at(rate - 1);
        }
        borderPoints_ = static_cast<int>(i);
        for (; i < p.coords.size(); ++i) {
            Vec3 position;
            Vec3 normal;
            evaluate(i, position, normal);
            slots_[i] = {addPosition(position), addNormal(normal)};
        }
        for (const auto& q : p.facets) addFacet(f, q);
    }

    int addPosition(const Vec3& position) {
        out_.positions.push_back(position);
        return static_cast<int>(out_.positions.size()) - 1;
    }
    int addNormal(const Vec3& normal) {
        out_.normals.push_back(normal.cast<float>());
        return static_cast<int>(out_.normals.size()) - 1;
    }

    /// A point that faces share: its place once, its normal once or, where it is hard, per face.
    void addShared(std::size_t i, bool hard, int& position, int& normal) {
        if (position < 0 || hard) {
            Vec3 where;
            Vec3 up;
            evaluate(i, where, up);
            if (position < 0) position = addPosition(where);
            normal = addNormal(up);
        }
        slots_[i] = {position, normal};
    }

    void addVertex(std::size_t i, int vertex) {
        addShared(i, edges_.hardPoint(vertex), vertexPositions_[at(vertex)],
                  vertexNormals_[at(vertex)]);
    }

    void addEdge(std::size_t first, int edge, int rate) {
        int& position = edgePositions_[at(edge)];
        int& normal = edgeNormals_[at(edge)];
        const bool hard = edges_.hard(edge);
        const bool known = position >= 0;
        if (!known) position = static_cast<int>(out_.positions.size());
        if (!known || hard) normal = static_cast<int>(out_.normals.size());
        for (int j = 0; j < rate - 1; ++j) {
            // The face that came first wrote the points in its own direction.
            const int back = rate - 2 - j;
            int slotPosition = known ? position + back : -1;
            int slotNormal = known && !hard ? normal + back : -1;
            addShared(first + at(j), hard, slotPosition, slotNormal);
        }
    }

    /// Where the surface has no normal of its own, its triangles give one or, where they have no
    /// area either, the faces of the control cage that they are part of.
    void mendNormals() {
        std::vector<bool> missing(out_.normals.size());
        for (std::size_t i = 0; i < missing.size(); ++i) {
            constexpr float kUnit = 0.5F;  // far from none
            missing[i] = !(out_.normals[i].squaredNorm() > kUnit);
        }
        if (std::find(missing.begin(), missing.end(), true) == missing.end()) return;
        struct Sums {
            Vec3 areas = Vec3::Zero();
            Vec3 faces = Vec3::Zero();
        };
        std::map<int, Sums> sums;
        const auto& ids = edges_.anyHard() ? out_.normalTriangles : out_.triangles;
        for (std::size_t t = 0; t < ids.size(); ++t) {
            for (const int i : ids[t]) {
                if (!missing[at(i)]) continue;
                const auto corner = [&](std::size_t k) -> const Vec3& {
                    return out_.positions[at(out_.triangles[t][k])];
                };
                sums[i].areas += (corner(1) - corner(0)).cross(corner(2) - corner(0));
                sums[i].faces +=
                    loopAreaVector(cage_.mesh.points, cage_.mesh.outline(out_.origin[t]))
                        .normalized();
            }
        }
        for (const auto& [i, sum] : sums) {
            const bool flat = !(sum.areas.norm() > 0.0);
            const Vec3 up = (flat ? sum.faces : sum.areas).normalized();
            const bool any = up.squaredNorm() > 0.0;
            out_.normals[at(i)] = (any ? up : Vec3(Vec3::UnitZ())).cast<float>();
        }
    }

    void addFacet(int face, const std::array<int, 4>& q) {
        const auto emit = [&](int a, int b, int c) {
            const Slot& sa = slots_[at(a)];
            const Slot& sb = slots_[at(b)];
            const Slot& sc = slots_[at(c)];
            out_.triangles.push_back({sa.position, sb.position, sc.position});
            if (edges_.anyHard()) out_.normalTriangles.push_back({sa.normal, sb.normal, sc.normal});
            out_.origin.push_back(face);
        };
        if (q[3] < 0) {
            emit(q[0], q[1], q[2]);
            return;
        }
        const auto corner = [&](std::size_t k) {
            const Slot& slot = slots_[at(q[k])];
            return SurfacePoint{out_.positions[at(slot.position)],
                                out_.normals[at(slot.normal)].cast<double>()};
        };
        if (freeDiagonal(q, splitsAt02(corner))) {
            emit(q[0], q[1], q[2]);
            emit(q[0], q[2], q[3]);
        } else {
            emit(q[0], q[1], q[3]);
            emit(q[1], q[2], q[3]);
        }
    }

    /// A diagonal between two points of the border cuts a corner of the face off. Where only two
    /// faces meet in that corner, the other one may have cut it off by the same line, which would
    /// be one edge with four triangles then.
    bool freeDiagonal(const std::array<int, 4>& q, bool at02) {
        const int from = at02 ? q[0] : q[1];
        const int to = at02 ? q[2] : q[3];
        if (from >= borderPoints_ || to >= borderPoints_) return at02;
        const auto [a, b] = std::minmax(slots_[at(from)].position, slots_[at(to)].position);
        return cutCorners_.insert(sideKey(a, b)).second ? at02 : !at02;
    }

    /// Where a corner lies straight between two others only the diagonal that begins at it leaves
    /// two triangles with an area.
    template <class Corner>
    bool splitsAt02(const Corner& corner) const {
        const std::array<SurfacePoint, 4> c{corner(0), corner(1), corner(2), corner(3)};
        const auto good = [&](std::size_t i, std::size_t j, std::size_t k) {
            return hasArea(c[i].position, c[j].position, c[k].position, leastHeight_);
        };
        const bool first = good(0, 1, 2) && good(0, 2, 3);
        const bool second = good(0, 1, 3) && good(1, 2, 3);
        return first == second ? turnsLess(c[0], c[2], c[1], c[3]) : first;
    }

    static constexpr double kBackwards = 0.999;  ///< cosine; no curved face turns so far

    const ControlCage& cage_;
    const SubdivisionOptions& options_;
    CageEdges edges_;
    SurfaceEvaluator evaluator_;
    std::vector<int> edgeRates_;
    std::vector<std::array<int, 2>> innerRates_;
    std::map<std::vector<int>, SurfacePattern> patterns_;
    std::map<std::pair<int, const SurfacePattern*>, PointWeights> weights_;  ///< first: class
    std::vector<Cut> cuts_;                                                  ///< by face
    int face_ = -1;                                                          ///< under way
    Vec3 faceNormal_ = Vec3::Zero();                ///< unit, of the control polygon
    double room_ = 0.0;                             ///< what counts as in a plane [mm]
    double leastHeight_ = 0.0;                      ///< of a triangle [mm]
    bool lost_ = false;                             ///< a face had no surface
    int borderPoints_ = 0;                          ///< of the face under way; they come first
    std::unordered_set<std::uint64_t> cutCorners_;  ///< diagonals between points of borders
    std::vector<int> key_;
    FaceSamples samples_;
    std::vector<int> vertexPositions_;
    std::vector<int> vertexNormals_;
    std::vector<int> edgePositions_;  ///< first of the points inside an edge
    std::vector<int> edgeNormals_;
    std::vector<Slot> slots_;
    SurfaceMesh out_;
};

}  // namespace

std::size_t surfaceBytes(std::size_t positions, std::size_t triangles, bool creased) {
    const std::size_t perTriangle = sizeof(std::array<int, 3>) * (creased ? 2 : 1) + sizeof(int);
    return positions * (sizeof(Vec3) + sizeof(Eigen::Vector3f)) + triangles * perTriangle;
}

Result<SurfaceMesh> subdivide(const ControlCage& cage, const SubdivisionOptions& options) {
    if (auto ok = checkInput(cage, options); !ok) return fail(ok.error());
    // Adaptive points are anywhere; with this many levels the patches beside extraordinary points
    // are within 1e-5 of the size of a face of the limit surface.
    constexpr int kPatchLevels = 6;
    auto surface = LimitSurface::create(cage, options.scheme,
                                        options.tolerance > 0.0 ? kPatchLevels : options.levels);
    if (!surface) return fail(surface.error());
    return Tessellator(cage, options, std::move(*surface)).run();
}

}  // namespace ew
