// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings that were not made for this program, read as strokes; they are no part of the project.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/reading/reading_fixture.h"
#include "tests/support/line_drawings.h"

namespace ew {
namespace {

using test::readStrokes;

const std::string kData = test::outsideDrawings();

/// Tests on files that may not be there.
class OutsideDrawings : public ::testing::Test {
  protected:
    void SetUp() override {
        if (kData.empty()) GTEST_SKIP() << "no drawings from outside: EDGEWRIGHT_DRAWINGS";
    }
};

/// Edge lengths of a box in its own frame, longest first [mm].
Vec3 boxSize(const Candidate& c) {
    Eigen::AlignedBox3d box;
    for (const Vec3& v : c.spec.vertices) box.extend(v);
    Vec3 size = box.sizes();
    std::sort(size.begin(), size.end(), std::greater<>());
    return size;
}

const Candidate* obliqueBox(const Interpretation& r) {
    const auto found = std::find_if(
        r.candidates.begin(), r.candidates.end(),
        [](const Candidate& c) { return c.templateId == "cube" && c.depth == DepthRule::Oblique; });
    return found == r.candidates.end() ? nullptr : &*found;
}

std::string answerOf(const Interpretation& r) {
    if (r.accepted) return "accepted " + r.candidates[0].templateId;
    return r.problem ? std::string(errcName(r.problem->code)) : "no answer";
}

struct KnownBox {
    const char* file;
    Vec3 size;  ///< longest first
};

class HiddenLineBoxes : public OutsideDrawings, public ::testing::WithParamInterface<KnownBox> {};

// The files give six digits or so. Strokes come in any order in them and end in one another.
TEST_P(HiddenLineBoxes, ComeBackUpToScale) {
    for (const double diagonalPx : {200.0, test::kImportDiagonalPx, 900.0}) {
        const auto drawing = test::readHiddenLineSvg(kData + GetParam().file, diagonalPx);
        ASSERT_TRUE(drawing) << drawing.error().message;
        const auto r = readStrokes(drawing->visible());
        ASSERT_TRUE(r.accepted) << diagonalPx << " px: " << answerOf(r);
        const Candidate& c = r.candidates[static_cast<std::size_t>(*r.accepted)];
        EXPECT_EQ(c.templateId, "cube");
        EXPECT_EQ(c.depth, DepthRule::Orthographic);
        const Vec3 size = boxSize(c);
        const Vec3 ratio = size.cwiseQuotient(GetParam().size);
        EXPECT_NEAR(ratio.y() / ratio.x(), 1.0, 1e-4) << size.transpose();
        EXPECT_NEAR(ratio.z() / ratio.x(), 1.0, 1e-4) << size.transpose();
        // The scale is that of the drawing.
        const double mmPerUnit = drawing->pxPerUnit * OrthographicCamera().worldPerPixel;
        EXPECT_NEAR(ratio.x() / mmPerUnit, 1.0, 1e-4);
    }
}
INSTANTIATE_TEST_SUITE_P(Files, HiddenLineBoxes,
                         ::testing::Values(KnownBox{"box_example.svg", {3, 2, 1}},
                                           KnownBox{"general_ex1.svg", {80, 60, 10}}),
                         [](const auto& param) {
                             const std::string file = param.param.file;
                             return file.substr(0, file.find('.'));
                         });

TEST_F(OutsideDrawings, TheBuildingsOuterBoxIsOfferedObliquely) {
    const auto drawing = test::readScap(kData + "building_SA_cluster.scap");
    ASSERT_TRUE(drawing) << drawing.error().message;
    const auto strokes = drawing->clusters(test::kBuildingOuterBox);
    for (const std::string only : {"", "cube"}) {
        SCOPED_TRACE(only);
        InterpretOptions options;
        options.templateId = only;
        const auto r = readStrokes(strokes, options);
        // Eighteen overtraced strokes are nine lines.
        EXPECT_EQ(r.graph.edges.size(), 9u);
        EXPECT_EQ(r.graph.junctions.size(), 7u);
        const Candidate* box = obliqueBox(r);
        ASSERT_NE(box, nullptr) << answerOf(r);
        EXPECT_EQ(box->missingEdges + box->extraEdges, 0);
        // The front is drawn about 273 px high and 172 px wide, its depth lines 64 to 80 px long.
        const double mm = options.camera.worldPerPixel;
        const Vec3 size = boxSize(*box);
        EXPECT_NEAR(size.x() / mm, 273, 14);
        EXPECT_NEAR(size.y() / mm, 172, 9);
        EXPECT_GT(size.z() / mm, 64 * options.obliqueFactor - 4);
        EXPECT_LT(size.z() / mm, 80 * options.obliqueFactor + 4);
        // Its lines come together a little: that fits closer than an oblique view.
        EXPECT_EQ(r.candidates[0].templateId, "cube");
        EXPECT_LT(r.candidates[0].residualPx, box->residualPx + 1e-9);
    }
}

TEST_F(OutsideDrawings, BoxesDrawnFlatOnAreObliqueBoxes) {
    const auto prisms =
        test::readExcalidrawLibrary(kData + "excalidraw_math-teacher.excalidrawlib");
    ASSERT_TRUE(prisms) << prisms.error().message;
    for (const test::LineDrawing& prism : *prisms) {
        if (prism.name.rfind("Rectangular Prism", 0) != 0) continue;
        SCOPED_TRACE(prism.name);
        const auto r = readStrokes(prism.visible());
        ASSERT_TRUE(r.accepted) << answerOf(r);
        EXPECT_EQ(&r.candidates[static_cast<std::size_t>(*r.accepted)], obliqueBox(r));
        // Both have a square front.
        const Vec3 size = boxSize(r.candidates[0]);
        EXPECT_NEAR(size.y() / size.x(), 1.0, 0.01);
        EXPECT_LT(size.z(), size.y());
    }
    const auto shapes = test::readExcalidrawLibrary(kData + "excalidraw_3d-shapes.excalidrawlib");
    ASSERT_TRUE(shapes) << shapes.error().message;
    for (const test::LineDrawing& shape : *shapes) {
        const auto r = readStrokes(shape.visible());
        if (shape.name == "cube") {
            const Candidate* box = obliqueBox(r);
            ASSERT_NE(box, nullptr) << answerOf(r);
            EXPECT_GT(box->score, 0.9);
        } else {
            // A cylinder: its straight lines are one flat outline.
            EXPECT_FALSE(r.accepted) << answerOf(r);
            ASSERT_TRUE(r.problem);
            EXPECT_EQ(r.problem->code, Errc::FlatDrawing);
        }
    }
}

/// Reads a drawing that shows no single shape of the library: never taken for one in silence,
/// always with a reason and with what was found.
void expectExplained(const std::string& name, const std::vector<Stroke>& strokes,
                     const std::vector<Errc>& codes) {
    SCOPED_TRACE(name);
    const auto r = readStrokes(strokes);
    EXPECT_FALSE(r.accepted) << answerOf(r);
    ASSERT_TRUE(r.problem);
    EXPECT_NE(std::find(codes.begin(), codes.end(), r.problem->code), codes.end()) << answerOf(r);
    EXPECT_FALSE(r.problem->message.empty());
    EXPECT_FALSE(r.problem->where.empty());
    EXPECT_FALSE(r.graph.empty());
    EXPECT_TRUE(!r.culprits.empty() || !r.repairs.empty());
    for (const Candidate& c : r.candidates) {
        for (const Vec3& v : c.spec.vertices) EXPECT_TRUE(v.allFinite());
    }
}

TEST_F(OutsideDrawings, WhatNoTemplateShowsIsExplained) {
    const std::vector<std::pair<const char*, std::vector<Errc>>> lineDrawings{
        {"packed_boxes_input.svg", {Errc::SeparateDrawings, Errc::NoMatch}},
        {"packed_boxes_output.svg", {Errc::SeparateDrawings, Errc::NoMatch, Errc::OpenEnd}},
    };
    for (const auto& [file, codes] : lineDrawings) {
        const auto drawing = test::readHiddenLineSvg(kData + file, 700);
        ASSERT_TRUE(drawing) << drawing.error().message;
        expectExplained(file, drawing->visible(), codes);
    }
    for (const char* file :
         {"building_SA_cluster.scap", "house_SA_cluster.scap", "archi10c_SA_cluster.scap"}) {
        const auto drawing = test::readScap(kData + file);
        ASSERT_TRUE(drawing) << drawing.error().message;
        // Open ends that would close nothing are no reason; the house's lines cross, too.
        expectExplained(file, drawing->visible(),
                        {Errc::SeparateDrawings, Errc::OpenEnd, Errc::NoMatch, Errc::SelfCrossing});
    }
}

// A square frustum with a top half as wide, over one corner of its base. A face is seen as a
// sliver.
TEST_F(OutsideDrawings, TheWedgeIsASlantedFrustum) {
    const auto drawing = test::readHiddenLineSvg(kData + "wedge_example.svg", 700);
    ASSERT_TRUE(drawing) << drawing.error().message;
    const auto r = readStrokes(drawing->visible());
    ASSERT_TRUE(r.accepted) << answerOf(r);
    const PolyhedronSpec& spec = r.candidates[static_cast<std::size_t>(*r.accepted)].spec;
    ASSERT_EQ(spec.vertices.size(), 8U);
    EXPECT_EQ(spec.faces.size(), 6U);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& face : spec.faces) {
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Vec3& from = spec.vertices[static_cast<std::size_t>(face[k])];
            const Vec3& to = spec.vertices[static_cast<std::size_t>(face[(k + 1) % face.size()])];
            least = std::min(least, (to - from).norm());
        }
    }
    // By Simpson's rule: areas of 1, 9/16 and 1/4 over a height of 1; the top's edges are 1/2.
    EXPECT_NEAR(test::volumeOf(spec) / std::pow(2.0 * least, 3), 7.0 / 12.0, 0.01);
}

// A plate with two hexagonal pockets and an open box: the outside is a box, what lies inside its
// upper face is ink that is left, ready to be cut out.
TEST_F(OutsideDrawings, WhatLiesInAFaceStaysInk) {
    for (const char* file : {"general_ex7.svg", "general_ex26.svg"}) {
        SCOPED_TRACE(file);
        const auto drawing = test::readHiddenLineSvg(kData + file, 700);
        ASSERT_TRUE(drawing) << drawing.error().message;
        const auto r = readStrokes(drawing->visible());
        ASSERT_TRUE(r.accepted) << answerOf(r);
        const Candidate& c = r.candidates[static_cast<std::size_t>(*r.accepted)];
        EXPECT_EQ(c.templateId, "cube");
        EXPECT_EQ(drawing->visible().size() - c.unusedStrokes.size(), 9u);
    }
}

}  // namespace
}  // namespace ew
