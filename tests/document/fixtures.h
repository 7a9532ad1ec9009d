// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/document/document.h"

namespace ew::test {

/// A box with corners at the origin and (x, y, z).
PolyhedronSpec cornerBox(double x, double y, double z);

/// The box as a template with the relations of a cube.
Template boxTemplate(const std::string& id, const std::string& name);

/// A straight stroke of two samples.
Stroke line(const Vec2& from, const Vec2& to);

/// Reads any ink as a box: width and depth from the extent of the first stroke, height 1 plus the
/// number of strokes, times the oblique factor for the second candidate. The first candidate is
/// accepted, unless the ink is exactly two strokes: that is ambiguous. Three strokes are no match.
Interpretation fakeInterpreter(const std::vector<Stroke>& strokes, const TemplateLibrary& library,
                               const InterpretOptions& options);

/// A library with one template, "box".
TemplateLibrary smallLibrary();

/// The templates that the program brings, loaded once.
const TemplateLibrary& shippedLibrary();

/// An empty document that reads strokes with fakeInterpreter.
std::unique_ptr<Document> fakeDocument();

/// One random thing that a person can do; what is refused changes nothing.
/// \param what  0..kDeeds - 1.
/// \param number  0..29, how it is done.
inline constexpr int kDeeds = 31;
void doSomething(Document& document, int what, int number);

/// True where both have the same solids to the bit, in the same poses, the same templates,
/// surface settings and mapped strokes.
bool sameState(const DocumentState& a, const DocumentState& b);

}  // namespace ew::test
