// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <algorithm>
#include <filesystem>
#include <future>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "assets/asset_client.h"
#include "catalog/json_text.h"
#include "cli/environment_setup.h"
#include "cli/long_work.h"
#include "cli/picture.h"
#include "cli/picture_options.h"
#include "cli/scene_meshes.h"
#include "cli/scene_setup.h"
#include "cli/sheet_axis.h"
#include "cli/texture_text.h"
#include "core/display_image.h"
#include "measure/cost/cell_meter.h"
#include "measure/stability/white_sky_albedo.h"
#include "sheet/sheet_file.h"
#include "sheet/sheet_picture.h"
#include "sheet/sheet_table.h"

namespace patina {
namespace {

struct SheetOptions {
    std::string source; ///< a preset or a sheet
    std::string x;
    std::string y;
    std::optional<int> cell;
    bool noControl = false;
    std::vector<std::string> numbers;
    PictureOptions picture;
    PictureFile output;

    bool isTable() const { return std::filesystem::path(output.name).extension() == ".csv"; }
};

/// What is drawn: the sheet, and the preset that it starts from.
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
    if (options.isTable() && sheet.numbers.empty()) {
        sheet.numbers = {CellNumber::Time, CellNumber::Error, CellNumber::Albedo};
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

/// Draws and measures the cells of a sheet, one after the other.
class SheetMaker {
  public:
    SheetMaker(const SheetPlan& plan, const Sheet& sheet, const SheetOptions& options)
        : plan_(plan), sheet_(sheet), options_(options),
          picture_(plan, sheet.name,
                   {sheet.cellPixels,
                    options.isTable() ? 0 : static_cast<int>(sheet.numbers.size()),
                    !options.output.isLinear()}) {}

    /// Reads the meshes while the graphics driver starts.
    Checked<void> begin(AssetClient& client) {
        client_ = &client;
        auto meshes = std::async(std::launch::async, [this, &client] {
            return SceneMeshes::load(plan_.start(), client);
        });
        auto maker = PictureMaker::create(plan_.catalog());
        auto loaded = meshes.get();
        if (!maker) {
            return tl::unexpected(oneError(maker.error()));
        }
        if (!loaded) {
            return tl::unexpected(loaded.error());
        }
        report(loaded->remarks());
        meshes_.emplace(std::move(*loaded));
        maker_.emplace(std::move(*maker));
        textures_.emplace(client);
        maker_->setTextures(*textures_, filesIn(options_.picture.textures));
        return {};
    }

    /// All cells; those that cannot be drawn say why. False where it was stopped before.
    Checked<bool> run() {
        LongWork work;
        const int cells = plan_.columns() * plan_.rows();
        for (int i = 0; i < cells; ++i) {
            if (work.isStopped()) {
                return false;
            }
            work.tell(fmt::format("cell {} of {}", i + 1, cells));
            const int column = i % plan_.columns();
            const int row = i / plan_.columns();
            const auto done = plan_.isControl(row) && column > 0 ? repeatStart(column, row)
                                                                 : make(column, row, work);
            if (!done) {
                return tl::unexpected(done.error());
            }
        }
        const bool isAny =
            std::ranges::any_of(rows_, [](const CellRow& row) { return row.problem.empty(); });
        return isAny ? Checked<bool>(true)
                     : tl::unexpected(oneError(failure(rows_.front().problem).value()));
    }

    const Image& image() const { return picture_.image(); }
    std::string csv() const { return sheetCsv(plan_, rows_); }

  private:
    MeshSource meshes() const {
        return [this](const Object& object) { return meshes_->view(object); };
    }

    /// The cell, with what was measured of it. An error ends the sheet.
    Checked<void> make(int column, int row, const LongWork& work) {
        CellRow made{column, row};
        const Result<Scene> scene = plan_.scene(column, row);
        if (!scene) {
            return refuse(std::move(made), scene.error().problem);
        }
        if (auto shown = showEnvironment(*scene); !shown) {
            return shown;
        }
        if (options_.isTable()) {
            made.numbers = measured(*scene, work);
            rows_.push_back(std::move(made));
            return {};
        }
        const auto image = maker_->draw(*scene, meshes(), glm::ivec2(sheet_.cellPixels),
                                        !options_.output.isLinear());
        if (!image) {
            report(image.error());
            return refuse(std::move(made), "it cannot be drawn");
        }
        made.numbers = measured(*scene, work);
        picture_.put(column, row, *image, captionOf(made.numbers, sheet_.numbers));
        start_ = *image;
        rows_.push_back(std::move(made));
        return {};
    }

    /// All cells of the control row are one.
    Checked<void> repeatStart(int column, int row) {
        CellRow again = rows_.back();
        again.column = column;
        if (!options_.isTable() && again.problem.empty()) {
            picture_.put(column, row, start_, captionOf(again.numbers, sheet_.numbers));
        }
        rows_.push_back(std::move(again));
        return {};
    }

    Checked<void> refuse(CellRow cell, std::string why) {
        picture_.putProblem(cell.column, cell.row, why);
        cell.problem = std::move(why);
        rows_.push_back(std::move(cell));
        return {};
    }

    /// Reads a picture only where a cell has another environment than the one before.
    Checked<void> showEnvironment(const Scene& scene) {
        const BlockValues* wanted = scene.part(kinds::environment);
        const std::optional<BlockValues> environment =
            wanted == nullptr ? std::nullopt : std::optional(*wanted);
        if (hasEnvironment_ && environment == environment_) {
            return {};
        }
        const auto picture =
            environmentPicture(scene, options_.picture, *plan_.catalog(), *client_);
        if (!picture) {
            return tl::unexpected(oneError(picture.error()));
        }
        environment_ = environment;
        hasEnvironment_ = true;
        panorama_ = *picture;
        maker_->setEnvironment(panorama_, directionsFor(scene, options_.picture, *plan_.catalog()));
        return {};
    }

    bool wants(CellNumber number) const {
        return std::ranges::find(sheet_.numbers, number) != sheet_.numbers.end();
    }

    CellNumbers measured(const Scene& scene, const LongWork& work) {
        CellNumbers numbers;
        if (wants(CellNumber::Albedo)) {
            numbers.albedo =
                whiteSkyAlbedo(*plan_.catalog(), scene.objects[plan_.object()].material);
        }
        if ((wants(CellNumber::Time) || wants(CellNumber::Error)) && hasMeter()) {
            const CellMeter::Subject subject{scene, plan_.object(), panorama_};
            const auto noted = [](const Result<double>& number) {
                return number ? std::optional(*number) : std::nullopt;
            };
            if (wants(CellNumber::Time)) {
                numbers.milliseconds = noted(meter_->milliseconds(subject));
            }
            if (wants(CellNumber::Error)) {
                numbers.error = noted(meter_->error(subject, glm::ivec2(sheet_.cellPixels),
                                                    [&work] { return work.isStopped(); }));
            }
        }
        return numbers;
    }

    bool hasMeter() {
        if (meter_ == nullptr && !hasNoMeter_) {
            auto meter = CellMeter::create({plan_.catalog(), meshes(), textures_->source()},
                                           programCacheFolder());
            hasNoMeter_ = !meter;
            if (meter) {
                meter_ = std::move(*meter);
            } else {
                report(oneError(meter.error()));
            }
        }
        return meter_ != nullptr;
    }

    const SheetPlan& plan_;
    const Sheet& sheet_;
    const SheetOptions& options_;
    AssetClient* client_ = nullptr;
    std::optional<SceneMeshes> meshes_;
    std::optional<PictureMaker> maker_;
    std::optional<TextureLoader> textures_;
    std::unique_ptr<CellMeter> meter_;
    bool hasNoMeter_ = false;
    SheetPicture picture_;
    Image start_; ///< the last cell that was drawn
    std::vector<CellRow> rows_;
    bool hasEnvironment_ = false;
    std::optional<BlockValues> environment_; ///< whose picture is shown
    std::shared_ptr<const EnvironmentImage> panorama_;
};

Checked<void> write(const SheetOptions& options, const SheetMaker& maker, AssetClient& client) {
    const auto checked = [](const auto& done) {
        return done ? Checked<void>() : tl::unexpected(oneError(done.error()));
    };
    if (options.isTable()) {
        return checked(writeFileAtomically(options.output.name, maker.csv()));
    }
    const Image image =
        options.output.isLinear() ? maker.image() : linearFromDisplay(maker.image());
    if (!options.output.isStandardOutput()) {
        return checked(client.saveImage(options.output.name, image));
    }
    const auto bytes = client.encodeImage(".png", image);
    if (bytes) {
        std::cout << *bytes;
    }
    return checked(bytes);
}

/// Returns the status of the program.
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
    SheetMaker maker(*plan, request->sheet, options);
    if (auto begun = maker.begin(client); !begun) {
        return tl::unexpected(begun.error());
    }
    const auto isWhole = maker.run();
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
