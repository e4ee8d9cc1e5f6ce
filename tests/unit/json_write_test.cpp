// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/json_text.h"

#include <cstdint>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

namespace patina::json_write_test {
namespace {

using nlohmann::json;

std::string reread(const std::string& text) {
    return writeJson(parseJson(text, "f").value().value);
}

TEST(WriteJson, Object_HasSortedKeysTwoSpacesAndANewline) {
    EXPECT_EQ(writeJson({{"b", 1}, {"a", "x"}}), "{\n  \"a\": \"x\",\n  \"b\": 1\n}\n");
}

TEST(WriteJson, Numbers_StandOnOneLine) {
    EXPECT_EQ(writeJson({{"c", {0.1, 2.0, 3}}}), "{\n  \"c\": [0.1, 2.0, 3]\n}\n");
}

TEST(WriteJson, EmptyContainers_StandOnOneLine) {
    EXPECT_EQ(writeJson({{"a", json::array()}, {"o", json::object()}}),
              "{\n  \"a\": [],\n  \"o\": {}\n}\n");
}

TEST(WriteJson, ArrayOfObjects_HasOneElementPerPlace) {
    EXPECT_EQ(writeJson(json::array({{{"a", 1}}, {{"b", 2}}})),
              "[\n  {\n    \"a\": 1\n  },\n  {\n    \"b\": 2\n  }\n]\n");
}

TEST(WriteJson, LongTexts_StandOnLinesOfTheirOwn) {
    const std::string word(60, 'x');
    EXPECT_EQ(writeJson({word, word}), "[\n  \"" + word + "\",\n  \"" + word + "\"\n]\n");
}

TEST(WriteJson, Float_IsTheShortestTextOfTheSameFloat) {
    EXPECT_EQ(writeJson(static_cast<double>(0.1f)), "0.1\n");
}

TEST(WriteJson, DoubleThatIsNoFloat_KeepsItsDigits) {
    EXPECT_EQ(reread("0.12345678901234567"), "0.12345678901234566\n");
}

TEST(WriteJson, WholeFloat_StaysAFloat) {
    EXPECT_EQ(writeJson(1.0), "1.0\n");
}

TEST(WriteJson, LargeFloat_HasAnExponent) {
    EXPECT_EQ(writeJson(1e20), "1e+20\n");
}

TEST(WriteJson, LargeInteger_KeepsItsDigits) {
    EXPECT_EQ(reread("18446744073709551615"), "18446744073709551615\n");
}

TEST(WriteJson, Text_IsEscaped) {
    EXPECT_EQ(writeJson("\"\n\x01"), "\"\\\"\\n\\u0001\"\n");
}

TEST(WriteJson, AnyFloat_ReadsBackAsTheSame) {
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        const std::uint32_t bits = random();
        float value = 0.0f;
        std::memcpy(&value, &bits, sizeof value);
        if (std::isfinite(value)) {
            const std::string text = writeJson(static_cast<double>(value));
            ASSERT_EQ(static_cast<float>(parseJson(text, "f")->value.get<double>()), value);
        }
    }
}

TEST(WriteJson, AnyDouble_ReadsBackAsTheSame) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20'000; ++i) {
        const std::uint64_t bits = random();
        double value = 0.0;
        std::memcpy(&value, &bits, sizeof value);
        const bool isFloat = static_cast<double>(static_cast<float>(value)) == value;
        if (std::isfinite(value) && !isFloat) {
            ASSERT_EQ(parseJson(writeJson(value), "f")->value.get<double>(), value);
        }
    }
}

TEST(WriteJson, Written_IsWrittenTheSameAgain) {
    const std::string text =
        writeJson({{"a", {{"b", {1, 2.5}}}}, {"c", {"x", nullptr, true}}, {"d", json::object()}});
    EXPECT_EQ(reread(text), text);
}

} // namespace
} // namespace patina::json_write_test
