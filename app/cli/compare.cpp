// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "assets/asset_client.h"
#include "assets/comparison_page.h"
#include "cli/environment_setup.h"
#include "cli/image_difference.h"
#include "cli/picture.h"
#include "cli/picture_options.h"
#include "cli/scene_meshes.h"
#include "cli/scene_setup.h"
#include "cli/texture_text.h"
#include "core/atomic_file.h"
#include "core/display_image.h"
#include "core/label.h"

namespace patina {
namespace {

/// Gives the colours of the sides A to D on a page.
constexpr std::array sideColors{"#f0a04b", "#5bb6e8", "#8fce6a", "#d58be0"};

struct CompareOptions {
    std::vector<std::string> presets;
    PictureOptions picture;
    PictureFile output;
    std::string mode = "side";
};

/// Holds one of the pictures that are compared.
struct Side {
    char letter = 'A';
    Scene scene;
    FileRights rights;
    Image image;

    std::string name() const {
        const std::string& material = scene.objects.front().material.name;
        return material.empty() ? scene.objects.front().material.model.id : material;
    }
};

Checked<std::vector<Side>> sidesFor(const CompareOptions& options, const Catalog& catalog) {
    std::vector<Side> sides;
    for (const std::string& preset : options.presets) {
        auto setup = sceneFor(preset, options.picture, catalog);
        if (!setup) {
            return tl::unexpected(setup.error());
        }
        report(setup->notes);
        sides.push_back({static_cast<char>('A' + sides.size()),
                         std::move(setup->scene),
                         std::move(setup->rights),
                         {}});
    }
    return sides;
}

Checked<void> draw(std::vector<Side>& sides, const CompareOptions& options,
                   const std::shared_ptr<const Catalog>& catalog) {
    auto maker = PictureMaker::create(catalog);
    if (!maker) {
        return tl::unexpected(oneError(maker.error()));
    }
    maker->setPixelRatio(options.picture.pixelRatio);
    AssetClient client;
    TextureLoader textures(client);
    maker->setTextures(textures, filesIn(options.picture.textures, options.picture.sets));
    for (Side& side : sides) {
        client.setRights(side.rights);
        const auto meshes = SceneMeshes::load(side.scene, *catalog, client);
        if (!meshes) {
            return tl::unexpected(meshes.error());
        }
        if (&side == &sides.front()) { // all sides show the same objects
            report(meshes->remarks());
        }
        const auto environment = environmentPicture(side.scene, options.picture, *catalog, client);
        if (!environment) {
            return tl::unexpected(oneError(environment.error()));
        }
        maker->setEnvironment(*environment, directionsFor(side.scene, options.picture, *catalog));
        auto image = maker->draw(
            side.scene, [&meshes](const Object& object) { return meshes->view(object); },
            options.picture.size, true);
        if (!image) {
            return tl::unexpected(image.error());
        }
        side.image = std::move(*image);
    }
    return {};
}

Image sideBySide(const std::vector<Side>& sides) {
    const Image& first = sides.front().image;
    Image all{first.width * static_cast<int>(sides.size()), first.height, first.channels, {}};
    all.pixels.reserve(first.pixels.size() * sides.size());
    const std::size_t row = std::size_t(first.width) * std::size_t(first.channels);
    for (std::size_t y = 0; y < std::size_t(first.height); ++y) {
        for (const Side& side : sides) {
            const float* start = side.image.pixels.data() + y * row;
            all.pixels.insert(all.pixels.end(), start, start + row);
        }
    }
    const int scale = std::max(1, first.height / 200);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const int left = static_cast<int>(i) * first.width;
        drawLabel(all, fmt::format("{}  {}", sides[i].letter, sides[i].name()), {left, 0}, scale,
                  left + first.width);
    }
    return all;
}

/// Returns the error metrics of every side against the first, one line each.
std::vector<std::string> metrics(const std::vector<Side>& sides) {
    std::vector<std::string> lines;
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const ImageDifference apart = difference(sides.front().image, sides[i].image);
        lines.push_back(fmt::format("{} ({}) against {} ({}): FLIP {:.5f}, RMSE {:.5f}, largest "
                                    "difference {:.5f}, {:.2f} % of the pixels differ",
                                    sides[i].letter, sides[i].name(), sides.front().letter,
                                    sides.front().name(), apart.flip, apart.rootMeanSquare,
                                    apart.largest, 100.0 * apart.changedShare));
    }
    return lines;
}

void printMetrics(const std::vector<Side>& sides, std::ostream& out) {
    for (const std::string& line : metrics(sides)) {
        out << line << '\n';
    }
}

bool isPage(const PictureFile& output) {
    return std::filesystem::path(output.name).extension() == ".html";
}

Checked<void> writePage(const CompareOptions& options, const std::vector<Side>& sides,
                        AssetClient& client) {
    std::vector<PagePicture> pictures;
    std::string title;
    for (const Side& side : sides) {
        const auto png = client.encodeImage(".png", linearFromDisplay(side.image));
        if (!png) {
            return tl::unexpected(oneError(png.error()));
        }
        const auto place = static_cast<std::size_t>(side.letter - 'A');
        pictures.push_back({std::string(1, side.letter), side.name(), sideColors[place], *png});
        title += (title.empty() ? "" : ", ") + side.name();
    }
    const auto written =
        writeFileAtomically(options.output.name, comparisonPage(title, pictures, metrics(sides)));
    if (!written) {
        return tl::unexpected(oneError(written.error()));
    }
    printMetrics(sides, std::cout);
    return {};
}

Checked<void> write(const CompareOptions& options, const std::vector<Side>& sides,
                    AssetClient& client) {
    if (isPage(options.output)) {
        return writePage(options, sides, client);
    }
    const Image image = linearFromDisplay(sideBySide(sides));
    if (!options.output.isStandardOutput()) {
        const auto saved = client.saveImage(options.output.name, image);
        if (!saved) {
            return tl::unexpected(oneError(saved.error()));
        }
        printMetrics(sides, std::cout);
        return {};
    }
    const auto bytes = client.encodeImage(".png", image);
    if (!bytes) {
        return tl::unexpected(oneError(bytes.error()));
    }
    std::cout << *bytes;
    printMetrics(sides, std::cerr);
    return {};
}

Checked<void> compare(const CompareOptions& options) {
    if (auto checked = options.output.check(); !checked && !isPage(options.output)) {
        return tl::unexpected(oneError(checked.error()));
    }
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    report(catalog->errors);
    auto sides = sidesFor(options, *catalog);
    if (!sides) {
        return tl::unexpected(sides.error());
    }
    AssetClient images;
    images.warmUp(options.output.needsImageFormats() && !isPage(options.output)
                      ? AssetClient::Formats::images
                      : AssetClient::Formats::meshes);
    const auto drawn = draw(*sides, options, catalog);
    return drawn ? write(options, *sides, images) : drawn;
}

} // namespace

void addCompare(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "compare", "Draw two to four presets side by side and print how far they are apart");
    auto options = std::make_shared<CompareOptions>();
    command->add_option("presets", options->presets, "Two to four presets (*.patina.json)")
        ->required()
        ->expected(2, 4)
        ->option_text("FILE FILE [FILE [FILE]] REQUIRED");
    addSceneOptions(*command, options->picture);
    addSizeOption(*command, options->picture);
    addPixelRatioOption(*command, options->picture);
    command->add_option("--mode", options->mode, "How they are shown: side by side, with letters")
        ->check(CLI::IsMember({"side"}))
        ->capture_default_str();
    command
        ->add_option("-o,--output", options->output.name,
                     "The image: .png, .jpg, .exr or .hdr; .html writes a page that wipes between "
                     "them; - writes a PNG to standard output")
        ->required();
    command->callback([options, &status] {
        const auto done = compare(*options);
        status = done ? 0 : 1;
        if (!done) {
            report(done.error());
        }
    });
}

} // namespace patina
