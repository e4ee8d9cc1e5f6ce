// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <unordered_map>

#include <QByteArray>

#include "catalog/catalog.h"
#include "material/material.h"
#include "scene/scene.h"

namespace patina {

/// Names the image of a material by a hash of everything that it depends on: the material's look,
/// its textures, the blocks, the shaders, the scene and the program. A file is read again only when
/// its size or time changed.
class ThumbnailKeys {
  public:
    explicit ThumbnailKeys(std::filesystem::path scene) : scene_(std::move(scene)) {}

    QByteArray of(const Material& material, const Catalog& catalog);

    /// Returns the name of the image of an environment.
    QByteArray of(const BlockValues& environment, const Catalog& catalog);

    /// Returns the name of the image of a scene file, whose objects have their own materials.
    QByteArray of(const Scene& scene, const std::filesystem::path& file, const Catalog& catalog);

  private:
    struct Hashed {
        std::int64_t bytes = 0;
        std::int64_t written = 0;
        QByteArray hash;
    };

    QByteArray hashOf(const std::filesystem::path& file);
    QByteArray renderer(const Catalog& catalog);

    std::filesystem::path scene_;
    std::unordered_map<std::string, Hashed> files_;
};

} // namespace patina
