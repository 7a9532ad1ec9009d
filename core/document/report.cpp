// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/report.h"

#include <QUndoStack>
#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "core/document/shape_reading.h"

namespace ew {

using Json = nlohmann::ordered_json;

namespace {

Json vec(const Vec2& v) { return {v.x(), v.y()}; }
Json vec(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json places(const std::vector<Vec2>& points) {
    Json list = Json::array();
    for (const Vec2& p : points) list.push_back(vec(p));
    return list;
}

/// Strokes that were dropped whole: of which nothing is in the graph.
std::size_t droppedStrokes(const EdgeGraph& graph) {
    std::set<int> dropped;
    for (const NoiseItem& item : graph.noise) {
        if (item.kind != NoiseKind::ModelEdge && item.stroke >= 0) dropped.insert(item.stroke);
    }
    for (const GraphEdge& edge : graph.edges) {
        for (const int stroke : edge.strokes) dropped.erase(stroke);
    }
    return dropped.size();
}

Json graphJson(const EdgeGraph& graph) {
    Json vertices = Json::array();
    for (const Junction& j : graph.junctions) vertices.push_back(vec(j.position));
    Json edges = Json::array();
    for (const GraphEdge& e : graph.edges) {
        const char* from = e.origin == EdgeOrigin::Model ? "model" : "stroke";
        edges.push_back({{"ends", {e.ends[0], e.ends[1]}}, {"from", from}});
    }
    int modelEdges = 0;
    for (const NoiseItem& item : graph.noise) modelEdges += item.kind == NoiseKind::ModelEdge;
    return {{"vertices", vertices},
            {"edges", edges},
            {"noise", {{"strokes", droppedStrokes(graph)}, {"model_edges", modelEdges}}}};
}

Json candidatesJson(const Interpretation& reading) {
    Json list = Json::array();
    for (const Candidate& c : reading.candidates) {
        list.push_back({{"template", c.templateId},
                        {"operation", operationName(c.operation)},
                        {"score", c.score},
                        {"probability", c.probability},
                        {"aspect", c.aspect},
                        {"reading", c.readingId}});
    }
    return list;
}

/// The T-LIB steps that a reading consists of, with the edges of the graph that they explain.
Json partsJson(const Interpretation& reading, const Candidate& c) {
    Json edges = Json::array();
    for (std::size_t e = 0; e < reading.graph.edges.size(); ++e) edges.push_back(e);
    return Json::array({Json{{"template", c.templateId},
                             {"operation", operationName(c.operation)},
                             {"edges", std::move(edges)}}});
}

Json matchJson(const Interpretation& reading, int chosen) {
    const Candidate& c = reading.candidates[static_cast<std::size_t>(chosen)];
    return {{"template", c.templateId},
            {"aspect", c.aspect},
            {"operation", operationName(c.operation)},
            {"score", c.score},
            {"residual_px", c.residualPx},
            {"reading", c.readingId},
            {"probability", c.probability},
            {"evidence",
             {{"fit", c.evidence.fit},
              {"stray", c.evidence.stray},
              {"bare", c.evidence.bare},
              {"freedoms", c.evidence.freedoms},
              {"prior", c.evidence.prior}}},
            {"notes", c.notes},
            {"camera", c.depth == DepthRule::Perspective ? "perspective" : "parallel"},
            {"parts", partsJson(reading, c)},
            {"candidates", candidatesJson(reading)}};
}

Json errorJson(const Error& error) {
    return {
        {"code", errcName(error.code)}, {"message", error.message}, {"where", places(error.where)}};
}

Json stepJson(const StepReport& step) {
    Json out{{"index", step.index}, {"do", step.name}, {"ok", step.ok}, {"ms", step.ms}};
    out["edge_graph"] = nullptr;
    out["match"] = nullptr;
    if (step.interpretation) {
        out["edge_graph"] = graphJson(step.interpretation->graph);
        if (step.chosen >= 0) {
            out["match"] = matchJson(*step.interpretation, step.chosen);
        } else if (!step.interpretation->candidates.empty()) {
            out["candidates"] = candidatesJson(*step.interpretation);
        }
    }
    out["error"] = nullptr;
    if (step.error) out["error"] = errorJson(*step.error);
    if (!step.notes.empty()) out["notes"] = step.notes;
    return out;
}

Json bodiesJson(const std::vector<Body>& bodies) {
    Json list = Json::array();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const SolidSummary s = summarize({bodies[b]});
        list.push_back({{"name", bodyName(bodies, b)},
                        {"visible", !bodies[b].hidden},
                        {"vertices", s.vertices},
                        {"edges", s.edges},
                        {"faces", s.faces},
                        {"shells", s.shells},
                        {"genus", s.genus},
                        {"closed", readsAsClosed({bodies[b]}, {BodyShape{}})},
                        {"volume", s.volume},
                        {"area", s.area},
                        {"bounds", {vec(s.bounds[0]), vec(s.bounds[1])}}});
    }
    return list;
}

Json solidJson(const std::vector<Body>& all) {
    const std::vector<Body> bodies = visibleBodies(all).first;
    if (bodies.empty()) return nullptr;
    const SolidSummary s = summarize(bodies);
    Json positions = Json::array();
    for (const Vec3& p : s.positions) positions.push_back(vec(p));
    return {{"vertices", s.vertices},
            {"edges", s.edges},
            {"faces", s.faces},
            {"shells", s.shells},
            {"genus", s.genus},
            {"closed", readsAsClosed(bodies, std::vector<BodyShape>(bodies.size()))},
            {"volume", s.volume},
            {"area", s.area},
            {"bounds", {vec(s.bounds[0]), vec(s.bounds[1])}},
            {"vertex_positions", positions}};
}

/// Surface or, without one, the filleted cage of every body together; bodies that have neither
/// count as they are. Nothing where there is neither.
Json surfaceJson(const Document& document) {
    const auto shape = document.shape();
    const DocumentState& state = document.state();
    const bool hasSurface = shape->hasSurface();
    std::size_t triangles = 0;
    double volume = 0.0;
    double deviation = 0.0;
    const bool any = hasSurface || shape->hasCage();
    if (any) {
        for (std::size_t b = 0; b < state.bodies.size(); ++b) {
            // A surface may be large: it is read where it is. Its pose changes no volume.
            if (state.bodies[b].hidden) continue;
            if (const auto& surface = shape->bodies[b].surface) {
                triangles += surface->triangles.size();
                volume += enclosedVolume(surface->positions, surface->triangles);
                deviation = std::max(deviation, estimatedDeviation(*surface));
                continue;
            }
            const ShapeMesh mesh = shapeMesh(state.bodies[b], shape->bodies[b]);
            triangles += mesh.triangles.size();
            volume += enclosedVolume(mesh.positions, mesh.triangles);
        }
    }
    const double tolerance = state.surface.subdivision.tolerance;
    if (tolerance > 0.0) deviation = std::min(deviation, tolerance);
    Json clamped = Json::array();
    for (const ClampedEdge& c : shape->clamped) {
        clamped.push_back({{"body", c.edge.body},
                           {"edge", c.edge.edge},
                           {"requested", c.requested},
                           {"used", c.used},
                           {"limiting_edge", c.limitingEdge},
                           {"limiting_vertex", c.limitingVertex}});
    }
    const bool closed = !any || readsAsClosed(state.bodies, shape->bodies);
    return {{"triangles", triangles},
            {"closed", closed},
            {"volume", volume},
            {"max_deviation", deviation},
            {"kind", hasSurface         ? "surface"
                     : shape->hasCage() ? "cage"
                                        : "none"},
            {"clamped", clamped},
            {"mapped_strokes", state.mapped.size()},
            {"mapped_curves", shape->curves.size()},
            {"problem", shape->problem ? errorJson(*shape->problem) : Json(nullptr)}};
}

}  // namespace

SolidSummary summarize(const std::vector<Body>& bodies) {
    SolidSummary sum;
    if (bodies.empty()) return sum;
    const double inf = std::numeric_limits<double>::infinity();
    sum.bounds = {Vec3::Constant(inf), Vec3::Constant(-inf)};
    for (const Body& body : bodies) {
        const Solid& solid = body.solid;
        sum.vertices += static_cast<int>(solid.vertices().size());
        sum.edges += static_cast<int>(solid.edges().size());
        sum.faces += static_cast<int>(solid.faces().size());
        sum.shells += solid.shellCount();
        sum.genus += solid.genus();
        sum.volume += solid.volume();
        sum.area += solid.area();
        for (const Vec3& v : solid.vertices()) {
            const Vec3 world = body.pose.toWorld(v);
            sum.positions.push_back(world);
            sum.bounds[0] = sum.bounds[0].cwiseMin(world);
            sum.bounds[1] = sum.bounds[1].cwiseMax(world);
        }
    }
    return sum;
}

std::string writeReport(const Document& document, const ReplayReport& report,
                        const std::string& scriptName) {
    Json steps = Json::array();
    for (const StepReport& step : report.steps) steps.push_back(stepJson(step));
    const QUndoStack& stack = document.undoStack();
    const Json out{{"format", "edgewright-report"},
                   {"version", 1},
                   {"script", scriptName},
                   {"steps", steps},
                   {"solid", solidJson(document.state().bodies)},
                   {"bodies", bodiesJson(document.state().bodies)},
                   {"surface", surfaceJson(document)},
                   {"undo", {{"index", stack.index()}, {"count", stack.count()}}},
                   {"ms_total", report.msTotal}};
    return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ew
