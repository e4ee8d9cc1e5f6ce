// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/block.h"

#include <algorithm>
#include <cctype>

#include "core/text.h"

namespace patina {
namespace {

template <class T>
const T* withId(const std::vector<T>& items, std::string_view id) {
    const auto found =
        std::find_if(items.begin(), items.end(), [id](const T& item) { return item.id == id; });
    return found == items.end() ? nullptr : &*found;
}

} // namespace

const Parameter* Block::parameter(std::string_view parameterId) const {
    return withId(parameters, parameterId);
}

const Parameter* Block::withRole(std::string_view role) const {
    const auto found = std::ranges::find(parameters, role, &Parameter::role);
    return found == parameters.end() ? nullptr : &*found;
}

const AccuracyChoice* Block::accuracyChoice(std::string_view choiceId) const {
    return withId(accuracy, choiceId);
}

const BlockTable* Block::table(std::string_view tableId) const {
    return withId(tables, tableId);
}

const Slot* Block::slot(std::string_view slotKind) const {
    const auto found = std::find_if(slots.begin(), slots.end(),
                                    [slotKind](const Slot& s) { return s.kind == slotKind; });
    return found == slots.end() ? nullptr : &*found;
}

bool Block::hasClaim(std::string_view claim) const {
    return std::find(claims.begin(), claims.end(), claim) != claims.end();
}

bool Block::hasGate(std::string_view gate) const {
    return std::find(gates.begin(), gates.end(), gate) != gates.end();
}

Values defaultValues(const Block& block) {
    Values values;
    for (const Parameter& parameter : block.parameters) {
        values.emplace(parameter.id, parameter.defaultValue);
    }
    return values;
}

std::string structName(const Block& block) {
    const BlockKind* kind = findKind(block.kind);
    const std::string_view word = kind == nullptr ? std::string_view() : kind->word;
    return capitalised(fieldName(block.id)).append(word);
}

std::string functionName(const Block& block) {
    std::string name = structName(block);
    name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    return name;
}

} // namespace patina
