// SPDX-License-Identifier: GPL-3.0-or-later
// Commands on whole bodies and their faces.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "core/document/applied_state.h"
#include "core/document/document.h"
#include "core/document/document_private.h"
#include "core/document/json_text.h"
#include "core/document/mirrored_state.h"
#include "core/solid/exact_tool.h"
#include "core/solid/mirror.h"
#include "core/solid/transform.h"

namespace ew {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Result<void> checkBody(const DocumentState& state, int body) {
    if (state.bodies.empty()) return fail(Errc::NoSolid, "There is no solid yet.");
    if (body >= 0 && at(body) < state.bodies.size()) return {};
    return fail(Errc::BadValue, "There is no solid number " + std::to_string(body) +
                                    "; there are " + std::to_string(state.bodies.size()) +
                                    ", counted from 0.");
}

void setEdges(DocumentState& state, int body, EdgeSettings edges) {
    auto& all = state.surface.edges;
    if (all.size() <= at(body)) all.resize(at(body) + 1);
    all[at(body)] = std::move(edges);
    state.surface.tidy();
}

/// What was set for edges, where a solid has become one with the same corners and edges.
/// \param scale  of the radii.
EdgeSettings sameEdges(const Solid& before, const EdgeSettings& settings, const Solid& after,
                       double scale) {
    std::map<std::pair<int, int>, std::size_t> places;
    for (std::size_t e = 0; e < before.edges().size(); ++e) {
        places[std::minmax(before.edges()[e].ends[0], before.edges()[e].ends[1])] = e;
    }
    EdgeSettings out;
    const auto carry = [&](const std::vector<double>& from, double by) {
        std::vector<double> to;
        for (std::size_t e = 0; !from.empty() && e < after.edges().size(); ++e) {
            const auto& ends = after.edges()[e].ends;
            to.push_back(from[places.at(std::minmax(ends[0], ends[1]))] * by);
        }
        return to;
    };
    out.radii = carry(settings.radii, scale);
    out.sharpness = carry(settings.sharpness, 1.0);
    return out;
}

/// What one of two solids that became one had set and the other had not.
EdgeSettings joined(EdgeSettings a, const EdgeSettings& b) {
    const auto fill = [](std::vector<double>& to, const std::vector<double>& from, double none) {
        if (to.empty()) {
            to = from;
            return;
        }
        for (std::size_t e = 0; e < from.size(); ++e) {
            if (to[e] == none) to[e] = from[e];
        }
    };
    fill(a.radii, b.radii, 0.0);
    fill(a.sharpness, b.sharpness, kAutomaticSharpness);
    return a;
}

/// Another body's solid in the frame of this one, exactly up to the poses' own rounding.
Result<Solid> inFrameOf(const Body& body, const Body& other) {
    const Mat3 turn = body.pose.rotation == other.pose.rotation
                          ? Mat3(Mat3::Identity())
                          : Mat3(body.pose.rotation.transpose() * other.pose.rotation);
    const Vec3 shift = body.pose.toBody(other.pose.translation);
    if (turn == Mat3::Identity() && shift == Vec3::Zero()) return other.solid;
    return transformed(other.solid, turn, shift);
}

/// The same where it lies in the planes of the body that it nearly lies in; nothing where that
/// cannot be.
std::optional<Solid> snappedTo(const Solid& target, const Solid& tool) {
    ToolSpec spec;
    spec.shape.vertices = tool.vertices();
    for (const SolidFace& f : tool.faces()) {
        if (f.loops.size() > 1) return std::nullopt;
        spec.shape.faces.push_back(f.loops.front());
    }
    spec.snap = true;
    auto made = makeTool(target, spec);
    if (!made) return std::nullopt;
    return *std::move(made);
}

Result<BooleanOutcome> combined(const Body& body, const Solid& tool, BooleanKind kind) {
    auto made = combine(body.solid, tool, kind);
    if (made || made.error().code != Errc::Sliver) return made;
    // Bodies that were put side by side meet up to a rounding only.
    const auto snapped = snappedTo(body.solid, tool);
    return snapped ? combine(body.solid, *snapped, kind) : made;
}

/// Pulls the mirror image of a face, or of an outline in it, of what was pulled.
Result<void> pullMirrorImage(const DocumentState& before, const PullRequest& request,
                             DocumentState& after) {
    const int body = request.face.body;
    const Body& old = before.bodies[at(body)];
    const MirrorPlane& plane = *before.mirror;
    const Vec3 normal = old.pose.rotation * old.solid.faces()[at(request.face.face)].normal;
    const Vec3 point = request.outline ? request.outline->at : pointInFace(old, request.face.face);
    const auto face = mirrorFace(after.bodies, body, point, normal, plane);
    // A face that lies across the plane is its own image, and was pulled.
    if (!face) return {};
    Body& now = after.bodies[at(body)];
    Result<PullOutcome> made = fail(Errc::NoChange, "");
    if (request.outline) {
        const MirrorPlane inside = inBody(plane, now.pose);
        std::vector<Vec3> corners;
        for (const Vec3& p : request.outline->profile.corners) corners.push_back(inside.image(p));
        std::reverse(corners.begin(), corners.end());
        made = pullProfile(now.solid, *face, corners, request.distance);
    } else {
        made = pullFace(now.solid, *face, request.distance, request.walls);
    }
    // An outline across the plane is its own image, too.
    if (!made && made.error().code == Errc::NoChange) return {};
    if (!made) return fail(made.error());
    const EdgeSettings edges = edgesOf(after, body);
    setEdges(after, body,
             made->slid ? sameEdges(now.solid, edges, made->solid, 1.0)
                        : carriedOver(now.solid, edges, made->solid));
    now.solid = std::move(made->solid);
    return {};
}

}  // namespace

Result<OutlineOnFace> Document::outlineAt(const Vec3& world) const {
    const auto& pending = d_->ink.strokes();
    if (pending.empty()) return fail(Errc::EmptySketch, "Nothing is drawn yet.");
    InterpretOptions options;
    options.thresholds = d_->view.thresholds;
    options.camera = pending.back().camera;
    std::vector<int> places;
    std::tie(options.bodies, places) = visibleBodies(d_->state->bodies);
    std::vector<Stroke> strokes;
    for (const PendingStroke& s : pending) strokes.push_back(s.stroke);
    auto profile = readProfile(strokes, options, options.camera.project(world));
    if (!profile) return fail(profile.error());
    OutlineOnFace out{*std::move(profile), world, {}};
    out.profile.body = places[at(out.profile.body)];
    for (const int i : out.profile.strokes) out.strokes.push_back(pending[at(i)].id);
    return out;
}

Result<std::shared_ptr<const DocumentState>> Document::pulled(const PullRequest& request) const {
    const DocumentState& before = *d_->state;
    const int body = request.face.body;
    if (auto ok = checkBody(before, body); !ok) return fail(ok.error());
    const Solid& solid = before.bodies[at(body)].solid;
    auto made = request.outline
                    ? pullProfile(solid, request.face.face, request.outline->profile.corners,
                                  request.distance)
                    : pullFace(solid, request.face.face, request.distance, request.walls);
    if (!made) return fail(made.error());
    auto after = std::make_shared<DocumentState>(before);
    const EdgeSettings edges = edgesOf(before, body);
    setEdges(*after, body,
             made->slid ? sameEdges(solid, edges, made->solid, 1.0)
                        : carriedOver(solid, edges, made->solid));
    after->bodies[at(body)].solid = std::move(made->solid);
    if (before.mirror) {
        if (auto ok = pullMirrorImage(before, request, *after); !ok) return fail(ok.error());
    }
    return std::shared_ptr<const DocumentState>(std::move(after));
}

Result<void> Document::setMirror(const std::optional<MirrorPlane>& wanted) {
    std::optional<MirrorPlane> plane;
    if (wanted) {
        auto usable = mirrorPlane(wanted->point, wanted->normal);
        if (!usable) return fail(usable.error());
        plane = *usable;
    }
    if (plane == d_->state->mirror) {
        return fail(Errc::NoChange,
                    plane ? "This is the mirror plane already." : "There is no mirror plane.");
    }
    auto after = std::make_shared<DocumentState>(*d_->state);
    after->mirror = plane;
    d_->record(MirrorPlaneStep{plane});
    d_->push(plane ? QStringLiteral("Set mirror plane") : QStringLiteral("Drop mirror plane"),
             std::move(after), {});
    return {};
}

Result<void> Document::pull(const PullRequest& request) {
    auto after = pulled(request);
    if (!after) return fail(after.error());
    const std::vector<Body>& bodies = d_->state->bodies;
    PullStep step{pointInFace(bodies[at(request.face.body)], request.face.face), request.distance,
                  request.walls, std::nullopt};
    // A script finds a face of what is shown by itself.
    const bool named = bodies.size() > 1 || bodies[at(request.face.body)].hidden;
    if (named) step.body = BodyWord{request.face.body, {}};
    std::vector<PendingStroke> consumed;
    if (request.outline) {
        step.at = request.outline->at;
        const auto& ids = request.outline->strokes;
        for (const PendingStroke& s : d_->ink.strokes()) {
            if (std::find(ids.begin(), ids.end(), s.id) != ids.end()) consumed.push_back(s);
        }
    }
    // In a script, too, a face with an outline round the place is pulled by its outline.
    step.whole = !request.outline && outlineAt(step.at).has_value();
    d_->record(std::move(step));
    d_->push(QStringLiteral("Pull face"), *std::move(after), std::move(consumed));
    return {};
}

Result<int> Document::moveBody(int body, const BodyMove& move) {
    const DocumentState& before = *d_->state;
    if (auto ok = checkBody(before, body); !ok) return fail(ok.error());
    const Body& old = before.bodies[at(body)];
    auto moved = movedBody(old, move);
    if (!moved) return fail(moved.error());
    auto after = std::make_shared<DocumentState>(before);
    const double scale = std::cbrt(move.scale.prod());
    EdgeSettings edges = edgesOf(before, body);
    if (!moved->solid.sharesDataWith(old.solid)) {
        edges = sameEdges(old.solid, edges, moved->solid, scale);
    }
    int place = body;
    if (move.copy) {
        place = static_cast<int>(after->bodies.size());
        moved->name.clear();
        after->bodies.push_back(*std::move(moved));
    } else {
        after->bodies[at(body)] = *std::move(moved);
    }
    setEdges(*after, place, std::move(edges));
    d_->record(MoveBodyStep{BodyWord{body, {}}, move});
    d_->push(move.copy ? QStringLiteral("Copy solid") : QStringLiteral("Move solid"),
             std::move(after), {});
    return place;
}

Result<void> Document::nameBody(int body, const std::string& name) {
    const DocumentState& before = *d_->state;
    if (auto ok = checkBody(before, body); !ok) return ok;
    if (auto ok = checkBodyName(name); !ok) return ok;
    if (before.bodies[at(body)].name == name) return {};
    if (!name.empty()) {
        const auto known = findBody(before.bodies, name);
        if (known && *known != body) {
            return fail(Errc::DuplicateId, "Another solid is called " + nameQuoted(name) + ".");
        }
    }
    auto after = std::make_shared<DocumentState>(before);
    after->bodies[at(body)].name = name;
    d_->record(NameBodyStep{BodyWord{body, {}}, name});
    d_->push(QStringLiteral("Name solid"), std::move(after), {});
    return {};
}

Result<void> Document::showBody(int body, bool visible) {
    const DocumentState& before = *d_->state;
    if (auto ok = checkBody(before, body); !ok) return ok;
    if (before.bodies[at(body)].hidden != visible) {
        return fail(Errc::NoChange,
                    visible ? "The solid is shown already." : "The solid is hidden already.");
    }
    auto after = std::make_shared<DocumentState>(before);
    after->bodies[at(body)].hidden = !visible;
    d_->record(ShowBodyStep{BodyWord{body, {}}, visible});
    d_->push(visible ? QStringLiteral("Show solid") : QStringLiteral("Hide solid"),
             std::move(after), {});
    return {};
}

namespace {

void removeBody(DocumentState& state, int body) {
    state.bodies.erase(state.bodies.begin() + body);
    auto& edges = state.surface.edges;
    if (at(body) < edges.size()) edges.erase(edges.begin() + body);
    state.surface.tidy();
    if (!state.bodies.empty()) return;
    state.surface = {};
    state.mapped.clear();
}

}  // namespace

Result<void> Document::deleteBody(int body) {
    const DocumentState& before = *d_->state;
    if (auto ok = checkBody(before, body); !ok) return ok;
    auto after = std::make_shared<DocumentState>(before);
    removeBody(*after, body);
    d_->record(DeleteBodyStep{BodyWord{body, {}}});
    d_->push(QStringLiteral("Delete solid"), std::move(after), {});
    return {};
}

Result<void> Document::combineBodies(int body, int other, BooleanKind kind) {
    const DocumentState& before = *d_->state;
    for (const int b : {body, other}) {
        if (auto ok = checkBody(before, b); !ok) return ok;
    }
    if (body == other) return fail(Errc::BadValue, "A solid is combined with another one.");
    const Body& target = before.bodies[at(body)];
    const auto tool = inFrameOf(target, before.bodies[at(other)]);
    if (!tool) return fail(tool.error());
    auto made = combined(target, *tool, kind);
    if (!made) return fail(made.error());
    const int shells = target.solid.shellCount() + tool->shellCount();
    if (kind == BooleanKind::Add && made->solid.shellCount() == shells) {
        return fail(Errc::OperationImpossible, "The two solids do not touch each other.");
    }
    auto after = std::make_shared<DocumentState>(before);
    EdgeSettings edges = carriedOver(target.solid, edgesOf(before, body), made->solid);
    if (kind == BooleanKind::Add) {
        edges = joined(std::move(edges), carriedOver(*tool, edgesOf(before, other), made->solid));
    }
    setEdges(*after, body, std::move(edges));
    after->bodies[at(body)].solid = std::move(made->solid);
    removeBody(*after, other);
    d_->record(CombineBodiesStep{BodyWord{body, {}}, BodyWord{other, {}}, kind});
    d_->push(
        kind == BooleanKind::Add ? QStringLiteral("Join solids") : QStringLiteral("Subtract solid"),
        std::move(after), {});
    return {};
}

}  // namespace ew
