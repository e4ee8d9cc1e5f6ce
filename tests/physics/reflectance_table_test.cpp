// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "lobe_cases.h"
#include "measure/lobe/table_files.h"

namespace patina::physics::reflectance_table_test {
namespace {

TEST(ReflectanceTable, OfEveryModel_IsOverTheNumbersThatDecideIt) {
    for (const Block* block : catalog().ofKind(kinds::models)) {
        const auto table =
            reflectanceTable(catalog(), defaultMaterial(*block), LobeTerm::Whole, 32);
        // Without a file the measured ones are matte.
        const bool factors = block->id == "lambert" || block->id == "measured" ||
                             block->id == "measured-grain" || block->id == "minnaert" ||
                             block->id == "lommel-seeliger" || block->id == "heidrich-seidel";
        EXPECT_EQ(table.has_value(), factors) << block->id;
        if (table) {
            EXPECT_EQ(table->axes, block->id == "heidrich-seidel" ? TableAxes::TangentCosines
                                                                  : TableAxes::NormalCosines)
                << block->id;
        }
    }
}

TEST(ReflectanceTable, ReadBetweenTexels_IsAsNearAsItSays) {
    const auto checked = [](const Material& material, LobeTerm term) {
        const auto table = reflectanceTable(catalog(), material, term, 64);
        ASSERT_TRUE(table);
        const LobeModel model = modelOf(material, term);
        double mean = 0.0;
        constexpr int steps = 50;
        for (int i = 0; i < steps; ++i) {
            for (int j = 0; j < steps; ++j) {
                // Directions that are not in one plane, other than those that were tabled.
                const double a = std::acos((i + 0.3) / steps);
                const double b = std::acos((j + 0.6) / steps);
                const glm::dvec3 l(std::sin(a) * 0.6, std::sin(a) * 0.8, std::cos(a));
                const glm::dvec3 v(-std::sin(b), 0.0, std::cos(b));
                mean += worst(table->value(l, v), model.value(l, v)) / (steps * steps);
                EXPECT_LE(worst(table->value(l, v), model.value(l, v)),
                          1.05 * table->maxError + 1e-9);
            }
        }
        EXPECT_LE(mean, 3.0 * table->meanError + 1e-9);
        EXPECT_LT(table->meanError, 0.003);
    };
    checked(materialOf("minnaert", {{"darkening", 1.5}}), LobeTerm::Whole);
    checked(materialOf("lommel-seeliger"), LobeTerm::Whole);
    checked(materialOf("heidrich-seidel"), LobeTerm::Whole);
    checked(materialOf("heidrich-seidel", {{"tangent.angle", 30.0}}), LobeTerm::Highlight);
    checked(materialOf("phong"), LobeTerm::Diffuse);
}

TEST(ReflectanceTable, OfLambert_LosesNothing) {
    const auto table = reflectanceTable(
        catalog(), materialOf("lambert", {{"diffuse.color", glm::dvec3(0.5)}}), LobeTerm::Whole, 8);
    ASSERT_TRUE(table);
    EXPECT_FALSE(table->hasCosine);
    EXPECT_LT(table->maxError, 1e-9);
    EXPECT_NEAR(table->values.front().y, 0.5, 1e-12);
    const std::string code = tableCode(*table, "Lambert");
    EXPECT_NE(code.find("vec2(dot(n, v), nl)"), std::string::npos) << code;
    EXPECT_NE(code.find(".rgb * nl"), std::string::npos) << code;
}

} // namespace
} // namespace patina::physics::reflectance_table_test
