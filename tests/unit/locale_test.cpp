// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in files have a point, whatever the system's or the program's locale says.
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <locale>
#include <sstream>

#include <gtest/gtest.h>

#include "catalog/json_text.h"
#include "core/number_text.h"

namespace patina::locale_test {
namespace {

/// Decimal commas and grouped thousands, as in Germany.
struct GermanNumbers : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

/// Puts the C library and the C++ library under a decimal comma for one test.
class DecimalComma : public testing::Test {
  protected:
    void SetUp() override {
        setenv("LOCPATH", PATINA_BINARY_DIR "/locale", 1);
        ASSERT_NE(std::setlocale(LC_ALL, "de_DE.UTF-8"), nullptr);
        before_ = std::locale::global(std::locale(std::locale::classic(), new GermanNumbers));
        std::setlocale(LC_ALL, "de_DE.UTF-8"); // std::locale::global may have set it back
    }
    void TearDown() override {
        std::locale::global(before_);
        std::setlocale(LC_ALL, "C");
    }

  private:
    std::locale before_;
};

TEST_F(DecimalComma, OfTheTests_IsInForceInC) {
    char text[16];
    std::snprintf(text, sizeof text, "%.1f", 1.5);
    EXPECT_STREQ(text, "1,5");
}

TEST_F(DecimalComma, OfTheTests_IsInForceInCpp) {
    std::ostringstream text;
    text << 1234.5;
    EXPECT_EQ(text.str(), "1.234,5");
}

TEST_F(DecimalComma, ParseJson_ReadsAPoint) {
    EXPECT_EQ(parseJson("0.25", "f").value().value.get<double>(), 0.25);
}

TEST_F(DecimalComma, ParseJson_RefusesAComma) {
    EXPECT_FALSE(parseJson("0,25", "f"));
}

TEST_F(DecimalComma, WriteJson_WritesAPoint) {
    EXPECT_EQ(writeJson(1234.5), "1234.5\n");
}

TEST_F(DecimalComma, WriteJson_WritesWholeNumbersUngrouped) {
    EXPECT_EQ(writeJson(1234567), "1234567\n");
}

TEST_F(DecimalComma, ShortestText_HasAPoint) {
    EXPECT_EQ(shortestText(0.1f), "0.1");
}

TEST_F(DecimalComma, FullText_HasAPoint) {
    EXPECT_EQ(fullText(0.5), "0.5");
}

TEST_F(DecimalComma, ParseNumber_WantsAPoint) {
    EXPECT_EQ(parseNumber("0.5"), 0.5);
    EXPECT_EQ(parseNumber("0,5"), std::nullopt);
}

TEST_F(DecimalComma, PlaceInAMessage_IsUngrouped) {
    const auto document = parseJson(std::string(1500, '\n').append("x"), "f");
    EXPECT_EQ(document.error().text().substr(0, 7), "f:1501:");
}

} // namespace
} // namespace patina::locale_test
