// SPDX-License-Identifier: GPL-3.0-or-later
// The chart of what accuracy costs, on a user's model whose errors are known.
#include <ctime>

#include <QTimer>

#include "docks/elided_label.h"
#include "support/full_disk.h"
#include "ui/accuracy_fixture.h"

namespace patina::tests::accuracy_dock_test {
namespace {

TEST_F(AccuracyPanel, Measured_HasARowForEveryLevel) {
    ASSERT_TRUE(measure()) << state().toStdString();
    EXPECT_EQ(list().topLevelItemCount(), 3);
}

TEST_F(MeasuredPanel, Measured_HasTheKnownErrors) {
    EXPECT_NEAR(errorOfLevel("near"), nearError, 0.01 * nearError);
    EXPECT_NEAR(errorOfLevel("far"), farError, 0.01 * farError);
}

TEST_F(MeasuredPanel, EnterInTheTable_GivesTheMaterialThatLevel) {
    list().select(pointOf("near"));
    QTest::keyClick(&list(), Qt::Key_Return);
    EXPECT_EQ(level(), "near");
}

TEST_F(MeasuredPanel, ClickOnAPoint_GivesTheMaterialThatLevel) {
    settle();
    const QPoint place = plot().placeOf(pointOf("far"));
    QWidget* target = plot().childAt(place);
    ASSERT_NE(target, nullptr);
    QTest::mouseClick(target, Qt::LeftButton, {}, target->mapFrom(&plot(), place));
    EXPECT_EQ(level(), "far");
}

TEST_F(MeasuredPanel, KeysInTheChart_GoFromPointToPoint) {
    plot().setFocus();
    QTest::keyClick(&plot(), Qt::Key_Right);
    EXPECT_EQ(plot().selected(), fastest());
    for (int i = 0; i < 3; ++i) {
        QTest::keyClick(&plot(), Qt::Key_Right);
    }
    EXPECT_EQ(plot().selected(), 0); // the exact one takes longest
}

TEST_F(MeasuredPanel, EnterInTheChart_GivesTheMaterialThatLevel) {
    plot().select(pointOf("near"));
    QTest::keyClick(&plot(), Qt::Key_Return);
    EXPECT_EQ(level(), "near");
}

TEST_F(MeasuredPanel, AppliedPoint_IsOneUndoStep) {
    const int before = steps();
    dock().apply(pointOf("near"));
    EXPECT_EQ(steps(), before + 1);
    document().undoStack().undo();
    EXPECT_EQ(level(), "");
}

TEST_F(MeasuredPanel, AppliedPoint_LeavesTheChartFresh) {
    dock().apply(pointOf("near"));
    settle();
    EXPECT_FALSE(dock().isStale());
}

TEST_F(MeasuredPanel, ChangedScene_PutsTheChartOutOfDate) {
    document().setBlock(pathOf(kinds::fog), "exponential");
    settle();
    EXPECT_TRUE(dock().isStale());
    EXPECT_TRUE(state().startsWith("Out of date")) << state().toStdString();
}

QColor middleOf(const QIcon& icon, QIcon::Mode mode) {
    const QImage image = icon.pixmap(QSize(12, 12), mode).toImage();
    return image.pixelColor(image.width() / 2, image.height() / 2);
}

TEST_F(MeasuredPanel, StaleTable_HasFaintDiscsAndSelectedRowsHaveTheirs) {
    const QPalette colors = list().palette();
    const auto disc = [this](QIcon::Mode mode) {
        list().select(0); // the exact way is always on the front
        return middleOf(list().currentItem()->icon(0), mode);
    };
    EXPECT_EQ(disc(QIcon::Normal), colors.color(QPalette::Highlight));
    EXPECT_EQ(disc(QIcon::Selected), colors.color(QPalette::HighlightedText));
    document().setBlock(pathOf(kinds::fog), "exponential");
    settle();
    EXPECT_NE(disc(QIcon::Normal), colors.color(QPalette::Highlight));
    EXPECT_EQ(disc(QIcon::Selected), colors.color(QPalette::HighlightedText));
}

TEST_F(MeasuredPanel, ClickOnAStalePoint_ChoosesAndSaysThatNumbersAreOld) {
    document().setBlock(pathOf(kinds::fog), "exponential");
    settle();
    const int before = steps();
    const QPoint place = plot().placeOf(pointOf("far"));
    QWidget* target = plot().childAt(place);
    ASSERT_NE(target, nullptr);
    QTest::mouseClick(target, Qt::LeftButton, {}, target->mapFrom(&plot(), place));
    settle();
    EXPECT_EQ(level(), "far");
    EXPECT_EQ(steps(), before + 1);
    EXPECT_TRUE(dock().isStale());
    EXPECT_TRUE(state().startsWith("Out of date")) << state().toStdString();
    EXPECT_TRUE(state().contains("Chosen now: Work: Far.")) << state().toStdString();
    const QString told = plot().accessibleDescription();
    EXPECT_TRUE(told.contains("from before a change")) << told.toStdString();
    EXPECT_FALSE(told.contains("ns per pixel")) << told.toStdString();
}

TEST_F(MeasuredPanel, BlocksThatAreReadAgain_PutTheChartOutOfDateWhenTheyDiffer) {
    const auto readAgain = [this] {
        document().setCatalog(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())));
        settle();
    };
    readAgain();
    EXPECT_FALSE(dock().isStale());
    const std::filesystem::path models = home("XDG_DATA_HOME") / "patina/shaders/models";
    writeFile(models / "burning.glsl", std::string(burningShader) + "// another\n");
    readAgain();
    EXPECT_TRUE(dock().isStale());
}

TEST_F(MeasuredPanel, MovedCamera_LeavesTheChartFreshAndSaysSo) {
    Camera moved = document().scene().camera;
    moved.yaw += 40.0;
    document().setCamera(moved);
    settle();
    EXPECT_FALSE(dock().isStale());
    EXPECT_TRUE(state().startsWith("Measured from another view")) << state().toStdString();
}

TEST_F(MeasuredPanel, StateInASmallWindow_IsReadInFull) {
    dock().apply(pointOf("near"));
    document().setBlock(pathOf(kinds::fog), "exponential");
    window().resize(1280, 720);
    settle();
    const auto& line = *dock().findChild<ElidedLabel*>("state");
    EXPECT_EQ(line.shown(), line.text());
    EXPECT_GE(line.height(), line.heightForWidth(line.width()));
}

TEST_F(MeasuredPanel, Table_HasTheInstructionsOfEveryWay) {
    const int column = list().columnCount() - 1;
    for (int i = 0; i < list().topLevelItemCount(); ++i) {
        EXPECT_GT(list().topLevelItem(i)->text(column).toInt(), 0) << i;
    }
}

TEST_F(MeasuredPanel, SceneThatIsBack_HasItsChartAgain) {
    document().setBlock(pathOf(kinds::fog), "exponential");
    settle();
    document().undoStack().undo();
    settle();
    EXPECT_FALSE(dock().isStale());
}

TEST_F(MeasuredPanel, SavedDocument_KeepsItsChart) {
    ASSERT_TRUE(window().documentFiles().saveScene(home("saved.patina-scene.json")));
    settle();
    ASSERT_NE(dock().shown(), nullptr);
    EXPECT_FALSE(dock().isStale());
}

TEST_F(MeasuredPanel, WhatIsNotMeasured_LeavesTheChartFresh) {
    Material renamed = *document().material(Side::A);
    renamed.name = "Another name";
    renamed.tags = {"a", "b"};
    document().replaceMaterial(Side::A, renamed, "Rename");
    document().setValue(document().selection().currentPath(settings::scene), "ground.mode",
                        std::string("plane"));
    settle();
    EXPECT_FALSE(dock().isStale());
    document().setValue(document().selection().currentPath(settings::material), "opacity", 0.5);
    settle();
    EXPECT_TRUE(dock().isStale());
}

TEST_F(MeasuredPanel, ChartOfAnotherModel_IsNotApplied) {
    const int point = pointOf("near");
    document().setModel(Side::A, "lambert");
    const int before = steps();
    dock().apply(point);
    EXPECT_EQ(steps(), before);
}

TEST_F(MeasuredPanel, ExportedTable_HasALineForEveryPoint) {
    EXPECT_EQ(exported("csv").trimmed().split('\n').size(), 1 + 3);
    EXPECT_TRUE(exported("json").contains("\"points\""));
}

TEST_F(MeasuredPanel, ExportToAFullDisk_LeavesTheOldFileAndSaysSo) {
    const QByteArray before = exported("csv");
    const int messages = window().messages().count();
    const FullDisk full(16);
    EXPECT_EQ(exported("csv"), before);
    EXPECT_EQ(window().messages().count(), messages + 1);
}

TEST_F(MeasuredPanel, ExportedChart_IsAPicture) {
    EXPECT_TRUE(exported("png").startsWith("\x89PNG"));
    EXPECT_TRUE(exported("svg").contains("<svg"));
}

TEST_F(MeasuredPanel, ExportedChart_NamesWhatItShows) {
    Material named = *document().material(Side::A);
    named.name = "Candle";
    named.accuracy["work"] = "far"; // the chosen way has its name, on the front or not
    document().replaceMaterial(Side::A, named, "Name");
    settle();
    const QString chart = QString::fromUtf8(exported("svg"));
    for (const char* text :
         {"What accuracy costs: Candle", "48 × 48 pixels", "OpenGL", ">Exact<", "Work: Far"}) {
        EXPECT_TRUE(chart.contains(QString::fromUtf8(text))) << text;
    }
}

TEST_F(AccuracyPanel, StoppedMeasurement_SaysSo) {
    dock().measure();
    press("Stop");
    ASSERT_TRUE(waitForEnd());
    EXPECT_TRUE(state().startsWith("Stopped")) << state().toStdString();
}

TEST_F(AccuracyPanel, RunningMeasurement_SaysWhichStepItIsAtFromTheStart) {
    std::vector<QString> told;
    start(400); // long enough for every step to be seen
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            told.push_back(state());
            return state().contains("Work: ");
        },
        waitMs));
    press("Stop");
    ASSERT_TRUE(waitForEnd());
    const auto all = [&told] {
        return QStringList(told.begin(), told.end()).join('\n').toStdString();
    };
    const auto said = [&told](const char* start) {
        return std::ranges::any_of(told,
                                   [&](const QString& each) { return each.startsWith(start); });
    };
    EXPECT_TRUE(said("Measuring, step 1 of 5: the ground truth, ")) << all();
    EXPECT_TRUE(said("Measuring, step 3 of 5: Exact, ")) << all();
}

TEST_F(AccuracyPanel, MaterialWithoutChoices_SaysSo) {
    document().setModel(Side::A, "lambert");
    settle();
    EXPECT_TRUE(state().startsWith("Nothing of this material")) << state().toStdString();
}

/// Milliseconds that this thread has worked.
double workedMs() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

/// The window's own clock measures it, which does not depend on what else the machine does.
TEST_F(AccuracyPanel, WhileMeasuring_TheWindowAnswers) {
    newFrames();
    double longest = 0.0;
    double before = workedMs();
    QTimer tick;
    QObject::connect(&tick, &QTimer::timeout, [&] {
        longest = std::max(longest, workedMs() - before);
        before = workedMs();
    });
    tick.start(5);
    start();
    ASSERT_TRUE(waitForEnd());
    EXPECT_GT(longest, 0.0);
    EXPECT_LT(longest, 100.0);
}

} // namespace
} // namespace patina::tests::accuracy_dock_test
