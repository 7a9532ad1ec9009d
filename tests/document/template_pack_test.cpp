// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/template_pack.h"

#include <gtest/gtest.h>
#include <zip.h>

#include <QCoreApplication>
#include <QProcess>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>
#include <random>

#include "core/document/file_bytes.h"
#include "core/document/zip_file.h"
#include "core/tlib/template_io.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

TemplatePack twoBoxes() {
    return {"Two boxes",
            "Ada",
            "CC0-1.0",
            "2.1",
            {test::boxTemplate("box-a", "Box A"), test::boxTemplate("box-b", "B\xc3\xb6x B")}};
}

std::string packed(const std::vector<ZipEntry>& entries) {
    const auto bytes = zipBytes(entries);
    EXPECT_TRUE(bytes);
    return *bytes;
}

const char* const kManifest = R"({"format": "edgewright-templates", "version": 1, "name": "N"})";

ZipEntry boxEntry(const std::string& name = "templates/box.json") {
    return {name, writeTemplate(test::boxTemplate("box", "Box"))};
}

TEST(TemplatePacks, ComeBackAsTheyWere) {
    const auto bytes = writeTemplatePack(twoBoxes());
    ASSERT_TRUE(bytes) << bytes.error().message;
    EXPECT_EQ(*bytes, *writeTemplatePack(twoBoxes()));
    const auto read = readTemplatePack(*bytes, "p");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->name, "Two boxes");
    EXPECT_EQ(read->author, "Ada");
    EXPECT_EQ(read->licence, "CC0-1.0");
    EXPECT_EQ(read->version, "2.1");
    ASSERT_EQ(read->templates.size(), 2U);
    EXPECT_EQ(writeTemplate(read->templates[1]), writeTemplate(twoBoxes().templates[1]));
}

TEST(TemplatePacks, WhatDoesNotBelongThereIsRefused) {
    struct Case {
        std::vector<ZipEntry> entries;
        Errc code;
        const char* named;
    };
    const ZipEntry manifest{"manifest.json", kManifest};
    const std::vector<Case> table{
        {{boxEntry()}, Errc::MissingKey, "manifest"},
        {{manifest}, Errc::BadValue, "no template"},
        {{manifest, boxEntry("../box.json")}, Errc::BadValue, "../box.json"},
        {{manifest, boxEntry("templates/../../box.json")}, Errc::BadValue, ".."},
        {{manifest, boxEntry("/etc/box.json")}, Errc::BadValue, "/etc/box.json"},
        {{manifest, boxEntry("templates\\box.json")}, Errc::BadValue, "box.json"},
        {{manifest, boxEntry("c:box.json")}, Errc::BadValue, "c:box.json"},
        {{manifest, boxEntry("templates/deep/box.json")}, Errc::BadValue, "deep"},
        {{manifest, boxEntry(), {"run.sh", "rm"}}, Errc::BadValue, "run.sh"},
        {{manifest, boxEntry(), boxEntry("templates/again.json")}, Errc::DuplicateId, "box"},
        {{manifest, {"templates/box.json", "{"}}, Errc::Syntax, "templates/box.json"},
        {{{"manifest.json", "{}"}, boxEntry()}, Errc::MissingKey, "manifest.json"},
        {{{"manifest.json", R"({"format": "x", "version": 1, "name": "N"})"}, boxEntry()},
         Errc::WrongFormat,
         "manifest.json"},
        {{{"manifest.json", R"({"format": "edgewright-templates", "version": 9, "name": "N"})"},
          boxEntry()},
         Errc::WrongVersion,
         "manifest.json"},
        {{manifest, {"templates/box.json", std::string(std::size_t{2} << 20U, ' ')}},
         Errc::TooLarge,
         "box.json"}};
    for (const Case& c : table) {
        const auto read = readTemplatePack(packed(c.entries), "p");
        ASSERT_FALSE(read) << c.named;
        EXPECT_EQ(read.error().code, c.code) << read.error().message;
        EXPECT_NE(read.error().message.find(c.named), std::string::npos) << read.error().message;
    }
}

TEST(TemplatePacks, ABombIsNotUnpacked) {
    std::vector<ZipEntry> entries{{"manifest.json", kManifest}};
    for (int i = 0; i < 100; ++i) {
        entries.push_back({"templates/t" + std::to_string(i) + ".json",
                           std::string(std::size_t{1000} << 10U, ' ')});
    }
    const std::string bytes = packed(entries);
    EXPECT_LT(bytes.size(), std::size_t{1} << 20U);
    const auto read = readZip(bytes, {});
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, Errc::TooLarge);
    ZipLimits few;
    few.entries = 3;
    EXPECT_EQ(readZip(bytes, few).error().code, Errc::TooLarge);
}

TEST(TemplatePacks, ALinkIsRefused) {
    std::string bytes = packed({{"manifest.json", kManifest}, boxEntry()});
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("p.zip"));
    ASSERT_TRUE(writeFileBytes(path, bytes));
    int error = 0;
    zip_t* zip = zip_open(path.toUtf8().constData(), 0, &error);
    ASSERT_NE(zip, nullptr);
    ASSERT_EQ(zip_file_set_external_attributes(zip, 1, 0, ZIP_OPSYS_UNIX, 0120777U << 16U), 0);
    ASSERT_EQ(zip_close(zip), 0);
    bytes = *readFileBytes(path, 1U << 20U);
    const auto read = readTemplatePack(bytes, "p");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, Errc::BadValue);
}

TEST(TemplatePacks, WhatIsCutOrChangedIsWholeOrRefused) {
    const std::string whole = *writeTemplatePack(twoBoxes());
    std::mt19937 random(4);
    for (int i = 0; i < 300; ++i) {
        std::string bad = whole;
        if (i % 3 == 0)
            bad.resize(random() % whole.size());
        else
            bad[random() % whole.size()] = static_cast<char>(random());
        const auto read = readTemplatePack(bad, "p");
        if (!read) {
            EXPECT_FALSE(read.error().message.empty());
            continue;
        }
        // Dates and the like may change; templates may not.
        ASSERT_EQ(read->templates.size(), 2U);
        EXPECT_EQ(writeTemplate(read->templates[0]), writeTemplate(twoBoxes().templates[0]));
    }
}

// The program ------------------------------------------------------------------------------------

class TemplateProgram : public testing::Test {
  protected:
    int run(const QStringList& arguments) {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.remove(QStringLiteral("DISPLAY"));
        process.setProcessEnvironment(environment);
        process.start(QCoreApplication::applicationDirPath() + "/../app/edgewright-template",
                      arguments);
        EXPECT_TRUE(process.waitForFinished(60'000));
        out_ = process.readAllStandardOutput().toStdString();
        err_ = process.readAllStandardError().toStdString();
        return process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    }
    void put(const QString& name, const std::string& text) {
        ASSERT_TRUE(writeFileBytes(folder_.filePath(name), text));
    }
    QTemporaryDir folder_;
    std::string out_, err_;
};

TEST_F(TemplateProgram, ChecksShippedTemplatesWithoutAWord) {
    const QString folder = QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/templates/");
    EXPECT_EQ(run({"check", folder + "cube.json", folder + "l-prism.json"}), 0) << out_;
    EXPECT_TRUE(out_.empty()) << out_;
}

TEST_F(TemplateProgram, NamesFaultsAtTheirPlaces) {
    std::string bad = writeTemplate(test::boxTemplate("box", "Box"));
    put("good.json", bad);
    const auto face = bad.find("\"faces\"");
    bad[bad.find('3', face)] = '9';
    put("bad.json", bad);
    put("cut.json", bad.substr(0, 40));
    EXPECT_EQ(run({"check", "good.json", "bad.json", "cut.json"}), 1);
    EXPECT_NE(out_.find("bad.json: /faces"), std::string::npos) << out_;
    EXPECT_NE(out_.find("cut.json: /: "), std::string::npos) << out_;
    EXPECT_EQ(out_.find("good.json: /"), std::string::npos) << out_;
    EXPECT_EQ(run({"check", "--json", "good.json", "bad.json"}), 1);
    const auto told = nlohmann::json::parse(out_);
    EXPECT_EQ(told["templates"].size(), 1U);
    ASSERT_EQ(told["faults"].size(), 1U);
    EXPECT_EQ(told["faults"][0]["file"], "bad.json");
    put("twin.json", writeTemplate(test::boxTemplate("box", "Box")));
    EXPECT_EQ(run({"check", "good.json", "twin.json"}), 1);
    EXPECT_NE(out_.find("twin.json: /id: "), std::string::npos) << out_;
}

TEST_F(TemplateProgram, PacksAndListsAspects) {
    put("a.json", writeTemplate(test::boxTemplate("box-a", "A")));
    put("b.json", writeTemplate(test::boxTemplate("box-b", "B")));
    EXPECT_EQ(run({"pack", "a.json", "b.json", "--out", "two", "--name", "Two", "--author", "Me"}),
              0)
        << err_;
    EXPECT_EQ(run({"check", "two.edgewright-templates"}), 0) << out_;
    EXPECT_EQ(run({"aspects", "--json", "two.edgewright-templates"}), 0) << err_;
    const auto told = nlohmann::json::parse(out_);
    ASSERT_EQ(told["templates"].size(), 2U);
    EXPECT_EQ(told["templates"][1]["id"], "box-b");
    EXPECT_GE(told["templates"][0]["aspects"].size(), 2U);
    EXPECT_EQ(run({"aspects", "a.json"}), 0);
    EXPECT_NE(out_.find("explicit-3"), std::string::npos) << out_;
}

TEST_F(TemplateProgram, ConvertsMeshesAndScripts) {
    // A box of two triangles a side.
    std::string obj;
    for (int i = 0; i < 8; ++i) {
        obj += "v " + std::to_string(i & 1) + " " + std::to_string(i >> 1 & 1) + " " +
               std::to_string(i >> 2) + "\n";
    }
    const std::vector<std::array<int, 4>> sides{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& [a, b, c, d] : sides) {
        for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{a, c, d}}) {
            obj += "f " + std::to_string(p + 1) + " " + std::to_string(q + 1) + " " +
                   std::to_string(r + 1) + "\n";
        }
    }
    put("My box.obj", obj);
    EXPECT_EQ(run({"convert", "My box.obj", "--out", "box.json"}), 0) << err_ << out_;
    const auto bytes = readFileBytes(folder_.filePath("box.json"), 1U << 20U);
    ASSERT_TRUE(bytes);
    const auto box = readTemplate(*bytes, "box.json");
    ASSERT_TRUE(box) << box.error().message;
    EXPECT_EQ(box->id, "my-box");
    EXPECT_EQ(box->name, "My box");
    EXPECT_EQ(box->shape.vertices.size(), 8U);
    EXPECT_EQ(box->relations.parallel.size(), 3U);
    EXPECT_EQ(box->relations.perpendicular.size(), 3U);

    const QString script = QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/examples/cube.json");
    EXPECT_EQ(run({"convert", script, "--out", "cube.json", "--name", "Die", "--id", "die"}), 0)
        << err_ << out_;
    EXPECT_EQ(run({"check", "cube.json", "box.json"}), 0) << out_;

    put("open.obj", obj.substr(0, obj.rfind("f ")));
    EXPECT_EQ(run({"convert", "open.obj", "--out", "o.json"}), 1);
    EXPECT_EQ(out_, "open.obj: /: The mesh is not closed.\n");
    EXPECT_FALSE(QFile::exists(folder_.filePath("o.json")));
    EXPECT_EQ(run({"convert", "open.obj"}), 2);
    EXPECT_EQ(run({"convert", "gone.obj", "--out", "o.json"}), 2);
}

TEST_F(TemplateProgram, UnusableArgumentsAndFilesAreStatusTwo) {
    put("a.json", writeTemplate(test::boxTemplate("box-a", "A")));
    for (const QStringList& arguments :
         {QStringList{},
          {"check"},
          {"frobnicate", "a.json"},
          {"check", "missing.json"},
          {"check", "."},
          {"check", "--fast", "a.json"},
          {"pack", "a.json"},
          {"pack", "a.json", "--out"},
          {"pack", "a.json", "--out", "no/such/folder", "--name", "N"}}) {
        EXPECT_EQ(run(arguments), 2) << arguments.join(' ').toStdString();
        EXPECT_FALSE(err_.empty());
    }
    EXPECT_EQ(run({"--help"}), 0);
    EXPECT_EQ(run({"--version"}), 0);
}

}  // namespace
}  // namespace ew
