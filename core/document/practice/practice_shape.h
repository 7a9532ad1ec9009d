// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "core/base/camera.h"
#include "core/solid/solid.h"

namespace ew {

inline constexpr int kPracticeLevels = 5;

/// Random numbers that are the same on every machine.
class PracticeRandom {
  public:
    explicit PracticeRandom(std::uint32_t seed) : engine_(seed) {}
    /// Uniform in [low, high).
    double uniform(double low, double high);
    /// 0 to count - 1.
    int index(int count);

  private:
    std::mt19937 engine_;
};

/// A solid to be drawn.
struct PracticeShape {
    Solid solid;                ///< stands on z = 0 [mm]
    OrthographicCamera camera;  ///< shows three of its faces or more, about 420 px across
};

/// A random solid. 1: a box. 2: a prism or pyramid over a triangle, or a frustum. 3: a prism over
/// an L, a house or a regular polygon. 4: a prism over a T, a U or stairs, also lying. 5: a box
/// with another box on it. \pre 1 <= level <= kPracticeLevels
Result<PracticeShape> practiceShape(int level, PracticeRandom& random);

}  // namespace ew
