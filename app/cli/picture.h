// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "core/error.h"
#include "core/image.h"
#include "gl/headless_context.h"
#include "render/gpu/texture_loader.h"
#include "render/renderer.h"

namespace patina {

/// Draws scenes without a display.
class PictureMaker {
  public:
    static Result<PictureMaker> create(std::shared_ptr<const Catalog> catalog);

    /// Images come from there. It outlives what is drawn. Without one of the needed files there is
    /// no picture; a checker stands for any other that cannot be read.
    void setTextures(TextureLoader& textures, std::vector<std::string> needed);

    /// Sets what the scenes' environments show, and how many samples their light has.
    void setEnvironment(std::shared_ptr<const EnvironmentImage> image, int samples);

    /// With display the 8-bit display values / 255, else linear floats. An error when the picture
    /// is not what was asked for; what was merely left out is a warning on standard error, given
    /// once.
    Checked<Image> draw(const Scene& scene, const MeshSource& meshes, glm::ivec2 size,
                        bool display);

  private:
    PictureMaker() = default;

    Checked<void> lookAtTextures();
    void tell(const Errors& warnings);

    std::unique_ptr<gl::HeadlessContext> context_;
    std::unique_ptr<Renderer> renderer_;
    TextureLoader* textures_ = nullptr;
    std::vector<std::string> neededTextures_;
    std::shared_ptr<const EnvironmentImage> environment_;
    int samples_ = 0;
    Errors told_; ///< warnings
};

/// Says where an image goes: a file, or "-" for a PNG on standard output.
struct PictureFile {
    std::string name;

    bool isStandardOutput() const { return name == "-"; }

    /// True for formats that keep linear light.
    bool isLinear() const;

    /// True where more than a PNG is written, which takes a moment to get ready for.
    bool needsImageFormats() const;

    /// The error says which formats there are.
    Result<void> check() const;
};

/// Returns where program binaries are kept between runs; empty where a user has no folder for such
/// things.
std::filesystem::path programCacheFolder();

} // namespace patina
