// SPDX-License-Identifier: GPL-3.0-or-later
// The chart of what the scene's own choices cost.
#include <memory>

#include <QCheckBox>

#include "accuracy/picture_target.h"
#include "scene/picture_choice_text.h"
#include "ui/accuracy_fixture.h"

namespace patina::tests {
namespace {

/// The panel with the chart of a picture. That has many levels and takes long: one is measured for
/// all tests.
class MeasuredPicture : public AccuracyPanel {
  public:
    MeasuredPicture() {
        pages().setCurrentWidget(&dock());
        isMeasured_ = measure();
        start_ = document().undoStack().index();
    }

    bool isMeasured() const { return isMeasured_; }

    /// As it was when all was measured.
    void goBack() {
        document().undoStack().setIndex(start_);
        for (QCheckBox* asked : budget().findChildren<QCheckBox*>()) {
            asked->setChecked(false);
        }
        pages().setCurrentWidget(&dock());
        settle();
    }

    AccuracyPage& dock() override { return *pages().findChild<AccuracyPage*>("picture"); }

    using AccuracyPanel::bound;
    using AccuracyPanel::budget;
    using AccuracyPanel::document;
    using AccuracyPanel::list;
    using AccuracyPanel::pages;
    using AccuracyPanel::plot;
    using AccuracyPanel::press;
    using AccuracyPanel::settle;
    using AccuracyPanel::state;
    using AccuracyPanel::typeInto;

  private:
    void TestBody() override {}

    bool isMeasured_ = false;
    int start_ = 0;
};

class PicturePanel : public testing::Test {
  protected:
    static void SetUpTestSuite() { shared() = std::make_unique<MeasuredPicture>(); }
    static void TearDownTestSuite() { shared().reset(); }

    void SetUp() override {
        ASSERT_TRUE(panel().isMeasured()) << panel().state().toStdString();
        panel().goBack();
    }

    AccuracyPage& dock() { return panel().dock(); }
    AccuracyDock& pages() { return panel().pages(); }
    BudgetRow& budget() { return panel().budget(); }
    CostList& list() { return panel().list(); }
    CostPlot& plot() { return panel().plot(); }
    Document& document() { return panel().document(); }
    void press(const QString& text) { panel().press(text); }
    void settle() { panel().settle(); }
    int steps() { return document().undoStack().index(); }

    /// The point that takes these levels alone; -1: none.
    int pointOf(const ChosenLevels& levels) {
        const std::vector<CostPoint>& points = dock().shown()->chart.points;
        const auto found = std::ranges::find(points, levels, &CostPoint::levels);
        return found == points.end() ? -1 : static_cast<int>(found - points.begin());
    }

    /// What the scene has of a choice.
    std::string level(PictureChoice choice) {
        for (const PictureChoiceText& text : pictureChoiceTexts()) {
            if (text.choice == choice) {
                return text.levels[document().scene().accuracy.level(choice)].id;
            }
        }
        return {};
    }

    MeasuredPicture& panel() { return *shared(); }

  private:
    static std::unique_ptr<MeasuredPicture>& shared() {
        static std::unique_ptr<MeasuredPicture> made;
        return made;
    }
};

TEST_F(PicturePanel, Measured_HasEveryLevelAndWhatTheSceneHas) {
    EXPECT_GE(pointOf({{"picture.scale", "half"}}), 0);
    EXPECT_GE(pointOf({{"picture.normals", "interpolated"}}), 0);
    EXPECT_NE(dock().shown()->chart.find({{"picture.samples", "4"}, {"picture.numbers", "half"}}),
              nullptr);
}

TEST_F(PicturePanel, EnterInTheTable_GivesTheSceneThatLevelInOneStep) {
    const Scene before = document().scene();
    const int count = steps();
    list().select(pointOf({{"picture.scale", "half"}}));
    QTest::keyClick(&list(), Qt::Key_Return);
    EXPECT_EQ(level(PictureChoice::Scale), "half");
    EXPECT_EQ(level(PictureChoice::Samples), "8"); // the others are exact at that point
    EXPECT_EQ(level(PictureChoice::Numbers), "full");
    EXPECT_EQ(steps(), count + 1);
    document().undoStack().undo();
    EXPECT_EQ(document().scene(), before);
}

TEST_F(PicturePanel, ClickOnAPoint_GivesTheSceneThatLevel) {
    settle();
    const QPoint place = plot().placeOf(pointOf({{"picture.scale", "half"}}));
    QWidget* target = plot().childAt(place);
    ASSERT_NE(target, nullptr);
    QTest::mouseClick(target, Qt::LeftButton, {}, target->mapFrom(&plot(), place));
    EXPECT_EQ(level(PictureChoice::Scale), "half");
}

TEST_F(PicturePanel, AppliedPoint_LeavesTheChartFreshAndIsTheCurrentOne) {
    dock().apply(pointOf({{"picture.scale", "half"}}));
    settle();
    EXPECT_FALSE(dock().isStale());
    const int count = steps();
    dock().apply(pointOf({{"picture.scale", "half"}})); // it has that already
    EXPECT_EQ(steps(), count);
}

TEST_F(PicturePanel, ChangedScene_PutsTheChartOutOfDate) {
    document().setFog("exponential");
    settle();
    EXPECT_TRUE(dock().isStale());
}

TEST_F(PicturePanel, ErrorBudget_PicksAWayWithinItAndTheSceneTakesIt) {
    panel().typeInto(panel().bound("share"), "50 %");
    ASSERT_TRUE(budget().answer().has_value());
    ASSERT_TRUE(budget().answer()->fits);
    const CostPoint& bought = dock().shown()->chart.points[budget().answer()->point];
    press("Use it");
    settle();
    const std::vector<Choice> choices = choicesOfPicture(document().scene(), document().catalog());
    EXPECT_EQ(levelsOfPicture(document().scene(), choices, document().catalog()), bought.levels);
}

TEST_F(PicturePanel, ShadowsLayersAndDirections_AreGivenToWhatHasThem) {
    document().setEnvironment("studio");
    document().setTransparency("peeled");
    document().setValue(document().currentPath(BlockPath::Part::Material), "opacity", 0.5);
    document().setShadow(0, "filtered");
    const std::vector<Choice> choices = choicesOfPicture(document().scene(), document().catalog());
    const ChosenLevels wanted{{"picture.environment", "16"}, {"picture.layers", "2"},
                              {"picture.shadows", "coarse"}};
    for (const auto& each : wanted) {
        ASSERT_TRUE(std::ranges::any_of(choices, [&](const Choice& choice) {
            return choice.id == each.first && choice.level(each.second) != nullptr;
        })) << each.first;
    }
    const int count = steps();
    PictureTarget(document()).apply(choices, wanted, "Accuracy");
    EXPECT_EQ(steps(), count + 1);
    EXPECT_EQ(levelsOfPicture(document().scene(), choices, document().catalog()), wanted);
    document().undoStack().undo();
    EXPECT_NE(levelsOfPicture(document().scene(), choices, document().catalog()), wanted);
}

TEST_F(PicturePanel, PicturesAccuracy_LeavesTheMaterialsChartFresh) {
    AccuracyPage& material = *pages().findChild<AccuracyPage*>("material");
    pages().setCurrentWidget(&material);
    CostSweep::Options options;
    options.size = {32, 32};
    options.pairs.fewest = 3;
    options.pairs.most = 3;
    options.combinations = false;
    material.measure(options);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !material.isMeasuring(); }, waitMs));
    document().setValue(document().currentPath(BlockPath::Part::Scene), "picture.scale",
                        std::string("half"));
    settle();
    EXPECT_FALSE(material.isStale());
}

} // namespace
} // namespace patina::tests
