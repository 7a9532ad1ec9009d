// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/vec.h"
#include "core/document/surface_settings.h"

namespace ew {

/// A body's mesh in the world.
struct WorldMesh {
    std::vector<Vec3> points;
    std::vector<std::vector<int>> polygons;
    std::vector<std::array<int, 3>> triangles;
    std::vector<Vec3> normals;  ///< of a surface, else empty
    std::vector<std::array<int, 3>> normalTriangles;
};

/// A stroke on the surface.
struct WorldLine {
    std::vector<std::vector<Vec3>> pieces;
    StrokeColor color{};
};

struct WorldMeshes {
    std::vector<WorldMesh> bodies;
    std::vector<WorldLine> lines;
    Vec3 origin = Vec3::Zero();  ///< of these coordinates, in the world
    std::string unit = "mm";     ///< of these coordinates

    std::size_t triangles() const {
        std::size_t count = 0;
        for (const WorldMesh& body : bodies) count += body.triangles.size();
        return count;
    }
};

/// Says how far the export is, now and then, and keeps in mind that it is to stop.
class ExportProgress {
  public:
    explicit ExportProgress(std::function<bool(double)> told) : told_(std::move(told)) {}
    /// What comes now goes from one share of the whole to another and has so many faces.
    void part(double from, double to, std::size_t faces) {
        from_ = from;
        width_ = to - from;
        faces_ = static_cast<double>(std::max<std::size_t>(1, faces));
        done_ = 0;
        say();
    }
    /// \return false: stop.
    bool did(std::size_t faces) {
        const std::size_t before = done_ / kBetween;
        done_ += faces;
        if (done_ / kBetween != before) say();
        return !stopped_;
    }
    bool stopped() const { return stopped_; }

  private:
    void say() {
        const double share = std::min(1.0, static_cast<double>(done_) / faces_);
        if (told_ && !told_(from_ + width_ * share)) stopped_ = true;
    }
    static constexpr std::size_t kBetween = 50'000;
    std::function<bool(double)> told_;
    double from_ = 0.0;
    double width_ = 1.0;
    double faces_ = 1.0;
    std::size_t done_ = 0;
    bool stopped_ = false;
};

/// "1000000000 0 0"
std::string placeText(const Vec3& p);

// The formats that are written here, without a library. What comes back is not whole where the
// progress stopped.

/// Wavefront OBJ: one object a body, numbers with 17 digits; strokes as lines.
std::string objText(const WorldMeshes& meshes, ExportProgress& progress);
/// Binary STL: triangles with unit normals.
std::string stlBytes(const WorldMeshes& meshes, ExportProgress& progress);
/// Binary PLY, little endian, double precision.
std::string plyBytes(const WorldMeshes& meshes, ExportProgress& progress);

}  // namespace ew
