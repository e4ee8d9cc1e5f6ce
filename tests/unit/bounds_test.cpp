// SPDX-License-Identifier: GPL-3.0-or-later
// What a descriptor says of how far its fog or light works.
#include <gtest/gtest.h>

#include "catalog_fixture.h"

namespace patina {
namespace {

/// What is wrong with a plain descriptor that has one more key.
std::string mistakesWith(const std::string& key, const nlohmann::json& value) {
    tests::BlockFolder folder;
    nlohmann::json descriptor = tests::plainDescriptor("a");
    descriptor[key] = value;
    folder.add("models", descriptor);
    return text(folder.load().errors);
}

TEST(DescriptorBounds, HidingByNothing_IsAMistake) {
    EXPECT_NE(mistakesWith("hides", {{"power", 2.0}}).find("either \"rate\", or \"from\""),
              std::string::npos);
}

TEST(DescriptorBounds, ReachFromANumber_IsAMistake) {
    const auto number = tests::plainDescriptor("a")["parameters"][0]["id"];
    EXPECT_NE(mistakesWith("reach", {{"from", number}}).find("not the parameter that is needed"),
              std::string::npos);
}

TEST(DescriptorBounds, RateWithABaseAlone_IsAMistake) {
    const auto number = tests::plainDescriptor("a")["parameters"][0]["id"];
    EXPECT_NE(mistakesWith("hides", {{"rate", number}, {"base", number}}).find("a thickness"),
              std::string::npos);
}

TEST(DescriptorBounds, NeutralByWhatIsNotThere_IsAMistake) {
    const nlohmann::json nothing{{"no/thing~", 0}};
    EXPECT_NE(mistakesWith("neutral", nlohmann::json::array({nothing}))
                  .find("\"no/thing~\" is not a parameter of the block"),
              std::string::npos);
}

TEST(DescriptorBounds, NeutralAtOne_IsAMistake) {
    const std::string number = tests::plainDescriptor("a")["parameters"][0]["id"];
    nlohmann::json neutral;
    neutral[number] = 1;
    EXPECT_NE(mistakesWith("neutral", nlohmann::json::array({neutral}))
                  .find("this does not say when the block does nothing"),
              std::string::npos);
}

} // namespace
} // namespace patina
