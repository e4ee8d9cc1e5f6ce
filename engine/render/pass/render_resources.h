// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "catalog/catalog.h"
#include "render/gpu/gpu_mesh_store.h"
#include "render/gpu/gpu_texture_store.h"
#include "render/gpu/measured_store.h"
#include "render/lights/environment_pictures.h"
#include "render/pass/pipeline_store.h"
#include "render/pass/shadow_map_pool.h"

namespace patina {

/// Holds what the views of one context share: programs, meshes, images and shadow maps on the GPU.
struct RenderResources {
    explicit RenderResources(std::filesystem::path folder)
        : programCache(std::move(folder)), pipelines(programCache) {}

    /// Sets the catalogue and drops all programs made from the old one.
    void setCatalog(std::shared_ptr<const Catalog> changed);

    ProgramCache& programs() { return pipelines.programs(); }

    std::filesystem::path programCache;     ///< is the folder of compiled programs; empty for none
                                            ///< on disk
    std::shared_ptr<const Catalog> catalog; ///< is null until setCatalog()
    PipelineStore pipelines;
    GpuMeshStore meshes;
    GpuTextureStore textures;
    MeasuredStore measured;
    EnvironmentPictures environments;
    ShadowMapPool shadows;
};

} // namespace patina
