// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/shadow_casters.h"

#include <algorithm>
#include <numeric>

#include "shading/effects/opacity.h"
#include "shading/effects/shadow_source.h"

namespace patina {

void ShadowCasters::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    alphaTested_.forget();
}

void ShadowCasters::clear() {
    meshes_.clear();
    byMesh_.clear();
    record_.boxes.clear();
    record_.shapes.clear();
    record_.alphaTests.clear();
    alphaTested_.clear();
}

void ShadowCasters::add(const GpuMesh& mesh, const CasterBox& box, const Material& material) {
    meshes_.push_back(&mesh);
    record_.boxes.push_back(box);
    record_.shapes.push_back(
        {mesh.serial(), isAlphaTested(material)
                            ? alphaTested_.add(material, opacityOf(material, *catalog_))
                            : solid});
}

Result<void> ShadowCasters::prepare(ProgramCache& programs, const GpuTextureStore& textures) {
    auto prepared = alphaTested_.prepare(catalog_, programs, textures);
    record_.alphaTests = alphaTested_.tests();
    return prepared;
}

std::int64_t ShadowCasters::triangles() const {
    std::int64_t triangles = 0;
    for (const GpuMesh* mesh : meshes_) {
        triangles += mesh->triangles();
    }
    return triangles;
}

void ShadowCasters::sortByMesh() {
    if (byMesh_.size() != meshes_.size()) {
        byMesh_.resize(meshes_.size());
        std::iota(byMesh_.begin(), byMesh_.end(), std::size_t(0));
        std::ranges::sort(byMesh_, std::less<>(), [this](std::size_t caster) {
            return std::pair(record_.shapes[caster].serial, caster);
        });
    }
}

void ShadowCasters::gather(const glm::dmat4& worldToMap, std::vector<Run>& runs,
                           InstanceBuffer& instances) {
    sortByMesh();
    runs.clear();
    instances.clear();
    for (const std::size_t caster : byMesh_) {
        if (!isSeen(worldToMap, caster)) {
            continue;
        }
        const std::size_t alphaTested = record_.shapes[caster].alphaTested;
        const bool isLike = !runs.empty() && runs.back().mesh == meshes_[caster] &&
                            runs.back().alphaTested == alphaTested;
        if (!isLike) {
            runs.push_back({meshes_[caster], instances.size(), 0, alphaTested});
        }
        ++runs.back().count;
        instances.add(instanceAt(record_.boxes[caster].world));
    }
    instances.upload();
}

/// Returns false when the caster's box lies beyond one side of the map.
bool ShadowCasters::isSeen(const glm::dmat4& worldToMap, std::size_t caster) const {
    const glm::dmat4 clip = worldToMap * record_.boxes[caster].world;
    glm::bvec4 outside(true);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 x = clip * cornerOf(record_.boxes[caster].bounds, corner);
        outside.x = outside.x && x.x < -x.w;
        outside.y = outside.y && x.x > x.w;
        outside.z = outside.z && x.y < -x.w;
        outside.w = outside.w && x.y > x.w;
    }
    return !glm::any(outside);
}

} // namespace patina
