// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "assets/asset_client.h"
#include "cli/bundle_outcomes.h"
#include "cli/environment_setup.h"
#include "cli/picture.h"
#include "cli/scene_meshes.h"
#include "cli/scene_setup.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

constexpr glm::ivec2 pictureSize{256, 256};

struct ExportOptions {
    std::vector<std::string> presets;
    std::string output;
    bool allowOutside = false;
    bool noPictures = false;
};

/// Draws presets in the default scene, one after the other.
class BundlePictures {
  public:
    explicit BundlePictures(std::shared_ptr<const Catalog> catalog)
        : catalog_(std::move(catalog)) {}

    /// Returns the bytes of a PNG file.
    Checked<std::string> draw(const SceneSetup& setup) {
        files_.setRights(setup.rights);
        if (!maker_) {
            auto made = PictureMaker::create(catalog_);
            if (!made) {
                return tl::unexpected(oneError(made.error()));
            }
            maker_.emplace(std::move(*made));
        }
        const PictureOptions options;
        const auto meshes = SceneMeshes::load(setup.scene, *catalog_, files_);
        if (!meshes) {
            return tl::unexpected(meshes.error());
        }
        TextureLoader textures(files_);
        maker_->setTextures(textures, {});
        const auto environment = environmentPicture(setup.scene, options, *catalog_, files_);
        if (!environment) {
            return tl::unexpected(oneError(environment.error()));
        }
        maker_->setEnvironment(*environment, directionsFor(setup.scene, options, *catalog_));
        const auto image = maker_->draw(
            setup.scene, [&meshes](const Object& object) { return meshes->view(object); },
            pictureSize, true);
        if (!image) {
            return tl::unexpected(image.error());
        }
        auto bytes = files_.encodeImage(".png", *image);
        return bytes ? Checked<std::string>(std::move(*bytes))
                     : tl::unexpected(oneError(bytes.error()));
    }

  private:
    std::shared_ptr<const Catalog> catalog_;
    AssetClient files_;
    std::optional<PictureMaker> maker_;
};

bool exportPresets(const ExportOptions& options) {
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    BundlePictures pictures(catalog);
    std::vector<BundledPreset> bundled;
    bool isAllRead = true;
    for (const std::string& file : options.presets) {
        PictureOptions picture;
        picture.allowsOutside = options.allowOutside;
        const auto setup = sceneFor(file, picture, *catalog);
        if (!setup) {
            report(setup.error());
            isAllRead = false;
            continue;
        }
        report(setup->notes);
        BundledPreset preset{fs::path(file).stem().stem().string(),
                             setup->scene.objects.front().material};
        if (!options.noPictures) {
            if (auto drawn = pictures.draw(*setup)) {
                preset.picture = std::move(*drawn);
            } else {
                report(drawn.error());
            }
        }
        bundled.push_back(std::move(preset));
    }
    const auto outcomes = exportBundle(options.output, bundled);
    if (!outcomes) {
        report({outcomes.error()});
        return false;
    }
    return tellOutcomes(*outcomes, options.output) && isAllRead;
}

} // namespace

void addExport(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "export", "Put presets into a zip file, with their images and a picture of each");
    auto options = std::make_shared<ExportOptions>();
    command->add_option("presets", options->presets, "Presets (*.patina.json)")->required();
    command->add_option("-o,--output", options->output, "The zip file")->required();
    command->add_flag("--allow-outside", options->allowOutside,
                      "Read what the presets name outside their folders");
    command->add_flag("--no-pictures", options->noPictures, "Draw nothing");
    command->callback([options, &status] { status = exportPresets(*options) ? 0 : 1; });
}

} // namespace patina
