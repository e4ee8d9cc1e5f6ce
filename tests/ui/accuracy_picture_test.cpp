// SPDX-License-Identifier: GPL-3.0-or-later
// The chart of what the scene's own choices cost.
#include <algorithm>
#include <memory>

#include <QCheckBox>

#include "accuracy/picture_target.h"
#include "document/scene_edits.h"
#include "measure/choice/pass_choices.h"
#include "scene/picture_choice_text.h"
#include "scene/scene_file.h"
#include "ui/accuracy_fixture.h"
#include "viewport/difference_view.h"
#include "viewport/side_view.h"

namespace patina::tests::accuracy_picture_test {
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

    /// Undoes all that was done after the measurement.
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
    using AccuracyPanel::camera;
    using AccuracyPanel::document;
    using AccuracyPanel::home;
    using AccuracyPanel::list;
    using AccuracyPanel::pages;
    using AccuracyPanel::plot;
    using AccuracyPanel::press;
    using AccuracyPanel::settle;
    using AccuracyPanel::state;
    using AccuracyPanel::typeInto;
    using AccuracyPanel::window;

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
    MainWindow& window() { return panel().window(); }
    Document& document() { return panel().document(); }
    void press(const QString& text) { panel().press(text); }
    void settle() { panel().settle(); }
    int steps() { return document().undoStack().index(); }

    /// The point that takes these levels alone; -1: none.
    int pointOf(const ChosenLevels& levels) {
        const std::vector<CostPoint>& points = dock().chart().points;
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
    EXPECT_NE(dock().chart().find({{"picture.samples", "4"}, {"picture.numbers", "half"}}),
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
    document().setBlock(pathOf(kinds::fog), "exponential");
    settle();
    EXPECT_TRUE(dock().isStale());
}

TEST_F(PicturePanel, ErrorBudget_PicksAWayWithinItAndTheSceneTakesIt) {
    panel().typeInto(panel().bound("share"), "50 %");
    ASSERT_TRUE(budget().answer().has_value());
    ASSERT_TRUE(budget().answer()->fits);
    const CostPoint& bought = dock().chart().points[budget().answer()->point];
    press("Use it");
    settle();
    const std::vector<Choice> choices = choicesOfPicture(document().scene(), document().catalog());
    EXPECT_EQ(levelsOfPicture(document().scene(), choices, document().catalog()), bought.levels);
}

TEST_F(PicturePanel, ShadowsLayersAndDirections_AreGivenToWhatHasThem) {
    document().setBlock(pathOf(kinds::environment), "studio");
    document().setBlock(pathOf(kinds::transparency), "peeled");
    document().setValue(document().selection().currentPath(settings::material), "opacity", 0.5);
    document().setBlock(pathOf(kinds::shadows, 0), "filtered");
    const std::vector<Choice> choices = choicesOfPicture(document().scene(), document().catalog());
    const ChosenLevels wanted{
        {"picture.environment", "16"}, {"picture.layers", "2"}, {"picture.shadows", "coarse"}};
    for (const auto& each : wanted) {
        ASSERT_TRUE(std::ranges::any_of(choices, [&](const Choice& choice) {
            return choice.id == each.first && choice.level(each.second) != nullptr;
        })) << each.first;
    }
    const int count = steps();
    PictureTarget(document(), window().comparison(), window().views())
        .apply(choices, wanted, "Accuracy");
    EXPECT_EQ(steps(), count + 1);
    EXPECT_EQ(levelsOfPicture(document().scene(), choices, document().catalog()), wanted);
    document().undoStack().undo();
    EXPECT_NE(levelsOfPicture(document().scene(), choices, document().catalog()), wanted);
}

TEST_F(PicturePanel, LevelsOfPasses_AreGivenToThePassesAsOneStep) {
    const PictureTarget target(document(), window().comparison(), window().views());
    EXPECT_FALSE(std::ranges::any_of(target.choices(), isOfPass));
    addPass(document(), "kuwahara");
    const std::vector<Choice> choices = target.choices();
    ASSERT_TRUE(std::ranges::any_of(choices, isOfPass));
    ChosenLevels wanted = target.levels(choices);
    wanted["pass.kuwahara.samples"] = "coarse";
    const int count = steps();
    PictureTarget(document(), window().comparison(), window().views())
        .apply(choices, wanted, "Accuracy");
    EXPECT_EQ(steps(), count + 1);
    EXPECT_EQ(target.levels(choices), wanted);
    EXPECT_EQ(std::get<std::string>(document().scene().passes[0].parameters.at("samples")),
              "coarse");
}

TEST_F(PicturePanel, PassesThatAreCompared_DifferInTheirLevelsAlone) {
    addPass(document(), "kuwahara");
    PictureTarget target(document(), window().comparison(), window().views());
    target.compare(target.choices(), {{"pass.kuwahara.samples", "coarse"}});
    const auto samplesOf = [this](Side side) {
        return std::get<std::string>(document().scene(side).passes[0].parameters.at("samples"));
    };
    EXPECT_EQ(samplesOf(Side::A), "fine");
    EXPECT_EQ(samplesOf(Side::B), "coarse");
}

TEST_F(PicturePanel, PicturesAccuracy_LeavesTheMaterialsChartFresh) {
    AccuracyPage& material = *pages().findChild<AccuracyPage*>("material");
    pages().setCurrentWidget(&material);
    CostSweep::Options options;
    options.size = {32, 32};
    options.pairs.min = 3;
    options.pairs.max = 3;
    options.combinations = false;
    material.measure(options);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !material.isMeasuring(); }, waitMs));
    document().setValue(document().selection().currentPath(settings::scene), "picture.scale",
                        std::string("half"));
    settle();
    EXPECT_FALSE(material.isStale());
}

/// Side by side, by the row and the button as an artist takes them.
class ComparedPicturePanel : public PicturePanel {
  protected:
    void compareHalf() {
        list().select(pointOf({{"picture.scale", "half"}}));
        const QPoint row = list().visualItemRect(list().currentItem()).center();
        list().select(-1);
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, {20, row.y()});
        press("Compare with exact");
        settle();
    }

    void TearDown() override {
        window().comparison().setComparing(false);
        PicturePanel::TearDown();
    }

    std::string savedScene() {
        const std::filesystem::path file = panel().home("compared.patina-scene.json");
        EXPECT_TRUE(writeScene(file, window().documentFiles().sceneToSave()));
        return readFile(file);
    }

    static double scaleOf(const Scene& scene) { return scene.accuracy.scale(); }
};

TEST_F(ComparedPicturePanel, HasTheExactPictureInAAndTheChosenInBInOneStep) {
    const Scene before = document().scene();
    const int count = steps();
    compareHalf();
    EXPECT_EQ(steps(), count + 1);
    EXPECT_EQ(document().scene(), before); // nothing is chosen by looking
    EXPECT_EQ(document().scene(Side::A).accuracy.samples(), 8);
    EXPECT_TRUE(document().scene(Side::A).accuracy.hasWholeNumbers());
    EXPECT_EQ(scaleOf(document().scene(Side::A)), 1.0);
    EXPECT_EQ(scaleOf(document().scene(Side::B)), 0.5);
    EXPECT_FALSE(dock().isStale());
    press("Compare with exact");
    EXPECT_EQ(steps(), count + 1);
    document().undoStack().undo();
    EXPECT_FALSE(document().isComparing());
    EXPECT_EQ(document().scene(Side::A), before);
    document().undoStack().redo();
    EXPECT_EQ(scaleOf(document().scene(Side::B)), 0.5);
}

TEST_F(ComparedPicturePanel, TitlesSayHowEachSideIsDrawn) {
    compareHalf();
    for (SideView* view : panel().window().findChildren<SideView*>()) {
        const QString told = view->findChild<QLabel*>("title")->toolTip();
        EXPECT_TRUE(told.startsWith(view->side() == Side::A ? "Exact" : "Render scale: "))
            << told.toStdString();
    }
}

TEST_F(ComparedPicturePanel, DifferenceIsThatOfThePictures) {
    compareHalf();
    DifferenceView& view = *panel().window().views().difference();
    const auto greatest = [&view] {
        QTest::qWait(20);
        EXPECT_TRUE(QTest::qWaitFor([&view] { return view.isUpToDate(); }, waitMs));
        return std::ranges::max(view.difference()->relative);
    };
    EXPECT_GT(greatest(), 0.01f);
    dock().compare(0); // the exact one beside itself
    EXPECT_EQ(greatest(), 0.0f);
    dock().compare(pointOf({{"picture.numbers", "half"}}));
    EXPECT_GT(greatest(), 0.0f); // not hidden by floats
}

TEST_F(ComparedPicturePanel, EndOfComparing_LeavesTheSceneAndTheCamera) {
    const Scene before = document().scene();
    const Camera seen = panel().camera();
    compareHalf();
    window().comparison().setComparing(false);
    EXPECT_EQ(document().scene(), before);
    EXPECT_EQ(document().scene(Side::A), before);
    EXPECT_EQ(panel().camera(), seen);
    document().undoStack().undo();
    EXPECT_EQ(scaleOf(document().scene(Side::B)), 0.5);
}

TEST_F(ComparedPicturePanel, SavedScene_HasItsOwnPictureAndNoOtherSide) {
    const std::string before = savedScene();
    compareHalf();
    EXPECT_EQ(savedScene(), before);
}

TEST_F(ComparedPicturePanel, EditedMaterial_IsShownOnBothSides) {
    compareHalf();
    const BlockPath path = document().selection().currentPath(settings::material);
    document().setValue(path, "opacity", 0.5);
    for (const Side side : {Side::A, Side::B}) {
        EXPECT_EQ(document().scene(side).objects.front().material.opacity, 0.5);
    }
    EXPECT_EQ(scaleOf(document().scene(Side::B)), 0.5);
}

TEST_F(ComparedPicturePanel, ChosenPicture_IsShownInA) {
    compareHalf();
    dock().apply(pointOf({{"picture.scale", "half"}}));
    EXPECT_EQ(scaleOf(document().scene()), 0.5);
    EXPECT_EQ(scaleOf(document().scene(Side::A)), 0.5);
    const int count = steps();
    document().undoStack().undo();
    EXPECT_EQ(scaleOf(document().scene(Side::A)), 1.0);
    document().setValue(document().selection().currentPath(settings::scene), "picture.scale",
                        std::string("half"));
    EXPECT_EQ(scaleOf(document().scene(Side::A)), 0.5);
    EXPECT_EQ(steps(), count);
}

TEST_F(ComparedPicturePanel, SwappedSides_SwapThePictures) {
    compareHalf();
    window().comparison().swapSides();
    EXPECT_EQ(scaleOf(document().scene(Side::A)), 0.5);
    EXPECT_EQ(scaleOf(document().scene(Side::B)), 1.0);
}

TEST_F(ComparedPicturePanel, MaterialsThatAreComparedNext_HaveTheScenesPicture) {
    compareHalf();
    window().comparison().previewMaterials(*document().material(Side::A),
                                           *document().material(Side::B), "Compare");
    EXPECT_EQ(document().scene(Side::A), document().scene());
    EXPECT_EQ(scaleOf(document().scene(Side::B)), scaleOf(document().scene()));
}

} // namespace
} // namespace patina::tests::accuracy_picture_test
