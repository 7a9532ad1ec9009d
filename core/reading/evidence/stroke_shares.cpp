// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/evidence/stroke_shares.h"

#include <set>

namespace ew {

std::vector<int> strokesLeftOut(const std::map<int, StrokeShare>& shares,
                                const std::vector<NoiseItem>& noise) {
    std::set<int> out;
    for (const auto& [stroke, share] : shares) {
        if (share.beside > 0.5 * share.all) out.insert(stroke);
    }
    for (const NoiseItem& n : noise) out.insert(n.stroke);
    return {out.begin(), out.end()};
}

}  // namespace ew
