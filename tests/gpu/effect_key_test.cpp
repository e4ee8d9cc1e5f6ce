// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of effects, over random scenes and what is left of them without one effect or another.
#include "shading/effects/effect_key.h"

#include <algorithm>
#include <map>
#include <utility>

#include "random_scenes.h"
#include "shading/effects/effect_rows.h"
#include "shading_scene.h"

namespace patina::effect_key_test {
namespace {

constexpr std::uint64_t sceneCount = 40;

class EffectKeyTest : public ShadingTest {
  protected:
    /// A scene, the same without each of its effects, in another fog, and brighter.
    static std::vector<Scene> variantsOf(std::uint64_t number) {
        const Scene scene = RandomScenes(catalog()).scene(number);
        std::vector<Scene> variants{scene};
        for (const EffectRow& row : effectRows(scene, 0, catalog())) {
            if (row.removable) {
                variants.push_back(withoutEffects(scene, {&row.line.effect, 1}, catalog()));
            }
        }
        const Scene other = RandomScenes(catalog()).scene(number + sceneCount);
        variants.push_back(scene);
        if (const BlockValues* fog = other.part(kinds::fog)) {
            variants.back().setPart(kinds::fog, *fog);
        }
        variants.push_back(scene);
        variants.back().exposure += 1.0;
        return variants;
    }

    static std::vector<EffectView> views() {
        auto first = std::make_shared<LightSet>();
        first->add(0);
        return {EffectView(), EffectView{3.0}, EffectView{40.0, first}, EffectView{5.0, {}, true}};
    }

    static EffectSet materialEffects(const Material& material) {
        EffectSet set;
        chooseEffects(set, MaterialSubject{material, catalog()});
        return set;
    }

    /// A set and the key that was made for it.
    void add(std::uint64_t key, EffectSet set) {
        const auto known = byKey_.find(key);
        if (known != byKey_.end()) {
            EXPECT_EQ(known->second, set) << "one key for two sets";
            return;
        }
        EXPECT_TRUE(std::ranges::none_of(byKey_, [&set](const auto& other) {
            return other.second == set;
        })) << "two keys for one set";
        byKey_.emplace(key, std::move(set));
    }

    std::map<std::uint64_t, EffectSet> byKey_;
};

TEST_F(EffectKeyTest, OfRandomScenes_DiffersExactlyWhereTheChoicesDo) {
    EffectKey keys;
    for (std::uint64_t number = 0; number < sceneCount; ++number) {
        for (const Scene& scene : variantsOf(number)) {
            for (const EffectView& view : views()) {
                add(keys.ofScene(scene, catalog(), view), sceneEffects(scene, catalog(), view));
            }
        }
    }
    EXPECT_GT(byKey_.size(), 2 * sceneCount);
}

TEST_F(EffectKeyTest, OfRandomMaterials_DiffersExactlyWhereTheChoicesDo) {
    for (std::uint64_t number = 0; number < sceneCount; ++number) {
        for (const Scene& scene : variantsOf(number)) {
            for (const Object& object : scene.objects) {
                add(EffectKey::ofMaterial(object.material, catalog()),
                    materialEffects(object.material));
            }
        }
    }
    EXPECT_GT(byKey_.size(), 2 * sceneCount);
}

/// An image already keeps two values apart, so making them differ changes nothing.
TEST_F(EffectKeyTest, OfWhatAnImageDecides_DoesNotDependOnTheValue) {
    Material ward = material("ward");
    ward.model.parameters["roughness.x"] = 0.3;
    ward.model.parameters["roughness.y"] = 0.3;
    ward.textures["roughness.x"] = textureUse("roughness.x", "/image.png");
    const std::uint64_t equal = EffectKey::ofMaterial(ward, catalog());
    ward.model.parameters["roughness.y"] = 0.4;
    EXPECT_EQ(EffectKey::ofMaterial(ward, catalog()), equal);
}

TEST_F(EffectKeyTest, Programs_AreThoseOfTheMaterialAndTheSceneTogether) {
    for (std::uint64_t number = 0; number < sceneCount; ++number) {
        const Scene scene = RandomScenes(catalog()).scene(number);
        EffectSet apart = sceneEffects(scene, catalog());
        chooseEffects(apart, MaterialSubject{scene.objects[0].material, catalog()});
        EXPECT_EQ(apart, effectSet(scene.objects[0].material, scene, catalog()));
    }
}

} // namespace
} // namespace patina::effect_key_test
