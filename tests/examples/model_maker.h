// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "tests/support/hand_model.h"
#include "tests/support/modification_shapes.h"

namespace ew::test {

/// Draws a model as a person would, stroke by stroke with a hand that shakes, in a document of its
/// own; what was done is then saved as a sketch script.
///
/// Places are given as shares of the first box: (0, 0, 0) is its left, front, lower corner and
/// (1, 1, 1) the opposite one. What comes near a coordinate that the solid has is put there.
class ModelMaker {
  public:
    ModelMaker(TemplateLibrary library, const HandLevel& hand, std::uint64_t seed);

    /// Looks from an azimuth (from the right, 0, to the front, 90) and a tilt [degrees].
    void lookFrom(double azimuthDeg, double tiltDeg);
    /// A box in free space. [mm]
    void startBox(const Vec3& size);
    void addBox(const Vec3& low, const Vec3& high);
    void cutBox(const Vec3& low, const Vec3& high);
    void addPrism(const std::vector<Vec3>& triangle, const Vec3& along);
    void cutPrism(const std::vector<Vec3>& triangle, const Vec3& along);
    /// All edges, by share of the box's height.
    void fillet(EdgeChoice::Which which, double share, int segments);
    void subdivide(int levels);
    /// Lines on the surface, each through some places.
    void drawOn(const std::vector<std::vector<Vec3>>& lines, const std::string& color);

    /// Steps that the document took.
    int steps() const { return steps_; }
    Document& document() { return document_; }

  private:
    void change(Operation operation, const PolyhedronSpec& shares);
    void draw(const std::vector<Line2>& lines);
    Vec3 place(const Vec3& share, bool snap) const;
    void aim();
    const Body& body() const { return document_.state().bodies.front(); }

    Document document_;
    HandLevel hand_;
    std::uint64_t seed_;
    int steps_ = 0;
    double azimuthDeg_ = 45.0;
    double tiltDeg_ = 32.0;
    std::array<Vec3, 2> bounds_{Vec3::Zero(), Vec3::Ones()};  ///< of the first box, body frame
};

}  // namespace ew::test
