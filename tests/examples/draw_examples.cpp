// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the models of resources/examples by a hand that shakes and saves what was done.
//
//   draw_examples FOLDER [NAME]
#include <QGuiApplication>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <map>
#include <string>

#include "core/document/sketch_script.h"
#include "tests/examples/model_maker.h"

namespace ew::test {
namespace {

using V = Vec3;
using Which = EdgeChoice::Which;

/// A desk printer: paper stands in the tray behind, comes out in front.
void printer(ModelMaker& m) {
    m.lookFrom(58, 32);
    m.startBox(V(120, 90, 55));
    // The control panel: a slope along the upper front edge.
    m.cutPrism({V(0, 0, 1), V(0, 0.3, 1), V(0, 0, 0.66)}, V(1, 0, 0));
    // Where the paper comes out, and the tray that it falls on.
    m.cutBox(V(0.12, 0, 0.16), V(0.88, 0.2, 0.5));
    m.addBox(V(0.22, -0.4, 0.0), V(0.78, 0, 0.16));
    // The paper's tray, standing on top at the back.
    m.addBox(V(0.15, 0.66, 1), V(0.85, 0.84, 1.6));
    m.lookFrom(58, 40);
    m.cutBox(V(0.25, 0.66, 1.16), V(0.75, 0.75, 1.6));
    // A lid, a ledge and feet.
    m.addBox(V(0.06, 0.36, 1), V(0.94, 0.58, 1.16));
    // A hollow to lift it by and a slope on the tray.
    m.lookFrom(35, 28);
    m.cutBox(V(0.88, 0.3, 0.3), V(1, 0.75, 0.62));
    m.lookFrom(58, 32);
    m.cutPrism({V(0.22, -0.4, 0.16), V(0.22, -0.24, 0.16), V(0.22, -0.4, 0)}, V(0.56, 0, 0));
    m.fillet(Which::All, 0.035, 2);
    m.subdivide(2);
}

const std::map<std::string, std::function<void(ModelMaker&)>>& models() {
    static const std::map<std::string, std::function<void(ModelMaker&)>> all{{"printer", printer}};
    return all;
}

int run(const std::string& folder, const std::string& only) {
    const auto load = loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
    if (!load) return 2;
    int failed = 0;
    for (const auto& [name, draw] : models()) {
        if (!only.empty() && only != name) continue;
        std::printf("%s\n", name.c_str());
        ModelMaker maker(load->library, kLightHand, 1);
        try {
            draw(maker);
        } catch (const std::exception& e) {
            std::printf("  %s\n", e.what());
            ++failed;
        }
        SketchScript script = maker.document().recordedScript();
        script.title = "A " + name + ", drawn by hand";
        std::ofstream(folder + "/" + name + ".json") << writeSketchScript(script);
        std::printf("  %d steps\n", maker.steps());
    }
    return failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace ew::test

int main(int argc, char** argv) {
    const QGuiApplication app(argc, argv);
    if (argc < 2) {
        std::fprintf(stderr, "draw_examples FOLDER [NAME]\n");
        return 2;
    }
    return ew::test::run(argv[1], argc > 2 ? argv[2] : "");
}
