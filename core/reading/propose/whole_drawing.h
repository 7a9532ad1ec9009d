// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/build.h"
#include "core/reading/types/interpretation.h"

namespace ew {

/// What a drawing was read as without the help of a single template of the library.
struct WholeReading {
    EdgeGraph graph;                    ///< that the candidates speak of
    std::vector<Candidate> candidates;  ///< best first
    bool clear = false;                 ///< the first one explains the ink, and no other does
    double residue = 1.0;               ///< of the first one: PictureEvidence::residue()
    bool isKnown = false;               ///< the first one is a template of the library
};

/// Reads a drawing in free space as one solid: prisms, pyramids and frusta over any polygon. Each
/// proposal is solved, made a solid, and its picture compared with the ink.
/// \paper{8}
WholeReading readWholeDrawing(const InkReading& ink, const TemplateLibrary& library,
                              const InterpretOptions& options);

/// Most lines that any view of a template has: a drawing of more is none of a template.
std::size_t mostLines(const TemplateLibrary& library);

}  // namespace ew
