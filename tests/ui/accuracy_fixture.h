// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include <QCheckBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QTest>
#include <QToolButton>

#include "accuracy/accuracy_dock.h"
#include "accuracy/accuracy_page.h"
#include "accuracy/bound_box.h"
#include "accuracy/budget_row.h"
#include "accuracy/cost_list.h"
#include "accuracy/cost_plot.h"
#include "document/scene_edits.h"
#include "ui/window_fixture.h"

namespace patina::tests {

inline constexpr int waitMs = 120000;
inline constexpr double nearError = 0.001;
inline constexpr double farError = 0.1;

inline constexpr const char* burningDescriptor = R"({
  "id": "burning", "version": 1, "label": "Burning", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.", "parameters": [],
  "accuracy": [{"id": "work", "label": "Work", "doc": "How much.", "values": [
    {"id": "all", "label": "All of it", "doc": "Right.", "exact": true},
    {"id": "near", "label": "Near", "doc": "A little off."},
    {"id": "far", "label": "Far", "doc": "Far off."}]}],
  "claims": ["finite"]
})";

inline constexpr const char* burningShader = R"(// SPDX-License-" "Identifier: MIT-0
#include "lib/directions.glsl"

vec3 burning(Directions d, Burning p) {
    int count = 320;
    float value = 0.5;
    if (p.work == BURNING_WORK_NEAR) {
        count = 32;
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

/// Shows the dock of what accuracy costs, with a user's model whose work and errors are known.
class AccuracyPanel : public WindowFixture {
  protected:
    AccuracyPanel() : AccuracyPanel(std::filesystem::path()) {}

    /// Begins with what earlier sessions measured, which the folder has; empty: nothing.
    explicit AccuracyPanel(const std::filesystem::path& measured) {
        if (!measured.empty()) {
            std::filesystem::create_directories(measurements().parent_path());
            std::filesystem::copy(measured, measurements());
        }
        const std::filesystem::path folder = home("XDG_DATA_HOME") / "patina/shaders/models";
        std::filesystem::create_directories(folder);
        writeFile(folder / "burning.json", burningDescriptor);
        writeFile(folder / "burning.glsl", burningShader);
        document().setCatalog(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())));
        document().setModel(Side::A, "burning");
        document().setBlock(pathOf(kinds::fresnel), "");
        document().setBlock(pathOf(kinds::environment), "");
        while (document().scene().lights.size() > 1) { // each of them costs as much again
            removeLight(document(), 0);
        }
        document().setValue(document().selection().currentPath(settings::scene), "ambient",
                            glm::dvec3(0.0));
        window().dock("accuracy")->show();
        settle();
    }

    std::filesystem::path measurements() const {
        return home("XDG_STATE_HOME") / "patina/measurements";
    }

    AccuracyDock& pages() { return *window().dock("accuracy")->findChild<AccuracyDock*>(); }
    virtual AccuracyPage& dock() { return *pages().findChild<AccuracyPage*>("material"); }
    CostList& list() { return *dock().findChild<CostList*>(); }
    CostPlot& plot() { return *dock().findChild<CostPlot*>(); }
    BudgetRow& budget() { return *dock().findChild<BudgetRow*>(); }
    /// Turns a field of the budget on and returns it.
    BoundBox& bound(const char* name) {
        const bool isTime = QLatin1String(name) == QLatin1String("milliseconds");
        const auto asked = budget().findChildren<QCheckBox*>();
        (isTime ? asked.first() : asked.last())->setChecked(true);
        return *budget().findChild<BoundBox*>(name);
    }
    static void typeInto(BoundBox& box, const QString& text) {
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
    }
    QString state() { return dock().findChild<QLabel*>("state")->text(); }

    /// Measures few small frames: the measurement itself is not tested here.
    void start(int size = 48) {
        CostSweep::Options options;
        options.size = {size, size};
        options.pairs.min = 7; // fewer let noise swap two points
        options.pairs.max = 9;
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

    /// Measures until a level is known to be faster than the exact one: other programs on the
    /// machine may blur one measurement, an error in measuring would blur all of them.
    bool measureUntilFaster(const std::string& level) {
        constexpr int attempts = 4;
        for (int i = 0; i < attempts && !isKnownFaster(level); ++i) {
            measure();
        }
        return isKnownFaster(level);
    }

    bool isKnownFaster(const std::string& level) {
        const int point = pointOf(level);
        return point >= 0 && dock().chart().points[std::size_t(point)].cost.ratio.upper < 1.0;
    }

    /// Returns the index of the point with a level; -1 when there is none.
    int pointOf(const std::string& level) {
        const std::vector<CostPoint>& points = dock().chart().points;
        const auto found = std::find_if(points.begin(), points.end(), [&](const CostPoint& point) {
            return point.levels == ChosenLevels{{"work", level}};
        });
        return found == points.end() ? -1 : static_cast<int>(found - points.begin());
    }

    int fastest() {
        const std::vector<CostPoint>& points = dock().chart().points;
        const auto found = std::min_element(
            points.begin(), points.end(), [](const CostPoint& a, const CostPoint& b) {
                return a.cost.nanosecondsPerPixel < b.cost.nanosecondsPerPixel;
            });
        return static_cast<int>(found - points.begin());
    }

    double errorOfLevel(const std::string& level) {
        return errorOf(dock().chart().points.at(std::size_t(pointOf(level))));
    }

    /// Returns the material's level; empty: exact.
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

/// Shows the panel with the chart of its scene, which is measured once for all tests that begin so
/// and is read from its file, as after a restart of the editor.
class MeasuredPanel : public AccuracyPanel {
  protected:
    MeasuredPanel() : AccuracyPanel(sharedMeasurements()) {}

    void SetUp() override {
        ASSERT_TRUE(dock().shown() != nullptr && dock().shown()->complete && !dock().isStale())
            << state().toStdString();
    }

  private:
    class FirstSession : public AccuracyPanel {
      public:
        void keep(const std::filesystem::path& folder) {
            EXPECT_TRUE(measure()) << state().toStdString();
            std::filesystem::copy(measurements(), folder);
        }

      private:
        void TestBody() override {}
    };

    static std::filesystem::path sharedMeasurements() {
        static const TemporaryFolder folder;
        if (std::filesystem::is_empty(folder.path())) {
            FirstSession().keep(folder.path());
        }
        return folder.path();
    }
};

} // namespace patina::tests
