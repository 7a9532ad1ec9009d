// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/wire_proposals.h"

#include <algorithm>
#include <cmath>

#include "core/reading/solve/simple_pieces.h"
#include "core/reading/solve/wire_faces.h"
#include "core/reading/solve/wire_lift.h"
#include "core/reading/types/reading_params.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The corners of a drawing, crossings left out, and faces between them.
bool build(const LineDrawing& wires, const WireLift& lift, const std::vector<WireFace>& faces,
           ShapeHypothesis& h) {
    h.family = "polyhedron";
    std::vector<int> vertex(wires.nodes.size(), -1);
    for (std::size_t v = 0; v < wires.nodes.size(); ++v) {
        if (wires.nodes[v].out.empty()) continue;
        vertex[v] = static_cast<int>(h.rough.vertices.size());
        h.rough.vertices.push_back(lift.points[v]);
        h.node.push_back(static_cast<int>(v));
    }
    for (std::size_t k = 0; k < faces.size(); ++k) {
        auto pieces = simplePieces(lift.points, faces[k].loops);
        if (pieces.empty()) return false;
        for (std::vector<int>& piece : pieces) {
            for (int& v : piece) v = vertex[at(v)];
            h.rough.faces.push_back(std::move(piece));
            h.pieceOf.push_back(static_cast<int>(k));
        }
    }
    return true;
}

}  // namespace

std::vector<ShapeHypothesis> wireProposals(const LineDrawing& wires, const AxisFrame& frame,
                                           double spreadPx) {
    std::vector<ShapeHypothesis> out;
    std::optional<double> best;
    for (const WireLift& lift : liftWires(wires, frame, spreadPx)) {
        for (const std::vector<WireFace>& faces : wireFaces(wires, frame, lift, spreadPx)) {
            ShapeHypothesis h;
            if (!build(wires, lift, faces, h)) continue;
            if (!best) best = lift.rank;
            h.frame = frame.axes;
            h.price = params::kFreedomCost * (*best - lift.rank);
            out.push_back(std::move(h));
        }
    }
    return out;
}

double seenFromBelow(const ShapeHypothesis& h) {
    constexpr double kUpright = 0.1;  // tangent
    double below = 0.0;
    double all = 0.0;
    for (const std::vector<int>& loop : h.rough.faces) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec3 d =
                h.rough.vertices[at(loop[(k + 1) % loop.size()])] - h.rough.vertices[at(loop[k])];
            if (std::abs(d.x()) > kUpright * std::abs(d.y())) continue;
            all += d.norm();
            // y is down and z away from the eye.
            if (d.y() * d.z() < 0.0) below += d.norm();
        }
    }
    return all > 0.0 ? below / all : 0.0;
}

}  // namespace ew
