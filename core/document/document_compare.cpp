// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document_compare.h"

#include <algorithm>

#include "core/document/store.h"
#include "core/tlib/template_io.h"

namespace ew {

namespace {

bool sameInk(const Stroke& a, const Stroke& b) {
    return std::equal(a.samples.begin(), a.samples.end(), b.samples.begin(), b.samples.end(),
                      [](const PenSample& x, const PenSample& y) {
                          return x.position == y.position && x.pressure == y.pressure &&
                                 x.timeMs == y.timeMs;
                      });
}

}  // namespace

bool identicalStates(const DocumentState& a, const DocumentState& b) {
    const auto sameMapped = [](const MappedStroke& x, const MappedStroke& y) {
        return x.color == y.color && x.camera == y.camera && sameInk(x.stroke, y.stroke);
    };
    const auto sameBody = [](const Body& x, const Body& y) {
        return x.solid.identicalTo(y.solid) && x.pose.rotation == y.pose.rotation &&
               x.pose.translation == y.pose.translation && x.name == y.name && x.hidden == y.hidden;
    };
    const auto sameTemplate = [&](const std::string& id) {
        const int x = a.library.find(id);
        const int y = b.library.find(id);
        return x >= 0 && y >= 0 &&
               writeTemplate(a.library.at(static_cast<std::size_t>(x))) ==
                   writeTemplate(b.library.at(static_cast<std::size_t>(y)));
    };
    return a.addedTemplates == b.addedTemplates &&
           std::all_of(a.addedTemplates.begin(), a.addedTemplates.end(), sameTemplate) &&
           a.surface == b.surface && a.mirror == b.mirror &&
           std::equal(a.mapped.begin(), a.mapped.end(), b.mapped.begin(), b.mapped.end(),
                      sameMapped) &&
           std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(), sameBody);
}

bool identicalDocuments(const Document& a, const Document& b) {
    const DocumentFile x = a.contents();
    const DocumentFile y = b.contents();
    const auto sameStep = [](const StoredCommand& p, const StoredCommand& q) {
        return p.name == q.name && identicalStates(*p.after, *q.after);
    };
    const auto samePending = [](const PendingStroke& p, const PendingStroke& q) {
        return p.camera == q.camera && sameInk(p.stroke, q.stroke);
    };
    return x.index == y.index && x.names == y.names && identicalStates(*x.first, *y.first) &&
           std::equal(x.commands.begin(), x.commands.end(), y.commands.begin(), y.commands.end(),
                      sameStep) &&
           std::equal(a.pendingStrokes().begin(), a.pendingStrokes().end(),
                      b.pendingStrokes().begin(), b.pendingStrokes().end(), samePending);
}

}  // namespace ew
