// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_parts.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace patina {
namespace {

constexpr std::size_t maxParts = 256; // more objects than that are no help to anybody

/// Returns the first free name among "Gold", "Gold 2", "Gold 3" ...
std::string freeName(const std::string& wanted, const std::set<std::string>& taken) {
    std::string name = wanted;
    for (int number = 2; taken.contains(name); ++number) {
        name = wanted + ' ' + std::to_string(number);
    }
    return name;
}

/// Returns the part of each triangle, and adds the material of each part to `materials`.
std::vector<std::size_t> partsOfTriangles(const RawMesh& mesh,
                                          std::vector<std::uint32_t>& materials) {
    std::map<std::uint32_t, std::size_t> partOf;
    std::vector<std::size_t> parts(mesh.indices.size() / 3);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::uint32_t material =
            i < mesh.materialOf.size() ? mesh.materialOf[i] : RawMesh::noMaterial;
        const auto [found, isNew] = partOf.try_emplace(material, materials.size());
        if (isNew && materials.size() < maxParts) {
            materials.push_back(material);
        }
        parts[i] = std::min(found->second, maxParts - 1);
    }
    return parts;
}

/// Copies the vertices that a part uses, each once.
class PartMaker {
  public:
    explicit PartMaker(const RawMesh& whole)
        : whole_(whole), target_(whole.positions.size(), unknown) {}

    void addCorner(RawMesh& part, std::uint32_t vertex) {
        if (target_[vertex] == unknown) {
            target_[vertex] = static_cast<std::uint32_t>(part.positions.size());
            used_.push_back(vertex);
            part.positions.push_back(whole_.positions[vertex]);
            copy(part.normals, whole_.normals, vertex);
            copy(part.tangents, whole_.tangents, vertex);
            copy(part.uvs, whole_.uvs, vertex);
            copy(part.colors, whole_.colors, vertex);
        }
        part.indices.push_back(target_[vertex]);
    }

    /// Begins the next part.
    void end() {
        for (const std::uint32_t vertex : std::exchange(used_, {})) {
            target_[vertex] = unknown;
        }
    }

  private:
    static constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();

    template <class T>
    static void copy(std::vector<T>& to, const std::vector<T>& from, std::uint32_t vertex) {
        if (!from.empty()) {
            to.push_back(from[vertex]);
        }
    }

    const RawMesh& whole_;
    std::vector<std::uint32_t> target_; ///< has the vertex of the part for each of the whole
    std::vector<std::uint32_t> used_;
};

/// Returns the first corners of each part's triangles, in their order.
std::vector<std::vector<std::size_t>> trianglesOf(const std::vector<std::size_t>& parts,
                                                  std::size_t count) {
    std::vector<std::vector<std::size_t>> triangles(count);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        triangles[parts[i]].push_back(3 * i);
    }
    return triangles;
}

} // namespace

std::vector<RawMesh> splitByMaterial(RawMesh mesh) {
    std::vector<std::uint32_t> materials;
    const std::vector<std::size_t> partOf = partsOfTriangles(mesh, materials);
    std::vector<RawMesh> parts;
    if (materials.size() == 1) {
        const std::uint32_t only = materials.front();
        mesh.materials = only < mesh.materials.size() ? std::vector{mesh.materials[only]}
                                                      : std::vector<MeshMaterial>();
        parts.push_back(std::move(mesh));
        return parts;
    }
    PartMaker maker(mesh);
    const auto triangles = trianglesOf(partOf, materials.size());
    for (std::size_t i = 0; i < materials.size(); ++i) {
        RawMesh part;
        for (const std::size_t first : triangles[i]) {
            for (std::size_t k = 0; k < 3; ++k) {
                maker.addCorner(part, mesh.indices[first + k]);
            }
        }
        maker.end();
        if (materials[i] < mesh.materials.size()) {
            part.materials.push_back(mesh.materials[materials[i]]);
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

MeshMaterial nameless(const std::vector<MeshMaterial>& others) {
    std::set<std::string> taken;
    for (const MeshMaterial& material : others) {
        taken.insert(material.name);
    }
    MeshMaterial material;
    material.name = freeName("No material", taken);
    return material;
}

void nameUniquely(std::vector<MeshMaterial>& materials) {
    std::set<std::string> taken;
    for (MeshMaterial& material : materials) {
        std::erase(material.name, '\0');
        material.name = freeName(material.name.empty() ? "Material" : material.name, taken);
        taken.insert(material.name);
    }
}

} // namespace patina
