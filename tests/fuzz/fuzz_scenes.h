// SPDX-License-Identifier: GPL-3.0-or-later
// The solids that fuzz_modification draws on, and the cameras that see them.
#pragma once

#include <vector>

#include "tests/support/modification_cases.h"

namespace ew::fuzz {

/// A drawing on a solid that means something, where an input starts from.
struct SceneCase {
    test::ModificationCase drawing;
    std::uint8_t scene = 0, view = 0;
};

struct Scenes {
    std::vector<std::vector<Body>> bodies;  ///< by scene
    std::vector<OrthographicCamera> views;  ///< of every scene
    std::vector<SceneCase> cases;
};

inline const Scenes& scenes() {
    static const Scenes made = [] {
        using namespace ew::test;
        Scenes out;
        const Vec3 middle(40, 30, 20);
        for (const int view : {0, 3, 7, 13}) out.views.push_back(modificationCamera(view, middle));
        const auto look = [&](const Vec3& direction, const Vec3& up, double worldPerPixel) {
            OrthographicCamera camera = modificationCamera(0, middle);
            camera.direction = direction.normalized();
            camera.up = up;
            camera.worldPerPixel = worldPerPixel;
            out.views.push_back(camera);
        };
        // Straight along faces and edges, from below and behind, far away and near.
        look(-Vec3::UnitZ(), Vec3::UnitY(), 0.25);
        look(Vec3::UnitY(), Vec3::UnitZ(), 0.25);
        look(-Vec3::UnitX(), Vec3::UnitZ(), 0.25);
        look(Vec3(0, 1, -1), Vec3::UnitZ(), 0.25);
        look(Vec3(1, -2, 1), Vec3::UnitZ(), 0.25);
        look(Vec3(-1, 1e-7, -1e-7), Vec3::UnitZ(), 0.25);
        look(Vec3(-1, 1, -1), Vec3::UnitZ(), 20.0);
        look(Vec3(-1, 1, -1), Vec3::UnitZ(), 0.002);

        const auto take = [&](const std::vector<ModificationCase>& cases) {
            const std::string* last = nullptr;
            for (const ModificationCase& c : cases) {
                if (last == nullptr || c.scene != *last) out.bodies.push_back({c.target});
                last = &c.scene;
                out.cases.push_back({c, static_cast<std::uint8_t>(out.bodies.size() - 1), 0});
            }
        };
        take(boxModifications());
        take(workedBoxModifications());
        take(prismModifications());
        take(jointModifications());
        // Turned in the world, and two bodies, one of which covers the other.
        Pose turned;
        turned.rotation = Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix();
        turned.translation = Vec3(4, -3, 2);
        out.bodies.push_back({{out.bodies[0][0].solid, turned}});
        Pose before;
        before.translation = Vec3(60, -30, 20);
        out.bodies.push_back({out.bodies[0][0], {out.bodies[1][0].solid, before}});
        return out;
    }();
    return made;
}

}  // namespace ew::fuzz
