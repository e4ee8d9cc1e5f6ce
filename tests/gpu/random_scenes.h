// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "scene/picture_choice_text.h"
#include "scene/scene.h"

namespace patina {

/// Makes scenes of all blocks, in any mixture and with any values. With the same catalogue the same
/// number gives the same scene.
class RandomScenes {
  public:
    explicit RandomScenes(const Catalog& catalog) : catalog_(catalog) {}

    Scene scene(std::uint64_t number) {
        state_ = number;
        state_ = next(); // neighbours begin far from each other
        Scene scene;
        const std::size_t objects = chance(0.7) ? 1 : 1 + below(3);
        for (std::size_t i = 0; i < objects; ++i) {
            scene.objects.push_back(object());
        }
        addLights(scene);
        addSurroundings(scene);
        scene.occlusion = number % 2 == 1;
        scene.camera.yaw = between(-180.0, 180.0);
        scene.camera.pitch = between(-60.0, 85.0);
        scene.camera.distance = chance(0.1) ? between(0.1, 1.0) : between(2.0, 6.0);
        scene.exposure = chance(0.5) ? 0.0 : between(-6.0, 6.0);
        if (chance(0.5)) {
            scene.setPart(kinds::tone, block("tone"));
        }
        if (chance(0.5)) {
            scene.setPart(kinds::transparency, block("transparency"));
        }
        for (const PictureChoiceText& text : pictureChoiceTexts()) {
            if (chance(0.25)) {
                scene.accuracy.choose(text.choice, below(text.levels.size()));
            }
        }
        return scene;
    }

    /// Draw numbers for what is not part of a scene; they follow those of the last scene.
    std::size_t below(std::size_t count) { return next() % count; }
    bool chance(double share) { return between(0.0, 1.0) < share; }

  private:
    /// Returns the next number of SplitMix64 (Steele, Lea, Flood 2014).
    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = (state_ ^ (state_ >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    double between(double lowest, double highest) {
        return lowest + (highest - lowest) * double(next() >> 11) * 0x1p-53;
    }

    glm::dvec3 point(double reach) {
        const double x = between(-reach, reach);
        const double y = between(-reach, reach);
        return {x, y, between(-reach, reach)};
    }

    glm::dvec3 color() { return chance(0.1) ? glm::dvec3(0.0) : 0.5 * point(1.0) + 0.5; }

    /// Returns mostly what a slider gives, sometimes a limit of what a file may hold.
    double number(const Parameter& parameter) {
        const double kind = between(0.0, 1.0);
        if (kind < 0.05) {
            return parameter.min;
        }
        if (kind < 0.1) {
            return parameter.max;
        }
        return kind < 0.15 ? std::clamp(0.0, parameter.min, parameter.max)
                           : between(parameter.softMin, parameter.softMax);
    }

    Value value(const Parameter& parameter) {
        switch (parameter.type) {
        case ParameterType::Bool:
            return chance(0.5);
        case ParameterType::Int:
            return int(std::clamp(number(parameter), -1e9, 1e9));
        case ParameterType::Enum:
            return parameter.values[below(parameter.values.size())].id;
        case ParameterType::Vec2: {
            const double x = number(parameter);
            return glm::dvec2(x, number(parameter));
        }
        case ParameterType::Vec3:
        case ParameterType::Color: {
            const double x = number(parameter);
            const double y = number(parameter);
            return glm::dvec3(x, y, number(parameter));
        }
        case ParameterType::Texture:
            return std::string(chance(0.8) ? "/panorama.hdr" : "");
        case ParameterType::Measured:
            return std::string();
        case ParameterType::Curve:
        case ParameterType::Ramp:
            return infoOf(parameter.type).ordinary(parameter, [&] { return number(parameter); });
        default:
            return number(parameter);
        }
    }

    /// Makes a block of the kind, with a random share of its values changed.
    BlockValues block(const std::string& kind) {
        const std::vector<const Block*> known = catalog_.ofKind(kind);
        const Block& chosen = *known[below(known.size())];
        BlockValues made;
        made.id = chosen.id;
        made.parameters = defaultValues(chosen);
        const double share = between(0.0, 1.0);
        for (const Parameter& parameter : chosen.parameters) {
            if (chance(share)) {
                made.parameters[parameter.id] = value(parameter);
            }
        }
        return made;
    }

    Object object() {
        static constexpr std::array meshes{"sphere", "cube", "torus", "plane", "cone"};
        Object made;
        made.mesh = std::string("builtin:") + meshes[below(meshes.size())];
        made.translation = point(0.7);
        made.rotation = point(180.0);
        made.scale = chance(0.8) ? glm::dvec3(between(0.3, 1.5)) : point(1.5);
        made.castsShadow = chance(0.9);
        made.material = material();
        return made;
    }

    Material material() {
        Material made;
        made.model = block("models");
        if (chance(0.4)) {
            made.parts["fresnel"] = block("fresnel");
        }
        if (chance(0.4)) {
            made.parts["specular"] = block("specular");
        }
        if (chance(0.2)) {
            made.parts["refraction"] = block("refraction");
        }
        made.opacity = chance(0.7) ? 1.0 : between(0.0, 1.0);
        if (chance(0.3)) {
            made.parts["outline"] = block("outline");
        }
        if (chance(0.1)) {
            made.parts["shells"] = block("shells");
            chooseAccuracy(made, *catalog_.find("shells", made.parts["shells"].id));
        }
        if (chance(0.1)) {
            made.parts["strokes"] = block("strokes");
            chooseAccuracy(made, *catalog_.find("strokes", made.parts["strokes"].id));
        }
        chooseAccuracy(made, *catalog_.find("models", made.model.id));
        addTextures(made);
        return made;
    }

    void chooseAccuracy(Material& material, const Block& block) {
        for (const AccuracyChoice& choice : block.accuracy) {
            material.accuracy[choice.id] = choice.values[below(choice.values.size())].id;
        }
    }

    void addTextures(Material& material) {
        if (chance(0.5)) {
            return;
        }
        addTexture(material, "normal", 0.3);
        addTexture(material, "height", 0.3);
        addTexture(material, "opacity", 0.2);
        for (const Parameter& parameter : catalog_.find("models", material.model.id)->parameters) {
            addTexture(material, parameter.id, parameter.textureChannels.empty() ? 0.0 : 0.3);
        }
        for (const auto& [kind, part] : material.parts) {
            for (const Parameter& parameter : catalog_.find(kind, part.id)->parameters) {
                addTexture(material, kind + '.' + parameter.id,
                           parameter.textureChannels.empty() ? 0.0 : 0.3);
            }
        }
    }

    void addTexture(Material& material, const std::string& key, double share) {
        if (!chance(share)) {
            return;
        }
        TextureUse use = textureUse(key, "/picture" + std::to_string(below(4)) + ".png");
        use.colorSpace = TextureColorSpace(below(3));
        use.channel = TextureChannel(below(6));
        use.mode = TextureMode(below(3));
        use.wrap = TextureWrap(below(3));
        use.filter = TextureFilter(below(2));
        use.scale = glm::dvec2(between(-4.0, 4.0), between(0.0, 4.0));
        use.offset = glm::dvec2(between(-1.0, 1.0), 0.0);
        use.rotation = between(-360.0, 360.0);
        use.strength = chance(0.7) ? use.strength : between(0.0, 2.0);
        use.cutOut = chance(0.5);
        use.threshold = between(0.0, 1.0);
        material.textures[key] = use;
    }

    void addLights(Scene& scene) {
        const std::size_t lights = below(5);
        for (std::size_t i = 0; i < lights; ++i) {
            Light& light = scene.lights.emplace_back();
            light.block = block("lights");
            light.enabled = chance(0.95);
            if (chance(0.4)) {
                light.setPart(kinds::shadows, block("shadows"));
            }
        }
    }

    void addSurroundings(Scene& scene) {
        if (chance(0.4)) {
            scene.setPart(kinds::fog, block("fog"));
        }
        if (chance(0.3)) {
            scene.setPart(kinds::environment, block("environment"));
        }
        if (chance(0.5)) {
            scene.setPart(kinds::transparency, block("transparency"));
        }
        scene.ambient = chance(0.5) ? glm::dvec3(0.0) : color();
        if (chance(0.3)) {
            scene.hemisphere = {color(), color(), point(1.0)};
        }
        scene.ground.mode = chance(0.5) ? GroundMode::Off : GroundMode(1 + below(2));
        scene.ground.automatic = chance(0.8);
        scene.ground.opacity = chance(0.7) ? 1.0 : between(0.0, 1.0);
        scene.background = color();
    }

    const Catalog& catalog_;
    std::uint64_t state_ = 0;
};

} // namespace patina
