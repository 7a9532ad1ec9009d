// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/sketch_generator.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "tests/support/random_shapes.h"

namespace ew::test {
namespace {

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }
double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

double angleDeg(const Vec2& a, const Vec2& b) {
    return degrees(std::abs(std::atan2(cross2(a, b), a.dot(b))));
}

double distanceToSegment(const Vec2& p, const Line2& s) {
    const Vec2 d = s[1] - s[0];
    const double t = std::clamp((p - s[0]).dot(d) / d.squaredNorm(), 0.0, 1.0);
    return (p - (s[0] + t * d)).norm();
}

/// A place where visible edges end.
struct SeenJunction {
    Vec2 at = Vec2::Zero();
    int vertex = -1;                 ///< -1: a T junction
    std::vector<std::size_t> edges;  ///< visible edges that end here
    std::vector<Vec2> directions;    ///< unit, away from the junction, one an edge
};

std::vector<SeenJunction> seenJunctions(const VisibleDrawing& drawing) {
    std::vector<SeenJunction> out;
    for (std::size_t e = 0; e < drawing.edges.size(); ++e) {
        const VisibleEdge& edge = drawing.edges[e];
        for (std::size_t end = 0; end < 2; ++end) {
            const int vertex = edge.vertices[end];
            auto it = std::find_if(out.begin(), out.end(), [&](const SeenJunction& j) {
                return vertex >= 0 && j.vertex == vertex;
            });
            if (it == out.end()) it = out.insert(out.end(), {edge.line[end], vertex, {}, {}});
            it->edges.push_back(e);
            it->directions.push_back((edge.line[1 - end] - edge.line[end]).normalized());
        }
    }
    return out;
}

bool breaksJunctionRules(const VisibleDrawing& drawing, const ReadabilityRules& rules,
                         std::string& rule) {
    const std::vector<SeenJunction> junctions = seenJunctions(drawing);
    for (std::size_t i = 0; i < junctions.size(); ++i) {
        const SeenJunction& a = junctions[i];
        for (std::size_t k = i + 1; k < junctions.size(); ++k) {
            if ((a.at - junctions[k].at).norm() < rules.nearestJunctionsPx) {
                rule = "near-junctions";
                return true;
            }
        }
        for (std::size_t e = 0; e < drawing.edges.size(); ++e) {
            if (std::find(a.edges.begin(), a.edges.end(), e) != a.edges.end()) continue;
            const double d = distanceToSegment(a.at, drawing.edges[e].line);
            const bool bar = a.vertex < 0 && d < 1e-6;
            if (!bar && d < rules.nearestLinePx) {
                rule = "near-line";
                return true;
            }
            if (!bar) continue;
            const Line2& line = drawing.edges[e].line;
            const double angle = angleDeg(line[1] - line[0], a.directions[0]);
            if (std::min(angle, 180.0 - angle) < rules.sharpestDeg) {
                rule = "sharp-corner";
                return true;
            }
        }
        for (std::size_t m = 0; m < a.directions.size(); ++m) {
            for (std::size_t n = m + 1; n < a.directions.size(); ++n) {
                const double angle = angleDeg(a.directions[m], a.directions[n]);
                if (angle < rules.sharpestDeg) {
                    rule = "sharp-corner";
                    return true;
                }
                if (a.directions.size() == 2 && 180.0 - angle < rules.straightestDeg) {
                    rule = "straight-corner";
                    return true;
                }
            }
        }
    }
    return false;
}

/// True where all visible edges between base and top are parallel within the angle, so that the
/// frustum is drawn as a box. Vertices 0 to 3 are the base, 4 to 7 the top.
bool looksLikeBox(const VisibleDrawing& drawing, double parallelDeg) {
    std::vector<Vec2> slants;
    for (const VisibleEdge& e : drawing.edges) {
        const int low = std::min(e.vertices[0], e.vertices[1]);
        const int high = std::max(e.vertices[0], e.vertices[1]);
        if (low < 0 || low > 3 || high < 4) continue;
        slants.emplace_back(e.vertices[0] == low ? e.line[1] - e.line[0] : e.line[0] - e.line[1]);
    }
    for (const Vec2& a : slants) {
        for (const Vec2& b : slants) {
            if (angleDeg(a, b) >= parallelDeg) return false;
        }
    }
    return true;
}

/// The reentrant edge of prismSpec over the L polygon joins vertices 3 and 9.
bool seesNotch(const VisibleDrawing& drawing) {
    return std::any_of(drawing.vertices.begin(), drawing.vertices.end(),
                       [](int v) { return v == 3 || v == 9; });
}

std::optional<std::array<double, 3>> yAngles(const SketchCase& sketch) {
    std::optional<std::array<double, 3>> best;
    for (const SeenJunction& j : seenJunctions(sketch.drawing)) {
        if (j.vertex < 0 || j.directions.size() != 3) continue;
        std::array<double, 3> around{};
        for (std::size_t i = 0; i < 3; ++i) {
            around[i] = std::atan2(j.directions[i].y(), j.directions[i].x());
        }
        std::sort(around.begin(), around.end());
        const std::array<double, 3> angles{degrees(around[1] - around[0]),
                                           degrees(around[2] - around[1]),
                                           360.0 - degrees(around[2] - around[0])};
        const double widest = *std::max_element(angles.begin(), angles.end());
        if (widest >= 180.0) continue;
        if (!best || widest < *std::max_element(best->begin(), best->end())) best = angles;
    }
    return best;
}

/// Scales the shape about the origin so that its drawing has the wanted diagonal, and puts the
/// camera's centre in the middle of it.
void frame(SketchCase& sketch, double diagonalPx) {
    OrthographicCamera& camera = sketch.camera;
    Vec2 low, high;
    const auto measure = [&] {
        low = high = camera.project(sketch.spec.vertices.front());
        for (const Vec3& v : sketch.spec.vertices) {
            low = low.cwiseMin(camera.project(v));
            high = high.cwiseMax(camera.project(v));
        }
    };
    measure();
    const double factor = diagonalPx / (high - low).norm();
    for (Vec3& v : sketch.spec.vertices) v *= factor;
    measure();
    camera.center = camera.unproject((low + high) / 2.0);
}

SketchCase tryView(const std::string& id, Random& random) {
    SketchCase sketch;
    sketch.spec = randomShape(id, random);
    const double tilt = radians(random.uniform(15.0, 65.0));
    const double azimuth = random.uniform(0.0, 2.0 * std::numbers::pi);
    sketch.camera.direction = Vec3(-std::cos(azimuth) * std::cos(tilt),
                                   -std::sin(azimuth) * std::cos(tilt), -std::sin(tilt))
                                  .normalized();
    sketch.camera.worldPerPixel = 0.05 * std::pow(20.0, random.uniform());
    frame(sketch, random.uniform(150.0, 500.0));
    sketch.drawing = visibleEdges(sketch.spec, sketch.camera);
    sketch.truth.templateId = id;
    sketch.truth.vertices = static_cast<int>(sketch.spec.vertices.size());
    sketch.truth.edges = static_cast<int>(specEdges(sketch.spec).size());
    sketch.truth.faces = static_cast<int>(sketch.spec.faces.size());
    sketch.truth.volume = specVolume(sketch.spec);
    sketch.truth.yAnglesDeg = yAngles(sketch);
    return sketch;
}

void append(std::string& text, double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    text.append(buffer.data(), end);
}

void appendVector(std::string& text, const Vec3& v) {
    text += '[';
    for (int i = 0; i < 3; ++i) {
        if (i > 0) text += ", ";
        append(text, v[i]);
    }
    text += ']';
}

}  // namespace

int ReadabilityCounts::rejectedTotal() const {
    int sum = 0;
    for (const auto& [rule, count] : rejected) sum += count;
    return sum;
}

void ReadabilityCounts::add(const ReadabilityCounts& other) {
    tried += other.tried;
    for (const auto& [rule, count] : other.rejected) rejected[rule] += count;
}

const std::vector<std::string>& sketchTemplates() {
    static const std::vector<std::string> ids{"cube", "triangular-prism", "triangular-pyramid",
                                              "wedge-frustum", "l-prism"};
    return ids;
}

std::string unreadableBecause(const SketchCase& sketch, const ReadabilityRules& rules) {
    const std::string& id = sketch.truth.templateId;
    const bool needsThree = id == "cube" || id == "wedge-frustum";
    const int fewest = needsThree ? std::max(3, rules.fewestFaces) : rules.fewestFaces;
    if (static_cast<int>(sketch.drawing.faces.size()) < fewest) return "few-faces";
    for (const VisibleEdge& e : sketch.drawing.edges) {
        if ((e.line[1] - e.line[0]).norm() < rules.shortestEdgePx) return "short-edge";
    }
    std::string rule;
    if (breaksJunctionRules(sketch.drawing, rules, rule)) return rule;
    if (id == "l-prism" && !seesNotch(sketch.drawing)) return "no-notch";
    if (id == "wedge-frustum" && looksLikeBox(sketch.drawing, rules.frustumTaperDeg)) {
        return "looks-like-box";
    }
    return {};
}

SketchCase randomSketch(const std::string& id, Random& random, ReadabilityCounts* counts,
                        const ReadabilityRules& rules) {
    while (true) {
        SketchCase sketch = tryView(id, random);
        const std::string rule = unreadableBecause(sketch, rules);
        if (counts != nullptr) {
            ++counts->tried;
            if (!rule.empty()) ++counts->rejected[rule];
        }
        if (rule.empty()) return sketch;
    }
}

std::string sketchScriptText(const std::string& title, const OrthographicCamera& camera,
                             const Thresholds& thresholds, const std::vector<Stroke>& strokes) {
    std::string text =
        "{\n  \"format\": \"edgewright-sketch\",\n  \"version\": 1,\n  \"title\": \"";
    for (const char c : title) {
        if (c == '"' || c == '\\') text += '\\';
        text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    text += "\",\n  \"viewport\": [";
    append(text, camera.width);
    text += ", ";
    append(text, camera.height);
    text += "],\n  \"thresholds\": {\"distance_px\": ";
    append(text, thresholds.distancePx);
    text += ", \"angle_deg\": ";
    append(text, thresholds.angleDeg);
    text += "},\n  \"steps\": [\n    ";
    text += R"({"do": "camera", "direction": )";
    appendVector(text, camera.direction);
    text += ", \"up\": ";
    appendVector(text, camera.up);
    text += ", \"center\": ";
    appendVector(text, camera.center);
    text += ", \"world_per_pixel\": ";
    append(text, camera.worldPerPixel);
    text += "},\n";
    for (const Stroke& stroke : strokes) {
        text += R"(    {"do": "stroke", "points": [)";
        for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
            const PenSample& s = stroke.samples[i];
            text += i > 0 ? ", [" : "[";
            append(text, s.position.x());
            for (const double value : {s.position.y(), s.pressure, s.timeMs}) {
                text += ", ";
                append(text, value);
            }
            text += ']';
        }
        text += "]},\n";
    }
    text += "    {\"do\": \"apply\"}\n  ]\n}\n";
    return text;
}

}  // namespace ew::test
