// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/family_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/color.h"
#include "measure/lobe/albedo_curve.h"

namespace patina {
namespace {

double strongestChannel(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

/// Returns a text with nothing in it that would end a cell.
std::string tableCell(const std::string& text) {
    std::string cell;
    for (const char letter : text) {
        cell += letter == '|' ? std::string("\\|") : std::string(1, letter);
    }
    return cell;
}

std::string claimCell(const Block& model, std::string_view claim) {
    return model.hasClaim(claim) ? "yes" : "no";
}

/// Returns three cells: the albedo at least, of a white sky and at most.
std::string albedoCells(const Catalog& catalog, const Block& model) {
    constexpr IntegralAim aim{1e-3, 20};
    const auto lobe = LobeModel::create(catalog, defaultMaterial(model));
    if (!lobe || !whyNoReflectance(model).empty()) {
        return "- | - | -";
    }
    const EnergyRange range = energyRange(albedoCurve(*lobe, 0.0, albedoAngles(10.0), aim));
    return fmt::format("{:.2f} | {:.2f} | {:.2f}", strongestChannel(range.min),
                       luminance(range.mean), strongestChannel(range.max));
}

/// Returns the first sentence of what a descriptor says of its formula.
std::string firstSentence(const std::string& text) {
    return text.substr(0, text.find(". ")) + (text.find(". ") == std::string::npos ? "" : ".");
}

std::string rowOf(const Catalog& catalog, const Block& model) {
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", tableCell(model.label),
                       model.parameters.size(), model.accuracy.size(),
                       claimCell(model, "reciprocal"), claimCell(model, "energy_conserving"),
                       albedoCells(catalog, model), tableCell(firstSentence(model.doc)),
                       tableCell(model.source));
}

} // namespace

std::string familyTable(const Catalog& catalog) {
    std::string table = "| model | values | accuracy choices | reciprocal | conserves energy | "
                        "albedo: least | white "
                        "sky | most | formula | source |\n"
                        "| --- | ---: | ---: | --- | --- | ---: | ---: | ---: | --- | --- |\n";
    for (const Block* model : catalog.ofKind(kinds::models)) {
        table += rowOf(catalog, *model);
    }
    return table;
}

} // namespace patina
