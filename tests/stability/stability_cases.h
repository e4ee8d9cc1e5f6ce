// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "measure/eval/eval_case.h"

namespace patina::stability {

inline const Catalog& catalog() {
    static const Catalog loaded = loadCatalog(
        std::array{BlockRoot{std::filesystem::path(PATINA_SOURCE_DIR) / "shaders", true}});
    return loaded;
}

inline std::vector<const Block*> evaluatedBlocks() {
    std::vector<const Block*> blocks;
    for (const Block& block : catalog().blocks) {
        if (!evaluatedFunctions(block).empty()) {
            blocks.push_back(&block);
        }
    }
    return blocks;
}

/// Returns a test's name, which may have only letters, digits and underscores.
inline std::string nameOf(const testing::TestParamInfo<const Block*>& tested) {
    std::string name = tested.param->kind + '_' + tested.param->id;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

} // namespace patina::stability
