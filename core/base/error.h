// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// What went wrong, as a stable code. The text form (errcName) is part of the report format and
/// never changes; new codes are added at the end of their group.
enum class Errc {
    // Reading the strokes
    EmptySketch,       ///< "empty-sketch": nothing was drawn
    BadCoordinates,    ///< "bad-coordinates": NaN, infinite or absurdly large
    TooManyPoints,     ///< "too-many-points"
    TooManyStrokes,    ///< "too-many-strokes"
    DegenerateStroke,  ///< "degenerate-stroke": too short to be a line
    CurvedStroke,      ///< "curved-stroke": no polyline
    Scribble,          ///< "scribble"
    NoStroke,          ///< "no-stroke": nothing within reach to erase
    // Edge Graph
    OnlyNoise,         ///< "only-noise": every stroke was dropped
    OpenEnd,           ///< "open-end": a stroke end meets nothing within the distance threshold
    SelfCrossing,      ///< "self-crossing": edges cross where no junction is
    SeparateDrawings,  ///< "separate-drawings": more than one connected drawing
    NoRegion,          ///< "no-region": the lines enclose nothing
    FlatDrawing,       ///< "flat-drawing": an outline without lines inside it
    MissingEdge,       ///< "missing-edge": with one more line it is a solid
    ExtraEdge,         ///< "extra-edge": without one line it is a solid
    CurvedEdge,        ///< "curved-edge": with one line straight it is a solid
    HiddenLine,        ///< "hidden-line": without a line that cannot be seen it is a solid
    TooSmall,          ///< "too-small": the lines lie nearer together than what counts as meeting
    Perspective,       ///< "perspective": edges that are parallel in space converge
    // Matching and reconstruction
    NoMatch,              ///< "no-match": no template shows this graph
    Ambiguous,            ///< "ambiguous": several readings, none clearly best
    ImpossibleCorner,     ///< "impossible-corner": breaks Perkins' law, no rectangular corner
    NotParallel,          ///< "not-parallel": edges that must be parallel are not
    UnknownTemplate,      ///< "unknown-template"
    UnknownCandidate,     ///< "unknown-candidate"
    OperationImpossible,  ///< "operation-impossible"
    NoSolution,           ///< "no-solution": the template matched but no solid fits the drawing
    // Solid
    NotClosed,         ///< "not-closed"
    NotManifold,       ///< "not-manifold"
    NotOriented,       ///< "not-oriented"
    NotPlanar,         ///< "not-planar"
    SelfIntersecting,  ///< "self-intersecting"
    NoVolume,          ///< "no-volume"
    NoChange,          ///< "no-change": the operation would leave the solid as it is
    NothingLeft,       ///< "nothing-left": the operation would leave no solid
    TouchesInEdge,     ///< "touches-in-edge": the solid would touch itself in an edge only
    TouchesInPoint,    ///< "touches-in-point": the solid would touch itself in a point only
    Sliver,            ///< "sliver": parts or gaps far thinner than anything that can be drawn
    Contradiction,     ///< "contradiction": no shape obeys all the constraints
    // Surface
    NoEdge,         ///< "no-edge": no edge was chosen
    NoSurface,      ///< "no-surface": there is no surface under the strokes
    TooMuchMemory,  ///< "too-much-memory": the result would exceed the limit that is set
    // Files and scripts
    Syntax,            ///< "syntax": not JSON
    WrongFormat,       ///< "wrong-format": JSON, but not this format
    WrongVersion,      ///< "wrong-version"
    UnknownKey,        ///< "unknown-key"
    MissingKey,        ///< "missing-key"
    WrongType,         ///< "wrong-type"
    BadValue,          ///< "bad-value": right type, value out of range
    TooLarge,          ///< "too-large": file over the size limit
    TooDeep,           ///< "too-deep": nested beyond the limit
    BadTemplate,       ///< "bad-template"
    DuplicateId,       ///< "duplicate-id"
    FileNotFound,      ///< "file-not-found"
    CannotWrite,       ///< "cannot-write"
    UnknownExtension,  ///< "unknown-extension"
    Cancelled,         ///< "cancelled"
    NothingToUndo,     ///< "nothing-to-undo"
    NothingToRedo,     ///< "nothing-to-redo"
    NoSolid,           ///< "no-solid": the step needs a solid and there is none
    NotAvailable,      ///< "not-available": this build cannot do it
    Internal,          ///< "internal": a library failed in a way no input should cause
    Damaged,           ///< "damaged": the file's bytes were cut off or changed
    InUse,             ///< "in-use": another process has the file open
};

/// Stable text of a code, e.g. "no-match".
std::string_view errcName(Errc code);

/// An error that a user can cause: a stable code, a sentence a designer understands, and the
/// places in the sketch that it speaks of.
struct Error {
    Errc code = Errc::Internal;
    std::string message;
    std::vector<Vec2> where;  ///< [Sketch Plane px], empty where it has no place
};

}  // namespace ew
