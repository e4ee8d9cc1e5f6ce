// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/assimp_reader.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>

#include "io/assimp_files.h"
#include "io/assimp_materials.h"
#include "io/material_images.h"
#include "io/mesh_limits.h"
#include "io/polygon_cutter.h"

namespace patina {
namespace {

/// Leaves polygons as they are in the file: Assimp's own triangles of concave ones cover their
/// notches.
constexpr unsigned int noSteps = 0;

class Reporter final : public Assimp::ProgressHandler {
  public:
    explicit Reporter(const ReportProgress& report) : report_(report) {}

    bool Update(float percentage) override {
        if (percentage >= 0.0f && percentage <= 1.0f) {
            report_(percentage);
        }
        return true;
    }

  private:
    const ReportProgress& report_;
};

glm::dmat4 matrixFrom(const aiMatrix4x4& m) {
    return {{m.a1, m.b1, m.c1, m.d1},
            {m.a2, m.b2, m.c2, m.d2},
            {m.a3, m.b3, m.c3, m.d3},
            {m.a4, m.b4, m.c4, m.d4}};
}

static_assert(sizeof(aiVector3D) == sizeof(glm::vec3));

/// Appends to an attribute. Earlier parts of the file that do not have it get zeros.
void append(std::vector<glm::vec3>& all, std::size_t first, const aiVector3D* part,
            std::size_t count) {
    all.resize(first + count, glm::vec3(0.0f));
    std::memcpy(static_cast<void*>(all.data() + first), part, count * sizeof(glm::vec3));
}

void appendUvs(RawMesh& mesh, std::size_t first, const aiMesh& part) {
    mesh.uvs.resize(first, glm::vec2(0.0f));
    std::transform(part.mTextureCoords[0], part.mTextureCoords[0] + part.mNumVertices,
                   std::back_inserter(mesh.uvs),
                   [](const aiVector3D& uv) { return glm::vec2(uv.x, uv.y); });
}

void appendTangents(RawMesh& mesh, std::size_t first, const aiMesh& part) {
    mesh.tangents.resize(first, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    for (unsigned int i = 0; i < part.mNumVertices; ++i) {
        const aiVector3D& t = part.mTangents[i];
        const float side = (part.mNormals[i] ^ t) * part.mBitangents[i] < 0.0f ? -1.0f : 1.0f;
        mesh.tangents.emplace_back(t.x, t.y, t.z, side);
    }
}

void appendColors(RawMesh& mesh, std::size_t first, const aiMesh& part) {
    mesh.colors.resize(first, glm::vec4(1.0f));
    std::transform(part.mColors[0], part.mColors[0] + part.mNumVertices,
                   std::back_inserter(mesh.colors),
                   [](const aiColor4D& c) { return glm::vec4(c.r, c.g, c.b, c.a); });
}

void appendFaces(RawMesh& mesh, std::size_t first, const aiMesh& part) {
    mesh.indices.reserve(mesh.indices.size() + 3 * std::size_t(part.mNumFaces));
    PolygonCutter cutter(mesh);
    std::vector<std::uint32_t> corners;
    for (unsigned int i = 0; i < part.mNumFaces; ++i) {
        const std::span face(part.mFaces[i].mIndices, part.mFaces[i].mNumIndices);
        const auto inside = [&](unsigned int index) { return index < part.mNumVertices; };
        if (face.size() < 3 || !std::ranges::all_of(face, inside)) {
            ++mesh.pointsAndLines;
            continue;
        }
        corners.clear();
        for (const unsigned int index : face) {
            corners.push_back(static_cast<std::uint32_t>(first + index));
        }
        cutter.cut(corners);
    }
}

void appendMesh(RawMesh& mesh, const aiMesh& part, const glm::dmat4& matrix) {
    const std::size_t first = mesh.positions.size();
    const std::size_t firstIndex = mesh.indices.size();
    if (!part.HasPositions() || !part.HasFaces()) {
        mesh.pointsAndLines += part.mNumVertices;
        return;
    }
    append(mesh.positions, first, part.mVertices, part.mNumVertices);
    if (part.HasNormals()) {
        append(mesh.normals, first, part.mNormals, part.mNumVertices);
    }
    if (part.HasTextureCoords(0)) {
        appendUvs(mesh, first, part);
    }
    if (part.HasVertexColors(0)) {
        appendColors(mesh, first, part);
    }
    if (part.HasTangentsAndBitangents() && part.HasNormals()) {
        appendTangents(mesh, first, part);
    }
    appendFaces(mesh, first, part);
    mesh.setMaterial(firstIndex, part.mMaterialIndex);
    mesh.transform(matrix, first, firstIndex);
}

/// Appends a node's meshes and those of its children. Returns false when the file is nested too
/// deeply or grows too large.
bool appendNode(RawMesh& mesh, const aiScene& scene, const aiNode& node, const glm::dmat4& parent,
                int depth) {
    const glm::dmat4 matrix = parent * matrixFrom(node.mTransformation);
    for (unsigned int i = 0; i < node.mNumMeshes; ++i) {
        if (node.mMeshes[i] >= scene.mNumMeshes) {
            continue;
        }
        const aiMesh& part = *scene.mMeshes[node.mMeshes[i]];
        if (mesh.positions.size() + part.mNumVertices > maxVertices) {
            return false;
        }
        appendMesh(mesh, part, matrix);
    }
    const auto appendChild = [&](const aiNode* child) {
        return appendNode(mesh, scene, *child, matrix, depth + 1);
    };
    return depth < maxNodeDepth &&
           std::all_of(node.mChildren, node.mChildren + node.mNumChildren, appendChild);
}

/// Adds the images of a material that no parameter takes, each as "roughness of Brick.png".
void addImages(LeftOut& left, const aiMaterial& material) {
    constexpr std::array<std::pair<aiTextureType, const char*>, 7> unread{
        {{aiTextureType_METALNESS, "metalness"},
         {aiTextureType_DIFFUSE_ROUGHNESS, "roughness"},
         {aiTextureType_AMBIENT_OCCLUSION, "occlusion"},
         {aiTextureType_LIGHTMAP, "occlusion"},
         {aiTextureType_SHININESS, "shininess"},
         {aiTextureType_REFLECTION, "reflections"},
         {aiTextureType_DISPLACEMENT, "displacement"}}};
    for (const auto& [type, use] : unread) {
        aiString path;
        if (material.GetTexture(type, 0, &path) == aiReturn_SUCCESS && path.length > 0) {
            left.add(LeftOut::What::Image, use + (" of " + fileNameIn(path.C_Str())));
        }
    }
}

/// Returns what the file has beside the triangles and the looks that are read.
LeftOut leftOutOf(const aiScene& scene) {
    using What = LeftOut::What;
    LeftOut left;
    for (unsigned int i = 0; i < scene.mNumAnimations; ++i) {
        left.add(What::Animation, scene.mAnimations[i]->mName.C_Str());
    }
    for (unsigned int i = 0; i < scene.mNumCameras; ++i) {
        left.add(What::Camera, scene.mCameras[i]->mName.C_Str());
    }
    for (unsigned int i = 0; i < scene.mNumLights; ++i) {
        left.add(What::Light, scene.mLights[i]->mName.C_Str());
    }
    for (unsigned int i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[i];
        if (mesh.HasBones()) {
            left.add(What::Skin, mesh.mName.C_Str());
        }
        if (mesh.mNumAnimMeshes > 0) {
            left.add(What::MorphTargets, mesh.mName.C_Str());
        }
    }
    for (unsigned int i = 0; i < scene.mNumTextures; ++i) {
        left.add(What::Image, scene.mTextures[i]->mFilename.C_Str());
    }
    for (unsigned int i = 0; i < scene.mNumMaterials; ++i) {
        addImages(left, *scene.mMaterials[i]);
    }
    return left;
}

Error unreadable(const std::filesystem::path& file, std::string why) {
    std::erase(why, '\n');
    while (why.ends_with('.') || why.ends_with(' ')) {
        why.pop_back();
    }
    if (why.ends_with("bad_alloc")) {
        why = "it is damaged, or asks for more memory than there is";
    }
    if (why.empty() || why.starts_with("No suitable reader")) {
        why = "it is damaged, or not in the format its name says";
    }
    return Error{file.string(), 0, 0, "cannot be read: " + why, {}};
}

/// Tells whether the format has colours in linear light; those of others are for a screen.
bool hasLinearColors(const std::filesystem::path& file) {
    return file.extension() == ".gltf" || file.extension() == ".glb";
}

/// Returns the scene that `read` makes with an importer as a mesh.
template <class Read>
Result<RawMesh> meshFrom(const std::shared_ptr<MeshFolder>& folder, const ReportProgress& report,
                         const Read& read) {
    const std::filesystem::path& file = folder->file();
    const auto importer = std::make_shared<Assimp::Importer>();
    if (!importer->IsExtensionSupported(file.extension().string())) {
        return tl::unexpected(Error{file.string(), 0, 0, "is not in a mesh format known here",
                                    ".obj, .gltf, .glb, .ply, .stl, .fbx, .dae, .3ds or the like"});
    }
    importer->SetIOHandler(new AssimpFiles(folder)); // becomes the importer's
    Reporter reporter(report);
    importer->SetProgressHandler(&reporter);
    const aiScene* const scene = read(*importer);
    importer->SetProgressHandler(nullptr); // else it would delete it
    if (scene == nullptr) {
        return tl::unexpected(unreadable(file, importer->GetErrorString()));
    }
    RawMesh mesh;
    mesh.leftovers = importer;
    if (scene->mRootNode != nullptr &&
        !appendNode(mesh, *scene, *scene->mRootNode, glm::dmat4(1.0), 0)) {
        return tl::unexpected(unreadable(file, "it is too large or nested too deeply"));
    }
    mesh.padAttributes();
    if (!hasLinearColors(file)) {
        mesh.decodeColors();
    }
    mesh.leftOut = leftOutOf(*scene);
    mesh.materials = materialsFrom(*scene, *folder, mesh.leftOut);
    return mesh;
}

} // namespace

Result<RawMesh> readWithAssimp(const std::shared_ptr<MeshFolder>& folder,
                               const ReportProgress& report) {
    return meshFrom(folder, report, [&](Assimp::Importer& importer) {
        return importer.ReadFile(folder->file().string(), noSteps);
    });
}

Result<RawMesh> readWithAssimp(const std::shared_ptr<MeshFolder>& folder, std::string_view text,
                               const ReportProgress& report) {
    return meshFrom(folder, report, [&](Assimp::Importer& importer) {
        const std::string format = folder->file().extension().string().substr(1);
        return importer.ReadFileFromMemory(text.data(), text.size(), noSteps, format.c_str());
    });
}

} // namespace patina
