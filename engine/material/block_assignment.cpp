// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/block_assignment.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/fills.h"
#include "catalog/suggestion.h"
#include "catalog/typed_value.h"

namespace patina {

std::string Assignment::inside(std::string_view word) const {
    const bool isIn = id.size() > word.size() && id.starts_with(word) && id[word.size()] == '.';
    return isIn ? id.substr(word.size() + 1) : std::string();
}

Result<Assignment> assignmentFrom(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        return failure(std::string("this sets nothing"), "id=value");
    }
    return Assignment{text.substr(0, equals), text.substr(equals + 1)};
}

Result<bool> assignIn(const Block& block, Values& values, const Assignment& assignment) {
    const Parameter* parameter = block.parameter(assignment.id);
    if (parameter == nullptr) {
        return false;
    }
    const auto value = valueFromText(*parameter, assignment.text);
    if (!value) {
        return tl::unexpected(value.error());
    }
    for (const auto& [changed, held] : afterEdit(block, values, *parameter, *value)) {
        values.insert_or_assign(changed, held);
    }
    return true;
}

std::vector<std::string> parameterIds(const Block& block, const std::string& prefix) {
    std::vector<std::string> ids;
    for (const Parameter& parameter : block.parameters) {
        ids.push_back(prefix + parameter.id);
    }
    return ids;
}

const BlockKind* kindCalled(std::string_view singular) {
    const auto all = blockKinds();
    const auto found = std::ranges::find(all, singular, &BlockKind::singular);
    return found == all.end() ? nullptr : &*found;
}

Result<const Block*> knownBlock(const Catalog& catalog, std::string_view kind,
                                const std::string& id) {
    if (const Block* block = catalog.find(kind, id)) {
        return block;
    }
    std::vector<std::string> known;
    const BlockKind* row = findKind(kind);
    if (row != nullptr && row->isPart) {
        known.emplace_back(row->noneWord);
    }
    for (const Block* block : catalog.ofKind(kind)) {
        known.push_back(block->id);
    }
    return failure(fmt::format("{}: no block \"{}\" is known", kind, id), oneOf(id, known));
}

} // namespace patina
