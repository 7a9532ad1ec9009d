// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/score/misfit.h"

#include <algorithm>
#include <cmath>

#include "core/reading/types/reading_params.h"

namespace ew {

Misfit misfitOf(const Sighting& sighting, const TemplateAnalysis& analysis,
                const CameraPoints& points, double noisePx, double cornerPx, int without) {
    const double variance = noisePx * noisePx + cornerPx * cornerPx;
    constexpr double kNu = params::kTailFreedoms;
    Misfit sum;
    std::size_t count = 0;
    for (const DrawnEdge& d : sighting.edges) {
        const auto& ends = analysis.edges[static_cast<std::size_t>(d.edge)].ends;
        const Vec2 a = points[static_cast<std::size_t>(ends[0])].head<2>();
        const Vec2 u = points[static_cast<std::size_t>(ends[1])].head<2>() - a;
        const double len = std::max(u.norm(), 1e-9);
        for (std::size_t side = 0; side < 2; ++side) {
            if (without >= 0 && d.vertex[side] == without) continue;
            const double off = cross2(u, d.tips[side] - a) / len;
            sum.perEnd += off * off / variance;
            sum.cost += (kNu + 1.0) * std::log1p(off * off / variance / kNu);
            ++count;
        }
    }
    sum.perEnd /= static_cast<double>(std::max<std::size_t>(1, count));
    return sum;
}

}  // namespace ew
