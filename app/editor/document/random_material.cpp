// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/random_material.h"

#include "catalog/random_value.h"
#include "document/value_locks.h"
#include "material/model_swap.h"

namespace patina {
namespace {

/// Returns the paths of the blocks that the active material is made of.
std::vector<BlockPath> pathsOf(const Document& document) {
    const Block* model = document.block(document.selection().currentPath(kinds::models));
    std::vector<BlockPath> paths;
    if (model) {
        paths.push_back(document.selection().currentPath(kinds::models));
        for (const std::string_view kind : partKinds(BlockOwner::Material)) {
            if (hasPlaceFor(*model, kind) &&
                document.block(document.selection().currentPath(kind))) {
                paths.push_back(document.selection().currentPath(kind));
            }
        }
    }
    return paths;
}

} // namespace

void randomiseMaterial(Document& document, const std::function<double()>& next) {
    std::vector<std::pair<BlockPath, Values>> random;
    for (const BlockPath& path : pathsOf(document)) {
        Values values;
        for (const Parameter& parameter : document.block(path)->parameters) {
            const auto value = isLocked(document.state(), path, parameter.id)
                                   ? std::nullopt
                                   : randomValue(parameter, next);
            if (value) {
                values.emplace(parameter.id, *value);
            }
        }
        if (!values.empty()) {
            random.emplace_back(path, std::move(values));
        }
    }
    const QString label = Document::tr("Randomise the material");
    const auto edit = [&] {
        for (const auto& [path, values] : random) {
            document.setValues(path, values, label);
        }
    };
    if (random.size() == 1) {
        edit();
    } else if (!random.empty()) {
        document.editAsOneStep(label, edit);
    }
}

} // namespace patina
