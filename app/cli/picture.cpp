// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/picture.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "catalog/xdg_folders.h"
#include "cli/command.h"
#include "render/surfaces/inspection_drawer.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

std::string extensionOf(const std::string& name) {
    std::string extension = fs::path(name).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

} // namespace

Result<PictureMaker> PictureMaker::create(std::shared_ptr<const Catalog> catalog) {
    PictureMaker maker;
    auto context = gl::HeadlessContext::create();
    if (!context) {
        return tl::unexpected(context.error());
    }
    maker.context_ = std::move(*context);
    auto renderer = Renderer::create({programCacheFolder()});
    if (!renderer) {
        return tl::unexpected(renderer.error());
    }
    maker.renderer_ = std::move(*renderer);
    maker.renderer_->setCatalog(std::move(catalog));
    return maker;
}

void PictureMaker::setTextures(TextureLoader& textures, std::vector<std::string> needed) {
    textures_ = &textures;
    neededTextures_ = std::move(needed);
    renderer_->setTextures(textures.source());
}

void PictureMaker::setEnvironment(std::shared_ptr<const EnvironmentImage> image, int samples) {
    environment_ = std::move(image);
    samples_ = samples;
}

View PictureMaker::viewOf(const Scene& scene, glm::ivec2 size) const {
    View view;
    view.size = size;
    view.camera = scene.camera;
    view.pixelRatio = pixelRatio_;
    view.environmentImage = environment_;
    view.environmentSamples = samples_;
    return view;
}

Checked<Image> PictureMaker::draw(const Scene& scene, const MeshSource& meshes, glm::ivec2 size,
                                  bool display) {
    auto image = renderer_->capture(scene, viewOf(scene, size), meshes, display);
    return checked(std::move(image), renderer_->report());
}

Checked<Image> PictureMaker::drawInspected(const Scene& scene, const MeshSource& meshes,
                                           glm::ivec2 size, bool display, const Inspected& shown) {
    InspectionDrawer& drawer = renderer_->inspection();
    auto image = drawer.capture(scene, viewOf(scene, size), meshes, display, shown);
    return checked(std::move(image), drawer.report());
}

/// Returns the image where it is what was asked for.
Checked<Image> PictureMaker::checked(Result<Image> image, const FrameReport& frame) {
    if (!image) {
        return tl::unexpected(Errors{image.error()});
    }
    if (frame.messages.size() > frame.warnings) {
        return tl::unexpected(frame.messages);
    }
    reportOnce(frame.messages);
    if (auto looked = lookAtTextures(); !looked) {
        return tl::unexpected(looked.error());
    }
    return std::move(*image);
}

Checked<void> PictureMaker::lookAtTextures() {
    Errors problems = textures_ == nullptr ? Errors() : textures_->takeProblems();
    const bool isNeeded = std::any_of(problems.begin(), problems.end(), [this](const Error& error) {
        return std::find(neededTextures_.begin(), neededTextures_.end(), error.file) !=
               neededTextures_.end();
    });
    if (isNeeded) {
        return tl::unexpected(std::move(problems));
    }
    reportOnce(problems);
    return {};
}

void PictureMaker::reportOnce(const Errors& warnings) {
    Errors fresh;
    for (const Error& warning : warnings) {
        if (std::find(reported_.begin(), reported_.end(), warning) == reported_.end()) {
            fresh.push_back(warning);
        }
    }
    addNew(reported_, fresh);
    report(fresh);
}

bool PictureFile::isLinear() const {
    const std::string extension = extensionOf(name);
    return extension == ".exr" || extension == ".hdr";
}

bool PictureFile::needsImageFormats() const {
    return !isStandardOutput() && extensionOf(name) != ".png";
}

Result<void> PictureFile::check() const {
    constexpr std::array<std::string_view, 5> known{".png", ".jpg", ".jpeg", ".exr", ".hdr"};
    if (isStandardOutput() ||
        std::find(known.begin(), known.end(), extensionOf(name)) != known.end()) {
        return {};
    }
    return tl::unexpected(Error{name, 0, 0, "the name does not say which image format to write",
                                ".png, .jpg, .exr or .hdr at its end"});
}

fs::path programCacheFolder() {
    const auto cache = xdgCacheFolder();
    return cache ? *cache / "programs" : fs::path();
}

} // namespace patina
