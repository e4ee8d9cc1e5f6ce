// SPDX-License-Identifier: GPL-3.0-or-later
// The numerical check: models that break in one way each, seen pixel by pixel.
#include <algorithm>
#include <cmath>

#include "gpu_fixture.h"
#include "render/surfaces/inspection_drawer.h"
#include "shading/effects/surface_program.h"
#include "support/program.h"

namespace patina::inspection_test {
namespace {

using tests::TemporaryFolder;
using tests::writeFile;

class InspectionTest : public GpuTest {
  protected:
    /// A user's model whose value is the expression `value`, in terms of `d`.
    void makeModel(const std::string& value) {
        writeFile(folder_ / "models/broken-test.json", R"({
  "id": "broken-test", "version": 1, "label": "Broken", "summary": "s", "applications": "a",
  "source": "a test", "doc": "d",
  "parameters": [
    {"id": "zero", "label": "Zero", "type": "float", "default": 0, "min": 0, "max": 1,
     "softMin": 0, "softMax": 1, "step": 0.01, "decimals": 2, "group": "g", "doc": "d"}
  ],
  "claims": []
})");
        writeFile(folder_ / "models/broken-test.glsl",
                  "// SPDX-License-"
                  "Identifier: MIT-0\n"
                  "vec3 brokenTest(Directions d, BrokenTest p) {\n    return vec3(" +
                      value + ");\n}\n");
        const std::array roots{BlockRoot{PATINA_SOURCE_DIR "/shaders", true},
                               BlockRoot{folder_.path(), false}};
        catalog = std::make_shared<const Catalog>(loadCatalog(roots));
        ASSERT_TRUE(catalog->errors.empty()) << text(catalog->errors);
        makeRenderer();
    }

    Image inspected(const Scene& scene, bool display = false) {
        auto image =
            renderer->inspection().capture(scene, viewOf(scene, size), meshSource(), display);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        return image ? *image : Image();
    }

    glm::vec3 shownInTheMiddle(const Scene& scene, const Inspected& shown, bool display = false) {
        auto image = renderer->inspection().capture(scene, viewOf(scene, size), meshSource(),
                                                    display, shown);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        return image ? middle(*image) : glm::vec3(0.0f);
    }

    PixelDefect defectAt(const Image& image, int x, int y) {
        return static_cast<PixelDefect>(std::lround(pixel(image, x, y).g));
    }

    PixelDefect defectInTheMiddle(const std::string& value) {
        makeModel(value);
        return defectAt(inspected(simpleScene("broken-test")), size / 2, size / 2);
    }

    std::optional<PixelProbe> probe(const Scene& scene, glm::ivec2 place) {
        auto found = renderer->inspection().probe(scene, viewOf(scene, size), meshSource(), place);
        EXPECT_TRUE(found) << (found ? "" : found.error().text());
        return found ? *found : std::nullopt;
    }

    /// The leftmost place of the middle row that shows the sphere.
    int edge(const Scene& scene) {
        int x = 0;
        while (x < size / 2 && !probe(scene, {x, size / 2})) {
            ++x;
        }
        return x;
    }

    static constexpr int size = 65;
    static constexpr glm::ivec2 center{size / 2, size / 2};
    TemporaryFolder folder_;
};

/// The square root of something that is negative near the outline only.
constexpr const char* brokenAtGrazing = "sqrt(d.nv - 0.3 + p.zero)";

TEST_F(InspectionTest, NotANumberAtGrazing_IsFoundThere) {
    makeModel(brokenAtGrazing);
    const Scene scene = simpleScene("broken-test");
    EXPECT_EQ(defectAt(inspected(scene), edge(scene), size / 2), PixelDefect::NotANumber);
}

TEST_F(InspectionTest, NotANumberAtGrazing_IsNotFoundElsewhere) {
    makeModel(brokenAtGrazing);
    const PixelDefect found = defectAt(inspected(simpleScene("broken-test")), size / 2, size / 2);
    EXPECT_NE(found, PixelDefect::NotANumber);
}

TEST_F(InspectionTest, NotANumber_IsPaintedInColour) {
    makeModel(brokenAtGrazing);
    const Scene scene = simpleScene("broken-test");
    const glm::vec3 shown = pixel(inspected(scene, true), edge(scene), size / 2);
    EXPECT_GT(std::abs(shown.r - shown.g), 0.2f);
}

TEST_F(InspectionTest, SoundPixels_AreGrey) {
    makeRenderer();
    const glm::vec3 shown = middle(inspected(simpleScene(), true));
    EXPECT_EQ(shown.r, shown.g);
    EXPECT_EQ(shown.g, shown.b);
}

TEST_F(InspectionTest, NegativeValue_IsFoundBeforeItIsCut) {
    EXPECT_EQ(defectInTheMiddle("-0.001 - p.zero"), PixelDefect::Negative);
}

TEST_F(InspectionTest, InfiniteValue_IsFoundBeforeItIsCut) {
    EXPECT_EQ(defectInTheMiddle("1.0 / p.zero"), PixelDefect::Infinite);
}

TEST_F(InspectionTest, MoreLightThanArrives_IsFound) {
    EXPECT_EQ(defectInTheMiddle("1.1 * d.nl"), PixelDefect::AboveOne);
}

TEST_F(InspectionTest, AsMuchLightAsArrives_IsNoDefect) {
    EXPECT_EQ(defectInTheMiddle("d.nl"), PixelDefect::None);
}

TEST_F(InspectionTest, Albedo_IsTheShareOfAWhiteSky) {
    makeModel("0.5 * d.nl");
    const auto found = probe(simpleScene("broken-test"), center);
    ASSERT_TRUE(found && found->albedo);
    EXPECT_NEAR(found->albedo->r, 0.5f, 0.005f);
}

/// Phong's lobe with (n + 2) / 2 has the albedo 1 along the normal; seen from there its integral
/// over the hemisphere is exact.
TEST_F(InspectionTest, AlbedoOfANarrowLobe_IsExactToTwoPercent) {
    makeModel("5001.0 * pow(max(1.0 - d.versineRv, 0.0), 10000.0)");
    const auto found = probe(simpleScene("broken-test"), center);
    ASSERT_TRUE(found && found->albedo);
    EXPECT_NEAR(found->albedo->r, 1.0f, 0.02f);
}

TEST_F(InspectionTest, EnergyView_IsTheShareOfAWhiteSky) {
    makeModel("0.5 * d.nl");
    const Scene scene = simpleScene("broken-test");
    EXPECT_NEAR(shownInTheMiddle(scene, InspectedView::Energy).r, 0.5f, 0.005f);
    const glm::vec3 shown = shownInTheMiddle(scene, InspectedView::Energy, true);
    EXPECT_EQ(shown.r, shown.g); // grey: no more than arrives
}

TEST_F(InspectionTest, EnergyViewOfMoreLightThanArrives_IsRed) {
    makeModel("1.1 * d.nl");
    const glm::vec3 shown =
        shownInTheMiddle(simpleScene("broken-test"), InspectedView::Energy, true);
    EXPECT_GT(shown.r, 2.0f * shown.g);
    EXPECT_GT(shown.r, 2.0f * shown.b);
}

TEST_F(InspectionTest, NormalsView_HasTheNormal) {
    makeRenderer();
    const glm::vec3 normal = shownInTheMiddle(simpleScene(), InspectedView::Normals);
    EXPECT_NEAR(normal.z, 1.0f, 0.01f);
    const glm::vec3 tangent = shownInTheMiddle(simpleScene(), InspectedView::Tangents);
    EXPECT_NEAR(glm::length(tangent), 1.0f, 0.01f);
    EXPECT_NEAR(glm::dot(normal, tangent), 0.0f, 0.01f);
}

TEST_F(InspectionTest, DiffuseAndHighlightViews_AddUpToTheLightOfTheLamps) {
    makeRenderer();
    for (const char* model : {"phong", "ashikhmin-shirley", "cook-torrance", "lambert"}) {
        const Scene scene = simpleScene(model);
        const auto found = probe(scene, center);
        ASSERT_TRUE(found && found->lights.size() == 1);
        const glm::vec3 sum = shownInTheMiddle(scene, InspectedView::Diffuse) +
                              shownInTheMiddle(scene, InspectedView::Highlight);
        EXPECT_NEAR(sum.r, found->lights.front().value.r, 2e-3f * sum.r) << model; // half floats
        EXPECT_NEAR(sum.b, found->lights.front().value.b, 2e-3f * sum.b) << model;
    }
}

TEST_F(InspectionTest, TermsOfAModelThatMixesThem_AreShownAsUnknown) {
    makeRenderer();
    const glm::vec3 a = shownInTheMiddle(simpleScene("strauss"), InspectedView::Highlight, true);
    EXPECT_EQ(a.r, a.g);
    EXPECT_NEAR(a.r, 0.385f, 0.05f); // of either stripe
}

/// The sphere's texture coordinates, also where no image lies on it.
TEST_F(InspectionTest, CoordinatesView_HasThePlaceInAnImage) {
    makeRenderer();
    const Scene scene = simpleScene();
    const glm::vec3 middlePlace = shownInTheMiddle(scene, InspectedView::Coordinates);
    EXPECT_NEAR(middlePlace.g, 0.5f, 0.02f); // on the equator
    const auto image = renderer->inspection().capture(scene, viewOf(scene, size), meshSource(),
                                                      false, InspectedView::Coordinates);
    ASSERT_TRUE(image);
    int checks = 0;
    for (int y = 0; y < size; ++y) {
        checks += pixel(*image, size / 2, y).b != pixel(*image, size / 2, std::max(y - 1, 0)).b;
        EXPECT_LE(pixel(*image, size / 2, y).g, 1.0f);
    }
    EXPECT_GE(checks, 6); // squares from pole to pole
}

TEST_F(InspectionTest, CoordinatesViewOfMaterialsWithImages_IsTheSame) {
    makeRenderer();
    Scene scene = simpleScene();
    const glm::vec3 without = shownInTheMiddle(scene, InspectedView::Coordinates);
    scene.objects[0].material.textures["diffuse.color"] = {};
    EXPECT_EQ(shownInTheMiddle(scene, InspectedView::Coordinates), without);
}

/// Facing the viewer a dielectric of index 1.5 reflects 0.04, whatever the lights and the exposure.
TEST_F(InspectionTest, FresnelView_IsTheReflectanceAtTheViewersAngle) {
    makeRenderer();
    Scene scene = simpleScene("cook-torrance");
    scene.objects[0].material.parts["fresnel"] = block("fresnel", "dielectric");
    scene.lights.clear();
    scene.exposure = 3.0;
    EXPECT_NEAR(shownInTheMiddle(scene, InspectedView::Fresnel).g, 0.04f, 1e-3f);
    const glm::vec3 blended = [&] {
        scene.objects[0].material.model.id = "lambert";
        return shownInTheMiddle(scene, InspectedView::Fresnel);
    }();
    EXPECT_NEAR(blended.g, 0.04f, 1e-3f);
    const glm::vec3 display = shownInTheMiddle(scene, InspectedView::Fresnel, true);
    EXPECT_NEAR(display.g, 0.22f, 0.01f); // sRGB of 0.04
}

TEST_F(InspectionTest, FresnelViewWithoutSuchATerm_IsUnknown) {
    makeRenderer();
    const glm::vec3 shown = shownInTheMiddle(simpleScene("lambert"), InspectedView::Fresnel, true);
    EXPECT_NEAR(shown.r, 0.385f, 0.05f); // of either stripe
    EXPECT_EQ(shown.r, shown.g);
}

TEST_F(InspectionTest, ViewsOfEachLightAlone_AreItsShareOfThePicture) {
    makeRenderer();
    Scene scene = simpleScene("ashikhmin-shirley");
    scene.lights.push_back(sun({0.4, 0.2, -1.0}));
    scene.lights.push_back(sun({-0.9, 0.1, -1.0}));
    scene.lights.back().enabled = false;
    const auto found = probe(scene, center);
    ASSERT_TRUE(found && found->lights.size() == 2);
    for (const LightShare& share : found->lights) {
        const glm::vec3 alone = shownInTheMiddle(scene, {InspectedView::Light, share.light});
        EXPECT_NEAR(alone.r, share.value.r, 2e-3f * share.value.r); // half floats
    }
    EXPECT_EQ(shownInTheMiddle(scene, {InspectedView::Light, 2}), glm::vec3(0.0f)); // is off
}

/// The glow is linear light; without one a place is black, and not unknown.
TEST_F(InspectionTest, GlowView_IsTheLightOfTheSurfaceItself) {
    makeRenderer();
    Scene scene = simpleScene("lambert");
    EXPECT_EQ(shownInTheMiddle(scene, InspectedView::Glow, true), glm::vec3(0.0f));
    scene.objects[0].material.model.parameters["emissive.color"] = glm::dvec3(0.5, 0.25, 2.0);
    EXPECT_EQ(shownInTheMiddle(scene, InspectedView::Glow), glm::vec3(0.5f, 0.25f, 2.0f));
}

TEST_F(InspectionTest, OpacityView_IsTheShareThatTheSurfaceHides) {
    makeRenderer();
    Scene scene = simpleScene("lambert");
    EXPECT_EQ(shownInTheMiddle(scene, InspectedView::Opacity), glm::vec3(1.0f));
    scene.objects[0].material.opacity = 0.25;
    scene.exposure = 3.0;
    EXPECT_EQ(shownInTheMiddle(scene, InspectedView::Opacity), glm::vec3(0.25f));
    const glm::vec3 display = shownInTheMiddle(scene, InspectedView::Opacity, true);
    EXPECT_NEAR(display.g, 0.537f, 0.01f); // sRGB of 0.25
}

TEST_F(InspectionTest, ProbeBesideTheObject_FindsNothing) {
    makeRenderer();
    EXPECT_FALSE(probe(simpleScene(), {0, 0}));
}

TEST_F(InspectionTest, ProbeInTheMiddle_SeesTheNormal) {
    makeRenderer();
    const auto found = probe(simpleScene(), center);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->normal.z, 1.0f, 0.01f);
    EXPECT_NEAR(found->nv, 1.0f, 0.01f);
}

TEST_F(InspectionTest, ProbedColour_IsThatOfThePicture) {
    makeRenderer();
    Scene scene = simpleScene("cook-torrance");
    scene.ambient = glm::dvec3(0.1);
    scene.setPart(kinds::fog, block("fog", "exponential"));
    const auto found = probe(scene, center);
    ASSERT_TRUE(found);
    const glm::vec3 drawn = middle(capture(scene, false, size));
    // A half float has 11 bits, and the picture the mean of four places.
    EXPECT_NEAR(found->color.r, drawn.r, 2e-3f * drawn.r);
}

TEST_F(InspectionTest, ProbedTermsOfManyLights_AddUpToTheColour) {
    makeRenderer();
    Scene scene = simpleScene();
    for (int i = 0; i < 9; ++i) {
        scene.lights.push_back(sun({0.1 * i, 0.0, -1.0}));
    }
    const auto found = probe(scene, center);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->lights.size(), 10U);
    float sum = 0.0f;
    for (const LightShare& share : found->lights) {
        sum += share.value.r;
    }
    EXPECT_NEAR(sum, found->color.r, 1e-5f * sum); // ten additions
}

TEST_F(InspectionTest, ProbedValue_IsTheOneBeforeItIsCut) {
    makeModel("-0.5 - p.zero");
    const auto found = probe(simpleScene("broken-test"), center);
    ASSERT_TRUE(found && !found->lights.empty());
    EXPECT_FLOAT_EQ(found->lights.front().value.r, -0.5f);
}

TEST_F(InspectionTest, TermsThatAreNotInTheProgram_AreNotProbed) {
    makeRenderer();
    const auto found = probe(simpleScene(), center);
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->ambient || found->emission || found->blended || found->fogged);
}

TEST_F(InspectionTest, PictureAfterwards_IsTheSame) {
    makeRenderer();
    const Image before = capture(simpleScene("cook-torrance"));
    inspected(simpleScene("cook-torrance"));
    EXPECT_EQ(capture(simpleScene("cook-torrance")), before);
}

TEST_F(InspectionTest, ProgramOfAPicture_HasNothingOfIt) {
    Scene scene = simpleScene("lambert");
    scene.ambient = glm::dvec3(0.1);
    scene.setPart(kinds::fog, block("fog", "exponential"));
    const auto program =
        surfaceProgram(effectSet(scene.objects[0].material, scene, *catalog), *catalog);
    ASSERT_TRUE(program);
    for (const char* word : {"noteTerm", "lookAt", "inspected", "lookedShare", "albedo"}) {
        EXPECT_EQ(program->fragment.text.find(word), std::string::npos) << word;
    }
}

TEST_F(InspectionTest, ModelsThatClaimToConserveEnergy_AreNotAboveOne) {
    makeRenderer();
    for (const Block* model : catalog->ofKind("models")) {
        if (std::find(model->claims.begin(), model->claims.end(), "energy_conserving") ==
            model->claims.end()) {
            continue;
        }
        const Image image = inspected(simpleScene(model->id));
        int above = 0;
        for (int i = 0; i < size * size; ++i) {
            above += defectAt(image, i % size, i / size) == PixelDefect::AboveOne ? 1 : 0;
        }
        EXPECT_EQ(above, 0) << model->id;
    }
}

TEST_F(InspectionTest, UnknownModel_IsDrawnAsAFallbackWithoutTerms) {
    makeRenderer();
    Scene scene = simpleScene();
    scene.objects[0].material.model.id = "nowhere";
    const auto found = probe(scene, center);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->lights.empty() && !found->albedo);
}

TEST_F(InspectionTest, EveryModel_HasAProgramOfIt) {
    makeRenderer();
    for (const Block* model : catalog->ofKind("models")) {
        Scene scene = simpleScene(model->id);
        scene.ambient = glm::dvec3(0.1);
        scene.setPart(kinds::fog, block("fog", "exponential"));
        renderer->inspection().capture(scene, viewOf(scene, 9), meshSource(), false);
        EXPECT_EQ(text(renderer->report().messages), "") << model->id;
    }
}

} // namespace
} // namespace patina::inspection_test
