// SPDX-License-Identifier: GPL-3.0-or-later
// Levels that read a table: what is in their programs, when tables are filled, and what is drawn.
#include <algorithm>
#include <cmath>

#include "gpu_fixture.h"
#include "measure/error/frame_error.h"
#include "measure/error/reference_frame.h"
#include "render/surfaces/surface_buffer_drawer.h"
#include "shading/effects/effect_key.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/program/program_source.h"
#include "support/program.h"

namespace patina::block_tables_test {
namespace {

using tests::TemporaryFolder;
using tests::writeFile;

class BlockTablesTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        source_ = meshSource();
    }

    Scene tabled(const std::string& model, const std::string& choice,
                 const std::string& level = "table") const {
        Scene scene = simpleScene(model);
        scene.lights.push_back(light("point"));
        scene.objects[0].material.accuracy[choice] = level;
        return scene;
    }

    View wholeView(const Scene& scene) const {
        View view = viewOf(scene, 48);
        view.samples = 1;
        view.numbers = HdrNumbers::Full;
        return view;
    }

    std::string fragment(const Scene& scene) const {
        const auto program =
            surfaceProgram(effectSet(scene.objects[0].material, scene, *catalog), *catalog);
        EXPECT_TRUE(program) << (program ? "" : text(program.error()));
        return program ? program->fragment.text : std::string();
    }

    /// Compares the device's frame with the one in double precision.
    FrameError error(const Scene& scene) {
        auto buffer = renderer->surfaces().capture(scene, wholeView(scene), source_);
        EXPECT_TRUE(buffer) << (buffer ? "" : buffer.error().text());
        auto right = ReferenceFrame::create(std::move(*buffer),
                                            std::vector<bool>(scene.objects.size(), true));
        EXPECT_TRUE(right) << (right ? "" : right.error().text());
        while (!(*right)->step(std::chrono::milliseconds(10))) {
        }
        const auto image = renderer->capture(scene, wholeView(scene), source_, false);
        EXPECT_TRUE(image);
        LinearFrame frame;
        for (std::size_t i = 0; i + 3 < image->pixels.size(); i += 4) {
            frame.colors.emplace_back(image->pixels[i], image->pixels[i + 1], image->pixels[i + 2]);
        }
        const FrameError found =
            ErrorMeter((*right)->frame(), DisplayCurve::of(scene, *catalog)).errorOf(frame);
        EXPECT_GT(found.pixels, 300u);
        return found;
    }

    int filled(const Scene& scene) {
        capture(scene);
        return renderer->report().filledTables;
    }

    MeshSource source_;
};

TEST_F(BlockTablesTest, ExactLevel_HasNoTableInItsText) {
    const std::string source = fragment(tabled("strauss", "terms", "exact"));
    EXPECT_EQ(source.find("blockTables"), std::string::npos);
    EXPECT_EQ(source.find("TermsEntry("), std::string::npos);
}

TEST_F(BlockTablesTest, TabledLevel_ReadsItsTableAlone) {
    const std::string source = fragment(tabled("strauss", "terms"));
    EXPECT_NE(source.find("readTableLine(x.x, 164, 0)"), std::string::npos);
    EXPECT_EQ(source.find("TermsEntry("), std::string::npos) << "entries are computed per pixel";
    EXPECT_NE(source.find("#define straussEvenTerms"), std::string::npos);
}

TEST_F(BlockTablesTest, ExactLevel_FillsNothing) {
    EXPECT_EQ(filled(tabled("strauss", "terms", "exact")), 0);
}

TEST_F(BlockTablesTest, SecondFrame_FillsNothing) {
    const Scene scene = tabled("strauss", "terms");
    EXPECT_EQ(filled(scene), 1);
    EXPECT_EQ(filled(scene), 0);
}

TEST_F(BlockTablesTest, ValueThatEntriesDependOn_FillsAnew) {
    Scene scene = tabled("strauss", "terms");
    filled(scene);
    scene.objects[0].material.model.parameters["kf"] = 1.5;
    EXPECT_EQ(filled(scene), 1);
    EXPECT_EQ(renderer->report().compiled, 0);
}

TEST_F(BlockTablesTest, OtherValue_FillsNothing) {
    Scene scene = tabled("strauss", "terms");
    filled(scene);
    scene.objects[0].material.model.parameters["smoothness"] = 0.8;
    EXPECT_EQ(filled(scene), 0);
}

TEST_F(BlockTablesTest, OtherLevel_FillsItsOwn) {
    filled(tabled("strauss", "terms"));
    EXPECT_EQ(filled(tabled("strauss", "terms", "even-table")), 1);
}

/// The reference means between the same entries.
TEST_F(BlockTablesTest, Picture_DiffersFromTheReferenceByRoundingOnly) {
    EXPECT_LE(error(tabled("strauss", "terms")).p99, 1e-4);
    EXPECT_LE(error(tabled("strauss", "terms", "even-table")).p99, 1e-4);
}

TEST_F(BlockTablesTest, TwoAxes_DifferFromTheReferenceByRoundingOnly) {
    EXPECT_LE(error(tabled("he-torrance", "series")).p99, 1e-4);
}

TEST_F(BlockTablesTest, ModelBetweenExactAndCosine_IsDrawnOtherwise) {
    const Image table = capture(tabled("strauss", "terms"));
    EXPECT_NE(table, capture(tabled("strauss", "terms", "cosine")));
    EXPECT_NE(table, capture(tabled("strauss", "terms", "even-table")));
}

/// A block of the user's folder, whose number an image may drive: 3 entries along u, 4 along v.
class UserTableTest : public BlockTablesTest {
  protected:
    void SetUp() override {
        BlockTablesTest::SetUp();
        writeFile(folder_ / "models/squared-test.json", R"({
  "id": "squared-test", "version": 1, "label": "Squared", "summary": "s", "applications": "a",
  "source": "a test", "doc": "d",
  "parameters": [
    {"id": "tallness", "label": "Tallness", "type": "float", "default": 0.5, "min": 0, "max": 1,
     "texture": true, "group": "g", "doc": "d"},
    {"id": "other", "label": "Other", "type": "float", "default": 0.5, "min": 0, "max": 1,
     "group": "g", "doc": "d"}
  ],
  "accuracy": [{"id": "way", "label": "Way", "doc": "d", "values": [
    {"id": "exact", "label": "Exact", "doc": "d", "exact": true},
    {"id": "table", "label": "Table", "doc": "d", "table": "squares"}]}],
  "tables": [{"id": "squares", "size": [3, 4], "of": ["tallness"]}],
  "claims": []
})");
        writeShader("p.tallness");
        load();
        renderer->setCatalog(catalog);
    }

    void writeShader(const std::string& entry) {
        writeFile(folder_ / "models/squared-test.glsl",
                  "// SPDX-License-"
                  "Identifier: MIT-0\n"
                  "vec3 squaredTestSquaresEntry(vec2 x, SquaredTest p) {\n"
                  "    return vec3(" +
                      entry +
                      " * x.x * x.x, x.y * x.y, 0.25);\n}\n"
                      "vec3 squaredTest(Directions d, SquaredTest p) {\n"
                      "    if (p.way == SQUARED_TEST_WAY_TABLE) {\n"
                      "        return squaredTestSquares(vec2(0.25, 0.5), p);\n    }\n"
                      "    return squaredTestSquaresEntry(vec2(0.25, 0.5), p);\n}\n");
    }

    void load() {
        const std::array roots{BlockRoot{PATINA_SOURCE_DIR "/shaders", true},
                               BlockRoot{folder_.path(), false}};
        catalog = std::make_shared<const Catalog>(loadCatalog(roots));
        ASSERT_TRUE(catalog->errors.empty()) << text(catalog->errors);
    }

    TemporaryFolder folder_;
};

TEST_F(UserTableTest, BetweenEntries_StandsTheirMean) {
    const Scene scene = [this] {
        Scene made = simpleScene("squared-test");
        made.objects[0].material.accuracy["way"] = "table";
        return made;
    }();
    const glm::vec3 color = middle(capture(scene));
    EXPECT_NEAR(color.r, 0.5f * 0.125f, 1e-4f);                      // of 0 and 1/4 of the height
    EXPECT_NEAR(color.g, (1.0f / 9.0f + 4.0f / 9.0f) / 2.0f, 1e-3f); // of 1/9 and 4/9
    EXPECT_NEAR(color.b, 0.25f, 1e-4f);
}

TEST_F(UserTableTest, OtherParameter_IsAMistakeInAnEntry) {
    writeShader("p.other");
    load();
    renderer->setCatalog(catalog);
    capture(simpleScene("squared-test"));
    ASSERT_FALSE(renderer->report().messages.empty());
    const Error& error = renderer->report().messages.front();
    EXPECT_EQ(error.line, 3);
    EXPECT_NE(error.problem.find("reads p.other"), std::string::npos) << error.problem;
}

TEST_F(UserTableTest, ImageThatDrivesAnEntry_MakesTheLevelExact) {
    Scene scene = simpleScene("squared-test");
    Material& material = scene.objects[0].material;
    material.textures["tallness"] = TextureUse();
    material.textures["tallness"].file = "/height.png";
    const EffectSet exact = effectSet(material, scene, *catalog);
    material.accuracy["way"] = "table";
    const EffectSet set = effectSet(material, scene, *catalog);
    EXPECT_EQ(set.model, exact.model);
    const std::vector<EffectLine> left = leftOut(set, {&material, scene, *catalog, {}});
    const auto table = std::ranges::find(left, "table/squares", &EffectLine::effect);
    ASSERT_NE(table, left.end());
    EXPECT_EQ(table->reason, "An image drives Tallness, so Way is computed exactly.");
}

TEST_F(UserTableTest, ImageThatDrivesAnEntry_LeavesTheTableOut) {
    Scene scene = simpleScene("squared-test");
    Material& material = scene.objects[0].material;
    material.accuracy["way"] = "table";
    material.textures["tallness"] = TextureUse();
    material.textures["tallness"].file = "/height.png";
    EXPECT_EQ(fragment(scene).find("blockTables"), std::string::npos);
    EXPECT_EQ(filled(scene), 0);
}

/// A Fresnel block of the user's folder whose table has no error: it is a line.
class UserFresnelTableTest : public BlockTablesTest {
  protected:
    void SetUp() override {
        BlockTablesTest::SetUp();
        writeFile(folder_ / "fresnel/line-test.json", R"({
  "id": "line-test", "version": 1, "label": "Line", "summary": "s", "applications": "a",
  "source": "a test", "doc": "d",
  "parameters": [
    {"id": "rim", "label": "Rim", "type": "float", "default": 0.75, "min": 0, "max": 1,
     "group": "g", "doc": "d"}
  ],
  "accuracy": [{"id": "way", "label": "Way", "doc": "d", "values": [
    {"id": "exact", "label": "Exact", "doc": "d", "exact": true},
    {"id": "table", "label": "Table", "doc": "d", "table": "lines"}]}],
  "tables": [{"id": "lines", "size": [256], "of": ["rim"]}],
  "claims": []
})");
        writeFile(folder_ / "fresnel/line-test.glsl",
                  "// SPDX-License-"
                  "Identifier: MIT-0\n"
                  "vec3 lineTestFresnelLinesEntry(vec2 x, LineTestFresnel p) {\n"
                  "    return vec3(p.rim + (0.125 - p.rim) * x.x);\n}\n"
                  "vec3 lineTestFresnel(Incidence i, LineTestFresnel p) {\n"
                  "    if (p.way == LINE_TEST_FRESNEL_WAY_TABLE) {\n"
                  "        return lineTestFresnelLines(vec2(i.c, 0.0), p);\n    }\n"
                  "    return lineTestFresnelLinesEntry(vec2(i.c, 0.0), p);\n}\n"
                  "vec3 lineTestFresnelTint(LineTestFresnel p) {\n    return vec3(1.0);\n}\n");
        const std::array roots{BlockRoot{PATINA_SOURCE_DIR "/shaders", true},
                               BlockRoot{folder_.path(), false}};
        catalog = std::make_shared<const Catalog>(loadCatalog(roots));
        ASSERT_TRUE(catalog->errors.empty()) << text(catalog->errors);
        renderer->setCatalog(catalog);
    }

    Scene withLine(const std::string& model, const std::string& level) const {
        Scene scene = tabled(model, "way", level);
        scene.objects[0].material.parts["fresnel"] = block("fresnel", "line-test");
        return scene;
    }

    /// The greatest difference of a channel.
    float apart(const Scene& scene, const Scene& other) {
        const auto one = renderer->capture(scene, wholeView(scene), source_, false);
        const auto two = renderer->capture(other, wholeView(other), source_, false);
        EXPECT_TRUE(one && two);
        float largest = 0.0f;
        for (std::size_t i = 0; i < one->pixels.size(); ++i) {
            largest = std::max(largest, std::abs(one->pixels[i] - two->pixels[i]));
        }
        return largest;
    }

    TemporaryFolder folder_;
};

TEST_F(UserFresnelTableTest, InASlot_IsReadFromItsTable) {
    const Scene scene = withLine("cook-torrance", "table");
    EXPECT_EQ(filled(scene), 1);
    EXPECT_NE(fragment(scene).find("readTableLine(x.x, 256, 0)"), std::string::npos);
    EXPECT_LE(apart(scene, withLine("cook-torrance", "exact")), 1e-4f);
}

TEST_F(UserFresnelTableTest, InABlend_IsReadFromItsTable) {
    const Scene scene = withLine("lambert", "table");
    EXPECT_EQ(filled(scene), 1);
    EXPECT_NE(fragment(scene).find("readTableLine(x.x, 256, 0)"), std::string::npos);
    EXPECT_LE(apart(scene, withLine("lambert", "exact")), 1e-4f);
}

TEST_F(UserFresnelTableTest, BesideAModelsTable_SharesItsTexture) {
    Scene both = withLine("he-torrance", "table");
    both.objects[0].material.accuracy["series"] = "table";
    Scene one = both;
    one.objects[0].material.accuracy["way"] = "exact";
    EXPECT_NE(fragment(both).find("readTableLine(x.x, 256, 64)"), std::string::npos);
    EXPECT_LE(apart(both, one), 1e-4f);
}

} // namespace
} // namespace patina::block_tables_test
