// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "core/reading/interpret.h"
#include "core/tlib/library.h"
#include "core/tlib/library_index.h"

namespace ew::test {

/// The shipped library, loaded once.
inline const TemplateLibrary& shippedLibrary() {
    static const TemplateLibrary kLibrary = [] {
        auto load = loadLibrary(std::string(EDGEWRIGHT_SOURCE_DIR) + "/resources/templates");
        return load ? load->library : TemplateLibrary();
    }();
    return kLibrary;
}

/// A template of that library, by its id.
inline std::shared_ptr<const LibraryEntry> entryOf(const std::string& id) {
    const LibraryIndex& index = shippedLibrary().index();
    return index.entries[static_cast<std::size_t>(index.byId.at(id))];
}

inline Stroke line(const Vec2& a, const Vec2& b) {
    Stroke s;
    s.samples.push_back({a, 1, 0});
    s.samples.push_back({b, 1, 0});
    return s;
}

/// Enclosed volume of a spec [mm^3].
inline double volumeOf(const PolyhedronSpec& spec) {
    double v = 0;
    for (const auto& f : spec.faces) {
        for (std::size_t i = 1; i + 1 < f.size(); ++i) {
            v += spec.vertices[static_cast<std::size_t>(f[0])].dot(
                spec.vertices[static_cast<std::size_t>(f[i])].cross(
                    spec.vertices[static_cast<std::size_t>(f[i + 1])]));
        }
    }
    return v / 6;
}

/// The nine visible edges of a box a x b x c [mm] at the origin, seen by a camera.
inline std::vector<Stroke> boxStrokes(const OrthographicCamera& camera, const Vec3& size,
                                      const Vec3& corner = Vec3::Zero()) {
    // The default camera looks along (-1, 1, -1): it sees +x, -y and +z.
    auto p = [&](double x, double y, double z) {
        return camera.project(corner + Vec3(x * size.x(), y * size.y(), z * size.z()));
    };
    const Vec2 near = p(1, 0, 1);
    return {
        line(near, p(0, 0, 1)),       line(near, p(1, 1, 1)),       line(near, p(1, 0, 0)),
        line(p(0, 0, 1), p(0, 1, 1)), line(p(1, 1, 1), p(0, 1, 1)), line(p(1, 1, 1), p(1, 1, 0)),
        line(p(1, 0, 0), p(1, 1, 0)), line(p(1, 0, 0), p(0, 0, 0)), line(p(0, 0, 1), p(0, 0, 0))};
}

inline Interpretation readStrokes(const std::vector<Stroke>& strokes,
                                  InterpretOptions options = {}) {
    return interpret(strokes, shippedLibrary(), options);
}

}  // namespace ew::test
