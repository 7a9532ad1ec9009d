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
    /// The same for measuring only: patches beside extraordinary points are those of two levels,
    /// which take a fraction of the time.
    bool selectCoarse(int face) { return select(face, *coarse_); }
    OpenSubdiv::Bfr::Parameterization parameterization() const {
        return surface_.GetParameterization();
    }
    Vec3 position(double u, double v) const;
    /// Position and unit normal; zero where the surface has none.
    void evaluate(double u, double v, Vec3& position, Vec3& normal) const;
    /// The control points of a regular patch without creases, as evaluate() weighs them.
    const double* patchPoints() const { return patch_.data(); }
    /// Weights of position and both derivatives for a face like the selected one.
    int weights(double u, double v, double* p, double* du, double* dv) const;

  private:
    using Refiner = OpenSubdiv::Far::TopologyRefiner;
    using Factory = OpenSubdiv::Bfr::RefinerSurfaceFactory<>;

    explicit LimitSurface(const ControlCage& cage) : cage_(&cage) {}
    bool select(int face, const Factory& factory);

    const ControlCage* cage_;
    std::unique_ptr<Refiner> refiner_;
    std::unique_ptr<Factory> fine_;
    std::unique_ptr<Factory> coarse_;
    OpenSubdiv::Bfr::Surface<double> surface_;
    std::vector<double> patch_;
};

}  // namespace ew
