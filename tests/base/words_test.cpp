// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"

#include <gtest/gtest.h>

namespace ew::test {
namespace {

TEST(WithArticle, FollowsTheSoundOfANamesBeginning) {
    for (const char* name :
         {"Cube", "Triangular prism", "Wedge frustum", "Pyramid", "Hat stand", "T-slot",
          "U-profile", "Unicorn", "One-sided ramp", "7-gon", "house"}) {
        EXPECT_EQ(withArticle(name), std::string("a ") + name);
    }
    for (const char* name : {"L-prism", "Octagon", "ellipsoid", "H-beam", "I-beam", "X",
                             "Hourglass", "8-gon", "Unequal wedge"}) {
        EXPECT_EQ(withArticle(name), std::string("an ") + name);
    }
    EXPECT_EQ(withArticle(""), "a ");
    EXPECT_EQ(withArticle("2 solids"), "2 solids");
}

}  // namespace
}  // namespace ew::test
