// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/camera.h"
#include "core/modeling/interpretation.h"
#include "core/solid/solid.h"
#include "tests/support/hand_model.h"

namespace ew::test {

/// A change of a solid as a designer draws it, with what has to come of it.
struct ModificationCase {
    std::string name;
    Body target;
    Operation operation = Operation::Cut;
    std::string templateId;
    std::vector<std::array<Vec3, 2>> lines;  ///< what is drawn, body frame [mm]
    double volume = 0.0;                     ///< of the result [mm^3]
    int vertices = 0, edges = 0, faces = 0;  ///< of the result
};

/// The cases on a box of 80 x 60 x 40 mm (corner in the origin) in some pose. Their lines are those
/// that are new and can be seen from the default camera, or the outlines on the solid alone, as the
/// name says.
std::vector<ModificationCase> boxModifications(const Pose& pose = {});

/// A camera that sees the whole box from the side of its corner (80, 0, 40), about 400 px wide.
OrthographicCamera defaultBoxCamera(const Pose& pose = {});

/// The lines on the Sketch Plane, ends that meet being equal.
std::vector<Line2> linesOnPlane(const ModificationCase& c, const OrthographicCamera& camera);

/// One straight stroke a line, sampled every few px.
std::vector<Stroke> exactStrokes(const std::vector<Line2>& lines);

}  // namespace ew::test
