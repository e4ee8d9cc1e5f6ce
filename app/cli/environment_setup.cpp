// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/environment_setup.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "catalog/fills.h"
#include "cli/command.h"
#include "cli/value_text.h"
#include "material/block_values.h"
#include "scene/environment.h"

namespace patina {
namespace {

constexpr std::string_view kind = "environment";
constexpr std::string_view prefix = "environment.";

std::string knownIds(const Catalog& catalog) {
    std::string known;
    for (const Block* block : catalog.ofKind(kind)) {
        known += block->id + ", ";
    }
    return known + "none, or an .hdr or .exr file";
}

const Block* blockWithPicture(const Catalog& catalog) {
    const std::vector<const Block*> blocks = catalog.ofKind(kind);
    const auto found = std::find_if(blocks.begin(), blocks.end(), [](const Block* block) {
        return pictureParameter(*block) != nullptr;
    });
    return found == blocks.end() ? nullptr : *found;
}

Result<void> choose(Scene& scene, const std::string& choice, const Catalog& catalog) {
    if (choice == "none") {
        scene.environment.reset();
        return {};
    }
    if (const Block* block = catalog.find(kind, choice)) {
        scene.environment = defaultBlockValues(*block);
        return {};
    }
    const Block* block = blockWithPicture(catalog);
    std::error_code ignored; // a file that cannot be asked about is none
    if (block == nullptr || !std::filesystem::is_regular_file(choice, ignored)) {
        return failure(
            fmt::format("--environment {}: no such environment and no such file", choice),
            knownIds(catalog));
    }
    scene.environment = defaultBlockValues(*block);
    scene.environment->parameters[pictureParameter(*block)->id] =
        std::filesystem::absolute(choice).generic_string();
    return {};
}

Result<void> assign(Scene& scene, const std::string& assignment, const Catalog& catalog) {
    const std::size_t equals = assignment.find('=');
    const std::string id = assignment.substr(prefix.size(), equals - prefix.size());
    const Block* block =
        scene.environment ? catalog.find(kind, scene.environment->id) : nullptr;
    const Parameter* parameter = block == nullptr ? nullptr : block->parameter(id);
    if (equals == std::string::npos || parameter == nullptr) {
        return failure(fmt::format("--set {}: the scene's environment has no such parameter",
                                   assignment),
                       block == nullptr ? "--environment" : "an id that `patina models` lists");
    }
    const auto value = valueFromText(*parameter, assignment.substr(equals + 1));
    if (!value) {
        return tl::unexpected(value.error());
    }
    Values& values = scene.environment->parameters;
    for (const auto& [changed, held] : afterEdit(*block, values, *parameter, *value)) {
        values.insert_or_assign(changed, held);
    }
    return {};
}

} // namespace

bool isForEnvironment(const std::string& assignment) {
    return assignment.starts_with(prefix);
}

Result<void> chooseEnvironment(Scene& scene, const PictureOptions& options,
                               const Catalog& catalog) {
    if (!options.environment.empty()) {
        if (auto chosen = choose(scene, options.environment, catalog); !chosen) {
            return chosen;
        }
    }
    for (const std::string& assignment : options.sets) {
        if (isForEnvironment(assignment)) {
            if (auto assigned = assign(scene, assignment, catalog); !assigned) {
                return assigned;
            }
        }
    }
    return {};
}

Result<std::shared_ptr<const EnvironmentImage>>
environmentPicture(const Scene& scene, const PictureOptions& options, const Catalog& catalog,
                   AssetClient& client) {
    const Block* block =
        scene.environment ? catalog.find(kind, scene.environment->id) : nullptr;
    const std::string_view file =
        block == nullptr ? std::string_view() : pictureFile(*scene.environment, *block);
    if (file.empty()) {
        return nullptr;
    }
    const Result<Image> panorama = client.loadImage(std::filesystem::path(file));
    if (!panorama && options.environment.empty()) {
        report(Errors{panorama.error()});
        return EnvironmentImage::missing();
    }
    return panorama.map(EnvironmentImage::from);
}

} // namespace patina
