// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/whole_shapes.h"

namespace ew::test {

/// Is every junction far enough from the others and from foreign lines, and every line long enough?
bool isReadable(const WholeCase& drawn);

/// Faces that are turned to the eye by more than a sliver.
int wellSeenFaces(const Solid& solid, const OrthographicCamera& camera);

/// Is something seen of every foot and every bite? Edges that bend inwards and hang together belong
/// to one; what shows none of its own nobody can tell.
bool showsItsParts(const Solid& solid, const OrthographicCamera& camera);

/// Is something seen of every face that looks at the eye? Behind others there may be anything.
bool showsItsFaces(const Solid& solid, const OrthographicCamera& camera);

/// Does the outline of every face that looks at the eye turn at each of its corners by more than
/// what passes for straight?
bool showsItsCorners(const Solid& solid, const OrthographicCamera& camera);

/// Is any face seen so nearly edge-on that it looks like a line?
bool hasSliver(const Solid& solid, const OrthographicCamera& camera);

}  // namespace ew::test
