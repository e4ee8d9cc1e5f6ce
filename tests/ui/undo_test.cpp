// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of edit in the real window, taken back and made again.
#include <algorithm>
#include <functional>
#include <ostream>
#include <stdexcept>

#include <QDockWidget>
#include <QMenu>
#include <QTest>
#include <QToolButton>

#include "document/compare_edits.h"
#include "document/random_material.h"
#include "document/scene_edits.h"
#include "parameters/number_box.h"
#include "parameters/parameter_row.h"
#include "scene/scene_file.h"
#include "sheets/cell_taking.h"
#include "ui/window_fixture.h"

namespace patina::tests::undo_test {
namespace {

struct Edit {
    std::string name;
    std::function<void(Document&)> apply;

    friend std::ostream& operator<<(std::ostream& out, const Edit& edit) {
        return out << edit.name;
    }
};

void set(Document& document, std::string_view kind, const std::string& id, const Value& value) {
    document.setValue(document.selection().currentPath(kind), id, value);
}

const std::vector<Edit> edits{
    {"Parameter", [](Document& d) { set(d, kinds::models, "diffuse.color", glm::dvec3(0.1)); }},
    {"ValuesAtOnce",
     [](Document& d) {
         d.setValues(d.selection().currentPath(kinds::models), {{"diffuse.color", glm::dvec3(0.1)}},
                     "Reset");
     }},
    {"RandomMaterial",
     [](Document& d) { randomiseMaterial(d, [share = 0.0]() mutable { return share += 0.06; }); }},
    {"Model", [](Document& d) { d.setModel(Side::A, "oren-nayar"); }},
    {"FresnelBlend",
     [](Document& d) {
         d.setModel(Side::A, "lambert");
         d.setBlock(pathOf(kinds::fresnel), "schlick");
     }},
    {"Highlight",
     [](Document& d) {
         d.setModel(Side::A, "lambert");
         d.setBlock(pathOf(kinds::specular), "phong");
     }},
    {"Opacity", [](Document& d) { set(d, settings::material, "opacity", 0.5); }},
    {"LightAdded", [](Document& d) { addLight(d, "point"); }},
    {"LightsAdded", [](Document& d) { addLights(d, d.scene().lights, "Paste"); }},
    {"LightRemoved", [](Document& d) { removeLight(d, 0); }},
    {"LightKind", [](Document& d) { d.setBlock(pathOf(kinds::lights), "head"); }},
    {"LightSwitched",
     [](Document& d) {
         Light light = d.scene().lights[0];
         light.enabled = false;
         setLight(d, 0, light);
     }},
    {"KeyLight",
     [](Document& d) {
         d.setModel(Side::A, "gooch");
         addLight(d, "head");
         Light light = d.scene().lights.back();
         light.isKey = true;
         setLight(d, static_cast<int>(d.scene().lights.size()) - 1, light);
     }},
    {"DrawingsTakeAllLights",
     [](Document& d) {
         d.setModel(Side::A, "gooch");
         set(d, settings::scene, "drawings", std::string("all"));
     }},
    {"Occlusion", [](Document& d) { set(d, settings::scene, "occlusion", false); }},
    {"Lighting",
     [](Document& d) { setLighting(d, readScene(defaultSceneFile(), d.catalog())->scene); }},
    {"LampsTakenOut",
     [](Document& d) {
         const auto fitted = readScene(defaultSceneFile(), d.catalog()); // is at rest at once
         setLighting(d, fitted->scene);
         takeLampsOut(d, {2.0, {{{0.0, 0.6, 0.8}, {1.0, 0.9, 0.8}, 0.2}}});
     }},
    {"LightValue", [](Document& d) { set(d, kinds::lights, "intensity", 0.0); }},
    {"Fog", [](Document& d) { d.setBlock(pathOf(kinds::fog), "exponential"); }},
    {"FogValue",
     [](Document& d) {
         d.setBlock(pathOf(kinds::fog), "exponential");
         set(d, kinds::fog, "density", 0.5);
     }},
    {"Ambient", [](Document& d) { set(d, settings::scene, "ambient", glm::dvec3(0.3)); }},
    {"Background", [](Document& d) { set(d, settings::scene, "background", glm::dvec3(0.9)); }},
    {"Exposure", [](Document& d) { set(d, settings::scene, "exposure", 1.0); }},
    {"ToneCurve", [](Document& d) { d.setBlock(pathOf(kinds::tone), "agx"); }},
    {"NoToneCurve", [](Document& d) { d.setBlock(pathOf(kinds::tone), ""); }},
    {"ToneCurvesValue",
     [](Document& d) {
         d.setBlock(pathOf(kinds::tone), "reinhard");
         set(d, kinds::tone, "white", 1.0);
     }},
    {"PassAdded", [](Document& d) { addPass(d, "kuwahara"); }},
    {"PassesValue",
     [](Document& d) {
         addPass(d, "kuwahara");
         set(d, kinds::pass, "radius", 3.0);
     }},
    {"PassMoved",
     [](Document& d) {
         addPass(d, "kuwahara");
         addPass(d, "kuwahara");
         set(d, kinds::pass, "radius", 3.0);
         movePass(d, 0, 1);
     }},
    {"PassRemoved",
     [](Document& d) {
         addPass(d, "kuwahara");
         addPass(d, "kuwahara");
         removePass(d, 0);
     }},
    {"OwnView",
     [](Document& d) {
         setSecondMaterial(d, *d.material(Side::A));
         OwnView own;
         own.exposure = 1.5;
         own.hasEnvironment = true;
         setOwnView(d, Side::B, own, "Exposure of view B");
     }},
    {"ObjectAdded",
     [](Document& d) {
         Object object = d.scene().objects[0];
         object.mesh = "builtin:cube";
         object.translation = {1.0, 0.5, 0.0};
         addObject(d, object);
     }},
    {"ObjectRemoved", [](Document& d) { removeObjects(d, {0}); }},
    {"ObjectsRemoved", [](Document& d) { removeObjects(d, {0}); }},
    {"ObjectsAdded",
     [](Document& d) {
         std::vector<Object> copies(2, d.scene().objects[0]);
         copies[0].translation = {-0.8, 0.3, 0.0};
         copies[1].translation = {0.8, 0.3, 0.0};
         addObjects(d, copies, "Duplicate");
     }},
    {"ObjectsMoved",
     [](Document& d) {
         changeObjects(d, {0}, "Move", [](Object& object) { object.translation.x = 0.4; });
     }},
    {"Solo", [](Document& d) { toggleSolo(d, 0); }},
    {"Mute", [](Document& d) { toggleMute(d, 0); }},
    {"LightPlaced",
     [](Document& d) {
         const BlockPath path = d.selection().currentPath(kinds::lights);
         Values places;
         for (const Parameter& parameter : d.block(path)->parameters) {
             if (parameter.space != Space::None) {
                 places.emplace(parameter.id, glm::dvec3(3.0, -0.5, 0.2));
             }
         }
         d.setValues(path, places, "Place light");
     }},
    {"ObjectMesh",
     [](Document& d) {
         Object object = d.scene().objects[0];
         object.mesh = "builtin:torus";
         setObject(d, 0, object);
     }},
    {"ObjectHidden", [](Document& d) { set(d, settings::object, "visible", false); }},
    {"ObjectTurned", [](Document& d) { set(d, settings::object, "rotation", glm::dvec3(40.0)); }},
    {"CellTaken",
     [](Document& d) {
         const Sheet sheet{.x = {AxisKind::Models, {}, {}, {"lambert", "strauss"}},
                           .y = SheetAxis{AxisKind::Lights, {}, {}, {"all", "head"}}};
         const auto plan = SheetPlan::of(sheet, d.ownScene(Side::A), 0, d.sharedCatalog());
         ASSERT_TRUE(plan && takeCell(d, *plan, 1, 1));
     }},
    {"Preset",
     [](Document& d) {
         DocumentFiles files(d);
         ASSERT_TRUE(files.applyPreset(otherPreset(d), Side::A));
     }},
};

class UndoneEdit : public WindowFixture, public testing::WithParamInterface<Edit> {
  protected:
    QImage picture() {
        newFrames();
        return view().grabPicture();
    }
    void undoAll() {
        while (document().undoStack().canUndo()) {
            document().undoStack().undo();
        }
    }
    void redoAll() {
        while (document().undoStack().canRedo()) {
            document().undoStack().redo();
        }
    }
};

TEST_P(UndoneEdit, PictureAndDocument_AreAsBefore) {
    const QImage before = picture();
    const DocumentState start = document().state();
    GetParam().apply(document());
    const QImage after = picture();
    EXPECT_NE(after, before);
    EXPECT_TRUE(window().isWindowModified());
    undoAll();
    EXPECT_EQ(picture(), before);
    EXPECT_EQ(document().state(), start);
    EXPECT_FALSE(window().isWindowModified());
    redoAll();
    EXPECT_EQ(picture(), after);
}

INSTANTIATE_TEST_SUITE_P(Kinds, UndoneEdit, testing::ValuesIn(edits),
                         [](const auto& tested) { return tested.param.name; });

using LightingMenu = WindowFixture;

TEST_F(LightingMenu, EveryShippedScene_LightsWhatIsThereInOneStep) {
    auto* menu = window().findChild<QMenu*>("lighting");
    Q_EMIT menu->aboutToShow();
    ASSERT_EQ(std::size_t(menu->actions().size()), shippedScenes().size());
    const Scene before = document().scene();
    for (int i = 0; i < menu->actions().size(); ++i) {
        const auto shipped = readScene(shippedScenes()[std::size_t(i)], document().catalog());
        const int steps = document().undoStack().count();
        menu->actions()[i]->trigger();
        EXPECT_EQ(document().scene().lights, shipped->scene.lights);
        EXPECT_EQ(document().scene().parts, shipped->scene.parts);
        EXPECT_EQ(document().scene().objects, before.objects);
        EXPECT_EQ(document().scene().camera, before.camera);
        EXPECT_EQ(document().undoStack().count(), steps + 1);
        EXPECT_LT(document().selection().light(), int(document().scene().lights.size()));
    }
}

TEST_F(LightingMenu, EveryShippedScene_HasAPictureSoon) {
    window().startRest();
    auto* menu = window().findChild<QMenu*>("lighting");
    Q_EMIT menu->aboutToShow();
    const auto isPainted = [](const QAction* action) {
        const QImage picture = action->icon().pixmap(84).toImage();
        return picture.pixelColor(picture.rect().center()).alpha() == 255;
    };
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return std::ranges::all_of(menu->actions(), isPainted); }, 120000));
}

TEST_F(LightingMenu, Rows_AreAsHighAsTheirPictures) {
    auto* menu = window().findChild<QMenu*>("lighting");
    Q_EMIT menu->aboutToShow();
    for (QAction* action : menu->actions()) {
        EXPECT_GE(menu->actionGeometry(action).height(), 84);
    }
}

class NumberField : public WindowFixture {
  protected:
    NumberBox& box(const std::string& id) {
        window().dock("scene")->show();
        window().dock("scene")->raise();
        QApplication::processEvents();
        for (auto* row : window().findChildren<ParameterRow*>()) {
            if (row->parameter().id == id) {
                return *row->findChild<NumberBox*>();
            }
        }
        throw std::runtime_error("no row " + id);
    }
};

/// Its light is middle grey afterwards: so a second click changes nothing.
TEST_F(NumberField, AutoBesideTheExposure_IsOneStep) {
    box("exposure");
    document().setValue(pathOf(settings::scene), "exposure", 4.0);
    newFrames();
    QToolButton* button = nullptr;
    for (auto* each : window().findChildren<QToolButton*>()) {
        button = each->accessibleName() == "Automatic exposure" ? each : button;
    }
    ASSERT_NE(button, nullptr);
    const int steps = document().undoStack().count();
    QTest::mouseClick(button, Qt::LeftButton);
    const double chosen = document().scene().exposure;
    EXPECT_NE(chosen, 4.0);
    EXPECT_EQ(document().undoStack().count(), steps + 1);
    newFrames();
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_NEAR(document().scene().exposure, chosen, 0.011);
    document().undoStack().undo();
    document().undoStack().setIndex(steps);
    EXPECT_EQ(document().scene().exposure, 4.0);
}

TEST_F(NumberField, ExposureInTheToolBar_IsOneStepAndFollowsUndo) {
    auto* bar = window().findChild<QWidget*>("exposureBar");
    ASSERT_NE(bar, nullptr);
    auto* stops = bar->findChild<NumberBox*>();
    const double before = document().scene().exposure;
    const int steps = document().undoStack().count();
    stops->setFocus();
    stops->selectAll();
    QTest::keyClicks(stops, "1.5");
    QTest::keyClick(stops, Qt::Key_Return);
    EXPECT_EQ(document().scene().exposure, 1.5);
    EXPECT_EQ(document().undoStack().count(), steps + 1);
    document().undoStack().undo();
    EXPECT_EQ(stops->value(), before);
}

TEST_F(NumberField, EscapeInIt_TakesTypingBackAndNothingElse) {
    const DocumentState before = document().state();
    NumberBox& exposure = box("exposure");
    exposure.setFocus();
    const QString shown = exposure.text();
    exposure.selectAll();
    QTest::keyClicks(&exposure, "7");
    QTest::keyClick(&exposure, Qt::Key_Escape);
    EXPECT_EQ(exposure.text(), shown);
    EXPECT_EQ(document().state(), before);
    EXPECT_FALSE(window().isWindowModified());
    EXPECT_TRUE(window().isVisible());
}

} // namespace
} // namespace patina::tests::undo_test
