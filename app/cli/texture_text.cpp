// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/texture_text.h"

#include <filesystem>

#include <fmt/format.h>

#include "catalog/typed_value.h"
#include "core/ordinary_file.h"
#include "shading/effects/textures.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

std::string fullPath(const std::string& file) {
    return fs::absolute(file).lexically_normal().generic_string();
}

Result<void> layOn(Material& material, const std::string& key, const std::string& file,
                   const Catalog& catalog) {
    if (const auto opened = OrdinaryFile::open(file, maxAssetBytes); !opened) {
        const Error& why = opened.error();
        return tl::unexpected(Error{why.file, 0, 0, why.problem, "an image"});
    }
    const TextureUse use = textureUse(key, fullPath(file));
    if (const char* why = textureTarget(key, use, material, catalog).whyNot) {
        return failure(fmt::format("--texture {}: {}", key, why),
                       "a value that takes an image, or normal, height or opacity");
    }
    material.textures[key] = use;
    return {};
}

Result<void> change(Material& material, const std::string& key, const std::string& setting,
                    const std::string& text, const Catalog& catalog) {
    const auto use = material.textures.find(key);
    if (use == material.textures.end()) {
        return failure(fmt::format("--texture {}:{}: there is no image", key, setting),
                       fmt::format("--texture {}=FILE before it", key));
    }
    const TextureTarget target = textureTarget(key, use->second, material, catalog);
    const Block settings = target.parameter == nullptr
                               ? textureSettings(target.role)
                               : textureSettings(target.role, target.parameter->textureChannels);
    const Parameter* parameter = settings.parameter(setting);
    if (parameter == nullptr) {
        std::string known;
        for (const Parameter& each : settings.parameters) {
            known += (known.empty() ? "one of " : ", ") + each.id;
        }
        return failure(fmt::format("--texture {}: an image has no \"{}\"", key, setting), known);
    }
    const auto value = valueFromText(*parameter, text);
    if (!value) {
        return tl::unexpected(value.error());
    }
    storeTextureSetting(use->second, setting, *value);
    return {};
}

} // namespace

Result<void> applyTexture(Material& material, const std::string& assignment,
                          const Catalog& catalog) {
    const std::size_t equals = assignment.find('=');
    const std::string name = assignment.substr(0, equals);
    if (equals == std::string::npos || name.empty()) {
        return failure(fmt::format("--texture {}: this sets nothing", assignment),
                       "id=FILE or id:setting=value");
    }
    const std::string text = assignment.substr(equals + 1);
    const std::size_t colon = name.find(':');
    return colon == std::string::npos
               ? layOn(material, name, text, catalog)
               : change(material, name.substr(0, colon), name.substr(colon + 1), text, catalog);
}

std::vector<std::string> filesIn(const std::vector<std::string>& assignments) {
    std::vector<std::string> files;
    for (const std::string& assignment : assignments) {
        const std::size_t equals = assignment.find('=');
        if (equals != std::string::npos && assignment.find(':') >= equals) {
            files.push_back(fullPath(assignment.substr(equals + 1)));
        }
    }
    return files;
}

} // namespace patina
