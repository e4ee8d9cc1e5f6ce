// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_block.h"

#include <fmt/format.h>

#include "catalog/fills.h"
#include "cli/picture_levels.h"
#include "cli/typed_value.h"

namespace patina {

Result<void> SceneBlock::assign(const std::string& assignment, const Catalog& catalog) const {
    const std::size_t equals = assignment.find('=');
    const std::size_t start = kind.size() + 1;
    const std::string id = assignment.substr(start, equals - start);
    BlockValues* values = partOf(parts, kind);
    const Block* block = blockOf(parts, kind, catalog);
    const Parameter* parameter = block == nullptr ? nullptr : block->parameter(id);
    if (equals == std::string::npos || parameter == nullptr) {
        return failure(
            fmt::format("--set {}: the scene's {} has no such parameter", assignment, kind),
            block == nullptr ? "--" + kind : "an id that `patina models` lists");
    }
    const auto value = valueFromText(*parameter, assignment.substr(equals + 1));
    if (!value) {
        return tl::unexpected(value.error());
    }
    Values& held = values->parameters;
    for (const auto& [changed, number] : afterEdit(*block, held, *parameter, *value)) {
        held.insert_or_assign(changed, number);
    }
    return {};
}

Result<void> assignAll(const SceneBlock& block, const std::vector<std::string>& assignments,
                       const Catalog& catalog) {
    for (const std::string& assignment : assignments) {
        if (!block.owns(assignment)) {
            continue;
        }
        if (auto assigned = block.assign(assignment, catalog); !assigned) {
            return assigned;
        }
    }
    return {};
}

bool isForScene(const std::string& assignment) {
    return assignment.starts_with("environment.") || assignment.starts_with("transparency.") ||
           isOfPicture(assignment);
}

} // namespace patina
