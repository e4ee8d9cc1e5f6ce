// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/texture_text.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "catalog/settings.h"
#include "catalog/typed_value.h"
#include "core/ordinary_file.h"
#include "material/block_assignment.h"
#include "shading/effects/textures.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

std::string fullPath(const std::string& file) {
    return isVertexColors(file) ? file : fs::absolute(file).lexically_normal().generic_string();
}

Result<void> layOn(Material& material, const std::string& key, const std::string& file,
                   const Catalog& catalog) {
    const auto opened = OrdinaryFile::open(file, maxAssetBytes);
    if (!opened && !isVertexColors(file)) {
        const Error& why = opened.error();
        return tl::unexpected(
            Error{why.file, 0, 0, why.problem,
                  fmt::format("an image, or {} for the mesh's own", vertexColorsName)});
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
    const Block settings = target.parameter == nullptr ? textureSettings(target.role)
                           : isVertexColors(use->second.file)
                               ? vertexColorSettings(target.parameter->textureChannels)
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

/// Is the key of preset files for images.
constexpr std::string_view inFiles = "textures";

/// Returns "key=FILE" for "key" and "key.file", and "key:setting=value" for "key.setting".
std::string withSetting(const Assignment& named) {
    const std::size_t dot = named.id.rfind('.');
    const std::string last = dot == std::string::npos ? std::string() : named.id.substr(dot + 1);
    const std::string key = named.id.substr(0, dot);
    if (last == "file") {
        return key + '=' + named.text;
    }
    const bool isSetting = textureSettings(textureRole(key)).parameter(last) != nullptr;
    return (isSetting ? key + ':' + last : named.id) + '=' + named.text;
}

/// Tells whether the text is no value of the parameter but a file on it.
bool isImageOnValue(const Material& material, const Assignment& assignment,
                    const Catalog& catalog) {
    const TextureUse use = textureUse(assignment.id, fullPath(assignment.text));
    const TextureTarget target = textureTarget(assignment.id, use, material, catalog);
    std::error_code ignored;
    return target.whyNot == nullptr && target.parameter != nullptr &&
           !valueFromText(*target.parameter, assignment.text) &&
           (isVertexColors(use.file) || fs::is_regular_file(use.file, ignored));
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

std::optional<std::string> textureAssignment(const Material& material, const std::string& set,
                                             const Catalog& catalog) {
    const auto cut = assignmentFrom(set);
    if (!cut) {
        return std::nullopt;
    }
    if (const std::string inside = cut->inside(inFiles); !inside.empty()) {
        return withSetting({inside, cut->text});
    }
    const std::string own = cut->inside(settings::material);
    const std::string& id = own.empty() ? cut->id : own;
    const Parameter* setting = settingsBlock(settings::material)->parameter(id);
    const bool isMap = setting != nullptr && infoOf(setting->type).isFile;
    return isMap || isImageOnValue(material, *cut, catalog) ? std::optional(id + '=' + cut->text)
                                                            : std::nullopt;
}

std::vector<std::string> filesIn(const std::vector<std::string>& textures,
                                 const std::vector<std::string>& sets) {
    std::vector<std::string> files;
    const auto add = [&files](const std::string& assignment) {
        const std::size_t equals = assignment.find('=');
        const bool laysOn = equals != std::string::npos && assignment.find(':') >= equals;
        if (laysOn && !isVertexColors(assignment.substr(equals + 1))) {
            files.push_back(fullPath(assignment.substr(equals + 1)));
        }
    };
    std::ranges::for_each(textures, add);
    for (const std::string& set : sets) {
        const auto cut = assignmentFrom(set);
        if (cut && !cut->inside(inFiles).empty()) {
            add(withSetting({cut->inside(inFiles), cut->text}));
        }
    }
    return files;
}

} // namespace patina
