// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <filesystem>
#include <future>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "assets/asset_client.h"
#include "cli/environment_setup.h"
#include "cli/picture.h"
#include "cli/picture_options.h"
#include "cli/scene_meshes.h"
#include "cli/scene_setup.h"
#include "cli/texture_text.h"
#include "core/auto_exposure.h"
#include "core/display_image.h"
#include "scene/turntable.h"

namespace patina {
namespace {

struct RenderOptions {
    std::string preset;
    PictureOptions picture;
    PictureFile output;
    bool autoExposure = false;
    int turntable = 0; ///< counts the pictures of a whole turn; 0 for a single one, unturned
    TurntableOf turns = TurntableOf::Object;
};

constexpr int maxPictures = 3600;
constexpr int digits = 4; ///< counts the digits of a picture's number in a series

Checked<void> checkRequest(const RenderOptions& options) {
    if (options.preset.empty() && options.picture.model.empty() && options.picture.scene.empty()) {
        return tl::unexpected(oneError(
            failure("there is nothing to render", "a preset, --model or --scene").value()));
    }
    if (auto checked = options.output.check(); !checked) {
        return tl::unexpected(oneError(checked.error()));
    }
    if (options.turntable > 0 && options.output.isStandardOutput()) {
        return tl::unexpected(oneError(failure("a turntable is a series of files",
                                               "-o with the name of a file, such as turn.png")
                                           .value()));
    }
    return {};
}

/// Draws the pictures of a request: meshes are read while the graphics driver starts.
class RequestDrawer {
  public:
    RequestDrawer(const RenderOptions& options, std::shared_ptr<const Catalog> catalog,
                  AssetClient& client)
        : options_(options), catalog_(std::move(catalog)), client_(client), textures_(client) {}

    Checked<void> prepare(const Scene& scene) {
        auto meshes = std::async(std::launch::async, [this, &scene] {
            return SceneMeshes::load(scene, *catalog_, client_);
        });
        auto maker = PictureMaker::create(catalog_);
        auto loaded = meshes.get();
        if (!maker) {
            return tl::unexpected(oneError(maker.error()));
        }
        if (!loaded) {
            return tl::unexpected(loaded.error());
        }
        report(loaded->remarks());
        maker->setTextures(textures_, filesIn(options_.picture.textures));
        const auto environment = environmentPicture(scene, options_.picture, *catalog_, client_);
        if (!environment) {
            return tl::unexpected(oneError(environment.error()));
        }
        maker->setEnvironment(*environment, directionsFor(scene, options_.picture, *catalog_));
        maker_.emplace(std::move(*maker));
        meshes_.emplace(std::move(*loaded));
        return {};
    }

    Checked<Image> draw(const Scene& scene) {
        const bool display = !options_.output.isLinear();
        const MeshSource source = [this](const Object& object) { return meshes_->view(object); };
        Scene exposed = scene;
        if (options_.autoExposure) {
            exposed.exposure = 0.0;
            auto linear = maker_->draw(exposed, source, options_.picture.size, false);
            if (!linear) {
                return linear;
            }
            exposed.exposure = autoExposure(*linear).value_or(scene.exposure);
        }
        auto image = maker_->draw(exposed, source, options_.picture.size, display);
        return image && display ? linearFromDisplay(std::move(*image)) : std::move(image);
    }

  private:
    const RenderOptions& options_;
    std::shared_ptr<const Catalog> catalog_;
    AssetClient& client_;
    TextureLoader textures_;
    std::optional<SceneMeshes> meshes_;
    std::optional<PictureMaker> maker_;
};

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

/// Returns the name of a picture in a series: "turn.0001.png" of "turn.png".
PictureFile numbered(const PictureFile& file, int number) {
    const std::filesystem::path path(file.name);
    const std::string name =
        fmt::format("{}.{:0{}}{}", path.stem().string(), number, digits, path.extension().string());
    return {(path.parent_path() / name).string()};
}

/// Draws a whole turn in even steps; the picture after the last one would equal the first.
Checked<void> renderSeries(const RenderOptions& options, const Catalog& catalog, const Scene& scene,
                           RequestDrawer& drawer, AssetClient& files) {
    for (int i = 0; i < options.turntable; ++i) {
        const auto turned =
            onTurntable(scene, catalog, options.turns, 360.0 * i / options.turntable);
        if (!turned) {
            return tl::unexpected(oneError(turned.error()));
        }
        const auto image = drawer.draw(*turned);
        if (!image) {
            return tl::unexpected(image.error());
        }
        if (auto written = write(numbered(options.output, i + 1), *image, files); !written) {
            return written;
        }
    }
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
    RequestDrawer drawer(options, catalog, files);
    if (auto prepared = drawer.prepare(setup->scene); !prepared) {
        return prepared;
    }
    if (options.turntable > 0) {
        return renderSeries(options, *catalog, setup->scene, drawer, files);
    }
    const auto image = drawer.draw(setup->scene);
    return image ? write(options.output, *image, files) : tl::unexpected(image.error());
}

std::map<std::string, TurntableOf> turntableChoices() {
    std::map<std::string, TurntableOf> choices;
    for (std::size_t i = 0; i < turntableWords.size(); ++i) {
        choices.emplace(turntableWords[i], static_cast<TurntableOf>(i));
    }
    return choices;
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
    command
        ->add_option("--turntable", options->turntable,
                     "So many pictures of a whole turn, numbered: turn.png is turn.0001.png ...")
        ->check(CLI::Range(1, maxPictures));
    command
        ->add_option("--turn", options->turns,
                     "What a turntable turns: object, light or "
                     "environment")
        ->transform(CLI::CheckedTransformer(turntableChoices()));
    command->callback([options, &status] {
        const auto done = render(*options);
        status = done ? 0 : 1;
        if (!done) {
            report(done.error());
        }
    });
}

} // namespace patina
