// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace ew {

/// Every colour of the program, in one place. Text colours keep at least 4.5 : 1 against the
/// backgrounds they are used on (a test computes it), marks in the viewport at least 3 : 1.
struct ThemeColours {
    bool dark = false;

    // Widgets
    QColor window;   ///< docks, bars
    QColor surface;  ///< lists, cards, drawings inside panels
    QColor raised;   ///< buttons, hovered cards
    QColor border;   ///< hairlines
    QColor text;
    QColor mutedText;   ///< secondary text
    QColor accent;      ///< selection, focus, the reading
    QColor accentText;  ///< text on accent
    QColor warning;     ///< culprits, and text that speaks of them
    QColor ok;          ///< what is clear enough to be applied

    // Viewport
    QColor background;
    QColor grid;
    QColor axis;  ///< the two grid lines through the origin
    QColor ink;
    QColor dropped;    ///< ink that the reading does not use
    QColor read;       ///< recognised edges and junctions
    QColor extracted;  ///< edges of the model that the reading takes in
    QColor ghost;      ///< preview of the candidate
    QColor added;      ///< preview of what is added to a solid
    QColor removed;    ///< preview of what is cut out of it
    QColor body;
    QColor bodyEdge;
    QColor hiddenEdge;
    QColor hover;  ///< ring round the pen tip
};

const ThemeColours& lightColours();
const ThemeColours& darkColours();

/// Contrast of two opaque colours as WCAG 2.1 defines it, 1..21.
double contrastRatio(const QColor& a, const QColor& b);

/// Is a background so dark that what is on it has to be light?
bool isDark(const QColor& background);

/// a and b mixed; t = 0 gives a, 1 gives b.
QColor mixColours(const QColor& a, const QColor& b, double t);

/// A colour for lines on bodies as the theme shows it: on the dark theme's dark bodies, lightened
/// as far as needed to be seen; a colour that is seen well stays as it is.
QColor onBody(const QColor& colour, const ThemeColours& colours);

/// Distances of the layout [logical px].
namespace metrics {
inline constexpr int kGap = 4;             ///< between things that belong together
inline constexpr int kSpace = 8;           ///< between groups
inline constexpr int kMargin = 12;         ///< round the content of a panel
inline constexpr int kRadius = 6;          ///< corners of cards
inline constexpr int kIcon = 20;           ///< tool bar icons
inline constexpr int kMessageHeight = 52;  ///< fixed, so that a sentence never moves the drawing
}  // namespace metrics

}  // namespace ew
