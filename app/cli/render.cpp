// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <future>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "assets/asset_client.h"
#include "cli/environment_setup.h"
#include "cli/picture.h"
#include "cli/picture_options.h"
#include "cli/scene_meshes.h"
#include "cli/scene_setup.h"
#include "cli/texture_text.h"
#include "core/auto_exposure.h"
#include "core/display_image.h"

namespace patina {
namespace {

struct RenderOptions {
    std::string preset;
    PictureOptions picture;
    PictureFile output;
    bool autoExposure = false;
};

Checked<void> checkRequest(const RenderOptions& options) {
    if (options.preset.empty() && options.picture.model.empty() && options.picture.scene.empty()) {
        return tl::unexpected(oneError(
            failure("there is nothing to render", "a preset, --model or --scene").value()));
    }
    if (auto checked = options.output.check(); !checked) {
        return tl::unexpected(oneError(checked.error()));
    }
    return {};
}

/// The image of the request: meshes are read while the graphics driver starts.
Checked<Image> picture(const RenderOptions& options, const std::shared_ptr<const Catalog>& catalog,
                       const Scene& scene, AssetClient& client) {
    auto meshes = std::async(std::launch::async,
                             [&scene, &client] { return SceneMeshes::load(scene, client); });
    auto maker = PictureMaker::create(catalog);
    const auto loaded = meshes.get();
    if (!maker) {
        return tl::unexpected(oneError(maker.error()));
    }
    if (!loaded) {
        return tl::unexpected(loaded.error());
    }
    report(loaded->remarks());
    TextureLoader textures(client);
    maker->setTextures(textures, filesIn(options.picture.textures));
    const auto environment = environmentPicture(scene, options.picture, *catalog, client);
    if (!environment) {
        return tl::unexpected(oneError(environment.error()));
    }
    maker->setEnvironment(*environment, directionsFor(scene, options.picture, *catalog));
    const bool display = !options.output.isLinear();
    const MeshSource source = [&loaded](const Object& object) { return loaded->view(object); };
    Scene exposed = scene;
    if (options.autoExposure) {
        exposed.exposure = 0.0;
        const auto linear = maker->draw(exposed, source, options.picture.size, false);
        if (!linear) {
            return linear;
        }
        exposed.exposure = autoExposure(*linear).value_or(scene.exposure);
    }
    auto image = maker->draw(exposed, source, options.picture.size, display);
    return image && display ? linearFromDisplay(std::move(*image)) : std::move(image);
}

Checked<void> write(const PictureFile& file, const Image& image, AssetClient& client) {
    if (!file.isStandardOutput()) {
        const auto saved = client.saveImage(file.name, image);
        return saved ? Checked<void>() : tl::unexpected(oneError(saved.error()));
    }
    const auto bytes = client.encodeImage(".png", image);
    if (!bytes) {
        return tl::unexpected(oneError(bytes.error()));
    }
    std::cout << *bytes;
    return {};
}

Checked<void> render(const RenderOptions& options) {
    if (auto checked = checkRequest(options); !checked) {
        return checked;
    }
    AssetClient files;
    files.warmUp(options.output.needsImageFormats() ? AssetClient::Formats::images
                                                    : AssetClient::Formats::meshes);
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    report(catalog->errors);
    const auto setup = sceneFor(options.preset, options.picture, *catalog);
    if (!setup) {
        return tl::unexpected(setup.error());
    }
    report(setup->notes);
    files.setRights(setup->rights);
    const auto image = picture(options, catalog, setup->scene, files);
    return image ? write(options.output, *image, files) : tl::unexpected(image.error());
}

} // namespace

void addRender(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand("render", "Draw a preset into an image file");
    auto options = std::make_shared<RenderOptions>();
    command->add_option("preset", options->preset, "A preset (*.patina.json)");
    addSceneOptions(*command, options->picture);
    addSizeOption(*command, options->picture);
    command->add_flag("--auto-exposure", options->autoExposure,
                      "Set the exposure so that the mean brightness of the picture (of the "
                      "logarithms) is middle grey");
    command
        ->add_option("-o,--output", options->output.name,
                     "The image: .png, .jpg, .exr or .hdr (linear); - writes a PNG to standard "
                     "output")
        ->required();
    command->callback([options, &status] {
        const auto done = render(*options);
        status = done ? 0 : 1;
        if (!done) {
            report(done.error());
        }
    });
}

} // namespace patina
