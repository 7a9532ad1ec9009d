// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/document/fixtures.h"

#include <QUndoStack>
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

const TemplateLibrary& shippedLibrary() {
    static const TemplateLibrary kLibrary =
        loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates")->library;
    return kLibrary;
}

std::unique_ptr<Document> fakeDocument() {
    return std::make_unique<Document>(smallLibrary(), &fakeInterpreter);
}

namespace {

/// Deeds of doSomething() that have to do with the surface.
void changeSurface(Document& d, int what, int number) {
    const auto ignore = [](const auto&) {};
    EdgeChoice edges;
    edges.which = static_cast<EdgeChoice::Which>(number % 4);
    for (int i = 0; i <= number % 3; ++i)
        edges.picked.push_back({number % 2, (number + 5 * i) % 12});
    const double n = number;
    switch (what) {
        case 16: {
            FilletRequest request{edges, 0.05 + n / 20, std::nullopt, number % 5 == 0};
            if (number % 3 == 0) request.segments = 1 + number % 4;
            ignore(d.fillet(request));
            break;
        }
        case 17:
            ignore(d.mapStrokes({static_cast<std::uint8_t>(number), 0, 99}));
            break;
        case 18: {
            SubdivisionSettings s;
            s.on = number % 4 != 0;
            s.scheme = number % 2 == 0 ? SubdivisionScheme::Loop : SubdivisionScheme::CatmullClark;
            s.levels = 1 + number % 2;
            if (number % 7 == 0) s.tolerance = 0.5;
            if (number % 3 == 0) s.sharpness = n / 7;
            s.sharpCorners = number % 5 == 0;
            ignore(d.subdivide(s, number % 6 == 0));
            break;
        }
        case 19:
            ignore(number % 3 == 0 ? d.unmapStrokes() : d.sharpen(edges));
            break;
        default:
            ignore(d.crease(edges, number % 4 == 0 ? kAutomaticSharpness : n / 4));
            break;
    }
}

/// Deeds that have to do with whole bodies.
void changeBodies(Document& d, int what, int number) {
    const auto ignore = [](const auto&) {};
    const int body = number % 3;
    const double n = number;
    switch (what) {
        case 25: {
            BodyMove move;
            if (number % 4 == 0) move.degrees = 90 + n / 3;
            if (number % 5 == 0) move.mirror = BodyMove::Mirror{Vec3(n, 1, 2), Vec3(1, n, 0.5)};
            if (number % 3 == 0) move.scale = Vec3(1 + n / 40, 1, 0.75);
            move.translate = Vec3(n / 3, -n, 0.1);
            move.copy = number % 7 == 0;
            ignore(d.moveBody(body, move));
            break;
        }
        case 26:
            ignore(d.pull({{body, number % 7},
                           (n - 12) / 3,
                           number % 2 == 0 ? PullWalls::Follow : PullWalls::Straight}));
            break;
        case 27:
            ignore(d.nameBody(body, number % 4 == 0 ? "" : "K\xc3\xb6rper " + std::to_string(n)));
            break;
        case 28:
            ignore(d.showBody(body, number % 2 == 0));
            break;
        case 29:
            if (number % 2 == 0) ignore(d.deleteBody(body));
            break;
        default:
            ignore(d.combineBodies(body, number % 2,
                                   number % 5 == 0 ? BooleanKind::Cut : BooleanKind::Add));
            break;
    }
}

}  // namespace

void doSomething(Document& d, int what, int number) {
    const double n = number;
    const auto ignore = [](const auto&) {};
    switch (what) {
        case 0:
        case 1:
        case 2:
            ignore(d.addStroke(line({n / 3, 5}, {n * 1.1, 100 / (1 + n)})));
            break;
        case 3:
        case 4:
        case 5: {
            ApplyRequest request;
            if (number % 2 == 0) request.candidate = 1;
            ignore(d.apply(request));
            break;
        }
        case 6:
            ignore(d.undo(1 + number % 3));
            break;
        case 7:
            ignore(d.redo(1 + number % 2));
            break;
        case 8:
            ignore(d.eraseAt({n / 3, 5}));
            break;
        case 9: {
            OrthographicCamera c = d.camera();
            c.center.x() += 1 / (n + 0.7);
            c.direction = Vec3(n + 1, 2, -3).normalized();
            ignore(d.setCamera(c));
            break;
        }
        case 10: {
            const std::string id = "t" + std::to_string(number % 5);
            ignore(d.defineTemplate(test::boxTemplate(id, "T \xc3\xa4 " + id)));
            break;
        }
        case 11:
            ignore(d.chooseReading(number % 2));
            break;
        case 12:
            ignore(d.setThresholds({5 + n / 7, 5 + n / 11}));
            break;
        case 13:
            d.setObliqueFactor(0.1 + n / 50);
            break;
        case 14:
            ignore(d.deleteBodies());
            break;
        case 15:
            d.undoInk();
            break;
        case 21:
            d.redoInk();
            break;
        case 22:
            ignore(d.goToStep(number % (d.undoStack().count() + 1)));
            break;
        case 23:
            ignore(d.nameState(number % (d.undoStack().count() + 1),
                               number % 4 == 0 ? "" : "N\xc3\xa4me " + std::to_string(number)));
            break;
        case 24:
            if (number % 3 == 0) ignore(d.compactHistory());
            break;
        default:
            if (what > 24)
                changeBodies(d, what, number);
            else
                changeSurface(d, what, number);
            break;
    }
}

bool sameState(const DocumentState& a, const DocumentState& b) {
    const bool sameMapped = std::equal(
        a.mapped.begin(), a.mapped.end(), b.mapped.begin(), b.mapped.end(),
        [](const MappedStroke& x, const MappedStroke& y) {
            return x.color == y.color && x.camera == y.camera &&
                   std::equal(x.stroke.samples.begin(), x.stroke.samples.end(),
                              y.stroke.samples.begin(), y.stroke.samples.end(),
                              [](const PenSample& p, const PenSample& q) {
                                  return p.position == q.position && p.pressure == q.pressure;
                              });
        });
    return a.addedTemplates == b.addedTemplates && a.library.size() == b.library.size() &&
           a.surface == b.surface && sameMapped &&
           std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(),
                      [](const Body& x, const Body& y) {
                          return x.solid.identicalTo(y.solid) &&
                                 x.pose.rotation == y.pose.rotation && x.name == y.name &&
                                 x.hidden == y.hidden && x.pose.translation == y.pose.translation;
                      });
}

}  // namespace ew::test
