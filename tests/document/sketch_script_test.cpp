// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/sketch_script.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>

#include "tests/document/fixtures.h"

namespace ew {
namespace {

std::string withSteps(const std::string& steps) {
    return R"({"format": "edgewright-sketch", "version": 1, "steps": [)" + steps + "]}";
}

const char* const kEveryStep = R"({
  "format": "edgewright-sketch", "version": 1, "title": "Ein K\u00f6rper", "viewport": [640, 480],
  "thresholds": {"distance_px": 10.5, "angle_deg": 8},
  "steps": [
    {"do": "camera", "direction": [0, 0, -1], "up": [0, 1, 0], "center": [1, 2, 3], "world_per_pixel": 0.5,
     "viewport": [800, 600]},
    {"do": "camera"},
    {"do": "thresholds", "distance_px": 20},
    {"do": "thresholds", "angle_deg": 3},
    {"do": "stroke", "points": [[640, 400], [641.5, 1e-3]]},
    {"do": "stroke", "points": [[1, 2, 0.5, 0], [3, 4, 1, 12.5]]},
    {"do": "erase", "at": [640, 400]},
    {"do": "clear"},
    {"do": "apply"},
    {"do": "apply", "candidate": 2, "template": "cube", "operation": "create", "oblique_factor": 0.7},
    {"do": "fillet", "edges": "convex", "radius": 2, "segments": 3},
    {"do": "fillet", "edges": [[1, 2, 3], [4, 5, 6]], "radius": 0.5},
    {"do": "subdivide", "scheme": "loop", "levels": 0},
    {"do": "subdivide", "scheme": "catmull-clark", "tolerance": 0.01},
    {"do": "map_strokes", "color": "#ff0000"},
    {"do": "map_strokes"},
    {"do": "define_template", "id": "mine", "name": "Mine", "from": "solid"},
    {"do": "delete_solid"},
    {"do": "undo"}, {"do": "redo", "count": 3},
    {"do": "save", "path": "a.edgewright"}, {"do": "open", "path": "a.edgewright"},
    {"do": "export", "path": "a.obj"},
    {"do": "export", "path": "a.obj", "faces": "triangles"}
  ]})";

TEST(SketchScript, ReadsEveryStep) {
    const auto script = readSketchScript(kEveryStep);
    ASSERT_TRUE(script) << script.error().message;
    EXPECT_EQ(script->title, "Ein K\u00f6rper");
    EXPECT_EQ(script->viewport[1], 480);
    EXPECT_EQ(script->thresholds.distancePx, 10.5);
    EXPECT_EQ(script->thresholds.angleDeg, 8);
    ASSERT_EQ(script->steps.size(), 24U);
    const auto& camera = std::get<CameraStep>(script->steps[0]);
    EXPECT_EQ(*camera.center, Vec3(1, 2, 3));
    EXPECT_EQ(*camera.viewport, Vec2(800, 600));
    EXPECT_FALSE(std::get<CameraStep>(script->steps[1]).direction);
    const auto& plain = std::get<StrokeStep>(script->steps[4]);
    EXPECT_FALSE(plain.hasPressure);
    EXPECT_EQ(plain.stroke.samples[1].position, Vec2(641.5, 1e-3));
    const auto& pen = std::get<StrokeStep>(script->steps[5]);
    EXPECT_TRUE(pen.hasPressure);
    EXPECT_EQ(pen.stroke.samples[0].pressure, 0.5);
    EXPECT_EQ(pen.stroke.samples[1].timeMs, 12.5);
    const auto& apply = std::get<ApplyStep>(script->steps[9]);
    EXPECT_EQ(apply.candidate, 2);
    EXPECT_EQ(apply.templateId, "cube");
    EXPECT_EQ(apply.operation, Operation::Create);
    EXPECT_EQ(apply.obliqueFactor, 0.7);
    EXPECT_EQ(std::get<FilletStep>(script->steps[11]).near.size(), 2U);
    EXPECT_EQ(std::get<SubdivideStep>(script->steps[12]).levels, 0);
    EXPECT_EQ(std::get<RedoStep>(script->steps[19]).count, 3);
}

TEST(SketchScript, WritesBackToTheSameText) {
    const auto script = readSketchScript(kEveryStep);
    ASSERT_TRUE(script);
    const std::string once = writeSketchScript(*script);
    const auto again = readSketchScript(once);
    ASSERT_TRUE(again) << again.error().message << once;
    EXPECT_EQ(writeSketchScript(*again), once);
    // One step a line, between the seven lines of the head and the two of the end.
    EXPECT_EQ(std::count(once.begin(), once.end(), '\n'), 7 + 24 + 2);
}

TEST(SketchScript, KeepsAnInlineTemplate) {
    SketchScript script;
    DefineTemplateStep step{"slab", "Slab", test::boxTemplate("slab", "Slab")};
    script.steps.emplace_back(step);
    const std::string text = writeSketchScript(script);
    const auto read = readSketchScript(text);
    ASSERT_TRUE(read) << read.error().message;
    const auto& define = std::get<DefineTemplateStep>(read->steps[0]);
    ASSERT_TRUE(define.tmpl);
    EXPECT_EQ(define.tmpl->id, "slab");
    EXPECT_EQ(define.tmpl->shape.faces, step.tmpl->shape.faces);
    EXPECT_EQ(define.tmpl->relations.parallel, step.tmpl->relations.parallel);
    EXPECT_EQ(writeSketchScript(*read), text);
}

TEST(SketchScript, KeepsThatATemplateIsReplaced) {
    SketchScript script;
    script.steps.emplace_back(
        DefineTemplateStep{"slab", "Slab", test::boxTemplate("slab", "Slab"), true});
    const std::string text = writeSketchScript(script);
    const auto read = readSketchScript(text);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(std::get<DefineTemplateStep>(read->steps[0]).replace);
    EXPECT_EQ(writeSketchScript(*read), text);
}

TEST(SketchScript, InlineTemplateMayLeaveOutWhatTheStepSays) {
    const auto read = readSketchScript(withSteps(
        R"({"do": "define_template", "id": "tet", "name": "Tet", "template": {
            "vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]],
            "faces": [[0,2,1],[0,1,3],[0,3,2],[1,2,3]]}})"));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(std::get<DefineTemplateStep>(read->steps[0]).tmpl->id, "tet");
}

struct BadScript {
    const char* text;
    Errc code;
    const char* says;
};

std::string step(const char* body) { return withSteps(std::string(R"({"do": "clear"}, )") + body); }

TEST(SketchScript, RefusesBadSteps) {
    const std::vector<BadScript> table{
        {R"(7)", Errc::WrongType, "step 1"},
        {R"({})", Errc::MissingKey, "step 1: the key \"do\""},
        {R"({"do": 3})", Errc::WrongType, "step 1: \"do\""},
        {R"({"do": "dance"})", Errc::BadValue, "\"dance\""},
        {R"({"do": "stroke"})", Errc::MissingKey, "step 1 (stroke): the key \"points\""},
        {R"({"do": "stroke", "pts": []})", Errc::UnknownKey,
         "step 1 (stroke): unknown key \"pts\""},
        {R"({"do": "stroke", "points": [], "pts": 1})", Errc::UnknownKey,
         "step 1 (stroke): unknown key \"pts\""},
        {R"({"do": "clear", "all": true})", Errc::UnknownKey, "\"all\""},
        {R"({"do": "stroke", "points": 3})", Errc::WrongType, "\"points\""},
        {R"({"do": "stroke", "points": [[1]]})", Errc::BadValue, "\"points\"/0"},
        {R"({"do": "stroke", "points": [[1, 2, 0.5]]})", Errc::BadValue, "\"points\"/0"},
        {R"({"do": "stroke", "points": [[1, 2], [1, null]]})", Errc::WrongType, "\"points\"/1"},
        {R"({"do": "stroke", "points": [[1, 2, 1.5, 0]]})", Errc::BadValue, "pressure"},
        {R"({"do": "stroke", "points": [[1e999, 2]]})", Errc::BadValue, "beyond the range"},
        {R"({"do": "stroke", "points": [[NaN, 2]]})", Errc::Syntax, "not valid JSON"},
        {R"({"do": "stroke", "points": [], "points": []})", Errc::Syntax, "twice"},
        {R"({"do": "camera", "direction": [0, 0, 0]})", Errc::BadValue, "\"direction\""},
        {R"({"do": "camera", "up": [1, 2]})", Errc::BadValue, "\"up\""},
        {R"({"do": "camera", "center": [1e300, 0, 0]})", Errc::BadValue, "\"center\""},
        {R"({"do": "camera", "world_per_pixel": 0})", Errc::BadValue, "\"world_per_pixel\""},
        {R"({"do": "camera", "world_per_pixel": "1"})", Errc::WrongType, "\"world_per_pixel\""},
        {R"({"do": "thresholds", "distance_px": 0.5})", Errc::BadValue, "\"distance_px\""},
        {R"({"do": "thresholds", "distance_px": 101})", Errc::BadValue, "\"distance_px\""},
        {R"({"do": "thresholds", "angle_deg": 46})", Errc::BadValue, "\"angle_deg\""},
        {R"({"do": "erase"})", Errc::MissingKey, "\"at\""},
        {R"({"do": "apply", "candidate": -1})", Errc::BadValue, "\"candidate\""},
        {R"({"do": "apply", "candidate": 0.5})", Errc::WrongType, "\"candidate\""},
        {R"({"do": "apply", "candidate": 99999999999999999999})", Errc::WrongType, "\"candidate\""},
        {R"({"do": "apply", "operation": "glue"})", Errc::BadValue, "\"operation\""},
        {R"({"do": "apply", "template": ""})", Errc::BadValue, "\"template\""},
        {R"({"do": "apply", "oblique_factor": 5})", Errc::BadValue, "\"oblique_factor\""},
        {R"({"do": "fillet", "edges": "all"})", Errc::MissingKey, "\"radius\""},
        {R"({"do": "fillet", "edges": "all", "radius": 0})", Errc::BadValue, "\"radius\""},
        {R"({"do": "fillet", "edges": "all", "radius": -2.5})", Errc::BadValue, "\"radius\""},
        {R"({"do": "fillet", "edges": "all", "radius": NaN})", Errc::Syntax, "byte"},
        {R"({"do": "fillet", "edges": "all", "radius": null})", Errc::WrongType, "\"radius\""},
        {R"({"do": "fillet", "edges": "round", "radius": 1})", Errc::BadValue, "\"edges\""},
        {R"({"do": "fillet", "edges": [], "radius": 1})", Errc::BadValue, "\"edges\""},
        {R"({"do": "fillet", "edges": "all", "radius": 1, "segments": 0})", Errc::BadValue,
         "\"segments\""},
        {R"({"do": "subdivide", "scheme": "loop"})", Errc::MissingKey, "\"levels\""},
        {R"({"do": "subdivide", "scheme": "loop", "levels": 7})", Errc::BadValue, "\"levels\""},
        {R"({"do": "subdivide", "scheme": "loop", "tolerance": 0})", Errc::BadValue,
         "\"tolerance\""},
        {R"({"do": "subdivide", "scheme": "doo-sabin", "levels": 1})", Errc::BadValue,
         "\"scheme\""},
        {R"({"do": "subdivide", "scheme": "loop", "levels": 1, "tolerance": 1})", Errc::BadValue,
         "not both"},
        {R"({"do": "define_template", "id": "a", "name": "A"})", Errc::MissingKey, "\"from\""},
        {R"({"do": "define_template", "id": "a", "name": "A", "from": "air"})", Errc::BadValue,
         "\"from\""},
        {R"({"do": "define_template", "id": "a", "name": "A", "template": 4})", Errc::WrongType,
         "\"template\""},
        {R"({"do": "undo", "count": 0})", Errc::BadValue, "\"count\""},
        {R"({"do": "export", "path": ""})", Errc::BadValue, "\"path\""},
        {R"({"do": "export", "path": "a.obj", "faces": "few"})", Errc::BadValue, "\"faces\""},
        {R"({"do": "save", "path": "a", "faces": "simple"})", Errc::UnknownKey, "\"faces\""},
        {R"({"do": "save"})", Errc::MissingKey, "\"path\""},
    };
    for (const BadScript& bad : table) {
        const auto read = readSketchScript(step(bad.text));
        ASSERT_FALSE(read) << bad.text;
        EXPECT_EQ(read.error().code, bad.code) << bad.text << "\n" << read.error().message;
        EXPECT_NE(read.error().message.find(bad.says), std::string::npos) << bad.text << "\n"
                                                                          << read.error().message;
    }
}

TEST(SketchScript, RefusesBadFiles) {
    const std::vector<BadScript> table{
        {"", Errc::Syntax, "byte"},
        {"[]", Errc::WrongType, "object"},
        {"null", Errc::WrongType, "object"},
        {R"({"version": 1, "steps": []})", Errc::MissingKey, "\"format\""},
        {R"({"format": "edgewright-report", "version": 1, "steps": []})", Errc::WrongFormat,
         "edgewright-report"},
        {R"({"format": 1, "version": 1, "steps": []})", Errc::WrongType, "\"format\""},
        {R"({"format": "edgewright-sketch", "steps": []})", Errc::MissingKey, "\"version\""},
        {R"({"format": "edgewright-sketch", "version": 2, "steps": []})", Errc::WrongVersion,
         "version 2"},
        {R"({"format": "edgewright-sketch", "version": "1", "steps": []})", Errc::WrongType,
         "\"version\""},
        {R"({"format": "edgewright-sketch", "version": 1})", Errc::MissingKey, "\"steps\""},
        {R"({"format": "edgewright-sketch", "version": 1, "steps": {}})", Errc::WrongType,
         "\"steps\""},
        {R"({"format": "edgewright-sketch", "version": 1, "steps": [], "stesp": []})",
         Errc::UnknownKey, "\"stesp\""},
        {R"({"format": "edgewright-sketch", "version": 1, "steps": [], "viewport": [8, 600]})",
         Errc::BadValue, "\"viewport\""},
        {R"({"format": "edgewright-sketch", "version": 1, "steps": [], "viewport": [8e9, 600]})",
         Errc::BadValue, "\"viewport\""},
        {R"({"format": "edgewright-sketch", "version": 1, "steps": [], "thresholds": {"distance_px": 0}})",
         Errc::BadValue, "\"distance_px\""},
        {R"({"format": "edgewright-sketch", "version": 1, "steps": [], "thresholds": {"px": 0}})",
         Errc::UnknownKey, "\"px\""},
        {R"({"format": "edgewright-sketch", "version": 1, "steps": [], "title": 1})",
         Errc::WrongType, "\"title\""},
        {R"({"format": "edgewright-sketch", "version": 1, "steps": []} x)", Errc::Syntax, "byte"},
        {"{\"format\": \"edgewright-sketch\xff\", \"version\": 1, \"steps\": []}", Errc::Syntax,
         "byte"},
    };
    for (const BadScript& bad : table) {
        const auto read = readSketchScript(bad.text);
        ASSERT_FALSE(read) << bad.text;
        EXPECT_EQ(read.error().code, bad.code) << bad.text << "\n" << read.error().message;
        EXPECT_NE(read.error().message.find(bad.says), std::string::npos) << bad.text << "\n"
                                                                          << read.error().message;
    }
}

TEST(SketchScript, RefusesAFileThatIsCutAnywhere) {
    const std::string whole = kEveryStep;
    ASSERT_TRUE(readSketchScript(whole));
    for (std::size_t n = 0; n < whole.size(); ++n) {
        const auto read = readSketchScript(std::string_view(whole).substr(0, n));
        ASSERT_FALSE(read) << "cut after byte " << n;
        EXPECT_EQ(read.error().code, Errc::Syntax) << "cut after byte " << n;
    }
}

TEST(SketchScript, RefusesDeepNestingAtOnce) {
    const std::string deep(1'000'000, '[');
    auto read = readSketchScript(deep);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, Errc::TooDeep);
    std::string objects;
    for (int i = 0; i < 200'000; ++i) objects += "{\"a\":";
    read = readSketchScript(objects);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, Errc::TooDeep);
}

TEST(SketchScript, RefusesHugeFiles) {
    const std::string huge(std::size_t{100} << 20U, ' ');
    const auto read = readSketchScript(huge);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, Errc::TooLarge);
}

TEST(SketchScript, LeavesCoordinatesToTheStep) {
    const auto read =
        readSketchScript(withSteps(R"({"do": "stroke", "points": [[1e308, -1e308]]})"));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(std::get<StrokeStep>(read->steps[0]).stroke.samples[0].position.x(), 1e308);
}

bool sameBits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

RC_GTEST_PROP(SketchScript, NumbersComeBackToTheBit, ()) {
    SketchScript script;
    StrokeStep stroke;
    stroke.hasPressure = *rc::gen::arbitrary<bool>();
    const auto points = *rc::gen::container<std::vector<std::pair<double, double>>>(
        rc::gen::pair(rc::gen::arbitrary<double>(), rc::gen::arbitrary<double>()));
    for (const auto& [x, y] : points) {
        PenSample s;
        s.position = {x, y};
        if (stroke.hasPressure) s.timeMs = y / 3;
        stroke.stroke.samples.push_back(s);
    }
    stroke.stroke.samples.push_back({Vec2(-0.0, 0.0), 1.0, 0.0});
    script.steps.emplace_back(stroke);
    const auto read = readSketchScript(writeSketchScript(script));
    RC_ASSERT(read.has_value());
    const auto& back = std::get<StrokeStep>(read->steps[0]);
    RC_ASSERT(back.hasPressure == stroke.hasPressure);
    RC_ASSERT(back.stroke.samples.size() == stroke.stroke.samples.size());
    for (std::size_t i = 0; i < back.stroke.samples.size(); ++i) {
        const PenSample& a = back.stroke.samples[i];
        const PenSample& b = stroke.stroke.samples[i];
        RC_ASSERT(sameBits(a.position.x(), b.position.x()));
        RC_ASSERT(sameBits(a.position.y(), b.position.y()));
        RC_ASSERT(sameBits(a.timeMs, b.timeMs));
    }
}

RC_GTEST_PROP(SketchScript, MutatedFilesAreReadOrRefused, ()) {
    std::string text = kEveryStep;
    const int changes = *rc::gen::inRange(1, 6);
    for (int i = 0; i < changes; ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
        text[at] = *rc::gen::element('{', '}', '[', ']', ',', ':', '"', '0', '9', '-', 'e', '.',
                                     ' ', '\\', '\x80', '\0');
    }
    const auto read = readSketchScript(text);
    if (read)
        RC_ASSERT(readSketchScript(writeSketchScript(*read)).has_value());
    else
        RC_ASSERT(!read.error().message.empty());
}

}  // namespace
}  // namespace ew
