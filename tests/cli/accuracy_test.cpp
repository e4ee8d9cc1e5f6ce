// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::accuracy_test {
namespace {

Outcome rendered(const std::vector<std::string>& more) {
    std::vector<std::string> command{"render", "--size", "48x48", "-o", "-"};
    command.insert(command.end(), more.begin(), more.end());
    return patina(command);
}

std::string picture(const std::vector<std::string>& more) {
    const Outcome outcome = rendered(more);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return outcome.out;
}

TEST(SetOption, AccuracyOfTheModel_ChangesThePicture) {
    const std::vector<std::string> exact{"--model", "phong"};
    EXPECT_NE(picture({"--model", "phong", "--set", "power=rational"}), picture(exact));
    EXPECT_EQ(picture({"--model", "phong", "--set", "accuracy.power=rational"}),
              picture({"--model", "phong", "--set", "power=rational"}));
}

TEST(SetOption, AccuracyOfAPart_ChangesThePicture) {
    const std::vector<std::string> metal{"--model", "cook-torrance", "--fresnel", "conductor",
                                         "--set", "metal=iron"};
    const auto with = [&metal](const std::string& set) {
        std::vector<std::string> all = metal;
        all.insert(all.end(), {"--set", set});
        return all;
    };
    EXPECT_NE(picture(with("reflectance=schlick")), picture(metal));
    EXPECT_EQ(picture(with("fresnel.reflectance=schlick")), picture(with("reflectance=schlick")));
}

TEST(SetOption, AccuracyLevelThatIsNone_NamesThoseThereAre) {
    const Outcome outcome = rendered({"--model", "phong", "--set", "power=guess"});
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("gaussian"), std::string::npos) << outcome.err;
}

TEST(SetOption, AccuracyOfThePicture_ChangesIt) {
    const std::vector<std::string> exact{"--model", "phong"};
    EXPECT_NE(picture({"--model", "phong", "--set", "picture.scale=half"}), picture(exact));
    EXPECT_EQ(picture({"--model", "phong", "--set", "picture.scale=full"}), picture(exact));
}

TEST(SetOption, AccuracyLevelOfThePictureThatIsNone_NamesThoseThereAre) {
    const Outcome outcome = rendered({"--model", "phong", "--set", "picture.lighting=wax"});
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("vertex"), std::string::npos) << outcome.err;
}

TEST(SetOption, AccuracyOfABlockThatIsNotUsed_IsAMistake) {
    EXPECT_NE(rendered({"--model", "lambert", "--set", "power=rational"}).exitCode, 0);
}

} // namespace
} // namespace patina::tests::accuracy_test
