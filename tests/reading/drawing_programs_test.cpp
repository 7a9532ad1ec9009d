// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes as other programs, and people with rulers, draw them.
#include <cmath>

#include "tests/reading/reading_fixture.h"

namespace ew::test {
namespace {

const OrthographicCamera kCamera;

/// A corner of a box of 60 x 40 x 50 mm; the camera sees +x, -y and +z.
Vec2 corner(double x, double y, double z) { return kCamera.project(Vec3(60 * x, 40 * y, 50 * z)); }

void expectBox(const Interpretation& reading) {
    ASSERT_TRUE(reading.accepted) << (reading.problem ? reading.problem->message : "");
    const Candidate& c = reading.candidates[static_cast<std::size_t>(*reading.accepted)];
    EXPECT_EQ(c.templateId, "cube");
    EXPECT_NEAR(volumeOf(c.spec) / (60.0 * 40.0 * 50.0), 1.0, 0.01);
}

TEST(DrawingPrograms, AFrontWithRoundedCornersIsAFace) {
    const std::vector<Vec2> front{corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1),
                                  corner(0, 0, 1)};
    for (const double radius : {12.0, 20.0, 30.0}) {
        SCOPED_TRACE(radius);
        Stroke loop;
        for (std::size_t i = 0; i < 4; ++i) {
            // A quadratic curve, as drawing programs make it.
            const Vec2 in = (front[i] - front[(i + 3) % 4]).normalized();
            const Vec2 out = (front[(i + 1) % 4] - front[i]).normalized();
            for (int k = 0; k <= 6; ++k) {
                const double t = k / 6.0;
                const Vec2 p = front[i] - (1 - t) * (1 - t) * radius * in + t * t * radius * out;
                loop.samples.push_back({p, 1, 0});
            }
        }
        loop.samples.push_back(loop.samples.front());
        expectBox(readStrokes(
            {loop, line(corner(0, 0, 1), corner(0, 1, 1)), line(corner(0, 1, 1), corner(1, 1, 1)),
             line(corner(1, 1, 1), corner(1, 0, 1)), line(corner(1, 1, 1), corner(1, 1, 0)),
             line(corner(1, 1, 0), corner(1, 0, 0))}));
    }
}

TEST(DrawingPrograms, LinesRunPastTheCorners) {
    for (const double tail : {30.0, 60.0, 90.0}) {
        SCOPED_TRACE(tail);
        std::vector<Stroke> strokes;
        for (const Stroke& s : boxStrokes(kCamera, Vec3(60, 40, 50))) {
            const Vec2 a = s.samples.front().position;
            const Vec2 b = s.samples.back().position;
            const Vec2 d = tail * (b - a).normalized();
            strokes.push_back(line(a - d, b + 0.7 * d));
        }
        const Interpretation reading = readStrokes(strokes);
        expectBox(reading);
        ASSERT_TRUE(reading.accepted);
        EXPECT_TRUE(reading.candidates.front().unusedStrokes.empty());
    }
}

}  // namespace
}  // namespace ew::test
