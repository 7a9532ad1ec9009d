// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/tlib/template.h"

namespace ew {

/// An undirected edge of a template with what relations say of it.
struct AnalysedEdge {
    std::array<int, 2> ends{-1, -1};   ///< ends[0] < ends[1]
    std::array<int, 2> faces{-1, -1};  ///< faces[0] runs ends[0] -> ends[1]
    int directionClass = -1;           ///< edges known to be parallel share it; never -1
    double sense = 1.0;                ///< +1 where ends[0] -> ends[1] has the sense of its class
};

/// A template all of whose edges run along three mutually perpendicular directions. Every vertex
/// lies on one plane perpendicular to each axis; planes[i] is the plane number of every vertex
/// along axis i.
struct RectilinearStructure {
    std::array<int, 3> axisClass{-1, -1, -1};  ///< direction class of each axis
    std::array<std::vector<int>, 3> planes;    ///< per vertex
    std::array<int, 3> planeCount{0, 0, 0};
    std::array<std::vector<double>, 3>
        reference;  ///< coordinate of each plane in the reference shape
};

/// What follows from a template's relations; derived once when it is loaded.
struct TemplateAnalysis {
    std::vector<AnalysedEdge> edges;
    int classCount = 0;
    std::vector<std::array<int, 2>> perpendicularClasses;  ///< pairs of direction classes
    std::vector<std::vector<int>> equalLength;             ///< classes of edge indices
    std::vector<Vec3> faceNormals;                         ///< unit, outward, reference shape
    bool convex = false;
    std::optional<RectilinearStructure> rectilinear;

    int edgeBetween(int a, int b) const;  ///< index or -1
};

/// \pre the template passed checkTemplate.
TemplateAnalysis analyse(const Template& tmpl);

}  // namespace ew
