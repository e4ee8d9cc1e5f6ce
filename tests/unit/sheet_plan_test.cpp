// SPDX-License-Identifier: GPL-3.0-or-later
// Which scene each cell of a contact sheet shows.
#include "sheet/sheet_plan.h"

#include <gtest/gtest.h>

#include "sheet_fixture.h"

namespace patina::sheet_plan_test {
namespace {

using tests::sheetCatalog;
using tests::sheetScene;

SheetAxis range(const std::string& id, double from, double to, int steps) {
    return {AxisKind::Value, id, SheetRange{from, to, steps}, {}};
}

SheetAxis list(AxisKind kind, std::vector<std::string> entries = {}) {
    return {kind, {}, {}, std::move(entries)};
}

SheetAxis values(const std::string& id, std::vector<std::string> entries = {}) {
    return {AxisKind::Value, id, {}, std::move(entries)};
}

Checked<SheetPlan> planned(SheetAxis x, std::optional<SheetAxis> y = {}) {
    Sheet sheet;
    sheet.x = std::move(x);
    sheet.y = std::move(y);
    return SheetPlan::of(sheet, sheetScene(), 0, sheetCatalog());
}

SheetPlan plan(SheetAxis x, std::optional<SheetAxis> y = {}) {
    auto made = planned(std::move(x), std::move(y));
    EXPECT_TRUE(made) << text(made.error());
    return made.value_or(SheetPlan());
}

std::string mistakes(SheetAxis x, std::optional<SheetAxis> y = {}) {
    const auto made = planned(std::move(x), std::move(y));
    return made ? std::string() : text(made.error());
}

double gloss(const SheetPlan& plan, int column, int row) {
    const auto scene = plan.scene(column, row);
    EXPECT_TRUE(scene);
    return std::get<double>(scene->objects[0].material.model.parameters.at("gloss"));
}

std::vector<std::string> labels(const PlannedAxis& axis) {
    std::vector<std::string> all;
    for (const SheetStep& step : axis.steps) {
        all.push_back(step.label);
    }
    return all;
}

TEST(SheetPlan, Range_HasBothEndsAndEvenSteps) {
    const SheetPlan made = plan(range("gloss", 0.0, 1.0, 5));
    ASSERT_EQ(made.columns(), 5);
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(gloss(made, i, 0), 0.25 * i) << i;
    }
}

TEST(SheetPlan, RangeOfALogarithmicSlider_HasEvenRatios) {
    const SheetPlan made = plan(range("sheen", 1.0, 1000.0, 4));
    EXPECT_EQ(labels(made.x()), (std::vector<std::string>{"1", "10", "100", "1000"}));
}

TEST(SheetPlan, OneStep_IsTheRangesBegin) {
    EXPECT_EQ(gloss(plan(range("gloss", 0.25, 1.0, 1)), 0, 0), 0.25);
}

TEST(SheetPlan, Axes_VaryTheirOwnValueAlone) {
    const SheetPlan made = plan(range("gloss", 0.0, 1.0, 3), values("weave"));
    ASSERT_EQ(made.rows(), 3); // two weaves and the start
    const auto scene = made.scene(2, 1);
    ASSERT_TRUE(scene);
    Scene expected = sheetScene();
    expected.objects[0].material.model.parameters["gloss"] = 1.0;
    expected.objects[0].material.model.parameters["weave"] = std::string("twill");
    EXPECT_EQ(*scene, expected);
    EXPECT_EQ(made.cellLabel(2, 1), "Gloss 1, Weave Twill");
}

TEST(SheetPlan, ControlRow_IsTheStartInEveryColumn) {
    const SheetPlan made = plan(range("gloss", 0.0, 1.0, 3), values("weave"));
    EXPECT_TRUE(made.isControl(2));
    EXPECT_FALSE(made.isControl(1));
    EXPECT_EQ(made.scene(0, 2).value(), sheetScene());
    EXPECT_EQ(made.scene(2, 2).value(), sheetScene());
    EXPECT_EQ(made.rowLabel(2), "Start");
}

TEST(SheetPlan, WithoutAControlRow_HasTheSweptRowsOnly) {
    Sheet sheet;
    sheet.x = range("gloss", 0.0, 1.0, 3);
    sheet.hasControlRow = false;
    const auto made = SheetPlan::of(sheet, sheetScene(), 0, sheetCatalog());
    ASSERT_TRUE(made);
    EXPECT_EQ(made->rows(), 1);
}

TEST(SheetPlan, ValuesWithCommas_AreTakenAsTyped) {
    const SheetPlan made = plan(values("tint", {"1,0,0", "#00ff00"}));
    const auto tint = made.scene(0, 0)->objects[0].material.model.parameters.at("tint");
    EXPECT_EQ(tint, Value(glm::dvec3(1.0, 0.0, 0.0)));
}

TEST(SheetPlan, ValueOfTheScene_IsNamedWithItsOwner) {
    const SheetPlan made = plan(range("light.key.gloss", 0.0, 1.0, 2), range("fog.gloss", 0, 1, 2));
    EXPECT_EQ(made.x().title, "Key: Gloss");
    const Scene scene = made.scene(1, 1).value();
    EXPECT_EQ(scene.lights[0].block.parameters.at("gloss"), Value(1.0));
    EXPECT_EQ(scene.lights[1].block.parameters.at("gloss"), Value(0.5));
    EXPECT_EQ(scene.part("fog")->parameters.at("gloss"), Value(1.0));
}

TEST(SheetPlan, ModelsWithoutAList_AreAllThereAre) {
    const SheetPlan made = plan(list(AxisKind::Models));
    EXPECT_EQ(labels(made.x()), (std::vector<std::string>{"Label of chalk", "Label of velvet"}));
    EXPECT_EQ(made.scene(0, 0)->objects[0].material.model.id, "chalk");
}

TEST(SheetPlan, ValueByModel_GoesOntoTheModelThatTheCellHas) {
    const SheetPlan made = plan(range("gloss", 0.0, 1.0, 3), list(AxisKind::Models));
    const Scene scene = made.scene(2, 0).value();
    EXPECT_EQ(scene.objects[0].material.model.id, "chalk");
    EXPECT_EQ(gloss(made, 2, 0), 1.0);
}

TEST(SheetPlan, ValueThatAModelLacks_IsAnErrorOfItsCellsAlone) {
    const SheetPlan made = plan(range("sheen", 1.0, 10.0, 2), list(AxisKind::Models));
    EXPECT_FALSE(made.scene(0, 0));
    EXPECT_TRUE(made.scene(0, 1));
}

TEST(SheetPlan, Accuracy_IsExactAndEachLevelByItself) {
    const SheetPlan made = plan(list(AxisKind::Accuracy));
    EXPECT_EQ(labels(made.x()), (std::vector<std::string>{"Exact", "Fast"}));
    EXPECT_EQ(made.scene(1, 0)->objects[0].material.accuracy.at("power"), "fast");
    EXPECT_EQ(made.scene(0, 0)->objects[0].material.accuracy.at("power"), "full");
}

TEST(SheetPlan, AccuracyChoiceAsAValue_GoesThroughItsLevels) {
    const SheetPlan made = plan(values("power"));
    EXPECT_EQ(made.x().title, "Power");
    EXPECT_EQ(labels(made.x()), (std::vector<std::string>{"Full", "Fast"}));
}

TEST(SheetPlan, Lights_AreTogetherAndEachAlone) {
    const SheetPlan made = plan(list(AxisKind::Lights));
    EXPECT_EQ(labels(made.x()), (std::vector<std::string>{"All lights", "Key", "Fill"}));
    const Scene alone = made.scene(2, 0).value();
    EXPECT_FALSE(alone.lights[0].enabled);
    EXPECT_TRUE(alone.lights[1].enabled);
}

TEST(SheetPlan, KindOfLight_StandsInPlaceOfAll) {
    const Scene scene = plan(list(AxisKind::Lights, {"lamp", "none"})).scene(0, 0).value();
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].name, "Label of lamp");
}

TEST(SheetPlan, Environments_AreNoneAndEach) {
    const SheetPlan made = plan(list(AxisKind::Environments));
    EXPECT_EQ(made.scene(0, 0)->part("environment"), nullptr);
    ASSERT_NE(made.scene(1, 0)->part("environment"), nullptr);
    EXPECT_EQ(made.scene(1, 0)->part("environment")->id, "sky");
}

TEST(SheetPlan, EachMistake_IsToldWithItsAxis) {
    EXPECT_NE(
        mistakes(range("glos", 0, 1, 2)).find("x: the model \"velvet\" has no such parameter"),
        std::string::npos);
    EXPECT_NE(mistakes(range("gloss", 0, 7, 2)).find("x: gloss: \"7\" is not a value for it"),
              std::string::npos);
    EXPECT_NE(mistakes(range("gloss", 0, 1, 2), range("tint", 0, 1, 2)).find("y: \"tint\""),
              std::string::npos);
    EXPECT_NE(mistakes(list(AxisKind::Models, {"chalky"})).find("'chalk'"), std::string::npos);
    EXPECT_NE(mistakes(list(AxisKind::Accuracy, {"power=slow"})).find("is not a level of it"),
              std::string::npos);
    EXPECT_NE(mistakes(list(AxisKind::Lights, {"Rim"})).find("there is no light \"Rim\""),
              std::string::npos);
    EXPECT_NE(mistakes(range("gloss", 0, 1, 2), range("gloss", 0, 1, 3)).find("both axes"),
              std::string::npos);
    EXPECT_NE(mistakes(range("gloss", 0, 1, 33)).find("33 steps"), std::string::npos);
}

TEST(SheetPlan, Cell_IsBroughtIntoAnotherObjectToo) {
    const SheetPlan made = plan(range("gloss", 0.0, 1.0, 3));
    Scene scene = sheetScene();
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].material.model.parameters["sheen"] = 7.0;
    ASSERT_TRUE(made.apply(scene, 1, 2, 0));
    EXPECT_EQ(scene.objects[0], sheetScene().objects[0]);
    EXPECT_EQ(scene.objects[1].material.model.parameters.at("gloss"), Value(1.0));
    EXPECT_EQ(scene.objects[1].material.model.parameters.at("sheen"), Value(7.0));
}

TEST(SheetPlan, SceneWithoutTheObject_IsAnError) {
    EXPECT_FALSE(SheetPlan::of(Sheet{.x = range("gloss", 0, 1, 2)}, Scene(), 0, sheetCatalog()));
}

} // namespace
} // namespace patina::sheet_plan_test
