// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"

#include <gtest/gtest.h>

namespace patina {
namespace {

Catalog shipped() {
    return loadCatalog(std::vector<BlockRoot>{{PATINA_SOURCE_DIR "/shaders", true}});
}

TEST(ShippedBlocks, Loaded_HaveNoMistakes) { EXPECT_EQ(text(shipped().errors), ""); }

TEST(ShippedBlocks, OfEveryKind_AreThere) {
    const Catalog catalog = shipped();
    for (const char* kind : {"models", "fresnel", "lights", "fog", "environment"}) {
        EXPECT_FALSE(catalog.ofKind(kind).empty()) << kind;
    }
}

TEST(ShippedBlocks, EveryParameter_HasATooltip) {
    for (const Block& block : shipped().blocks) {
        for (const Parameter& parameter : block.parameters) {
            EXPECT_FALSE(parameter.doc.empty()) << block.id << ' ' << parameter.id;
        }
    }
}

TEST(ShippedBlocks, EveryBlock_SaysWhatItIsAndWhereItIsFrom) {
    for (const Block& block : shipped().blocks) {
        EXPECT_FALSE(block.summary.empty() || block.source.empty() || block.applications.empty())
            << block.id;
    }
}

} // namespace
} // namespace patina
