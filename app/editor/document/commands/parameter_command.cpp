// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/parameter_command.h"

#include "catalog/fills.h"

namespace patina {

namespace {

Values heldNow(const Document& document, const BlockPath& path, const Block& block) {
    Values values;
    for (const Parameter& parameter : block.parameters) {
        values.emplace(parameter.id, document.value(path, parameter));
    }
    return values;
}

/// Returns the part of `values` that `after` changes.
Values formerOf(const Values& values, const Values& after) {
    Values part;
    for (const auto& [id, value] : after) {
        part.emplace(id, values.at(id));
    }
    return part;
}

std::vector<std::string> idsOf(const Values& values) {
    std::vector<std::string> ids;
    for (const auto& [id, value] : values) {
        ids.push_back(id);
    }
    return ids;
}

/// Returns the given values and the shorthands among the others: a choice that is given sets values
/// that are not, and one that does not match what is set becomes the choice for custom values.
Values decided(const Block& block, const Values& held, Values given) {
    fillGaps(block, given);
    Values all = held;
    for (const auto& [id, value] : given) {
        all.insert_or_assign(id, roundedToFloat(value));
    }
    settleShorthands(block, all);
    std::erase_if(all, [&](const auto& each) {
        const Parameter* parameter = block.parameter(each.first);
        return !given.contains(each.first) && !(parameter != nullptr && isShorthand(*parameter));
    });
    return all;
}

} // namespace

ParameterCommand::ParameterCommand(Document& document, const BlockPath& path, const Block& block,
                                   const Parameter& parameter, const Value& after)
    : ParameterCommand(document, path,
                       Document::tr("Change %1").arg(QString::fromStdString(parameter.label)),
                       heldNow(document, path, block),
                       afterEdit(block, heldNow(document, path, block), parameter, after)) {}

ParameterCommand::ParameterCommand(Document& document, const BlockPath& path, const Block& block,
                                   const Values& given, const QString& label)
    : ParameterCommand(document, path, label, heldNow(document, path, block),
                       decided(block, heldNow(document, path, block), given)) {}

ParameterCommand::ParameterCommand(Document& document, const BlockPath& path, const QString& label,
                                   const Values& held, const Values& after)
    : ChangeCommand(document, label, ValuesTarget{path, idsOf(after)}, formerOf(held, after),
                    after) {}

void ParameterCommand::apply(const Values& values) {
    for (const auto& [id, value] : values) {
        storeValue(state(), target().path, id, value);
    }
    if (target().path.owner == BlockOwner::Material && target().path.side != Side::A) {
        showSidesOn(target().path.index);
    }
    for (const auto& [id, value] : values) {
        document().announce({DocumentChange::Value, target().path, id});
    }
}

} // namespace patina
