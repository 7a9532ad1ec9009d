// SPDX-License-Identifier: GPL-3.0-or-later
// Are the probabilities true that readings are told with?
//
//   recognition --told free.txt; modification --told solid.txt
//   calibrate free.txt solid.txt
//
// Prints, for bins of told probability, which share was told to be wrong and which was: of what was
// accepted, and of the first readings of what was asked about. Then the line over log odds that
// would make them agree in all (Platt 1999), whose two numbers scale and shift the constants of
// core/reading/score/probability.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>

namespace {

struct Told {
    double probability = 0.0;
    bool right = false;
    bool accepted = false;
};

double logOdds(double p) {
    constexpr double kSure = 1e-6;
    const double q = std::clamp(p, kSure, 1.0 - kSure);
    return std::log(q / (1.0 - q));
}

double sigmoid(double x) { return 1.0 / (1.0 + std::exp(-x)); }

bool read(const char* path, std::vector<Told>& out) {
    std::ifstream in(path);
    if (!in) return false;
    double probability = 0.0;
    int right = 0;
    int accepted = 0;
    while (in >> probability >> right >> accepted) {
        out.push_back({probability, right == 1, accepted == 1});
    }
    return in.eof();
}

void printBins(const char* what, const std::vector<Told>& told, bool accepted) {
    constexpr std::array<double, 6> kEdges{0.0, 0.5, 0.9, 0.99, 0.999, 1.0 + 1e-9};
    std::printf("%-16s %9s %12s %12s %8s\n", what, "drawings", "wrong, told", "wrong", "ratio");
    for (std::size_t b = 0; b + 1 < kEdges.size(); ++b) {
        double expected = 0.0;
        int n = 0;
        int wrong = 0;
        for (const Told& t : told) {
            if (t.accepted != accepted || t.probability < kEdges[b] ||
                t.probability >= kEdges[b + 1])
                continue;
            ++n;
            wrong += t.right ? 0 : 1;
            expected += 1.0 - t.probability;
        }
        std::printf("%.3f to %.3f   %9d %11.2f%% %11.2f%% %8.2f\n", kEdges[b],
                    std::min(1.0, kEdges[b + 1]), n, n > 0 ? 100.0 * expected / n : 0.0,
                    n > 0 ? 100.0 * wrong / n : 0.0, expected > 0.0 ? wrong / expected : 0.0);
    }
}

/// Newton's method on the likelihood, which is convex.
std::array<double, 2> fit(const std::vector<Told>& told) {
    double scale = 1.0;
    double shift = 0.0;
    for (int round = 0; round < 100; ++round) {
        double gs = 0.0, gb = 0.0, hss = 1e-9, hsb = 0.0, hbb = 1e-9;
        for (const Told& t : told) {
            const double x = logOdds(t.probability);
            const double p = sigmoid(scale * x + shift);
            const double error = (t.right ? 1.0 : 0.0) - p;
            const double weight = p * (1.0 - p);
            gs += error * x;
            gb += error;
            hss += weight * x * x;
            hsb += weight * x;
            hbb += weight;
        }
        const double determinant = hss * hbb - hsb * hsb;
        if (!(std::abs(determinant) > 0.0)) break;
        const double ds = (hbb * gs - hsb * gb) / determinant;
        const double db = (hss * gb - hsb * gs) / determinant;
        scale += ds;
        shift += db;
        if (std::abs(ds) + std::abs(db) < 1e-9) break;
    }
    return {scale, shift};
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<Told> told;
    for (int i = 1; i < argc; ++i) {
        if (!read(argv[i], told)) {
            std::fprintf(stderr, "cannot read %s\n", argv[i]);
            return 2;
        }
    }
    if (told.empty()) {
        std::fprintf(stderr, "calibrate FILE...   files that recognition --told wrote\n");
        return 2;
    }
    const auto print = [&] {
        printBins("accepted", told, true);
        printBins("asked about", told, false);
    };
    print();
    const auto [scale, shift] = fit(told);
    std::printf("\nlog odds: %.3f times what was told, %+.3f\n\n", scale, shift);
    for (Told& t : told) t.probability = sigmoid(scale * logOdds(t.probability) + shift);
    print();
    return 0;
}
