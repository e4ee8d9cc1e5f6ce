// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/compiled_block.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/parameter_layout.h"

namespace patina {
namespace {

/// Tells whether the compiled code reads its values where the catalogue now puts them.
bool matches(const reference::Block& code, const Block& block) {
    const ParameterLayout layout = layoutOf(block);
    return layout.floats == code.size &&
           std::equal(layout.fields.begin(), layout.fields.end(), code.fields.begin(),
                      code.fields.end(),
                      [](const ParameterField& field, const reference::Field& compiled) {
                          return field.name == compiled.name && field.offset == compiled.offset &&
                                 field.components == compiled.components;
                      });
}

} // namespace

Result<const reference::Block*> compiledBlock(const Block& block) {
    const reference::Block* code = reference::findBlock(block.kind, block.id);
    if (code == nullptr || !matches(*code, block)) {
        return failure(fmt::format("{} was {} this program was built", block.id,
                                   code == nullptr ? "not there when" : "changed since"),
                       R"("precision": "gpu", or a new build)");
    }
    return code;
}

} // namespace patina
