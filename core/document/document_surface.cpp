// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/document/document.h"
#include "core/document/document_private.h"
#include "core/document/mirrored_state.h"

namespace ew {

namespace {

QString counted(const QString& one, const QString& many, std::size_t count) {
    return count == 1 ? one : many.arg(count);
}

/// What a command changes, to find out whether the next one changes the same.
std::string keyOf(const char* word, const EdgeChoice& choice, const std::vector<EdgeRef>& edges) {
    std::string out = word;
    out += std::to_string(static_cast<int>(choice.which));
    if (choice.which != EdgeChoice::Which::Picked) return out;
    for (const EdgeRef& e : edges) {
        out += ' ' + std::to_string(e.body) + ':' + std::to_string(e.edge);
    }
    return out;
}

/// The choice as a script says it: edges by points on them.
EdgeWords edgeWords(const std::vector<Body>& bodies, const EdgeChoice& choice,
                    const std::vector<EdgeRef>& edges) {
    EdgeWords words;
    switch (choice.which) {
        case EdgeChoice::Which::All:
            words.which = EdgeWords::Which::All;
            return words;
        case EdgeChoice::Which::Convex:
            words.which = EdgeWords::Which::Convex;
            return words;
        case EdgeChoice::Which::Concave:
            words.which = EdgeWords::Which::Concave;
            return words;
        case EdgeChoice::Which::Picked:
            break;
    }
    words.which = EdgeWords::Which::Near;
    for (const EdgeRef& e : edges) {
        const auto point = pointNaming(bodies, e);
        const Body& body = bodies[static_cast<std::size_t>(e.body)];
        const auto& ends = body.solid.edges()[static_cast<std::size_t>(e.edge)].ends;
        const auto corner = [&](int i) {
            return body.pose.toWorld(body.solid.vertices()[static_cast<std::size_t>(i)]);
        };
        words.near.push_back(point.value_or(0.5 * (corner(ends[0]) + corner(ends[1]))));
        words.bodies.push_back(point ? -1 : e.body);
    }
    return words;
}

template <class Step>
Step stepFor(EdgeWords words, Step step) {
    static_cast<EdgeWords&>(step) = std::move(words);
    return step;
}

}  // namespace

// Private ----------------------------------------------------------------------------------------

std::shared_ptr<const DerivedShape> Document::Private::derive(const DocumentState& of) const {
    return std::make_shared<const DerivedShape>(
        deriveShape({of.bodies, of.surface, of.mapped, memoryLimit}, *cache));
}

Result<void> Document::Private::pushSettings(const Change& change, SurfaceSettings settings) {
    settings.tidy();
    auto after = std::make_shared<DocumentState>(*state);
    after->surface = std::move(settings);
    if (after->surface == state->surface) return {};
    auto derived = derive(*after);
    // What cannot be made now either must not keep the person from changing other things.
    if (derived->problem && !q.shape()->problem) return fail(*derived->problem);

    const std::shared_ptr<const DocumentState> shown = state;
    const auto* newest =
        stackIndex > 0 ? static_cast<const StateCommand*>(stack.command(stackIndex - 1)) : nullptr;
    if (change.replace && newest != nullptr && !change.key.empty() && newest->key == change.key) {
        movingStack = true;
        stack.undo();
        movingStack = false;
        stackIndex = stack.index();
        record(UndoStep{});
        if (after->surface == state->surface) {
            // Dragged back to where it was: nothing is left of the step.
            touch();
            stateChanged(*shown);
            return {};
        }
    }
    record(change.step);
    shapeOf = after;
    shape = std::move(derived);
    auto* command = new StateCommand(*this, change.name, state, after);  // the stack owns it
    command->key = change.key;
    command->inkBefore = ink.takeHistory();
    movingStack = true;
    stack.push(command);
    movingStack = false;
    stackIndex = stack.index();
    touch();
    stateChanged(*shown);
    return {};
}

// Document ---------------------------------------------------------------------------------------

Result<std::vector<EdgeRef>> Document::Private::edgesOnBothSides(const EdgeChoice& choice) const {
    auto edges = chosenEdges(state->bodies, choice);
    if (!edges || !state->mirror || choice.which != EdgeChoice::Which::Picked) return edges;
    return withMirrorEdges(state->bodies, *std::move(edges), *state->mirror);
}

Result<FilletOutcome> Document::fillet(const FilletRequest& request) {
    if (auto ok = checkRadius(request.radius); !ok) return fail(ok.error());
    if (request.segments) {
        if (auto ok = checkSegments(*request.segments); !ok) return fail(ok.error());
    }
    const auto edges = d_->edgesOnBothSides(request.edges);
    if (!edges) return fail(edges.error());
    SurfaceSettings settings = d_->state->surface;
    for (const EdgeRef& e : *edges) settings.setRadius(d_->state->bodies, e, request.radius);
    settings.segments = request.segments.value_or(settings.segments);
    FilletStep step = stepFor(edgeWords(d_->state->bodies, request.edges, *edges), FilletStep{});
    step.radius = request.radius;
    step.segments = request.segments;
    const QString name =
        counted(QStringLiteral("Fillet 1 edge"), QStringLiteral("Fillet %1 edges"), edges->size());
    const auto pushed = d_->pushSettings(
        {name, keyOf("fillet", request.edges, *edges), request.replace, std::move(step)},
        std::move(settings));
    if (!pushed) return fail(pushed.error());
    return FilletOutcome{static_cast<int>(edges->size()), shape()->clamped};
}

Result<void> Document::sharpen(const EdgeChoice& choice) {
    const auto edges = d_->edgesOnBothSides(choice);
    if (!edges) return fail(edges.error());
    SurfaceSettings settings = d_->state->surface;
    std::size_t count = 0;
    for (const EdgeRef& e : *edges) {
        if (settings.radius(e) == 0.0) continue;
        settings.setRadius(d_->state->bodies, e, 0.0);
        ++count;
    }
    if (count == 0) return fail(Errc::NoEdge, "None of these edges is filleted.");
    return d_->pushSettings(
        {counted(QStringLiteral("Sharpen 1 edge"), QStringLiteral("Sharpen %1 edges"), count),
         keyOf("sharpen", choice, *edges), false,
         stepFor(edgeWords(d_->state->bodies, choice, *edges), SharpenStep{})},
        std::move(settings));
}

Result<void> Document::crease(const EdgeChoice& choice, double sharpness) {
    if (sharpness != kAutomaticSharpness) {
        if (auto ok = checkSharpness(sharpness); !ok) return ok;
    }
    const auto edges = d_->edgesOnBothSides(choice);
    if (!edges) return fail(edges.error());
    SurfaceSettings settings = d_->state->surface;
    for (const EdgeRef& e : *edges) settings.setSharpness(d_->state->bodies, e, sharpness);
    CreaseStep step = stepFor(edgeWords(d_->state->bodies, choice, *edges), CreaseStep{});
    if (sharpness != kAutomaticSharpness) step.sharpness = sharpness;
    return d_->pushSettings(
        {counted(QStringLiteral("Crease 1 edge"), QStringLiteral("Crease %1 edges"), edges->size()),
         keyOf("crease", choice, *edges), false, std::move(step)},
        std::move(settings));
}

Result<void> Document::subdivide(const SubdivisionSettings& wanted, bool replace) {
    if (d_->state->bodies.empty()) {
        return fail(Errc::NoSolid, "There is no solid to make a surface over yet.");
    }
    if (auto ok = checkSubdivision(wanted); !ok) return ok;
    SurfaceSettings settings = d_->state->surface;
    // What plays no part is set back, so that equal surfaces have equal settings.
    SubdivisionSettings& s = settings.subdivision;
    s = wanted;
    if (s.tolerance > 0.0) s.levels = SubdivisionSettings{}.levels;
    if (!s.on) {
        s = SubdivisionSettings{};
        s.scheme = wanted.scheme;
    }
    SubdivideStep step;
    step.scheme = s.scheme == SubdivisionScheme::Loop ? "loop" : "catmull-clark";
    if (s.on && s.tolerance > 0.0)
        step.tolerance = s.tolerance;
    else
        step.levels = s.on ? s.levels : 0;
    step.crease = s.sharpness;
    step.sharpCorners = s.sharpCorners;
    const QString name = s.on ? QStringLiteral("Smooth surface") : QStringLiteral("Surface off");
    return d_->pushSettings({name, s.on ? "subdivide" : "", replace, std::move(step)},
                            std::move(settings));
}

Result<MapOutcome> Document::mapStrokes(const StrokeColor& color) {
    const auto& pending = d_->ink.strokes();
    if (pending.empty()) return fail(Errc::EmptySketch, "Nothing is drawn yet.");
    if (d_->state->bodies.empty()) {
        return fail(Errc::NoSurface, "There is no surface under the strokes.");
    }
    auto after = std::make_shared<DocumentState>(*d_->state);
    const int before = static_cast<int>(after->mapped.size());
    for (const PendingStroke& s : pending) {
        after->mapped.push_back({s.id, s.stroke, s.camera, color});
    }
    const auto tried = d_->derive(*after);
    if (tried->problem && !shape()->problem) return fail(*tried->problem);
    MapOutcome outcome;
    std::vector<PendingStroke> consumed;
    for (std::size_t i = 0; i < pending.size(); ++i) {
        const int index = before + static_cast<int>(i);
        if (std::binary_search(tried->missed.begin(), tried->missed.end(), index)) {
            ++outcome.missed;
        } else {
            consumed.push_back(pending[i]);
        }
    }
    if (consumed.empty()) {
        return fail(Errc::NoSurface, "There is no surface under the strokes.",
                    {pending.front().stroke.samples.front().position});
    }
    after->mapped.resize(static_cast<std::size_t>(before));
    for (const PendingStroke& s : consumed) {
        after->mapped.push_back({s.id, s.stroke, s.camera, color});
    }
    outcome.mapped = static_cast<int>(consumed.size());
    MapStrokesStep step;
    if (color != kDefaultStrokeColor) step.color = colorText(color);
    d_->record(std::move(step));
    d_->push(
        counted(QStringLiteral("Map 1 stroke"), QStringLiteral("Map %1 strokes"), consumed.size()),
        std::move(after), consumed);
    return outcome;
}

Result<void> Document::unmapStrokes() {
    if (d_->state->mapped.empty()) {
        return fail(Errc::NoStroke, "There is no stroke on the surface.");
    }
    auto after = std::make_shared<DocumentState>(*d_->state);
    after->mapped.clear();
    d_->record(UnmapStrokesStep{});
    d_->push(QStringLiteral("Remove strokes from surface"), std::move(after), {});
    return {};
}

std::shared_ptr<const DerivedShape> Document::shape() const {
    if (d_->shapeOf != d_->state) {
        d_->shape = d_->derive(*d_->state);
        d_->shapeOf = d_->state;
    }
    return d_->shape;
}

ShapeInput Document::shapeInput() const {
    return {d_->state->bodies, d_->state->surface, d_->state->mapped, d_->memoryLimit};
}

const std::shared_ptr<ShapeCache>& Document::shapeCache() const { return d_->cache; }

void Document::setSurfaceMemoryLimit(std::size_t bytes) {
    if (bytes == d_->memoryLimit) return;
    d_->memoryLimit = bytes;
    // A surface that stands may be too large now, and one that was refused may fit.
    d_->shapeOf.reset();
    d_->emitChange(DocumentChange::Shape);
}

}  // namespace ew
