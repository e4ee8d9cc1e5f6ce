// SPDX-License-Identifier: GPL-3.0-or-later
// How much light white materials give back.
#include "measure/stability/white_albedo.h"

#include <algorithm>

#include "gpu_fixture.h"

namespace patina::white_albedo_test {
namespace {

TEST(WhiteAlbedo, Matte_GivesAllOfItBack) {
    const auto catalog = loadCatalog(std::array{BlockRoot{PATINA_SOURCE_DIR "/shaders", true}});
    const auto albedo = whiteAlbedo(catalog, *catalog.find("models", "lambert"));
    ASSERT_TRUE(albedo);
    EXPECT_NEAR(*albedo, 1.0, 1e-4);
}

TEST(WhiteAlbedo, ModelsThatClaimToConserve_SendOutNoMoreThanArrives) {
    const auto catalog = loadCatalog(std::array{BlockRoot{PATINA_SOURCE_DIR "/shaders", true}});
    for (const Block* model : catalog.ofKind("models")) {
        const auto albedo = whiteAlbedo(catalog, *model);
        ASSERT_TRUE(albedo) << model->id;
        EXPECT_GE(*albedo, 0.0) << model->id;
        if (std::ranges::find(model->claims, "energy_conserving") != model->claims.end()) {
            EXPECT_LE(*albedo, 1.0 + 5e-3) << model->id; // what the rule may add
        }
    }
}

} // namespace
} // namespace patina::white_albedo_test
