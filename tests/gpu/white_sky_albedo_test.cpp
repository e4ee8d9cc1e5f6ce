// SPDX-License-Identifier: GPL-3.0-or-later
// How much light models give back with their own values.
#include "measure/stability/white_sky_albedo.h"

#include "core/color.h"
#include "gpu_fixture.h"

namespace patina::white_sky_albedo_test {
namespace {

Catalog shippedBlocks() {
    return loadCatalog(std::array{BlockRoot{PATINA_SOURCE_DIR "/shaders", true}});
}

TEST(WhiteSkyAlbedo, Matte_IsTheLuminanceOfItsColour) {
    const Catalog catalog = shippedBlocks();
    const Block& lambert = *catalog.find("models", "lambert");
    const auto color = std::get<glm::dvec3>(lambert.parameter("diffuse.color")->defaultValue);
    const auto albedo = whiteSkyAlbedo(catalog, lambert);
    ASSERT_TRUE(albedo);
    EXPECT_NEAR(*albedo, luminance(color), 1e-4);
}

TEST(WhiteSkyAlbedo, ModelsThatClaimToConserve_SendOutNoMoreThanArrives) {
    const Catalog catalog = shippedBlocks();
    for (const Block* model : catalog.ofKind("models")) {
        const auto albedo = whiteSkyAlbedo(catalog, *model);
        ASSERT_TRUE(albedo) << model->id;
        EXPECT_GT(*albedo, 0.0) << model->id;
        if (model->hasClaim("energy_conserving")) {
            EXPECT_LE(*albedo, 1.0 + 5e-3) << model->id; // what the rule may add
        }
    }
}

} // namespace
} // namespace patina::white_sky_albedo_test
