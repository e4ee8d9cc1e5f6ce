// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/sheet_offers.h"

#include <algorithm>
#include <utility>

#include "catalog/settings.h"
#include "material/blocks_in_use.h"
#include "sheet/axis_steps.h"

namespace patina {
namespace {

void addValues(std::vector<AxisOffer>& offers, const Block& block, const std::string& prefix,
               const std::string& owner) {
    for (const Parameter& parameter : block.parameters) {
        const bool isNumber = isOneNumber(parameter);
        const bool hasStates =
            infoOf(parameter.type).isChoice || std::holds_alternative<bool>(parameter.defaultValue);
        if (!isNumber && !hasStates) {
            continue;
        }
        AxisOffer offer{{AxisKind::Value, prefix + parameter.id}, owner + parameter.label};
        if (isNumber) {
            offer.axis.range = SheetRange{parameter.softMin, parameter.softMax, usualSheetSteps};
            offer.of = parameter;
        }
        offers.push_back(std::move(offer));
    }
}

/// The levels of each choice by itself.
void addChoices(std::vector<AxisOffer>& offers, const Block& block) {
    for (const AccuracyChoice& choice : block.accuracy) {
        const bool isNew = std::ranges::none_of(
            offers, [&choice](const AxisOffer& each) { return each.axis.value == choice.id; });
        if (isNew && choice.values.size() > 1) {
            offers.push_back({{AxisKind::Value, choice.id}, "Accuracy: " + choice.label});
        }
    }
}

} // namespace

std::vector<AxisOffer> axisOffers(const Scene& scene, std::size_t object, const Catalog& catalog) {
    std::vector<AxisOffer> offers;
    if (object >= scene.objects.size()) {
        return offers;
    }
    const std::vector<const Block*> blocks = blocksInUse(scene.objects[object].material, catalog);
    for (const Block* block : blocks) {
        const bool isModel = block->kind == kinds::models;
        addValues(offers, *block, isModel ? std::string() : block->kind + '.',
                  isModel ? std::string() : block->label + ": ");
    }
    addValues(offers, *settingsBlock(settings::material), {}, {});
    for (const Block* block : blocks) {
        addChoices(offers, *block);
    }
    for (const AxisKind kind :
         {AxisKind::Models, AxisKind::Accuracy, AxisKind::Lights, AxisKind::Environments}) {
        const auto planned = plannedAxis({kind, {}, {}, {}}, scene, object, catalog);
        if (planned && planned->steps.size() > 1) {
            offers.push_back({{kind, {}, {}, {}}, planned->title});
        }
    }
    return offers;
}

} // namespace patina
