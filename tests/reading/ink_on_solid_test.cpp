// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/ink_on_solid.h"

#include <gtest/gtest.h>

#include "core/base/tolerance.h"
#include "core/reading/evidence/hand_noise.h"

namespace ew {
namespace {

double noiseOf(double wobblePx) {
    InkReading ink;
    ink.wobblePx = wobblePx;
    return handNoisePx(ink);
}

TEST(HandNoise, IsNextToNothingForAnExactDrawing) {
    EXPECT_EQ(noiseOf(0.0), 0.0);
    EXPECT_LT(noiseOf(1e-9), 1e-8);
}

TEST(HandNoise, IsMoreThanShortLinesShow) {
    // A light hand's short edges hide nearly all of its wobble, not that it misses corners.
    EXPECT_NEAR(noiseOf(0.17), 8.0 * 0.17, 1e-12);
    EXPECT_EQ(noiseOf(0.4), tol::kMissAtLeastPx);
}

TEST(HandNoise, GrowsWithTheWobbleAndNeverFalls) {
    double last = 0.0;
    for (double wobble = 0.0; wobble < 5.0; wobble += 0.01) {
        EXPECT_GE(noiseOf(wobble), last);
        last = noiseOf(wobble);
    }
    EXPECT_NEAR(noiseOf(4.0), tol::kMissPerWobble * 4.0, 1e-12);
}

}  // namespace
}  // namespace ew
