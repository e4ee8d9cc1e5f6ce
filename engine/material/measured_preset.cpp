// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/measured_preset.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/numbered_texts.h"
#include "measured/kept_tables.h"

namespace patina {

const Parameter* tableParameter(const Block& block) {
    const auto found = std::ranges::find_if(
        block.parameters, [](const Parameter& each) { return infoOf(each.type).isTable; });
    return found == block.parameters.end() ? nullptr : &*found;
}

int measuredFileOf(const Block& block, const Values& values) {
    const Parameter* parameter = tableParameter(block);
    const auto found = parameter != nullptr ? values.find(parameter->id) : values.end();
    const auto* file = found != values.end() ? std::get_if<std::string>(&found->second) : nullptr;
    return file != nullptr ? numberOfText(*file) : 0;
}

Checked<PresetReading> readMeasuredPreset(const std::filesystem::path& file,
                                          const Catalog& catalog) {
    const std::vector<const Block*> models = catalog.ofKind(kinds::models);
    const auto model = std::ranges::find_if(
        models, [](const Block* each) { return tableParameter(*each) != nullptr; });
    if (model == models.end()) {
        return tl::unexpected(Errors{{file.string(), 0, 0, "no model shows a measured file", {}}});
    }
    const Result<SharedTable> table = readTable(file);
    if (!table) {
        return tl::unexpected(Errors{table.error()});
    }
    PresetReading reading;
    reading.material = defaultMaterial(**model);
    reading.material.name = file.stem().string();
    reading.material.description = fmt::format("Measured: {}", file.filename().string());
    reading.material.model.parameters[tableParameter(**model)->id] =
        std::filesystem::absolute(file).lexically_normal().string();
    reading.readOnly = true;
    if ((*table)->isWithoutGrain) {
        reading.notes.push_back({file.string(),
                                 0,
                                 0,
                                 "the surface has a grain, and is shown as the mean over all ways "
                                 "it may be turned; a match knows the grain",
                                 {}});
    }
    return reading;
}

} // namespace patina
