// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// Random numbers that are the same with every standard library: std::mt19937_64 is specified to
/// the bit, the distributions of <random> are not, so these are its own.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(mix(seed)) {}

    /// Seed of an independent stream (splitmix64 finaliser), for numbered instances.
    static std::uint64_t mix(std::uint64_t a, std::uint64_t b = 0, std::uint64_t c = 0) {
        std::uint64_t z = a + 0x9e3779b97f4a7c15ULL * (b + 1) + 0xd1b54a32d192ed03ULL * (c + 1);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }

    /// In [0, 1).
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// True with this probability, 0..1.
    bool chance(double probability) { return uniform() < probability; }
    /// In 0..count-1, count >= 1.
    int index(int count) { return static_cast<int>(uniform() * count); }
    /// Mean 0, standard deviation 1 (Box and Muller).
    double normal() {
        const double r = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return r * std::cos(2.0 * std::numbers::pi * uniform());
    }
    /// Unit vector of uniform direction.
    Vec2 direction() {
        const double a = uniform(0.0, 2.0 * std::numbers::pi);
        return {std::cos(a), std::sin(a)};
    }
    /// Uniform in the disc of this radius.
    Vec2 inDisc(double radius) {
        const double r = radius * std::sqrt(uniform());
        return r * direction();
    }
    template <class T>
    void shuffle(std::vector<T>& values) {
        for (std::size_t i = values.size(); i > 1; --i) {
            std::swap(values[i - 1], values[static_cast<std::size_t>(index(static_cast<int>(i)))]);
        }
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace ew
