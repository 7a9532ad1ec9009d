// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/evidence/reading_tolerances.h"

#include "core/base/tolerance.h"
#include "core/reading/evidence/hand_noise.h"

namespace ew {

const std::vector<ReadingOptions>& readingOptions() {
    static const std::vector<ReadingOptions> kOptions{
        {},
        {1.0, 0.6, 0.4},
        {0.72, 0.8, 0.4},
        {1.0, 1.3, 0.7},
        {1.0, 1.0, 0.1},
        {0.72, 0.6, 0.2},
        {0.85, 1.0, 0.7},
        {0.55, 0.6, 0.2},
        {1.0, 1.0, 0.4, 2.2},
        {0.8, 0.8, 0.4, 2.2},
    };
    return kOptions;
}

const std::vector<DraftOptions>& draftOptions() {
    static const std::vector<DraftOptions> kOptions{
        {{}},
        {{1.0, 1.3, 0.7}, tol::kSecondLookCost},
        {{0.72, 0.6, 0.2}, tol::kSecondLookCost},
        {{1.0, 1.6, 0.7}, 2 * tol::kSecondLookCost, kUnsteadySpread},
        {{1.4, 1.0, 0.4, 1.8}, 4 * tol::kSecondLookCost, 0.25},
    };
    return kOptions;
}

}  // namespace ew
