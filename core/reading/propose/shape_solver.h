// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/edge_graph/build.h"
#include "core/reading/extract/line_drawing.h"
#include "core/reading/propose/shape_hypothesis.h"
#include "core/reading/score/picture_evidence.h"
#include "core/reading/types/interpretation.h"
#include "core/reading/types/reading_params.h"
#include "core/solid/solid.h"

namespace ew {

struct LibraryEntry;

/// A hypothesis that was fitted to a drawing and is a solid.
struct SolvedShape {
    Candidate candidate;
    PictureEvidence evidence{};
    double cost = 0.0;    ///< of what is drawn otherwise and of its freedoms, twice a negative
                          ///< log-likelihood
    double misfit = 0.0;  ///< PlaneFit::misfit
    Solid solid;
    bool known = false;        ///< is a template of the library
    bool family = false;       ///< a prism, pyramid or frustum over a base that is seen
    bool guessed = false;      ///< a hole ends where nothing of it is seen
    double leastCorner = 0.0;  ///< how far the flattest corner of a seen face stands out from the
                               ///< line past it [standard deviations of a drawn corner]
    bool tiny = false;         ///< some side of a seen face is no longer than this hand errs
    int lines = 0;             ///< its edges that the eye sees one of the faces of
    bool exact = false;        ///< the drawing is an exact picture of some solid
    int lift = -1;             ///< those of one number differ in what is not seen alone; -1: none
    std::shared_ptr<const EdgeGraph> graph{};  ///< that the candidate speaks of; set by its reader

    /// Does it account for the ink?
    bool explains() const {
        return misfit <= params::kWholeMisfit && evidence.residue() <= params::kWholeResidue;
    }
};

/// Fits hypotheses to drawings, at several degrees of regularity, makes solids of them and compares
/// their pictures with the ink.
class ShapeSolver {
  public:
    ShapeSolver(const InkReading& ink, const TemplateLibrary& library,
                const InterpretOptions& options)
        : ink_(ink), library_(library), options_(options) {}

    /// Hypotheses at most in all drawings; what comes after them is left.
    static constexpr int kMostTried = 60;

    /// Takes how precise this drawing is; before solveAll().
    void begin(const EdgeGraph& graph);

    /// Standard deviation of a drawn corner, per axis [px].
    double spread() const { return spread_; }
    /// Those to read with: an exact drawing tells planes apart that a hand would draw as one.
    std::vector<double> spreads() const;
    /// Is the drawing exact, and was no solid found of which it is an exact picture?
    bool mayBeNearer() const { return noise_ <= params::kExactPx && !isExact(); }
    bool isExact() const { return fitSpread_ < spread_; }

    /// Adds those that can be solved to `found`.
    /// \param lifts  is added to ShapeHypothesis::lift.
    /// \return does one of them explain the ink?
    bool solveAll(const std::vector<ShapeHypothesis>& proposals, const LineDrawing& drawing,
                  int lifts, std::vector<SolvedShape>& found);

  private:
    struct Rough;

    Rough roughFit(const ShapeHypothesis& h, const LineDrawing& drawing) const;
    std::optional<double> exactSpread(const std::vector<Rough>& rough) const;
    std::optional<PlaneFit> fit(const ShapeHypothesis& h, const LineDrawing& drawing) const;
    std::optional<SolvedShape> solve(const ShapeHypothesis& h, const LineDrawing& drawing) const;
    double leastCorner(const PlaneFit& f, const ShapeHypothesis& h,
                       const LineDrawing& drawing) const;
    /// The sides of the faces that look at the eye, each once [px].
    std::vector<double> seenSides(const PlaneFit& f, const ShapeHypothesis& h) const;
    void place(const PlaneFit& f, const ShapeHypothesis& h, Candidate& c) const;
    void describe(const ShapeHypothesis& h, const PlaneFit& f, SolvedShape& out) const;
    const LibraryEntry* templateOf(const PlaneModel& model, const PolyhedronSpec& spec) const;

    const InkReading& ink_;
    const TemplateLibrary& library_;
    const InterpretOptions& options_;
    int tried_ = 0;
    double noise_ = 1.0;
    double spread_ = 2.0;     ///< of drawn corners, per axis [px]
    double fitSpread_ = 2.0;  ///< less where the drawing is exact
};

}  // namespace ew
