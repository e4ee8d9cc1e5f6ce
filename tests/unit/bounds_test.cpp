// SPDX-License-Identifier: GPL-3.0-or-later
// What a descriptor says of how far its fog or light works.
#include <regex>

#include <gtest/gtest.h>

#include "catalog_fixture.h"

namespace patina::bounds_test {
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

/// What is wrong with a descriptor of two numbers, a choice of two values and one of a single value
/// for the cases in which it does nothing.
std::string neutralMistakes(const char* cases) {
    tests::BlockFolder folder;
    nlohmann::json descriptor = tests::plainDescriptor("a");
    const nlohmann::json number = descriptor["parameters"][0];
    for (const char* id : {"one", "other", "never"}) {
        descriptor["parameters"].push_back(number);
        descriptor["parameters"].back()["id"] = id;
        descriptor["parameters"].back()["default"] = 0;
    }
    descriptor["parameters"].back().merge_patch({{"min", -1}, {"max", 0}});
    descriptor["parameters"].push_back(nlohmann::json::parse(R"({"id": "way", "label": "Way",
        "type": "enum", "default": "a", "doc": "d",
        "values": [{"id": "a", "label": "A"}, {"id": "b", "label": "B"}]})"));
    descriptor["neutral"] = nlohmann::json::parse(cases);
    folder.add("models", descriptor);
    return text(folder.load().errors);
}

TEST(DescriptorBounds, NeutralCasesThatDiffer_AreNoMistake) {
    EXPECT_EQ(neutralMistakes(R"([{"one": 0, "way": "a"}, {"one": "other"}, {"way": "b"}])"), "");
}

/// Each of them would leave the block out for ever.
TEST(DescriptorBounds, NeutralThatAlwaysHolds_IsAMistakeAtItsPlace) {
    for (const char* cases : {R"([{"one": "one"}])", R"([{"never": 0}])",
                              R"([{"one": 0}, {"other": 0, "one": "one"}])",
                              R"([{"way": "a"}, {"way": "b"}])"}) {
        const std::string mistakes = neutralMistakes(cases);
        EXPECT_NE(mistakes.find("the block would never be there"), std::string::npos)
            << cases << mistakes;
        EXPECT_TRUE(std::regex_search(mistakes, std::regex(R"(a\.json:\d+:\d+: )"))) << mistakes;
    }
}

TEST(DescriptorBounds, NeutralInNoCase_IsAMistake) {
    EXPECT_NE(neutralMistakes("[]").find("this names no case"), std::string::npos);
}

TEST(DescriptorBounds, NeutralCaseForWhichAnotherIsEnough_IsAMistake) {
    for (const char* cases :
         {R"([{"one": 0}, {"one": 0}])", R"([{"one": "other"}, {"other": "one"}])",
          R"([{"other": 0}, {"one": 0, "other": 0}])"}) {
        EXPECT_NE(neutralMistakes(cases).find("case 1 is enough"), std::string::npos) << cases;
    }
    EXPECT_NE(neutralMistakes(R"([{"one": 0, "other": 0}, {"other": 0}])").find("case 2 is enough"),
              std::string::npos);
}

} // namespace
} // namespace patina::bounds_test
