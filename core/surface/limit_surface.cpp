// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/limit_surface.h"

#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <shared_mutex>

#include "core/surface/patch_memory.h"

namespace ew {
namespace {

namespace Osd = OpenSubdiv;

const Osd::Bfr::Surface<double>::PointDescriptor kThree(3);
constexpr int kCoarseLevels = 3;  ///< as dense as the samples beside extraordinary points
constexpr int kSharpLevels = 6;

/// Patches by topology; they outlive a surface, since the next one is mostly of the same topology:
/// while a radius is dragged only the points move.
class PatchCache : public Osd::Bfr::SurfaceFactoryCache {
  public:
    std::size_t patches() const {
        const std::shared_lock lock(mutex_);
        return Size();
    }

  protected:
    DataType Find(const KeyType& key) const override {
        const std::shared_lock lock(mutex_);
        return find(key);
    }
    DataType Add(const KeyType& key, const DataType& data) override {
        const std::unique_lock lock(mutex_);
        return add(key, data);
    }

  private:
    mutable std::shared_mutex mutex_;
};

/// The caches of all factories, by their options, on which patches depend. Where all together hold
/// more than the bound, all begin anew; surfaces that are being made keep theirs until then.
class PatchCaches {
  public:
    static PatchCaches& all() {
        static PatchCaches caches;
        return caches;
    }
    std::shared_ptr<PatchCache> of(Osd::Sdc::SchemeType scheme, int smooth, int sharp) {
        constexpr std::size_t kMostPatches = 1'000;  // some tens of KiB each
        const std::scoped_lock lock(mutex_);
        std::size_t patches = 0;
        for (const auto& [options, cache] : caches_) patches += cache->patches();
        if (patches >= kMostPatches) caches_.clear();
        std::shared_ptr<PatchCache>& cache = caches_[{static_cast<int>(scheme), smooth, sharp}];
        if (!cache) cache = std::make_shared<PatchCache>();
        return cache;
    }
    void forget() {
        const std::scoped_lock lock(mutex_);
        caches_.clear();
    }

  private:
    std::mutex mutex_;
    std::map<std::array<int, 3>, std::shared_ptr<PatchCache>> caches_;
};

}  // namespace

void forgetPatches() { PatchCaches::all().forget(); }

Result<LimitSurface> LimitSurface::create(const ControlCage& cage, SubdivisionScheme scheme,
                                          int exactLevels) {
    const PolyMesh& mesh = cage.mesh;
    std::vector<int> sizes;
    sizes.reserve(static_cast<std::size_t>(mesh.faceCount()));
    for (int f = 0; f < mesh.faceCount(); ++f) {
        sizes.push_back(static_cast<int>(mesh.outline(f).size()));
    }
    std::vector<int> creaseEnds;
    std::vector<float> creases;
    for (const CreaseEdge& c : cage.creases) {
        creaseEnds.push_back(c.from);
        creaseEnds.push_back(c.to);
        creases.push_back(static_cast<float>(std::min(c.sharpness, kInfiniteSharpness)));
    }
    std::vector<int> cornerPoints;
    std::vector<float> corners;
    for (const SharpPoint& c : cage.corners) {
        cornerPoints.push_back(c.point);
        corners.push_back(static_cast<float>(std::min(c.sharpness, kInfiniteSharpness)));
    }
    Osd::Far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(mesh.points.size());
    descriptor.numFaces = mesh.faceCount();
    descriptor.numVertsPerFace = sizes.data();
    descriptor.vertIndicesPerFace = mesh.corners.data();
    descriptor.numCreases = static_cast<int>(creases.size());
    descriptor.creaseVertexIndexPairs = creaseEnds.data();
    descriptor.creaseWeights = creases.data();
    descriptor.numCorners = static_cast<int>(corners.size());
    descriptor.cornerVertexIndices = cornerPoints.data();
    descriptor.cornerWeights = corners.data();
    using RefinerFactory = Osd::Far::TopologyRefinerFactory<Osd::Far::TopologyDescriptor>;
    const auto type =
        scheme == SubdivisionScheme::Loop ? Osd::Sdc::SCHEME_LOOP : Osd::Sdc::SCHEME_CATMARK;
    Osd::Sdc::Options options;
    options.SetVtxBoundaryInterpolation(Osd::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    LimitSurface out(cage);
    out.refiner_.reset(RefinerFactory::Create(descriptor, RefinerFactory::Options(type, options)));
    if (!out.refiner_) return fail(Errc::Internal, "The cage could not be subdivided.");
    const auto factory = [&](int smooth, int sharp) {
        out.caches_.push_back(PatchCaches::all().of(type, smooth, sharp));
        Osd::Bfr::SurfaceFactory::Options levels;
        levels.SetApproxLevelSmooth(smooth);
        levels.SetApproxLevelSharp(sharp);
        levels.SetExternalCache(out.caches_.back().get());
        return std::make_unique<Factory>(*out.refiner_, levels);
    };
    out.coarse_ = factory(kCoarseLevels, kSharpLevels);
    // Points of that many rounds of subdivision are then exact beside extraordinary points too.
    out.fine_ = factory(std::max(exactLevels, 2), std::max(exactLevels, kSharpLevels));
    return out;
}

bool LimitSurface::select(int face, const Factory& factory) {
    if (!factory.InitVertexSurface(face, &surface_)) return false;
    patch_.resize(3 * static_cast<std::size_t>(surface_.GetNumPatchPoints()));
    surface_.PreparePatchPoints(cage_->mesh.points.front().data(), kThree, patch_.data(), kThree);
    return true;
}

Vec3 LimitSurface::position(double u, double v) const {
    const double uv[2] = {u, v};
    Vec3 p;
    surface_.Evaluate(uv, patch_.data(), kThree, p.data());
    return p;
}

void LimitSurface::evaluate(double u, double v, Vec3& position, Vec3& du, Vec3& dv) const {
    const double uv[2] = {u, v};
    surface_.Evaluate(uv, patch_.data(), kThree, position.data(), du.data(), dv.data());
}

void LimitSurface::controlPoints(std::vector<int>& out) const {
    out.resize(static_cast<std::size_t>(surface_.GetNumControlPoints()));
    surface_.GetControlPointIndices(out.data());
}

void LimitSurface::weights(double u, double v, double* p, double* du, double* dv) const {
    const double uv[2] = {u, v};
    surface_.EvaluateStencil(uv, p, du, dv);
}

void LimitSurface::weights(double u, double v, double* p) const {
    const double uv[2] = {u, v};
    surface_.EvaluateStencil(uv, p);
}

}  // namespace ew
