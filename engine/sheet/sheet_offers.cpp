// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/sheet_offers.h"

#include <algorithm>
#include <utility>

#include "catalog/expression.h"
#include "catalog/settings.h"
#include "material/blocks_in_use.h"
#include "sheet/axis_steps.h"

namespace patina {
namespace {

/// Tells whether a block with these values reads this parameter.
bool counts(const Parameter& parameter, const Values& values) {
    const Result<Expression> condition = Expression::parse(parameter.enabledWhen);
    return !condition || condition->evaluate(values);
}

void addValues(std::vector<AxisOffer>& offers, const Block& block, const std::string& prefix,
               const std::string& owner, const BlockValues* held = nullptr) {
    Values values = defaultValues(block);
    if (held != nullptr) {
        for (const auto& [id, value] : held->parameters) {
            values.insert_or_assign(id, value);
        }
    }
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
        offer.counts = counts(parameter, values);
        offers.push_back(std::move(offer));
    }
}

/// Adds each accuracy choice of the block that has two levels at least and is not offered yet.
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
    const Material& material = scene.objects[object].material;
    const std::vector<const Block*> blocks = blocksInUse(material, catalog);
    for (const Block* block : blocks) {
        const bool isModel = block->kind == kinds::models;
        addValues(offers, *block, isModel ? std::string() : block->kind + '.',
                  isModel ? std::string() : block->label + ": ",
                  isModel ? &material.model : material.part(block->kind));
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
