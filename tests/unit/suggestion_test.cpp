// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/suggestion.h"

#include <vector>

#include <gtest/gtest.h>

namespace patina::suggestion_test {
namespace {

const std::vector<std::string> words{"label", "default", "min", "max"};

TEST(Nearest, ExchangedLetters_AreUnderstood) {
    EXPECT_EQ(nearest("lable", words), "label");
}
TEST(Nearest, MissingLetter_IsUnderstood) {
    EXPECT_EQ(nearest("defalt", words), "default");
}
TEST(Nearest, SomethingElse_IsNotGuessed) {
    EXPECT_EQ(nearest("colour", words), "");
}
TEST(Nearest, EmptyWord_IsNotGuessed) {
    EXPECT_EQ(nearest("", words), "");
}
TEST(Nearest, VeryLongWord_IsNotGuessed) {
    EXPECT_EQ(nearest(std::string(1'000'000, 'x'), words), "");
}
TEST(OneOf, NearWord_ComesFirst) {
    EXPECT_EQ(oneOf("lable", words), "'label', or one of label, default, min, max");
}
TEST(OneOf, NoCandidates_AreSaidToBeNone) {
    EXPECT_EQ(oneOf("x", {}), "nothing here");
}

} // namespace
} // namespace patina::suggestion_test
