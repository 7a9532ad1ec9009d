// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Every epsilon of the core, with its reason. Lengths in px are on the Sketch Plane at the default
/// distance threshold of 14 px; fractions of the distance threshold scale with it.
namespace ew::tol {

/// Two samples nearer than this are one [px]: below any tablet's resolution.
inline constexpr double kSamePointPx = 1e-9;

/// Largest extent of a dot, as a fraction of the distance threshold: anything that small cannot be
/// an edge, because its two ends would be one junction.
inline constexpr double kDotExtent = 0.5;

/// Reach of a pen-up or pen-down hook [px]; hooks come from the pen lifting while the hand moves.
inline constexpr double kHookReachPx = 9.0;
/// A hook leaves the line at more than this angle [degrees].
inline constexpr double kHookAngleDeg = 40.0;

/// Wobble that corner finding assumes before it knows the hand, and the range that a drawing can
/// move it to [px rms].
inline constexpr double kWobbleUnknownPx = 2.2;
inline constexpr double kWobbleLeastPx = 0.5;
/// Lines that stray from straight by less than this are ruled or computed [px]; they are read as if
/// drawn by a hand that wobbles by so much.
inline constexpr double kRuledPx = 0.02;
inline constexpr double kRuledWobblePx = 0.1;
/// A turn under this may be wobble [degrees].
inline constexpr double kWobbleTurnDeg = 32.0;
/// Distance over which a hand's wobble is correlated [px]; sets how much evidence a bend gives.
inline constexpr double kWobbleCorrelationPx = 14.0;
/// Evidence that one more corner must bring (log-likelihood ratio).
inline constexpr double kCornerPenalty = 5.0;
/// Consecutive pieces of one stroke that turn less than this are one line [degrees].
inline constexpr double kMinCornerDeg = 9.0;
/// A corner concentrates at least this share of its turn near its apex; less is a curve.
inline constexpr double kCornerSharpness = 0.55;

// Solid and template geometry. Relative values are fractions of the size, which is the diagonal of
// the bounding box.

/// Largest magnitude of a solid's or template's coordinate [mm]: a kilometre; beyond it doubles are
/// coarser than the drawing accuracy of a part.
inline constexpr double kMaxCoordinateMm = 1e6;
/// Smallest size of a solid or template [mm]: below it no pixel can show it and squares of lengths
/// come near the end of the doubles.
inline constexpr double kMinSizeMm = 1e-6;
/// A face is planar where no vertex is farther from its plane than this, relative: the accuracy
/// that exact drawings are held to. Also the largest move of a vertex that is made planar.
inline constexpr double kPlanarRelative = 1e-6;
/// Two planes of a solid to be made exact are one where all points of both lie within this,
/// relative: solvers leave residuals near 1e-12, a wanted step is above kPlanarRelative.
inline constexpr double kSamePlaneRelative = 1e-9;
/// Two face normals closer than this are made parallel (sine of the angle): turning a face by it
/// moves its points by at most 1e-9 of the size.
inline constexpr double kParallelSine = 1e-9;
/// Steps to which plane coefficients are rounded: 2^-40 of the size moves a point by 1e-12 of it
/// and keeps exact intersections at a few hundred bits.
inline constexpr double kPlaneGrid = 0x1p-40;
/// Longest exact coordinate that making faces planar may produce [bits]: three planes give about
/// 300, chains of dependent planes more; beyond this, exact predicates cost more than facets do.
inline constexpr unsigned kMaxRealizedBits = 4096;
/// Edges and near misses of a boolean's result shorter than this, relative, come from a tool that
/// misses the solid by rounding: what is meant to coincide coincides exactly, what can be drawn is
/// a thousand times larger.
inline constexpr double kSliverRelative = 1e-9;
/// No change of a solid leaves a wall, gap or step thinner than this, relative, and what a drawing
/// puts so near to a plane or a corner of the solid is meant to lie in it: a hundredth of a pixel
/// in a drawing of a thousand, which nobody can draw, and some hundred steps of single precision,
/// so that mesh files keep apart what is left apart.
inline constexpr double kThinnestRelative = 1e-5;
/// Longest exact coordinate that a boolean may produce [bits]. What coincides by exact constraints
/// stays far below; only long chains of parts that each hang on slanted ones before come here.
inline constexpr unsigned kMaxExactBits = 8192;
/// Plane coefficients up to this length are left alone [bits]: fitted ones (kPlaneGrid) have about
/// 100 with their offsets, and three such planes meet in points of about 500.
inline constexpr unsigned kLightBits = 128;
// Rounded geometry before exact arithmetic: the doubles decide where they are farther from zero
// than this, else rational numbers do. Each bounds the error of its formula, counting 2^-52 for
// every rounded input and operation, with a margin of 8 or more; relative to the formula's terms.

/// Height over a plane (a sum of four terms).
inline constexpr double kSideError = 0x1p-48;
/// Orientation of three points, areas and volumes (differences, then products; per term of a sum).
inline constexpr double kOrientError = 0x1p-46;
/// Triple product of two plane normals and an edge.
inline constexpr double kTripleError = 0x1p-44;
/// A place computed in doubles that misses a box by this share of the coordinates misses it
/// exactly, where the line that it lies on meets the plane under no smaller sine than this.
inline constexpr double kSurelyBeside = 1e-6;

/// What a tool's doubles have in common with the solid within this, relative (for normals: the sine
/// of the angle), is meant to be exact: an anchoring solver ends near 1e-12.
inline constexpr double kToolSnap = 1e-7;
/// Largest move of a tool's corner by its rules, as a fraction of its size: a drawing that needs
/// more was read wrongly.
inline constexpr double kToolMove = 1e-2;
/// Largest sine of a near miss that is taken for a right angle between two free faces of a tool.
inline constexpr double kToolRightAngle = 1e-9;
/// A template's relations hold for its reference shape within this: cosine, sine, or length
/// difference relative to the size. Files give irrational lengths with 7 digits or more.
inline constexpr double kTemplateRelation = 1e-6;
/// Sine of the smallest angle between neighbouring faces of a template; flatter ones would not show
/// as an edge in any drawing.
inline constexpr double kTemplateMinFold = 1e-3;

// Consolidation of overtraced lines (fractions are of the distance threshold).

/// A retraced line lies this near to the line it retraces, on average and at worst: two drawn
/// edges of one face are farther apart than that or could not be told apart by the threshold.
inline constexpr double kOvertraceMean = 0.5;
inline constexpr double kOvertraceMax = 0.85;
/// Directions of a line and its retrace differ by this at most, plus what the hand's end error does
/// to a short line [degrees].
inline constexpr double kOvertraceDeg = 6.0;
/// Share of the shorter line that must lie beside the longer one.
inline constexpr double kOvertraceOverlap = 0.45;

// Joining stroke ends.

/// Short lines join within this share of their own length only, or both their ends would join.
inline constexpr double kJoinLengthShare = 0.42;
/// Spread of a stroke end across and along its line [fractions of the distance threshold]: people
/// hit the line well and its end badly.
inline constexpr double kEndSpreadAcross = 0.13;
inline constexpr double kEndSpreadAlong = 0.45;
/// An end that runs past its junction counts this much of the way: overshoot is meant as contact.
inline constexpr double kOvershootDiscount = 0.5;
/// Ends no farther from each other than this (fraction of the distance threshold) lie together
/// whatever their lines say.
inline constexpr double kTipsTogether = 1.2;
/// Two strokes are one broken line where they point at each other (cosine) with this offset at most
/// [fraction of the distance threshold].
inline constexpr double kBreakCosine = 0.78;
inline constexpr double kBreakBeside = 0.9;
/// Overshoot that is trimmed without a word: fractions of the distance threshold and of the line.
inline constexpr double kOvershootReach = 2.4;
inline constexpr double kOvershootShare = 0.34;
/// A junction of several ends lies on another line within this fraction of the threshold.
inline constexpr double kThroughReach = 0.4;
/// A junction of two lines that turns less than this [degrees] and bends less than
/// kSurelyStraightBend of the distance threshold is no corner.
inline constexpr double kStraightDeg = 10.0;
inline constexpr double kSurelyStraightBend = 0.15;
/// Up to this turn [degrees] and bend it may be none: an edge drawn in two strokes.
inline constexpr double kBrokenTurnDeg = 42.0;
inline constexpr double kBrokenBend = 1.0;
/// Without a template to decide, a bend under this is taken for straight.
inline constexpr double kNearlyStraightDeg = 25.0;
inline constexpr double kStraightBend = 0.4;
/// An open end looks for what it was meant to meet this far [fractions of the distance threshold].
inline constexpr double kOpenEndReach = 6.0;

/// A camera vector whose largest component is shorter than this (or longer than its inverse) is no
/// direction: its square would leave the range in which normalising keeps all digits.
inline constexpr double kShortestDirection = 1e-9;
/// A direction this near to length 1 is used as it is, so that what was written reads back to the
/// bit.
inline constexpr double kUnitLength = 1e-12;
/// A pose's rotation may miss orthonormality by this much: products of a few rounded rotations do.
inline constexpr double kRotation = 1e-9;
/// Two edges of a solid whose unit directions differ by less than this are parallel (or, by the dot
/// product, perpendicular): a solid's planes are exact, its rounded corners are good to about 1e-9.
inline constexpr double kSolidDirection = 1e-7;

// Pictures of wireframes.

/// Crossings of projected edges nearer than this to an end, or pieces shorter (fractions of the
/// edge), are not told apart: far below a pixel for any edge that fits a screen.
inline constexpr double kWireCrossing = 1e-9;
/// A face hides an edge only where it is this much nearer [px of depth]: an edge lies on the faces
/// that merely touch it.
inline constexpr double kWireDepthPx = 1e-3;
/// A face seen flatter than this (sine of the angle) has no side towards the eye.
inline constexpr double kEdgeOnSine = 1e-6;
/// Places in the picture of a solid nearer than this share of its size are one: projecting rounds
/// at 1e-15, a solid's smallest features are 1e-9.
inline constexpr double kViewSame = 1e-9;
/// Something hides an edge where it is this share of the picture's size nearer: an edge lies on the
/// faces round it, and its depth and theirs are rounded apart.
inline constexpr double kViewDepth = 1e-7;

// Aspects.

/// A view is accidental where a face is seen within this sine of edge-on, or a vertex lies within
/// this share of an edge's length over that edge: nobody can tell such a drawing from its
/// neighbours.
inline constexpr double kAccidentalView = 0.02;

// Reconstruction.

/// Weight of one radian of a face angle's difference to the reference shape against one spread of a
/// drawn line end: closes open freedoms, moves determined ones by less than 1e-8.
inline constexpr double kRegularityWeight = 0.02;

/// Coordinates of a reconstructed body nearer than this share of its size are the same coordinate:
/// the solver ends at about 1e-12.
inline constexpr double kEqualCoordinate = 1e-9;
/// Share of kRegularityWeight that is left for an exact drawing: enough to close what is open.
inline constexpr double kLeastDoubt = 0.01;
/// Nobody draws better than this [px]: a display's rounding.
inline constexpr double kNoiseFloorPx = 0.05;
/// Directions in which the picture changes by less than this share of the most visible one
/// (squared) are not determined by the drawing.
inline constexpr double kUnseenDirection = 1e-7;
/// Singular values of a template's relations below this share of the largest belong to redundant
/// relations.
inline constexpr double kRelationRank = 1e-3;
/// Rectangular corners within this of 90 degrees say next to nothing about depth [degrees]: 8% a
/// degree of drawing error at 95, 18% at 92 (docs/algorithms.md).
inline constexpr double kUnreliableCornerDeg = 6.0;
/// A solution whose critical angle is within this many of its own spreads of 90 degrees yields to
/// the oblique reading; and so it does, where this hand can have meant a right angle at all, within
/// so many degrees: depth comes out more than three times as long as it is drawn there.
inline constexpr double kDepthSpreads = 0.7;
inline constexpr double kStretchedCornerDeg = 2.5;
/// A corner without real roots is turned this far past 90 degrees to have some [degrees].
inline constexpr double kSnapMarginDeg = 4.0;
/// ... if no axis has to turn more than this [degrees].
inline constexpr double kSnapLimitDeg = 25.0;

/// A face that should be hidden may show this many end spreads of width (two thirds of the distance
/// threshold): nobody draws a face that narrow.
inline constexpr double kSliverSpreads = 5.0;

/// Up to this distance of its most nearly right angle from 90 degrees a corner is offered as
/// oblique too.
inline constexpr double kObliqueLimitDeg = 35.0;

// Choosing between candidates. Costs are in units of twice a log-likelihood.

/// Price of one more degree of freedom (three times the Bayesian information criterion
/// at about 36 observations: people draw boxes far more often than nearly-boxes).
inline constexpr double kFreedomCost = 11.0;
/// Price of an edge that was not drawn, of one too many, and of a plane that nothing was drawn on.
inline constexpr double kMissingEdgeCost = 14.0;
inline constexpr double kExtraEdgeCost = 12.0;
inline constexpr double kUnseenPlaneCost = 8.0;
/// Price of a second look at the strokes with other tolerances.
inline constexpr double kSecondLookCost = 2.0;
/// Hands miss corners by more than their lines wobble: line ends are off by about this many times
/// the wobble.
inline constexpr double kMissPerWobble = 2.5;
/// ... and no hand that wobbles at all misses by less than this [px], or so many times its wobble.
inline constexpr double kMissAtLeastPx = 1.5;
inline constexpr double kMissPerSteadyWobble = 8.0;
/// Two line ends that aim at one point lie this many times as far apart, per axis, as this hand's
/// lines wobble.
inline constexpr double kSpreadPerWobble = 3.6;
/// A candidate whose line ends miss it by this many variances on average leaves doubt about the
/// graph.
inline constexpr double kDoubtfulMisfit = 3.0;
/// Price of a reading that is offered although the drawing speaks against it.
inline constexpr double kUnlikelyReadingCost = 12.0;
/// A candidate is taken by itself only where it explains the ink but for this share: so much for
/// each edge beyond the second that it shows, so much at most.
inline constexpr double kUnexplainedPerEdge = 0.018;
inline constexpr double kMostUnexplained = 0.16;
/// Edges may turn from their direction class by what moving an end by this share of the distance
/// threshold does, or by this many spreads of this hand's line ends.
inline constexpr double kTurnExcuse = 0.3;
inline constexpr double kTurnSpreads = 1.5;
/// A candidate is clear where the next different one costs this much more.
inline constexpr double kClearMargin = 4.0;
inline constexpr double kClearMarginImperfect = 16.0;
/// ... and its lines are within this fraction of the distance threshold of the solid, rms.
inline constexpr double kClearResidual = 0.55;
/// People draw boxes more often than all else: any other template pays this.
inline constexpr double kBoxesAreUsual = 6.0;
/// Ink beside an aspect that was laid over the ink as a whole costs this many times more again: the
/// graph, which would tell what it is, was not asked.
inline constexpr double kBesideOutline = 2.0;
/// ... and such a reading is taken by itself up to this price, for each edge beyond the second, of
/// ink beside it, of edges bare of ink, and of ink bent along its edges.
inline constexpr double kOutlineTells = 2.7;

// Fillet, subdivision and strokes on the surface.

/// Share of an edge's length, or of the distance between two edges of a face, that fillets leave
/// over when they are clamped: a face that shrinks to nothing would have no normal.
inline constexpr double kFilletRest = 0.01;
/// A setback that weighs less than this in a clamp, against the heaviest one, is not stopped by it:
/// what it uses up stays within kFilletRest.
inline constexpr double kFilletLightWeight = 0.02;
/// Points of a fillet nearer than this share of the setback are one point.
inline constexpr double kFilletSamePoint = 1e-7;
/// A corner patch is one flat face where its points lie within this share of the setback in a
/// plane.
inline constexpr double kFilletFlat = 1e-9;
/// Least sine of the angle at which the side of a strip is prolonged to the neighbouring sharp
/// edge: below it the strip's end would lie more than two setbacks away.
inline constexpr double kFilletCutSine = 0.5;
/// Two filleted edges of a face that are this near to one straight line (sine of the angle between
/// them) meet in a step, because their sides would meet far away or never.
inline constexpr double kFilletStraightSine = 0.5;
/// Strips go round the end of a third one where the arc in the face begins at least this share of
/// its setback away from where their sides would meet.
inline constexpr double kFilletArcLeast = 0.05;
/// An arc that would begin so much nearer to where its sides meet than it ends (ratio) is drawn as
/// a curve that bends less.
inline constexpr double kFilletArcSkew = 0.25;
/// Arcs that turn by less than this [rad] are drawn straight: their sagitta is below 1e-4 setbacks.
inline constexpr double kFilletArcAngle = 1e-3;
/// Triangles are apart where a separating plane leaves this share of the model's size: a few
/// roundings of coordinates.
inline constexpr double kApartRelative = 1e-13;
/// Triangles round a point are seen beside each other along an axis to which all their normals have
/// at least this cosine.
inline constexpr double kSpreadCosine = 0.05;
/// Two triangles on one edge lie on each other where the sine of the angle between them is below
/// this: rounded points of faces that are truly apart keep more.
inline constexpr double kFoldedSine = 1e-9;
/// Two triangles join to a quadrangle where each of its corners turns by more than this sine:
/// flatter corners make subdivision wrinkle.
inline constexpr double kLeastQuadSine = 0.05;
/// A support loop goes no farther into a spike than at this value of 1 + cosine of the turn: about
/// 160 degrees.
inline constexpr double kSharpestInset = 0.06;

// Drawing on a solid.

/// Anchors and relations of a template on a solid hold within this share of the drawing's size, or
/// they contradict each other: the solver ends at about 1e-12.
inline constexpr double kAnchorResidual = 1e-8;

/// Rows of linear relations on a solid depend on each other below this share of the largest
/// singular value: directions of the model are apart or the same to rounding.
inline constexpr double kLinearRank = 1e-9;
/// Price of a wall that does not stand upright, and of two directions of the model for what is
/// perpendicular in the template.
inline constexpr double kSlantCost = 3.0;
inline constexpr double kSkewCost = 6.0;

/// A change of a solid whose line ends miss it by so many variances on average needs no other look
/// at the strokes; one by so many no other directions than the model's.
inline constexpr double kPlainMisfit = 0.9;
inline constexpr double kUnderstoodMisfit = 2.0;
/// A line that a careless hand bends turns by no more than this [degrees] and strays from straight
/// by no more than this fraction of the distance threshold.
inline constexpr double kCarelessTurnDeg = 40.0;
inline constexpr double kCarelessBend = 0.7;
/// Ink that turns by more than this where it meets an edge or a corner of the solid may be bent
/// there, over the edge [degrees].
inline constexpr double kFoldDeg = 3.0;

/// A stroke is a model edge where it lies beside it within this fraction of the distance threshold.
inline constexpr double kAlongModel = 0.8;
/// A direction of the model that is seen shorter than this (sine to the view) gives none on the
/// screen.
inline constexpr double kEndOnSine = 0.05;
/// On a solid a line that misses the model's directions or faces by less than this fraction of the
/// distance threshold does not speak against them, however steady the hand.
inline constexpr double kSnapNoise = 0.1;
/// A start that misses the drawing by this many times what a solution may is not worth solving.
inline constexpr double kStartResidual = 2.5;
/// Changes of a solid whose volumes differ by less than this share are one, where their faces and
/// edges are as many.
inline constexpr double kSameChange = 0.05;
/// Of two templates that make the same change the one that can show fewer shapes is meant: price of
/// each freedom that its relations leave.
inline constexpr double kTemplateFreedomCost = 0.1;
/// Price of a model edge that a reading on a solid takes in, and of a direction that is none of the
/// model's.
inline constexpr double kModelEdgeCost = 0.5;
inline constexpr double kStrangeDirectionCost = 6.0;
/// Where the two derivatives of a surface are parallel within this sine it has no normal of its
/// own: a corner of a face that lies straight on a crease.
inline constexpr double kNoNormalSine = 1e-9;

/// A triangle has no area where it is no higher than this share of its longest side: its corners
/// are on one line to rounding.
inline constexpr double kNoAreaRatio = 1e-7;
/// Two to four steps of single precision, as a share of the largest coordinate: heights of
/// triangles below it are noise to a program that reads them so.
inline constexpr double kSingleStep = 0x1p-22;

/// Two edges lie on one line, and two faces in one plane, where they are this close [share of the
/// solid's size; sine of the angle]: an exact boolean moves what it leaves by rounding only.
inline constexpr double kSameEdgeRelative = 1e-7;

/// A corner of an exported polygon that turns by less than this sine is none: a reader that cuts
/// the polygon there would get a triangle without area in single precision.
inline constexpr double kNoTurnSine = 1e-5;
/// A mesh file in single precision is moved to the origin where it lies farther from there than
/// this many times its size: nearer, rounding is below a millionth of the size anyway.
inline constexpr double kFarFromOrigin = 16.0;
/// Bodies in one file whose format has one origin for all: the farthest may lie this many times the
/// size of the smallest away, which rounds it by less than a thousandth of its size.
inline constexpr double kSinglePrecisionReach = 1e4;
/// The same for coordinates in double precision: beyond it the solid itself is no longer what was
/// drawn.
inline constexpr double kDoublePrecisionReach = 1e12;

}  // namespace ew::tol
