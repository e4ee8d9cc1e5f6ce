// SPDX-License-Identifier: GPL-3.0-or-later
// The row of a kind of block (added_kind.cpp) and the two files of a block that CONTRIBUTING.md
// shows are all it takes for the kind to be read, written, checked, compiled in double precision,
// evaluated, edited, and chosen on the command line.
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "catalog/json_schema.h"
#include "cli/eval_line.h"
#include "cli/picture_options.h"
#include "cli/scene_setup.h"
#include "document/document.h"
#include "gl/headless_context.h"
#include "material/preset_file.h"
#include "measure/eval/eval_gpu.h"
#include "measure/eval/eval_reference.h"
#include "measure/stability/finding_text.h"
#include "measure/stability/stability_sweep.h"
#include "measure/stability/sweep_cases.h"
#include "reference/reference.h"
#include "shading/program/block_text.h"

namespace patina::tests::added_kind_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::string_view kind = "sheen";

std::shared_ptr<const Catalog> catalog() {
    const fs::path source = PATINA_SOURCE_DIR;
    static const auto loaded = std::make_shared<const Catalog>(loadCatalog(
        std::vector<BlockRoot>{{source / "shaders", true}, {PATINA_GUIDE_SHADERS, true}}));
    return loaded;
}

const Block& velvet() {
    return *catalog()->find(kind, "velvet");
}

/// What the options make of the object of the default scene.
Checked<SceneSetup> setupWith(const std::vector<std::string>& arguments) {
    CLI::App program;
    PictureOptions options;
    addSceneOptions(program, options);
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    program.parse(reversed);
    return sceneFor({}, options, *catalog());
}

TEST(AddedKind, ItsBlocks_AreRead) {
    EXPECT_EQ(text(catalog()->errors), "");
    ASSERT_NE(catalog()->find(kind, "velvet"), nullptr);
    EXPECT_EQ(structName(velvet()), "VelvetSheen");
}

TEST(AddedKind, ItsFunctions_AreInTheReference) {
    const reference::Block* block = reference::findBlock(kind, "velvet");
    ASSERT_NE(block, nullptr);
    const std::vector<double> parameters{0.25, 0.5, 1.0, 3.0};
    const auto rim = block->call<3>("", std::array{0.5, 0.5}, parameters);
    EXPECT_DOUBLE_EQ(rim[1], 0.5 * 0.25);
    EXPECT_DOUBLE_EQ(block->call<1>("Share", {}, parameters)[0], 0.25);
}

TEST(AddedKind, MissingFunction_IsAMistakeOfItsText) {
    const Errors mistakes = blockTextMistakes(
        velvet(), "vec3 velvetSheen(Incidence i, VelvetSheen p) { return p.tint; }\n");
    ASSERT_EQ(mistakes.size(), 1u);
    EXPECT_EQ(mistakes.front().problem, "there is no function velvetSheenShare(VelvetSheen p)");
}

TEST(AddedKind, InAPreset_IsReadAsWritten) {
    Material material = defaultMaterial(*catalog()->ofKind(kinds::models).front());
    material = withPart(material, kind, nullptr, &velvet());
    const LocatedJson document{"a.patina.json", toJson(material, {}), {}};
    const auto reading = materialFromJson(document, "", *catalog());
    ASSERT_TRUE(reading);
    EXPECT_EQ(text(reading->notes), "");
    EXPECT_EQ(reading->material.parts, material.parts);
}

TEST(AddedKind, InAPreset_FollowsTheSchema) {
    const Result<JsonSchema> schema = JsonSchema::load("preset");
    ASSERT_TRUE(schema);
    Json preset = toJson(defaultMaterial(*catalog()->ofKind(kinds::models).front()), {});
    preset[std::string(kind)] = {{"id", "velvet"}, {"parameters", {{"width", 3}}}};
    EXPECT_EQ(text(schema->check({"a.patina.json", preset, {}})), "");
}

TEST(AddedKind, OnTheCommandLine_IsChosenAndSet) {
    const auto setup = setupWith({"--sheen", "velvet", "--set", "sheen.width=3"});
    ASSERT_TRUE(setup) << text(setup.error());
    const BlockValues* part = setup->scene.objects.front().material.part(kind);
    ASSERT_NE(part, nullptr);
    EXPECT_EQ(part->parameters.at("width"), Value(3.0));
}

TEST(AddedKind, WithASlipOfThePen_IsAnErrorWithTheNearestName) {
    const auto setup = setupWith({"--sheen", "velvte"});
    ASSERT_FALSE(setup);
    EXPECT_NE(text(setup.error()).find("'velvet'"), std::string::npos) << text(setup.error());
}

/// The numbers that answer a line of `patina eval`.
std::vector<double> answerTo(const std::string& line) {
    const EvalLine read = readEvalLine(line, *catalog());
    EXPECT_TRUE(read.request) << (read.request ? "" : read.request.error().text());
    if (!read.request) {
        return {};
    }
    EvalGpu gpu;
    const auto answer = read.request->gpu ? gpu.evaluate({&*read.request, 1}, *catalog()).front()
                                          : evaluatedInDouble(*read.request);
    EXPECT_TRUE(answer) << (answer ? "" : answer.error().text());
    return answer.value_or(std::vector<double>());
}

TEST(AddedKind, ItsFunctions_AreEvaluated) {
    const std::string velvetOf3 =
        R"("sheen": {"id": "velvet", "parameters": {"tint": [0.25, 0.5, 1], "width": 3}})";
    for (const char* precision : {"double", "gpu"}) {
        const std::string end = fmt::format(R"(, {}, "precision": "{}"}})", velvetOf3, precision);
        const std::vector<double> rim = answerTo(R"({"cos": 0.5)" + end);
        ASSERT_EQ(rim.size(), 3u);
        EXPECT_NEAR(rim[1], 0.125, 1e-6);
        const std::vector<double> share = answerTo(R"({"call": "Share")" + end);
        ASSERT_EQ(share.size(), 1u);
        EXPECT_NEAR(share[0], 0.25, 1e-6);
    }
}

TEST(AddedKind, ItsFunctions_AreChecked) {
    const auto context = gl::HeadlessContext::create();
    ASSERT_TRUE(context) << context.error().text();
    const std::vector<EvalCase> variants = sweepVariants(*catalog(), velvet());
    EXPECT_EQ(variants.size(), 2u);
    SweepOptions options;
    options.cases = 20000;
    options.shaders = catalog()->roots.front().folder;
    StabilitySweep sweep(variants, options);
    while (!sweep.finished()) {
        sweep.step();
    }
    EXPECT_TRUE(sweep.report().isClean()) << toJson(sweep.report());
    EXPECT_FALSE(sweep.report().withoutDouble);
}

TEST(AddedKind, InADocument_IsChosenEditedAndUndone) {
    Document document(catalog());
    document.startFrom({setupWith({})->scene, std::nullopt});
    const BlockPath path = document.selection().currentPath(kind);
    document.setBlock(path, "velvet");
    EXPECT_EQ(document.undoStack().undoText(), "Sheen Velvet");
    document.setValue(path, "width", 4.0);
    EXPECT_EQ(document.value(path, *velvet().parameter("width")), Value(4.0));
    document.undoStack().undo();
    document.undoStack().undo();
    EXPECT_EQ(blockValuesAt(document.state(), path), nullptr);
}

} // namespace
} // namespace patina::tests::added_kind_test
