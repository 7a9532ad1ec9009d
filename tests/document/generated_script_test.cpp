// SPDX-License-Identifier: GPL-3.0-or-later
// The scripts that the sketch generator writes are sketch scripts, and nothing of a stroke is lost.
#include <gtest/gtest.h>

#include "core/document/sketch_script.h"
#include "tests/support/sketch_generator.h"

namespace ew::test {
namespace {

TEST(GeneratedScript, ReadsAsASketchScriptWithEverySample) {
    for (const std::string& id : sketchTemplates()) {
        Random random(17);
        const SketchCase sketch = randomSketch(id, random);
        const auto strokes = drawByHand(sketch.drawing.lines(), kRoughHand, random);
        const auto script =
            readSketchScript(sketchScriptText("generated " + id, sketch.camera, {}, strokes));
        ASSERT_TRUE(script) << script.error().message;
        EXPECT_EQ(script->title, "generated " + id);
        EXPECT_EQ(script->thresholds, Thresholds{});
        ASSERT_EQ(script->steps.size(), strokes.size() + 2);
        const auto* camera = std::get_if<CameraStep>(&script->steps.front());
        ASSERT_NE(camera, nullptr);
        EXPECT_EQ(camera->direction, sketch.camera.direction);
        EXPECT_EQ(camera->worldPerPixel, sketch.camera.worldPerPixel);
        EXPECT_TRUE(std::holds_alternative<ApplyStep>(script->steps.back()));
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            const auto* step = std::get_if<StrokeStep>(&script->steps[i + 1]);
            ASSERT_NE(step, nullptr);
            EXPECT_TRUE(step->hasPressure);
            ASSERT_EQ(step->stroke.samples.size(), strokes[i].samples.size());
            for (std::size_t k = 0; k < strokes[i].samples.size(); ++k) {
                EXPECT_EQ(step->stroke.samples[k].position, strokes[i].samples[k].position);
                EXPECT_EQ(step->stroke.samples[k].pressure, strokes[i].samples[k].pressure);
                EXPECT_EQ(step->stroke.samples[k].timeMs, strokes[i].samples[k].timeMs);
            }
        }
    }
}

}  // namespace
}  // namespace ew::test
