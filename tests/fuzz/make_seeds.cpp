// SPDX-License-Identifier: GPL-3.0-or-later
// Writes inputs that the fuzz targets start from, a folder a target, out of the templates and
// examples of the source tree and, where they are there, drawings from outside:
//   make_seeds FOLDER
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/document/replay.h"
#include "core/document/store.h"
#include "core/document/store_blobs.h"
#include "core/document/template_pack.h"
#include "tests/fuzz/fuzz_scenes.h"
#include "tests/fuzz/fuzz_strokes.h"
#include "tests/support/line_drawings.h"

namespace {

namespace fs = std::filesystem;
const std::string kSource = EDGEWRIGHT_SOURCE_DIR;

class Seeds {
  public:
    explicit Seeds(fs::path folder) : folder_(std::move(folder)) {}
    bool put(const std::string& target, const std::string& name, const std::string& bytes) const {
        fs::create_directories(folder_ / target);
        std::ofstream file(folder_ / target / name, std::ios::binary);
        file << bytes;
        file.close();
        if (!file) std::fprintf(stderr, "make_seeds: cannot write %s\n", name.c_str());
        return !file.fail();
    }

  private:
    fs::path folder_;
};

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A script with only every `every`th sample of its strokes: the shorter, the faster it is tried.
std::string thinned(const ew::SketchScript& script, std::size_t every) {
    ew::SketchScript out = script;
    for (ew::ScriptStep& step : out.steps) {
        auto* stroke = std::get_if<ew::StrokeStep>(&step);
        if (stroke == nullptr) continue;
        std::vector<ew::PenSample> kept;
        const auto& all = stroke->stroke.samples;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (i % every != 0 && i + 1 < all.size()) continue;
            kept.push_back(all[i]);
            kept.back().position = (kept.back().position * 16.0).array().round() / 16.0;
        }
        stroke->stroke.samples = std::move(kept);
        stroke->hasPressure = false;
    }
    return ew::writeSketchScript(out);
}

/// The steps that examples have no use for.
const char* const kOtherSteps = R"(
    {"do": "erase", "at": [640, 400]}, {"do": "undo", "count": 2}, {"do": "redo", "count": 2},
    {"do": "fillet", "edges": "all", "radius": 2, "segments": 3},
    {"do": "sharpen", "edges": [[1, 2, 3, 0]]},
    {"do": "crease", "edges": "convex", "sharpness": 2.5},
    {"do": "subdivide", "scheme": "catmull-clark", "levels": 2, "crease": "auto",
     "corners": "sharp"},
    {"do": "subdivide", "scheme": "loop", "tolerance": 0.5},
    {"do": "stroke", "points": [[600, 390], [680, 410]]}, {"do": "map_strokes", "color": "navy"},
    {"do": "unmap_strokes"},
    {"do": "define_template", "id": "mine", "name": "Mine", "from": "solid"},
    {"do": "delete_solid"}, {"do": "undo"}, {"do": "clear"},
    {"do": "thresholds", "distance_px": 20, "angle_deg": 9}
  ]})";

bool scriptsAndDocuments(const Seeds& seeds) {
    bool ok = true;
    for (const auto& entry : fs::directory_iterator(kSource + "/resources/examples")) {
        if (entry.path().extension() != ".json") continue;  // its picture
        const std::string name = entry.path().filename().string();
        const auto script = ew::readSketchScript(contents(entry.path()));
        if (!script) continue;
        ok &= seeds.put("sketch_script", name, thinned(*script, 4));
        std::string replay = thinned(*script, 12);
        const auto end = replay.rfind("]");
        const std::string all = replay.substr(0, end) + "," + kOtherSteps;
        ok &= seeds.put("sketch_script", "all-" + name, all);
        // Whole models take too long to be tried again and again.
        constexpr std::size_t kShort = 20;
        if (script->steps.size() <= kShort) {
            ok &= seeds.put("replay", name, replay) && seeds.put("replay", "all-" + name, all);
        }
        ew::Document document(ew::fuzz::shippedTemplates());
        ew::replay(document, *ew::readSketchScript(replay), {});
        const QString path = QString::fromStdString(
            (fs::temp_directory_path() / ("edgewright-seed-" + name)).string());
        if (!document.save(path)) return false;
        ok &= seeds.put("document", name, contents(path.toStdString()));
        fs::remove(path.toStdString());
    }
    return ok;
}

std::vector<ew::test::LineDrawing> drawingsFromOutside() {
    using namespace ew::test;
    std::vector<LineDrawing> out;
    const std::string folder = outsideDrawings();
    if (folder.empty()) {
        std::fprintf(stderr, "make_seeds: no drawings from outside (EDGEWRIGHT_DRAWINGS)\n");
        return out;
    }
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string path = entry.path().string();
        const std::string name = entry.path().filename().string();
        if (const auto svg = readHiddenLineSvg(path)) out.push_back(*svg);
        if (const auto scap = readScap(path)) out.push_back(*scap);
        if (const auto items = readExcalidrawLibrary(path)) {
            for (std::size_t i = 0; i < items->size(); ++i) {
                out.push_back((*items)[i]);
                out.back().name = name + std::to_string(i);
            }
        }
    }
    return out;
}

bool drawings(const Seeds& seeds) {
    using namespace ew::test;
    bool ok = true;
    const auto put = [&](const std::string& name, const std::vector<ew::Stroke>& strokes) {
        ok &= seeds.put("interpret", name, ew::fuzz::bytesOf({}, strokes, 3));
    };
    for (const LineDrawing& drawing : drawingsFromOutside()) put(drawing.name, drawing.visible());
    for (const auto& entry : fs::directory_iterator(kSource + "/resources/examples")) {
        if (entry.path().extension() != ".json") continue;  // its picture
        const auto script = ew::readSketchScript(contents(entry.path()));
        if (!script) continue;
        std::vector<ew::Stroke> strokes;
        for (const ew::ScriptStep& step : script->steps) {
            if (std::holds_alternative<ew::ApplyStep>(step)) break;
            if (const auto* s = std::get_if<ew::StrokeStep>(&step)) strokes.push_back(s->stroke);
        }
        put(entry.path().filename().string(), strokes);
    }
    return ok;
}

/// The first byte says what the others are (fuzz_blob).
bool blobs(const Seeds& seeds) {
    bool ok = seeds.put("blob", "packed",
                        std::string(1, '\0') + ew::packBlob(std::string(300, 'x')).first);
    int number = 0;
    for (const auto& bodies : ew::fuzz::scenes().bodies) {
        const std::string solid = bodies.front().solid.serialize();
        ok &= seeds.put("blob", "solid" + std::to_string(number++), "\2" + solid);
    }
    ew::Stroke stroke;
    for (int i = 0; i < 4; ++i) stroke.samples.push_back({ew::Vec2(i, 2 * i), 0.5, 0.01 * i});
    return seeds.put("blob", "stroke", "\1" + ew::samplesBlob(stroke)) && ok;
}

bool packs(const Seeds& seeds) {
    ew::TemplatePack pack;
    pack.name = "Some";
    pack.licence = "CC0-1.0";
    const ew::TemplateLibrary& shipped = ew::fuzz::shippedTemplates();
    for (std::size_t i = 0; i < shipped.size(); ++i) pack.templates.push_back(shipped.at(i));
    const auto bytes = ew::writeTemplatePack(pack);
    return bytes && seeds.put("pack", "shipped", *bytes);
}

bool modifications(const Seeds& seeds) {
    using namespace ew::test;
    bool ok = true;
    int number = 0;
    for (const ew::fuzz::SceneCase& c : ew::fuzz::scenes().cases) {
        ew::fuzz::Head head;
        head.scene = c.scene;
        head.view = c.view;
        const auto lines = linesOnPlane(c.drawing);
        ok &= seeds.put("modification", std::to_string(number++),
                        ew::fuzz::bytesOf(head, exactStrokes(lines), 8));
    }
    return ok;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("Usage: make_seeds FOLDER\n", stderr);
        return 2;
    }
    const Seeds seeds{argv[1]};
    bool ok = true;
    for (const auto& entry : fs::directory_iterator(kSource + "/resources/templates")) {
        if (entry.path().extension() != ".json") continue;
        ok &= seeds.put("template", entry.path().filename().string(), contents(entry.path()));
    }
    for (const auto& entry : fs::directory_iterator(kSource + "/tests/data")) {
        ok &= seeds.put("document", "schema1-" + entry.path().filename().string(),
                        contents(entry.path()));
    }
    // What changes there are is told by the bytes; any will do to begin with.
    ok &= seeds.put("rows", "any", std::string(64, 'x'));
    ok &= blobs(seeds);
    ok &= packs(seeds);
    ok &= scriptsAndDocuments(seeds);
    ok &= drawings(seeds);
    ok &= modifications(seeds);
    return ok ? 0 : 1;
}
