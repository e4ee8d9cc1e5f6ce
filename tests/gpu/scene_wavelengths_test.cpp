// SPDX-License-Identifier: GPL-3.0-or-later
// The wavelengths that a scene has for red, green and blue are those of its materials.
#include "catalog/fills.h"
#include "catalog/spectrum.h"
#include "gpu_fixture.h"

namespace patina::scene_wavelengths_test {
namespace {

const glm::dvec3 others(700.0, 530.0, 420.0);

class SceneWavelengthsTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    /// Makes a scene whose material has wavelengths in its part of a kind; returns where they are.
    Value& wavelengths(const std::string& kind, const std::string& id) {
        const bool isModel = kind == kinds::models;
        scene_ = simpleScene(isModel ? id : "cook-torrance");
        Material& material = scene_.objects[0].material;
        if (!isModel) {
            material.parts[kind] = block(kind, id);
        }
        Values& values = isModel ? material.model.parameters : material.parts[kind].parameters;
        return values[catalog->find(kind, id)->withRole(roles::wavelengths)->id];
    }

    Scene scene_;
};

TEST_F(SceneWavelengthsTest, OfEveryMaterialThatNamesNone_AreThoseOfTheScene) {
    for (const char* kind : {"models", "fresnel"}) {
        int found = 0;
        for (const Block* each : catalog->ofKind(kind)) {
            const Parameter* parameter = each->withRole(roles::wavelengths);
            if (parameter == nullptr) {
                continue;
            }
            SCOPED_TRACE(each->id);
            ++found;
            Value& own = wavelengths(kind, each->id);
            EXPECT_EQ(own, Value(glm::dvec3(0.0)));
            const Image atFirst = capture(scene_, false, 17);
            const double unit = parameter->unit == "nm" ? 1.0 : 1e-3;
            own = srgbWavelengths * unit;
            EXPECT_EQ(capture(scene_, false, 17).pixels, atFirst.pixels);
            own = others * unit;
            const Image right = capture(scene_, false, 17);
            EXPECT_NE(right.pixels, atFirst.pixels);
            own = glm::dvec3(0.0);
            scene_.wavelengths = others;
            EXPECT_EQ(capture(scene_, false, 17).pixels, right.pixels);
        }
        EXPECT_GT(found, 0) << kind;
    }
}

TEST_F(SceneWavelengthsTest, OfAMetalByName_AreThoseOfItsConstants) {
    scene_ = simpleScene("cook-torrance");
    const Block& block = *catalog->find("fresnel", "metal");
    Material& material = scene_.objects[0].material;
    for (const char* level : {"exact", "table"}) {
        scene_.wavelengths = srgbWavelengths;
        material.accuracy["reflectance"] = level;
        Values& values = material.parts["fresnel"].parameters;
        material.parts["fresnel"] = {block.id, block.version, defaultValues(block), {}};
        const Image atFirst = capture(scene_, false, 17);
        scene_.wavelengths = others;
        const Image there = capture(scene_, false, 17);
        EXPECT_NE(there.pixels, atFirst.pixels) << level;
        const EnumValue* gold = spectralChoice(*block.parameter("metal"), values);
        ASSERT_NE(gold, nullptr);
        values["metal"] = std::string("custom");
        EXPECT_EQ(capture(scene_, false, 17).pixels, atFirst.pixels) << level;
        for (const char* id : {"eta", "k"}) {
            values[id] = atWavelengths(*spectrumIn(gold->fills.at(id)), others);
        }
        EXPECT_EQ(capture(scene_, false, 17).pixels, there.pixels) << level;
    }
}

TEST_F(SceneWavelengthsTest, OfABodyThatBendsColoursApart_AreThoseOfTheScene) {
    scene_ = simpleScene("lambert");
    scene_.setPart(kinds::environment, block("environment", "strip-lights"));
    Material& material = scene_.objects[0].material;
    material.opacity = 0.0;
    material.parts["refraction"] = block("refraction", "solid-body");
    material.parts["refraction"].parameters["dispersion"] = 2.0;
    material.accuracy["wavelengths"] = "3";
    const Image atFirst = capture(scene_);
    scene_.wavelengths = glm::dvec3(587.6); // the line for which the index holds
    const Image alike = capture(scene_);
    EXPECT_NE(alike.pixels, atFirst.pixels);
    material.parts["refraction"].parameters["dispersion"] = 0.0;
    scene_.wavelengths = srgbWavelengths;
    const Image plain = capture(scene_);
    const auto apart = [&plain](const Image& picture) {
        double sum = 0.0;
        for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
            sum += std::abs(double(picture.pixels[i]) - double(plain.pixels[i]));
        }
        return sum / double(plain.pixels.size());
    };
    EXPECT_LT(apart(alike), 0.5 * apart(atFirst));
    EXPECT_LT(apart(alike), 5e-3);
}

} // namespace
} // namespace patina::scene_wavelengths_test
