// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/measured_preset.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/measured_file.h"
#include "measured/kept_tables.h"

namespace patina {

const Parameter* tableParameter(const Block& block) {
    const auto found = std::ranges::find_if(
        block.parameters, [](const Parameter& each) { return infoOf(each.type).isTable; });
    return found == block.parameters.end() ? nullptr : &*found;
}

int measuredTableOf(const Block& block, const Values& values) {
    const Parameter* parameter = tableParameter(block);
    const auto found = parameter != nullptr ? values.find(parameter->id) : values.end();
    const auto* file = found != values.end() ? std::get_if<std::string>(&found->second) : nullptr;
    return file != nullptr ? tableOfFile(*parameter, *file) : 0;
}

Result<void> readMeasuredOf(const Material& material, const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    const Parameter* parameter = model != nullptr ? tableParameter(*model) : nullptr;
    if (parameter == nullptr) {
        return {};
    }
    if (const int table = measuredTableOf(*model, material.model.parameters); table != 0) {
        return readTable(table).map([](const auto&) {});
    }
    const auto parked = material.parked.find(parameter->id); // readPreset() puts it there
    const std::string withheld =
        parked != material.parked.end() && parked->is_string() ? parked->get<std::string>() : "";
    return withheld.empty()
               ? Result<void>()
               : failure(fmt::format("\"{}\" lies outside the folder of its preset and is not read",
                                     withheld),
                         "a measured file in that folder");
}

Checked<PresetReading> readMeasuredPreset(const std::filesystem::path& file,
                                          const Catalog& catalog) {
    const Result<SharedTable> table = readTable(file);
    if (!table) {
        return tl::unexpected(Errors{table.error()});
    }
    const bool hasGrain = (*table)->form == TableForm::WithGrain;
    const std::vector<const Block*> models = catalog.ofKind(kinds::models);
    const auto model = std::ranges::find_if(models, [hasGrain](const Block* each) {
        return tableParameter(*each) != nullptr &&
               (each->withRole(grainRole) != nullptr) == hasGrain;
    });
    if (model == models.end()) {
        return tl::unexpected(Errors{{file.string(), 0, 0, "no model shows such a file", {}}});
    }
    PresetReading reading;
    reading.material = defaultMaterial(**model);
    reading.material.name = file.stem().string();
    reading.material.description = fmt::format("Measured: {}", file.filename().string());
    reading.material.model.parameters[tableParameter(**model)->id] =
        std::filesystem::absolute(file).lexically_normal().string();
    reading.readOnly = true;
    return reading;
}

} // namespace patina
