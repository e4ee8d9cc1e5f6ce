// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that follow the wavelength, and the choices that set parameters by them.
#include "catalog/spectrum.h"

#include <cmath>

#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "catalog/fills.h"
#include "catalog/wavelengths.h"
#include "scene/scene.h"
#include "shading/effects/spectral_range.h"

namespace patina::spectrum_test {
namespace {

using Json = nlohmann::json;

Parameter indexOfColors() {
    Parameter parameter;
    parameter.id = "eta";
    parameter.type = ParameterType::Vec3;
    parameter.max = 100.0;
    return parameter;
}

NumberList spectrumOf(const Json& json) {
    const ValueReading value = fillFromJson(indexOfColors(), json);
    const NumberList* spectrum = value ? spectrumIn(*value) : nullptr;
    EXPECT_NE(spectrum, nullptr) << (value ? "" : value.error().text());
    return spectrum == nullptr ? NumberList{{}, {1.0, 0.0, 2.0, 0.0}} : *spectrum;
}

std::string mistakeOf(const Json& json) {
    const ValueReading value = fillFromJson(indexOfColors(), json);
    return value ? "" : value.error().within + ": " + value.error().problem;
}

const Json falling{{"nm", {400.0, 500.0, 700.0}}, {"values", {3.0, 2.0, 1.0}}};

TEST(Spectrum, BetweenItsWavelengths_IsLinear) {
    const NumberList spectrum = spectrumOf(falling);
    EXPECT_EQ(atWavelengths(spectrum, {400.0, 500.0, 700.0}), glm::dvec3(3.0, 2.0, 1.0));
    EXPECT_EQ(atWavelengths(spectrum, {450.0, 550.0, 600.0}), glm::dvec3(2.5, 1.75, 1.5));
}

TEST(Spectrum, BeyondItsWavelengths_StaysAsItIsThere) {
    const NumberList spectrum = spectrumOf(falling);
    EXPECT_EQ(atWavelengths(spectrum, {399.0, 701.0, 0.0}), glm::dvec3(3.0, 1.0, 3.0));
    EXPECT_EQ(atWavelengths(spectrum, {-INFINITY, INFINITY, NAN}), glm::dvec3(3.0, 1.0, 3.0));
    EXPECT_EQ(rangeOf(spectrum), std::pair(400.0, 700.0));
}

TEST(Spectrum, Written_ReadsBack) {
    const NumberList spectrum = spectrumOf(falling);
    EXPECT_EQ(fillJson(spectrum), falling);
    EXPECT_EQ(fillJson(glm::dvec3(1.0, 2.0, 3.0)), Json({1.0, 2.0, 3.0}));
}

TEST(Spectrum, ThatIsNone_SaysWhatIsWrong) {
    EXPECT_EQ(mistakeOf({{"nm", {400.0, 500.0}}}), ": this is no spectrum");
    EXPECT_EQ(mistakeOf({{"nm", {400.0, "red"}}, {"values", {1.0, 2.0}}}), ": this is no spectrum");
    EXPECT_EQ(mistakeOf({{"nm", {400.0}}, {"values", {1.0}}}),
              "/values: 1 wavelengths have 1 numbers");
    EXPECT_EQ(mistakeOf({{"nm", {400.0, 500.0}}, {"values", {1.0}}}),
              "/values: 2 wavelengths have 1 numbers");
    EXPECT_EQ(mistakeOf({{"nm", {500.0, 500.0}}, {"values", {1.0, 2.0}}}),
              "/nm/1: the wavelengths do not rise");
    EXPECT_EQ(mistakeOf({{"nm", {0.0, 500.0}}, {"values", {1.0, 2.0}}}),
              "/nm/0: the wavelengths do not rise");
    EXPECT_EQ(mistakeOf({{"nm", {400.0, 500.0}}, {"values", {1.0, 101.0}}}),
              "/values/1: the value is outside the range of 'eta'");
}

/// Is the shipped block whose metals go by spectra.
class NamedMetal : public testing::Test {
  protected:
    NamedMetal()
        : catalog_(loadCatalog(
              std::vector{BlockRoot{std::filesystem::path(PATINA_SOURCE_DIR) / "shaders", true}})),
          block_(*catalog_.find("fresnel", "metal")), metal_(*block_.parameter("metal")) {}

    Values chosen(const char* id) const {
        return afterEdit(block_, defaultValues(block_), metal_, std::string(id));
    }

    Catalog catalog_;
    const Block& block_;
    const Parameter& metal_;
};

TEST_F(NamedMetal, Chosen_SetsTheNumbersOfSrgbsWavelengths) {
    const Values silver = chosen("silver");
    const NumberList& k = *spectrumIn(spectralChoice(metal_, silver)->fills.at("k"));
    EXPECT_EQ(silver.at("k"), roundedToFloat(atWavelengths(k, srgbWavelengths)));
    Values settled = defaultValues(block_);
    settled.merge(Values(silver));
    for (const auto& [id, value] : silver) {
        settled[id] = value;
    }
    settleShorthands(block_, settled);
    EXPECT_EQ(settled.at("metal"), Value(std::string("silver")));
}

TEST_F(NamedMetal, WithATypedNumber_IsOnesOwn) {
    const Values typed =
        afterEdit(block_, chosen("copper"), *block_.parameter("eta"), glm::dvec3(1.0));
    EXPECT_EQ(typed.at("metal"), Value(std::string("custom")));
    EXPECT_EQ(spectralChoice(metal_, typed), nullptr);
}

TEST_F(NamedMetal, ByNameAloneInAFile_HasItsNumbers) {
    Values given{{"metal", std::string("nickel")}};
    fillGaps(block_, given);
    EXPECT_EQ(roundedToFloat(given.at("eta")), chosen("nickel").at("eta"));
}

TEST_F(NamedMetal, EveryOne_NamesItsSourceAndIsKnownWhereLightIsSeen) {
    int named = 0;
    for (const EnumValue& choice : metal_.values) {
        for (const auto& [id, fill] : choice.fills) {
            const auto [from, to] = rangeOf(*spectrumIn(fill));
            EXPECT_LE(from, 380.0) << choice.id;
            EXPECT_GE(to, 780.0) << choice.id;
            ++named;
        }
        EXPECT_TRUE(choice.fills.empty() || choice.doc.find(", 19") != std::string::npos);
    }
    EXPECT_EQ(named, 2 * 13);
}

TEST_F(NamedMetal, AtAWavelengthThatNobodyMeasured_SaysSo) {
    Scene scene;
    EXPECT_EQ(spectralRangeNote(block_, chosen("gold"), scene), "");
    scene.wavelengths.x = 1500.0;
    EXPECT_EQ(spectralRangeNote(block_, chosen("gold"), scene),
              " Gold is known from 301 to 1088 nm: 1500 nm counts as the nearest.");
    EXPECT_EQ(spectralRangeNote(block_, chosen("custom"), scene), "");
}

} // namespace
} // namespace patina::spectrum_test
