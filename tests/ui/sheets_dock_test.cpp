// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of contact sheets in the window.
#include <QDockWidget>
#include <QImage>
#include <QMenu>
#include <QProcess>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "docks/elided_label.h"
#include "docks/notice_bar.h"
#include "scene/scene_file.h"
#include "sheet/sheet_file.h"
#include "sheets/sheet_grid.h"
#include "sheets/sheets_dock.h"
#include "ui/window_fixture.h"

namespace patina::tests::sheets_dock_test {
namespace {

constexpr int longMs = 120000;

class SheetsPanel : public WindowFixture {
  protected:
    SheetsPanel() {
        const auto preset = dataFolder() / "presets/strauss/red-plastic.patina.json";
        EXPECT_TRUE(window().documentFiles().applyPreset(preset, Side::A));
        document().undoStack().clear();
        window().dock("sheets")->setFloating(true);
        window().dock("sheets")->resize(500, 600);
        window().dock("sheets")->show();
        window().dock("sheets")->raise();
        QTest::qWait(1);
        panel_ = window().findChild<SheetsDock*>();
        Sheet sheet{.x = {AxisKind::Value, "metalness", SheetRange{0.0, 1.0, 3}, {}},
                    .y = SheetAxis{AxisKind::Models, {}, {}, {"strauss", "lambert"}}};
        sheet.cellPixels = 24;
        panel_->setSheet(sheet);
        await();
    }

    SheetsDock& panel() { return *panel_; }
    SheetGrid& grid() { return *panel_->findChild<SheetGrid*>(); }
    CellTable& table() { return grid().table(); }
    const SheetCell& cell(int column, int row) { return table().cell(table().index(row, column)); }

    void await() {
        EXPECT_TRUE(QTest::qWaitFor([this] { return panel_->isIdle(); }, longMs));
    }

    void click(int column, int row) {
        const QModelIndex index = table().index(row, column);
        grid().scrollTo(index);
        QTest::mouseClick(grid().viewport(), Qt::LeftButton, {}, grid().visualRect(index).center());
    }

    double metalness() {
        const Values& values = document().material(Side::A)->model.parameters;
        return std::get<double>(values.at("metalness"));
    }

  private:
    SheetsDock* panel_ = nullptr;
};

TEST_F(SheetsPanel, TitleOfTheColumns_StandsAboveTheCells) {
    ElidedLabel* title = nullptr;
    for (ElidedLabel* each : panel().findChildren<ElidedLabel*>()) {
        title = each->text() == "Metalness" ? each : title;
    }
    ASSERT_NE(title, nullptr);
    for (const int width : {500, 900}) {
        window().dock("sheets")->resize(width, 600);
        QTest::qWait(50);
        const QRect cells = grid().cells();
        const double middle = grid().mapTo(&panel(), cells.center()).x();
        EXPECT_NEAR(title->mapTo(&panel(), title->contentsRect().center()).x(), middle, 1.0)
            << width;
        EXPECT_GT(cells.width(), 100);
    }
}

TEST_F(SheetsPanel, Sheet_HasEveryCellThatCanBeAndSaysWhyNotOfOthers) {
    ASSERT_EQ(table().columnCount(), 3);
    ASSERT_EQ(table().rowCount(), 3);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const bool isPossible = row != 1; // Lambert has no metalness
            EXPECT_EQ(cell(column, row).picture.isNull(), !isPossible) << column << ' ' << row;
            EXPECT_EQ(cell(column, row).problem.isEmpty(), isPossible);
            EXPECT_FALSE(cell(column, row).isDue);
        }
    }
    EXPECT_NE(cell(0, 0).picture, cell(2, 0).picture);
    EXPECT_EQ(cell(0, 2).picture, cell(2, 2).picture);
    EXPECT_TRUE(cell(1, 2).isShown); // the start
}

TEST_F(SheetsPanel, Edit_DrawsTheCellsThatItChangesAndNoOthers) {
    QSignalSpy drawn(panel().findChild<SheetDrawing*>(), &SheetDrawing::drawn);
    document().setValue(document().selection().currentPath(kinds::models), "metalness", 0.25);
    await();
    EXPECT_EQ(drawn.count(), 3); // the row of the start: the others have a metalness of their own
    drawn.clear();
    document().setValue(document().selection().currentPath(kinds::models), "smoothness", 0.5);
    await();
    EXPECT_EQ(drawn.count(), 6);
    drawn.clear();
    document().undoStack().undo();
    document().undoStack().redo();
    await();
    EXPECT_EQ(drawn.count(), 0);
}

TEST_F(SheetsPanel, Hidden_DrawsNothingUntilItIsSeen) {
    QSignalSpy drawn(panel().findChild<SheetDrawing*>(), &SheetDrawing::drawn);
    window().dock("sheets")->hide();
    ASSERT_FALSE(panel().isVisible());
    document().setValue(document().selection().currentPath(kinds::models), "smoothness", 0.5);
    settle();
    EXPECT_TRUE(panel().isIdle());
    EXPECT_EQ(drawn.count(), 0);
    window().dock("sheets")->show();
    window().dock("sheets")->raise();
    ASSERT_TRUE(QTest::qWaitFor([&] { return drawn.count() == 6; }, longMs));
}

TEST_F(SheetsPanel, Click_TakesACellInOneStepAndTheStartStays) {
    const double before = metalness();
    click(2, 0);
    EXPECT_EQ(metalness(), 1.0);
    EXPECT_EQ(document().undoStack().count(), 1);
    await();
    EXPECT_TRUE(cell(2, 0).isShown);
    EXPECT_FALSE(cell(0, 2).isShown);
    click(1, 2);
    EXPECT_EQ(metalness(), before);
    EXPECT_EQ(document().undoStack().count(), 2);
    document().undoStack().undo();
    await();
    EXPECT_TRUE(cell(2, 0).isShown);
}

TEST_F(SheetsPanel, Enter_TakesTheCellThatTheArrowsWentTo) {
    grid().setFocus();
    grid().setCurrentIndex(table().index(0, 0));
    QTest::keyClick(&grid(), Qt::Key_Right);
    QTest::keyClick(&grid(), Qt::Key_Right);
    EXPECT_EQ(document().undoStack().count(), 0); // going there takes nothing
    QTest::keyClick(&grid(), Qt::Key_Return);
    EXPECT_EQ(metalness(), 1.0);
}

TEST_F(SheetsPanel, ClickOnACellThatIsOutOfDate_TakesNothingBack) {
    document().setValue(document().selection().currentPath(kinds::models), "smoothness", 0.5);
    click(2, 0);
    ASSERT_TRUE(QTest::qWaitFor([this] { return metalness() == 1.0; }, longMs));
    EXPECT_EQ(
        document().value(document().selection().currentPath(kinds::models),
                         *document().parameter(
                             {document().selection().currentPath(kinds::models), "smoothness"})),
        Value(0.5));
}

TEST_F(SheetsPanel, AxisThatTheModelLacks_IsSaidWithAnotherOnOffer) {
    Sheet sheet = panel().sheet();
    sheet.y.reset();
    panel().setSheet(sheet);
    document().setModel(Side::A, "lambert");
    await();
    auto* notice = panel().findChild<NoticeBar*>();
    EXPECT_EQ(notice->text(), "Lambert has no “Metalness”.");
    EXPECT_EQ(table().rowCount(), 0);
    QToolButton* use = notice->findChild<QToolButton*>();
    ASSERT_TRUE(use->text().startsWith("Use "));
    use->click();
    await();
    EXPECT_FALSE(notice->isVisible());
    EXPECT_FALSE(cell(0, 0).picture.isNull());
}

TEST_F(SheetsPanel, Example_IsDrawnWithItsPreset) {
    auto* menu = panel().findChild<QMenu*>("examples");
    Q_EMIT menu->aboutToShow();
    ASSERT_EQ(std::size_t(menu->actions().size()), shippedSheets().size());
    QSignalSpy planned(panel().findChild<SheetDrawing*>(), &SheetDrawing::planned);
    menu->actions().first()->trigger();
    EXPECT_EQ(document().undoStack().count(), 1); // its preset
    ASSERT_TRUE(planned.wait(longMs));
    EXPECT_EQ(table().columnCount(), 6);
    EXPECT_EQ(table().rowCount(), 9);
}

TEST_F(SheetsPanel, ExportedFiles_AreThoseOfTheCommand) {
    ASSERT_TRUE(window().documentFiles().openTemplate(defaultSceneFile()));
    const auto preset = dataFolder() / "presets/strauss/red-plastic.patina.json";
    ASSERT_TRUE(window().documentFiles().applyPreset(preset, Side::A));
    Sheet sheet = panel().sheet();
    sheet.x.range->steps = 2;
    sheet.numbers = {CellNumber::Albedo};
    sheet.name = "Two";
    sheet.preset = preset.string();
    panel().setSheet(sheet);
    ASSERT_TRUE(QTest::qWaitFor([this] { return !window().meshes().isLoading(); }, longMs));
    const auto file = home("two.patina-sheet.json");
    panel().save(QString::fromStdString(file.string()));
    QSignalSpy saved(&panel(), &SheetsDock::saved);
    for (const char* ending : {"png", "csv"}) {
        const std::string name = std::string("two.") + ending;
        panel().writeTo(QString::fromStdString(home(name).string()));
        ASSERT_TRUE(saved.wait(longMs));
        QProcess::execute(PATINA_BINARY_DIR "/bin/patina",
                          {"sheet", QString::fromStdString(file.string()), "-o",
                           QString::fromStdString(home("command-" + name).string())});
        ASSERT_FALSE(readFile(home(name)).empty());
        EXPECT_EQ(readFile(home(name)), readFile(home("command-" + name))) << ending;
    }
    const Sheet kept = panel().sheet();
    panel().setSheet({.x = {AxisKind::Lights, {}, {}, {}}});
    window().files().drop({QString::fromStdString(file.string())}, Side::A);
    EXPECT_EQ(panel().sheet(), kept);
}

} // namespace
} // namespace patina::tests::sheets_dock_test
