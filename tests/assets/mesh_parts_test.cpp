// SPDX-License-Identifier: GPL-3.0-or-later
// How a mesh file is taken apart by its materials, and what is said of them.

#include <gtest/gtest.h>

#include "core/color.h"
#include "glb_writer.h"
#include "mesh_files.h"

namespace patina::tests::mesh_parts_test {
namespace {

/// Has a square of each of two materials that share an edge, and a triangle of none before them.
constexpr const char* twoSquares = "mtllib look.mtl\n"
                                   "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                                   "usemtl paint\nf 1 2 3 4\nusemtl cloth\nf 2 5 6 3\n"
                                   "usemtl paint\nf 1 2 3\n";
constexpr const char* looks = "newmtl paint\nKd 0.5 0.25 0\nKs 0.5 0.5 0.5\nNs 40\nillum 2\n"
                              "map_Kd wood.png\nd 0.5\n"
                              "newmtl cloth\nKd 1 0 0\nillum 1\n";

class MeshInParts : public testing::Test {
  protected:
    LoadedMesh load(const std::string& name, const std::string& content) {
        writeFile(folder_ / name, content);
        MeshRequest request;
        request.file = folder_ / name;
        request.byMaterial = true;
        return client_.loadMesh(request);
    }

    std::string at(const std::string& name) { return (folder_ / name).generic_string(); }

    TemporaryFolder folder_;
    AssetClient client_;
};

TEST_F(MeshInParts, Obj_HasAPartForEachMaterialByItsFirstUse) {
    writeFile(at("look.mtl"), looks);
    const auto mesh = load("two.obj", twoSquares);
    ASSERT_TRUE(mesh) << mesh.error().text();
    const auto& parts = (*mesh)->parts();
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].material.name, "paint");
    EXPECT_EQ(parts[0].view.indices.size(), 9u);
    EXPECT_EQ(parts[0].view.vertices.size(), 4u);
    EXPECT_EQ(parts[1].material.name, "cloth");
    EXPECT_EQ(parts[1].view.indices.size(), 6u);
    EXPECT_EQ(parts[1].view.bounds.lower.x, 1.0f);
}

TEST_F(MeshInParts, Mtl_SaysHowItLooks) {
    writeFile(at("look.mtl"), looks);
    writeFile(at("wood.png"), "only its name matters");
    const auto mesh = load("two.obj", twoSquares);
    ASSERT_TRUE(mesh) << mesh.error().text();
    const MeshMaterial& paint = (*mesh)->parts()[0].material;
    EXPECT_EQ(paint.look, "blinn-phong");
    EXPECT_NEAR(paint.values.at("diffuse").x, srgbDecoded(0.5), 1e-6);
    EXPECT_NEAR(paint.values.at("specular").y, srgbDecoded(0.5), 1e-6);
    EXPECT_EQ(paint.values.at("shininess").x, 40.0);
    EXPECT_EQ(paint.values.at("opacity").x, 0.5);
    EXPECT_EQ(paint.images.at("diffuse"), at("wood.png"));
    EXPECT_EQ((*mesh)->parts()[1].material.look, "matte");
}

TEST_F(MeshInParts, ObjWithoutItsMtl_KeepsTheNames) {
    const auto mesh = load("two.obj", twoSquares);
    ASSERT_TRUE(mesh) << mesh.error().text();
    ASSERT_EQ((*mesh)->parts().size(), 2u);
    EXPECT_EQ((*mesh)->parts()[1].material.name, "cloth");
}

TEST_F(MeshInParts, ImageOfAnotherMachine_IsFoundBesideTheMesh) {
    writeFile(at("look.mtl"), "newmtl paint\nKd 1 1 1\nmap_Kd C:\\art\\wood.png\n");
    writeFile(at("wood.png"), "only its name matters");
    const auto mesh = load("two.obj", twoSquares);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->parts()[0].material.images.at("diffuse"), at("wood.png"));
}

TEST_F(MeshInParts, ImageOutsideTheFolder_IsNotNamed) {
    const TemporaryFolder other;
    writeFile(other / "secret.png", "outside");
    writeFile(at("look.mtl"),
              "newmtl paint\nKd 1 1 1\nmap_Kd " + (other / "secret.png").string() + "\n");
    const auto mesh = load("two.obj", twoSquares);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_TRUE((*mesh)->parts()[0].material.images.empty());
}

TEST_F(MeshInParts, Normals_AreSmoothAcrossTheEdgeOfTwoParts) {
    const auto mesh = load("roof.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 1\nv 1 2 0\nv 0 2 0\n"
                                       "usemtl a\nf 1 2 3 4\nusemtl b\nf 4 3 5 6\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    ASSERT_EQ((*mesh)->parts().size(), 2u);
    for (const MeshPartView& part : (*mesh)->parts()) {
        for (const Vertex& vertex : part.view.vertices) {
            if (vertex.position.z == 1.0f) {
                // The weights by angle are as rough as that.
                EXPECT_NEAR(vertex.normal.y, 0.0f, 7e-5f) << part.material.name;
            }
        }
    }
}

TEST_F(MeshInParts, Fitted_KeepTheirPlacesInTheWhole) {
    writeFile(at("two.obj"), twoSquares);
    MeshRequest request;
    request.file = at("two.obj");
    request.fitUnitBox = true;
    request.byMaterial = true;
    const auto mesh = client_.loadMesh(request);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->parts()[0].view.bounds.lower.x, -1.0f);
    EXPECT_EQ((*mesh)->parts()[0].view.bounds.upper.x, 0.0f);
    EXPECT_EQ((*mesh)->parts()[1].view.bounds.upper.x, 1.0f);
}

TEST_F(MeshInParts, NotAskedFor_IsOnePart) {
    const auto mesh = loaded("two.obj", twoSquares);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->parts().size(), 1u);
    EXPECT_EQ((*mesh)->view().indices.size(), 15u);
}

TEST_F(MeshInParts, ThousandMaterials_AreAtMost256Parts) {
    std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 1000; ++i) {
        obj += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
    }
    const auto mesh = load("many.obj", obj);
    ASSERT_TRUE(mesh) << mesh.error().text();
    ASSERT_EQ((*mesh)->parts().size(), 256u);
    EXPECT_EQ((*mesh)->parts().back().view.indices.size(), 3u * 745u);
}

/// Has a triangle of a metal, one of a dielectric and one without a material.
constexpr const char* threeLooks = R"({"asset": {"version": "2.0"},
 "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [
   {"attributes": {"POSITION": 0}, "material": 1},
   {"attributes": {"POSITION": 0}, "material": 0},
   {"attributes": {"POSITION": 0}}]}],
 "materials": [
   {"name": "same", "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.5],
     "metallicFactor": 0, "roughnessFactor": 0.5, "baseColorTexture": {"index": 0}},
     "alphaMode": "BLEND"},
   {"name": "same", "pbrMetallicRoughness": {"baseColorFactor": [1, 0.8, 0.3, 1]}}],
 "textures": [{"source": 0}], "images": [{"uri": "skin.png"}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri": "triangle.bin"}]})";

TEST_F(MeshInParts, Gltf_HasMetalsAndDielectricsUnderNamesOfTheirOwn) {
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    writeFile(at("triangle.bin"),
              std::string(reinterpret_cast<const char*>(corners), sizeof corners));
    writeFile(at("skin.png"), "only its name matters");
    const auto mesh = load("three.gltf", threeLooks);
    ASSERT_TRUE(mesh) << mesh.error().text();
    const auto& parts = (*mesh)->parts();
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_EQ(parts[0].material.name, "same 2");
    EXPECT_EQ(parts[0].material.look, "metal");
    EXPECT_NEAR(parts[0].material.values.at("f0").y, 0.8, 1e-6);
    EXPECT_EQ(parts[1].material.name, "same");
    EXPECT_EQ(parts[1].material.look, "dielectric");
    EXPECT_NEAR(parts[1].material.values.at("alpha").x, 0.25, 1e-6);
    EXPECT_EQ(parts[1].material.values.at("opacity").x, 0.5);
    EXPECT_EQ(parts[1].material.images.at("diffuse"), at("skin.png"));
    EXPECT_EQ(parts[2].material.name, "No material");
    EXPECT_TRUE(parts[2].material.look.empty());
}

TEST_F(MeshInParts, ImagesThatAreNotThere_AreToldByName) {
    writeFile(at("look.mtl"), "newmtl paint\nKd 1 1 1\nmap_Kd art\\nope.png\n");
    const auto mesh = load("two.obj", twoSquares);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_NE((*mesh)->remarks().find("1 image that is not in the folder (nope.png)"),
              std::string::npos)
        << (*mesh)->remarks();
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    writeFile(at("triangle.bin"),
              std::string(reinterpret_cast<const char*>(corners), sizeof corners));
    const auto gltf = load("three.gltf", threeLooks); // names skin.png
    ASSERT_TRUE(gltf) << gltf.error().text();
    EXPECT_NE((*gltf)->remarks().find("1 image that is not in the folder (skin.png)"),
              std::string::npos)
        << (*gltf)->remarks();
}

/// Has one material whose image is turned by 30 degrees with two scales and goes on in two ways,
/// and whose highlight is longer than ten times its width.
constexpr const char* whatIsCut = R"({"asset": {"version": "2.0"},
 "extensionsUsed": ["KHR_materials_anisotropy", "KHR_texture_transform"],
 "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
 "materials": [
   {"name": "steel", "pbrMetallicRoughness": {"roughnessFactor": 0.1, "baseColorTexture":
     {"index": 0, "extensions": {"KHR_texture_transform": {"rotation": 0.5236, "scale": [2, 3]}}}},
    "extensions": {"KHR_materials_anisotropy": {"anisotropyStrength": 1}}}],
 "textures": [{"source": 0, "sampler": 0}], "images": [{"uri": "skin.png"}],
 "samplers": [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri": "triangle.bin"}]})";

TEST_F(MeshInParts, GltfThatSaysMoreThanAModelHas_IsToldByName) {
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    writeFile(at("triangle.bin"),
              std::string(reinterpret_cast<const char*>(corners), sizeof corners));
    writeFile(at("skin.png"), "only its name matters");
    const auto mesh = load("cut.gltf", whatIsCut);
    ASSERT_TRUE(mesh) << mesh.error().text();
    const std::string remarks = (*mesh)->remarks();
    for (const char* told : {"1 shear of an image (steel)", "1 second edge of an image (steel)",
                             "1 part of an anisotropy that is too strong (steel)"}) {
        EXPECT_NE(remarks.find(told), std::string::npos) << remarks;
    }
    const MeshMaterial& material = (*mesh)->parts().front().material;
    EXPECT_EQ(material.look, "grained-metal");
    EXPECT_EQ(material.values.at("anisotropy").x, 1.0);
    EXPECT_NEAR(material.values.at("alpha").x, 0.1, 1e-9) << "the mean of 1 and 0.01";
    EXPECT_EQ(material.values.at("f0.wrap").x, 1.0);
    EXPECT_EQ(material.values.at("f0.nearest").x, 1.0);
}

/// An image of a buffer and one of a data URI; what is no PNG or JPEG is told.
TEST_F(MeshInParts, GltfWithImagesInside_HasThemAsDataUris) {
    GlbWriter glb;
    const int corners = glb.addView<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
    glb.primitive()["attributes"]["POSITION"] = glb.addAccessor(corners, 5126, "VEC3", 3);
    glb.primitive()["material"] = 0;
    const std::string png = "\x89PNG\r\n\x1a\nand more";
    const int bytes = glb.addView(std::vector<char>(png.begin(), png.end()));
    glb.document["images"] = {{{"bufferView", bytes}, {"mimeType", "image/png"}},
                              {{"uri", "data:image/jpeg;base64,/9j/"}},
                              {{"uri", "data:image/png;base64,R0lG"}, {"name", "moving"}}};
    glb.document["textures"] = {{{"source", 0}}, {{"source", 1}}, {{"source", 2}}};
    glb.document["materials"] = {
        {{"name", "paint"},
         {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"baseColorTexture", {{"index", 0}}}}},
         {"normalTexture", {{"index", 1}}},
         {"emissiveTexture", {{"index", 2}}}}};
    const auto mesh = load("inside.glb", glb.bytes());
    ASSERT_TRUE(mesh) << mesh.error().text();
    const auto& images = (*mesh)->parts().front().material.images;
    ASSERT_EQ(images.size(), 2u);
    EXPECT_EQ(images.at("diffuse"), "data:image/png;base64,iVBORw0KGgphbmQgbW9yZQ==");
    EXPECT_EQ(images.at("normal"), "data:image/jpeg;base64,/9j/");
    EXPECT_EQ((*mesh)->remarks(), "not read: 1 image (glow of moving)");
}

} // namespace
} // namespace patina::tests::mesh_parts_test
