// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

namespace ew {

std::string_view errcName(Errc code) {
    switch (code) {
        case Errc::EmptySketch:
            return "empty-sketch";
        case Errc::BadCoordinates:
            return "bad-coordinates";
        case Errc::TooManyPoints:
            return "too-many-points";
        case Errc::TooManyStrokes:
            return "too-many-strokes";
        case Errc::DegenerateStroke:
            return "degenerate-stroke";
        case Errc::CurvedStroke:
            return "curved-stroke";
        case Errc::Scribble:
            return "scribble";
        case Errc::NoStroke:
            return "no-stroke";
        case Errc::OnlyNoise:
            return "only-noise";
        case Errc::OpenEnd:
            return "open-end";
        case Errc::SelfCrossing:
            return "self-crossing";
        case Errc::SeparateDrawings:
            return "separate-drawings";
        case Errc::NoRegion:
            return "no-region";
        case Errc::NoMatch:
            return "no-match";
        case Errc::Ambiguous:
            return "ambiguous";
        case Errc::ImpossibleCorner:
            return "impossible-corner";
        case Errc::NotParallel:
            return "not-parallel";
        case Errc::UnknownTemplate:
            return "unknown-template";
        case Errc::UnknownCandidate:
            return "unknown-candidate";
        case Errc::OperationImpossible:
            return "operation-impossible";
        case Errc::NoSolution:
            return "no-solution";
        case Errc::NotClosed:
            return "not-closed";
        case Errc::NotManifold:
            return "not-manifold";
        case Errc::NotOriented:
            return "not-oriented";
        case Errc::NotPlanar:
            return "not-planar";
        case Errc::SelfIntersecting:
            return "self-intersecting";
        case Errc::NoVolume:
            return "no-volume";
        case Errc::Syntax:
            return "syntax";
        case Errc::WrongFormat:
            return "wrong-format";
        case Errc::WrongVersion:
            return "wrong-version";
        case Errc::UnknownKey:
            return "unknown-key";
        case Errc::MissingKey:
            return "missing-key";
        case Errc::WrongType:
            return "wrong-type";
        case Errc::BadValue:
            return "bad-value";
        case Errc::TooLarge:
            return "too-large";
        case Errc::TooDeep:
            return "too-deep";
        case Errc::BadTemplate:
            return "bad-template";
        case Errc::DuplicateId:
            return "duplicate-id";
        case Errc::FileNotFound:
            return "file-not-found";
        case Errc::CannotWrite:
            return "cannot-write";
        case Errc::UnknownExtension:
            return "unknown-extension";
        case Errc::Cancelled:
            return "cancelled";
        case Errc::NothingToUndo:
            return "nothing-to-undo";
        case Errc::NothingToRedo:
            return "nothing-to-redo";
        case Errc::NoSolid:
            return "no-solid";
        case Errc::NotAvailable:
            return "not-available";
        case Errc::Internal:
            return "internal";
    }
    return "internal";
}

}  // namespace ew
