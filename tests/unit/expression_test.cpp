// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/expression.h"

#include <gtest/gtest.h>

namespace patina::expression_test {
namespace {

const Values values{{"on", true},
                    {"off", false},
                    {"count", 3},
                    {"roughness.x", 0.5},
                    {"lobe", std::string("wide-tail")},
                    {"scale", std::string("1982")}};

bool isTrue(std::string_view text) {
    const auto expression = Expression::parse(text);
    EXPECT_TRUE(expression) << text << ": " << expression.error().text();
    return expression && expression->evaluate(values);
}

std::string mistake(std::string_view text) {
    const auto expression = Expression::parse(text);
    return expression ? "" : expression.error().text();
}

TEST(Expression, Empty_IsTrue) {
    EXPECT_TRUE(isTrue(""));
}
TEST(Expression, Blanks_AreTrue) {
    EXPECT_TRUE(isTrue("  "));
}
TEST(Expression, BoolThatIsOn_IsTrue) {
    EXPECT_TRUE(isTrue("on"));
}
TEST(Expression, BoolThatIsOff_IsFalse) {
    EXPECT_FALSE(isTrue("off"));
}
TEST(Expression, BoolComparedWithAWord_IsCompared) {
    EXPECT_TRUE(isTrue("off == false"));
}
TEST(Expression, NumberAlone_IsTrueUnlessZero) {
    EXPECT_TRUE(isTrue("count"));
}
TEST(Expression, Less_ComparesNumbers) {
    EXPECT_TRUE(isTrue("roughness.x < 0.6"));
}
TEST(Expression, LessEqual_HoldsAtTheNumber) {
    EXPECT_TRUE(isTrue("roughness.x <= 0.5"));
}
TEST(Expression, Greater_FailsAtTheNumber) {
    EXPECT_FALSE(isTrue("roughness.x > 0.5"));
}
TEST(Expression, GreaterEqual_HoldsAtTheNumber) {
    EXPECT_TRUE(isTrue("count >= 3"));
}
TEST(Expression, NumberWithAnExponent_IsRead) {
    EXPECT_TRUE(isTrue("roughness.x == 5e-1"));
}
TEST(Expression, NegativeNumber_IsRead) {
    EXPECT_TRUE(isTrue("count > -1"));
}
TEST(Expression, BareChoice_IsCompared) {
    EXPECT_TRUE(isTrue("lobe == wide-tail"));
}
TEST(Expression, QuotedChoice_IsCompared) {
    EXPECT_TRUE(isTrue("lobe == \"wide-tail\""));
}
TEST(Expression, OtherChoice_IsUnequal) {
    EXPECT_TRUE(isTrue("lobe != 'narrow'"));
}
TEST(Expression, ChoiceThatLooksLikeANumber_IsCompared) {
    EXPECT_TRUE(isTrue("scale == 1982"));
}
TEST(Expression, ChoiceOrderedByLess_IsFalse) {
    EXPECT_FALSE(isTrue("lobe < 3"));
}
TEST(Expression, ParameterAgainstParameter_IsCompared) {
    EXPECT_TRUE(isTrue("roughness.x < count"));
}
TEST(Expression, Not_BindsCloserThanAnd) {
    EXPECT_FALSE(isTrue("not off and off"));
}
TEST(Expression, And_BindsCloserThanOr) {
    EXPECT_TRUE(isTrue("on or off and off"));
}
TEST(Expression, Parentheses_BindFirst) {
    EXPECT_FALSE(isTrue("(on or off) and off"));
}
TEST(Expression, NotTwice_IsNothing) {
    EXPECT_TRUE(isTrue("not not on"));
}
TEST(Expression, MissingValue_IsAWord) {
    EXPECT_FALSE(isTrue("missing == 3"));
}

TEST(Expression, MissingOperand_IsAnErrorAtTheEnd) {
    EXPECT_EQ(mistake("count >"),
              "1:8: the expression ends here; expected a parameter, a number or a choice");
}
TEST(Expression, MissingParenthesis_IsAnError) {
    EXPECT_EQ(mistake("(count"), "1:7: the expression ends here; expected ')', 'and' or 'or'");
}
TEST(Expression, TwoOperands_AreAnError) {
    EXPECT_EQ(mistake("count 3"), "1:7: '3' stands here; expected 'and', 'or' or the end");
}
TEST(Expression, UnknownSign_IsAnError) {
    EXPECT_EQ(mistake("count & 3"), "1:7: '&' stands here; expected 'and', 'or' or the end");
}
TEST(Expression, SingleEquals_IsAnError) {
    EXPECT_NE(mistake("count = 3"), "");
}
TEST(Expression, LoneQuote_IsAnError) {
    EXPECT_NE(mistake("lobe == 'wide"), "");
}
TEST(Expression, EmptyQuotes_AreAnEmptyWord) {
    EXPECT_TRUE(isTrue("lobe != ''"));
}
TEST(Expression, VeryDeep_IsAnError) {
    EXPECT_NE(mistake(std::string(100'000, '(')), "");
}

TEST(Expression, Comparisons_NameBothSides) {
    const auto comparisons = Expression::parse("not (a == b) or c")->comparisons();
    ASSERT_EQ(comparisons.size(), 2u);
    EXPECT_EQ(comparisons[0].left + comparisons[0].right + comparisons[1].left, "abc");
}

} // namespace
} // namespace patina::expression_test
