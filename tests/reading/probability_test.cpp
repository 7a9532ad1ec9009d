// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/score/probability.h"

#include <gtest/gtest.h>

namespace ew {
namespace {

Candidate candidate(const std::string& id, double fit, double prior = 0.0) {
    Candidate c;
    c.templateId = id;
    c.evidence.fit = fit;
    c.evidence.prior = prior;
    return c;
}

double sum(const std::vector<Candidate>& candidates) {
    double out = 0.0;
    for (const Candidate& c : candidates) out += c.probability;
    return out;
}

TEST(Probability, GrowsWithTheDistanceOfTheNextResultAndFallsWithTheMisfit) {
    double last = 0.0;
    for (const double margin : {0.0, 2.0, 8.0, 25.0}) {
        std::vector<Candidate> two{candidate("a", 4.0), candidate("b", 4.0 + margin)};
        tellProbabilities(two, 9);
        EXPECT_GT(two[0].probability, last) << margin;
        EXPECT_GE(two[0].probability, two[1].probability);
        EXPECT_LE(sum(two), 1.0);
        last = two[0].probability;
    }
    last = 1.0;
    for (const double fit : {0.0, 10.0, 60.0}) {
        std::vector<Candidate> one{candidate("a", fit)};
        tellProbabilities(one, 9);
        EXPECT_LT(one[0].probability, last) << fit;
        last = one[0].probability;
    }
}

TEST(Probability, AnotherSolutionOfTheSameResultIsNoRival) {
    std::vector<Candidate> alone{candidate("a", 4.0)};
    std::vector<Candidate> twins{candidate("a", 4.0), candidate("a", 4.5)};
    tellProbabilities(alone, 9);
    tellProbabilities(twins, 9);
    EXPECT_EQ(twins[0].probability, alone[0].probability);
    EXPECT_LE(sum(twins), 1.0);
}

TEST(Probability, WhatIsNoCandidateMayBeARival) {
    std::vector<Candidate> free{candidate("a", 4.0)};
    std::vector<Candidate> doubtful{candidate("a", 4.0)};
    tellProbabilities(free, 9);
    tellProbabilities(doubtful, 9, 5.0);
    EXPECT_LT(doubtful[0].probability, free[0].probability);
}

TEST(Probability, OfAQuestionIsLessForTheFirstAndMoreForTheOthers) {
    std::vector<Candidate> taken{candidate("a", 4.0), candidate("b", 6.0), candidate("c", 9.0)};
    tellProbabilities(taken, 9);
    std::vector<Candidate> asked = taken;
    tellProbabilitiesOfQuestion(asked);
    EXPECT_LT(asked[0].probability, 0.5);
    EXPECT_GT(asked[1].probability, taken[1].probability);
    EXPECT_GT(asked[1].probability, asked[2].probability);
    EXPECT_LE(sum(asked), 1.0 + 1e-12);
    std::vector<Candidate> none;
    tellProbabilitiesOfQuestion(none);
    tellProbabilities(none, 0);
    EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace ew
