// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/solid/solid.h"
#include "core/surface/subdivision.h"

namespace ew {

/// An edge of one of the document's bodies.
struct EdgeRef {
    int body = -1;  ///< index into DocumentState::bodies
    int edge = -1;  ///< index into Solid::edges()
    auto operator<=>(const EdgeRef&) const = default;
};

/// Which edges an operation is for.
struct EdgeChoice {
    enum class Which { All, Convex, Concave, Picked };
    Which which = Which::All;
    std::vector<EdgeRef> picked;  ///< for Which::Picked
};

/// A crease that is as sharp as SubdivisionSettings says.
inline constexpr double kAutomaticSharpness = -1.0;

/// What is set for the edges of one body. Each list is empty or holds one number an edge.
struct EdgeSettings {
    std::vector<double> radii;      ///< of the fillet [mm], 0: not filleted; empty: none is
    std::vector<double> sharpness;  ///< 0..kInfiniteSharpness or kAutomaticSharpness; empty: all
                                    ///< automatic
    bool operator==(const EdgeSettings&) const = default;
};

/// The smooth surface over the cage.
struct SubdivisionSettings {
    bool on = false;
    SubdivisionScheme scheme = SubdivisionScheme::CatmullClark;
    int levels = 3;                   ///< uniform, 1..kMaxSubdivisionLevels
    double tolerance = 0.0;           ///< > 0: adaptive [mm], `levels` is not used then
    std::optional<double> sharpness;  ///< of edges that are neither filleted nor set by themselves,
                                      ///< 0..kInfiniteSharpness; not set: infinite where some edge
                                      ///< of the document is filleted, else 0
    bool sharpCorners = false;        ///< what is left of the solid's corners stays where it is
    bool operator==(const SubdivisionSettings&) const = default;
};

/// Step 5 as the document keeps it; the shapes that follow from it are derived (derived_shape.h).
struct SurfaceSettings {
    std::vector<EdgeSettings> edges;  ///< by body; bodies beyond its end have nothing set
    int segments = 1;                 ///< across a fillet, 1..kMaxFilletSegments
    SubdivisionSettings subdivision;
    bool operator==(const SurfaceSettings&) const = default;

    bool hasFillet() const;
    /// The radius of an edge, 0 where it is not filleted. [mm]
    double radius(const EdgeRef& edge) const;
    double sharpness(const EdgeRef& edge) const;
    void setRadius(const std::vector<Body>& bodies, const EdgeRef& edge, double radius);
    void setSharpness(const std::vector<Body>& bodies, const EdgeRef& edge, double sharpness);
    /// Drops lists that say nothing, so that equal settings compare equal.
    void tidy();
};

/// Red, green, blue of a stroke on the surface.
using StrokeColor = std::array<std::uint8_t, 3>;
inline constexpr StrokeColor kDefaultStrokeColor{32, 34, 40};

/// "#rrggbb" or a name of the SVG colours, opaque. Errc::BadValue.
Result<StrokeColor> parseColor(const std::string& text);
std::string colorText(const StrokeColor& color);

/// The largest radius that is taken at all [mm]; what is too large for an edge is clamped.
inline constexpr double kMaxRadiusMm = 1e9;
inline constexpr double kMaxToleranceMm = 1e9;

/// Errors: BadValue for what is out of range, NaN included.
Result<void> checkRadius(double radius);
Result<void> checkSegments(int segments);
Result<void> checkSharpness(double sharpness);
Result<void> checkSubdivision(const SubdivisionSettings& settings);

/// The edges of a choice, sorted, each once. Errors: NoSolid; NoEdge where there is none; BadValue
/// for an edge that does not exist.
Result<std::vector<EdgeRef>> chosenEdges(const std::vector<Body>& bodies, const EdgeChoice& choice);

/// The edge nearest to a world point; of equally near ones the first.
/// \param body  only this body's edges where not -1.
/// Errors: NoSolid, NoEdge where there is no such body.
Result<EdgeRef> nearestEdge(const std::vector<Body>& bodies, const Vec3& world, int body = -1);

/// A world point for which nearestEdge() gives this edge; nothing where another edge of another
/// body covers all of it.
std::optional<Vec3> pointNaming(const std::vector<Body>& bodies, const EdgeRef& edge);

/// What was set for the edges of a solid, for the edges that survive in what became of it: those on
/// the same line between the same two planes that overlap the old ones. Parts of an edge that was
/// split inherit from it; of several edges that became one, the longest decides.
EdgeSettings carriedOver(const Solid& before, const EdgeSettings& settings, const Solid& after);

}  // namespace ew
