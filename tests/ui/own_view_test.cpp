// SPDX-License-Identifier: GPL-3.0-or-later
// What a view has of its own of the scene, without widgets.
#include <gtest/gtest.h>

#include "document/compare_edits.h"
#include "document/program_effects.h"
#include "document/scene_edits.h"
#include "document/tried_material.h"
#include "ui/fixtures.h"
#include "viewport/effect_switches.h"

namespace patina::tests::own_view_test {
namespace {

struct OwnViewOf : testing::Test {
    FixtureDocument fixture;
    Document& document = fixture.document;
    Comparison& comparison = fixture.comparison;

    OwnViewOf() { comparison.setSideCount(3); }

    static OwnView exposed(double stops) {
        OwnView own;
        own.exposure = stops;
        return own;
    }

    static BlockPath stopsOf(Side side) {
        BlockPath path = pathOf(settings::scene, 0, side);
        path.isOfView = true;
        return path;
    }

    double exposureOf(Side side) { return document.scene(side).exposure; }
};

TEST_F(OwnViewOf, Exposure_IsThatSidesAlone) {
    setOwnView(document, Side::B, exposed(2.0), "");
    document.setValue(pathOf(settings::scene), exposureSetting, -1.0);
    EXPECT_EQ(exposureOf(Side::A), -1.0);
    EXPECT_EQ(exposureOf(Side::B), 2.0);
    EXPECT_EQ(exposureOf(Side::C), -1.0);
    setOwnView(document, Side::B, {}, "");
    EXPECT_EQ(exposureOf(Side::B), -1.0);
}

TEST_F(OwnViewOf, ExposureOfA_LeavesTheScenes) {
    setOwnView(document, Side::A, exposed(2.0), "");
    EXPECT_EQ(exposureOf(Side::A), 2.0);
    EXPECT_EQ(document.scene().exposure, 0.0);
    EXPECT_EQ(exposureOf(Side::B), 0.0);
}

TEST_F(OwnViewOf, DraggedExposure_ChangesTheShownSceneInPlaceInOneStep) {
    setOwnView(document, Side::B, exposed(0.0), "");
    const int steps = document.undoStack().index();
    const Scene* shown = &document.scene(Side::B);
    const Object* objects = shown->objects.data();
    document.interaction().begin(ParameterTarget{stopsOf(Side::B), exposureSetting});
    document.setValue(stopsOf(Side::B), exposureSetting, 1.0);
    document.setValue(stopsOf(Side::B), exposureSetting, 2.0);
    document.interaction().end();
    EXPECT_EQ(exposureOf(Side::B), 2.0);
    EXPECT_EQ(document.scene(Side::B).objects.data(), objects) << "the scene was copied";
    EXPECT_EQ(document.undoStack().index(), steps + 1);
    document.undoStack().undo();
    EXPECT_EQ(exposureOf(Side::B), 0.0);
}

TEST_F(OwnViewOf, Values_RestWhileNothingIsCompared) {
    setOwnView(document, Side::A, exposed(2.0), "");
    comparison.setComparing(false);
    EXPECT_EQ(exposureOf(Side::A), 0.0);
    comparison.setComparing(true);
    EXPECT_EQ(exposureOf(Side::A), 2.0);
}

TEST_F(OwnViewOf, Swapped_GoesWithItsMaterial) {
    setOwnView(document, Side::A, exposed(1.0), "");
    const int steps = document.undoStack().index();
    comparison.swapSides();
    EXPECT_EQ(exposureOf(Side::A), 0.0);
    EXPECT_EQ(exposureOf(Side::B), 1.0);
    EXPECT_EQ(document.undoStack().index(), steps + 1);
}

TEST_F(OwnViewOf, SideThatComes_HasWhatTheActiveOneHas) {
    document.selection().setSide(Side::C);
    setOwnView(document, Side::C, exposed(1.0), "");
    comparison.setSideCount(4);
    EXPECT_EQ(exposureOf(Side::D), 1.0);
    document.selection().setSide(Side::A);
    comparison.setSideCount(3);
    comparison.setSideCount(4);
    EXPECT_EQ(exposureOf(Side::D), 0.0);
}

TEST_F(OwnViewOf, SwitchedOffEffects_AreUndoneAndTheOthersStayOn) {
    ProgramEffects effects(document);
    TriedMaterial tried(document);
    EffectSwitches switches(document, effects, tried);
    switches.setOff("shared", true);
    OwnView own;
    own.switchedOff = switches.offOn(Side::B);
    setOwnView(document, Side::B, own, "");
    document.selection().setSide(Side::B);
    switches.setOff("own", true);
    const std::vector<std::string> shared{"shared"};
    const std::vector<std::string> both{"shared", "own"};
    EXPECT_EQ(switches.offOn(Side::A), shared);
    EXPECT_EQ(switches.offOn(Side::B), both);
    EXPECT_TRUE(switches.isOff("own"));
    document.selection().setSide(Side::A);
    EXPECT_FALSE(switches.isOff("own"));
    document.undoStack().undo();
    EXPECT_EQ(switches.offOn(Side::B), shared);
}

} // namespace
} // namespace patina::tests::own_view_test
