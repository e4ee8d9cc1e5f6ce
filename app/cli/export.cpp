// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <iostream>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "assets/asset_client.h"
#include "cli/bundle_outcomes.h"
#include "cli/content_hash.h"
#include "cli/environment_setup.h"
#include "cli/job.h"
#include "cli/long_work.h"
#include "cli/picture.h"
#include "cli/preset_folder.h"
#include "cli/scene_meshes.h"
#include "cli/scene_setup.h"
#include "exchange/material_export.h"
#include "material/preset_file.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

constexpr glm::ivec2 pictureSize{256, 256};

struct ExportOptions {
    std::vector<std::string> presets;
    std::string output; ///< is a zip file, or a folder with one for each preset
    JobOptions job;
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

/// Returns a preset as it stands in a zip file; it has no picture where that cannot be drawn.
Checked<BundledPreset> bundled(const std::string& file, const ExportOptions& options,
                               const Catalog& catalog, BundlePictures& pictures) {
    PictureOptions picture;
    picture.allowsOutside = options.allowOutside;
    const auto setup = sceneFor(file, picture, catalog);
    if (!setup) {
        return tl::unexpected(setup.error());
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
    return preset;
}

/// Puts each preset into a zip file of its own.
class ExportWork : public JobWork {
  public:
    ExportWork(const ExportOptions& options, std::shared_ptr<const Catalog> catalog)
        : options_(options), catalog_(std::move(catalog)), pictures_(catalog_) {}

    Checked<nlohmann::json> resultOf(const std::string& preset) override {
        const auto made = bundled(preset, options_, *catalog_, pictures_);
        if (!made) {
            return tl::unexpected(made.error());
        }
        const std::string name = nameInFolder(preset, ".zip");
        const auto outcomes = exportBundle(inFolder(name), {*made});
        if (!outcomes) {
            return tl::unexpected(oneError(outcomes.error()));
        }
        if (!outcomes->front().problem.empty()) {
            return tl::unexpected(oneError(Error{preset, 0, 0, outcomes->front().problem, {}}));
        }
        return nlohmann::json{{"bundle", name}, {"hash", fileHash(inFolder(name))}};
    }

    bool isThere(const nlohmann::json& result) const override {
        const std::string name = result.value("bundle", std::string());
        return fileHash(inFolder(name)) == result.value("hash", std::string());
    }

  private:
    fs::path inFolder(const std::string& name) const { return fs::path(options_.output) / name; }

    const ExportOptions& options_;
    std::shared_ptr<const Catalog> catalog_;
    BundlePictures pictures_;
};

/// Puts each preset into a zip file of a folder, also where some fail; returns the exit status.
Checked<int> exportEach(const CLI::App& command, const ExportOptions& options,
                        const std::shared_ptr<const Catalog>& catalog) {
    if (auto made = prepareFolder(options.output, options.presets, ".zip", "zip file"); !made) {
        return tl::unexpected(oneError(made.error()));
    }
    ExportWork work(options, catalog);
    LongWork longWork;
    if (options.job.isWanted()) {
        return runJob({command, options.job, options.presets, *catalog, options.allowOutside}, work,
                      longWork);
    }
    int status = 0;
    for (const std::string& preset : options.presets) {
        if (longWork.isStopped()) {
            return LongWork::stoppedStatus;
        }
        longWork.report(preset);
        if (const auto made = work.resultOf(preset); !made) {
            report(made.error());
            status = 1;
        }
    }
    longWork.report({});
    return status;
}

/// Puts all presets into one zip file; returns the exit status.
Checked<int> exportTogether(const ExportOptions& options,
                            const std::shared_ptr<const Catalog>& catalog) {
    BundlePictures pictures(catalog);
    std::vector<BundledPreset> presets;
    bool isAllRead = true;
    for (const std::string& file : options.presets) {
        if (auto made = bundled(file, options, *catalog, pictures)) {
            presets.push_back(std::move(*made));
        } else {
            report(made.error());
            isAllRead = false;
        }
    }
    const auto outcomes = exportBundle(options.output, presets);
    if (!outcomes) {
        return tl::unexpected(oneError(outcomes.error()));
    }
    return tellOutcomes(*outcomes, options.output) && isAllRead ? 0 : 1;
}

/// Writes presets as materials of another program, and says what becomes of each value; returns the
/// exit status.
Checked<int> exportForOthers(const ExportOptions& options, const Catalog& catalog) {
    std::vector<Material> materials;
    bool isAllRead = true;
    for (const std::string& file : options.presets) {
        const auto reading = readPreset(file, catalog, {.everything = options.allowOutside});
        if (reading) {
            report(reading->notes);
            materials.push_back(reading->material);
        } else {
            report(reading.error());
            isAllRead = false;
        }
    }
    if (materials.empty()) {
        return 1;
    }
    const auto exported = exportMaterials(options.output, materials, catalog, Progress());
    if (!exported) {
        return tl::unexpected(oneError(exported.error()));
    }
    for (std::size_t i = 0; i < exported->names.size(); ++i) {
        std::cout << exported->names[i] << '\n' << exportText(exported->lines[i]);
    }
    return isAllRead ? 0 : 1;
}

Checked<int> exportPresets(const CLI::App& command, const ExportOptions& options) {
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    if (exchangeFormatOf(options.output) != nullptr && !options.job.isWanted()) {
        return exportForOthers(options, *catalog);
    }
    if (options.job.isWanted() && !isFolder(options.output)) {
        return tl::unexpected(oneError(
            failure("--results are of one zip file for each preset", "-o FOLDER/").value()));
    }
    return isFolder(options.output) ? exportEach(command, options, catalog)
                                    : exportTogether(options, catalog);
}

} // namespace

void addExport(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "export", "Put presets into a zip file, or into one for each, with their images and a "
                  "picture of each; or write them as materials of other programs");
    auto options = std::make_shared<ExportOptions>();
    command->add_option("presets", options->presets, "Presets (*.patina.json)")->required();
    command
        ->add_option(
            "-o,--output", options->output,
            "The zip file, or a folder (FOLDER/) for a zip file of each preset; or a .gltf, "
            ".glb, .mtlx or .mtl file of materials, with what becomes of each value told")
        ->required();
    command->add_flag("--allow-outside", options->allowOutside,
                      "Read what the presets name outside their folders");
    command->add_flag("--no-pictures", options->noPictures, "Draw nothing");
    addJobOptions(*command, options->job);
    command->callback([command, options, &status] {
        const Checked<int> ended = exportPresets(*command, *options);
        status = ended.value_or(1);
        if (!ended) {
            report(ended.error());
        }
    });
}

} // namespace patina
