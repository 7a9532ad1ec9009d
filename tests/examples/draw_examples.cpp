// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the models of resources/examples by a hand that shakes and saves what was done.
//
//   draw_examples FOLDER [NAME]
#include <QGuiApplication>
#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

#include "core/document/sketch_script.h"
#include "tests/examples/models.h"

namespace ew::test {
namespace {

struct Model {
    const char* name;
    const char* title;
    void (*draw)(ModelMaker&);
};

constexpr std::array<Model, 3> kModels{{{"printer", "A printer, drawn by hand", drawPrinter},
                                        {"clock", "A clock, drawn by hand", drawClock},
                                        {"mouse", "A computer mouse, drawn by hand", drawMouse}}};

int run(const std::string& folder, const std::string& only) {
    const auto load = loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
    if (!load) return 2;
    int failed = 0;
    for (const Model& model : kModels) {
        if (!only.empty() && only != model.name) continue;
        std::printf("%s\n", model.name);
        ModelMaker maker(load->library, kLightHand, 1);
        try {
            model.draw(maker);
        } catch (const std::exception& e) {
            std::printf("  %s\n", e.what());
            ++failed;
        }
        SketchScript script = maker.document().recordedScript();
        script.title = model.title;
        std::ofstream(folder + "/" + model.name + ".json") << writeSketchScript(script);
        std::printf("  %d sketches\n", maker.sketches());
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
