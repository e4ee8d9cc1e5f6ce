// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/accuracy_block.h"

namespace patina {
namespace {

void addChoice(Block& block, const AccuracyChoice& choice) {
    if (choice.values.empty() || block.parameter(choice.id) != nullptr) {
        return;
    }
    Parameter parameter;
    parameter.type = ParameterType::Enum;
    parameter.id = choice.id;
    parameter.label = choice.label;
    parameter.doc = choice.doc;
    parameter.defaultValue = choice.values.front().id;
    parameter.values = choice.values;
    parameter.compiled = Compiled::Yes;
    block.parameters.push_back(std::move(parameter));
}

} // namespace

Block accuracyBlock(std::span<const Block* const> blocks) {
    Block block;
    block.id = "accuracy";
    block.label = "Accuracy";
    for (const Block* used : blocks) {
        for (const AccuracyChoice& choice : used->accuracy) {
            addChoice(block, choice);
        }
    }
    return block;
}

} // namespace patina
