// SPDX-License-Identifier: GPL-3.0-or-later
// What the rows say of images whose file is missing, and of meshes that lay none.
#include "render/lights/environment_image.h"
#include "render/surfaces/object_rows.h"
#include "scene/primitives.h"
#include "shading_scene.h"

namespace patina::image_rows_test {
namespace {

class ImageRows : public ShadingTest {
  protected:
    ImageRows() : mesh_(*primitive("cube")) {
        scene_.objects.resize(1);
        scene_.objects[0].material = material("phong");
        known_.textures = [](const TextureUse& use, TextureDecoding) {
            return TextureLookup{nullptr, use.file == "/gone.png"};
        };
    }

    void bind(const std::string& key, const std::string& file) {
        scene_.objects[0].material.textures[key] = textureUse(key, file);
    }

    void loseTextureCoordinates() {
        for (Vertex& vertex : mesh_.vertices) {
            vertex.uv = {};
        }
    }

    std::string reason(const std::string& effect) {
        const auto rows = objectRows(
            scene_, 0, catalog(), [this](const Object&) { return mesh_.view(); }, known_);
        for (const EffectRow& row : rows) {
            if (row.line.effect == effect) {
                return row.line.reason;
            }
        }
        return {};
    }

    Scene scene_;
    Mesh mesh_;
    KnownImages known_;
};

TEST_F(ImageRows, MissingFile_IsSaidWithThePlaceholder) {
    bind("diffuse.color", "/gone.png");
    bind("normal", "/there.png");
    EXPECT_EQ(reason("texture/diffuse.color"),
              "An image is bound to it. The image's file is missing or cannot be read: a "
              "placeholder is shown.");
    EXPECT_EQ(reason("texture/normal"), "An image is bound to it.");
    scene_.objects[0].material.textures["diffuse.color"].outside = true;
    EXPECT_NE(reason("texture/diffuse.color").find("outside the preset's folder"),
              std::string::npos);
    known_ = {};
    EXPECT_EQ(reason("texture/diffuse.color"), "An image is bound to it.");
}

TEST_F(ImageRows, MeshWithoutTextureCoordinates_IsSaidByWhatTheImageDoes) {
    loseTextureCoordinates();
    const std::string base = "An image is bound to it. The mesh has no texture coordinates: ";
    for (const auto& [key, text] : std::map<std::string, std::string>{
             {"diffuse.color", "it is one colour."},
             {"shininess", "it is one value."},
             {"opacity", "it is one opacity."},
             {"height", "it has no effect."},
             {"normal", "it leans all of the surface the same way."}}) {
        bind(key, "/there.png");
        EXPECT_EQ(reason("texture/" + key), base + text);
    }
}

TEST_F(ImageRows, EnvironmentWithoutItsFile_SendsAPlaceholdersLight) {
    scene_.setPart(kinds::environment, block("environment", "image"));
    scene_.part(kinds::environment)->parameters["image"] = std::string("/gone.hdr");
    EXPECT_EQ(reason("environment/image"), "The scene has an environment that sends light.");
    known_.isEnvironmentMissing = true;
    EXPECT_EQ(reason("environment/image"),
              "The file of the environment's picture is missing or cannot be read: a placeholder "
              "sends light.");
}

TEST_F(ImageRows, PlaceholderOfAnEnvironment_SaysThatItIsOne) {
    EXPECT_TRUE(EnvironmentImage::missing()->isMissing);
    EXPECT_FALSE(EnvironmentImage::from({1, 1, 1, {0.5f}})->isMissing);
}

} // namespace
} // namespace patina::image_rows_test
