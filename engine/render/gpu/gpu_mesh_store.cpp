// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/gpu_mesh_store.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace patina {
namespace {

constexpr std::uint64_t meshesKept = 120;
constexpr std::size_t sampledItems = 64;

/// Hashes at most 64 items, spread evenly, by FNV-1a.
template <class Item>
std::uint64_t sampleOf(std::span<const Item> items, std::uint64_t hash) {
    const std::size_t count = std::min(items.size(), sampledItems);
    for (std::size_t i = 0; i < count; ++i) {
        unsigned char bytes[sizeof(Item)];
        std::memcpy(bytes, &items[i * items.size() / count], sizeof(Item));
        for (const unsigned char byte : bytes) {
            hash = (hash ^ byte) * 0x100000001b3u;
        }
    }
    return hash;
}

} // namespace

const GpuMesh& GpuMeshStore::get(const MeshView& mesh) {
    GpuMesh& held = *prepare(mesh);
    while (!held.isComplete()) {
        held.upload(mesh, mesh.vertices.size_bytes() + mesh.indices.size_bytes());
    }
    held.takeOpenness(mesh);
    held.takeColors(mesh);
    return held;
}

const std::shared_ptr<GpuMesh>& GpuMeshStore::prepare(const MeshView& mesh) {
    const Key key{mesh.vertices.data(), mesh.indices.data(), mesh.vertices.size(),
                  mesh.indices.size()};
    if (lastEntry_ != nullptr && key == last_) {
        return lastEntry_->mesh;
    }
    auto found = meshes_.find(key);
    const bool isCurrent = found != meshes_.end() && found->second.looked == look_;
    if (!isCurrent) {
        const std::uint64_t sample = sampleOf(
            mesh.colors, sampleOf(mesh.indices, sampleOf(mesh.vertices, 0xcbf29ce484222325u)));
        if (found == meshes_.end() || found->second.sample != sample) {
            found =
                meshes_
                    .insert_or_assign(key, Entry{std::make_shared<GpuMesh>(mesh, ++made_), sample})
                    .first;
        }
        found->second.looked = look_;
    }
    found->second.lastFrame = frame_;
    last_ = key;
    lastEntry_ = &found->second;
    return found->second.mesh;
}

void GpuMeshStore::beginFrame() {
    ++look_;
    lastEntry_ = nullptr;
}

void GpuMeshStore::endFrame() {
    lastEntry_ = nullptr;
    std::erase_if(meshes_, [this](const auto& entry) {
        return frame_ - entry.second.lastFrame > meshesKept && entry.second.mesh.use_count() == 1;
    });
    if (frame_ >= meshesKept) {
        for (auto& [key, entry] : meshes_) {
            entry.mesh->forgetUnused(frame_ - meshesKept);
        }
    }
    ++frame_;
}

} // namespace patina
