// SPDX-License-Identifier: GPL-3.0-or-later
// The chart of what accuracy costs, on a user's model whose errors are known.
#include <algorithm>
#include <ctime>

#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QSpinBox>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "accuracy/budget_row.h"
#include "accuracy/cost_list.h"
#include "accuracy/cost_plot.h"
#include "docks/accuracy_dock.h"
#include "ui/window_fixture.h"

namespace patina::tests {
namespace {

constexpr int waitMs = 120000;
constexpr double nearError = 0.001;
constexpr double farError = 0.1;

constexpr const char* descriptor = R"({
  "id": "burning", "version": 1, "label": "Burning", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.", "parameters": [],
  "accuracy": [{"id": "work", "label": "Work", "doc": "How much.", "values": [
    {"id": "all", "label": "All of it", "doc": "Right.", "exact": true},
    {"id": "near", "label": "Near", "doc": "A little off."},
    {"id": "far", "label": "Far", "doc": "Far off."}]}],
  "claims": ["finite"]
})";

constexpr const char* shader = R"(// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"

vec3 burning(Directions d, Burning p) {
    int count = 160;
    float value = 0.5;
    if (p.work == BURNING_WORK_NEAR) {
        count = 16;
        value = 0.5005;
    }
    if (p.work == BURNING_WORK_FAR) {
        count = 1;
        value = 0.55;
    }
    float sum = 0.0;
    for (int i = 0; i < count; ++i) {
        sum += sin(d.nl + float(i) * sum);
    }
    return vec3(d.nl * (value + 1e-12 * sum));
}
)";

class AccuracyPanel : public WindowFixture {
  protected:
    AccuracyPanel() {
        const std::filesystem::path folder = home("XDG_DATA_HOME") / "patina/shaders/models";
        std::filesystem::create_directories(folder);
        writeFile(folder / "burning.json", descriptor);
        writeFile(folder / "burning.glsl", shader);
        document().setCatalog(
            std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())));
        document().setModel(Side::A, "burning");
        document().setPart(Side::A, BlockPath::Part::Fresnel, "");
        document().setEnvironment("");
        document().setValue(document().currentPath(BlockPath::Part::Scene), "ambient",
                            glm::dvec3(0.0));
        window().dock("accuracy")->show();
        settle();
    }

    AccuracyDock& dock() { return *window().dock("accuracy")->findChild<AccuracyDock*>(); }
    CostList& list() { return *dock().findChild<CostList*>(); }
    CostPlot& plot() { return *dock().findChild<CostPlot*>(); }
    BudgetRow& budget() { return *dock().findChild<BudgetRow*>(); }
    QString state() { return dock().findChild<QLabel*>("state")->text(); }
    void settle() { QTest::qWait(200); }

    /// Few small frames: what is tested here is not the instrument.
    void start() {
        CostSweep::Options options;
        options.size = {48, 48};
        options.pairs.fewest = 3;
        options.pairs.most = 4;
        options.combinations = false;
        dock().measure(options);
    }

    bool waitForEnd() {
        return QTest::qWaitFor([this] { return !dock().isMeasuring(); }, waitMs);
    }

    bool measure() {
        start();
        return waitForEnd() && dock().shown() != nullptr && dock().shown()->complete;
    }

    /// The point with a level; -1: none.
    int pointOf(const std::string& level) {
        const std::vector<CostPoint>& points = dock().shown()->chart.points;
        const auto found = std::find_if(points.begin(), points.end(), [&](const CostPoint& point) {
            return point.levels == ChosenLevels{{"work", level}};
        });
        return found == points.end() ? -1 : static_cast<int>(found - points.begin());
    }

    int fastest() {
        const std::vector<CostPoint>& points = dock().shown()->chart.points;
        const auto found = std::min_element(
            points.begin(), points.end(), [](const CostPoint& a, const CostPoint& b) {
                return a.cost.nanosecondsPerPixel < b.cost.nanosecondsPerPixel;
            });
        return static_cast<int>(found - points.begin());
    }

    double errorOfLevel(const std::string& level) {
        return errorOf(dock().shown()->chart.points.at(std::size_t(pointOf(level))));
    }

    /// What the material has; empty: exact.
    std::string level(Side side = Side::A) {
        const AccuracyLevels& levels = document().material(side)->accuracy;
        const auto found = levels.find("work");
        return found == levels.end() || found->second == "all" ? std::string() : found->second;
    }

    int steps() { return document().undoStack().count(); }

    void press(const QString& text) {
        for (QToolButton* button : dock().findChildren<QToolButton*>()) {
            if (button->text() == text) {
                button->click();
            }
        }
    }

    QByteArray exported(const QString& ending) {
        const QString file = QString::fromStdString(home("chart").string()) + '.' + ending;
        dock().exportTo(file);
        QFile written(file);
        return written.open(QIODevice::ReadOnly) ? written.readAll() : QByteArray();
    }
};

TEST_F(AccuracyPanel, Measured_HasARowForEveryLevel) {
    ASSERT_TRUE(measure()) << state().toStdString();
    EXPECT_EQ(list().topLevelItemCount(), 3);
}

TEST_F(AccuracyPanel, Measured_HasTheKnownErrors) {
    ASSERT_TRUE(measure()) << state().toStdString();
    EXPECT_NEAR(errorOfLevel("near"), nearError, 0.01 * nearError);
    EXPECT_NEAR(errorOfLevel("far"), farError, 0.01 * farError);
}

TEST_F(AccuracyPanel, EnterInTheTable_GivesTheMaterialThatLevel) {
    ASSERT_TRUE(measure()) << state().toStdString();
    list().select(pointOf("near"));
    QTest::keyClick(&list(), Qt::Key_Return);
    EXPECT_EQ(level(), "near");
}

TEST_F(AccuracyPanel, ClickOnAPoint_GivesTheMaterialThatLevel) {
    ASSERT_TRUE(measure()) << state().toStdString();
    settle();
    const QPoint place = plot().placeOf(pointOf("far"));
    QWidget* target = plot().childAt(place);
    ASSERT_NE(target, nullptr);
    QTest::mouseClick(target, Qt::LeftButton, {}, target->mapFrom(&plot(), place));
    EXPECT_EQ(level(), "far");
}

TEST_F(AccuracyPanel, KeysInTheChart_GoFromPointToPoint) {
    ASSERT_TRUE(measure()) << state().toStdString();
    plot().setFocus();
    QTest::keyClick(&plot(), Qt::Key_Right);
    EXPECT_EQ(plot().selected(), fastest());
    for (int i = 0; i < 3; ++i) {
        QTest::keyClick(&plot(), Qt::Key_Right);
    }
    EXPECT_EQ(plot().selected(), 0); // the exact one takes longest
}

TEST_F(AccuracyPanel, EnterInTheChart_GivesTheMaterialThatLevel) {
    ASSERT_TRUE(measure()) << state().toStdString();
    plot().select(pointOf("near"));
    QTest::keyClick(&plot(), Qt::Key_Return);
    EXPECT_EQ(level(), "near");
}

TEST_F(AccuracyPanel, AppliedPoint_IsOneUndoStep) {
    ASSERT_TRUE(measure()) << state().toStdString();
    const int before = steps();
    dock().apply(pointOf("near"));
    EXPECT_EQ(steps(), before + 1);
    document().undoStack().undo();
    EXPECT_EQ(level(), "");
}

TEST_F(AccuracyPanel, AppliedPoint_LeavesTheChartFresh) {
    ASSERT_TRUE(measure()) << state().toStdString();
    dock().apply(pointOf("near"));
    settle();
    EXPECT_FALSE(dock().isStale());
}

TEST_F(AccuracyPanel, ChangedScene_PutsTheChartOutOfDate) {
    ASSERT_TRUE(measure()) << state().toStdString();
    document().setFog("exponential");
    settle();
    EXPECT_TRUE(dock().isStale());
    EXPECT_TRUE(state().startsWith("Out of date")) << state().toStdString();
}

TEST_F(AccuracyPanel, SceneThatIsBack_HasItsChartAgain) {
    ASSERT_TRUE(measure()) << state().toStdString();
    document().setFog("exponential");
    settle();
    document().undoStack().undo();
    settle();
    EXPECT_FALSE(dock().isStale());
}

TEST_F(AccuracyPanel, ChartOfAnotherModel_IsNotApplied) {
    ASSERT_TRUE(measure()) << state().toStdString();
    const int point = pointOf("near");
    document().setModel(Side::A, "lambert");
    const int before = steps();
    dock().apply(point);
    EXPECT_EQ(steps(), before);
}

TEST_F(AccuracyPanel, ErrorBudget_PicksTheFastestWayWithinIt) {
    ASSERT_TRUE(measure()) << state().toStdString();
    budget().findChildren<QCheckBox*>().last()->setChecked(true);
    budget().findChild<QSpinBox*>()->setValue(255);
    ASSERT_TRUE(budget().answer().has_value());
    EXPECT_TRUE(budget().answer()->fits);
    EXPECT_EQ(static_cast<int>(budget().answer()->point), pointOf("near"));
    press("Use it");
    EXPECT_EQ(level(), "near");
}

TEST_F(AccuracyPanel, TimeBudgetThatNothingMeets_SaysSo) {
    ASSERT_TRUE(measure()) << state().toStdString();
    budget().findChildren<QCheckBox*>().first()->setChecked(true);
    budget().findChild<QDoubleSpinBox*>()->setValue(0.01);
    ASSERT_TRUE(budget().answer().has_value());
    EXPECT_FALSE(budget().answer()->fits);
    const QString text = budget().findChild<QLabel*>("budget")->text();
    EXPECT_TRUE(text.startsWith("Nothing fits")) << text.toStdString();
}

TEST_F(AccuracyPanel, Compared_HasTheExactWayInAAndTheChosenInB) {
    ASSERT_TRUE(measure()) << state().toStdString();
    dock().apply(pointOf("near"));
    settle();
    const int before = steps();
    list().select(pointOf("far"));
    dock().compare(list().selected());
    EXPECT_EQ(steps(), before + 1);
    EXPECT_EQ(level(Side::A), "");
    EXPECT_EQ(level(Side::B), "far");
}

TEST_F(AccuracyPanel, ExportedTable_HasALineForEveryPoint) {
    ASSERT_TRUE(measure()) << state().toStdString();
    EXPECT_EQ(exported("csv").trimmed().split('\n').size(), 1 + 3);
    EXPECT_TRUE(exported("json").contains("\"points\""));
}

TEST_F(AccuracyPanel, ExportedChart_IsAPicture) {
    ASSERT_TRUE(measure()) << state().toStdString();
    EXPECT_TRUE(exported("png").startsWith("\x89PNG"));
    EXPECT_TRUE(exported("svg").contains("<svg"));
}

TEST_F(AccuracyPanel, StoppedMeasurement_SaysSo) {
    dock().measure();
    press("Stop");
    ASSERT_TRUE(waitForEnd());
    EXPECT_TRUE(state().startsWith("Stopped")) << state().toStdString();
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

/// By the window's own clock, which does not depend on what else the machine does.
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
} // namespace patina::tests
