// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/camera.h"
#include "core/reading/types/interpretation.h"
#include "tests/support/hand_model.h"
#include "tests/support/modification_shapes.h"

namespace ew::test {

/// A change of a solid as a designer draws it, with what has to come of it.
struct ModificationCase {
    std::string scene;  ///< what the target is
    std::string name;
    int view = 0;  ///< which camera
    Body target;
    OrthographicCamera camera;
    Operation operation = Operation::Cut;
    std::string templateId;
    Lines3 lines;                            ///< what is drawn, body frame [mm]
    double volume = 0.0;                     ///< of the result [mm^3]
    int vertices = 0, edges = 0, faces = 0;  ///< of the result
    bool told = true;                        ///< the lines say all that is needed

    /// A person could tell what is meant: no line is shorter than two distance thresholds, and what
    /// is apart is so by more than one.
    bool legible() const;
};

/// Cameras that see the front, the right and the upper side of a solid that is about 80 mm wide,
/// the whole of it about 400 px wide; the first is the default one. The second half sees the same
/// from nearer, as a person would to draw something small.
inline constexpr int kModificationDirections = 14;
inline constexpr int kModificationViews = 2 * kModificationDirections;
OrthographicCamera modificationCamera(int view, const Vec3& center, const Pose& pose = {});

/// The cases on a box of 80 x 60 x 40 mm (corner in the origin) in some pose. Their lines are those
/// that are new and can be seen, or the outlines on the solid alone, as the name says.
std::vector<ModificationCase> boxModifications(const Pose& pose = {}, int view = 0);

/// The same on the box after ten earlier modifications, two of them in sight.
std::vector<ModificationCase> workedBoxModifications(int view = 0);

/// Cases on a lying triangular prism with a slope of 3 : 4.
std::vector<ModificationCase> prismModifications(int view = 0);

/// Bodies on the box whose sides lean, each as much as the one across from it.
std::vector<ModificationCase> frustumModifications(int view = 0);

/// Against a wall, between two bosses, and where new faces meet earlier hollows or bosses.
std::vector<ModificationCase> jointModifications(int view = 0);

/// The one of that name; a name that none has ends the program.
ModificationCase caseNamed(const std::vector<ModificationCase>& cases, const std::string& name);

/// A camera that sees the whole box from the side of its corner (80, 0, 40), about 400 px wide.
OrthographicCamera defaultBoxCamera(const Pose& pose = {});

/// The lines on the Sketch Plane, ends that meet being equal.
std::vector<Line2> linesOnPlane(const ModificationCase& c);

/// One straight stroke a line, sampled every few px.
std::vector<Stroke> exactStrokes(const std::vector<Line2>& lines);

}  // namespace ew::test
