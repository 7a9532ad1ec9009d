// SPDX-License-Identifier: GPL-3.0-or-later
// Units, chosen bodies and progress of exports.
#include "core/document/export_options.h"

#include <gtest/gtest.h>

#include <QFileInfo>
#include <QTemporaryDir>
#include <cstring>
#include <sstream>

#include "core/document/export_mesh.h"
#include "core/document/file_bytes.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

class ExportOptionsTest : public testing::Test {
  protected:
    ExportOptionsTest() {
        for (const double x : {0.0, 100.0}) {
            Body body{*Solid::fromSpec(test::cornerBox(25.4, 50.8, 76.2)), {}};
            body.pose.translation = Vec3(x, 0, 0);
            bodies_.push_back(body);
        }
    }
    std::string path(const char* name) const { return folder_.filePath(name).toStdString(); }
    std::string bytes(const char* name) const {
        const auto read = readFileBytes(folder_.filePath(name), 1U << 24U);
        return read ? *read : "";
    }
    /// Largest coordinates of an OBJ file.
    Vec3 reach(const char* name) const {
        std::istringstream in(bytes(name));
        Vec3 most = Vec3::Zero();
        for (std::string line; std::getline(in, line);) {
            if (!line.starts_with("v ")) continue;
            std::istringstream numbers(line.substr(2));
            Vec3 p;
            numbers >> p.x() >> p.y() >> p.z();
            most = most.cwiseMax(p);
        }
        return most;
    }
    static std::size_t count(const std::string& text, const std::string& word) {
        std::size_t n = 0;
        for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
        return n;
    }

    QTemporaryDir folder_;
    std::vector<Body> bodies_;
};

TEST_F(ExportOptionsTest, LengthsAreInTheUnitThatIsAskedFor) {
    ExportOptions options;
    options.bodies = {0};
    ASSERT_TRUE(exportBodies(bodies_, path("mm.obj"), options));
    EXPECT_TRUE(reach("mm.obj").isApprox(Vec3(25.4, 50.8, 76.2), 1e-12));
    options.unit = ExportUnit::Inch;
    ASSERT_TRUE(exportBodies(bodies_, path("inch.obj"), options));
    EXPECT_TRUE(reach("inch.obj").isApprox(Vec3(1, 2, 3), 1e-12));
    EXPECT_TRUE(bytes("inch.obj").starts_with("# Edgewright, inch\n"));
    options.unit = ExportUnit::Metre;
    ASSERT_TRUE(exportBodies(bodies_, path("m.stl"), options));
    EXPECT_TRUE(bytes("m.stl").starts_with("Edgewright, m "));
    ASSERT_TRUE(exportBodies(bodies_, path("m.ply"), options));
    EXPECT_NE(bytes("m.ply").find("comment Edgewright, m\n"), std::string::npos);
}

TEST_F(ExportOptionsTest, FormatsWithAUnitKeepTheirs) {
    for (const char* name : {"a.glb", "a.3mf"}) {
        ASSERT_TRUE(exportBodies(bodies_, path(name)));
        const std::string plain = bytes(name);
        ExportOptions inch;
        inch.unit = ExportUnit::Inch;
        ASSERT_TRUE(exportBodies(bodies_, path(name), inch));
        EXPECT_EQ(bytes(name), plain);
        EXPECT_FALSE(formatLacksUnit(path(name)));
    }
    for (const char* name : {"a.obj", "a.STL", "x.y.Ply"}) EXPECT_TRUE(formatLacksUnit(name));
    EXPECT_FALSE(formatLacksUnit("obj"));
}

TEST_F(ExportOptionsTest, OnlyChosenBodiesAreWritten) {
    ASSERT_TRUE(exportBodies(bodies_, path("all.obj")));
    EXPECT_EQ(count(bytes("all.obj"), "\no body"), 2U);
    ExportOptions second;
    second.bodies = {1, 1};
    ASSERT_TRUE(exportBodies(bodies_, path("one.obj"), second));
    EXPECT_EQ(count(bytes("one.obj"), "\no body"), 1U);
    EXPECT_NEAR(reach("one.obj").x(), 125.4, 1e-9);
    second.bodies = {2};
    const auto refused = exportBodies(bodies_, path("none.obj"), second);
    EXPECT_EQ(refused.error().code, Errc::BadValue);
    EXPECT_FALSE(QFileInfo::exists(folder_.filePath("none.obj")));
}

TEST_F(ExportOptionsTest, ProgressRisesAndGivingUpAnywhereKeepsTheOldFile) {
    for (const char* name : {"a.obj", "a.stl", "a.ply", "a.glb", "a.3mf"}) {
        ASSERT_TRUE(exportBodies(bodies_, path(name)));
        const std::string before = bytes(name);
        std::vector<double> shares;
        ExportOptions options;
        options.progress = [&](double share) {
            shares.push_back(share);
            return true;
        };
        ASSERT_TRUE(exportBodies(bodies_, path(name), options));
        ASSERT_GE(shares.size(), 3U);
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
        EXPECT_GE(shares.front(), 0.0);
        EXPECT_LE(shares.back(), 1.0);
        ASSERT_TRUE(writeFileBytes(folder_.filePath(name), "old"));
        for (std::size_t stop = 0; stop < shares.size(); ++stop) {
            std::size_t told = 0;
            options.progress = [&](double) { return told++ != stop; };
            const auto done = exportBodies(bodies_, path(name), options);
            ASSERT_FALSE(done) << name << " " << stop;
            EXPECT_EQ(done.error().code, Errc::Cancelled);
            EXPECT_EQ(bytes(name), "old");
        }
        ASSERT_TRUE(exportBodies(bodies_, path(name)));
        EXPECT_EQ(bytes(name), before);
    }
}

}  // namespace
}  // namespace ew
