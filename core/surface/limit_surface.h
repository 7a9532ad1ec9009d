// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface: brings OpenSubdiv with it.
#pragma once

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/surface/control_cage.h"

namespace ew {

/// The limit surface of a control cage, face by face.
class LimitSurface {
  public:
    /// \pre the cage is closed and fits the scheme.
    /// Errors: Internal where OpenSubdiv refuses the cage.
    static Result<LimitSurface> create(const ControlCage& cage, SubdivisionScheme scheme,
                                       int exactLevels);

    /// Chooses the face that the calls below speak of.
    bool select(int face) { return select(face, *fine_); }
    /// The same for measuring only: patches beside extraordinary points are those of three levels,
    /// which take a fraction of the time.
    bool selectCoarse(int face) { return select(face, *coarse_); }
    /// One bicubic patch (or Loop's triangle) without an extraordinary point or a crease.
    bool regular() const { return surface_.IsRegular(); }
    Vec3 position(double u, double v) const;
    void evaluate(double u, double v, Vec3& position, Vec3& du, Vec3& dv) const;
    /// Points of the cage that the selected face depends on.
    void controlPoints(std::vector<int>& out) const;
    /// Their weights in the position and both derivatives, as many each.
    void weights(double u, double v, double* p, double* du, double* dv) const;
    void weights(double u, double v, double* p) const;

  private:
    using Refiner = OpenSubdiv::Far::TopologyRefiner;
    using Factory = OpenSubdiv::Bfr::RefinerSurfaceFactory<>;

    explicit LimitSurface(const ControlCage& cage) : cage_(&cage) {}
    bool select(int face, const Factory& factory);

    const ControlCage* cage_;
    std::unique_ptr<Refiner> refiner_;
    std::vector<std::shared_ptr<OpenSubdiv::Bfr::SurfaceFactoryCache>> caches_;
    std::unique_ptr<Factory> fine_;
    std::unique_ptr<Factory> coarse_;
    OpenSubdiv::Bfr::Surface<double> surface_;
    std::vector<double> patch_;
};

}  // namespace ew
