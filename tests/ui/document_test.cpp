// SPDX-License-Identifier: GPL-3.0-or-later
// The document without widgets: what edits do, and what undo takes back.
#include <gtest/gtest.h>

#include "document/scene_edits.h"
#include "ui/fixtures.h"

namespace patina::tests::document_test {

namespace {

/// Undoes everything, does it again, and says whether both ends are what they were.
bool survivesUndoAndRedo(Document& document, const DocumentState& before) {
    const DocumentState after = document.state();
    while (document.undoStack().canUndo()) {
        document.undoStack().undo();
    }
    const bool undone = document.state() == before;
    while (document.undoStack().canRedo()) {
        document.undoStack().redo();
    }
    return undone && document.state() == after && !(before == after);
}

struct DocumentEdit : testing::Test {
    FixtureDocument fixture;
    Document& document = fixture.document;
    DocumentState before = document.state();
};

} // namespace

TEST(FixtureBlocks, Loaded_HaveNoMistakes) {
    EXPECT_EQ(text(FixtureBlocks().catalog()->errors), "");
}

TEST_F(DocumentEdit, AccuracyOfThePicture_UndoesAndRedoes) {
    document.setValue(pathOf(settings::scene), "picture.lighting", std::string("vertex"));
    EXPECT_TRUE(document.scene().accuracy.lightsAtVertices());
    EXPECT_TRUE(survivesUndoAndRedo(document, before));
}

TEST_F(DocumentEdit, Parameter_UndoesAndRedoes) {
    document.setValue(fixture.model(), "roughness", 0.75);
    EXPECT_TRUE(survivesUndoAndRedo(document, before));
}

/// A document whose Fresnel block has a choice that sets two other values.
struct ShorthandEdit : testing::Test {
    FixtureBlocks blocks;
    std::unique_ptr<Document> document;

    void SetUp() override {
        blocks.add("fresnel", "alloy", R"({
  "id": "alloy", "version": 1, "label": "Alloy", "summary": "For tests.",
  "parameters": [
    {"id": "a", "label": "A", "type": "float", "default": 0.1},
    {"id": "b", "label": "B", "type": "float", "default": 0.2},
    {"id": "sort", "label": "Sort", "type": "enum", "default": "one", "values": [
      {"id": "one", "label": "One", "fills": {"a": 0.1, "b": 0.2}},
      {"id": "two", "label": "Two", "fills": {"a": 0.5, "b": 0.6}},
      {"id": "custom", "label": "Your own"}]}
  ],
  "claims": ["finite"]
})",
                   "vec3 alloyFresnel(Incidence i, AlloyFresnel p) {\n    return vec3(p.a);\n}\n"
                   "vec3 alloyFresnelTint(AlloyFresnel p) {\n    return vec3(p.b);\n}\n");
        document = std::make_unique<Document>(blocks.catalog());
        document->startFrom({fixtureScene(*blocks.catalog()), std::nullopt});
        document->setBlock(pathOf(kinds::fresnel), "alloy");
    }
    BlockPath path() const { return document->selection().currentPath(kinds::fresnel); }
    Value value(const char* id) const {
        return document->value(path(), *document->block(path())->parameter(id));
    }
};

TEST_F(ShorthandEdit, Choosing_SetsAllInOneStep) {
    const int steps = document->undoStack().count();
    document->setValue(path(), "sort", std::string("two"));
    EXPECT_EQ(value("a"), roundedToFloat(0.5));
    EXPECT_EQ(value("b"), roundedToFloat(0.6));
    EXPECT_EQ(document->undoStack().count(), steps + 1);
    document->undoStack().undo();
    EXPECT_EQ(value("a"), roundedToFloat(0.1));
    EXPECT_EQ(value("sort"), Value(std::string("one")));
}

TEST_F(ShorthandEdit, TypingAValue_IsOnesOwnAndUndoesTogether) {
    document->setValue(path(), "a", 0.3);
    EXPECT_EQ(value("sort"), Value(std::string("custom")));
    document->undoStack().undo();
    EXPECT_EQ(value("sort"), Value(std::string("one")));
    document->undoStack().redo();
    EXPECT_EQ(value("sort"), Value(std::string("custom")));
}

TEST_F(ShorthandEdit, DraggingAValue_StaysOnesOwnAfterRedo) {
    const int token = document->interaction().begin();
    document->setValue(path(), "a", 0.3);
    document->setValue(path(), "a", 0.4);
    document->interaction().end(token);
    document->undoStack().undo();
    document->undoStack().redo();
    EXPECT_EQ(value("a"), roundedToFloat(0.4));
    EXPECT_EQ(value("sort"), Value(std::string("custom")));
}

TEST_F(DocumentEdit, EveryPart_UndoesAndRedoes) {
    document.setBlock(pathOf(kinds::fresnel), "rim");
    document.setBlock(pathOf(kinds::fog), "mist");
    document.setValue(document.selection().currentPath(kinds::fresnel), "f0", 0.5);
    document.setValue(document.selection().currentPath(kinds::fog), "density", 0.5);
    document.setValue(document.selection().currentPath(kinds::lights), "intensity", 3.0);
    document.setValue(document.selection().currentPath(settings::material), "opacity", 0.5);
    document.setValue(document.selection().currentPath(settings::object), "translation",
                      glm::dvec3(1, 2, 3));
    document.setValue(document.selection().currentPath(settings::scene), "exposure", 1.0);
    EXPECT_EQ(fixture.steps(), 8);
    EXPECT_TRUE(survivesUndoAndRedo(document, before));
}

TEST_F(DocumentEdit, Highlight_UndoesAndRedoes) {
    document.setBlock(pathOf(kinds::specular), "spark");
    document.setValue(document.selection().currentPath(kinds::specular), "size", 0.25);
    EXPECT_EQ(fixture.steps(), 2);
    EXPECT_TRUE(survivesUndoAndRedo(document, before));
}

TEST_F(DocumentEdit, ModelSwap_UndoesAndRedoes) {
    document.setModel(Side::A, "second");
    EXPECT_TRUE(survivesUndoAndRedo(document, before));
}

TEST_F(DocumentEdit, Lights_UndoAndRedo) {
    addLight(document, "sun");
    Light renamed = document.scene().lights[1];
    renamed.name = "Rim";
    setLight(document, 1, renamed);
    document.setBlock(pathOf(kinds::lights), "sun");
    removeLight(document, 0);
    EXPECT_EQ(fixture.steps(), 4);
    EXPECT_TRUE(survivesUndoAndRedo(document, before));
}

TEST_F(DocumentEdit, Objects_UndoAndRedo) {
    Object second = document.scene().objects[0];
    second.name = "Second";
    addObject(document, second);
    second.mesh = "builtin:cube";
    setObject(document, 1, second);
    removeObjects(document, {0});
    EXPECT_EQ(fixture.steps(), 3);
    EXPECT_TRUE(survivesUndoAndRedo(document, before));
}

/// Side B is on the current object: redoing an import must not move it to another one.
TEST_F(DocumentEdit, CurrentObject_FollowsUndoAndRedo) {
    const int first = document.selection().object();
    addObject(document, document.scene().objects.front());
    const int second = document.selection().object();
    ASSERT_NE(first, second);
    document.undoStack().undo();
    EXPECT_EQ(document.selection().object(), first);
    document.undoStack().redo();
    EXPECT_EQ(document.selection().object(), second);
    removeObjects(document, {first});
    EXPECT_EQ(document.selection().object(), second - 1);
    document.undoStack().undo();
    EXPECT_EQ(document.selection().object(), second);
}

TEST_F(DocumentEdit, RemovedLight_IsCurrentAgainWhenItIsBack) {
    addLight(document, "sun");
    ASSERT_EQ(document.selection().light(), 1);
    removeLight(document, 1);
    document.selection().setLight(0);
    document.undoStack().undo();
    EXPECT_EQ(document.selection().light(), 1);
}

TEST_F(DocumentEdit, Shadow_IsChosenAndSetAndUndone) {
    addLight(document, "sun");
    const int light = document.selection().light();
    const auto shadow = [this, light] {
        return document.scene().lights.at(static_cast<std::size_t>(light)).part(kinds::shadows);
    };
    document.setBlock(pathOf(kinds::shadows, light), "veil");
    document.setValue(document.selection().currentPath(kinds::shadows), "width", 0.5);
    ASSERT_TRUE(shadow());
    EXPECT_EQ(shadow()->parameters.at("width"), Value(0.5));
    document.undoStack().undo();
    EXPECT_EQ(shadow()->parameters.at("width"), roundedToFloat(0.1));
    document.undoStack().undo();
    EXPECT_FALSE(shadow());
}

TEST_F(DocumentEdit, Shadow_IsToldAsAPartAtItsPath) {
    std::vector<BlockPath> told;
    onChange(document, DocumentChange::Block, &document,
             [&told](const DocumentChange& change) { told.push_back(change.path); });
    document.setBlock(pathOf(kinds::shadows, 0), "veil");
    document.undoStack().undo();
    EXPECT_EQ(told, std::vector<BlockPath>(2, pathOf(kinds::shadows, 0)));
}

TEST_F(DocumentEdit, ShadowOfALightThatIsNotThere_LeavesNoStep) {
    document.setBlock(pathOf(kinds::shadows, 7), "veil");
    document.setBlock(pathOf(kinds::shadows, -1), "veil");
    EXPECT_EQ(fixture.steps(), 0);
}

TEST_F(DocumentEdit, Ground_IsSetAndUndone) {
    const Ground untouched = document.scene().ground;
    document.setValue(document.selection().currentPath(settings::scene), "ground.mode",
                      std::string("plane"));
    EXPECT_EQ(document.scene().ground.mode, GroundMode::Plane);
    document.setValue(document.selection().currentPath(settings::scene), "ground.height", -0.5);
    EXPECT_EQ(document.scene().ground.height, -0.5);
    document.undoStack().undo();
    document.undoStack().undo();
    EXPECT_EQ(document.scene().ground, untouched);
}

TEST_F(DocumentEdit, Fog_UndoesAndRedoes) {
    document.setBlock(pathOf(kinds::fog), "mist");
    EXPECT_TRUE(survivesUndoAndRedo(document, before));
}

TEST_F(DocumentEdit, SideB_IsOnItsObjectAfterUndoAndRedo) {
    addObject(document, document.scene().objects.front());
    document.selection().setObject(0);
    fixture.comparison.setComparing(true);
    document.selection().setObject(1);
    document.setValue(pathOf(kinds::models, 1, Side::B), "roughness", 0.9);
    const Scene shown = document.scene(Side::B);
    ASSERT_TRUE(survivesUndoAndRedo(document, before));
    EXPECT_EQ(document.scene(Side::B), shown);
}

TEST_F(DocumentEdit, Comparing_UndoesAndRedoes) {
    fixture.comparison.setComparing(true);
    document.setValue(pathOf(kinds::models, 0, Side::B), "roughness", 0.9);
    fixture.comparison.swapSides();
    EXPECT_EQ(fixture.steps(), 3);
    EXPECT_TRUE(survivesUndoAndRedo(document, before));
}

TEST_F(DocumentEdit, ReplacedMaterial_UndoesAndRedoes) {
    Material material = *document.material(Side::A);
    material.name = "Other";
    document.replaceMaterial(Side::A, material, "Preset");
    EXPECT_TRUE(survivesUndoAndRedo(document, before));
}

TEST_F(DocumentEdit, SameValue_LeavesNoStep) {
    document.setValue(fixture.model(), "roughness", 0.5);
    EXPECT_EQ(fixture.steps(), 0);
}

TEST_F(DocumentEdit, NotANumber_IsRefused) {
    document.setValue(fixture.model(), "roughness", std::nan(""));
    document.setValue(fixture.model(), "roughness", HUGE_VAL);
    EXPECT_EQ(document.state(), before);
}

TEST_F(DocumentEdit, BeyondHardRange_StopsAtIt) {
    document.setValue(fixture.model(), "roughness", 99.0);
    EXPECT_EQ(fixture.number("roughness"), 10.0);
}

TEST_F(DocumentEdit, OneInteraction_IsOneStep) {
    const int token = document.interaction().begin();
    for (int i = 0; i < 20; ++i) {
        document.setValue(fixture.model(), "roughness", 0.01 * i);
    }
    document.interaction().end(token);
    EXPECT_EQ(fixture.steps(), 1);
}

TEST_F(DocumentEdit, TwoInteractions_AreTwoSteps) {
    for (const double wanted : {0.2, 0.3}) {
        const int token = document.interaction().begin();
        document.setValue(fixture.model(), "roughness", wanted);
        document.interaction().end(token);
    }
    EXPECT_EQ(fixture.steps(), 2);
}

TEST_F(DocumentEdit, InteractionBackToItsStart_LeavesNoStep) {
    const int token = document.interaction().begin();
    document.setValue(fixture.model(), "roughness", 0.9);
    document.setValue(fixture.model(), "roughness", 0.5);
    document.interaction().end(token);
    EXPECT_EQ(fixture.steps(), 0);
    EXPECT_FALSE(document.isModified());
}

TEST_F(DocumentEdit, LateEndOfAnInteraction_LeavesTheNextAlone) {
    const int wheel = document.interaction().begin();
    const int drag = document.interaction().begin();
    document.setValue(fixture.model(), "roughness", 0.6);
    document.interaction().end(wheel);
    document.setValue(fixture.model(), "roughness", 0.7);
    document.interaction().end(drag);
    EXPECT_EQ(fixture.steps(), 1);
}

TEST_F(DocumentEdit, ModelSwapAndBack_RestoresValues) {
    document.setValue(fixture.model(), "roughness", 0.8);
    document.setModel(Side::A, "second");
    document.setModel(Side::A, "first");
    EXPECT_FLOAT_EQ(static_cast<float>(fixture.number("roughness")), 0.8f);
}

TEST_F(DocumentEdit, ModelSwap_CarriesSharedValues) {
    const Value red = glm::dvec3(0.75, 0.125, 0.125);
    document.setValue(fixture.model(), "diffuse.color", red);
    document.setModel(Side::A, "second");
    EXPECT_EQ(fixture.value("diffuse.color"), red);
}

TEST_F(DocumentEdit, LightKindAndBack_RestoresValues) {
    const BlockPath light = document.selection().currentPath(kinds::lights);
    document.setValue(light, "height", 5.0);
    document.setBlock(pathOf(kinds::lights), "sun");
    document.setBlock(pathOf(kinds::lights), "lamp");
    EXPECT_EQ(storedValue(document.state(), light, "height"), Value(5.0));
}

TEST_F(DocumentEdit, FogOffAndOn_RestoresValues) {
    document.setBlock(pathOf(kinds::fog), "mist");
    document.setValue(document.selection().currentPath(kinds::fog), "density", 0.5);
    document.setBlock(pathOf(kinds::fog), "");
    document.setBlock(pathOf(kinds::fog), "mist");
    EXPECT_EQ(document.scene().part(kinds::fog)->parameters.at("density"), Value(0.5));
}

TEST_F(DocumentEdit, ScaleOfNothing_IsWhatASceneFileMayHold) {
    document.setValue(document.selection().currentPath(settings::object), "scale",
                      glm::dvec3(0.0, 1.0, -2.0));
    const glm::dvec3 scale = document.scene().objects[0].scale;
    EXPECT_GT(scale.x, 0.0);
    EXPECT_EQ(scale.y, 1.0);
    EXPECT_EQ(scale.z, -2.0);
}

TEST_F(DocumentEdit, ComparingAgain_BringsBackWhatWasOnSideB) {
    fixture.comparison.setComparing(true);
    document.setValue(pathOf(kinds::models, 0, Side::B), "roughness", 0.75);
    const Material made = *document.state().second;
    fixture.comparison.setComparing(false);
    fixture.comparison.setComparing(true);
    EXPECT_EQ(document.state().second, made);
}

TEST_F(DocumentEdit, ComparingOnAnotherObject_StartsWithACopy) {
    addObject(document, document.scene().objects.front());
    document.selection().setObject(0);
    fixture.comparison.setComparing(true);
    document.setValue(pathOf(kinds::models, 0, Side::B), "roughness", 0.75);
    fixture.comparison.setComparing(false);
    document.selection().setObject(1);
    fixture.comparison.setComparing(true);
    EXPECT_EQ(document.state().second, *document.material(Side::A));
}

TEST_F(DocumentEdit, SecondMaterial_ShowsOnSideBOnly) {
    fixture.comparison.setComparing(true);
    document.scene(Side::B);
    document.setValue(pathOf(kinds::models, 0, Side::B), "roughness", 0.75);
    document.setValue(document.selection().currentPath(settings::scene), "exposure", 1.0);
    EXPECT_EQ(document.scene(Side::A).objects[0].material, before.scene.objects[0].material);
    EXPECT_EQ(document.scene(Side::B).objects[0].material, *document.state().second);
    EXPECT_EQ(document.scene(Side::B).exposure, 1.0);
}

TEST_F(DocumentEdit, RemovingTheLastLight_LeavesNoCurrentLight) {
    removeLight(document, 0);
    EXPECT_EQ(document.selection().light(), -1);
    document.undoStack().undo();
    EXPECT_EQ(document.selection().light(), 0);
}

TEST_F(DocumentEdit, NewCatalogue_KeepsValuesById) {
    document.setValue(fixture.model(), "roughness", 0.75);
    std::string narrower = readFile(fixture.blocks.folder() / "models" / "first.json");
    narrower.replace(narrower.find("\"max\": 10,"), 10, "\"max\": 0.7,");
    narrower.replace(narrower.find("\"softMax\": 1,"), 13, "\"softMax\": 0.7,");
    fixture.blocks.add("models", "first", narrower,
                       "vec3 first(Directions d, First p) {\n    return p.diffuseColor;\n}\n");
    document.setCatalog(fixture.blocks.catalog());
    EXPECT_EQ(text(fixture.blocks.catalog()->errors), "");
    EXPECT_FLOAT_EQ(static_cast<float>(fixture.number("roughness")), 0.7f);
    EXPECT_EQ(fixture.steps(), 1);
}

} // namespace patina::tests::document_test
