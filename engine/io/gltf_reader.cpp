// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_reader.h"

#include <map>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "io/gltf_file.h"
#include "io/gltf_left_out.h"
#include "io/gltf_materials.h"
#include "io/gltf_primitive.h"
#include "io/gltf_views.h"
#include "io/mesh_limits.h"

namespace patina {
namespace {

constexpr int maxNodeVisits = 1000000; // nodes that share children multiply

glm::dmat4 localMatrix(const tinygltf::Node& node) {
    if (node.matrix.size() == 16) {
        return glm::make_mat4(node.matrix.data());
    }
    glm::dmat4 matrix(1.0);
    if (node.translation.size() == 3) {
        matrix = glm::translate(matrix, glm::make_vec3(node.translation.data()));
    }
    if (node.rotation.size() == 4) {
        const auto& r = node.rotation;
        const glm::dquat rotation(r[3], r[0], r[1], r[2]);
        const double length = glm::length(rotation);
        matrix *= length > 0.0 ? glm::mat4_cast(rotation / length) : glm::dmat4(1.0);
    }
    if (node.scale.size() == 3) {
        matrix = glm::scale(matrix, glm::make_vec3(node.scale.data()));
    }
    return matrix;
}

/// Appends one attribute. Earlier parts without it get the filler here, later ones in
/// padAttributes.
template <class Vector>
void append(std::vector<Vector>& all, std::size_t first, const std::vector<Vector>& part,
            const Vector& filler) {
    if (!part.empty()) {
        all.resize(first, filler);
        all.insert(all.end(), part.begin(), part.end());
    }
}

/// Visits the nodes and gathers their meshes.
class Gatherer {
  public:
    Gatherer(const tinygltf::Model& model, const ReportProgress& report)
        : model_(model), views_(model), report_(report) {}

    Result<RawMesh> gather() {
        for (const int root : roots()) {
            if (auto added = addNode(root, glm::dmat4(1.0), 0); !added) {
                return tl::unexpected(added.error());
            }
        }
        whole_.padAttributes();
        return std::move(whole_);
    }

  private:
    /// Returns the nodes of the default scene, else of the first scene; without any scene, every
    /// node that is no other node's child.
    std::vector<int> roots() const {
        if (!model_.scenes.empty()) {
            const auto scene = std::size_t(std::max(model_.defaultScene, 0));
            return model_.scenes[scene < model_.scenes.size() ? scene : 0].nodes;
        }
        std::vector<bool> owned(model_.nodes.size(), false);
        for (const tinygltf::Node& node : model_.nodes) {
            for (const int child : node.children) {
                if (child >= 0 && std::size_t(child) < owned.size()) {
                    owned[std::size_t(child)] = true;
                }
            }
        }
        std::vector<int> free;
        for (std::size_t i = 0; i < owned.size(); ++i) {
            if (!owned[i]) {
                free.push_back(static_cast<int>(i));
            }
        }
        return free;
    }

    Result<void> addNode(int index, const glm::dmat4& parent, int depth) {
        if (index < 0 || std::size_t(index) >= model_.nodes.size()) {
            return failure(fmt::format("there is no node {}", index));
        }
        if (depth > maxNodeDepth || ++visits_ > maxNodeVisits) {
            return failure("its nodes are nested in a circle or too deeply");
        }
        const tinygltf::Node& node = model_.nodes[std::size_t(index)];
        const glm::dmat4 matrix = parent * localMatrix(node);
        if (node.mesh >= 0) {
            if (auto added = addMesh(node.mesh, matrix); !added) {
                return added;
            }
        }
        for (const int child : node.children) {
            if (auto added = addNode(child, matrix, depth + 1); !added) {
                return added;
            }
        }
        return {};
    }

    Result<void> addMesh(int index, const glm::dmat4& matrix) {
        if (std::size_t(index) >= model_.meshes.size()) {
            return failure(fmt::format("there is no mesh {}", index));
        }
        const auto& primitives = model_.meshes[std::size_t(index)].primitives;
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const auto part = decoded(index, i, primitives[i]);
            if (!part) {
                return tl::unexpected(part.error());
            }
            if (whole_.positions.size() + (*part)->positions.size() > maxVertices) {
                return failure("is too large");
            }
            addPart(**part, matrix, primitives[i].material);
        }
        report_(double(index + 1) / double(model_.meshes.size()));
        return {};
    }

    /// Returns a primitive, which is decoded once, however many nodes use it.
    Result<const RawMesh*> decoded(int mesh, std::size_t index,
                                   const tinygltf::Primitive& primitive) {
        const auto key = std::pair(mesh, index);
        if (const auto known = decoded_.find(key); known != decoded_.end()) {
            return &known->second;
        }
        auto part = readPrimitive(model_, views_, primitive);
        if (!part) {
            Error error = part.error();
            error.problem = fmt::format("mesh {}, primitive {}: {}", mesh, index, error.problem);
            return tl::unexpected(error);
        }
        return &decoded_.emplace(key, std::move(*part)).first->second;
    }

    void addPart(const RawMesh& part, const glm::dmat4& matrix, int material) {
        const std::size_t first = whole_.positions.size();
        const std::size_t firstIndex = whole_.indices.size();
        append(whole_.positions, first, part.positions, glm::vec3(0.0f));
        append(whole_.normals, first, part.normals, glm::vec3(0.0f));
        append(whole_.tangents, first, part.tangents, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
        append(whole_.uvs, first, part.uvs, glm::vec2(0.0f));
        append(whole_.colors, first, part.colors, glm::vec4(1.0f));
        for (std::size_t i = first; !part.uvs.empty() && i < whole_.uvs.size(); ++i) {
            whole_.uvs[i].y = 1.0f - whole_.uvs[i].y; // glTF counts it from the image's top
        }
        for (const std::uint32_t index : part.indices) {
            whole_.indices.push_back(static_cast<std::uint32_t>(first + index));
        }
        if (material >= 0) {
            whole_.setMaterial(firstIndex, static_cast<std::uint32_t>(material));
        }
        whole_.pointsAndLines += part.pointsAndLines;
        whole_.transform(matrix, first, firstIndex);
    }

    const tinygltf::Model& model_;
    GltfViews views_;
    const ReportProgress& report_;
    RawMesh whole_;
    int visits_ = 0;
    std::map<std::pair<int, std::size_t>, RawMesh> decoded_;
};

/// Returns whether each material has a triangle with a vertex that is not white.
std::vector<bool> haveColors(const RawMesh& mesh) {
    std::vector<bool> have(mesh.materials.size(), false);
    for (std::size_t i = 0; i < mesh.indices.size() && i / 3 < mesh.materialOf.size(); ++i) {
        const std::uint32_t material = mesh.materialOf[i / 3];
        if (material < have.size() && mesh.colors[mesh.indices[i]] != glm::vec4(1.0f)) {
            have[material] = true;
        }
    }
    return have;
}

/// Multiplies vertex colours with the base colour of each material, unless an image is there: then
/// they are left out.
void layVertexColors(RawMesh& mesh) {
    if (mesh.colors.empty()) {
        return;
    }
    const std::vector<bool> have = haveColors(mesh);
    for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
        MeshMaterial& material = mesh.materials[i];
        const bool isFree =
            material.images.try_emplace(material.isMetal() ? "f0" : "diffuse", vertexColorsName)
                .second;
        if (!isFree && have[i]) {
            mesh.leftOut.add(LeftOut::What::VertexColors, material.name);
        }
    }
}

} // namespace

Result<std::optional<RawMesh>> readGltf(MeshFolder& folder, const ReportProgress& report) {
    const auto model = loadGltf(folder);
    if (!model) {
        return tl::unexpected(model.error());
    }
    if (!*model) {
        return std::optional<RawMesh>();
    }
    auto mesh = Gatherer(**model, report).gather();
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    mesh->leftOut = leftOutOf(**model);
    mesh->materials = materialsFrom(**model, folder, mesh->leftOut);
    layVertexColors(*mesh);
    return std::optional(std::move(*mesh));
}

} // namespace patina
