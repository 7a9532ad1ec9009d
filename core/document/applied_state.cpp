// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/applied_state.h"

#include "core/document/mirrored_state.h"
#include "core/solid/polyhedron_spec.h"

namespace ew {

namespace {

/// "Create cube" out of "Cube", but "Create L-prism" out of "L-prism".
QString inSentence(const std::string& name) {
    const QString text = QString::fromStdString(name);
    const bool word = text.size() > 1 && text[1].isLower();
    return word ? text.left(1).toLower() + text.mid(1) : text;
}

Result<std::shared_ptr<const DocumentState>> split(const DocumentState& before,
                                                   const Candidate& candidate, SplitKeep keep) {
    const auto body = static_cast<std::size_t>(candidate.body);
    if (candidate.body < 0 || body >= before.bodies.size() || !candidate.result ||
        !candidate.rest) {
        return fail(Errc::OperationImpossible, "There is no such solid to change.");
    }
    auto after = std::make_shared<DocumentState>(before);
    const Body old = before.bodies[body];
    const EdgeSettings settings = edgesOf(before, candidate.body);
    auto& edges = after->surface.edges;
    edges.resize(after->bodies.size());
    const Solid& stays = keep == SplitKeep::Smaller ? *candidate.rest : *candidate.result;
    after->bodies[body].solid = stays;
    edges[body] = carriedOver(old.solid, settings, stays);
    if (keep == SplitKeep::Both) {
        after->bodies.push_back({*candidate.rest, old.pose});
        edges.push_back(carriedOver(old.solid, settings, *candidate.rest));
    }
    after->surface.tidy();
    return std::shared_ptr<const DocumentState>(std::move(after));
}

}  // namespace

EdgeSettings edgesOf(const DocumentState& state, int body) {
    const auto place = static_cast<std::size_t>(body);
    return place < state.surface.edges.size() ? state.surface.edges[place] : EdgeSettings{};
}

Result<std::shared_ptr<const DocumentState>> withCandidate(const DocumentState& before,
                                                           const Candidate& candidate,
                                                           SplitKeep keep) {
    if (candidate.operation == Operation::Split) return split(before, candidate, keep);
    auto after = std::make_shared<DocumentState>(before);
    if (candidate.operation == Operation::Add || candidate.operation == Operation::Cut) {
        const auto body = static_cast<std::size_t>(candidate.body);
        if (candidate.body < 0 || body >= before.bodies.size() || !candidate.result) {
            return fail(Errc::OperationImpossible, "There is no such solid to change.");
        }
        after->bodies[body].solid = *candidate.result;
        auto& edges = after->surface.edges;
        if (body < edges.size()) {
            edges[body] = carriedOver(before.bodies[body].solid, edges[body], *candidate.result);
            after->surface.tidy();
        }
        return std::shared_ptr<const DocumentState>(std::move(after));
    }
    if (!candidate.pose.rotation.allFinite() || !candidate.pose.translation.allFinite()) {
        return fail(Errc::NoSolution, "The solid has no place in the world.");
    }
    // What stands apart becomes a body of its own.
    for (const PolyhedronSpec& spec : separateBodies(candidate.spec)) {
        auto solid = Solid::fromSpec(spec);
        if (!solid) return fail(solid.error());
        after->bodies.push_back({*std::move(solid), candidate.pose});
    }
    return std::shared_ptr<const DocumentState>(std::move(after));
}

Result<std::shared_ptr<const DocumentState>> withCandidate(const DocumentState& before,
                                                           const Candidate& candidate,
                                                           SplitKeep keep, double reach) {
    auto after = withCandidate(before, candidate, keep);
    if (!after || !before.mirror) return after;
    return withMirrorImage(before, *std::move(after), candidate, reach);
}

QString commandName(const Candidate& candidate) {
    const QString name = inSentence(candidate.templateName);
    switch (candidate.operation) {
        case Operation::Add:
            return QStringLiteral("Add %1").arg(name);
        case Operation::Cut:
            return QStringLiteral("Cut %1").arg(name);
        case Operation::Split:
            return QStringLiteral("Cut in two");
        default:
            return QStringLiteral("Create %1").arg(name);
    }
}

}  // namespace ew
