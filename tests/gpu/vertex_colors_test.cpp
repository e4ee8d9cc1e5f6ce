// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex colours that drive values: what pixels show, and what of it is in programs.
#include "render/surfaces/object_rows.h"
#include "shading/effects/effect_key.h"
#include "shading/effects/surface_program.h"
#include "shading_scene.h"
#include "texture_fixture.h"

namespace patina::vertex_colors_test {
namespace {

VertexColor packed(const glm::dvec4& color) {
    const auto missing = [](double share) {
        return static_cast<std::uint16_t>(65535 - std::lround(65535.0 * share));
    };
    return {missing(color.x), missing(color.y), missing(color.z),
            static_cast<std::uint16_t>(std::lround(65535.0 * color.w))};
}

/// A quad whose left edge has one colour and whose right edge has another one.
class VertexColors : public TextureTest {
  protected:
    void paint(const glm::dvec4& left, const glm::dvec4& right) {
        colors_ = {packed(left), packed(right), packed(right), packed(left)};
    }

    TextureUse& drive(const std::string& key) { return use(key, std::string(vertexColorsName)); }

    Image painted() {
        const auto mesh = [this](const Object&) {
            MeshView view = quad();
            view.colors = colors_;
            return view;
        };
        auto image = renderer->capture(scene, viewOf(scene, 16), mesh, false);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        return image ? *image : Image();
    }

  private:
    std::vector<VertexColor> colors_;
};

TEST_F(VertexColors, Colour_IsThatOfTheVertices) {
    drive("diffuse.color");
    paint({0.25, 0.5, 0.75, 1.0}, {0.25, 0.5, 0.75, 1.0});
    expectNear(at(painted(), 0.5, 0.5), {0.25f, 0.5f, 0.75f});
    EXPECT_TRUE(asked.empty()) << "no image was asked for";
}

TEST_F(VertexColors, BetweenVertices_ItGoesOnEvenly) {
    drive("diffuse.color");
    paint({0.0, 1.0, 0.0, 1.0}, {1.0, 0.0, 0.0, 1.0});
    const Image image = painted();
    for (const double u : {0.25, 0.5, 0.75}) {
        const float share = (std::floor(float(u) * 16.0f) + 0.5f) / 16.0f;
        expectNear(at(image, u, 0.5), {share, 1.0f - share, 0.0f});
    }
}

TEST_F(VertexColors, MeshWithoutThem_IsWhite) {
    drive("diffuse.color");
    expectNear(at(drawn(), 0.5, 0.5), glm::vec3(1.0f));
}

TEST_F(VertexColors, Multiplied_TintTheValue) {
    color({0.5, 0.25, 1.0});
    drive("diffuse.color").mode = TextureMode::Multiply;
    paint({0.5, 0.5, 0.25, 1.0}, {0.5, 0.5, 0.25, 1.0});
    expectNear(at(painted(), 0.5, 0.5), {0.25f, 0.125f, 0.25f});
}

TEST_F(VertexColors, Strength_IsTheirShare) {
    color({1.0, 1.0, 1.0});
    drive("diffuse.color").strength = 0.5;
    paint({0.0, 0.5, 1.0, 1.0}, {0.0, 0.5, 1.0, 1.0});
    expectNear(at(painted(), 0.5, 0.5), {0.5f, 0.75f, 1.0f});
}

TEST_F(VertexColors, Channel_CountsAlone) {
    for (const auto& [channel, expected] :
         {std::pair(TextureChannel::Green, 0.5f), std::pair(TextureChannel::Alpha, 0.75f)}) {
        drive("diffuse.color").channel = channel;
        paint({0.25, 0.5, 1.0, 0.75}, {0.25, 0.5, 1.0, 0.75});
        expectNear(at(painted(), 0.5, 0.5), glm::vec3(expected));
    }
}

/// A colour that comes after frames without one, and goes again.
TEST_F(VertexColors, BeforeAndAfter_TheMeshShowsItsValue) {
    color({0.5, 0.5, 0.5});
    paint({0.25, 0.25, 0.25, 1.0}, {0.25, 0.25, 0.25, 1.0});
    expectNear(at(painted(), 0.5, 0.5), glm::vec3(0.5f));
    drive("diffuse.color");
    expectNear(at(painted(), 0.5, 0.5), glm::vec3(0.25f));
    scene.objects.front().material.textures.clear();
    expectNear(at(painted(), 0.5, 0.5), glm::vec3(0.5f));
}

TEST_F(VertexColors, NumberOfAModel_IsTheirGrey) {
    scene.objects.front().material.model = block("models", "phong");
    const auto shown = [this](double shininess) {
        scene.objects.front().material.model.parameters["shininess"] = shininess;
        return at(painted(), 0.5, 0.5);
    };
    const Parameter* shininess = catalog->find("models", "phong")->parameter("shininess");
    ASSERT_NE(shininess, nullptr);
    const glm::vec3 plain = shown(40.0);
    TextureUse& use = drive("shininess");
    use.mode = TextureMode::Multiply;
    paint({0.25, 0.25, 0.25, 0.25}, {0.25, 0.25, 0.25, 0.25});
    expectNear(shown(160.0), plain);
}

class VertexColorTexts : public ShadingTest {
  protected:
    static Material driven(const std::string& model, const std::string& key) {
        Material made = material(model);
        made.textures[key] = textureUse(key, std::string(vertexColorsName));
        return made;
    }
};

TEST_F(VertexColorTexts, WhatTheyDrive_HasNoSamplerAndNoCoordinates) {
    const auto program =
        surfaceProgram(effectSet(driven("phong", "diffuse.color"), {}, catalog()), catalog());
    ASSERT_TRUE(program);
    EXPECT_NE(program->vertex.text.find("placeVertexColor();"), std::string::npos);
    EXPECT_EQ(program->fragment.text.find("sampler"), std::string::npos);
    EXPECT_EQ(program->fragment.text.find("surfaceUv"), std::string::npos);
    EXPECT_EQ(program->vertex.text.find("surfaceUv"), std::string::npos);
}

TEST_F(VertexColorTexts, OtherMaterials_HaveNothingOfThem) {
    Material imaged = material("phong");
    imaged.textures["diffuse.color"] = textureUse("diffuse.color", "/image.png");
    for (const Material& each : {material("phong"), imaged}) {
        const auto program = surfaceProgram(effectSet(each, {}, catalog()), catalog());
        ASSERT_TRUE(program);
        for (const std::string& text : {program->vertex.text, program->fragment.text}) {
            EXPECT_EQ(text.find("vertexColor"), std::string::npos);
            EXPECT_EQ(text.find("missingColor"), std::string::npos);
        }
    }
}

TEST_F(VertexColorTexts, BesideAnImage_BothAreInTheProgram) {
    Material both = driven("phong", "diffuse.color");
    both.textures["specular.color"] = textureUse("specular.color", "/image.png");
    const std::string text = fragment(both, {});
    EXPECT_NE(text.find("vertexColor.rgb"), std::string::npos);
    EXPECT_NE(text.find("uniform sampler2D image1;"), std::string::npos);
    EXPECT_EQ(text.find("image0"), std::string::npos);
}

TEST_F(VertexColorTexts, Key_DiffersFromThatOfAnImage) {
    Material imaged = material("phong");
    imaged.textures["diffuse.color"] = textureUse("diffuse.color", "/image.png");
    EXPECT_NE(EffectKey::ofMaterial(driven("phong", "diffuse.color"), catalog()),
              EffectKey::ofMaterial(imaged, catalog()));
}

TEST_F(VertexColorTexts, ReliefAndOpacity_AreLeftOutWithAReason) {
    for (const char* key : {"normal", "height", "opacity"}) {
        EXPECT_EQ(whyNoTexture(driven("phong", key)),
                  "Vertex colours are no image of the surface's shape.")
            << key;
    }
}

TEST_F(VertexColorTexts, Row_SaysWhereTheMeshHasNone) {
    Scene scene;
    scene.objects.resize(1);
    scene.objects[0].material = driven("phong", "diffuse.color");
    const Mesh cube = *primitive("cube");
    const std::vector<VertexColor> colors(cube.vertices.size());
    const auto reason = [&](std::span<const VertexColor> own) {
        const auto rows = objectRows(scene, 0, catalog(),
                                     [&](const Object&) {
                                         MeshView view = cube.view();
                                         view.colors = own;
                                         return view;
                                     },
                                     {});
        for (const EffectRow& row : rows) {
            if (row.line.effect == "texture/diffuse.color") {
                return row.line.detail + "; " + row.line.reason;
            }
        }
        return std::string();
    };
    EXPECT_EQ(reason(colors),
              "vertex colours: colour, in place of the value; The mesh's vertex colours drive it.");
    EXPECT_EQ(reason({}),
              "vertex colours: colour, in place of the value; The mesh's vertex colours drive it. "
              "The mesh has no vertex colours: it counts as white.");
}

} // namespace
} // namespace patina::vertex_colors_test
