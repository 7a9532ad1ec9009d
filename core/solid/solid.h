// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"
#include "core/solid/polyhedron_spec.h"

namespace ew {

/// A planar face as a person counts it: one outer loop and the loops of its holes.
struct SolidFace {
    std::vector<std::vector<int>> loops;  ///< vertex indices; [0] outer, counter-clockwise from
                                          ///< outside, the others clockwise
    Vec3 normal = Vec3::Zero();           ///< unit, outward, body frame
    double offset = 0.0;                  ///< normal . p = offset on the face [mm]
};

/// An edge between two faces (or two visits of one face, never inside a region).
struct SolidEdge {
    std::array<int, 2> ends{-1, -1};   ///< vertex indices, ends[0] -> ends[1] as in faces[0]
    std::array<int, 2> faces{-1, -1};  ///< left and right face
    bool convex = true;                ///< dihedral angle inside the solid under 180 degrees
};

/// A triangle for display and for exact algorithms; `face` names its region.
struct SolidTriangle {
    std::array<int, 3> vertices{-1, -1, -1};
    int face = -1;
};

/// An immutable closed solid with planar faces in its own body frame: an OpenMesh half-edge mesh
/// with exact (EPECK) points behind the doubles given here. Copies share their data. A Solid
/// always passed the validity check of docs/design.md: closed, 2-manifold, oriented, planar
/// regions, free of self-intersection, positive volume of every outer shell.
class Solid {
  public:
    /// Builds a solid from faces. Vertices are moved (far below drawing accuracy, at most 1e-6 of
    /// the size) so that every face is planar in exact arithmetic.
    /// Errors: BadValue (non-finite, indices out of range), NotClosed, NotManifold, NotOriented,
    /// NotPlanar, SelfIntersecting, NoVolume; the message names the face or vertex.
    static Result<Solid> fromSpec(const PolyhedronSpec& spec);

    /// Geometry as a person counts it (nothing that only triangulation brought in).
    const std::vector<Vec3>& vertices() const;  ///< body frame [mm], rounded from exact
    const std::vector<SolidEdge>& edges() const;
    const std::vector<SolidFace>& faces() const;
    const std::vector<SolidTriangle>& triangles() const;

    int shellCount() const;              ///< connected components of the surface
    int genus() const;                   ///< sum over the shells
    double volume() const;               ///< [mm^3]
    double area() const;                 ///< [mm^2]
    std::array<Vec3, 2> bounds() const;  ///< body frame min, max [mm]

    /// Exact text form of all coordinates and topology, and back: nothing is lost, bit-equal
    /// after a round trip. Reading checks everything as fromSpec does.
    std::string serialize() const;
    static Result<Solid> deserialize(const std::string& text);

    /// A solid that is read when something first asks for its geometry; any thread may be the one.
    /// Until then it costs what `text` holds.
    /// \param text  gives what serialize() gave; called by any thread, one at a time.
    /// \pre where load() fails, only that, serialize() and sharesDataWith() are called; everything
    ///     else throws std::runtime_error then.
    static Solid deferred(std::function<Result<std::string>()> text);
    /// Reads a deferred solid now, where that was not done yet. Errors: those of its text and of
    /// deserialize(), the same ones every time.
    Result<void> load() const;
    bool isLoaded() const;

    /// True where both hold the same topology and exactly the same coordinates, index by index.
    bool identicalTo(const Solid& other) const;
    /// Is one a copy of the other, however far removed? Nothing is read for it.
    bool sharesDataWith(const Solid& other) const { return content_ == other.content_; }

    struct Impl;
    explicit Solid(std::shared_ptr<const Impl> impl);
    const Impl& impl() const;

  private:
    class Content;
    explicit Solid(std::shared_ptr<Content> content);
    std::shared_ptr<Content> content_;
};

/// A solid in the world.
struct Body {
    Solid solid;
    Pose pose;              ///< body frame -> world
    std::string name = {};  ///< that a person calls it by; empty: by its number
    bool hidden = false;    ///< neither shown nor drawn on nor exported
};

}  // namespace ew
