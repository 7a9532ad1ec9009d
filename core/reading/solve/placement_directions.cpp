// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/placement_directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }
constexpr double kRadian = 180.0 / std::numbers::pi;
constexpr std::size_t kMostChoices = 3;
constexpr double kSteadiestDeg = 0.2;  // nobody draws directions better

/// What is drawn of a direction class.
struct DrawnClass {
    Vec2 doubled = Vec2::Zero();  ///< sum of lengths times doubled direction
    double length = 0.0;
    std::vector<int> inFaces;  ///< faces of the solid that its edges lie in
    int modelEdge = -1;        ///< one of its edges is this edge of the solid
    bool related = false;      ///< it has edges in such faces or is perpendicular to what has
};

struct Choice {
    ModelDirection direction;
    bool free = false;  ///< no direction of the model
    double price = 0.0;
    double cost = 0.0;
};

bool coincides(const FacePairs& pairs, int templateFace) {
    return std::any_of(pairs.begin(), pairs.end(),
                       [&](const auto& p) { return p[0] == templateFace; });
}

std::vector<DrawnClass> drawnClasses(const JointReading& reading, const GraphMatch& match,
                                     const FacePairs& pairs) {
    const TemplateAnalysis& analysis = match.entry->analysis;
    std::vector<DrawnClass> classes(at(analysis.classCount));
    for (std::size_t g = 0; g < reading.graph.edges.size(); ++g) {
        const AnalysedEdge& e = analysis.edges[at(match.edge[g])];
        DrawnClass& c = classes[at(e.directionClass)];
        const Vec2 d = reading.graph.edges[g].tips[1] - reading.graph.edges[g].tips[0];
        const double len = std::max(d.norm(), 1e-9);
        c.doubled += Vec2(d.x() * d.x() - d.y() * d.y(), 2 * d.x() * d.y()) / len;
        c.length += len;
        if (reading.edgeModel[g] >= 0 &&
            (coincides(pairs, e.faces[0]) || coincides(pairs, e.faces[1]))) {
            c.modelEdge = reading.edgeModel[g];
        }
    }
    for (const AnalysedEdge& e : analysis.edges) {
        for (const auto& p : pairs) {
            if (e.faces[0] == p[0] || e.faces[1] == p[0]) {
                classes[at(e.directionClass)].inFaces.push_back(p[1]);
                classes[at(e.directionClass)].related = true;
            }
        }
    }
    for (const auto& pair : analysis.perpendicularClasses) {
        for (std::size_t s = 0; s < 2; ++s) {
            if (!classes[at(pair[1 - s])].inFaces.empty()) classes[at(pair[s])].related = true;
        }
    }
    return classes;
}

class Chooser {
  public:
    Chooser(const ModelView& model, const FacePairs& pairs, const DirectionOptions& options)
        : model_(model),
          pairs_(pairs),
          options_(options),
          known_(directionsNear(model, solidFacesOf(pairs))) {}

    std::vector<Choice> choices(const DrawnClass& c) const {
        if (c.modelEdge >= 0) {
            return {
                {{model_.edgeDirection(c.modelEdge), ToolEdgeRule::Kind::AlongEdge, c.modelEdge}}};
        }
        std::vector<Choice> out;
        // The slope of a pyramid's side says nothing of how deep its apex lies: it may look like
        // any direction.
        if (c.length > 0 && c.related) out = near(c);
        if (c.length == 0 && !c.inFaces.empty()) out = within(c.inFaces);
        std::stable_sort(out.begin(), out.end(),
                         [](const Choice& a, const Choice& b) { return a.price < b.price; });
        if (out.size() > kMostChoices) out.resize(kMostChoices);
        out.push_back({{}, true, tol::kFreedomCost, 0.0});
        return out;
    }

  private:
    std::vector<Choice> near(const DrawnClass& c) const {
        const double drawn = 0.5 * std::atan2(c.doubled.y(), c.doubled.x());
        const double excuse = std::atan(options_.noisePx / std::max(0.5 * c.length, 1.0)) * kRadian;
        std::vector<Choice> out;
        for (const ModelDirection& d : known_) {
            if (d.direction.head<2>().norm() < tol::kEndOnSine) continue;
            if (!liesIn(d, c.inFaces)) continue;
            const double angle = std::atan2(d.direction.y(), d.direction.x());
            const double off = std::abs(std::remainder(angle - drawn, std::numbers::pi)) * kRadian;
            if (off > options_.angleDeg + excuse) continue;
            // How far off is said by the ink once more when it is solved, so here it only sorts.
            const double cost = c.inFaces.empty() && !upright(d) ? tol::kSlantCost : 0.0;
            out.push_back({d, false, off / (kSteadiestDeg + 0.5 * excuse) + cost, cost});
        }
        return out;
    }
    /// What was not drawn but lies in faces of the solid, as where a body ends at a wall: a
    /// direction that lies in all of them.
    std::vector<Choice> within(const std::vector<int>& faces) const {
        std::vector<Choice> out;
        for (const ModelDirection& d : known_) {
            if (liesIn(d, faces)) out.push_back({d, false, 0.0, 0.0});
        }
        return out;
    }
    bool liesIn(const ModelDirection& d, const std::vector<int>& faces) const {
        return std::all_of(faces.begin(), faces.end(), [&](int f) {
            return std::abs(model_.plane(f).normal.dot(d.direction)) < tol::kSolidDirection;
        });
    }
    /// A wall is usually meant to stand upright on its face.
    bool upright(const ModelDirection& d) const {
        return std::any_of(pairs_.begin(), pairs_.end(), [&](const auto& p) {
            return model_.plane(p[1]).normal.cross(d.direction).norm() < tol::kSolidDirection;
        });
    }

    const ModelView& model_;
    const FacePairs& pairs_;
    const DirectionOptions& options_;
    const std::vector<ModelDirection>& known_;
};

/// Perpendicular classes of the template that take directions which are not.
int skewed(const DirectionAssignment& a, const TemplateAnalysis& analysis) {
    int n = 0;
    for (const auto& pair : analysis.perpendicularClasses) {
        const auto& d = a.byClass[at(pair[0])];
        const auto& e = a.byClass[at(pair[1])];
        if (d && e && std::abs(d->direction.dot(e->direction)) > tol::kSolidDirection) ++n;
    }
    return n;
}

/// Two classes of the template that are one direction of the model make a flat body.
bool flat(const DirectionAssignment& a) {
    for (std::size_t i = 0; i < a.byClass.size(); ++i) {
        for (std::size_t k = i + 1; k < a.byClass.size(); ++k) {
            const auto& d = a.byClass[i];
            const auto& e = a.byClass[k];
            if (d && e && d->direction.cross(e->direction).norm() < tol::kSolidDirection) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace

std::vector<int> solidFacesOf(const FacePairs& pairs) {
    std::vector<int> faces;
    for (const auto& p : pairs) faces.push_back(p[1]);
    return faces;
}

KnownDirections DirectionAssignment::known() const {
    KnownDirections out;
    for (const auto& d : byClass) {
        out.push_back(d ? std::optional<Vec3>(d->direction) : std::nullopt);
    }
    return out;
}

std::vector<DirectionAssignment> directionAssignments(
    const JointReading& reading, const GraphMatch& match, const ModelView& model,
    const FacePairs& pairs, const DirectionOptions& options, std::size_t limit) {
    constexpr std::size_t kMostKept = 96;
    const Chooser chooser(model, pairs, options);
    std::vector<DirectionAssignment> all(1);
    for (const DrawnClass& c : drawnClasses(reading, match, pairs)) {
        std::vector<DirectionAssignment> next;
        for (const Choice& choice : chooser.choices(c)) {
            for (const DirectionAssignment& a : all) {
                next.push_back(a);
                DirectionAssignment& b = next.back();
                b.byClass.push_back(choice.free ? std::nullopt : std::optional(choice.direction));
                b.price += choice.price;
                b.cost += choice.cost;
                if (!choice.free && flat(b)) next.pop_back();
            }
        }
        std::stable_sort(next.begin(), next.end(),
                         [](const auto& a, const auto& b) { return a.price < b.price; });
        if (next.size() > kMostKept) next.resize(kMostKept);
        all = std::move(next);
    }
    for (DirectionAssignment& a : all) {
        const double skew = tol::kSkewCost * skewed(a, match.entry->analysis);
        a.price += skew;
        a.cost += skew;
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.price < b.price; });
    if (all.size() > limit) all.resize(limit);
    return all;
}

}  // namespace ew
