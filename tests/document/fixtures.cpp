// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/document/fixtures.h"

#include <algorithm>

namespace ew::test {

PolyhedronSpec cornerBox(double x, double y, double z) {
    PolyhedronSpec spec;
    for (int i = 0; i < 8; ++i) {
        spec.vertices.emplace_back((i & 1) != 0 ? x : 0.0, (i & 2) != 0 ? y : 0.0,
                                   (i & 4) != 0 ? z : 0.0);
    }
    spec.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return spec;
}

Template boxTemplate(const std::string& id, const std::string& name) {
    Template t;
    t.id = id;
    t.name = name;
    t.shape = cornerBox(1, 1, 1);
    t.relations.parallel = {{{0, 1}, {2, 3}, {4, 5}, {6, 7}},
                            {{0, 2}, {1, 3}, {4, 6}, {5, 7}},
                            {{0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    t.relations.perpendicular = {{{{0, 1}, {0, 2}}}, {{{0, 1}, {0, 4}}}, {{{0, 2}, {0, 4}}}};
    return t;
}

Stroke line(const Vec2& from, const Vec2& to) {
    Stroke s;
    s.samples = {{from, 1.0, 0.0}, {to, 1.0, 0.0}};
    return s;
}

Interpretation fakeInterpreter(const std::vector<Stroke>& strokes, const TemplateLibrary&,
                               const InterpretOptions& options) {
    Interpretation r;
    if (strokes.empty()) {
        r.problem = Error{Errc::EmptySketch, "Nothing is drawn yet.", {}};
        return r;
    }
    if (strokes.size() == 3) {
        r.problem = Error{Errc::NoMatch, "No template matches.", {strokes[0].samples[0].position}};
        return r;
    }
    const auto& samples = strokes.front().samples;
    const Vec2 extent = (samples.back().position - samples.front().position).cwiseAbs();
    const double height = 1.0 + static_cast<double>(strokes.size());
    r.graph.junctions = {{samples.front().position}, {samples.back().position}};
    GraphEdge edge;
    edge.ends = {0, 1};
    edge.strokes = {0};
    r.graph.edges = {edge};
    r.graph.noise = {{NoiseKind::Dot, 1, {}}, {NoiseKind::Overshoot, 0, {}}};
    for (const double factor : {1.0, 1.0 + options.obliqueFactor}) {
        Candidate c;
        c.templateId = "box";
        c.templateName = "Box";
        c.aspect = "explicit-3";
        c.readingId = factor == 1.0 ? "default" : "oblique";
        c.score = 1.0 / factor;
        c.residualPx = 0.25;
        c.spec = cornerBox(1 + extent.x(), 1 + extent.y(), height * factor);
        c.pose.translation = Vec3(10, 20, 30);
        r.candidates.push_back(std::move(c));
    }
    if (strokes.size() == 2) {
        r.problem = Error{Errc::Ambiguous, "Two readings are as good as each other.", {}};
    } else {
        r.accepted = 0;
    }
    return r;
}

TemplateLibrary smallLibrary() {
    auto library = TemplateLibrary().with(boxTemplate("box", "Box"));
    return library ? *library : TemplateLibrary();
}

std::unique_ptr<Document> fakeDocument() {
    return std::make_unique<Document>(smallLibrary(), &fakeInterpreter);
}

bool sameState(const DocumentState& a, const DocumentState& b) {
    return a.addedTemplates == b.addedTemplates && a.library.size() == b.library.size() &&
           std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(),
                      [](const Body& x, const Body& y) {
                          return x.solid.identicalTo(y.solid) &&
                                 x.pose.rotation == y.pose.rotation &&
                                 x.pose.translation == y.pose.translation;
                      });
}

}  // namespace ew::test
