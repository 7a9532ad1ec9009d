// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/line_drawings.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

namespace ew::test {
namespace {

/// Tests on files that may not be there.
class OutsideFiles : public ::testing::Test {
  protected:
    void SetUp() override {
        if (kData.empty()) GTEST_SKIP() << "no drawings from outside: EDGEWRIGHT_DRAWINGS";
    }
    const std::string kData = outsideDrawings();
};

double diagonalOf(const LineDrawing& drawing) {
    Vec2 low(1e9, 1e9), high(-1e9, -1e9);
    for (const ImportedStroke& s : drawing.strokes) {
        for (const PenSample& p : s.stroke.samples) {
            low = low.cwiseMin(p.position);
            high = high.cwiseMax(p.position);
        }
    }
    EXPECT_LT(((low + high) / 2 - Vec2(640, 400)).norm(), 1e-9);
    return (high - low).norm();
}

TEST_F(OutsideFiles, HiddenLineDrawingsHaveTheLinesOfABox) {
    for (const char* file : {"box_example.svg", "general_ex1.svg"}) {
        const auto drawing = readHiddenLineSvg(kData + file, 320);
        ASSERT_TRUE(drawing) << drawing.error().message;
        EXPECT_EQ(drawing->strokes.size(), 12U);
        EXPECT_EQ(drawing->visible().size(), 9U);
        EXPECT_NEAR(diagonalOf(*drawing), 320, 1e-9);
        for (const ImportedStroke& s : drawing->strokes) ASSERT_TRUE(validateStroke(s.stroke));
    }
}

// y is up in the file: the box's lowest corner (-0.9465 in the file) is the lowest on the screen.
TEST_F(OutsideFiles, ThePictureIsTheRightWayUp) {
    const auto drawing = readHiddenLineSvg(kData + "box_example.svg");
    ASSERT_TRUE(drawing);
    const Vec2 lowest = drawing->strokes[0].stroke.samples.front().position;
    for (const ImportedStroke& s : drawing->strokes) {
        for (const PenSample& p : s.stroke.samples) EXPECT_LE(p.position.y(), lowest.y());
    }
    EXPECT_NEAR(lowest.x() - 640, 0.223607 * drawing->pxPerUnit, 1e-9);
}

TEST_F(OutsideFiles, StrokesAreStraightAndDense) {
    const auto drawing = readHiddenLineSvg(kData + "wedge_example.svg");
    ASSERT_TRUE(drawing);
    for (const ImportedStroke& s : drawing->strokes) {
        const auto& p = s.stroke.samples;
        const Vec2 d = p.back().position - p.front().position;
        for (std::size_t i = 1; i < p.size(); ++i) {
            EXPECT_LT((p[i].position - p[i - 1].position).norm(), 8.0);
            EXPECT_LT(std::abs(cross2(d, p[i].position - p.front().position)) / d.norm(), 1e-9);
        }
    }
}

TEST_F(OutsideFiles, PenStrokesComeWithTheirClusters) {
    const auto drawing = readScap(kData + "building_SA_cluster.scap");
    ASSERT_TRUE(drawing) << drawing.error().message;
    std::set<int> clusters;
    for (const ImportedStroke& s : drawing->strokes) {
        EXPECT_GE(s.cluster, 0);
        clusters.insert(s.cluster);
        ASSERT_TRUE(validateStroke(s.stroke));
    }
    EXPECT_LT(clusters.size(), drawing->strokes.size());
    EXPECT_NEAR(diagonalOf(*drawing), kImportDiagonalPx, 1e-9);
    const auto first = *clusters.begin();
    const auto wanted = std::count_if(drawing->strokes.begin(), drawing->strokes.end(),
                                      [&](const ImportedStroke& s) { return s.cluster == first; });
    EXPECT_EQ(drawing->clusters({first}).size(), static_cast<std::size_t>(wanted));
    // The nine edges of the outer box, most of them drawn more than once.
    EXPECT_EQ(drawing->clusters(kBuildingOuterBox).size(), 18U);
}

TEST_F(OutsideFiles, EveryFileOfItsKindIsRead) {
    const auto house = readScap(kData + "house_SA_cluster.scap");
    ASSERT_TRUE(house) << house.error().message;
    EXPECT_NEAR(diagonalOf(*house), kImportDiagonalPx, 1e-9);
    const auto boxes = readHiddenLineSvg(kData + "packed_boxes_input.svg");
    ASSERT_TRUE(boxes) << boxes.error().message;
    EXPECT_GT(boxes->visible().size(), 27U);  // more than three boxes
}

TEST_F(OutsideFiles, ExcalidrawItemsAreDrawings) {
    const auto shapes = readExcalidrawLibrary(kData + "excalidraw_3d-shapes.excalidrawlib");
    ASSERT_TRUE(shapes) << shapes.error().message;
    ASSERT_EQ(shapes->size(), 2U);
    EXPECT_EQ((*shapes)[1].name, "cube");
    EXPECT_EQ((*shapes)[1].strokes.size(), 3U);

    const auto prisms = readExcalidrawLibrary(kData + "excalidraw_math-teacher.excalidrawlib");
    ASSERT_TRUE(prisms) << prisms.error().message;
    int found = 0;
    for (const LineDrawing& prism : *prisms) {
        if (prism.name.rfind("Rectangular Prism", 0) != 0) continue;
        ++found;
        EXPECT_EQ(prism.strokes.size(), 12U);
        EXPECT_EQ(prism.visible().size(), 9U);
        // Turned lines must meet the others: no end is far from another line's end.
        for (const ImportedStroke& a : prism.strokes) {
            for (const PenSample& end : {a.stroke.samples.front(), a.stroke.samples.back()}) {
                double nearest = 1e9;
                for (const ImportedStroke& b : prism.strokes) {
                    if (&a == &b) continue;
                    for (const PenSample& p : {b.stroke.samples.front(), b.stroke.samples.back()}) {
                        nearest = std::min(nearest, (p.position - end.position).norm());
                    }
                }
                EXPECT_LT(nearest, 15.0) << prism.name;
            }
        }
    }
    EXPECT_EQ(found, 2);
}

TEST(LineDrawings, BadFilesAreRefused) {
    EXPECT_EQ(readScap("/no/folder/absent.scap").error().code, Errc::FileNotFound);
    EXPECT_EQ(readHiddenLineSvg("/no/folder/absent.svg").error().code, Errc::FileNotFound);
    const auto folder = std::filesystem::temp_directory_path() /
                        ("edgewright-line-drawings-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const auto write = [&](const std::string& name, const std::string& text) {
        std::ofstream(folder / name) << text;
        return (folder / name).string();
    };
    EXPECT_EQ(readScap(write("a.scap", "#1 1\n{\n#0 0\n1 2 0\n")).error().code, Errc::WrongFormat);
    EXPECT_EQ(readScap(write("b.scap", "1 2 0\n")).error().code, Errc::WrongFormat);
    EXPECT_EQ(readScap(write("c.scap", "")).error().code, Errc::WrongFormat);
    EXPECT_EQ(
        readHiddenLineSvg(write("a.svg", "<g id=\"Visible\"><line x1=\"1\"/></g>")).error().code,
        Errc::WrongFormat);
    EXPECT_EQ(readExcalidrawLibrary(write("a.excalidrawlib", "{\"libraryItems\": 3")).error().code,
              Errc::WrongFormat);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace ew::test
