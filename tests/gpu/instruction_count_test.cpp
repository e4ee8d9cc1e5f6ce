// SPDX-License-Identifier: GPL-3.0-or-later
// Instructions of shaders whose work is known.
#include "measure/time/instruction_count.h"

#include <array>

#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "material/material.h"
#include "scene/scene.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/program/program_source.h"

namespace patina::instruction_count_test {
namespace {

InstructionCount counted(const std::string& body) {
    const auto count = countInstructions("#version 410 core\n"
                                         "in vec3 a;\n"
                                         "uniform sampler2D image;\n"
                                         "layout(location = 0) out vec4 stored;\n"
                                         "void main() {\n" +
                                         body + "}\n");
    EXPECT_TRUE(count) << (count ? "" : count.error().text());
    return count.value_or(InstructionCount());
}

TEST(InstructionCount, Sums_CountByTheirNumbers) {
    EXPECT_EQ(counted("stored = vec4(a + a.zxy, 1.0);").arithmetic, 3);
}

TEST(InstructionCount, DotProduct_CountsWhatIsMultiplied) {
    EXPECT_EQ(counted("stored = vec4(dot(a, a.zxy));").arithmetic, 3);
}

TEST(InstructionCount, RootsAndPowers_AreTranscendental) {
    const InstructionCount count =
        counted("stored = vec4(sqrt(a.x), pow(a.y, a.z), a.x / a.y, 1.0);");
    EXPECT_EQ(count.transcendental, 3);
    EXPECT_EQ(count.arithmetic, 0);
}

TEST(InstructionCount, Looks_AreTextures) {
    EXPECT_EQ(counted("stored = texture(image, a.xy);").texture, 1);
}

TEST(InstructionCount, WhatIsNeverUsed_IsNotCounted) {
    EXPECT_EQ(counted("float waste = sin(a.x);\nstored = vec4(1.0);").transcendental, 0);
}

TEST(InstructionCount, Kill_IsABranch) {
    EXPECT_GE(counted("if (a.x > 0.0) { discard; }\nstored = vec4(1.0);").branch, 1);
}

TEST(InstructionCount, TextThatIsNoShader_IsAnError) {
    EXPECT_FALSE(countInstructions(std::string("#version 410 core\nvoid main() { nothing }\n")));
}

TEST(InstructionCount, ProgramsOfAllModels_AreCounted) {
    const Catalog catalog =
        loadCatalog(std::array{BlockRoot{PATINA_SOURCE_DIR "/shaders", true}});
    Scene scene;
    for (const Block* model : catalog.ofKind("models")) {
        SCOPED_TRACE(model->id);
        const EffectSet effects = effectSet(defaultMaterial(*model), scene, catalog);
        const auto source = surfaceProgram(effects, catalog);
        ASSERT_TRUE(source);
        const auto count = countInstructions(source->fragment.text);
        ASSERT_TRUE(count) << count.error().text();
        EXPECT_GT(count->total(), 0);
    }
}

} // namespace
} // namespace patina::instruction_count_test
