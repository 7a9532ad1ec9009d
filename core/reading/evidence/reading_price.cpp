// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/evidence/reading_price.h"

#include <algorithm>
#include <vector>

#include "core/base/tolerance.h"

namespace ew {

double strayPrice(const EdgeGraph& graph, double distancePx) {
    double price = 0;
    for (const NoiseItem& n : graph.noise) {
        if (n.kind != NoiseKind::Stray || n.polyline.size() < 2) continue;
        const double length = (n.polyline.back() - n.polyline.front()).norm();
        price += tol::kExtraEdgeCost * std::min(1.0, length / (4.0 * distancePx));
    }
    return price;
}

double bentPrice(const EdgeGraph& graph, double wobblePx) {
    // A hand that bows one line bows the others too; what is bent alone is two edges.
    std::vector<double> all;
    for (const GraphEdge& e : graph.edges) all.push_back(e.wobblePx);
    double common = 0;
    if (!all.empty()) {
        const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
        std::nth_element(all.begin(), middle, all.end());
        common = *middle;
    }
    const double usual = std::max({wobblePx, common, tol::kWobbleLeastPx});
    double price = 0;
    for (const GraphEdge& e : graph.edges) {
        const double excess = e.wobblePx * e.wobblePx / (usual * usual) - 4.0;
        if (excess > 0)
            price += std::min(30.0, 0.25 * excess * e.inkPx / tol::kWobbleCorrelationPx);
    }
    return price;
}

}  // namespace ew
