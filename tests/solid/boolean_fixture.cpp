// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/solid/boolean_fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "tests/solid/shapes.h"

namespace ew::test {
namespace {

std::string nameOf(const std::vector<BoxStep>& steps) {
    std::string out;
    for (const BoxStep& s : steps) {
        out += s.kind == BooleanKind::Add ? " +" : s.kind == BooleanKind::Cut ? " -" : " &";
        for (std::size_t k = 0; k < 3; ++k) {
            out += " " + std::to_string(s.box.low[k]) + ".." + std::to_string(s.box.high[k]);
        }
    }
    return out;
}

/// What the oracle says about a step.
std::optional<Errc> refusal(const Voxels& before, const Voxels& after,
                            const SurfaceCounts& counts) {
    if (after == before) return Errc::NoChange;
    if (after.empty()) return Errc::NothingLeft;
    if (counts.touchesInEdge) return Errc::TouchesInEdge;
    if (counts.touchesInPoint) return Errc::TouchesInPoint;
    return std::nullopt;
}

}  // namespace

const std::vector<Eigen::Matrix3i>& cubeRotations() {
    static const std::vector<Eigen::Matrix3i> all = [] {
        std::vector<Eigen::Matrix3i> out;
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b) {
                if (a == b) continue;
                for (const int s : {1, -1}) {
                    for (const int t : {1, -1}) {
                        Eigen::Matrix3i m = Eigen::Matrix3i::Zero();
                        m(a, 0) = s;
                        m(b, 1) = t;
                        m.col(2) = m.col(0).cross(m.col(1));
                        out.push_back(m);
                    }
                }
            }
        }
        return out;
    }();
    return all;
}

Solid movedBox(const IntBox& b, const Eigen::Matrix3i& matrix) {
    const auto corner = [](const std::array<int, 3>& p) { return Vec3(p[0], p[1], p[2]); };
    PolyhedronSpec spec = box(corner(b.low), corner(b.high));
    for (Vec3& p : spec.vertices) p = matrix.cast<double>() * p;
    const auto solid = Solid::fromSpec(spec);
    EXPECT_TRUE(solid) << solid.error().message;
    return *solid;
}

void checkWholeGate(const Solid& solid) {
    const auto back = Solid::deserialize(solid.serialize());
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(back->identicalTo(solid));
    EXPECT_EQ(back->volume(), solid.volume());
    EXPECT_EQ(back->shellCount(), solid.shellCount());
    EXPECT_EQ(back->genus(), solid.genus());
}

namespace {

/// What the oracle says of every step; the same for all rotations.
struct Expected {
    std::optional<Errc> refused;
    SurfaceCounts counts;
};

std::vector<Expected> expectedOf(const std::vector<BoxStep>& steps) {
    std::vector<Expected> out(1);
    Voxels voxels;
    voxels.combine(steps[0].box, BooleanKind::Add);
    for (std::size_t i = 1; i < steps.size(); ++i) {
        Voxels after = voxels;
        after.combine(steps[i].box, steps[i].kind);
        const SurfaceCounts counts = after.counts();
        out.push_back({refusal(voxels, after, counts), counts});
        if (!out.back().refused) voxels = after;
    }
    return out;
}

SurfaceCounts countsOf(const Solid& solid, double scale) {
    return {static_cast<int>(std::lround(solid.volume() / scale)),
            static_cast<int>(solid.vertices().size()),
            static_cast<int>(solid.edges().size()),
            static_cast<int>(solid.faces().size()),
            solid.shellCount(),
            solid.genus(),
            false,
            false};
}

void runSteps(const std::vector<BoxStep>& steps, const std::vector<Expected>& expected,
              const Eigen::Matrix3i& matrix) {
    const double scale = std::abs(matrix.cast<double>().determinant());
    Solid solid = movedBox(steps[0].box, matrix);
    for (std::size_t i = 1; i < steps.size(); ++i) {
        const auto result = combine(solid, movedBox(steps[i].box, matrix), steps[i].kind);
        if (expected[i].refused) {
            ASSERT_FALSE(result) << "step " << i << " of" << nameOf(steps)
                                 << " is to be refused: " << errcName(*expected[i].refused);
            ASSERT_EQ(errcName(result.error().code), errcName(*expected[i].refused))
                << "step " << i << " of" << nameOf(steps);
            continue;
        }
        ASSERT_TRUE(result) << "step " << i << " of" << nameOf(steps) << ": "
                            << errcName(result.error().code) << " " << result.error().message;
        solid = result->solid;
        const SurfaceCounts& counts = expected[i].counts;
        const SurfaceCounts seen = countsOf(solid, scale);
        ASSERT_TRUE(seen == counts) << "step " << i << " of" << nameOf(steps) << "\nseen " << seen
                                    << "\nexpected " << counts;
        EXPECT_NEAR(solid.volume(), scale * counts.volume, 1e-9 * scale * counts.volume);
        ASSERT_EQ(result->report.faceOrigin.size(), solid.faces().size());
        ASSERT_EQ(result->report.shells, counts.shells);
    }
    // The whole gate once per row of the table is enough: it knows no direction.
    if (scale > 1.0) checkWholeGate(solid);
}

}  // namespace

void checkSteps(const std::vector<BoxStep>& steps, const Eigen::Matrix3i& matrix) {
    runSteps(steps, expectedOf(steps), matrix);
}

void checkUnderRotations(const std::vector<BoxStep>& steps) {
    const std::vector<Expected> expected = expectedOf(steps);
    for (const Eigen::Matrix3i& rotation : cubeRotations()) {
        runSteps(steps, expected, rotation);
        if (::testing::Test::HasFatalFailure()) return;
    }
    Eigen::Matrix3i oblique;
    oblique << 2, -1, 2, 2, 2, -1, -1, 2, 2;
    runSteps(steps, expected, oblique);
}

}  // namespace ew::test
