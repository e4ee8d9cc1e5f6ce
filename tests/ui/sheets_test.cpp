// SPDX-License-Identifier: GPL-3.0-or-later
// What the panel of contact sheets knows, without its window.
#include <stdexcept>

#include <gtest/gtest.h>

#include <QTest>

#include "document/scene_edits.h"
#include "material/preset_file.h"
#include "parameters/choice_box.h"
#include "parameters/number_box.h"
#include "sheet/sheet_file.h"
#include "sheets/axis_row.h"
#include "sheets/cell_table.h"
#include "sheets/cell_taking.h"
#include "sheets/check_menu.h"
#include "sheets/sheet_saving.h"
#include "sheets/sheet_start.h"
#include "ui/fixtures.h"

namespace patina::tests::sheets_test {
namespace {

SheetAxis range(const std::string& id, double from, double to, int steps) {
    return {AxisKind::Value, id, SheetRange{from, to, steps}, {}};
}

SheetAxis list(AxisKind kind, std::vector<std::string> entries = {}) {
    return {kind, {}, {}, std::move(entries)};
}

const Sheet roughnessSheet{.x = range("roughness", 0.0, 1.0, 3)};

class Sheets : public testing::Test {
  protected:
    Document& document() { return fixture.document; }
    Scene shown() { return drawnScene(document().ownScene(document().selection().side())); }

    SheetPlan plan(const Sheet& sheet) {
        const auto made = SheetPlan::of(sheet, shown(), 0, document().sharedCatalog());
        EXPECT_TRUE(made) << text(made.error());
        return made.value_or(SheetPlan());
    }

    FixtureDocument fixture;
};

TEST_F(Sheets, TakenCell_IsOneStepThatUndoTakesBack) {
    const DocumentState before = document().state();
    const SheetPlan made =
        plan({.x = range("roughness", 0.0, 1.0, 3), .y = list(AxisKind::Lights, {"all", "none"})});
    ASSERT_TRUE(takeCell(document(), made, 2, 1));
    EXPECT_EQ(fixture.number("roughness"), 1.0);
    EXPECT_TRUE(document().scene().lights.empty());
    EXPECT_EQ(fixture.steps(), 1);
    document().undoStack().undo();
    EXPECT_EQ(document().state(), before);
}

TEST_F(Sheets, CellThatIsShown_IsNoEdit) {
    EXPECT_FALSE(takeCell(document(), plan({.x = range("roughness", 0.0, 1.0, 3)}), 1, 0));
    EXPECT_EQ(fixture.steps(), 0);
}

TEST_F(Sheets, CellOfAnotherModel_ChangesItAsTheModelBoxDoes) {
    const SheetPlan made = plan({.x = list(AxisKind::Models, {"first", "second"})});
    ASSERT_TRUE(takeCell(document(), made, 1, 0));
    const Material taken = *document().material(Side::A);
    document().undoStack().undo();
    document().setModel(Side::A, "second");
    EXPECT_EQ(taken, *document().material(Side::A));
    document().setModel(Side::A, "first");
    EXPECT_EQ(fixture.number("exponent"), 32.0); // it was parked
}

TEST_F(Sheets, CellOfTheStart_BringsTheValuesBack) {
    const SheetPlan made = plan(roughnessSheet);
    const Scene before = shown();
    takeCell(document(), made, 2, 0);
    ASSERT_TRUE(made.isControl(1));
    ASSERT_TRUE(takeCell(document(), made, 0, 1));
    EXPECT_EQ(shown(), before);
}

TEST_F(Sheets, TakenCell_IsForAllSelectedObjects) {
    Object other = document().scene().objects[0];
    other.name = "Other";
    other.material.model.parameters["exponent"] = 7.0;
    addObject(document(), other);
    document().selection().setObjects({1, 0});
    ASSERT_TRUE(takeCell(document(), plan(roughnessSheet), 2, 0));
    const Values& values = document().scene().objects[1].material.model.parameters;
    EXPECT_EQ(values.at("roughness"), Value(1.0));
    EXPECT_EQ(values.at("exponent"), Value(7.0));
}

TEST_F(Sheets, Camera_StaysWhereItIsWhenACellIsTaken) {
    const SheetPlan made = plan(roughnessSheet);
    Camera camera = document().scene().camera;
    camera.yaw = 77.0;
    document().setCamera(camera);
    takeCell(document(), made, 2, 0);
    EXPECT_EQ(document().scene().camera, camera);
}

TEST_F(Sheets, Start_StaysWhileCellsAreTakenAndTheCameraMoves) {
    SheetStart start;
    start.follow(shown(), {}, roughnessSheet);
    const Scene first = *start.scene();
    takeCell(document(), plan(roughnessSheet), 2, 0);
    start.noteTaken(shown());
    Camera camera = document().scene().camera;
    camera.yaw = 77.0;
    document().setCamera(camera);
    start.follow(shown(), {}, roughnessSheet);
    EXPECT_EQ(start.scene()->objects, first.objects);
    EXPECT_EQ(start.scene()->camera, camera);
    document().undoStack().undo();
    start.follow(shown(), {}, roughnessSheet);
    EXPECT_EQ(start.scene()->objects, first.objects);
}

TEST_F(Sheets, AnotherEdit_IsTheStartOfWhatFollows) {
    SheetStart start;
    start.follow(shown(), {}, roughnessSheet);
    const std::shared_ptr<const Scene> first = start.scene();
    start.follow(shown(), {}, roughnessSheet);
    EXPECT_EQ(start.scene(), first); // nothing has changed
    document().setValue(fixture.model(), "exponent", 5.0);
    EXPECT_FALSE(start.holds(shown()));
    start.follow(shown(), {}, roughnessSheet);
    EXPECT_EQ(*start.scene(), shown());
}

TEST_F(Sheets, OtherAxis_StartsFromTheCellThatWasTaken) {
    SheetStart start;
    start.follow(shown(), {}, roughnessSheet);
    takeCell(document(), plan(roughnessSheet), 2, 0);
    start.noteTaken(shown());
    start.follow(shown(), {}, {.x = range("roughness", 0.0, 1.0, 9)});
    EXPECT_NE(*start.scene(), shown());
    start.follow(shown(), {}, {.x = range("exponent", 1.0, 100.0, 3)});
    EXPECT_EQ(*start.scene(), shown());
}

TEST_F(Sheets, Saved_IsReadWithThePresetThatItStartsFrom) {
    const TemporaryFolder folder;
    const Material& material = *document().material(Side::A);
    const auto saved =
        saveSheet(folder / "a.patina-sheet.json", roughnessSheet, material, document().catalog());
    ASSERT_TRUE(saved) << saved.error().text();
    const auto read = readSheet(folder / "a.patina-sheet.json");
    ASSERT_TRUE(read) << text(read.error());
    EXPECT_EQ(read->sheet, *saved);
    EXPECT_EQ(read->sheet.x, roughnessSheet.x);
    const auto preset = readPreset(read->sheet.preset, document().catalog());
    ASSERT_TRUE(preset);
    EXPECT_EQ(preset->material, material);
}

TEST_F(Sheets, SavedOnceMore_OverwritesNoOtherPreset) {
    const TemporaryFolder folder;
    const auto file = folder / "a.patina-sheet.json";
    const auto save = [&] {
        return saveSheet(file, roughnessSheet, *document().material(Side::A), document().catalog())
            .value_or(Sheet())
            .preset;
    };
    const std::string first = save();
    EXPECT_EQ(save(), first); // the same material needs no second file
    const std::string kept = readFile(first);
    document().setValue(fixture.model(), "exponent", 5.0);
    EXPECT_NE(save(), first);
    EXPECT_EQ(readFile(first), kept);
}

class SheetsAxisRow : public Sheets {
  protected:
    SheetsAxisRow() {
        QObject::connect(&row, &AxisRow::wished,
                         [this](const std::optional<SheetAxis>& axis) { wished = axis; });
    }

    void show(const std::optional<SheetAxis>& axis) {
        scene = shown();
        offers = axisOffers(scene, 0, document().catalog());
        row.show(axis, {scene, 0, document().catalog(), offers});
    }

    NumberBox& box(const QString& name) {
        for (auto* each : row.findChildren<NumberBox*>()) {
            if (each->accessibleName() == name) {
                return *each;
            }
        }
        throw std::runtime_error(name.toStdString());
    }

    void type(const QString& name, const QString& text) {
        NumberBox& field = box(name);
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }

    AxisRow row{AxisRow::Direction::Down};
    Scene scene;
    std::vector<AxisOffer> offers;
    std::optional<SheetAxis> wished;
};

TEST_F(SheetsAxisRow, TypedEnds_StayInTheNumbersRange) {
    show(range("roughness", 0.0, 1.0, 5));
    type("To", "4.5");
    EXPECT_EQ(wished, range("roughness", 0.0, 4.5, 5));
    type("From", "-3");
    EXPECT_EQ(wished, range("roughness", 0.0, 4.5, 5)); // it begins at 0 already
    EXPECT_EQ(box("From").text(), "0");
    type("Steps", "99");
    EXPECT_EQ(wished, range("roughness", 0.0, 1.0, maxSheetSteps));
}

TEST_F(SheetsAxisRow, Entries_AreSwitchedOneByOneAndOneStays) {
    show(list(AxisKind::Models));
    const auto actions = row.findChild<CheckMenu*>()->actions();
    ASSERT_EQ(actions.size(), 2);
    actions[0]->trigger();
    ASSERT_EQ(wished, list(AxisKind::Models, {"second"}));
    show(wished);
    actions[1]->trigger(); // the last one
    EXPECT_EQ(wished, list(AxisKind::Models, {"second"}));
    EXPECT_TRUE(actions[1]->isChecked());
    actions[0]->trigger();
    EXPECT_EQ(wished, list(AxisKind::Models)); // all, whatever comes
}

TEST_F(SheetsAxisRow, Choice_IsAnAxisOfItsSlidersRangeOrNone) {
    show(list(AxisKind::Models));
    auto* what = row.findChild<ChoiceBox*>();
    what->setCurrentIndex(what->findText("Exponent"));
    Q_EMIT what->activated(what->currentIndex());
    EXPECT_EQ(wished, range("exponent", 1.0, 1000.0, usualSheetSteps));
    Q_EMIT what->activated(0);
    EXPECT_EQ(wished, std::nullopt);
}

TEST_F(SheetsAxisRow, AxisOfNothing_IsNamedByItsId) {
    show(range("gone", 0.0, 1.0, 3));
    EXPECT_EQ(row.findChild<ChoiceBox*>()->currentText(), "gone");
}

TEST_F(Sheets, Table_SaysOfEachCellWhatItIs) {
    CellTable table;
    const auto made = std::make_shared<const SheetPlan>(plan(roughnessSheet));
    PlannedSheet sheet{made, roughnessSheet, std::vector<SheetCell>(6)};
    sheet.sheet.numbers = {CellNumber::Albedo};
    sheet.cells[1].isShown = true;
    sheet.cells[1].numbers.albedo = 0.25;
    table.setSheet(sheet);
    const auto said = [&](int row, int column) {
        return table.data(table.index(row, column), Qt::AccessibleTextRole).toString();
    };
    EXPECT_EQ(said(0, 1), "Roughness 0.5, shown now, albedo 0.250");
    EXPECT_EQ(said(1, 0), "Start");
    EXPECT_EQ(table.headerData(2, Qt::Horizontal, Qt::DisplayRole), "1");
    EXPECT_EQ(table.headerData(1, Qt::Vertical, Qt::DisplayRole), "Start");
    table.markShown(table.index(1, 0));
    EXPECT_EQ(said(0, 1), "Roughness 0.5, albedo 0.250");
    EXPECT_EQ(said(1, 2), "Start, shown now"); // all of the control row are one
}

} // namespace
} // namespace patina::tests::sheets_test
