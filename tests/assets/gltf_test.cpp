// SPDX-License-Identifier: GPL-3.0-or-later
// glTF as artists have it. Every file is made here, with the libraries that define the formats.
#include <cmath>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "glb_writer.h"
#include "mesh_files.h"

namespace patina::tests::gltf_test {
namespace {

constexpr int byteType = 5120;
constexpr int unsignedShortType = 5123;
constexpr int floatType = 5126;
constexpr float tolerance = 1e-6f; // a few roundings of numbers near one

const std::vector<float> corners{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<std::uint16_t> square{0, 1, 2, 0, 2, 3};

/// A square of side one in the plane z = 0, facing +z.
GlbWriter squareGlb() {
    GlbWriter glb;
    const int positions = glb.addAccessor(glb.addView(corners), floatType, "VEC3", 4);
    glb.primitive()["attributes"]["POSITION"] = positions;
    glb.primitive()["indices"] =
        glb.addAccessor(glb.addView(square), unsignedShortType, "SCALAR", 6);
    return glb;
}

LoadedMesh loadedGlb(const GlbWriter& glb) {
    return loaded("made.glb", glb.bytes());
}

std::string complaint(const GlbWriter& glb) {
    return complaintAbout("made.glb", glb.bytes());
}

/// Expects a mesh in this box; where it lies proves how its positions were read.
void expectBox(const LoadedMesh& mesh, const glm::vec3& lower, const glm::vec3& upper) {
    ASSERT_TRUE(mesh) << mesh.error().text();
    const Bounds bounds = (*mesh)->view().bounds;
    EXPECT_LT(glm::distance(bounds.lower, lower), 1e-3f) << bounds.lower.x << " " << bounds.lower.y;
    EXPECT_LT(glm::distance(bounds.upper, upper), 1e-3f) << bounds.upper.x << " " << bounds.upper.y;
}

void expectFacing(const LoadedMesh& mesh, const glm::vec3& direction) {
    ASSERT_TRUE(mesh) << mesh.error().text();
    const MeshView view = (*mesh)->view();
    const auto at = [&](std::size_t k) { return view.vertices[view.indices[k]].position; };
    const glm::vec3 normal = glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
    EXPECT_GT(glm::dot(normal, direction), 1.0f - tolerance);
    EXPECT_GT(glm::dot(view.vertices[view.indices[0]].normal, direction), 1.0f - tolerance);
}

TEST(Gltf, Square_Loads) {
    expectBox(loadedGlb(squareGlb()), {0, 0, 0}, {1, 1, 0});
}

TEST(Gltf, WhatIsNotRead_IsToldByName) {
    GlbWriter glb = squareGlb();
    glb.document["cameras"] = nlohmann::json::parse(
        R"([{"name": "Front", "type": "orthographic",
             "orthographic": {"xmag": 1, "ymag": 1, "znear": 1, "zfar": 2}}])");
    glb.document["extensionsUsed"] = {"KHR_materials_sheen", "EXT_mesh_gpu_instancing"};
    glb.document["images"] = {{{"uri", "ao.png"}, {"name", "Occlusion"}}};
    glb.document["textures"] = {{{"source", 0}}};
    glb.document["materials"] = {{{"name", "Wall"},
                                  {"occlusionTexture", {{"index", 0}}},
                                  {"extras", {{"shader", "of another program"}}}}};
    EXPECT_EQ((*loadedGlb(glb))->remarks(),
              "not read: 1 camera (Front), 1 extension (EXT_mesh_gpu_instancing)");
    const TemporaryFolder folder;
    writeFile(folder / "made.glb", glb.bytes());
    MeshRequest apart{folder / "made.glb"};
    apart.byMaterial = true;
    EXPECT_TRUE((*AssetClient().loadMesh(apart))
                    ->remarks()
                    .ends_with(", 1 image (occlusion of ao.png), 1 extension of materials "
                               "(KHR_materials_sheen), 1 material's extras (Wall)"));
}

TEST(Gltf, BinaryOfVersionOne_SaysSo) {
    std::string bytes = squareGlb().bytes();
    bytes[4] = 1;
    EXPECT_EQ(complaintAbout("former.glb", bytes), "is binary glTF 1.0, which is not read here");
}

TEST(Gltf, BufferOutsideItsFolder_IsNotRead) {
    for (const char* uri : {"../../secret", "/etc/hostname", "a/../../secret", "%2E%2e/secret"}) {
        GlbWriter glb = squareGlb();
        glb.document["buffers"] = {nlohmann::json::object(), {{"uri", uri}, {"byteLength", 4}}};
        EXPECT_EQ(complaint(glb), "its buffer \"" + std::string(uri) +
                                      "\" lies outside its folder and is not read");
    }
}

TEST(Gltf, BufferInAFolderBelow_IsRead) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "below it");
    writeFile(folder / "below it/more.bin", "1234");
    GlbWriter glb = squareGlb();
    glb.document["buffers"] = {nlohmann::json::object(),
                               {{"uri", "below%20it/more.bin"}, {"byteLength", 4}}};
    writeFile(folder / "made.glb", glb.bytes());
    AssetClient client;
    const auto mesh = client.loadMesh({folder / "made.glb"});
    EXPECT_TRUE(mesh) << mesh.error().text();
}

TEST(Gltf, NodeWithTranslationRotationScale_AppliesThemInThatOrder) {
    GlbWriter glb = squareGlb();
    const double half = std::sqrt(0.5);
    glb.node()["translation"] = {10, 0, 0};
    glb.node()["rotation"] = {0, 0, half, half}; // a quarter turn from x to y
    glb.node()["scale"] = {2, 1, 1};
    expectBox(loadedGlb(glb), {9, 0, 0}, {10, 2, 0});
}

TEST(Gltf, NodeWithMatrix_AppliesItByColumns) {
    GlbWriter glb = squareGlb();
    glb.node()["matrix"] = {2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
    expectBox(loadedGlb(glb), {5, 6, 7}, {7, 9, 7});
}

TEST(Gltf, ChildNode_StandsInItsParent) {
    GlbWriter glb = squareGlb();
    glb.document["nodes"] = nlohmann::json::parse(
        R"([{"children": [1], "scale": [2, 2, 2]}, {"mesh": 0, "translation": [1, 0, 0]}])");
    expectBox(loadedGlb(glb), {2, 0, 0}, {4, 2, 0});
}

TEST(Gltf, MirroringNode_KeepsTheOutside) {
    GlbWriter glb = squareGlb();
    glb.node()["scale"] = {-1, 1, 1};
    expectFacing(loadedGlb(glb), {0, 0, 1});
}

TEST(Gltf, NodeWithScaleZero_SaysThatNothingIsLeft) {
    GlbWriter glb = squareGlb();
    glb.node()["scale"] = {0, 0, 0};
    EXPECT_NE(complaint(glb).find("none of its 2 triangles can be drawn"), std::string::npos);
}

TEST(Gltf, MeshInTwoNodes_IsThereTwice) {
    GlbWriter glb = squareGlb();
    glb.document["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 3}}});
    glb.document["scenes"][0]["nodes"].push_back(1);
    expectBox(loadedGlb(glb), {0, 0, 0}, {1, 1, 3});
}

TEST(Gltf, SeveralPrimitives_AreAllThere) {
    GlbWriter glb = squareGlb();
    nlohmann::json second = glb.primitive();
    const std::vector<float> above{0, 0, 5, 1, 0, 5, 1, 1, 5, 0, 1, 5};
    second["attributes"]["POSITION"] = glb.addAccessor(glb.addView(above), floatType, "VEC3", 4);
    glb.document["meshes"][0]["primitives"].push_back(second);
    expectBox(loadedGlb(glb), {0, 0, 0}, {1, 1, 5});
}

TEST(Gltf, TriangleStrip_FacesOneWay) {
    GlbWriter glb = squareGlb();
    const std::vector<std::uint16_t> strip{0, 1, 3, 2};
    glb.primitive()["mode"] = 5;
    glb.primitive()["indices"] =
        glb.addAccessor(glb.addView(strip), unsignedShortType, "SCALAR", strip.size());
    const auto mesh = loadedGlb(glb);
    ASSERT_TRUE(mesh) << mesh.error().text();
    expectFacing(mesh, {0, 0, 1});
    EXPECT_EQ((*mesh)->view().indices.size(), 6u);
    EXPECT_EQ((*mesh)->view().vertices.back().normal, glm::vec3(0, 0, 1));
}

TEST(Gltf, TriangleFan_FacesOneWay) {
    GlbWriter glb = squareGlb();
    const std::vector<std::uint16_t> fan{0, 1, 2, 3};
    glb.primitive()["mode"] = 6;
    glb.primitive()["indices"] =
        glb.addAccessor(glb.addView(fan), unsignedShortType, "SCALAR", fan.size());
    const auto mesh = loadedGlb(glb);
    ASSERT_TRUE(mesh) << mesh.error().text();
    expectFacing(mesh, {0, 0, 1});
    EXPECT_EQ((*mesh)->view().vertices.back().normal, glm::vec3(0, 0, 1));
}

TEST(Gltf, Points_SayThatThereAreNoFaces) {
    GlbWriter glb = squareGlb();
    glb.primitive()["mode"] = 0;
    EXPECT_EQ(complaint(glb), "has points or lines but no faces");
}

TEST(Gltf, WithoutIndices_TakesVerticesInOrder) {
    GlbWriter glb = squareGlb();
    glb.primitive().erase("indices");
    const auto mesh = loadedGlb(glb);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().indices.size(), 3u); // the fourth vertex makes no triangle
}

TEST(Gltf, SparseAccessor_ReplacesElements) {
    GlbWriter glb = squareGlb();
    const int places = glb.addView(std::vector<std::uint16_t>{2});
    const int values = glb.addView(std::vector<float>{4, 5, 6});
    glb.document["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", places}, {"componentType", unsignedShortType}}},
        {"values", {{"bufferView", values}}}};
    expectBox(loadedGlb(glb), {0, 0, 0}, {4, 5, 6});
}

TEST(Gltf, SparseAccessorWithoutBase_StartsFromZero) {
    GlbWriter glb = squareGlb();
    const int places = glb.addView(std::vector<std::uint16_t>{1, 2});
    const int values = glb.addView(std::vector<float>{3, 0, 0, 3, 3, 0});
    glb.document["accessors"][0].erase("bufferView");
    glb.document["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", places}, {"componentType", unsignedShortType}}},
        {"values", {{"bufferView", values}}}};
    expectBox(loadedGlb(glb), {0, 0, 0}, {3, 3, 0});
}

TEST(Gltf, QuantisedAndNormalised_IsScaledIntoUnitRange) {
    GlbWriter glb = squareGlb();
    const std::vector<std::int8_t> quantised{0,   0,   0, 0, 127, 0,   0, 0,
                                             127, 127, 0, 0, 0,   127, 0, 0};
    const int view = glb.addView(quantised);
    glb.document["bufferViews"][std::size_t(view)]["byteStride"] = 4;
    const int accessor = glb.addAccessor(view, byteType, "VEC3", 4);
    glb.document["accessors"][std::size_t(accessor)]["normalized"] = true;
    glb.primitive()["attributes"]["POSITION"] = accessor;
    glb.document["extensionsRequired"][0] = "KHR_mesh_quantization";
    expectBox(loadedGlb(glb), {0, 0, 0}, {1, 1, 0});
}

TEST(Gltf, QuantisedIntegers_AreTakenAsTheyAre) {
    GlbWriter glb = squareGlb();
    const std::vector<std::uint16_t> quantised{0,   0,   0, 0, 700, 0,   0, 0,
                                               700, 700, 0, 0, 0,   700, 0, 0};
    const int view = glb.addView(quantised);
    glb.document["bufferViews"][std::size_t(view)]["byteStride"] = 8;
    glb.primitive()["attributes"]["POSITION"] = glb.addAccessor(view, unsignedShortType, "VEC3", 4);
    glb.document["extensionsRequired"][0] = "KHR_mesh_quantization";
    expectBox(loadedGlb(glb), {0, 0, 0}, {700, 700, 0});
}

/// The square as KHR_draco_mesh_compression stores it.
std::vector<char> dracoSquare() {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2);
    const int position =
        builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    for (std::uint32_t face = 0; face < 2; ++face) {
        const auto corner = [&](std::uint32_t k) { return &corners[3 * square[3 * face + k]]; };
        builder.SetAttributeValuesForFace(position, draco::FaceIndex(face), corner(0), corner(1),
                                          corner(2));
    }
    draco::EncoderBuffer buffer;
    draco::Encoder().EncodeMeshToBuffer(*builder.Finalize(), &buffer);
    return {buffer.data(), buffer.data() + buffer.size()};
}

GlbWriter dracoGlb(const std::vector<char>& data) {
    GlbWriter glb;
    const int view = glb.addView(data);
    glb.primitive()["attributes"]["POSITION"] = glb.addAccessor(-1, floatType, "VEC3", 4);
    glb.primitive()["indices"] = glb.addAccessor(-1, unsignedShortType, "SCALAR", 6);
    glb.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", {{"POSITION", 0}}}};
    glb.document["extensionsRequired"][0] = "KHR_draco_mesh_compression";
    return glb;
}

TEST(Gltf, Draco_IsDecoded) {
    const auto mesh = loadedGlb(dracoGlb(dracoSquare()));
    expectBox(mesh, {0, 0, 0}, {1, 1, 0});
    expectFacing(mesh, {0, 0, 1});
}

TEST(Gltf, DamagedDraco_SaysSo) {
    std::vector<char> data = dracoSquare();
    data.resize(data.size() / 2);
    EXPECT_NE(complaint(dracoGlb(data)).find("the Draco data is damaged"), std::string::npos);
}

std::vector<unsigned char> compressedCorners() {
    std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(4, 12));
    bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), corners.data(), 4, 12));
    return bytes;
}

std::vector<unsigned char> compressedSquare() {
    const std::vector<std::uint32_t> indices(square.begin(), square.end());
    std::vector<unsigned char> bytes(meshopt_encodeIndexBufferBound(6, 4));
    bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), indices.data(), 6));
    return bytes;
}

/// The square as EXT_meshopt_compression stores it: the views point into a fallback buffer that
/// has no data, their extensions into the real one.
GlbWriter meshoptGlb(const std::vector<unsigned char>& positions) {
    GlbWriter glb;
    glb.addView(positions);
    const std::size_t indicesAt = (positions.size() + 3) / 4 * 4;
    const std::vector<unsigned char> indices = compressedSquare();
    glb.addView(indices);
    const auto view = [](std::size_t at, std::size_t bytes, std::size_t stride, std::size_t count,
                         const char* mode) {
        const nlohmann::json compression{{"buffer", 0},         {"byteOffset", at},
                                         {"byteLength", bytes}, {"byteStride", stride},
                                         {"count", count},      {"mode", mode}};
        return nlohmann::json{{"buffer", 1},
                              {"byteLength", stride * count},
                              {"extensions", {{"EXT_meshopt_compression", compression}}}};
    };
    glb.document["bufferViews"][0] = view(0, positions.size(), 12, 4, "ATTRIBUTES");
    glb.document["bufferViews"][1] = view(indicesAt, indices.size(), 2, 6, "TRIANGLES");
    glb.document["buffers"][1] = nlohmann::json::parse(
        R"({"byteLength": 60, "extensions": {"EXT_meshopt_compression": {"fallback": true}}})");
    glb.primitive()["attributes"]["POSITION"] = glb.addAccessor(0, floatType, "VEC3", 4);
    glb.primitive()["indices"] = glb.addAccessor(1, unsignedShortType, "SCALAR", 6);
    glb.document["extensionsRequired"][0] = "EXT_meshopt_compression";
    return glb;
}

TEST(Gltf, Meshopt_IsDecoded) {
    const auto mesh = loadedGlb(meshoptGlb(compressedCorners()));
    expectBox(mesh, {0, 0, 0}, {1, 1, 0});
    expectFacing(mesh, {0, 0, 1});
}

TEST(Gltf, DamagedMeshopt_SaysSo) {
    std::vector<unsigned char> damaged = compressedCorners();
    damaged.front() = 0; // the header byte
    EXPECT_NE(complaint(meshoptGlb(damaged)).find("is damaged"), std::string::npos);
}

TEST(Gltf, MeshoptWithImpossibleStride_IsRefused) {
    GlbWriter glb = meshoptGlb(compressedCorners());
    glb.document["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["byteStride"] = 13;
    EXPECT_NE(complaint(glb).find("the compression of buffer view 0 is not valid"),
              std::string::npos);
}

TEST(Gltf, DataUri_IsRead) {
    // Three positions and nothing else: (0 0 0), (1 0 0), (0 1 0) as floats.
    const char* const text = R"({"asset": {"version": "2.0"}, "scene": 0,
        "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)"
                             R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
    expectBox(loaded("data.gltf", text), {0, 0, 0}, {1, 1, 0});
}

TEST(Gltf, MissingBuffer_NamesIt) {
    const char* const text = R"({"asset": {"version": "2.0"},
        "buffers": [{"byteLength": 36, "uri": "lost.bin"}]})";
    EXPECT_NE(complaintAbout("a.gltf", text).find("lost.bin"), std::string::npos);
}

TEST(Gltf, UnknownRequiredExtension_NamesIt) {
    GlbWriter glb = squareGlb();
    glb.document["extensionsRequired"][0] = "EXT_unheard_of";
    EXPECT_EQ(complaint(glb), "needs the glTF extension EXT_unheard_of, which is not known here");
}

TEST(Gltf, UnknownOptionalExtension_IsIgnored) {
    GlbWriter glb = squareGlb();
    glb.document["extensionsUsed"][0] = "EXT_unheard_of";
    EXPECT_TRUE(loadedGlb(glb));
}

TEST(Gltf, IndexBeyondTheVertices_SaysSo) {
    GlbWriter glb = squareGlb();
    const std::vector<std::uint16_t> wrong{0, 1, 4};
    glb.primitive()["indices"] =
        glb.addAccessor(glb.addView(wrong), unsignedShortType, "SCALAR", 3);
    EXPECT_NE(complaint(glb).find("an index beyond its 4 vertices"), std::string::npos);
}

TEST(Gltf, AccessorLongerThanItsData_SaysSo) {
    GlbWriter glb = squareGlb();
    glb.document["accessors"][0]["count"] = 1000000;
    EXPECT_NE(complaint(glb).find("too short for 1000000 elements"), std::string::npos);
}

TEST(Gltf, ViewBeyondItsBuffer_SaysSo) {
    GlbWriter glb = squareGlb();
    glb.document["bufferViews"][0]["byteLength"] = 4000000000u;
    EXPECT_NE(complaint(glb).find("buffer 0 is too short"), std::string::npos);
}

TEST(Gltf, NodesInACircle_SaySo) {
    GlbWriter glb = squareGlb();
    glb.node()["children"][0] = 0;
    EXPECT_NE(complaint(glb).find("nested in a circle"), std::string::npos);
}

} // namespace
} // namespace patina::tests::gltf_test
