// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex colours in the formats that have them: all become linear light.
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "core/color.h"
#include "glb_writer.h"
#include "mesh_files.h"

namespace patina::tests::vertex_colors_test {
namespace {

constexpr double step = 1.0 / 65535.0; // colours are whole numbers of these

/// The colour and the alpha at the vertex of this place; -1 where there is none.
glm::dvec4 colorAt(const MeshView& mesh, const glm::vec3& place) {
    for (std::size_t i = 0; i < mesh.colors.size(); ++i) {
        const VertexColor& color = mesh.colors[i];
        if (mesh.vertices[i].position == place) {
            return {1.0 - step * color.red, 1.0 - step * color.green, 1.0 - step * color.blue,
                    step * color.alpha};
        }
    }
    return glm::dvec4(-1.0);
}

void expectColor(const LoadedMesh& mesh, const glm::vec3& place, const glm::dvec4& expected) {
    ASSERT_TRUE(mesh) << mesh.error().text();
    const glm::dvec4 color = colorAt((*mesh)->view(), place);
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(color[i], expected[i], step) << i;
    }
}

glm::dvec4 ofScreen(const glm::dvec3& shown, double alpha = 1.0) {
    return {srgbDecoded(shown), alpha};
}

constexpr const char* coloredObj = "v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0 0 0 0.25\nf 1 2 3\n";

TEST(VertexColors, Obj_AreTakenForWhatAScreenShows) {
    const auto mesh = loaded("colors.obj", coloredObj);
    expectColor(mesh, {0, 0, 0}, ofScreen({1, 0, 0}));
    expectColor(mesh, {1, 0, 0}, ofScreen({0, 0.5, 0}));
    expectColor(mesh, {0, 1, 0}, ofScreen({0, 0, 0.25}));
}

TEST(VertexColors, ObjWithNormals_KeepsThemAtTheirCorners) {
    std::string text = coloredObj;
    text.replace(text.find("f 1 2 3"), 7, "vn 0 0 1\nf 1//1 2//1 3//1");
    expectColor(loaded("colors.obj", text), {1, 0, 0}, ofScreen({0, 0.5, 0}));
}

/// Goes to the other reader of OBJ files.
TEST(VertexColors, ObjWithAQuad_AreRead) {
    const auto mesh = loaded("quad.obj", "v 0 0 0 1 1 1\nv 1 0 0 0 0.5 0\nv 1 1 0 0 0 1\n"
                                         "v 0 1 0 1 0 0\nf 1 2 3 4\n");
    expectColor(mesh, {1, 0, 0}, ofScreen({0, 0.5, 0}));
    expectColor(mesh, {0, 0, 0}, ofScreen({1, 1, 1}));
}

TEST(VertexColors, PlyOfBytes_AreTakenForWhatAScreenShows) {
    const auto mesh =
        loaded("colors.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                             "property float y\nproperty float z\nproperty uchar red\n"
                             "property uchar green\nproperty uchar blue\nelement face 1\n"
                             "property list uchar int vertex_indices\nend_header\n"
                             "0 0 0 255 0 0\n1 0 0 0 51 0\n0 1 0 0 0 102\n3 0 1 2\n");
    expectColor(mesh, {0, 0, 0}, ofScreen({1, 0, 0}));
    expectColor(mesh, {1, 0, 0}, ofScreen({0, 0.2, 0}));
    expectColor(mesh, {0, 1, 0}, ofScreen({0, 0, 0.4}));
}

GlbWriter triangleGlb() {
    GlbWriter glb;
    const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
    glb.primitive()["attributes"]["POSITION"] =
        glb.addAccessor(glb.addView(corners), 5126, "VEC3", 3);
    return glb;
}

TEST(VertexColors, Gltf_AreLinearLight) {
    GlbWriter glb = triangleGlb();
    const std::vector<float> colors{1, 0.25f, 0, 0, 0.5f, 0, 0, 0, 0.125f};
    glb.primitive()["attributes"]["COLOR_0"] =
        glb.addAccessor(glb.addView(colors), 5126, "VEC3", 3);
    const auto mesh = loaded("colors.glb", glb.bytes());
    expectColor(mesh, {0, 0, 0}, {1.0, 0.25, 0.0, 1.0});
    expectColor(mesh, {0, 1, 0}, {0.0, 0.0, 0.125, 1.0});
}

TEST(VertexColors, GltfOfNormalizedNumbersWithAlpha_KeepsTheAlpha) {
    GlbWriter glb = triangleGlb();
    const std::vector<std::uint16_t> colors{65535, 0, 0, 32768, 0, 65535, 0, 0, 0, 0, 16384, 65535};
    const int accessor = glb.addAccessor(glb.addView(colors), 5123, "VEC4", 3);
    glb.document["accessors"][accessor]["normalized"] = true;
    glb.primitive()["attributes"]["COLOR_0"] = accessor;
    const auto mesh = loaded("colors.glb", glb.bytes());
    expectColor(mesh, {0, 0, 0}, {1.0, 0.0, 0.0, 32768 * step});
    expectColor(mesh, {1, 0, 0}, {0.0, 1.0, 0.0, 0.0});
    expectColor(mesh, {0, 1, 0}, {0.0, 0.0, 16384 * step, 1.0});
}

/// glTF 2.0, section 3.9.2: the base colour is multiplied with them.
TEST(VertexColors, GltfMaterial_HasThemOnItsColour) {
    GlbWriter glb = triangleGlb();
    const std::vector<float> colors{1, 0, 0, 0, 1, 0, 0, 0, 1};
    glb.primitive()["attributes"]["COLOR_0"] =
        glb.addAccessor(glb.addView(colors), 5126, "VEC3", 3);
    glb.document["materials"] = {
        {{"name", "Paint"}, {"pbrMetallicRoughness", {{"metallicFactor", 0.0}}}}};
    glb.primitive()["material"] = 0;
    MeshRequest apart;
    apart.byMaterial = true;
    const auto mesh = loaded("colors.glb", glb.bytes(), apart);
    ASSERT_TRUE(mesh) << mesh.error().text();
    const auto& images = (*mesh)->parts().front().material.images;
    ASSERT_TRUE(images.contains("diffuse"));
    EXPECT_EQ(images.at("diffuse"), vertexColorsName);
}

/// Exporters write white ones, and one of a car's parts may be the only one with others.
TEST(VertexColors, GltfMaterialOfWhiteVertices_HasNone) {
    GlbWriter glb = triangleGlb();
    glb.primitive()["attributes"]["COLOR_0"] =
        glb.addAccessor(glb.addView(std::vector<float>(9, 1.0f)), 5126, "VEC3", 3);
    glb.document["materials"].push_back({{"name", "Paint"}});
    glb.primitive()["material"] = 0;
    MeshRequest apart;
    apart.byMaterial = true;
    const auto mesh = loaded("colors.glb", glb.bytes(), apart);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_TRUE((*mesh)->parts().front().material.images.empty());
}

TEST(VertexColors, GltfMaterialWithAnImage_LeavesThemOutAndSaysSo) {
    const TemporaryFolder folder;
    GlbWriter glb = triangleGlb();
    const std::vector<float> colors{1, 0, 0, 0, 1, 0, 0, 0, 1};
    glb.primitive()["attributes"]["COLOR_0"] =
        glb.addAccessor(glb.addView(colors), 5126, "VEC3", 3);
    glb.document["images"].push_back({{"uri", "paint.png"}});
    glb.document["textures"].push_back({{"source", 0}});
    glb.document["materials"] = {
        {{"name", "Paint"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    glb.primitive()["material"] = 0;
    writeFile(folder / "paint.png", "only its name matters");
    writeFile(folder / "colors.glb", glb.bytes());
    MeshRequest apart;
    apart.file = folder / "colors.glb";
    apart.byMaterial = true;
    AssetClient client;
    const auto mesh = client.loadMesh(apart);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->remarks(), "not read: 1 set of vertex colours under an image (Paint)");
}

TEST(VertexColors, WhiteMesh_HasNone) {
    const auto plain = loaded("plain.obj", squareObj);
    ASSERT_TRUE(plain) << plain.error().text();
    EXPECT_TRUE((*plain)->view().colors.empty());
    const auto white =
        loaded("white.obj", "v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nf 1 2 3\n");
    ASSERT_TRUE(white) << white.error().text();
    EXPECT_TRUE((*white)->view().colors.empty());
}

TEST(VertexColors, WrongNumbers_AreWhiteOrTheNearestThatIsRight) {
    const auto mesh = loaded("odd.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"
                                        "property float x\nproperty float y\nproperty float z\n"
                                        "property float red\nproperty float green\n"
                                        "property float blue\nelement face 1\n"
                                        "property list uchar int vertex_indices\nend_header\n"
                                        "0 0 0 nan 0 0\n1 0 0 -3 7 0\n0 1 0 0 0 0\n3 0 1 2\n");
    expectColor(mesh, {1, 0, 0}, {0.0, 1.0, 0.0, 1.0});
    expectColor(mesh, {0, 1, 0}, {0.0, 0.0, 0.0, 1.0});
    ASSERT_TRUE(mesh);
    EXPECT_TRUE(std::isfinite(colorAt((*mesh)->view(), {0, 0, 0}).x));
}

TEST(VertexColors, Parts_HaveTheirOwn) {
    const std::string text = "v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nv 0 0 1 1 0 0\n"
                             "v 1 0 1 0 1 0\nv 0 1 1 0 0 1\nusemtl white\nf 1 2 3\n"
                             "usemtl painted\nf 4 5 6\n";
    MeshRequest apart;
    apart.byMaterial = true;
    const auto mesh = loaded("parts.obj", text, apart);
    ASSERT_TRUE(mesh) << mesh.error().text();
    std::map<std::string, std::size_t> colors;
    for (const MeshPartView& part : (*mesh)->parts()) {
        colors[part.material.name] = part.view.colors.size();
    }
    EXPECT_EQ(colors, (std::map<std::string, std::size_t>{{"painted", 3}, {"white", 0}}));
}

/// The two corners at one place are two vertices, since they differ in colour.
TEST(VertexColors, CornersOfOnePlaceAndTwoColours_StayApart) {
    const auto mesh = loaded("edge.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\n"
                                         "v 1 0 0 0 0 1\nv 0 1 0 0 0 1\nv 1 1 0 0 0 1\n"
                                         "f 1 2 3\nf 4 6 5\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().vertices.size(), 6u);
}

} // namespace
} // namespace patina::tests::vertex_colors_test
