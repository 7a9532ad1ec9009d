// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/apart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/edge_graph/edit.h"
#include "core/reading/extract/line_drawing.h"
#include "core/reading/extract/plane_geometry.h"
#include "core/reading/types/reading_params.h"

namespace ew {
namespace {

constexpr std::size_t kFewestEdges = 5;
constexpr std::size_t kMostBodies = 12;
constexpr double kSameAxis = 0.99;     ///< cosine of an angle between axes that are one
constexpr double kLeastUpright = 0.7;  ///< cosine of its angle to the picture's vertical
constexpr double kLeastSlope = 0.1;    ///< of the view onto the ground, sine
constexpr double kFarthest = 4.0;      ///< from each other, in their size

/// Does a corner of one drawing lie inside the outline of another one?
bool overlap(const std::vector<EdgeGraph>& parts) {
    for (const EdgeGraph& around : parts) {
        const LineDrawing drawing = lineDrawing(around, params::kStraightDeg);
        const std::vector<Vec2> outline = drawing.polygon(drawing.outline);
        for (const EdgeGraph& other : parts) {
            if (&other == &around) continue;
            for (const Junction& j : other.junctions) {
                if (insidePolygon(outline, j.position)) return true;
            }
        }
    }
    return false;
}

std::set<int> strokesOf(const EdgeGraph& graph) {
    std::set<int> out;
    for (const GraphEdge& e : graph.edges) out.insert(e.strokes.begin(), e.strokes.end());
    return out;
}

/// The ink of each drawing; nothing where strokes are in two, or in none.
std::optional<std::vector<InkReading>> inkOfEach(const InkReading& ink,
                                                 const std::vector<EdgeGraph>& parts) {
    std::vector<InkReading> out;
    std::set<int> seen;
    for (const EdgeGraph& part : parts) {
        const std::set<int> strokes = strokesOf(part);
        for (const int s : strokes) {
            if (!seen.insert(s).second) return std::nullopt;
        }
        InkReading own;
        own.wobblePx = ink.wobblePx;
        for (const Segment& s : ink.segments) {
            if (strokes.contains(s.stroke)) own.segments.push_back(s);
        }
        out.push_back(std::move(own));
    }
    const bool all = std::all_of(ink.segments.begin(), ink.segments.end(),
                                 [&](const Segment& s) { return seen.contains(s.stroke); });
    if (!all) return std::nullopt;
    return out;
}

/// Bodies, each as it was read.
class Scene {
  public:
    Scene(const std::vector<Interpretation>& read, const OrthographicCamera& camera)
        : camera_(camera) {
        for (const Interpretation& r : read) {
            taken_.push_back(&r.candidates[static_cast<std::size_t>(*r.accepted)]);
            std::vector<Vec3> world;
            for (const Vec3& v : taken_.back()->spec.vertices) {
                world.push_back(taken_.back()->pose.toWorld(v));
            }
            bodies_.push_back(std::move(world));
        }
        if (const auto up = commonUp()) standOnOneGround(*up);
    }

    Candidate candidate() const {
        Candidate out = *taken_.front();
        out.templateName = std::to_string(taken_.size()) + " solids";
        out.readingId = "default";
        out.readingName.clear();
        out.spec = {};
        out.notes.clear();
        out.unusedStrokes.clear();
        out.junctionVertex.clear();
        out.evidence = {};
        double squares = 0.0;
        double probability = 1.0;
        for (std::size_t i = 0; i < taken_.size(); ++i) {
            const Candidate& c = *taken_[i];
            add(out, c, bodies_[i]);
            if (c.templateId != out.templateId) out.templateId = "polyhedron";
            out.score = std::min(out.score, c.score);
            probability *= c.probability;
            squares += c.residualPx * c.residualPx / static_cast<double>(taken_.size());
        }
        out.aspect = "region";
        out.probability = probability;
        out.residualPx = std::sqrt(squares);
        return out;
    }

  private:
    static void add(Candidate& out, const Candidate& c, const std::vector<Vec3>& world) {
        const int first = static_cast<int>(out.spec.vertices.size());
        for (const Vec3& v : world) out.spec.vertices.push_back(out.pose.toBody(v));
        for (std::vector<int> face : c.spec.faces) {
            for (int& v : face) v += first;
            out.spec.faces.push_back(std::move(face));
        }
        for (const int v : c.junctionVertex) out.junctionVertex.push_back(v < 0 ? v : v + first);
        for (const std::string& note : c.notes) {
            if (std::find(out.notes.begin(), out.notes.end(), note) == out.notes.end()) {
                out.notes.push_back(note);
            }
        }
        out.unusedStrokes.insert(out.unusedStrokes.end(), c.unusedStrokes.begin(),
                                 c.unusedStrokes.end());
        out.evidence.fit += c.evidence.fit;
        out.evidence.stray += c.evidence.stray;
        out.evidence.bare += c.evidence.bare;
        out.evidence.freedoms += c.evidence.freedoms;
        out.evidence.prior += c.evidence.prior;
    }

    /// The axis that all bodies have and that is most upright in the picture [world].
    std::optional<Vec3> commonUp() const {
        std::optional<Vec3> best;
        double most = kLeastUpright;
        for (int k = 0; k < 3; ++k) {
            Vec3 axis = taken_.front()->pose.rotation.col(k);
            if (axis.dot(camera_.trueUp()) < 0.0) axis = -axis;
            const Vec2 shown(axis.dot(camera_.right()), axis.dot(camera_.trueUp()));
            const double upright = shown.y() / std::max(shown.norm(), 1e-9);
            if (upright < most) continue;
            const bool common = std::all_of(taken_.begin(), taken_.end(), [&](const Candidate* c) {
                return (c->pose.rotation.transpose() * axis).cwiseAbs().maxCoeff() > kSameAxis;
            });
            if (!common) continue;
            most = upright;
            best = axis;
        }
        return best;
    }

    void standOnOneGround(const Vec3& up) {
        const double slope = up.dot(camera_.direction);
        if (std::abs(slope) < kLeastSlope) return;
        std::vector<double> shifts;
        Eigen::AlignedBox3d box;
        for (const auto& body : bodies_) {
            for (const Vec3& v : body) box.extend(v);
            shifts.push_back((lowest(bodies_.front(), up) - lowest(body, up)) / slope);
        }
        const auto far = [&](double shift) {
            return std::abs(shift) > kFarthest * box.diagonal().norm();
        };
        if (std::any_of(shifts.begin(), shifts.end(), far)) return;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            for (Vec3& v : bodies_[i]) v += shifts[i] * camera_.direction;
        }
    }

    static double lowest(const std::vector<Vec3>& body, const Vec3& up) {
        double least = std::numeric_limits<double>::infinity();
        for (const Vec3& v : body) least = std::min(least, v.dot(up));
        return least;
    }

    const OrthographicCamera& camera_;
    std::vector<const Candidate*> taken_;
    std::vector<std::vector<Vec3>> bodies_;  ///< vertices [world, mm]
};

}  // namespace

std::optional<Interpretation> readApart(
    const InkReading& ink, const InterpretOptions& options,
    const std::function<Interpretation(const InkReading&)>& read) {
    const std::vector<EdgeGraph> parts =
        connectedParts(buildEdgeGraph(ink, options.thresholds.distancePx));
    if (parts.size() < 2 || parts.size() > kMostBodies) return std::nullopt;
    for (const EdgeGraph& part : parts) {
        if (part.edges.size() < kFewestEdges || isOneOutline(part)) return std::nullopt;
    }
    if (overlap(parts)) return std::nullopt;
    const auto inks = inkOfEach(ink, parts);
    if (!inks) return std::nullopt;
    std::vector<Interpretation> each;
    std::vector<EdgeGraph> graphs;
    for (const InkReading& own : *inks) {
        Interpretation one = read(own);
        if (!one.accepted) return std::nullopt;
        Candidate& c = one.candidates[static_cast<std::size_t>(*one.accepted)];
        c.junctionVertex.resize(one.graph.junctions.size(), -1);
        if (c.depth != DepthRule::Orthographic || c.missingEdges > 0 || c.extraEdges > 0) {
            return std::nullopt;
        }
        graphs.push_back(one.graph);
        each.push_back(std::move(one));
    }
    Interpretation out;
    out.graph = joinedParts(graphs);
    out.graph.noise.insert(out.graph.noise.end(), ink.noise.begin(), ink.noise.end());
    out.candidates.push_back(Scene(each, options.camera).candidate());
    out.accepted = 0;
    std::vector<int>& unused = out.candidates.front().unusedStrokes;
    for (const NoiseItem& n : ink.noise) unused.push_back(n.stroke);
    std::sort(unused.begin(), unused.end());
    return out;
}

}  // namespace ew
