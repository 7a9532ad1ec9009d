// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/template_variations.h"

#include <gtest/gtest.h>

#include "core/tlib/template_io.h"
#include "tests/support/random_shapes.h"
#include "tests/support/visible_edges.h"

namespace ew::test {
namespace {

TEST(TemplateVariations, CuttingACornerTakesItsTetrahedronAway) {
    const PolyhedronSpec cut = cutCorner(boxSpec(1, 1, 1), 6, 0.5);
    EXPECT_EQ(cut.vertices.size(), 10U);
    EXPECT_EQ(cut.faces.size(), 7U);
    EXPECT_EQ(specEdges(cut).size(), 15U);
    EXPECT_NEAR(specVolume(cut), 1.0 - 1.0 / 48.0, 1e-15);
}

TEST(TemplateVariations, AreValidTemplates) {
    Random random(1);
    for (const Template& t : templateVariations(300, random)) {
        const auto ok = checkTemplate(t, t.id);
        EXPECT_TRUE(ok) << ok.error().message;
    }
}

}  // namespace
}  // namespace ew::test
