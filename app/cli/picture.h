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
#include "render/surfaces/inspected_view.h"

namespace patina {

/// Draws scenes without a display.
class PictureMaker {
  public:
    static Result<PictureMaker> create(std::shared_ptr<const Catalog> catalog);

    /// Sets where images come from; `textures` has to outlive the drawing. A file in `needed` that
    /// cannot be read is an error; any other is replaced by a checker pattern, with a warning.
    void setTextures(TextureLoader& textures, std::vector<std::string> needed);

    /// Sets the picture of the scenes' environments, and from how many samples their light is
    /// summed.
    void setEnvironment(std::shared_ptr<const EnvironmentImage> image, int samples);

    /// Sets how many pixels a unit of lengths has that keep their size on the screen.
    void setPixelRatio(double ratio) { pixelRatio_ = ratio; }

    /// Draws a scene: with `display` the 8-bit display values / 255, else linear floats. Fails when
    /// the picture is not what was asked for; anything that was merely left out is a warning on
    /// standard error, given once.
    Checked<Image> draw(const Scene& scene, const MeshSource& meshes, glm::ivec2 size,
                        bool display);

    /// Draws something in place of the picture: with `display` as a view shows it, else as it is,
    /// which of the numerical check is the luminance and the defect's number.
    Checked<Image> drawInspected(const Scene& scene, const MeshSource& meshes, glm::ivec2 size,
                                 bool display, const Inspected& shown);

  private:
    PictureMaker() = default;

    View viewOf(const Scene& scene, glm::ivec2 size) const;
    Checked<Image> checked(Result<Image> image, const FrameReport& frame);
    Checked<void> lookAtTextures();
    void reportOnce(const Errors& warnings);

    std::unique_ptr<gl::HeadlessContext> context_;
    std::unique_ptr<Renderer> renderer_;
    TextureLoader* textures_ = nullptr;
    std::vector<std::string> neededTextures_;
    std::shared_ptr<const EnvironmentImage> environment_;
    int samples_ = 0;
    double pixelRatio_ = 1.0;
    Errors reported_; ///< holds the warnings that were given
};

/// Says where an image goes: a file, or "-" for a PNG on standard output.
struct PictureFile {
    std::string name;

    bool isStandardOutput() const { return name == "-"; }

    /// Tells whether the format keeps linear light.
    bool isLinear() const;

    /// Tells whether a format other than PNG is written, whose module takes a moment to load.
    bool needsImageFormats() const;

    /// Fails, naming the formats there are, where the name ends in none of them.
    Result<void> check() const;
};

/// Returns where program binaries are kept between runs; empty where a user has no folder for such
/// things.
std::filesystem::path programCacheFolder();

} // namespace patina
