// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "ui/fixtures.h"

namespace patina::tests::accuracy_test {
namespace {

constexpr const char* shineModel = R"({
  "id": "shine", "version": 1, "label": "Shine", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.",
  "slots": [{"kind": "fresnel"}], "parameters": [],
  "accuracy": [{"id": "lobe", "label": "Lobe", "doc": "How.", "values": [
    {"id": "full", "label": "Full", "doc": "All of it.", "exact": true},
    {"id": "fast", "label": "Fast", "doc": "Some of it."}]}],
  "claims": ["finite"]
})";

constexpr const char* filmBlock = R"({
  "id": "film", "version": 1, "label": "Film", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.", "parameters": [],
  "accuracy": [{"id": "rise", "label": "Rise", "doc": "How.", "values": [
    {"id": "right", "label": "Right", "doc": "As it is.", "exact": true},
    {"id": "rough", "label": "Rough", "doc": "Nearly."}]}],
  "claims": ["finite"]
})";

struct AccuracyForm : testing::Test {
    FixtureDocument fixture;

    AccuracyForm() {
        fixture.blocks.add("models", "shine", shineModel,
                           "vec3 shine(Directions d, Shine p) { return vec3(d.nl); }\n");
        fixture.blocks.add("fresnel", "film", filmBlock,
                           "vec3 filmFresnel(Incidence i, FilmFresnel p) { return vec3(i.c); }\n"
                           "vec3 filmFresnelTint(FilmFresnel p) { return vec3(1.0); }\n");
        fixture.document.setCatalog(fixture.blocks.catalog());
        fixture.document.setModel(Side::A, "shine");
    }

    BlockPath path() const { return fixture.document.selection().currentPath(settings::accuracy); }
    const Block& choices() const { return *fixture.document.block(path()); }
};

TEST_F(AccuracyForm, OfAModelWithAPart_HasTheChoicesOfBoth) {
    fixture.document.setBlock(pathOf(kinds::fresnel), "film");
    EXPECT_NE(choices().parameter("lobe"), nullptr);
    EXPECT_NE(choices().parameter("rise"), nullptr);
}

TEST_F(AccuracyForm, PartThatIsTakenOut_TakesItsChoicesAlong) {
    fixture.document.setBlock(pathOf(kinds::fresnel), "film");
    fixture.document.setBlock(pathOf(kinds::fresnel), "");
    EXPECT_EQ(choices().parameter("rise"), nullptr);
}

TEST_F(AccuracyForm, LevelThatIsChosen_IsOneUndoStep) {
    const Parameter& lobe = *choices().parameter("lobe");
    fixture.document.setValue(path(), "lobe", std::string("fast"));
    EXPECT_EQ(fixture.document.value(path(), lobe), Value(std::string("fast")));
    fixture.document.undoStack().undo();
    EXPECT_EQ(fixture.document.value(path(), lobe), Value(std::string("full")));
}

} // namespace
} // namespace patina::tests::accuracy_test
