// SPDX-License-Identifier: GPL-3.0-or-later
// Materials in files of other programs: what has a counterpart there comes back as it was, and what
// has none is told.
#include "exchange/material_export.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "assets/asset_client.h"
#include "catalog/json_text.h"
#include "cli/patina_program.h"
#include "material/material_assignment.h"
#include "material/mesh_look.h"
#include "material/preset_file.h"

namespace patina::tests::material_export_test {
namespace {

const Catalog& blocks() {
    static const Catalog catalog =
        loadCatalog(std::vector<BlockRoot>{{dataFolder() / "shaders", true}});
    return catalog;
}

/// Returns a material called "paint" that looks as a word says, with these assignments.
Material looking(const std::string& look, const std::vector<std::string>& assignments) {
    Material material = importedLook(look, blocks())->start(blocks()).value();
    material.name = "paint";
    for (const std::string& assignment : assignments) {
        const auto done = assignInMaterial(material, assignment, blocks());
        EXPECT_TRUE(done) << done.error().text();
    }
    return material;
}

std::string textOf(const Material& material) {
    return writeJson(toJson(material));
}

class ExportedMaterial : public testing::Test {
  protected:
    /// Writes the material, and returns what becomes of it.
    std::vector<ExportLine> write(const Material& material, const std::string& name) {
        const Progress progress;
        const auto exported = exportMaterials(folder_ / name, {material}, blocks(), progress);
        EXPECT_TRUE(exported) << exported.error().text();
        return exported ? exported->lines.front() : std::vector<ExportLine>();
    }

    /// Returns the material as it comes out of a mesh file that another program has written: what
    /// Patina keeps in glTF for itself is not there.
    Material read(const std::string& name) {
        if (name.ends_with(".gltf")) {
            auto document = nlohmann::json::parse(readFile(folder_ / name));
            document["materials"][0].erase("extras");
            writeFile(folder_ / name, document.dump());
        }
        return readOwn(name);
    }

    /// Returns the material as it comes out of a mesh file.
    Material readOwn(const std::string& name) {
        MeshRequest request;
        request.file = folder_ / name;
        request.byMaterial = true;
        const auto mesh = client_.loadMesh(request);
        if (!mesh) {
            ADD_FAILURE() << mesh.error().text();
            return {};
        }
        EXPECT_EQ((*mesh)->remarks(), "");
        const auto material = materialOf((*mesh)->parts().front().material, blocks());
        return material ? *material : Material();
    }

    TemporaryFolder folder_;
    AssetClient client_;
};

bool isAllExact(const std::vector<ExportLine>& lines) {
    return std::ranges::all_of(lines,
                               [](const ExportLine& line) { return line.kept == Kept::Exact; });
}

TEST_F(ExportedMaterial, GltfMetal_ComesBackAsItWas) {
    const Material gold = looking("metal", {"fresnel.f0=0.9,0.61,0.23", "roughness=0.137",
                                            "emissive.color=3,0.5,0", "opacity=0.75"});
    EXPECT_TRUE(isAllExact(write(gold, "gold.gltf")));
    EXPECT_EQ(textOf(read("gold.gltf")), textOf(gold));
}

TEST_F(ExportedMaterial, GltfDielectricOfAnyReflectance_ComesBackAsItWas) {
    for (const char* f0 : {"0.04,0.04,0.04", "0.17,0.17,0.17", "0.02,0.3,0.1", "0,0,0", "1,1,1"}) {
        const Material paint =
            looking("dielectric", {std::string("fresnel.f0=") + f0, "diffuse.color=0.5,0.2,0.1",
                                   "roughness=0.3"});
        write(paint, "paint.glb");
        EXPECT_EQ(textOf(read("paint.glb")), textOf(paint)) << f0;
    }
}

TEST_F(ExportedMaterial, GltfMatteWithImages_ComesBackAsItWas) {
    Material wall = looking("matte", {"diffuse.color=0.5,0.25,0.125"});
    for (const char* name : {"wall.png", "bumps.png"}) {
        writeFile(folder_ / name, name);
    }
    wall.textures["diffuse.color"] = textureUse("diffuse.color", folder_ / "wall.png");
    wall.textures["diffuse.color"].mode = TextureMode::Multiply;
    wall.textures["normal"] = textureUse("normal", folder_ / "bumps.png");
    EXPECT_TRUE(isAllExact(write(wall, "wall.gltf")));
    Material back = read("wall.gltf");
    for (auto& [key, use] : back.textures) {
        EXPECT_EQ(use.file, (folder_ / "wall-images" /
                             std::filesystem::path(wall.textures[key].file).filename())
                                .string());
        EXPECT_EQ(readFile(use.file), readFile(wall.textures[key].file));
        use.file = wall.textures[key].file;
    }
    EXPECT_EQ(textOf(back), textOf(wall));
}

TEST_F(ExportedMaterial, Mtl_ComesBackWithinTheFloatsOfItsReader) {
    writeFile(folder_ / "mesh.obj",
              "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl paint\nf 1 2 3\n");
    const Material shiny =
        looking("blinn-phong", {"diffuse.color=0.5,0.2,0.1", "specular.color=0.25,0.25,0.5",
                                "shininess=40", "opacity=0.5"});
    EXPECT_TRUE(isAllExact(write(shiny, "paint.mtl")));
    const Material back = read("mesh.obj");
    EXPECT_EQ(back.model.id, shiny.model.id);
    EXPECT_EQ(back.opacity, 0.5);
    for (const char* id : {"diffuse.color", "specular.color"}) {
        const auto color = std::get<glm::dvec3>(back.model.parameters.at(id));
        const auto wanted = std::get<glm::dvec3>(shiny.model.parameters.at(id));
        EXPECT_LT(glm::length(color - wanted), 1e-6) << id;
    }
    EXPECT_EQ(back.model.parameters.at("shininess"), Value(40.0));
}

/// A highlight that is black leaves a matte surface, which glTF has and the model does not state.
TEST_F(ExportedMaterial, WhatNoLookSays_IsFittedAndTold) {
    const Material paint = looking(
        "blinn-phong", {"diffuse.color=0.4,0.3,0.2", "specular.color=0,0,0", "outline=ink-line"});
    const std::vector<ExportLine> lines = write(paint, "paint.gltf");
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(lines.front().kept, Kept::Approximated);
    EXPECT_EQ(lines.front().what, "Blinn-Phong");
    EXPECT_TRUE(
        lines.front().how.starts_with("has no counterpart as it is set; matte was fitted to it, "))
        << lines.front().how;
    EXPECT_TRUE(std::ranges::any_of(lines, [](const ExportLine& line) {
        return line.kept == Kept::Dropped && line.what == "Ink line";
    }));
    const Material back = read("paint.gltf");
    EXPECT_EQ(back.model.id, "lambert");
    const auto color = std::get<glm::dvec3>(back.model.parameters.at("diffuse.color"));
    EXPECT_LT(glm::length(color - glm::dvec3(0.4, 0.3, 0.2)), 1e-4);
}

/// Its highlight has most of its light, but next to none of the ball.
TEST_F(ExportedMaterial, FittedPlastic_KeepsTheColourOfItsBall) {
    const auto plastic = readPreset(shipped("presets/strauss/red-plastic.patina.json"), blocks());
    ASSERT_TRUE(plastic);
    write(plastic->material, "plastic.gltf");
    const Material back = read("plastic.gltf");
    const auto color = std::get<glm::dvec3>(back.model.parameters.at("diffuse.color"));
    EXPECT_GT(color.r, 0.1);
    EXPECT_LT(color.g, 0.02);
    EXPECT_LT(color.b, 0.02);
    EXPECT_NEAR(std::get<double>(back.model.parameters.at("roughness")), 0.2, 0.05);
}

/// Another look comes nearer, but has no colour that the image could lie on.
TEST_F(ExportedMaterial, FittedSurfaceWithAnImage_KeepsItOnItsColour) {
    auto velvet = readPreset(shipped("presets/minnaert/velvet.patina.json"), blocks());
    ASSERT_TRUE(velvet);
    for (auto& [key, use] : velvet->material.textures) {
        use.scale = glm::dvec2(1.0);
    }
    write(velvet->material, "velvet.gltf");
    const Material back = read("velvet.gltf");
    ASSERT_TRUE(back.textures.contains("diffuse.color"));
    const auto color = std::get<glm::dvec3>(back.model.parameters.at("diffuse.color"));
    EXPECT_GT(color.r, 0.05);
}

/// A wide highlight in place of the clay's rim would come nearer than its own.
TEST_F(ExportedMaterial, HighlightOverAMatteModel_GoesAlong) {
    const auto clay = readPreset(shipped("presets/oren-nayar/wet-clay.patina.json"), blocks());
    ASSERT_TRUE(clay);
    const std::vector<ExportLine> lines = write(clay->material, "clay.gltf");
    const Material back = read("clay.gltf");
    ASSERT_NE(back.part("fresnel"), nullptr) << exportText(lines);
    EXPECT_GT(std::get<glm::dvec3>(back.part("fresnel")->parameters.at("f0")).g, 0.005);
    EXPECT_NEAR(std::get<double>(back.model.parameters.at("roughness")), std::sqrt(2.0 / 122.0),
                1e-6);
    EXPECT_TRUE(std::ranges::none_of(lines, [](const ExportLine& line) {
        return line.kept == Kept::Dropped;
    })) << exportText(lines);
}

TEST_F(ExportedMaterial, GltfGrain_ComesBackAsItWas) {
    for (const char* grain : {"anisotropy=0.8,tangent.angle=30", "anisotropy=1,tangent.angle=0",
                              "anisotropy=0,tangent.angle=135"}) {
        const std::string both(grain);
        const auto comma = both.find(',');
        for (const bool isMetal : {true, false}) {
            const Material brass = looking(isMetal ? "grained-metal" : "grained-dielectric",
                                           {"fresnel.f0=0.9,0.61,0.23", "roughness=0.137",
                                            both.substr(0, comma), both.substr(comma + 1)});
            const std::vector<ExportLine> lines = write(brass, "brass.gltf");
            EXPECT_EQ(isAllExact(lines), isMetal) << exportText(lines); // a base is darkened
            EXPECT_EQ(textOf(read("brass.gltf")), textOf(brass)) << grain;
        }
    }
}

/// The extension has the width along its direction between the other one and 1: 0.25 and 0.25 +
/// 0.75 / 4 are a mean of 0.330719.
TEST_F(ExportedMaterial, GltfGrain_IsThatOfItsExtension) {
    const double across = 0.25 + 0.75 * 0.25;
    const Material steel =
        looking("grained-metal",
                {"roughness=" + std::to_string(std::sqrt(0.25 * across)),
                 "anisotropy=" + std::to_string((1.0 - 0.25 / across) / 0.9), "tangent.angle=0"});
    write(steel, "steel.gltf");
    const auto material = nlohmann::json::parse(readFile(folder_ / "steel.gltf"))["materials"][0];
    const auto& grain = material["extensions"]["KHR_materials_anisotropy"];
    EXPECT_NEAR(double(grain["anisotropyStrength"]), 0.5, 1e-5);
    EXPECT_NEAR(std::abs(double(grain["anisotropyRotation"])), 1.57079633, 1e-8)
        << "the highlight is long across the grain";
    EXPECT_NEAR(double(material["pbrMetallicRoughness"]["roughnessFactor"]), 0.5, 1e-5);
}

TEST_F(ExportedMaterial, WidthAboveOne_IsToldToBeCut) {
    const std::vector<ExportLine> lines =
        write(looking("grained-metal", {"roughness=0.9", "anisotropy=1"}), "rough.gltf");
    EXPECT_TRUE(std::ranges::any_of(lines, [](const ExportLine& line) {
        return line.kept == Kept::Approximated && line.what == "Anisotropy";
    })) << exportText(lines);
}

/// OpenPBR: across = r^2 sqrt(2 / (1 + (1 - a)^2)), along = (1 - a) across.
TEST_F(ExportedMaterial, MaterialX_HasAGrainAcrossItsTangent) {
    const Material brass =
        looking("grained-metal", {"roughness=0.2", "anisotropy=0.8", "tangent.angle=0"});
    EXPECT_TRUE(isAllExact(write(brass, "brass.mtlx")));
    const std::string text = readFile(folder_ / "brass.mtlx");
    const auto valueOf = [&text](const std::string& input) {
        const auto place = text.find("\"" + input + "\"");
        const auto value = text.find("value=\"", place);
        return place == std::string::npos ? -1.0 : std::stod(text.substr(value + 7));
    };
    const double ratio = 1.0 - valueOf("specular_roughness_anisotropy");
    const double roughness = valueOf("specular_roughness");
    const double across = roughness * roughness * std::sqrt(2.0 / (1.0 + ratio * ratio));
    EXPECT_NEAR(ratio, 1.0 - 0.9 * 0.8, 1e-6);
    EXPECT_NEAR(std::sqrt(across * across * ratio), 0.2, 1e-6);
    for (const char* part : {"<bitangent name=\"paint_streak_bitangent\" type=\"vector3\">",
                             "name=\"geometry_tangent\" type=\"vector3\" "
                             "nodename=\"paint_streak\""}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
    }
}

TEST_F(ExportedMaterial, BrushedPreset_KeepsItsGrain) {
    const auto steel = readPreset(shipped("presets/ward/brushed-steel.patina.json"), blocks());
    ASSERT_TRUE(steel);
    Material plain = steel->material;
    plain.textures.clear();
    write(plain, "steel.gltf");
    const Material back = read("steel.gltf");
    ASSERT_TRUE(back.model.parameters.contains("anisotropy")) << textOf(back);
    EXPECT_GT(std::get<double>(back.model.parameters.at("anisotropy")), 0.3);
}

TEST_F(ExportedMaterial, BodyThatRefracts_IsADielectricWithAVolume) {
    const Material glass =
        looking("dielectric", {"diffuse.color=0,0,0", "opacity=0.25", "refraction=solid-body",
                               "refraction.absorption.color=0.5,0.75,0.25",
                               "refraction.absorption.distance=2", "refraction.dispersion=0.5"});
    const std::vector<ExportLine> lines = write(glass, "glass.gltf");
    EXPECT_TRUE(isAllExact(lines)) << exportText(lines);
    const auto document = nlohmann::json::parse(readFile(folder_ / "glass.gltf"));
    const auto& extensions = document["materials"][0]["extensions"];
    EXPECT_EQ(extensions["KHR_materials_transmission"]["transmissionFactor"], 0.75);
    EXPECT_EQ(extensions["KHR_materials_volume"]["attenuationDistance"], 2.0);
    EXPECT_EQ(extensions["KHR_materials_volume"]["attenuationColor"],
              nlohmann::json::array({0.5, 0.75, 0.25}));
    EXPECT_EQ(extensions["KHR_materials_dispersion"]["dispersion"], 0.5);
    EXPECT_FALSE(document["materials"][0].contains("alphaMode"));
    Material back = read("glass.gltf");
    EXPECT_EQ(back.model.parameters["diffuse.color"], Value(glm::dvec3(1.0)))
        << "the base colour is that of what passes, too";
    back.model.parameters["diffuse.color"] = glm::dvec3(0.0);
    EXPECT_EQ(textOf(back), textOf(glass));
}

TEST_F(ExportedMaterial, PaneThatRefracts_ComesBackAsAWall) {
    const Material pane = looking(
        "dielectric", {"opacity=0.125", "refraction=thin-pane", "refraction.tint=0.5,0.75,0.25"});
    write(pane, "pane.gltf");
    const Material back = read("pane.gltf");
    ASSERT_NE(back.part("refraction"), nullptr);
    EXPECT_EQ(back.part("refraction")->id, "thin-pane");
    EXPECT_EQ(back.part("refraction")->parameters.at("tint"), Value(glm::dvec3(0.5, 0.75, 0.25)));
    EXPECT_EQ(back.part("refraction")->parameters.at("thickness"), Value(0.0));
    EXPECT_EQ(back.opacity, 0.125);
}

TEST_F(ExportedMaterial, TurnedImage_LiesInGltfAsInPatina) {
    writeFile(folder_ / "wood.png", "an image");
    Material wood = looking("matte", {});
    TextureUse use = textureUse("diffuse.color", folder_ / "wood.png");
    use.scale = glm::dvec2(2.0);
    use.offset = {0.25, 0.5};
    use.rotation = 90.0;
    wood.textures["diffuse.color"] = use;
    write(wood, "wood.gltf");
    const auto document = nlohmann::json::parse(readFile(folder_ / "wood.gltf"));
    const auto& place = document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]
                                ["extensions"]["KHR_texture_transform"];
    // The middle of the surface stays in the middle of what is turned; up leads to the right there.
    const double turn = place["rotation"];
    const auto at = [&](double u, double v) {
        const double s = place["scale"][0];
        return glm::dvec2(
            std::cos(turn) * s * u + std::sin(turn) * s * v + double(place["offset"][0]),
            -std::sin(turn) * s * u + std::cos(turn) * s * v + double(place["offset"][1]));
    };
    EXPECT_LT(glm::length(at(0.5, 0.5) - glm::dvec2(1.25, -0.5)), 1e-12);
    EXPECT_LT(glm::length(at(0.5, 0.25) - glm::dvec2(1.75, -0.5)), 1e-12);
}

TEST_F(ExportedMaterial, PlacedImages_ComeBackAsTheyLay) {
    writeFile(folder_ / "wood.png", "an image");
    for (const auto& [scale, rotation] :
         {std::pair(glm::dvec2(3.0), 30.0), std::pair(glm::dvec2(2.0), -120.0),
          std::pair(glm::dvec2(0.5, 4.0), 0.0)}) {
        Material wood = looking("matte", {});
        TextureUse use = textureUse("diffuse.color", folder_ / "wood.png");
        use.mode = TextureMode::Multiply;
        use.scale = scale;
        use.offset = {0.25, -1.5};
        use.rotation = rotation;
        wood.textures["diffuse.color"] = use;
        write(wood, "wood.gltf");
        const Material back = read("wood.gltf");
        ASSERT_TRUE(back.textures.contains("diffuse.color"));
        const TextureUse& placed = back.textures.at("diffuse.color");
        EXPECT_LT(glm::length(placed.scale - scale), 1e-9);
        EXPECT_LT(glm::length(placed.offset - use.offset), 1e-9) << rotation;
        EXPECT_NEAR(placed.rotation, rotation, 1e-9);
    }
}

TEST_F(ExportedMaterial, EdgesAndPixelsOfImages_ComeBackAsTheyWere) {
    writeFile(folder_ / "wood.png", "an image");
    for (const TextureWrap wrap : {TextureWrap::Repeat, TextureWrap::Clamp, TextureWrap::Mirror}) {
        for (const TextureFilter filter : {TextureFilter::Smooth, TextureFilter::Nearest}) {
            Material wood = looking("matte", {});
            TextureUse& use = wood.textures["diffuse.color"];
            use = textureUse("diffuse.color", folder_ / "wood.png");
            use.mode = TextureMode::Multiply;
            use.wrap = wrap;
            use.filter = filter;
            EXPECT_TRUE(isAllExact(write(wood, "wood.gltf")));
            const Material back = read("wood.gltf");
            ASSERT_TRUE(back.textures.contains("diffuse.color"));
            EXPECT_EQ(back.textures.at("diffuse.color").wrap, wrap);
            EXPECT_EQ(back.textures.at("diffuse.color").filter, filter);
        }
    }
}

/// glTF has roots in the green of an image that has the metalness in its blue.
TEST_F(ExportedMaterial, ImageOfARoughness_IsWrittenAsItsRoots) {
    ASSERT_TRUE(client_.saveImage(
        folder_ / "worn.exr", Image{2, 2, 3, {0.25f, 0, 0, 0.04f, 0, 0, 0.64f, 0, 0, 1, 0, 0}}));
    for (const TextureMode mode : {TextureMode::Replace, TextureMode::Multiply}) {
        Material steel = looking("metal", {"roughness=0.25"});
        TextureUse& use = steel.textures["roughness"];
        use = textureUse("roughness", folder_ / "worn.exr");
        use.mode = mode;
        use.wrap = TextureWrap::Mirror;
        const std::vector<ExportLine> lines = write(steel, "steel.gltf");
        EXPECT_TRUE(isAllExact(lines)) << exportText(lines);
        const Material back = read("steel.gltf");
        const bool isMultiplied = mode == TextureMode::Multiply;
        EXPECT_EQ(back.model.parameters.at("roughness"), Value(isMultiplied ? 0.25 : 1.0));
        ASSERT_TRUE(back.textures.contains("roughness"));
        const TextureUse& written = back.textures.at("roughness");
        EXPECT_EQ(written.colorSpace, TextureColorSpace::Roots);
        EXPECT_EQ(written.channel, TextureChannel::Green);
        EXPECT_EQ(written.mode, TextureMode::Multiply);
        EXPECT_EQ(written.wrap, TextureWrap::Mirror);
        const auto picture = client_.loadTexture(written.file, TextureDecoding::Linear);
        ASSERT_TRUE(picture) << picture.error().text();
        ASSERT_EQ((*picture)->format, TexelFormat::Color8);
        const auto number = [&](std::size_t texel, std::size_t channel) {
            return std::to_integer<int>((*picture)->bytes[texel * 4 + channel]) / 255.0;
        };
        const std::array<double, 4> roots{0.8, 1.0, 0.5, 0.2}; // rows go up
        for (std::size_t texel = 0; texel < roots.size(); ++texel) {
            EXPECT_NEAR(number(texel, 1), roots[texel], 0.6 / 255.0);
            EXPECT_EQ(number(texel, 2), 1.0) << "all is metal";
        }
    }
}

/// Returns a material of a metalness and a width that have images.
Material chipped(const std::string& metalness, const std::string& width) {
    Material paint = looking("metallic-roughness",
                             {"diffuse.color=0.8,0.5,0.1", "metalness=0.5", "roughness=0.25"});
    for (const auto& [key, file] : {std::pair("metalness", metalness), {"roughness", width}}) {
        paint.textures[key] = textureUse(key, file);
        paint.textures[key].mode = TextureMode::Multiply;
    }
    return paint;
}

TEST_F(ExportedMaterial, ShareOfMetal_ComesBackAsItWas) {
    const Material alloy =
        looking("metallic-roughness", {"diffuse.color=0.8,0.5,0.1", "f0=0.04,0.04,0.04",
                                       "metalness=0.375", "roughness=0.25"});
    const std::vector<ExportLine> lines = write(alloy, "alloy.gltf");
    EXPECT_TRUE(isAllExact(lines)) << exportText(lines);
    EXPECT_EQ(textOf(read("alloy.gltf")), textOf(alloy));
}

/// glTF has both in one image: the roots of the widths in green, the metalness in blue.
TEST_F(ExportedMaterial, ImagesOfMetalnessAndRoughness_BecomeOne) {
    ASSERT_TRUE(client_.saveImage(folder_ / "bare.png",
                                  Image{2, 2, 3, {0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1}}));
    ASSERT_TRUE(client_.saveImage(folder_ / "worn.exr", Image{1, 1, 3, {0.25f, 0, 0}}));
    const std::vector<ExportLine> lines =
        write(chipped(folder_ / "bare.png", folder_ / "worn.exr"), "paint.gltf");
    EXPECT_TRUE(isAllExact(lines)) << exportText(lines);
    const Material back = read("paint.gltf");
    EXPECT_EQ(back.model.id, "metallic-roughness");
    EXPECT_EQ(back.model.parameters.at("metalness"), Value(0.5));
    EXPECT_EQ(back.model.parameters.at("roughness"), Value(0.25));
    const TextureUse& packed = back.textures.at("metalness");
    EXPECT_EQ(packed.channel, TextureChannel::Blue);
    EXPECT_EQ(packed.file, back.textures.at("roughness").file);
    const auto picture = client_.loadTexture(packed.file, TextureDecoding::Linear);
    ASSERT_TRUE(picture) << picture.error().text();
    ASSERT_EQ((*picture)->levels.front().size, glm::ivec2(2, 2));
    for (std::size_t texel = 0; texel < 4; ++texel) {
        EXPECT_NEAR(std::to_integer<int>((*picture)->bytes[texel * 4 + 1]), 127.5, 0.6)
            << "the root of 1/4";
        EXPECT_EQ(std::to_integer<int>((*picture)->bytes[texel * 4 + 2]), texel % 2 == 1 ? 255 : 0);
    }
    write(back, "again.gltf");
    EXPECT_EQ(readFile(folder_ / "again-images" / std::filesystem::path(packed.file).filename()),
              readFile(packed.file))
        << "one of glTF's own is taken as it is";
}

TEST_F(ExportedMaterial, ImageOfMetalnessThatLiesOtherwise_IsToldToBeDropped) {
    for (const char* name : {"bare.png", "worn.png"}) {
        ASSERT_TRUE(client_.saveImage(folder_ / name, Image{1, 1, 3, {1, 1, 1}}));
    }
    Material paint = chipped(folder_ / "bare.png", folder_ / "worn.png");
    paint.textures["metalness"].scale = {2.0, 2.0};
    const std::vector<ExportLine> lines = write(paint, "paint.gltf");
    EXPECT_NE(exportText(lines).find("dropped       Image bare.png: lies otherwise"),
              std::string::npos)
        << exportText(lines);
    EXPECT_FALSE(read("paint.gltf").textures.contains("metalness"));
}

TEST_F(ExportedMaterial, MaterialX_TakesChannelsOfAPackedImage) {
    ASSERT_TRUE(client_.saveImage(folder_ / "packed.png", Image{1, 1, 3, {1, 0.5f, 0.25f}}));
    Material paint = chipped(folder_ / "packed.png", folder_ / "packed.png");
    paint.textures["metalness"].channel = TextureChannel::Blue;
    paint.textures["roughness"].channel = TextureChannel::Green;
    paint.textures["roughness"].colorSpace = TextureColorSpace::Roots;
    write(paint, "paint.mtlx");
    const std::string text = readFile(folder_ / "paint.mtlx");
    for (const char* part :
         {"name=\"index\" type=\"integer\" value=\"1\"",
          "name=\"index\" type=\"integer\" value=\"2\"",
          "name=\"base_metalness\" type=\"float\" nodename=\"paint_metalness_product\"",
          "name=\"specular_roughness\" type=\"float\" nodename=\"paint_alpha_product\""}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
    }
}

TEST_F(ExportedMaterial, MaterialX_NamesItsSurfaceAndItsImages) {
    writeFile(folder_ / "wood.png", "an image");
    Material wood = looking("dielectric", {"diffuse.color=0.5,0.25,0.125", "roughness=0.25"});
    wood.textures["diffuse.color"] = textureUse("diffuse.color", folder_ / "wood.png");
    wood.textures["diffuse.color"].mode = TextureMode::Multiply;
    write(wood, "wood.mtlx");
    const std::string text = readFile(folder_ / "wood.mtlx");
    for (const char* part :
         {"<open_pbr_surface name=\"paint_surface\"", "value=\"wood-images/wood.png\"",
          "name=\"in2\" type=\"color3\" value=\"0.5, 0.25, 0.125\"",
          "name=\"specular_roughness\" type=\"float\" value=\"0.5\"",
          "name=\"base_color\" type=\"color3\" nodename=\"paint_diffuse_product\"",
          "name=\"specular_ior\" type=\"float\" value=\"1.5\""}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
    }
}

TEST_F(ExportedMaterial, MaterialX_MixesAnImageOfHalfStrengthWithWhite) {
    writeFile(folder_ / "wood.png", "an image");
    Material wood = looking("matte", {"diffuse.color=0.5,0.25,0.125"});
    TextureUse& image = wood.textures["diffuse.color"];
    image = textureUse("diffuse.color", folder_ / "wood.png");
    image.mode = TextureMode::Multiply;
    image.strength = 0.5;
    EXPECT_TRUE(isAllExact(write(wood, "wood.mtlx")));
    const std::string text = readFile(folder_ / "wood.mtlx");
    for (const char* part : {"name=\"bg\" type=\"color3\" value=\"1, 1, 1\"",
                             "name=\"mix\" type=\"float\" value=\"0.5\"",
                             "name=\"in1\" type=\"color3\" nodename=\"paint_diffuse_mix\""}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
    }
}

TEST_F(ExportedMaterial, MaterialX_HasARoughMatteBaseAsItIs) {
    const Material clay = looking("rough-matte", {"diffuse.color=0.5,0.25,0.125", "roughness=0.5"});
    EXPECT_TRUE(isAllExact(write(clay, "clay.mtlx")));
    const std::string text = readFile(folder_ / "clay.mtlx");
    for (const char* part : {"name=\"base_diffuse_roughness\" type=\"float\" value=\"0.5\"",
                             "name=\"specular_weight\" type=\"float\" value=\"0\""}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
    }
}

/// The paper's own short form is not EON, but nearer to it than Lambert's.
TEST_F(ExportedMaterial, OtherFormOfARoughMatteBase_IsFittedToIt) {
    const Material clay = looking("rough-matte", {"form=full", "roughness=0.5"});
    const std::vector<ExportLine> lines = write(clay, "clay.mtlx");
    ASSERT_FALSE(lines.empty());
    EXPECT_TRUE(lines.front().how.starts_with(
        "has no counterpart as it is set; rough-matte was fitted to it, "))
        << lines.front().how;
}

TEST_F(ExportedMaterial, WhatGltfHasNoWordFor_ComesBackAsItWas) {
    for (const char* preset : {"oren-nayar/wet-clay", "toon/bark", "cook-torrance/gold",
                               "ward/brushed-steel", "minnaert/velvet"}) {
        const std::filesystem::path file =
            shipped("presets/" + std::string(preset) + ".patina.json");
        if (!std::filesystem::exists(file)) {
            ADD_FAILURE() << file;
            continue;
        }
        const auto before = readPreset(file, blocks());
        ASSERT_TRUE(before);
        write(before->material, "any.gltf");
        Material back = readOwn("any.gltf");
        for (auto& [key, use] : back.textures) {
            EXPECT_EQ(readFile(use.file), readFile(before->material.textures.at(key).file));
            use.file = before->material.textures.at(key).file;
        }
        EXPECT_EQ(textOf(back), textOf(before->material));
    }
}

TEST_F(ExportedMaterial, PresetWhoseFactorsWereChanged_GivesWayToThem) {
    write(looking("metal", {"fresnel.f0=0.9,0.61,0.23", "roughness=0.25", "gloss=0.5"}),
          "gold.gltf");
    auto document = nlohmann::json::parse(readFile(folder_ / "gold.gltf"));
    document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 0.25, 0.125, 1.0};
    writeFile(folder_ / "gold.gltf", document.dump());
    const Material back = readOwn("gold.gltf");
    EXPECT_EQ(back.part("fresnel")->parameters.at("f0"), Value(glm::dvec3(0.5, 0.25, 0.125)));
    EXPECT_EQ(back.model.parameters.at("gloss"), Value(1.0));
}

TEST_F(ExportedMaterial, PresetWhoseImagesWereChanged_GivesWayToThem) {
    for (const char* name : {"red.png", "blue.png"}) {
        ASSERT_TRUE(client_.saveImage(folder_ / name, Image{1, 1, 3, {1, 1, 1}}));
    }
    Material wood = looking("dielectric", {"gloss=0.5"});
    wood.textures["diffuse.color"] = textureUse("diffuse.color", folder_ / "red.png");
    write(wood, "wood.gltf");
    EXPECT_EQ(readOwn("wood.gltf").model.parameters.at("gloss"), Value(0.5));
    auto document = nlohmann::json::parse(readFile(folder_ / "wood.gltf"));
    document["images"][0]["uri"] = "blue%2epng";
    writeFile(folder_ / "wood.gltf", document.dump());
    const Material back = readOwn("wood.gltf");
    EXPECT_EQ(back.model.parameters.at("gloss"), Value(1.0));
    EXPECT_EQ(back.textures.at("diffuse.color").file, (folder_ / "blue.png").generic_string());
}

TEST_F(ExportedMaterial, ImageThatCannotBeWritten_LeavesTheValue) {
    Material steel = looking("metallic-roughness", {"metalness=0.25", "roughness=0.25"});
    for (const char* key : {"metalness", "roughness", "diffuse.color"}) {
        steel.textures[key] = textureUse(key, folder_ / "not-there.png");
    }
    steel.model.parameters["diffuse.color"] = glm::dvec3(0.5);
    write(steel, "steel.gltf");
    const Material back = read("steel.gltf");
    EXPECT_EQ(back.model.parameters.at("metalness"), Value(0.25));
    EXPECT_EQ(back.model.parameters.at("roughness"), Value(0.25));
    EXPECT_EQ(back.model.parameters.at("diffuse.color"), Value(glm::dvec3(0.5)));
}

/// But not where an extension names a texture, whose number is that of another file.
TEST_F(ExportedMaterial, WhatOnlyOtherProgramsKnow_IsWrittenBack) {
    write(looking("metal", {"roughness=0.25"}), "gold.gltf");
    auto document = nlohmann::json::parse(readFile(folder_ / "gold.gltf"));
    auto& material = document["materials"][0];
    material["extras"]["studio"] = {{"shelf", 3}};
    material["extensions"]["EXT_of_a_studio"] = {{"wear", 0.25}};
    material["extensions"]["EXT_with_an_image"] = {{"map", {{"index", 7}}}};
    document["extensionsUsed"] = {"EXT_of_a_studio", "EXT_with_an_image"};
    writeFile(folder_ / "gold.gltf", document.dump());
    MeshRequest request;
    request.file = folder_ / "gold.gltf";
    request.byMaterial = true;
    const auto mesh = client_.loadMesh(request);
    ASSERT_TRUE(mesh) << mesh.error().text();
    const auto back = materialOf((*mesh)->parts().front().material, blocks());
    ASSERT_TRUE(back);
    write(*back, "again.gltf");
    const auto again = nlohmann::json::parse(readFile(folder_ / "again.gltf"));
    const auto& written = again["materials"][0];
    EXPECT_EQ(written["extras"]["studio"], (nlohmann::json{{"shelf", 3}}));
    EXPECT_EQ(written["extensions"]["EXT_of_a_studio"], (nlohmann::json{{"wear", 0.25}}));
    EXPECT_FALSE(written["extensions"].contains("EXT_with_an_image"));
    EXPECT_EQ(again["extensionsUsed"], nlohmann::json::array({"EXT_of_a_studio"}));
}

TEST(MaterialExportCommand, EachPreset_IsToldLineByLine) {
    const TemporaryFolder folder;
    const Outcome outcome = patina(
        {"export", shipped("presets/lambert/grey-card.patina.json"), "-o", folder / "card.mtl"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("  exact         Diffuse colour: Kd"), std::string::npos)
        << outcome.out;
    EXPECT_TRUE(std::filesystem::exists(folder / "card.mtl"));
}

} // namespace
} // namespace patina::tests::material_export_test
