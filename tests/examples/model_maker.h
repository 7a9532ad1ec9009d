// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "tests/support/hand_model.h"
#include "tests/support/modification_shapes.h"

namespace ew::test {

/// Draws a model as a person would, stroke by stroke with a hand that shakes, in a document of its
/// own; what was done is then saved as a sketch script.
///
/// Places are given in millimetres as the model is meant: the first box has its left, front, lower
/// corner at (0, 0, 0). What the hand makes of it differs; a coordinate that is meant again is that
/// of the solid, and one between two of these is put between them.
class ModelMaker {
  public:
    ModelMaker(TemplateLibrary library, const HandLevel& hand, std::uint64_t seed);

    // View ----------------------------------------------------------------------------------------
    /// Looks at the whole from an azimuth (from the right, 0, to the front, 90, and the left, 180)
    /// and a tilt, 90 from above [degrees].
    void lookFrom(double azimuthDeg, double tiltDeg);
    /// The same at a place, with this height of the model filling the viewport [mm].
    void lookFrom(double azimuthDeg, double tiltDeg, const Vec3& place, double heightMm);

    // Sketches ------------------------------------------------------------------------------------
    /// A box in free space, from (0, 0, 0) to this corner.
    void startBox(const Vec3& size);
    void add(const PolyhedronSpec& what) { change(Operation::Add, what); }
    void cut(const PolyhedronSpec& what) { change(Operation::Cut, what); }

    // Surface -------------------------------------------------------------------------------------
    void fillet(EdgeChoice::Which which, double radiusMm, int segments);
    /// The edges nearest to these places.
    void fillet(const std::vector<Vec3>& places, double radiusMm, int segments);
    void sharpen(const std::vector<Vec3>& places);
    void crease(const std::vector<Vec3>& places, double sharpness);
    void subdivide(int levels, std::optional<double> sharpness = std::nullopt);
    /// Curves on the surface, each one stroke through places near enough to each other, or with
    /// corners.
    void drawOn(const std::vector<std::vector<Vec3>>& curves, const std::string& color);

    /// Sketches that the document took.
    int sketches() const { return sketches_; }
    Document& document() { return document_; }

  private:
    void change(Operation operation, const PolyhedronSpec& meant);
    bool isMeant(const Candidate& found, Operation operation, const Solid& wanted,
                 std::string& why) const;
    void learn(const PolyhedronSpec& meant, const PolyhedronSpec& placed,
               const PolyhedronSpec& found);
    Vec3 place(const Vec3& meant) const;
    Vec3 worldPlace(const Vec3& meant) const;
    PolyhedronSpec placed(PolyhedronSpec meant) const;
    EdgeChoice edgesAt(const std::vector<Vec3>& places) const;
    std::vector<Stroke> byHand(const std::vector<Line2>& lines, std::uint64_t attempt) const;
    void aim();
    const Body& body() const { return document_.state().bodies.front(); }

    Document document_;
    HandLevel hand_;
    std::uint64_t seed_;
    int sketches_ = 0;
    std::uint64_t curves_ = 0;
    double azimuthDeg_ = 45.0;
    double tiltDeg_ = 32.0;
    std::optional<Vec3> focus_;
    double heightMm_ = 0.0;
    /// By axis of the world: coordinates that were meant, and what they are in the body's frame.
    std::array<std::map<double, double>, 3> known_;
};

}  // namespace ew::test
