// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/template_io.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace ew::test {
namespace {

namespace fs = std::filesystem;

fs::path folder() { return fs::path(EDGEWRIGHT_SOURCE_DIR) / "resources" / "templates"; }

std::string textOf(const std::string& name) {
    std::ifstream in(folder() / name, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    EXPECT_FALSE(text.str().empty()) << name;
    return text.str();
}

/// The text with its first `what` replaced.
std::string with(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

std::string cubeWith(const std::string& what, const std::string& by) {
    return with(textOf("cube.json"), what, by);
}

TEST(TemplateIo, ShippedTemplatesAreReadAndWrittenBack) {
    std::vector<std::string> ids;
    for (const auto& entry : fs::directory_iterator(folder())) {
        if (entry.path().extension() != ".json") continue;
        const std::string text = textOf(entry.path().filename().string());
        const auto tmpl = readTemplate(text, entry.path().filename().string());
        ASSERT_TRUE(tmpl) << tmpl.error().message;
        EXPECT_EQ(tmpl->id + ".json", entry.path().filename().string());
        EXPECT_EQ(writeTemplate(*tmpl), text) << tmpl->id;
        ids.push_back(tmpl->id);
    }
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(ids, (std::vector<std::string>{"cube", "l-prism", "triangular-prism",
                                             "triangular-pyramid", "wedge-frustum"}));
}

Template withAbout() {
    Template t = *readTemplate(textOf("cube.json"), "cube.json");
    t.about = {"Boxes", {"crate", "b\xc3\xb6x"}, "A. Person", "CC0-1.0", "1.2", {}};
    t.about.inLanguage["de"] = {"Quader", "Sechs Rechtecke."};
    t.about.inLanguage["pt-BR"] = {"Caixa", ""};
    return t;
}

TEST(TemplateIo, KeepsWhoMadeItAndOtherLanguages) {
    const Template t = withAbout();
    const std::string text = writeTemplate(t);
    const auto read = readTemplate(text, "t");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->about, t.about);
    EXPECT_EQ(writeTemplate(*read), text);
}

TEST(TemplateIo, RefusesBadWordsAboutATemplate) {
    const auto messageFor = [](auto change) {
        Template t = withAbout();
        change(t.about);
        const auto ok = checkTemplate(t, "t");
        return ok ? std::string() : ok.error().message;
    };
    EXPECT_EQ(messageFor([](auto&) {}), "");
    EXPECT_NE(messageFor([](auto& a) { a.tags.push_back("crate"); }).find("/tags/2"),
              std::string::npos);
    EXPECT_NE(messageFor([](auto& a) { a.tags.push_back(""); }).find("/tags/2"), std::string::npos);
    EXPECT_NE(messageFor([](auto& a) { a.tags.resize(33, "x"); }).find("/tags"), std::string::npos);
    EXPECT_NE(messageFor([](auto& a) { a.author = "a\nb"; }).find("/author"), std::string::npos);
    EXPECT_NE(messageFor([](auto& a) { a.licence.assign(501, 'x'); }).find("/licence"),
              std::string::npos);
    for (const char* code : {"", "d", "German", "DE", "de-", "de-x", "de-123456789", "de_AT"}) {
        EXPECT_NE(messageFor([&](auto& a) { a.inLanguage[code].name = "x"; }).find("/languages/"),
                  std::string::npos)
            << code;
    }
    EXPECT_NE(messageFor([](auto& a) { a.inLanguage["fr"] = {}; }).find("/languages/fr"),
              std::string::npos);
    EXPECT_EQ(
        readTemplate(cubeWith("\"vertices\"", "\"tags\": \"a\", \"vertices\""), "t").error().code,
        Errc::WrongType);
    EXPECT_EQ(readTemplate(cubeWith("\"vertices\"",
                                    "\"languages\": {\"de\": {\"title\": \"\"}}, \"vertices\""),
                           "t")
                  .error()
                  .code,
              Errc::UnknownKey);
}

TEST(TemplateIo, ReadsEverythingThatTheFileSays) {
    const auto prism = readTemplate(textOf("triangular-prism.json"), "triangular-prism.json");
    ASSERT_TRUE(prism) << prism.error().message;
    EXPECT_EQ(prism->name, "Triangular prism");
    EXPECT_FALSE(prism->description.empty());
    EXPECT_EQ(prism->shape.vertices.size(), 6U);
    EXPECT_EQ(prism->shape.vertices[4], Vec3(1, 0, 1));
    EXPECT_EQ(prism->shape.faces[1], (std::vector<int>{3, 4, 5}));
    ASSERT_EQ(prism->relations.parallel.size(), 4U);
    EXPECT_EQ(prism->relations.parallel[3],
              (std::vector<TemplateEdge>{TemplateEdge{2, 0}, TemplateEdge{5, 3}}));
    EXPECT_EQ(prism->relations.perpendicular.size(), 3U);
    EXPECT_TRUE(prism->relations.equalLength.empty());
    ASSERT_EQ(prism->readings.size(), 2U);
    EXPECT_EQ(prism->readings[0].id, "isosceles");
    EXPECT_EQ(prism->readings[0].relations.equalLength.size(), 1U);
    EXPECT_EQ(prism->readings[1].name, "Right-angled");
}

TEST(TemplateIo, ShippedReferenceShapesAreTheMostRegularOnes) {
    const auto edgeLengths = [](const std::string& name) {
        const auto t = readTemplate(textOf(name), name);
        std::vector<double> out;
        for (const auto& face : t->shape.faces) {
            for (std::size_t k = 0; k < face.size(); ++k) {
                const auto a = static_cast<std::size_t>(face[k]);
                const auto b = static_cast<std::size_t>(face[(k + 1) % face.size()]);
                out.push_back((t->shape.vertices[a] - t->shape.vertices[b]).norm());
            }
        }
        return out;
    };
    for (const char* name : {"cube.json", "triangular-prism.json", "triangular-pyramid.json"}) {
        for (const double length : edgeLengths(name)) EXPECT_NEAR(length, 1.0, 1e-15) << name;
    }
}

TEST(TemplateIo, AsciiAndOtherTextsSurvive) {
    auto tmpl = readTemplate(textOf("cube.json"), "cube.json");
    ASSERT_TRUE(tmpl);
    tmpl->name = "W\xc3\xbcrfel \"A\\B\"";
    const auto back = readTemplate(writeTemplate(*tmpl), "x");
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->name, tmpl->name);
}

struct Case {
    std::string name;
    std::string text;
    Errc code;
    std::string place;  ///< the message holds it
};

std::vector<Case> syntaxCases() {
    const std::string cube = textOf("cube.json");
    return {
        {"empty", "", Errc::Syntax, "t.json: /: "},
        {"not JSON", "solid cube", Errc::Syntax, "line 1"},
        {"comment", "// note\n" + cube, Errc::Syntax, "line 1"},
        {"line of the fault", with(cube, "[1, 1, 0],", "[1, 1, 0"), Errc::Syntax, "line 11"},
        {"NaN", cubeWith("[1, 1, 0]", "[1, NaN, 0]"), Errc::Syntax, "line 10"},
        {"bytes that are no text", cubeWith("Cube", "\xff\xfe"), Errc::Syntax, "/: "},
        {"key twice", cubeWith("\"version\": 1", "\"version\": 1, \"version\": 1"), Errc::Syntax,
         "\"version\""},
        {"1e999", cubeWith("[1, 1, 0]", "[1, 1e999, 0]"), Errc::BadValue, "too large"},
        {"deep", std::string(1'000'000, '['), Errc::TooDeep, "32"},
        {"deep in a value", cubeWith("[1, 1, 0]", std::string(40, '[') + std::string(40, ']')),
         Errc::TooDeep, "32"},
        {"large", cube + std::string(4U << 20U, ' '), Errc::TooLarge, "4 MiB"},
        {"a list", "[]", Errc::WrongFormat, "/: "},
        {"another format", cubeWith("edgewright-template", "edgewright-sketch"), Errc::WrongFormat,
         "/format"},
        {"no format", cubeWith("\"format\": \"edgewright-template\",", ""), Errc::WrongFormat,
         "/format"},
        {"version 2", cubeWith("\"version\": 1", "\"version\": 2"), Errc::WrongVersion, "/version"},
        {"version text", cubeWith("\"version\": 1", "\"version\": \"1\""), Errc::WrongType,
         "/version"},
        {"no version", cubeWith("\"version\": 1,", ""), Errc::MissingKey, "version"},
        {"no id", cubeWith("\"id\": \"cube\",", ""), Errc::MissingKey, "\"id\""},
        {"unknown key", cubeWith("\"id\"", "\"colour\": 1, \"id\""), Errc::UnknownKey,
         "\"colour\""},
        {"unknown relation", cubeWith("\"parallel\"", "\"paralel\""), Errc::UnknownKey,
         "/relations: unknown key \"paralel\""},
        {"name no text", cubeWith("\"Cube\"", "7"), Errc::WrongType, "/name"},
        {"two numbers", cubeWith("[1, 1, 0]", "[1, 1]"), Errc::WrongType, "/vertices/2:"},
        {"text for a number", cubeWith("[1, 1, 0]", "[1, 1, \"0\"]"), Errc::WrongType,
         "/vertices/2/2"},
        {"null for a number", cubeWith("[1, 1, 0]", "[1, null, 0]"), Errc::WrongType,
         "/vertices/2/1"},
        {"fraction for an index", cubeWith("[0, 1, 5, 4]", "[0, 1.0, 5, 4]"), Errc::WrongType,
         "/faces/2/1"},
        {"faces no list", cubeWith("\"faces\": [", "\"faces\": 5, \"relations\": ["), Errc::Syntax,
         ""},
        {"edge of three", cubeWith("[[0, 1], [0, 3]]", "[[0, 1, 2], [0, 3]]"), Errc::WrongType,
         "/relations/perpendicular/0/0"},
        {"pair of three", cubeWith("[[0, 1], [0, 3]]", "[[0, 1], [0, 3], [0, 4]]"), Errc::WrongType,
         "/relations/perpendicular/0:"},
        {"reading without a name",
         with(textOf("triangular-prism.json"), "\"name\": \"Isosceles\",", ""), Errc::MissingKey,
         "/readings/0"},
    };
}

std::vector<Case> shapeCases() {
    const std::string bottom = "[0, 3, 2, 1]";
    const std::string front = "[0, 1, 5, 4]";
    return {
        {"id with a space", cubeWith("\"cube\"", "\"my cube\""), Errc::BadTemplate, "/id"},
        {"id empty", cubeWith("\"cube\"", "\"\""), Errc::BadTemplate, "/id"},
        {"id long", cubeWith("\"cube\"", "\"" + std::string(65, 'a') + "\""), Errc::BadTemplate,
         "/id"},
        {"name empty", cubeWith("\"Cube\"", "\"\""), Errc::BadTemplate, "/name"},
        {"name long", cubeWith("\"Cube\"", "\"" + std::string(501, 'a') + "\""), Errc::BadTemplate,
         "/name"},
        {"name with a line break", cubeWith("\"Cube\"", "\"a\\nb\""), Errc::BadTemplate, "/name"},
        {"index too large", cubeWith(front, "[9, 1, 5, 4]"), Errc::BadTemplate,
         "t.json: /faces/2/0: vertex 9 does not exist; there are 8 vertices."},
        {"index negative", cubeWith(front, "[-1, 1, 5, 4]"), Errc::BadTemplate, "/faces/2/0"},
        {"index huge", cubeWith(front, "[99999999999999999999, 1, 5, 4]"), Errc::WrongType,
         "/faces/2/0"},
        {"index of 2^32", cubeWith(front, "[4294967296, 1, 5, 4]"), Errc::BadTemplate,
         "/faces/2/0"},
        {"vertex twice in a face", cubeWith(front, "[0, 1, 0, 4]"), Errc::BadTemplate,
         "/faces/2/0"},
        {"face of two", cubeWith(front, "[0, 1]"), Errc::BadTemplate, "/faces/2:"},
        {"not closed", cubeWith(bottom + ",", ""), Errc::BadTemplate, "not closed"},
        {"face turned", cubeWith(bottom, "[0, 1, 2, 3]"), Errc::BadTemplate, "inside out"},
        {"vertex unused", cubeWith("[0, 1, 1]\n", "[0, 1, 1],\n    [9, 9, 9]\n"), Errc::BadTemplate,
         "/vertices/8"},
        {"too far out", cubeWith("[1, 1, 0]", "[1, 1e308, 0]"), Errc::BadTemplate, "/vertices/2"},
        {"not planar", cubeWith("[1, 1, 1]", "[1, 1, 1.01]"), Errc::BadTemplate,
         "off the face's plane"},
        {"edge without length", cubeWith("[1, 1, 1]", "[1, 1, 0]"), Errc::BadTemplate, "no length"},
        {"three vertices", R"({"format":"edgewright-template","version":1,"id":"x","name":"x",
            "vertices":[[0,0,0],[1,0,0],[0,1,0]],"faces":[[0,1,2],[2,1,0]]})",
         Errc::BadTemplate, "/vertices"},
        {"two faces", R"({"format":"edgewright-template","version":1,"id":"x","name":"x",
            "vertices":[[0,0,0],[1,0,0],[1,1,0],[0,1,0]],"faces":[[0,1,2,3],[3,2,1,0]]})",
         Errc::BadTemplate, "/faces"},
        {"two tetrahedra", R"({"format":"edgewright-template","version":1,"id":"x","name":"x",
            "vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1],[5,0,0],[6,0,0],[5,1,0],[5,0,1]],
            "faces":[[0,2,1],[0,1,3],[1,2,3],[2,0,3],[4,6,5],[4,5,7],[5,6,7],[6,4,7]]})",
         Errc::BadTemplate, "not connected"},
        {"two tetrahedra with one tip",
         R"({"format":"edgewright-template","version":1,"id":"x","name":"x",
            "vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1],[-1,0,0],[0,-1,0],[0,0,-1]],
            "faces":[[0,2,1],[0,1,3],[1,2,3],[2,0,3],[0,4,5],[0,6,4],[4,6,5],[5,6,0]]})",
         Errc::BadTemplate, "touch in this vertex only"},
        {"inside out", R"({"format":"edgewright-template","version":1,"id":"x","name":"x",
            "vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],
            "faces":[[0,1,2],[0,3,1],[1,3,2],[2,3,0]]})",
         Errc::BadTemplate, "inwards"},
        {"folded flat", R"({"format":"edgewright-template","version":1,"id":"x","name":"x",
            "vertices":[[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0.5,0.5,1]],
            "faces":[[0,2,1],[0,3,2],[0,1,4],[1,2,4],[2,3,4],[3,0,4]]})",
         Errc::BadTemplate, "one plane"},
        {"pierces its base", R"({"format":"edgewright-template","version":1,"id":"x","name":"x",
            "vertices":[[0,0,0],[4,0,0],[4,4,0],[0,4,0],[1,1,2],[3,1,-1],[2,3,2]],
            "faces":[[0,3,2,1],[0,1,4],[1,5,4],[1,2,5],[2,6,5],[2,3,6],[3,0,6],[0,4,6],[4,5,6]]})",
         Errc::BadTemplate, "cut through"},
    };
}

std::vector<Case> relationCases() {
    const std::string prism = textOf("triangular-prism.json");
    const std::string parallel = "[[0, 1], [3, 2], [4, 5], [7, 6]]";
    const std::string square = "[[0, 1], [0, 3]]";
    const std::string isosceles = "[[0, 1], [0, 2]]\n        ]\n      }\n    },";
    return {
        {"no such edge", cubeWith(square, "[[0, 2], [0, 3]]"), Errc::BadTemplate,
         "/relations/perpendicular/0/0: there is no edge 0-2"},
        {"no such vertex", cubeWith(square, "[[0, 77], [0, 3]]"), Errc::BadTemplate,
         "/relations/perpendicular/0/0/1"},
        {"class of one", cubeWith(parallel, "[[0, 1]]"), Errc::BadTemplate,
         "/relations/parallel/0:"},
        {"edge twice", cubeWith(parallel, "[[0, 1], [1, 0]]"), Errc::BadTemplate,
         "/relations/parallel/0/1: edge 1-0 stands twice"},
        {"against the class", cubeWith(parallel, "[[0, 1], [2, 3]]"), Errc::BadTemplate,
         "/relations/parallel/0/1"},
        {"not parallel", with(prism, "[[1, 2], [4, 5]]", "[[1, 2], [5, 3]]"), Errc::BadTemplate,
         "/relations/parallel/2/1: edge 5-3 of the reference shape is not parallel"},
        {"parallel to its own neighbour", cubeWith(parallel, "[[0, 1], [0, 3]]"), Errc::BadTemplate,
         "/relations/perpendicular/0: edges 0-1 and 0-3 are parallel too"},
        {"not perpendicular", with(prism, "[[0, 3], [0, 1]]", "[[0, 1], [0, 2]]"),
         Errc::BadTemplate, "/relations/perpendicular/0"},
        {"parallel and perpendicular",
         cubeWith("[[0, 4], [0, 1]]", "[[0, 4], [0, 1]],\n      [[0, 1], [7, 6]]"),
         Errc::BadTemplate, "/relations/perpendicular/3: edges 0-1 and 7-6 are parallel too"},
        {"not of equal length",
         with(textOf("l-prism.json"), "\"perpendicular\"",
              "\"equal_length\": [[[0, 1], [1, 2]]], \"perpendicular\""),
         Errc::BadTemplate, "/relations/equal_length/0/1"},
        {"reading with no such edge", with(prism, isosceles, with(isosceles, "[0, 1]", "[0, 5]")),
         Errc::BadTemplate, "/readings/0/relations/equal_length/0/0"},
        {"reading against the template",
         with(prism, "\"perpendicular\": [\n          [[0, 1], [0, 2]]",
              "\"perpendicular\": [\n          [[0, 1], [3, 4]]"),
         Errc::BadTemplate, "/readings/1/relations/perpendicular/0"},
        {"reading named default", with(prism, "\"isosceles\"", "\"default\""), Errc::BadTemplate,
         "/readings/0/id"},
        {"reading named twice", with(prism, "\"isosceles\"", "\"right-angled\""), Errc::BadTemplate,
         "/readings/1/id"},
    };
}

void expectRefused(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
        SCOPED_TRACE(c.name);
        const auto tmpl = readTemplate(c.text, "t.json");
        ASSERT_FALSE(tmpl);
        EXPECT_EQ(errcName(tmpl.error().code), errcName(c.code)) << tmpl.error().message;
        EXPECT_NE(tmpl.error().message.find(c.place), std::string::npos) << tmpl.error().message;
        EXPECT_EQ(tmpl.error().message.rfind("t.json: /", 0), 0U) << tmpl.error().message;
        EXPECT_LT(tmpl.error().message.size(), 300U);
    }
}

TEST(TemplateIo, BadSyntaxAndTypesAreRefused) { expectRefused(syntaxCases()); }
TEST(TemplateIo, BadShapesAreRefused) { expectRefused(shapeCases()); }
TEST(TemplateIo, BadRelationsAreRefused) { expectRefused(relationCases()); }

TEST(TemplateIo, CutAnywhereIsRefused) {
    const std::string text = textOf("triangular-prism.json");
    for (std::size_t end = 0; end + 2 < text.size(); ++end) {
        const auto tmpl = readTemplate(text.substr(0, end), "t.json");
        ASSERT_FALSE(tmpl) << "cut at " << end;
        EXPECT_EQ(tmpl.error().code, Errc::Syntax);
    }
}

TEST(TemplateIo, CheckRefusesWhatNoFileCanHold) {
    auto tmpl = readTemplate(textOf("cube.json"), "cube.json");
    ASSERT_TRUE(tmpl);
    tmpl->shape.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
    const auto ok = checkTemplate(*tmpl, "mine");
    ASSERT_FALSE(ok);
    EXPECT_EQ(ok.error().code, Errc::BadTemplate);
    EXPECT_EQ(ok.error().message.rfind("mine: /vertices/3", 0), 0U) << ok.error().message;
}

RC_GTEST_PROP(TemplateIoProperty, MutatedFilesNeverCrash, ()) {
    static const std::string original = textOf("triangular-prism.json");
    std::string text = original;
    const int changes = *rc::gen::inRange(1, 6);
    const std::string alphabet = "0123456789-.e[]{},:\" \\";
    for (int c = 0; c < changes; ++c) {
        const auto at =
            static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(text.size())));
        text[at] = alphabet[static_cast<std::size_t>(
            *rc::gen::inRange(0, static_cast<int>(alphabet.size())))];
    }
    const auto tmpl = readTemplate(text, "t.json");
    if (tmpl) {
        const auto again = readTemplate(writeTemplate(*tmpl), "t.json");
        RC_ASSERT(again.has_value());
        RC_ASSERT(writeTemplate(*again) == writeTemplate(*tmpl));
    } else {
        RC_ASSERT(!tmpl.error().message.empty());
    }
}

}  // namespace
}  // namespace ew::test
