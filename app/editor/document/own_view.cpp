// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/own_view.h"

#include <utility>

#include "catalog/settings.h"
#include "material/block_values.h"
#include "scene/environment.h"
#include "scene/mesh_path.h"

namespace patina {
namespace {

constexpr const char* environmentKey = "environment";
constexpr const char* switchedOffKey = "switchedOff";

/// Returns stops conformed to the range of the scene's exposure.
double inRange(double stops) {
    for (const Descriptor& descriptor : settingsDescriptors()) {
        const Parameter* parameter = descriptor.block.parameter(exposureSetting);
        if (descriptor.block.id == settings::scene && parameter != nullptr) {
            return std::get<double>(conformed(*parameter, stops));
        }
    }
    return stops;
}

/// Reads a view's own environment, and notes in `references` the picture file that it names.
std::optional<BlockValues> environmentFrom(JsonReader reader, const Catalog& catalog, Errors& notes,
                                           References& references) {
    BlockValues values = BlockReader{catalog, notes}.read(reader, kinds::environment);
    const Block* block = catalog.find(kinds::environment, values.id);
    const std::string file(block != nullptr ? pictureFile(values, *block) : "");
    if (!file.empty()) {
        references.mayRead(file, OutsideFile::Kind::Picture);
        values.parameters[pictureParameter(*block)->id] = meshFromFile(file, references.base());
    }
    return values;
}

} // namespace

std::optional<Value> settingOf(const OwnView& own, std::string_view id) {
    return id == exposureSetting && own.exposure ? std::optional<Value>(*own.exposure)
                                                 : std::nullopt;
}

void storeSetting(OwnView& own, std::string_view id, const Value& value) {
    if (const auto* stops = std::get_if<double>(&value); stops && id == exposureSetting) {
        own.exposure = *stops;
    }
}

void giveOwn(Scene& scene, const OwnView& own) {
    scene.exposure = own.exposure.value_or(scene.exposure);
    if (own.hasEnvironment) {
        scene.setPart(kinds::environment, own.environment);
    }
}

void relink(Scene& shown, const Scene& scene, const OwnView& own) {
    shown.exposure = scene.exposure;
    const BlockValues* environment = scene.part(kinds::environment);
    shown.setPart(kinds::environment,
                  environment != nullptr ? std::optional(*environment) : std::nullopt);
    giveOwn(shown, own);
}

nlohmann::json toJson(const OwnView& own) {
    nlohmann::json json = nlohmann::json::object();
    if (own.exposure) {
        json[exposureSetting] = *own.exposure;
    }
    if (own.hasEnvironment) {
        json[environmentKey] = own.environment ? toJson(*own.environment) : nlohmann::json();
    }
    if (own.switchedOff) {
        json[switchedOffKey] = *own.switchedOff;
    }
    return json;
}

OwnView ownViewFrom(const LocatedJson& document, const Catalog& catalog, References& references) {
    const nlohmann::json& json = document.value;
    OwnView own;
    if (!json.is_object()) {
        return own;
    }
    if (const auto found = json.find(exposureSetting); found != json.end() && found->is_number()) {
        own.exposure = inRange(found->get<double>());
    }
    if (const auto found = json.find(environmentKey); found != json.end()) {
        own.hasEnvironment = true;
        if (found->is_object()) {
            Errors notes;
            JsonReader reader(document, "", notes);
            own.environment =
                environmentFrom(reader.child(environmentKey), catalog, notes, references);
        }
    }
    if (const auto found = json.find(switchedOffKey); found != json.end() && found->is_array()) {
        own.switchedOff.emplace();
        for (const nlohmann::json& effect : *found) {
            if (effect.is_string()) {
                own.switchedOff->push_back(effect.get<std::string>());
            }
        }
    }
    return own;
}

} // namespace patina
