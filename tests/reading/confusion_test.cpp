// SPDX-License-Identifier: GPL-3.0-or-later
// Random drawings of a template, and which template they are taken for.
#include "core/reading/confusion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/reading/solve/general_fit.h"
#include "core/reading/template_drawing.h"
#include "core/solid/solid.h"
#include "tests/reading/reading_fixture.h"

namespace ew {
namespace {

TEST(TemplateDrawing, ObeysTheTemplateAndCanBeSeen) {
    for (const auto& entry : test::shippedLibrary().index().entries) {
        for (std::uint64_t n = 0; n < 5; ++n) {
            Random random(Random::mix(3, n));
            const auto drawn = randomDrawing(*entry, random);
            ASSERT_TRUE(drawn) << entry->tmpl.id << " " << n;
            EXPECT_TRUE(Solid::fromSpec(drawn->spec));
            EXPECT_LT(
                violation(solverRelations(entry->analysis), entry->analysis, drawn->spec.vertices),
                1e-6)
                << entry->tmpl.id;
            EXPECT_GE(drawn->lines.size(), 5U);
            for (const Line2& l : drawn->lines) EXPECT_GE((l[1] - l[0]).norm(), 18.0);
        }
    }
}

TEST(TemplateDrawing, IsTheSameForTheSameSeed) {
    const auto cube = test::entryOf("cube");
    Random a(5);
    Random b(5);
    const auto first = randomDrawing(*cube, a);
    const auto second = randomDrawing(*cube, b);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->lines, second->lines);
}

TEST(Confusion, ExactDrawingsAreTakenForWhatTheyAre) {
    ConfusionOptions options;
    options.drawings = 6;
    options.hand = kExactHand;
    std::vector<double> told;
    options.progress = [&](double share) {
        told.push_back(share);
        return true;
    };
    const auto rows = confusion(test::shippedLibrary(), {"cube", "triangular-prism"}, options);
    ASSERT_EQ(rows.size(), 2U);
    for (const ConfusionRow& row : rows) {
        EXPECT_EQ(row.drawings, 6) << row.templateId;
        EXPECT_EQ(row.wrong(), 0) << row.templateId;
        EXPECT_GE(row.right() + row.asked, 6) << row.templateId;
    }
    ASSERT_EQ(told.size(), 12U);
    EXPECT_DOUBLE_EQ(*std::max_element(told.begin(), told.end()), 1.0);
}

TEST(Confusion, DoesNotDependOnThreadsAndCanBeStopped) {
    ConfusionOptions options;
    options.drawings = 4;
    options.threads = 1;
    const auto one = confusion(test::shippedLibrary(), {"wedge-frustum"}, options);
    options.threads = 3;
    const auto three = confusion(test::shippedLibrary(), {"wedge-frustum"}, options);
    EXPECT_EQ(one[0].readAs, three[0].readAs);
    EXPECT_EQ(one[0].asked, three[0].asked);
    options.progress = [](double) { return false; };
    options.threads = 1;
    EXPECT_LE(confusion(test::shippedLibrary(), {"cube"}, options)[0].drawings, 1);
    EXPECT_EQ(confusion(test::shippedLibrary(), {"nothing"}, {})[0].drawings, 0);
}

}  // namespace
}  // namespace ew
