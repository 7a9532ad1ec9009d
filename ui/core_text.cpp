// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/core_text.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <initializer_list>
#include <span>
#include <vector>

#include "core/base/words.h"
#include "ui/file_sentences.h"
#include "ui/lesson/class_sentences.h"
#include "ui/template_names.h"

namespace ew {

namespace {

constexpr const char* kContext = "Core";

/// What the core says, with %1, %2 ... for what varies; of two that fit, the earlier one counts.
constexpr const char* kSentences[] = {
    QT_TRANSLATE_NOOP("Core", "All but this corner fits %1; it is %2 from where it would be."),
    QT_TRANSLATE_NOOP(
        "Core", "This is too small to be read: it is %1 px across. Zoom in and draw it larger."),
    QT_TRANSLATE_NOOP("Core",
                      "These lines converge as in perspective, by up to %1 degrees. Only "
                      "right-angled shapes are read so; draw "
                      "edges that are parallel in space as parallel lines."),
    QT_TRANSLATE_NOOP(
        "Core",
        "This line is a curve; solids are drawn with straight lines (round them afterwards)."),
    QT_TRANSLATE_NOOP("Core", "One line is missing here; with it this is %1."),
    QT_TRANSLATE_NOOP(
        "Core", "Without this line this is %1; edges that cannot be seen from here are not drawn."),
    QT_TRANSLATE_NOOP(
        "Core",
        "Without these lines this is %1; edges that cannot be seen from here are not drawn."),
    QT_TRANSLATE_NOOP("Core", "Without this line this is %1."),
    QT_TRANSLATE_NOOP("Core", "Without these lines this is %1."),
    QT_TRANSLATE_NOOP("Core", "%1 is damaged and cannot be opened whole: %2."),
    QT_TRANSLATE_NOOP("Core",
                      "%1: The document was written by a later version (its schema is %2, this "
                      "program reads up to %3); Edgewright %4 or later is needed."),
    QT_TRANSLATE_NOOP("Core",
                      "%1: The document was written by a later version (its schema is %2, this "
                      "program reads up to %3); a later version of Edgewright is needed."),
    QT_TRANSLATE_NOOP("Core", "The solid has no such face to pull."),
    QT_TRANSLATE_NOOP("Core", "A face cannot be pulled so far."),
    QT_TRANSLATE_NOOP("Core", "A pull by 0 mm changes nothing."),
    QT_TRANSLATE_NOOP(
        "Core",
        "This face is not flat enough to be pulled: its corners lie in one plane to the eye only."),
    QT_TRANSLATE_NOOP("Core",
                      "The faces beside this one do not tell where its corners would go; pull it "
                      "with straight walls."),
    QT_TRANSLATE_NOOP(
        "Core",
        "The face would shrink to nothing after %1; pull it less far, or with straight walls."),
    QT_TRANSLATE_NOOP("Core", "A solid can be moved by numbers only."),
    QT_TRANSLATE_NOOP("Core", "A solid cannot be scaled to nothing."),
    QT_TRANSLATE_NOOP("Core", "A solid is scaled by numbers from 0.000001 to 1000000."),
    QT_TRANSLATE_NOOP("Core", "A solid is turned by a number of degrees."),
    QT_TRANSLATE_NOOP("Core", "The axis to turn about has no direction."),
    QT_TRANSLATE_NOOP("Core", "The mirror plane has no direction."),
    QT_TRANSLATE_NOOP("Core", "This is the mirror plane already."),
    QT_TRANSLATE_NOOP("Core", "There is no mirror plane."),
    QT_TRANSLATE_NOOP("Core",
                      "The mirror image would hang in the air; move the mirror plane, or drop it."),
    QT_TRANSLATE_NOOP("Core", "A solid cannot be moved so far."),
    QT_TRANSLATE_NOOP("Core", "A name is one line of at most %1 bytes."),
    QT_TRANSLATE_NOOP("Core", "There is no solid called %1."),
    QT_TRANSLATE_NOOP("Core", "There is no solid number %1; there are %2, counted from 0."),
    QT_TRANSLATE_NOOP("Core", "All solids are hidden."),
    QT_TRANSLATE_NOOP("Core", "All solids are hidden; show one to export it."),
    QT_TRANSLATE_NOOP("Core", "Another solid is called %1."),
    QT_TRANSLATE_NOOP("Core", "The solid is shown already."),
    QT_TRANSLATE_NOOP("Core", "The solid is hidden already."),
    QT_TRANSLATE_NOOP("Core", "A solid is combined with another one."),
    QT_TRANSLATE_NOOP("Core", "The two solids do not touch each other."),
    QT_TRANSLATE_NOOP("Core",
                      "A line that cuts a solid runs from one side of it to the other; this one "
                      "ends inside a face."),
    QT_TRANSLATE_NOOP(
        "Core", "The line lies in no plane, and a cut is plane; draw it straight on every face."),
    QT_TRANSLATE_NOOP("Core", "The line runs over no solid."),
    QT_TRANSLATE_NOOP("Core", "The plane through this line misses the solid."),
    QT_TRANSLATE_NOOP("Core", "There is no solid to cut in two."),
    QT_TRANSLATE_NOOP("Core", "This line could cut the solid in two; choose it, or draw on."),
    QT_TRANSLATE_NOOP("Core", "Cut the solid in two"), QT_TRANSLATE_NOOP("Core", "Cut in two"),
    QT_TRANSLATE_NOOP("Core", "square"), QT_TRANSLATE_NOOP("Core", "No face is seen there."),
    QT_TRANSLATE_NOOP("Core", "No closed outline runs round this place."),
    QT_TRANSLATE_NOOP("Core",
                      "This closed line is no circle on the face; draw it straighter, or rounder."),
    QT_TRANSLATE_NOOP("Core", "This outline encloses nothing."),
    QT_TRANSLATE_NOOP("Core", "This outline leaves the face; an outline to pull lies in one face."),
    QT_TRANSLATE_NOOP("Core",
                      "This outline says where, not how deep; pull it (L), or draw one line into "
                      "the solid or out of it."),
    QT_TRANSLATE_NOOP("Core", "Another window has this document open."),
    QT_TRANSLATE_NOOP("Core", "The folder %1 cannot be made or written to."),
    QT_TRANSLATE_NOOP("Core", "there is no room left on the disk"),
    QT_TRANSLATE_NOOP("Core", "there is not enough memory"),
    QT_TRANSLATE_NOOP("Core", "the file cannot be read or written (%1)"),
    QT_TRANSLATE_NOOP("Core",
                      "A line ends %1 from what it should meet (the distance threshold is %2)."),
    QT_TRANSLATE_NOOP(
        "Core", "%1 line ends meet nothing; the nearest gap is %2 (the distance threshold is %3)."),
    QT_TRANSLATE_NOOP("Core", "The lines enclose nothing: a solid needs closed outlines."),
    QT_TRANSLATE_NOOP(
        "Core", "This is a curve; solids are drawn with straight lines (round them afterwards)."),
    QT_TRANSLATE_NOOP("Core", "This looks like a scribble; no straight lines were found in it."),
    QT_TRANSLATE_NOOP("Core", "There are only dots here; draw the edges of a solid."),
    QT_TRANSLATE_NOOP("Core", "These are %1 separate drawings; apply them one at a time."),
    QT_TRANSLATE_NOOP("Core",
                      "This corner cannot be right-angled: at a Y all three angles must be over 90 "
                      "degrees, at an arrow both inner angles under 90 with a sum over 90."),
    QT_TRANSLATE_NOOP(
        "Core", "Lines cross at %1 where no corner is; draw visible edges only, or drop a line."),
    QT_TRANSLATE_NOOP("Core",
                      "This could be %1, but an edge is %2 degrees off its parallels (the angle "
                      "threshold is %3)."),
    QT_TRANSLATE_NOOP("Core", "The lines fit no %1 closely: they are %2 off on average."),
    QT_TRANSLATE_NOOP(
        "Core", "This could be %1, but only without some of the lines; choose it, or draw on."),
    QT_TRANSLATE_NOOP(
        "Core", "This could be %1, but only with edges that are not drawn; choose it, or draw on."),
    QT_TRANSLATE_NOOP("Core",
                      "This could be %1, but it would run through the solid that is there; choose "
                      "it, or draw on."),
    QT_TRANSLATE_NOOP("Core", "This could be %1 of these lengths; choose it, or draw on."),
    QT_TRANSLATE_NOOP("Core", "This could be %1; choose it, or draw on."),
    QT_TRANSLATE_NOOP("Core",
                      "This is one flat outline; a solid needs the lines inside it too, where its "
                      "faces meet."),
    QT_TRANSLATE_NOOP("Core",
                      "Just two faces are drawn here; this could be %1. Choose it, or draw the "
                      "third face."),
    QT_TRANSLATE_NOOP("Core",
                      "As it is drawn %1 would be far deeper than it is wide, or hardly thicker "
                      "than a line; choose it, or draw it from another side."),
    QT_TRANSLATE_NOOP("Core",
                      "Seen from here %1 looks like simpler solids; choose it, or turn the view "
                      "and draw again."),
    QT_TRANSLATE_NOOP("Core",
                      "Seen from here this could be %1, or something simpler; choose it, or turn "
                      "the view and draw again."),
    QT_TRANSLATE_NOOP(
        "Core",
        "No template shows %1 and %2 like this. The nearest is %3 (%4 missing, %5 too many)."),
    QT_TRANSLATE_NOOP("Core",
                      "No template shows %1 and %2 like this. The nearest is %3 (%4 missing)."),
    QT_TRANSLATE_NOOP("Core",
                      "No template shows %1 and %2 like this. The nearest is %3 (%4 too many)."),
    QT_TRANSLATE_NOOP("Core",
                      "No template shows %1 and %2 like this. The nearest is %3, but the lines "
                      "meet in another way."),
    QT_TRANSLATE_NOOP("Core", "No template shows %1 and %2 like this."),
    QT_TRANSLATE_NOOP("Core", "No template matches this drawing."),
    QT_TRANSLATE_NOOP("Core",
                      "These lines and the edges that they meet show no template on the solid."),
    QT_TRANSLATE_NOOP("Core", "These lines are edges of the solid already: nothing would change."),
    QT_TRANSLATE_NOOP("Core", "There is no template \"%1\" in the library."),
    QT_TRANSLATE_NOOP("Core", "There are %1 strokes; at most %2 are read at once."),
    QT_TRANSLATE_NOOP("Core",
                      "There are more lines than the %1 that are read at once; draw one solid at a "
                      "time."),
    QT_TRANSLATE_NOOP("Core", "There are %1 pending strokes already; apply or clear them first."),
    QT_TRANSLATE_NOOP("Core", "This can be read as %1; choose one."),
    QT_TRANSLATE_NOOP("Core", "Nothing was made or changed yet."),
    QT_TRANSLATE_NOOP("Core", "More solids were made than are wanted; draw one at a time."),
    QT_TRANSLATE_NOOP(
        "Core",
        "It was done to the wrong side: what was to be added was cut, or the other way round."),
    QT_TRANSLATE_NOOP("Core", "It became another kind of shape."),
    QT_TRANSLATE_NOOP("Core", "The shape is right, but it is in the wrong place."),
    QT_TRANSLATE_NOOP("Core",
                      "The shape is right, but its proportions are far from the wanted ones."),
    QT_TRANSLATE_NOOP("Core",
                      "It was done with other edges, another size or another kind of surface."),
    QT_TRANSLATE_NOOP("Core", "The lesson has %1 steps."),
    QT_TRANSLATE_NOOP("Core", "A lesson has no step %1."),
    QT_TRANSLATE_NOOP("Core", "Nothing is drawn yet."),
    QT_TRANSLATE_NOOP("Core", "There is no stroke within reach to erase."),
    QT_TRANSLATE_NOOP("Core", "There is no solid to cut."),
    QT_TRANSLATE_NOOP("Core", "There is no solid to add to."),
    QT_TRANSLATE_NOOP("Core", "There is no solid to delete."),
    QT_TRANSLATE_NOOP("Core", "There is no solid to export yet."),
    QT_TRANSLATE_NOOP("Core", "There is no solid to make a template from."),
    QT_TRANSLATE_NOOP("Core", "a template has 4 to 64 vertices, not %1."),
    QT_TRANSLATE_NOOP("Core", "The solid cuts through itself."),
    QT_TRANSLATE_NOOP("Core", "The faces of the solid point inwards."),
    QT_TRANSLATE_NOOP("Core", "Faces %1 and %2 cut through or touch each other."),
    QT_TRANSLATE_NOOP("Core", "coordinates must be finite and at most 1000000."),
    QT_TRANSLATE_NOOP("Core", "edges %1 and %2 are parallel too; they cannot be both."),
    QT_TRANSLATE_NOOP("Core", "edge %1 runs against its own class."),
    QT_TRANSLATE_NOOP("Core", "vertex %1 is off the face's plane."),
    QT_TRANSLATE_NOOP("Core", "edge %1 has no length."),
    QT_TRANSLATE_NOOP("Core", "the face has no area."),
    QT_TRANSLATE_NOOP("Core", "the shape is too small."),
    QT_TRANSLATE_NOOP("Core", "lies in one plane with face %1; make them one face."),
    QT_TRANSLATE_NOOP("Core", "A template's faces have no holes; this solid's have."),
    QT_TRANSLATE_NOOP("Core",
                      "This drawing cannot be read as that operation; let the program choose it."),
    QT_TRANSLATE_NOOP("Core", "There is nothing to undo."),
    QT_TRANSLATE_NOOP("Core", "There is nothing to redo."),
    QT_TRANSLATE_NOOP("Core", "The stroke to repair is gone."),
    QT_TRANSLATE_NOOP("Core", "There is no file at %1."),
    QT_TRANSLATE_NOOP("Core", "The new part lies inside the solid: nothing would change."),
    QT_TRANSLATE_NOOP("Core", "The part to cut out lies beside the solid: nothing would change."),
    QT_TRANSLATE_NOOP("Core", "The solid lies inside the part: nothing would change."),
    QT_TRANSLATE_NOOP("Core", "Nothing of the solid would be left."),
    QT_TRANSLATE_NOOP("Core", "The two parts have nothing in common."),
    QT_TRANSLATE_NOOP("Core",
                      "Two parts would all but touch: a wall, gap or step thinner than a hair "
                      "would be left that nobody can see. Make the new part a little larger or "
                      "smaller."),
    QT_TRANSLATE_NOOP("Core",
                      "The solid would touch itself along an edge only. Make the new part a little "
                      "larger or smaller."),
    QT_TRANSLATE_NOOP("Core",
                      "The solid would touch itself in a point only. Make the new part a little "
                      "larger or smaller."),
    QT_TRANSLATE_NOOP("Core", "One edge that was not drawn was added."),
    QT_TRANSLATE_NOOP("Core", "%1 edges that were not drawn were added."),
    QT_TRANSLATE_NOOP("Core", "One line too many was left out."),
    QT_TRANSLATE_NOOP("Core", "Lines that run past the corners were taken for guide lines."),
    QT_TRANSLATE_NOOP("Core",
                      "Parts that cannot be seen from here keep the template's proportions."),
    QT_TRANSLATE_NOOP(
        "Core", "The corner has no exact solution; the nearest drawing that has one was taken."),
    QT_TRANSLATE_NOOP("Core",
                      "Read as an oblique drawing: the front face is true, the depth is a choice."),
    QT_TRANSLATE_NOOP("Core",
                      "The drawing leaves one measure open; the most regular shape was taken."),
    QT_TRANSLATE_NOOP("Core",
                      "The drawing leaves %1 measures open; the most regular shape was taken."),
    QT_TRANSLATE_NOOP("Core", "The solid falls into %1 separate pieces."),
    QT_TRANSLATE_NOOP("Core", "A hidden face was moved so that it meets nothing undrawn."),
    QT_TRANSLATE_NOOP("Core", "Hidden faces meet faces that were not drawn on."),
    QT_TRANSLATE_NOOP("Core", "It closes off a hollow inside the solid."),
    QT_TRANSLATE_NOOP("Core", "There is no solid yet."),
    QT_TRANSLATE_NOOP("Core", "No edge is chosen."),
    QT_TRANSLATE_NOOP("Core", "An edge that was chosen does not exist."),
    QT_TRANSLATE_NOOP("Core", "There is no edge at this place."),
    QT_TRANSLATE_NOOP("Core", "The solid has no concave edge."),
    QT_TRANSLATE_NOOP("Core", "The solid has no such edge."),
    QT_TRANSLATE_NOOP("Core", "None of these edges is filleted."),
    QT_TRANSLATE_NOOP("Core", "The radius of a fillet must be a number greater than 0 mm."),
    QT_TRANSLATE_NOOP("Core", "A fillet has from 1 to %1 segments across."),
    QT_TRANSLATE_NOOP("Core", "The sharpness of an edge must be from 0 (smooth) to 10 (sharp)."),
    QT_TRANSLATE_NOOP("Core", "The tolerance of the surface must be greater than 0 mm."),
    QT_TRANSLATE_NOOP("Core", "The surface has from 1 to %1 levels."),
    QT_TRANSLATE_NOOP("Core", "There is no solid to make a surface over yet."),
    QT_TRANSLATE_NOOP("Core",
                      "The surface would need about %1 MiB, more than the limit of %2 MiB. Choose "
                      "fewer levels or a coarser tolerance."),
    QT_TRANSLATE_NOOP("Core",
                      "The surface would need more memory than is allowed; choose fewer levels or "
                      "a larger tolerance."),
    QT_TRANSLATE_NOOP("Core", "The outline of face %1 crosses itself."),
    QT_TRANSLATE_NOOP("Core", "The outline of face %1 crosses or touches itself."),
    QT_TRANSLATE_NOOP("Core", "There is no surface under the strokes."),
    QT_TRANSLATE_NOOP("Core", "There is no stroke on the surface."),
    QT_TRANSLATE_NOOP("Core", "There is nothing to export yet."),
    QT_TRANSLATE_NOOP(
        "Core",
        "In the single precision of this format the shape would not be closed: parts "
        "are too thin for it, or too far from the origin. Use .obj or .ply, or change "
        "the shape."),
    QT_TRANSLATE_NOOP("Core",
                      "The extension %1 names no mesh format; use .obj, .stl, .ply, .glb or .3mf."),
    QT_TRANSLATE_NOOP("Core",
                      "A file name without an extension names no mesh format; use .obj, .stl, "
                      ".ply, .glb or .3mf."),
    QT_TRANSLATE_NOOP("Core", "The surface is too large for a glTF file of 4 GiB."),
    QT_TRANSLATE_NOOP("Core",
                      "Edge %1 (%2 long): %3 instead of %4, its own length leaves no more room"),
    QT_TRANSLATE_NOOP("Core", "Edge %1 (%2 long): %3 instead of %4, edge %5 leaves no more room"),
    QT_TRANSLATE_NOOP("Core", "Edge %1 (%2 long): %3 instead of %4, corner %5 leaves no more room"),
    QT_TRANSLATE_NOOP("Core", "Edge %1 (%2 long): %3 instead of %4"),
    QT_TRANSLATE_NOOP("Core",
                      "The file %1 was written by a later version of Edgewright, and what this one "
                      "does not know of it would be lost; save under another name."),
    QT_TRANSLATE_NOOP("Core", "The file %1 could not be written: %2."),
    QT_TRANSLATE_NOOP(
        "Core", "A document cannot be called %1: files that end in .json are sketch scripts."),
    QT_TRANSLATE_NOOP("Core", "%1 is no Edgewright document or sketch script: it holds %2."),
    QT_TRANSLATE_NOOP("Core", "%1 is larger than %2 MiB."),
    QT_TRANSLATE_NOOP("Core", "%1 is a folder, not a file."),
    QT_TRANSLATE_NOOP("Core", "The solid lies too far out to be written to a mesh file."),
    QT_TRANSLATE_NOOP("Core",
                      "The bodies lie too far apart for the single precision of STL; export them "
                      "as OBJ, 3MF or glTF."),
    QT_TRANSLATE_NOOP("Core", "It lies far out: in the file, the origin is at %1."),
    QT_TRANSLATE_NOOP("Core", "%1 is no file of this computer; only those can be opened."),
    QT_TRANSLATE_NOOP("Core", "There is no body number %1; the document has %2, counted from 0."),
    QT_TRANSLATE_NOOP("Core", "A name has at most %1 characters."),
    QT_TRANSLATE_NOOP("Core", "This step read no drawing."),
    QT_TRANSLATE_NOOP("Core", "A step can only become another step of its kind."),
    QT_TRANSLATE_NOOP("Core", "How this step was made is not known any more."),
    QT_TRANSLATE_NOOP("Core", "There is no such step in the history."),
    QT_TRANSLATE_NOOP("Core", "Move this corner"), QT_TRANSLATE_NOOP("Core", "Draw it straight"),
    QT_TRANSLATE_NOOP("Core", "Draw the missing line"),
    QT_TRANSLATE_NOOP("Core", "Drop these lines"), QT_TRANSLATE_NOOP("Core", "%1 out of place"),
    QT_TRANSLATE_NOOP("Core", "cannot be seen"), QT_TRANSLATE_NOOP("Core", "is no edge"),
    QT_TRANSLATE_NOOP("Core", "Join these ends"),
    QT_TRANSLATE_NOOP("Core", "Join the nearest ends"),
    QT_TRANSLATE_NOOP("Core", "Raise the threshold to %1"),
    QT_TRANSLATE_NOOP("Core", "Raise the angle threshold to %1 degrees"),
    QT_TRANSLATE_NOOP("Core", "Drop this line"),
    QT_TRANSLATE_NOOP("Core", "Keep the largest drawing"),
    QT_TRANSLATE_NOOP("Core", "Keep drawing %1"),
    QT_TRANSLATE_NOOP("Core", "Take it as %1 all the same"),
    QT_TRANSLATE_NOOP("Core", "Take it as %1"),
    QT_TRANSLATE_NOOP("Core", "Take the %1"), QT_TRANSLATE_NOOP("Core", "Take: %1"),
    QT_TRANSLATE_NOOP("Core", "is part of no face"), QT_TRANSLATE_NOOP("Core", "a dot"),
    QT_TRANSLATE_NOOP("Core", "a scribble"), QT_TRANSLATE_NOOP("Core", "a curve"),
    QT_TRANSLATE_NOOP("Core", "gap %1, threshold %2"),
    QT_TRANSLATE_NOOP("Core", "no right-angled corner looks like this"),
    QT_TRANSLATE_NOOP("Core", "lines cross"),
    QT_TRANSLATE_NOOP("Core", "%1 degrees off its parallels"),
    QT_TRANSLATE_NOOP("Core", "%1 lines meet here"),
    QT_TRANSLATE_NOOP("Core", "Parallel projection"),
    QT_TRANSLATE_NOOP("Core", "Nearest parallel projection"), QT_TRANSLATE_NOOP("Core", "Oblique"),
    QT_TRANSLATE_NOOP("Core", "Perspective"),
    QT_TRANSLATE_NOOP("Core", "Read in perspective: lines that run away come together."),
    QT_TRANSLATE_NOOP("Core", "Most regular"), QT_TRANSLATE_NOOP("Core", "Isosceles"),
    QT_TRANSLATE_NOOP("Core", "Right-angled"), QT_TRANSLATE_NOOP("Core", "Right-angled corner"),
    QT_TRANSLATE_NOOP("Core", "Cube"),
    QT_TRANSLATE_NOOP("Core", "A box: six rectangular faces, any proportions."),
    QT_TRANSLATE_NOOP("Core", "L-prism"),
    QT_TRANSLATE_NOOP("Core", "A right prism over an L with right angles only."),
    QT_TRANSLATE_NOOP("Core", "Triangular prism"),
    QT_TRANSLATE_NOOP("Core", "A right prism over any triangle."),
    QT_TRANSLATE_NOOP("Core", "Prism"), QT_TRANSLATE_NOOP("Core", "Pyramid"),
    QT_TRANSLATE_NOOP("Core", "Solid"), QT_TRANSLATE_NOOP("Core", "%1 solids"),
    QT_TRANSLATE_NOOP("Core", "Frustum"), QT_TRANSLATE_NOOP("Core", "Triangular pyramid"),
    QT_TRANSLATE_NOOP("Core", "Four triangles, any shape."),
    QT_TRANSLATE_NOOP("Core", "Wedge frustum"),
    QT_TRANSLATE_NOOP("Core", "A rectangular pyramid with its top cut off parallel to the base."),
    // Titles of the examples.
    QT_TRANSLATE_NOOP("Core", "A box, drawn by hand"),
    QT_TRANSLATE_NOOP("Core", "A clock, drawn by hand"),
    QT_TRANSLATE_NOOP("Core", "A computer mouse, drawn by hand"),
    QT_TRANSLATE_NOOP("Core", "A printer, drawn by hand"),
    QT_TRANSLATE_NOOP("Core", "A triangular prism, drawn by hand"),
    QT_TRANSLATE_NOOP("Core", "A triangular pyramid, drawn by hand"),
    QT_TRANSLATE_NOOP("Core", "A wedge frustum, drawn by hand"),
    QT_TRANSLATE_NOOP("Core", "An L-prism, drawn by hand")};

const QRegularExpression& place() {
    static const QRegularExpression kPlace(QStringLiteral("%(\\d)"));
    return kPlace;
}

/// What stands in the places of sentences only.
constexpr const char* kParts[] = {QT_TRANSLATE_NOOP("Core", "%1 or %2"),
                                  QT_TRANSLATE_NOOP("Core", "one place"),
                                  QT_TRANSLATE_NOOP("Core", "%1 places"),
                                  QT_TRANSLATE_NOOP("Core", "one corner"),
                                  QT_TRANSLATE_NOOP("Core", "%1 corners"),
                                  QT_TRANSLATE_NOOP("Core", "one edge"),
                                  QT_TRANSLATE_NOOP("Core", "%1 edges"),
                                  QT_TRANSLATE_NOOP("Core", "one line"),
                                  QT_TRANSLATE_NOOP("Core", "%1 lines"),
                                  QT_TRANSLATE_NOOP("Core", "adding %1"),
                                  QT_TRANSLATE_NOOP("Core", "cutting %1"),
                                  QT_TRANSLATE_NOOP("Core", "radius %1"),
                                  QT_TRANSLATE_NOOP("Core", "stays sharp"),
                                  QT_TRANSLATE_NOOP("Core", "a %1"),
                                  QT_TRANSLATE_NOOP("Core", "an %1"),
                                  QT_TRANSLATE_NOOP("Core", "there is no room left on the disk"),
                                  QT_TRANSLATE_NOOP("Core", "its folder does not exist"),
                                  QT_TRANSLATE_NOOP("Core", "it is a folder"),
                                  QT_TRANSLATE_NOOP("Core", "it may not be changed"),
                                  QT_TRANSLATE_NOOP("Core", "its name is too long"),
                                  QT_TRANSLATE_NOOP("Core", "nothing"),
                                  QT_TRANSLATE_NOOP("Core", "a picture"),
                                  QT_TRANSLATE_NOOP("Core", "a PDF document"),
                                  QT_TRANSLATE_NOOP("Core", "a ZIP package, as 3MF files are"),
                                  QT_TRANSLATE_NOOP("Core", "a database of another program"),
                                  QT_TRANSLATE_NOOP("Core", "a glTF mesh"),
                                  QT_TRANSLATE_NOOP("Core", "a PLY mesh"),
                                  QT_TRANSLATE_NOOP("Core", "an STL mesh"),
                                  QT_TRANSLATE_NOOP("Core", "an OBJ mesh"),
                                  QT_TRANSLATE_NOOP("Core", "a STEP model"),
                                  QT_TRANSLATE_NOOP("Core", "XML text, as SVG files are"),
                                  QT_TRANSLATE_NOOP("Core", "text of another kind"),
                                  QT_TRANSLATE_NOOP("Core", "data of another kind")};

/// What a person calls the shipped shapes in a sentence about what was done.
struct Noun {
    const char* name;
    const char* noun;
};
constexpr Noun kNouns[] = {{"Cube", QT_TRANSLATE_NOOP("Core", "a box")},
                           {"L-prism", QT_TRANSLATE_NOOP("Core", "an L-prism")},
                           {"Triangular prism", QT_TRANSLATE_NOOP("Core", "a prism")},
                           {"Triangular pyramid", QT_TRANSLATE_NOOP("Core", "a pyramid")},
                           {"Wedge frustum", QT_TRANSLATE_NOOP("Core", "a frustum")}};

struct Wording {
    const char* source;
    QRegularExpression pattern;
};

/// Those of several lists. A phrase without a place is one that was meant word for word: "an STL
/// mesh" is not "an %1". So these come first.
std::vector<Wording> wordings(std::initializer_list<std::span<const char* const>> lists) {
    std::vector<const char*> sources;
    for (const auto& list : lists) sources.insert(sources.end(), list.begin(), list.end());
    std::stable_partition(sources.begin(), sources.end(), [](const char* source) {
        return !place().match(QString::fromUtf8(source)).hasMatch();
    });
    std::vector<Wording> all;
    for (const char* source : sources) {
        // Its parts are in the order of their numbers.
        QStringList parts = QString::fromUtf8(source).split(place());
        for (QString& part : parts) part = QRegularExpression::escape(part);
        const QString pattern = parts.join(QStringLiteral("(.+?)"));
        all.push_back({source, QRegularExpression(QRegularExpression::anchoredPattern(pattern))});
    }
    return all;
}

/// The core writes numbers with a point.
QString localNumber(QString part) {
    static const QRegularExpression kNumber(QStringLiteral(R"(^\d+\.\d+( (mm|px))?$)"));
    if (kNumber.match(part).hasMatch()) part.replace('.', QLocale().decimalPoint());
    return part;
}

QString translated(const QString& english, bool isPart);

/// Empty where none of the wordings is meant.
QString translatedBy(const std::vector<Wording>& wordings, const QString& english) {
    for (const Wording& w : wordings) {
        const QRegularExpressionMatch match = w.pattern.match(english);
        if (!match.hasMatch()) continue;
        const QString wording = QCoreApplication::translate(kContext, w.source);
        // All places at once: what is put in may hold a percent sign of its own.
        QString text;
        qsizetype done = 0;
        auto places = place().globalMatch(wording);
        while (places.hasNext()) {
            const QRegularExpressionMatch at = places.next();
            text += wording.mid(done, at.capturedStart() - done);
            text += translated(match.captured(at.captured(1).toInt()), true);
            done = at.capturedEnd();
        }
        return text + wording.mid(done);
    }
    return {};
}

QString translated(const QString& english, bool isPart) {
    static const std::vector<Wording> kWholes =
        wordings({kSentences, kClassSentences, kFileSentences});
    static const std::vector<Wording> kPieces = wordings({kParts, kFileParts});
    QString text = translatedBy(kWholes, english);
    if (text.isEmpty() && isPart) text = translatedBy(kPieces, english);
    if (!text.isEmpty()) return text;
    return isPart ? localNumber(english) : english;
}

}  // namespace

QString solidText(const std::string& templateName) {
    for (const Noun& n : kNouns) {
        if (templateName == n.name) return QCoreApplication::translate(kContext, n.noun);
    }
    return translated(QString::fromStdString(withArticle(templateName)), true);
}

QString stepText(const std::string& word) {
    return QCoreApplication::translate("Step", word.c_str());
}

QString coreText(const std::string& english) {
    // Labels are painted with every frame.
    static QHash<QString, QString> known;
    static QString language;
    const QString now = QCoreApplication::translate(kContext, kSentences[0]);
    constexpr int kMostKnown = 1000;
    if (language != now || known.size() > kMostKnown) known.clear();
    language = now;
    const QString text = QString::fromStdString(english);
    const auto found = known.constFind(text);
    const QString said =
        found != known.cend() ? *found : *known.insert(text, translated(text, false));
    return said == text ? ownTemplateText(text) : said;
}

}  // namespace ew
