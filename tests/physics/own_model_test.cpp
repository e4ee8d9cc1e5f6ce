// SPDX-License-Identifier: GPL-3.0-or-later
// A user's two files have all that plots and fits need, though no code was compiled for them.
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "measure/lobe/half_difference_slice.h"
#include "measure/lobe/lobe_lines.h"
#include "measure/lobe/lobe_solid.h"
#include "measure/lobe/reflectance_table.h"
#include "measure/match/model_fit.h"
#include "measure/stability/sweep_cases.h"
#include "measure/stability/white_sky_albedo.h"
#include "support/program.h"

namespace patina::own_model_test {
namespace {

using std::numbers::pi;

/// Returns pi f cos(theta_l) of the model below.
double formula(double color, double wrap, double nl) {
    return color * (nl + wrap) / (1.0 + wrap);
}

class OwnModel : public testing::Test {
  protected:
    OwnModel() { write("p.diffuseColor * ((d.nl + p.wrap) / (1.0 + p.wrap))"); }

    /// Writes the two files of a model that returns `value` after `before`.
    void write(const std::string& value, const std::string& before = {}) {
        tests::writeFile(folder_ / "models/creeping.json", R"({
            "id": "creeping", "version": 1, "label": "Creeping", "summary": "A test.",
            "applications": "None.", "source": "None.",
            "parameters": [
                {"id": "diffuse.color", "label": "Colour", "doc": "A colour.", "type": "color",
                 "default": [0.8, 0.8, 0.8]},
                {"id": "wrap", "label": "Wrap", "doc": "A width.", "type": "float",
                 "default": 0.3, "min": 0.0, "max": 1.0, "step": 0.01}],
            "claims": ["finite", "non_negative", "isotropic"]})");
        tests::writeFile(folder_ / "models/creeping.glsl",
                         "// SPDX-License-"
                         "Identifier: MIT-0\n#include \"lib/directions.glsl\"\n"
                         "vec3 creeping(Directions d, Creeping p) {\n" +
                             before + "    return " + value + ";\n}\n");
        const std::array roots{BlockRoot{PATINA_SOURCE_DIR "/shaders", true},
                               BlockRoot{folder_.path(), false}};
        catalog_ = loadCatalog(roots);
        EXPECT_TRUE(catalog_.errors.empty()) << text(catalog_.errors);
    }

    Material material() const { return defaultMaterial(*catalog_.find(kinds::models, "creeping")); }

    tests::TemporaryFolder folder_;
    Catalog catalog_;
};

TEST_F(OwnModel, IsEvaluatedInDoublePrecisionFromItsText) {
    const auto values = ModelValues::of(*sweepVariant(catalog_, material()), catalog_);
    ASSERT_TRUE(values) << values.error().text();
    const glm::dvec3 v(0.0, 0.6, 0.8);
    for (const double angle : {0.0, 0.7, 1.3, 1.57}) {
        const glm::dvec3 l(std::sin(angle), 0.0, std::cos(angle));
        EXPECT_NEAR(values->at({l, v}).x, formula(0.8, 0.3, l.z), 1e-7) << angle; // 0.3f, 0.8f
    }
    Material other = material();
    other.model.parameters["wrap"] = 0.75;
    const ModelValues changed = values->with(*sweepVariant(catalog_, other));
    EXPECT_NEAR(changed.at({{0.0, 0.0, 1.0}, v}).x, formula(0.8, 0.75, 1.0), 1e-7);
}

TEST_F(OwnModel, HasEveryPlot) {
    const auto model = reflectanceModel(catalog_, material());
    ASSERT_TRUE(model) << model.error().text();
    const HalfDifferenceSlice slice = halfDifferenceSlice(*model, 4);
    EXPECT_GT(slice.at(1, 1).x, 0.1);
    const LobeSolid solid = lobeSolid(*model, {0.5, 0.0}, {3, 8});
    EXPECT_NEAR(solid.f.back().x, formula(0.8, 0.3, std::cos(0.5)) / (pi * std::cos(0.5)), 1e-6);
    for (const LobePlot plot : {LobePlot::Polar, LobePlot::Albedo}) {
        LobeRequest request;
        request.plot = plot;
        request.isSketch = true;
        const auto lines = lobeLines(catalog_, material(), request);
        ASSERT_TRUE(lines) << lines.error().text();
        EXPECT_EQ(lines->note, "");
        EXPECT_NEAR(lines->lines.front().values.front().x, plot == LobePlot::Polar ? 0.26 : 0.8,
                    0.02);
    }
    const auto table = reflectanceTable(catalog_, material(), LobeTerm::Whole, 8);
    ASSERT_TRUE(table) << table.error().text();
    EXPECT_NEAR(table->read(0.9375, 0.5).x, formula(0.8, 0.3, 0.9375), 1e-6);
}

TEST_F(OwnModel, ThatDoesNotEnd_IsRefused) {
    write("vec3(s)", "    float s = 0.0;\n    while (s < 1.0) {\n        s = s * d.nl;\n    }\n");
    const auto values = ModelValues::of(*sweepVariant(catalog_, material()), catalog_);
    ASSERT_FALSE(values);
    EXPECT_NE(values.error().text().find("does not end"), std::string::npos);
}

TEST_F(OwnModel, ThatDoesNotEndInSomeDirections_HasNoPlotsOfThem) {
    write("vec3(s)", "    float s = d.nv;\n    while (s < 0.2) {\n        s = s * d.nv;\n    }\n");
    LobeRequest request;
    request.isSketch = true;
    const auto lines = lobeLines(catalog_, material(), request);
    ASSERT_FALSE(lines);
    EXPECT_NE(lines.error().text().find("does not end"), std::string::npos);
    EXPECT_FALSE(whiteSkyAlbedo(catalog_, material()));
    EXPECT_FALSE(matchTarget(*sweepVariant(catalog_, material()), 64, catalog_));
    const MatchTarget grazing{{{{0.0, 0.0, 1.0}, {0.995, 0.0, 0.1}}}, {glm::dvec3(0.1)}, false};
    EXPECT_FALSE(
        fittedModel(*sweepVariant(catalog_, material()), grazing, {}, catalog_, Progress()));
}

TEST_F(OwnModel, ThatDoesNotEndWithSomeValues_HasThoseOfOthers) {
    write("p.diffuseColor * d.nl",
          "    float s = p.wrap;\n    while (s < 0.2) {\n        s = s * d.nl;\n    }\n");
    const auto values = ModelValues::of(*sweepVariant(catalog_, material()), catalog_);
    ASSERT_TRUE(values) << values.error().text();
    Material other = material();
    other.model.parameters["wrap"] = 0.1;
    EXPECT_FALSE(ModelValues::of(*sweepVariant(catalog_, other), catalog_));
    const ModelValues endless = values->with(*sweepVariant(catalog_, other));
    const DirectionPair facing{{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}};
    EXPECT_EQ(endless.at(facing), glm::dvec3(0.0));
    EXPECT_TRUE(endless.isEndless());
    EXPECT_NEAR(values->at(facing).x, 0.8, 1e-7);
    EXPECT_FALSE(values->isEndless());
}

TEST_F(OwnModel, WithAMistake_IsRefusedAtItsLineAndColumn) {
    write("p.diffuseColor * ((d.nl + p.wrap)) )");
    const auto values = ModelValues::of(*sweepVariant(catalog_, material()), catalog_);
    ASSERT_FALSE(values);
    EXPECT_TRUE(values.error().file.ends_with("creeping.glsl")) << values.error().text();
    EXPECT_EQ(values.error().line, 4);
    EXPECT_EQ(values.error().column, 47);
}

TEST_F(OwnModel, ReflectsAShareOfAWhiteSky) {
    write("p.diffuseColor * (d.nl * d.nv)"); // f = color n.v / pi, whose albedo is 2/3 color
    const auto albedo = whiteSkyAlbedo(catalog_, material());
    ASSERT_TRUE(albedo);
    EXPECT_NEAR(*albedo, 0.8 * 2.0 / 3.0, 1e-4);
}

TEST_F(OwnModel, IsMatchedToValuesOfItsOwn) {
    Material hidden = material();
    hidden.model.parameters["wrap"] = 0.625;
    hidden.model.parameters["diffuse.color"] = glm::dvec3(0.2, 0.5, 0.7);
    const auto target = matchTarget(*sweepVariant(catalog_, hidden), 128, catalog_);
    ASSERT_TRUE(target) << target.error().text();
    const Progress progress;
    const auto fit =
        fittedModel(*sweepVariant(catalog_, material()), *target, {}, catalog_, progress);
    ASSERT_TRUE(fit) << fit.error().text();
    EXPECT_NEAR(std::get<double>(fit->model.block.values.at("wrap")), 0.625, 1e-3);
    EXPECT_NEAR(std::get<glm::dvec3>(fit->model.block.values.at("diffuse.color")).g, 0.5, 1e-3);
    EXPECT_LT(fit->relative, 1e-4);
}

} // namespace
} // namespace patina::own_model_test
