// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Numbers about hands and about choosing between readings, each with its reason. Costs are in
/// units of twice a negative log-likelihood.
namespace ew::params {

/// A corner is drawn this far from where it is meant, standard deviation per axis [share of the
/// mean line; px at least]: it is placed by eye, however straight its lines are. Measured: lines by
/// a ruler with corners 2 to 6 px off are read as boxes in 96 to 100% with 4 px at 240, in 0 to 36%
/// without.
inline constexpr double kCornerSpreadShare = 0.017;
inline constexpr double kCornerSpreadLeastPx = 2.0;

/// Degrees of freedom of Student's distribution of where line ends are.
inline constexpr double kTailFreedoms = 4.0;

/// Ink inside a face, and along an edge that is hidden, weighs so much of what ink beside the solid
/// does: it may be a window, or this person draws hidden lines.
inline constexpr double kDetailShare = 0.5;
inline constexpr double kHiddenShare = 0.05;

/// Price of a view that shows just two faces because the others are seen edge-on.
inline constexpr double kEdgeOnCost = 12.0;

/// A candidate is clear where one with fewer freedoms costs this much more.
inline constexpr double kPlainerMargin = 10.0;
/// ... or this much where the candidate fits poorly (kPoorFitPerEnd).
inline constexpr double kPlainerMarginPoor = 40.0;

/// A reading that pays more than this for each line end fits poorly: a hand that draws it pays
/// about half.
inline constexpr double kPoorFitPerEnd = 2.3;

/// A hand whose corners are off by more than this is careless [distance thresholds].
inline constexpr double kCarelessCorner = 0.28;

/// Price of one more degree of freedom of a shape's picture in free space: people draw boxes far
/// more often than nearly-boxes.
inline constexpr double kFreedomCost = 8.0;

/// A drawing whose lines miss each other by no more than this is exact [px]: noise has a floor.
inline constexpr double kExactNoisePx = 0.4;

/// Price of one corner out of place, besides that its two coordinates are free.
inline constexpr double kSlipCost = 4.0;
/// How far out it is at least [distance thresholds; spreads of a drawn corner]: less is what hands
/// do; and at most [times the least]: more is no slip.
inline constexpr double kSlipLeast = 1.2;
inline constexpr double kSlipSpreads = 8.0;
inline constexpr double kSlipMost = 5.0;
/// ... and the rest fits as well as this: Misfit::perEnd.
inline constexpr double kSlipFit = 1.5;
/// Price of a drawing of a right-angled corner that no view shows: who draws parallelograms means
/// a box far more often than a body whose slopes look parallel from one side.
inline constexpr double kImpossibleCornerCost = 4.0;
/// ... and the angle is off by more than this hand errs [standard deviations].
inline constexpr double kSureAngle = 4.0;
/// A solid is not taken in silence where a slip that explains the drawing costs less than this
/// more.
inline constexpr double kSlipMargin = 0.0;

/// A solid with an edge so many times as long as it was drawn is not taken without a question:
/// nobody looks along an edge within 8 degrees.
inline constexpr double kMostForeshortening = 7.0;

/// Lines of which more than this share lies over a solid are no other body by themselves.
inline constexpr double kTouchingInk = 0.1;
/// A cut of whose ink less than this share lies over the solid is not taken without a question.
inline constexpr double kCutInk = 0.5;

/// Ink this near to an edge was drawn for it, however steady the hand [px].
inline constexpr double kLeastBesidePx = 2.0;

/// Price of a perspective view beside a parallel one: true boxes with corners off by 4 px gain 6.7
/// by it in one of ten.
inline constexpr double kPerspectiveCost = 8.0;
/// Strongest perspective that is looked for: kappa of PerspectivePicture, about 75 degrees of view.
inline constexpr double kMostPerspective = 1.5;

/// Two lines of a junction that turn by less are one line that goes on [degrees].
inline constexpr double kStraightDeg = 8.0;

/// The steadiest hand strays so far from a straight line, rms [px].
inline constexpr double kLeastWobblePx = 0.5;

/// A free polyhedron that fits its drawing better than this was drawn exactly [px].
inline constexpr double kExactPx = 0.1;

/// Price of ink that a picture leaves, and of an edge that it has without ink [per distance
/// threshold of its length].
inline constexpr double kStrayCost = 6.0;

/// A whole drawing is read where no more than this share of the ink disagrees with the picture
/// (measured: right ones up to 8%, wrong ones from 17%), and no other solid within kOtherResidue
/// costs less than kWholeMargin more.
inline constexpr double kWholeResidue = 0.08;
inline constexpr double kOtherResidue = 0.12;
inline constexpr double kWholeMargin = 8.0;
/// ... or kCompletionMargin, where the two differ in what is not seen alone: the simplest is meant.
inline constexpr double kCompletionMargin = 2.0;
/// ... or kExactMargin, where an exact drawing is an exact picture of both.
inline constexpr double kExactMargin = 5.0;
/// ... and its corners are no farther from where they were drawn than this many variances.
inline constexpr double kWholeMisfit = 2.5;

/// An unsteady hand's few lines fit many solids, but not a family's so well.
inline constexpr double kSureMisfit = 1.5;
inline constexpr double kSureResidue = 0.01;
/// Others must be so many margins dearer where it is doubtful.
inline constexpr double kDoubtfulMargins = 2.0;

/// A corner that stands out from the line past it by less than this may be no corner [standard
/// deviations of a drawn corner].
inline constexpr double kFaintCorner = 2.5;
/// ... and by less than this is none.
inline constexpr double kNoCorner = 1.0;

/// A face that is seen thinner than this is not drawn: its far side would run beside the near one
/// [distance thresholds].
inline constexpr double kThinFace = 0.5;

/// A side of a face shorter than this may be one corner that lines missed [standard deviations of a
/// drawn corner].
inline constexpr double kTinySide = 3.0;

/// Price of a direction of faces that is across no axis of a solid, besides its freedom.
inline constexpr double kSlantedFacesCost = 6.0;

/// A reading by one template whose picture contradicts more than this share of the ink is not taken
/// by itself, nor is one that leaves more than kMostDetail of it inside faces where all of the
/// drawing is a solid.
inline constexpr double kMostContradiction = 0.05;
inline constexpr double kMostDetail = 0.02;
/// ... nor one whose corners are farther from where they were drawn than this, where another solid
/// explains the drawing [times the noise of its lines, and px].
inline constexpr double kPoorFitNoises = 2.0;
inline constexpr double kPoorFitPx = 1.5;

/// What is hidden is completed the simplest way. Price of a plane that closes a solid behind what
/// is seen: parallel to a seen face or across an axis, the mirror image of a seen face, any other;
/// and of a corner that is not seen.
inline constexpr double kParallelPlaneCost = 3.0;
inline constexpr double kMirrorPlaneCost = 4.0;
inline constexpr double kNewPlaneCost = 20.0;
inline constexpr double kUnseenCornerCost = 3.0;
/// ... and of a face that looks at the eye and is hidden whole: nothing tells that it is there.
inline constexpr double kHiddenFrontCost = 6.0;

/// Price of a solid that is seen from below, where the same lines show one from above.
inline constexpr double kFromBelowCost = 6.0;

/// So much of the hidden edges has ink where somebody draws hidden lines; dashes leave gaps.
inline constexpr double kHiddenDrawn = 0.4;

/// Solids of one topology whose volumes differ by less are one to a person: a hand's drawing does
/// not tell more of how deep they are. Exact ones are one only within kSameExactVolume.
inline constexpr double kSameVolume = 0.25;
inline constexpr double kSameExactVolume = 0.1;

}  // namespace ew::params
