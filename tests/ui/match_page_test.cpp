// SPDX-License-Identifier: GPL-3.0-or-later
// The page that finds the models that look like another material or a measured surface.
#include <algorithm>
#include <set>

#include <QCheckBox>
#include <QComboBox>
#include <QTreeWidget>

#include "accuracy/match_page.h"
#include "accuracy/match_plot.h"
#include "document/snapshot_edits.h"
#include "support/measured_files.h"
#include "ui/accuracy_fixture.h"

namespace patina::tests::match_page_test {
namespace {

class MatchPanel : public AccuracyPanel {
  protected:
    MatchPanel() {
        document().setModel(Side::A, "lambert");
        pages().setCurrentWidget(&page());
        page().findChild<QCheckBox*>("all models")->setChecked(false);
    }

    MatchPage& page() { return *pages().findChild<MatchPage*>(); }
    QTreeWidget& list() { return *page().findChild<QTreeWidget*>(); }
    MatchPlot& plot() {
        return static_cast<MatchPlot&>(*page().findChild<PlotWidget*>("matchPlot"));
    }
    QComboBox& aim() { return *page().findChild<QComboBox*>("aim"); }

    bool match() {
        for (QToolButton* button : page().findChildren<QToolButton*>()) {
            if (button->text() == "Measure" && button->isEnabled()) {
                button->click();
            }
        }
        return QTest::qWaitFor([this] { return list().topLevelItemCount() == 1; }, waitMs) &&
               QTest::qWaitFor([this] { return !page().isMeasuring(); }, waitMs);
    }

    glm::dvec3 color() {
        return std::get<glm::dvec3>(
            document().material(Side::A)->model.parameters.at("diffuse.color"));
    }
};

TEST_F(MatchPanel, NothingToMatch_SaysWhatToDo) {
    EXPECT_EQ(aim().count(), 0);
    EXPECT_TRUE(page().state().contains("snapshot")) << page().state().toStdString();
}

TEST_F(MatchPanel, Snapshot_IsMatchedAndTakenInOneStep) {
    document().setValue(pathOf(kinds::models), "diffuse.color", glm::dvec3(0.6, 0.3, 0.1));
    takeSnapshot(document(), {});
    document().setValue(pathOf(kinds::models), "diffuse.color", glm::dvec3(0.1, 0.1, 0.9));
    settle();
    ASSERT_EQ(aim().count(), 1);
    ASSERT_TRUE(match()) << page().state().toStdString();
    const int before = steps();
    list().setCurrentItem(list().topLevelItem(0));
    list().setFocus();
    QTest::keyClick(&list(), Qt::Key_Return);
    EXPECT_EQ(steps(), before + 1);
    EXPECT_LT(glm::length(color() - glm::dvec3(0.6, 0.3, 0.1)), 1e-3);
    document().undoStack().undo();
    EXPECT_EQ(color(), glm::dvec3(0.1f, 0.1f, 0.9f));
}

TEST_F(MatchPanel, Drawing_IsToldToBeNoReflectance) {
    takeSnapshot(document(), {});
    document().setModel(Side::A, "gooch");
    settle();
    for (QToolButton* button : page().findChildren<QToolButton*>()) {
        if (button->text() == "Measure") {
            button->click();
        }
    }
    ASSERT_TRUE(QTest::qWaitFor([this] { return !page().isMeasuring(); }, waitMs));
    EXPECT_TRUE(page().state().contains("draws tones")) << page().state().toStdString();
}

TEST_F(MatchPanel, MeasuredFile_IsMatched) {
    writeFile(home("paint.binary"), merlBytes({8, 8, 16}, [](const DirectionPair&) {
                  return glm::dvec3(0.5, 0.25, 0.125) / 3.14159265358979;
              }));
    page().aimAt(home("paint.binary"));
    ASSERT_TRUE(match()) << page().state().toStdString();
    list().setCurrentItem(list().topLevelItem(0));
    list().setFocus();
    QTest::keyClick(&list(), Qt::Key_Return);
    EXPECT_LT(glm::length(color() - glm::dvec3(0.5, 0.25, 0.125)), 1e-3);
}

TEST_F(MatchPanel, AllModels_AppearAsTheyAreDoneAndAreTimed) {
    writeFile(home("paint.binary"), merlBytes({8, 8, 16}, [](const DirectionPair&) {
                  return glm::dvec3(0.5, 0.25, 0.125) / 3.14159265358979;
              }));
    page().aimAt(home("paint.binary"));
    page().findChild<QCheckBox*>("all models")->setChecked(true);
    std::set<int> counts;
    for (QToolButton* button : page().findChildren<QToolButton*>()) {
        if (button->text() == "Measure") {
            button->click();
        }
    }
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            counts.insert(list().topLevelItemCount());
            return std::ranges::any_of(page().matches().rows, [](const ModelMatch& row) {
                return row.nanoseconds.has_value();
            });
        },
        8 * waitMs));
    EXPECT_GT(counts.size(), 3u);
    EXPECT_GT(page().matches().rows.size(), 10u);
    for (QToolButton* button : page().findChildren<QToolButton*>()) {
        if (button->text() == "Stop") {
            button->click();
        }
    }
    ASSERT_TRUE(QTest::qWaitFor([this] { return !page().isMeasuring(); }, waitMs));
    EXPECT_GT(page().matches().rows.size(), 10u);
    const auto& rows = page().matches().rows;
    const auto timed = std::ranges::find_if(
        rows, [](const ModelMatch& row) { return row.nanoseconds.has_value(); });
    ASSERT_NE(timed, rows.end());
    const QPoint dot = plot().placeOf(static_cast<std::size_t>(timed - rows.begin()));
    EXPECT_TRUE(plot().isVisible());
    EXPECT_TRUE(plot().readingAt(dot).contains("ns/pixel"));
    EXPECT_EQ(plot().readingAt(QPoint(0, 0)), "");
}

TEST_F(MatchPanel, DamagedFile_IsToldAndNothingIsLost) {
    writeFile(home("text.binary"), "no numbers");
    page().aimAt(home("text.binary"));
    const glm::dvec3 before = color();
    EXPECT_FALSE(list().topLevelItemCount() > 0);
    for (QToolButton* button : page().findChildren<QToolButton*>()) {
        if (button->text() == "Measure") {
            button->click();
        }
    }
    ASSERT_TRUE(QTest::qWaitFor([this] { return !page().isMeasuring(); }, waitMs));
    EXPECT_TRUE(page().state().contains("text.binary") || page().state().contains("too short"))
        << page().state().toStdString();
    EXPECT_EQ(color(), before);
}

} // namespace
} // namespace patina::tests::match_page_test
