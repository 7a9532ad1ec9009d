// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/placement_tool.h"

#include <algorithm>
#include <cmath>

namespace ew {
namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

bool finishTool(Placement& p, const Template& tmpl, const ModelView& model) {
    ToolSpec& tool = p.tool;
    tool.shape.vertices.clear();
    tool.faces.clear();
    tool.shape.faces = tmpl.shape.faces;
    double volume = 0;
    for (const Vec3& x : p.points) tool.shape.vertices.push_back(model.toBody(x));
    for (const auto& loop : tool.shape.faces) {
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            const Vec3 o = tool.shape.vertices[at(loop[0])] - tool.shape.vertices[0];
            volume +=
                o.dot((tool.shape.vertices[at(loop[i])] - tool.shape.vertices[0])
                          .cross(tool.shape.vertices[at(loop[i + 1])] - tool.shape.vertices[0]));
        }
    }
    if (!std::isfinite(volume) || volume == 0.0) return false;
    if (volume < 0) {
        for (auto& loop : tool.shape.faces) std::reverse(loop.begin(), loop.end());
    }
    // What is nearer to the solid's planes and corners than anybody can draw lies in them.
    tool.snap = true;
    for (const auto& pair : p.coinciding) {
        tool.faces.push_back({pair[0], ToolFaceRule::Kind::InFace, pair[1]});
    }
    return true;
}

}  // namespace ew
