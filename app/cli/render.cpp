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
#include "cli/content_hash.h"
#include "cli/environment_setup.h"
#include "cli/job.h"
#include "cli/long_work.h"
#include "cli/picture.h"
#include "cli/picture_options.h"
#include "cli/preset_folder.h"
#include "cli/scene_meshes.h"
#include "cli/scene_setup.h"
#include "cli/shown_view.h"
#include "cli/texture_text.h"
#include "core/auto_exposure.h"
#include "core/display_image.h"
#include "scene/turntable.h"

namespace patina {
namespace {

struct RenderOptions {
    std::vector<std::string> presets;
    PictureOptions picture;
    PictureFile output; ///< is a folder where there may be several pictures
    JobOptions job;
    std::string shown; ///< is what is drawn in place of the picture; empty: the picture
    bool autoExposure = false;
    int turntable = 0; ///< counts the pictures of a whole turn; 0 for a single one, unturned
    TurntableOf turns = TurntableOf::Object;

    bool isIntoFolder() const { return isFolder(output.name); }
};

constexpr int maxPictures = 3600;

Checked<void> checkRequest(const RenderOptions& options) {
    if (options.presets.empty() && options.picture.model.empty() && options.picture.scene.empty()) {
        return tl::unexpected(oneError(
            failure("there is nothing to render", "a preset, --model or --scene").value()));
    }
    const bool isIntoFolder = !options.presets.empty() && options.isIntoFolder();
    const bool isOfSeveral = options.presets.size() > 1 || options.job.isWanted() || isIntoFolder;
    if (isOfSeveral && (!options.isIntoFolder() || options.turntable > 0)) {
        return tl::unexpected(oneError(failure("several presets are drawn into a folder, one "
                                               "picture of each",
                                               "-o FOLDER/, without --turntable")
                                           .value()));
    }
    if (isOfSeveral) {
        return {};
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
        : options_(options), catalog_(std::move(catalog)), client_(client) {}

    /// Makes ready to draw a scene, and forgets the one before.
    Checked<void> prepare(const Scene& scene) {
        auto meshes = std::async(std::launch::async, [this, &scene] {
            return SceneMeshes::load(scene, *catalog_, client_);
        });
        const auto started = start();
        auto loaded = meshes.get();
        if (!started) {
            return tl::unexpected(oneError(started.error()));
        }
        if (!loaded) {
            return tl::unexpected(loaded.error());
        }
        report(loaded->remarks());
        textures_.emplace(client_);
        maker_->setTextures(*textures_, filesIn(options_.picture.textures, options_.picture.sets));
        const auto environment = environmentPicture(scene, options_.picture, *catalog_, client_);
        if (!environment) {
            return tl::unexpected(oneError(environment.error()));
        }
        maker_->setEnvironment(*environment, directionsFor(scene, options_.picture, *catalog_));
        maker_->setPixelRatio(options_.picture.pixelRatio);
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
        auto image = drawShown(exposed, source, display);
        return image && display ? linearFromDisplay(std::move(*image)) : std::move(image);
    }

  private:
    /// Draws the picture, or what is asked for in place of it.
    Checked<Image> drawShown(const Scene& scene, const MeshSource& meshes, bool display) {
        if (options_.shown.empty()) {
            return maker_->draw(scene, meshes, options_.picture.size, display);
        }
        const auto shown = shownView(options_.shown, scene);
        if (!shown) {
            return tl::unexpected(oneError(shown.error()));
        }
        return maker_->drawInspected(scene, meshes, options_.picture.size, display, *shown);
    }

    /// Starts the graphics driver, and again after many scenes: each has programs that are kept.
    Result<void> start() {
        constexpr int maxScenes = 250;
        if (!maker_ || ++scenes_ > maxScenes) {
            scenes_ = 1;
            maker_.reset();
            auto maker = PictureMaker::create(catalog_);
            if (!maker) {
                return tl::unexpected(maker.error());
            }
            maker_.emplace(std::move(*maker));
        }
        return {};
    }

    const RenderOptions& options_;
    std::shared_ptr<const Catalog> catalog_;
    AssetClient& client_;
    std::optional<TextureLoader> textures_;
    std::optional<SceneMeshes> meshes_;
    std::optional<PictureMaker> maker_;
    int scenes_ = 0; ///< counts those that the driver has drawn since it was started
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
        if (auto written = write({seriesFile(options.output.name, i + 1).string()}, *image, files);
            !written) {
            return written;
        }
    }
    return {};
}

/// Draws presets into a folder.
class RenderWork : public JobWork {
  public:
    RenderWork(const RenderOptions& options, std::shared_ptr<const Catalog> catalog,
               AssetClient& files)
        : options_(options), catalog_(std::move(catalog)), files_(files),
          drawer_(options, catalog_, files) {}

    Checked<nlohmann::json> resultOf(const std::string& preset) override {
        const auto setup = sceneFor(preset, options_.picture, *catalog_);
        if (!setup) {
            return tl::unexpected(setup.error());
        }
        report(setup->notes);
        files_.setRights(setup->rights);
        if (auto prepared = drawer_.prepare(setup->scene); !prepared) {
            return tl::unexpected(prepared.error());
        }
        const auto image = drawer_.draw(setup->scene);
        if (!image) {
            return tl::unexpected(image.error());
        }
        const std::string name = nameInFolder(preset, ".png");
        if (auto written = write({inFolder(name)}, *image, files_); !written) {
            return tl::unexpected(written.error());
        }
        return nlohmann::json{{"picture", name}, {"hash", fileHash(inFolder(name))}};
    }

    bool isThere(const nlohmann::json& result) const override {
        const std::string name = result.value("picture", std::string());
        return fileHash(inFolder(name)) == result.value("hash", std::string());
    }

  private:
    std::string inFolder(const std::string& name) const {
        return (std::filesystem::path(options_.output.name) / name).string();
    }

    const RenderOptions& options_;
    std::shared_ptr<const Catalog> catalog_;
    AssetClient& files_;
    RequestDrawer drawer_;
};

/// Draws every preset into the folder, also where some fail; returns the exit status.
Checked<int> renderAll(const CLI::App& command, const RenderOptions& options,
                       std::shared_ptr<const Catalog> catalog, AssetClient& files) {
    if (auto prepared = prepareFolder(options.output.name, options.presets, ".png", "picture");
        !prepared) {
        return tl::unexpected(oneError(prepared.error()));
    }
    RenderWork work(options, catalog, files);
    LongWork longWork;
    if (options.job.isWanted()) {
        return runJob(
            {command, options.job, options.presets, *catalog, options.picture.allowsOutside}, work,
            longWork);
    }
    int status = 0;
    for (const std::string& preset : options.presets) {
        if (longWork.isStopped()) {
            return LongWork::stoppedStatus;
        }
        longWork.report(preset);
        if (const auto drawn = work.resultOf(preset); !drawn) {
            report(drawn.error());
            status = 1;
        }
    }
    return status;
}

/// Draws one scene, or a turntable of it.
Checked<void> renderOne(const RenderOptions& options, std::shared_ptr<const Catalog> catalog,
                        AssetClient& files) {
    const auto setup = sceneFor(options.presets.empty() ? std::string() : options.presets.front(),
                                options.picture, *catalog);
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

/// Returns the exit status.
Checked<int> render(const CLI::App& command, const RenderOptions& options) {
    if (auto checked = checkRequest(options); !checked) {
        return tl::unexpected(checked.error());
    }
    AssetClient files;
    files.warmUp(options.output.needsImageFormats() ? AssetClient::Formats::images
                                                    : AssetClient::Formats::meshes);
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    report(catalog->errors);
    if (!options.presets.empty() && options.isIntoFolder()) {
        return renderAll(command, options, catalog, files);
    }
    return renderOne(options, catalog, files).map([] { return 0; });
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
    CLI::App* command = program.add_subcommand(
        "render", "Draw a preset into an image file, or several into a folder");
    auto options = std::make_shared<RenderOptions>();
    command->add_option("presets", options->presets, "Presets (*.patina.json)");
    addSceneOptions(*command, options->picture);
    addSizeOption(*command, options->picture);
    addPixelRatioOption(*command, options->picture);
    command->add_flag("--auto-exposure", options->autoExposure,
                      "Set the exposure so that the mean brightness of the picture (of the "
                      "logarithms) is middle grey");
    command->add_option("--show", options->shown,
                        "Something in place of the picture: " + shownViewWords());
    command
        ->add_option("-o,--output", options->output.name,
                     "The image: .png, .jpg, .exr or .hdr (linear); - writes a PNG to standard "
                     "output; FOLDER/ takes a PNG of each preset, named after its file")
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
    addJobOptions(*command, options->job);
    command->callback([command, options, &status] {
        const Checked<int> ended = render(*command, *options);
        status = ended.value_or(1);
        if (!ended) {
            report(ended.error());
        }
    });
}

} // namespace patina
