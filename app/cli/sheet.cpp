// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <future>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "assets/asset_client.h"
#include "cli/environment_setup.h"
#include "cli/long_work.h"
#include "cli/picture.h"
#include "cli/picture_options.h"
#include "cli/scene_meshes.h"
#include "cli/scene_setup.h"
#include "cli/sheet_axis.h"
#include "cli/texture_text.h"
#include "core/display_image.h"
#include "measure/cells/sheet_maker.h"
#include "sheet/sheet_file.h"

namespace patina {
namespace {

struct SheetOptions {
    std::string source; ///< is the file of a preset or of a sheet
    std::string x;
    std::string y;
    std::optional<int> cell;
    bool noControl = false;
    std::vector<std::string> numbers;
    PictureOptions picture;
    PictureFile output;

    SheetForm form() const { return sheetFormOf(output.name); }
    bool isTable() const { return form() == SheetForm::Table; }
};

/// Holds what is drawn: the sheet, and the preset that it starts from.
struct SheetRequest {
    Sheet sheet;
    std::string preset;
};

bool isSheetFile(const std::string& file) {
    return file.ends_with(sheetEnding);
}

Checked<SheetRequest> requestFromFile(const SheetOptions& options) {
    ReadingRights rights;
    rights.everything = options.picture.allowsOutside;
    auto reading = readSheet(options.source, rights);
    if (!reading) {
        return tl::unexpected(reading.error());
    }
    report(reading->notes);
    std::string preset = reading->sheet.preset;
    return SheetRequest{std::move(reading->sheet), std::move(preset)};
}

Result<void> readAxes(Sheet& sheet, const SheetOptions& options) {
    const auto named = [](const char* option, Error error) {
        error.problem = fmt::format("{}: {}", option, error.problem);
        return error;
    };
    if (!options.x.empty()) {
        const auto axis = axisFromText(options.x);
        if (!axis) {
            return tl::unexpected(named("--x", axis.error()));
        }
        sheet.x = *axis;
    }
    if (!options.y.empty()) {
        const auto axis = axisFromText(options.y);
        if (!axis) {
            return tl::unexpected(named("--y", axis.error()));
        }
        sheet.y = *axis;
    }
    return {};
}

Result<void> readNumbers(Sheet& sheet, const SheetOptions& options) {
    if (!options.numbers.empty()) {
        sheet.numbers.clear();
    }
    for (const std::string& word : options.numbers) {
        const auto number = cellNumberOf(word);
        if (!number) {
            return failure(fmt::format("--numbers: there is no number \"{}\"", word),
                           "time, error or albedo");
        }
        sheet.numbers.push_back(*number);
    }
    return {};
}

Checked<SheetRequest> requestFor(const SheetOptions& options) {
    SheetRequest request;
    if (isSheetFile(options.source)) {
        auto read = requestFromFile(options);
        if (!read) {
            return read;
        }
        request = std::move(*read);
    } else {
        request.preset = options.source;
        if (options.x.empty()) {
            return tl::unexpected(
                oneError(failure("the sheet has no axis", "--x, or a sheet's file").value()));
        }
    }
    if (const auto read = readAxes(request.sheet, options); !read) {
        return tl::unexpected(oneError(read.error()));
    }
    if (const auto read = readNumbers(request.sheet, options); !read) {
        return tl::unexpected(oneError(read.error()));
    }
    request.sheet.cellPixels = options.cell.value_or(request.sheet.cellPixels);
    request.sheet.hasControlRow = request.sheet.hasControlRow && !options.noControl;
    return request;
}

/// Draws the cells of a plan; meshes are read while the graphics driver starts.
class SheetStudio {
  public:
    SheetStudio(const SheetPlan& plan, const Sheet& sheet, const SheetOptions& options,
                AssetClient& client)
        : plan_(plan), sheet_(sheet), options_(options), client_(client) {}

    Checked<void> open() {
        auto meshes = std::async(std::launch::async, [this] {
            return SceneMeshes::load(plan_.start(), *plan_.catalog(), client_);
        });
        auto pictures = PictureMaker::create(plan_.catalog());
        auto loaded = meshes.get();
        if (!pictures) {
            return tl::unexpected(oneError(pictures.error()));
        }
        if (!loaded) {
            return tl::unexpected(loaded.error());
        }
        report(loaded->remarks());
        meshes_.emplace(std::move(*loaded));
        pictures_.emplace(std::move(*pictures));
        textures_.emplace(client_);
        pictures_->setTextures(*textures_,
                               filesIn(options_.picture.textures, options_.picture.sets));
        cells_.emplace(supplies());
        return {};
    }

    CellMaker& cells() { return *cells_; }

  private:
    CellMaker::Supplies supplies() {
        const auto surroundings = [this](const Scene& scene) {
            return environmentPicture(scene, options_.picture, *plan_.catalog(), client_);
        };
        const auto draw = [this](const Scene& scene, const CellMaker::Panorama& panorama) {
            return picture(scene, panorama);
        };
        return {{plan_.catalog(), meshes(), textures_->source()},
                programCacheFolder(),
                surroundings,
                draw};
    }

    MeshSource meshes() const {
        return [this](const Object& object) { return meshes_->view(object); };
    }

    Checked<Image> picture(const Scene& scene, const CellMaker::Panorama& panorama) {
        pictures_->setEnvironment(panorama,
                                  directionsFor(scene, options_.picture, *plan_.catalog()));
        auto image = pictures_->draw(scene, meshes(), glm::ivec2(sheet_.cellPixels),
                                     options_.form() == SheetForm::Display);
        if (!image) {
            report(image.error());
        }
        return image;
    }

    const SheetPlan& plan_;
    const Sheet& sheet_;
    const SheetOptions& options_;
    AssetClient& client_;
    std::optional<SceneMeshes> meshes_;
    std::optional<PictureMaker> pictures_;
    std::optional<TextureLoader> textures_;
    std::optional<CellMaker> cells_;
};

Checked<void> write(const SheetOptions& options, const SheetMaker& maker, AssetClient& client) {
    const auto checked = [](const auto& done) {
        return done ? Checked<void>() : tl::unexpected(oneError(done.error()));
    };
    if (!options.output.isStandardOutput()) {
        return checked(maker.write(options.output.name, client));
    }
    const auto bytes = client.encodeImage(".png", linearFromDisplay(maker.image()));
    if (bytes) {
        std::cout << *bytes;
    }
    return checked(bytes);
}

/// Returns the exit status.
Checked<int> drawSheet(const SheetOptions& options) {
    if (auto checked = options.output.check(); !checked && !options.isTable()) {
        return tl::unexpected(oneError(checked.error()));
    }
    const auto request = requestFor(options);
    if (!request) {
        return tl::unexpected(request.error());
    }
    AssetClient client;
    client.warmUp(options.output.needsImageFormats() && !options.isTable()
                      ? AssetClient::Formats::images
                      : AssetClient::Formats::meshes);
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    report(catalog->errors);
    auto setup = sceneFor(request->preset, options.picture, *catalog);
    if (!setup) {
        return tl::unexpected(setup.error());
    }
    report(setup->notes);
    client.setRights(setup->rights);
    const auto plan = SheetPlan::of(request->sheet, std::move(setup->scene), 0, catalog);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    SheetStudio studio(*plan, request->sheet, options, client);
    if (auto opened = studio.open(); !opened) {
        return tl::unexpected(opened.error());
    }
    SheetMaker maker(*plan, request->sheet, options.form(), studio.cells());
    LongWork work;
    const auto isWhole = maker.run([&work](int done, int cells) {
        work.report(fmt::format("cell {} of {}", done + 1, cells));
        return !work.isStopped();
    });
    if (const auto& problem = studio.cells().meterProblem()) {
        report(oneError(*problem));
    }
    if (!isWhole) {
        return tl::unexpected(isWhole.error());
    }
    return write(options, maker, client).map([&isWhole] {
        return *isWhole ? 0 : LongWork::stoppedStatus;
    });
}

} // namespace

void addSheet(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "sheet", "Draw a contact sheet: a preset again and again along one or two axes");
    auto options = std::make_shared<SheetOptions>();
    command->add_option("source", options->source,
                        "A preset (*.patina.json) or a sheet (*.patina-sheet.json)");
    command->add_option("--x", options->x,
                        "The axis to the right: id=from:to:steps, id=value,value, or models, "
                        "accuracy, lights or environments, alone or with a list");
    command->add_option("--y", options->y, "The axis down");
    command->add_option("--cell", options->cell, "Pixels of a cell's side")
        ->check(CLI::Range(minCellPixels, maxCellPixels));
    command->add_flag("--no-control", options->noControl,
                      "Leave out the row that shows the start below each column");
    command
        ->add_option("--numbers", options->numbers,
                     "What is measured of each cell: time, error, albedo; a .csv has all")
        ->delimiter(',');
    addSceneOptions(*command, options->picture);
    command
        ->add_option("-o,--output", options->output.name,
                     "The image: .png, .jpg, .exr or .hdr (linear); .csv writes a table of the "
                     "cells; - writes a PNG to standard output")
        ->required();
    command->callback([options, &status] {
        const auto done = drawSheet(*options);
        status = done.value_or(1);
        if (!done) {
            report(done.error());
        }
    });
}

} // namespace patina
