// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/picture_options.h"

#include <charconv>
#include <cmath>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/option_numbers.h"
#include "core/exposure.h"
#include "core/number_text.h"

namespace patina {
namespace {

bool readWhole(std::string_view text, int& number) {
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    return status == std::errc() && end == text.data() + text.size();
}

std::string sizeFrom(const std::string& text, glm::ivec2& size) {
    const std::size_t cross = text.find_first_of("xX,");
    const bool read = cross != std::string::npos &&
                      readWhole(std::string_view(text).substr(0, cross), size.x) &&
                      readWhole(std::string_view(text).substr(cross + 1), size.y);
    return read && size.x > 0 && size.y > 0
               ? std::string()
               : "not a size: \"" + text + "\"; expected WIDTHxHEIGHT such as 640x480";
}

double stopsIn(const std::string& text) {
    return optionNumber("--exposure", text,
                        {"an exposure", fmt::format("stops, {} .. {}", -maxStops, maxStops),
                         [](double stops) { return std::abs(stops) <= maxStops; }, parseNumber});
}

std::string helpFor(const BlockKind& kind) {
    if (kind.folder == kinds::environment) {
        return "What lights the scene from all around: an environment's id, an HDR panorama's "
               "file, or none";
    }
    if (kind.folder == kinds::transparency) {
        return "How what is transparent is put together: sorted by object, or the id of another "
               "way";
    }
    if (kind.folder == kinds::lights) {
        return "A light's id in place of the scene's lights, or NAME=ID for the light of that name "
               "or one more; none; repeatable";
    }
    if (kind.isInRow) {
        return fmt::format("Ids of {} in the order in which they work over the picture, as "
                           "ID,ID, or {}",
                           kind.plural, kind.noneWord);
    }
    if (kind.owner == BlockOwner::Light) {
        return fmt::format("The {} block's id for all lights, or NAME=ID for one; {}; repeatable",
                           kind.singular, kind.noneWord);
    }
    return fmt::format("The {} block's id, or {}", kind.singular, kind.noneWord);
}

void addKind(CLI::App& command, const BlockKind& kind, PictureOptions& options) {
    if (kind.folder == kinds::models) {
        return; // models have an option already
    }
    const std::string name = fmt::format("--{}", kind.singular);
    const std::string folder(kind.folder);
    if (kind.owner == BlockOwner::Light) {
        command.add_option(name, options.ofLights[folder], helpFor(kind))
            ->type_size(1)
            ->allow_extra_args(false);
        return;
    }
    command.add_option_function<std::string>(
        name, [&options, folder](const std::string& id) { options.parts[folder] = id; },
        helpFor(kind));
}

} // namespace

const std::string& PictureOptions::part(std::string_view kind) const {
    static const std::string none;
    const auto found = parts.find(kind);
    return found == parts.end() ? none : found->second;
}

void addAllowOutside(CLI::App& command, bool& allowsOutside) {
    command.add_flag("--allow-outside", allowsOutside,
                     "Also read what a scene, a preset or a mesh names outside its own folder: "
                     "meshes, pictures, presets, images, buffers, measured surfaces");
}

void addSceneOptions(CLI::App& command, PictureOptions& options) {
    command.add_option("--model", options.model,
                       "A lighting model's id: alone, or in place of a preset's own");
    for (const BlockKind& kind : blockKinds()) {
        addKind(command, kind, options);
    }
    command
        .add_option("--set", options.sets,
                    "A parameter's value, as id=value; a file where it takes an image, "
                    "also as textures.id=FILE; repeatable")
        ->type_size(1)
        ->allow_extra_args(false);
    command
        .add_option("--texture", options.textures,
                    "An image on a value, as id=FILE (or normal=, height=, opacity=), the mesh's "
                    "vertex colours, as id=builtin:vertex-colors, or how these lie, as "
                    "id:setting=value; repeatable")
        ->type_size(1)
        ->allow_extra_args(false);
    command.add_option("--mesh", options.mesh, "A mesh file, or builtin:sphere and the like");
    command.add_option("--scene", options.scene, "A scene file; a preset goes on its first object");
    command
        .add_option("--samples", options.samples,
                    "Directions per pixel that an environment's light is summed from; unless "
                    "given as many as the scene says, but no more than 256")
        ->check(CLI::Range(1, 1 << 24));
    command.add_option_function<std::string>(
        "--exposure", [&options](const std::string& text) { options.exposure = stopsIn(text); },
        "Stops; 1 is twice as bright");
    addAllowOutside(command, options.allowsOutside);
}

void addSizeOption(CLI::App& command, PictureOptions& options) {
    command.add_option_function<std::string>(
        "--size",
        [&options](const std::string& text) {
            if (const std::string wrong = sizeFrom(text, options.size); !wrong.empty()) {
                throw CLI::ValidationError("--size", wrong);
            }
        },
        "Pixels, as WIDTHxHEIGHT");
}

void addPixelRatioOption(CLI::App& command, PictureOptions& options) {
    command
        .add_option("--pixel-ratio", options.pixelRatio,
                    "How many pixels of the picture a pixel of drawn lines, dots and outlines has: "
                    "2 for a screen of twice the density, or a picture of twice the size")
        ->check(CLI::Range(0.125, 16.0));
}

} // namespace patina
