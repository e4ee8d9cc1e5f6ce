// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <unordered_map>

#include <QByteArray>

#include "catalog/catalog.h"
#include "material/material.h"
#include "scene/scene.h"

namespace patina {

/// Names the picture of a material by a hash of the content of everything that it depends on: the
/// material's look, its images, the blocks and the text of the shaders, the scene, and the program
/// that draws it. Files are read again only when they changed.
class ThumbnailKeys {
  public:
    explicit ThumbnailKeys(std::filesystem::path scene) : scene_(std::move(scene)) {}

    QByteArray of(const Material& material, const Catalog& catalog);

    /// The same for the picture of an environment.
    QByteArray of(const BlockValues& environment, const Catalog& catalog);

    /// The same for a scene that was read from a file, with its own materials.
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
