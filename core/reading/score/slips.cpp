// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/score/slips.h"

#include <algorithm>

#include "core/reading/types/reading_params.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The lines that do not end at this vertex.
Sighting withoutVertex(Sighting sighting, int vertex) {
    std::erase_if(sighting.edges, [vertex](const DrawnEdge& d) {
        return d.vertex[0] == vertex || d.vertex[1] == vertex;
    });
    sighting.seen[at(vertex)] = false;
    return sighting;
}

}  // namespace

std::optional<Slip> movedCorner(const Sighting& sighting, const LibraryEntry& entry, double noisePx,
                                double cornerPx, double leastPx) {
    const RectilinearStructure& r = *entry.analysis.rectilinear;
    const std::size_t count = entry.tmpl.shape.vertices.size();
    const double planes = r.planeCount[0] + r.planeCount[1] + r.planeCount[2];
    std::optional<Slip> best;
    for (std::size_t v = 0; v < count; ++v) {
        if (!sighting.seen[v]) continue;
        const auto vertex = static_cast<int>(v);
        const Sighting rest = withoutVertex(sighting, vertex);
        // Four lines would fit whatever is drawn.
        if (rest.edges.size() < 5) continue;
        const auto picture = fitAffine(rest, entry.analysis);
        if (!picture || picture->unseenPlanes > 0 || !cornerDepths(picture->axes)) continue;
        const Vec2 meant = picture->at(r, v);
        const double off = (meant - sighting.vertexPx[v]).norm();
        if (off < leastPx || off > params::kSlipMost * leastPx) continue;
        const Misfit misfit = misfitOf(sighting, entry.analysis, picturePoints(*picture, r),
                                       noisePx, cornerPx, vertex);
        const double cost =
            misfit.cost + params::kFreedomCost * (2.0 + planes + 2.0) + params::kSlipCost;
        if (best && best->cost <= cost) continue;
        best = Slip{Errc::NotParallel, sighting.vertexPx[v], meant,          cost,
                    misfit.perEnd,     entry.tmpl.id,        entry.tmpl.name};
    }
    return best;
}

const Slip* likeliestSlip(const std::vector<Slip>& slips, const std::string& templateId,
                          double below) {
    const Slip* best = nullptr;
    for (const Slip& s : slips) {
        if (s.templateId == templateId || s.cost >= below || s.misfit > params::kSlipFit) continue;
        if (best == nullptr || s.cost < best->cost) best = &s;
    }
    return best;
}

}  // namespace ew
