// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "scene/scene.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/program/program_source.h"

namespace patina {

/// Provides the shipped catalogue without a context, from which program text is made.
class ShadingTest : public testing::Test {
  protected:
    static const Catalog& catalog() {
        static const Catalog loaded =
            loadCatalog(std::array{BlockRoot{PATINA_SOURCE_DIR "/shaders", true}});
        return loaded;
    }

    static BlockValues block(const std::string& kind, const std::string& id) {
        BlockValues made;
        made.id = id;
        made.parameters = defaultValues(*catalog().find(kind, id));
        return made;
    }

    static Light light(const std::string& kindOfLight) {
        Light made;
        made.name = kindOfLight;
        made.block = block("lights", kindOfLight);
        return made;
    }

    static Material material(const std::string& model) {
        return defaultMaterial(*catalog().find("models", model));
    }

    /// Return what a program for the material, or every one in the scene, leaves out, and why. The
    /// ground is not listed, because it has a program of its own.
    static std::vector<EffectLine> leftOutOf(const Scene& scene) {
        std::vector<EffectLine> lines =
            leftOut(sceneEffects(scene, catalog()), {nullptr, scene, catalog(), {}});
        std::erase_if(lines, [](const EffectLine& line) { return line.effect == "ground"; });
        return lines;
    }
    static std::vector<EffectLine> leftOutOf(const Material& material, const Scene& scene) {
        return leftOut(effectSet(material, scene, catalog()), {&material, scene, catalog(), {}});
    }

    /// Returns why an image of the material is left out; empty where none is.
    static std::string whyNoTexture(const Material& material) {
        for (const EffectLine& line : leftOutOf(material, {})) {
            if (line.effect.starts_with("texture/")) {
                return line.reason;
            }
        }
        return {};
    }

    static std::string fragment(const Material& material, const Scene& scene) {
        const auto program = surfaceProgram(effectSet(material, scene, catalog()), catalog());
        EXPECT_TRUE(program) << (program ? "" : text(program.error()));
        return program ? program->fragment.text : std::string();
    }
};

} // namespace patina
