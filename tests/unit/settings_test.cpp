// SPDX-License-Identifier: GPL-3.0-or-later
// Settings: descriptors without a shader, and the members they describe.
#include <gtest/gtest.h>

#include "catalog/descriptor_checks.h"
#include "catalog/settings.h"
#include "material/material_settings.h"
#include "scene/scene_settings.h"

namespace patina::tests::settings_test {
namespace {

/// Another value than the default, in range.
Value otherValue(const Parameter& parameter) {
    const Value& usual = parameter.defaultValue;
    if (const auto* flag = std::get_if<bool>(&usual)) {
        return !*flag;
    }
    if (std::holds_alternative<std::string>(usual)) {
        const std::string& first = parameter.values.front().id;
        return usual == Value(first) ? parameter.values.back().id : first;
    }
    const double half = 0.5 * (parameter.softMin + parameter.softMax) + 0.125;
    return std::holds_alternative<double>(usual) ? Value(half) : Value(glm::dvec3(half));
}

template <class Owner>
void expectEachHeld(std::string_view word) {
    for (const Parameter& parameter : settingsBlock(word)->parameters) {
        if (parameter.type == ParameterType::Texture) {
            continue;
        }
        SCOPED_TRACE(parameter.id);
        Owner owner;
        ASSERT_TRUE(settingOf(owner, parameter.id));
        EXPECT_EQ(roundedToFloat(*settingOf(owner, parameter.id)),
                  roundedToFloat(parameter.defaultValue));
        storeSetting(owner, parameter.id, otherValue(parameter));
        EXPECT_EQ(*settingOf(owner, parameter.id), otherValue(parameter));
    }
}

TEST(Settings, EachDescriptor_HasNoMistake) {
    const auto schema = JsonSchema::load("descriptor");
    ASSERT_TRUE(schema);
    EXPECT_EQ(settingsDescriptors().size(), 5u);
    for (const Descriptor& descriptor : settingsDescriptors()) {
        EXPECT_EQ(text(schema->check(descriptor.document)), "");
        EXPECT_EQ(text(descriptorMistakes(descriptor)), "");
    }
}

TEST(Settings, EachParameter_IsAMemberWithItsDefault) {
    expectEachHeld<Scene>(settings::scene);
    expectEachHeld<Camera>(settings::camera);
    expectEachHeld<Object>(settings::object);
    expectEachHeld<Light>(settings::light);
    expectEachHeld<Material>(settings::material);
}

} // namespace
} // namespace patina::tests::settings_test
