// SPDX-License-Identifier: GPL-3.0-or-later
// Counts what is wrong with exported shapes: every mix of edge choice, radius, segments, scheme and
// levels, on the examples and on random solids. Prints a row of faults by kind for every solid as
// it is done, then one for every part of the mixes.
#include <QDir>
#include <QFile>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

#include "core/document/document.h"
#include "core/document/export_mesh.h"
#include "core/document/replay.h"
#include "core/document/resources.h"
#include "tests/document/surface_mixes.h"
#include "tests/support/random_modifications.h"
#include "tests/surface/shapes.h"

namespace {

using namespace ew;
using namespace ew::test;

struct Named {
    std::string name;
    std::vector<Body> bodies;
};

struct Options {
    int solids = 100;
    std::string only;      // part of the name of a solid
    std::string exportTo;  // a folder
    bool list = false;     // every mix at fault
    std::vector<std::string> extensions{".glb", ".stl"};
    int exportEvery = 1;
};

std::optional<Named> example(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
    const auto script = readSketchScript(file.readAll().toStdString());
    const auto templates = loadTemplates();
    if (!script || !templates) return std::nullopt;
    Document document(templates->library);
    if (replay(document, *script, {}).firstFailure() != nullptr) return std::nullopt;
    return Named{QFileInfo(path).baseName().toStdString(), document.state().bodies};
}

std::vector<Named> solids(const Options& options) {
    std::vector<Named> out;
    const auto resources = resourcesFolder();
    if (resources) {
        const QDir folder(*resources + QStringLiteral("/examples"));
        for (const QString& name : folder.entryList({QStringLiteral("*.json")})) {
            if (auto made = example(folder.filePath(name))) out.push_back(std::move(*made));
        }
    }
    for (int n = 0; n < options.solids; ++n) {
        const auto number = static_cast<std::uint64_t>(n / 2);
        if (n % 2 == 0) {
            out.push_back({"random" + std::to_string(n), {{randomSolid(number), {}}}});
        } else {
            Random random(Random::mix(number, 5));
            out.push_back({"random" + std::to_string(n), {{randomModifiedSolid(8, random), {}}}});
        }
    }
    std::erase_if(out,
                  [&](const Named& n) { return n.name.find(options.only) == std::string::npos; });
    return out;
}

Options readArguments(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto value = [&] { return std::string(i + 1 < argc ? argv[++i] : ""); };
        if (word == "--solids") {
            options.solids = std::atoi(value().c_str());
        } else if (word == "--only") {
            options.only = value();
        } else if (word == "--list") {
            options.list = true;
        } else if (word == "--export") {
            options.exportTo = value();
        } else if (word == "--every") {
            options.exportEvery = std::max(1, std::atoi(value().c_str()));
        } else {
            std::fprintf(stderr,
                         "surface_sweep [--solids N (100)] [--only NAME] [--list]\n"
                         "              [--export FOLDER [--every N]]   writes .glb and .stl\n");
            std::exit(word == "--help" ? 0 : 2);
        }
    }
    return options;
}

struct Row {
    long shapes = 0;
    long faulty = 0;
    ShapeFaults sum;
};

void print(const char* name, const Row& r) {
    std::printf("%-28s %7ld %7ld %9zu %9zu %9zu %9zu %9zu %6zu\n", name, r.shapes, r.faulty,
                r.sum.badNormals, r.sum.backwardNormals, r.sum.reading.withoutArea,
                r.sum.reading.openEdges, r.sum.notManifold, r.sum.notMade);
    std::fflush(stdout);
}

void printHead() {
    std::printf("%-28s %7s %7s %9s %9s %9s %9s %9s %6s\n", "", "shapes", "faulty", "normals",
                "backward", "no area", "edges", "manifold", "none");
}

}  // namespace

int main(int argc, char** argv) {
    const Options options = readArguments(argc, argv);
    std::map<std::string, Row> rows;
    long count = 0;
    printHead();
    for (const Named& solid : solids(options)) {
        ShapeCache cache;
        Row own;
        for (const SurfaceMix& mix : allMixes()) {
            const auto input = inputFor(solid.bodies, mix);
            if (!input) continue;
            const DerivedShape shape = deriveShape(*input, cache);
            const ShapeFaults faults = faultsOf(*input, shape);
            for (const std::string& key :
                 {std::string("all"), "edges " + std::string(mix.edgesName()),
                  std::string(mix.levels == 0 && mix.tolerance == 0.0 ? "cage"
                              : mix.scheme == SubdivisionScheme::Loop ? "loop"
                                                                      : "catmull-clark") +
                      (mix.tolerance > 0.0 ? " adaptive" : " " + std::to_string(mix.levels)),
                  "radius " + std::to_string(mix.radius).substr(0, 4)}) {
                Row& row = rows[key];
                ++row.shapes;
                row.faulty += faults.any() ? 1 : 0;
                row.sum += faults;
            }
            ++own.shapes;
            own.faulty += faults.any() ? 1 : 0;
            own.sum += faults;
            if (options.list && faults.any()) {
                Row row;
                row.shapes = row.faulty = 1;
                row.sum = faults;
                print((solid.name + " " + mix.name()).c_str(), row);
            }
            ++count;
            if (options.exportTo.empty() || count % options.exportEvery != 0) continue;
            for (const std::string& extension : options.extensions) {
                const std::string path =
                    options.exportTo + "/" + solid.name + "_" + mix.name() + extension;
                const std::vector<MappedStroke> none;
                const auto done = exportShape({input->bodies, shape, none}, path);
                if (!done) {
                    std::printf("%s: %s\n", path.c_str(), done.error().message.c_str());
                }
            }
        }
        print(solid.name.c_str(), own);
    }
    printHead();
    for (const auto& [name, row] : rows) print(name.c_str(), row);
    return rows["all"].faulty == 0 ? 0 : 1;
}
