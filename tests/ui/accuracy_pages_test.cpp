// SPDX-License-Identifier: GPL-3.0-or-later
// The pages beside the chart: all models, and how the time grows.
#include <memory>

#include <QHeaderView>

#include "accuracy/growth_plot.h"
#include "accuracy/model_list.h"
#include "accuracy/models_page.h"
#include "accuracy/scaling_page.h"
#include "docks/family_chooser.h"
#include "text/display_number.h"
#include "ui/accuracy_fixture.h"

namespace patina::tests::accuracy_pages_test {
namespace {

/// The panel with the ranking of the first models. They take long to compile, for here and for
/// other cards: they are measured once for all tests.
class MeasuredModels : public AccuracyPanel {
  public:
    MeasuredModels() {
        pages().setCurrentWidget(&page());
        measureSome();
        start_ = document().undoStack().index();
    }

    /// Measures the first models only.
    void measureSome() {
        CostSweep::Options options;
        options.size = {16, 16};
        options.pairs.min = 3;
        options.pairs.max = 3;
        page().measure(options);
        EXPECT_TRUE(page().isMeasuring());
        EXPECT_TRUE(QTest::qWaitFor([this] { return page().costs().size() >= 2; }, waitMs));
        for (QToolButton* button : page().findChildren<QToolButton*>()) {
            if (button->text() == "Stop") {
                button->click();
            }
        }
        EXPECT_TRUE(QTest::qWaitFor([this] { return !page().isMeasuring(); }, waitMs));
    }

    /// Undoes all that was done after the measurement.
    void goBack() {
        document().undoStack().setIndex(start_);
        settle();
    }

    ModelsPage& page() { return *pages().findChild<ModelsPage*>(); }

    using AccuracyPanel::document;
    using AccuracyPanel::home;
    using AccuracyPanel::settle;

  private:
    void TestBody() override {}

    int start_ = 0;
};

class ModelsPanel : public testing::Test {
  protected:
    static void SetUpTestSuite() { shared() = std::make_unique<MeasuredModels>(); }
    static void TearDownTestSuite() { shared().reset(); }

    void SetUp() override {
        shared()->goBack();
        ASSERT_GE(page().costs().size(), 2u);
        ASSERT_FALSE(page().isStale());
    }

    ModelsPage& page() { return shared()->page(); }
    ModelList& models() { return *page().findChild<ModelList*>(); }
    Document& document() { return shared()->document(); }
    void settle() { shared()->settle(); }
    void measureSome() { shared()->measureSome(); }
    std::filesystem::path home(const std::string& name) { return shared()->home(name); }

  private:
    static std::unique_ptr<MeasuredModels>& shared() {
        static std::unique_ptr<MeasuredModels> made;
        return made;
    }
};

TEST_F(ModelsPanel, Stopped_KeepsWhatIsMeasured) {
    EXPECT_TRUE(page().state().startsWith("Stopped")) << page().state().toStdString();
    EXPECT_EQ(models().topLevelItemCount(), static_cast<int>(page().costs().size()));
}

TEST_F(ModelsPanel, Measured_HasPredictedCyclesOfTheChosenCards) {
    const Block& model = *document().catalog().find(kinds::models, page().costs().front().model);
    for (int i = 0; i < models().topLevelItemCount(); ++i) {
        const QTreeWidgetItem& row = *models().topLevelItem(i);
        if (row.text(0).toStdString() == model.label) { // what the descriptor says of it
            const std::string source = model.source.substr(0, 12);
            EXPECT_TRUE(row.toolTip(0).contains(QString::fromStdString(source)));
            EXPECT_EQ(row.text(11), model.hasClaim("energy_conserving") ? "yes" : "no");
            EXPECT_EQ(row.text(12), model.hasClaim("reciprocal") ? "yes" : "no");
            EXPECT_EQ(row.text(13).toInt(), int(model.parameters.size()));
        }
    }
    constexpr int cycles = 9;
    QTreeWidgetItem& first = *models().topLevelItem(0);
    EXPECT_EQ(models().headerItem()->text(cycles), "RDNA 2");
    EXPECT_GT(numberLocale().toDouble(first.text(cycles)), 100.0)
        << first.text(cycles).toStdString();
    const QString note = first.toolTip(cycles);
    EXPECT_TRUE(note.contains("Steam Deck: ")) << note.toStdString();
    EXPECT_TRUE(note.contains("Left out")) << note.toStdString();
    const QString before = first.text(cycles);
    auto& chooser = *page().findChild<FamilyChooser*>();
    chooser.setCurrentIndex(chooser.findData("gcn"));
    EXPECT_EQ(models().headerItem()->text(cycles), "GCN 4");
    EXPECT_NE(models().topLevelItem(0)->text(cycles), before);
}

TEST(ModelsList, WithoutTheDriver_SaysWhatToInstall) {
    ModelList models;
    ModelCost cost{"matte", "Matte", {}, std::nullopt, std::nullopt};
    cost.predicted = failure("no driver", "the package mesa-vulkan-drivers");
    models.setCosts({cost}, false);
    EXPECT_EQ(models.topLevelItem(0)->text(9), QStringLiteral("–"));
    EXPECT_TRUE(models.topLevelItem(0)->toolTip(9).contains("mesa-vulkan-drivers"));
}

TEST_F(ModelsPanel, OtherScene_PutsItOutOfDate) {
    document().setModel(Side::A, page().costs().front().model);
    settle();
    EXPECT_FALSE(page().isStale()); // every model was measured with its defaults
    document().setBlock(pathOf(kinds::fog), "exponential");
    settle();
    EXPECT_TRUE(page().isStale());
}

TEST(ModelsList, LightLost_IsWrittenAsTheFieldsWriteNumbers) {
    ModelList models;
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    const auto textOf = [&models](double loss) {
        models.setCosts({{"matte", "Matte", {}, std::nullopt, loss}}, false);
        return models.topLevelItem(0)->text(10);
    };
    const QString text = textOf(0.255);
    const QString nothing = textOf(-1e-7);
    QLocale::setDefault(before);
    EXPECT_EQ(text, "25.5 %");
    EXPECT_EQ(nothing, "0.0 %");
}

TEST(ModelsList, LightLostByADrawing_IsEmptyAndSaysWhy) {
    ModelList models;
    models.setCatalog(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())));
    models.setCosts({{"toon", "Toon", {}, std::nullopt, 0.2}}, false);
    EXPECT_EQ(models.topLevelItem(0)->text(10), "");
    EXPECT_TRUE(models.topLevelItem(0)->toolTip(10).contains("no share of the light"));
}

TEST_F(ModelsPanel, SceneThatIsBack_HasItsNumbersAgain) {
    const std::string first = page().costs().front().model;
    document().setBlock(pathOf(kinds::fog), "exponential");
    settle();
    measureSome();
    EXPECT_FALSE(page().isStale());
    document().undoStack().undo();
    settle();
    EXPECT_FALSE(page().isStale()) << first;
    EXPECT_EQ(models().topLevelItemCount(), static_cast<int>(page().costs().size()));
}

TEST(ModelsList, LongNumbers_WidenTheirColumns) {
    ModelList models;
    ModelCost longest{"slow", "Slow", {}, std::nullopt, std::nullopt};
    longest.cost.nanosecondsPerPixel = 1234567.0;
    models.setCosts({longest}, false);
    const QString text = models.topLevelItem(0)->text(2);
    EXPECT_GT(models.columnWidth(2), models.fontMetrics().horizontalAdvance(text));
}

TEST(ModelsList, Columns_FitBesideEachOtherInADockOfUsualWidth) {
    ModelList models;
    constexpr int dockOf1600 = 846; // pixels between the docks at the sides, less a scroll bar
    EXPECT_LE(models.header()->length(), dockOf1600);
}

TEST_F(ModelsPanel, Enter_GivesTheObjectThatModel) {
    models().setCurrentItem(models().topLevelItem(1));
    const QString model = models().currentItem()->data(0, Qt::UserRole).toString();
    QTest::keyClick(&models(), Qt::Key_Return);
    EXPECT_EQ(document().material(Side::A)->model.id, model.toStdString());
}

TEST_F(ModelsPanel, ExportedTable_HasALineForEveryModel) {
    const QString file = QString::fromStdString((home("ranking") += ".csv").string());
    page().exportTo(file);
    QFile written(file);
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    EXPECT_EQ(written.readAll().trimmed().split('\n').size(), 1 + models().topLevelItemCount());
}

class ScalingPanel : public AccuracyPanel {
  protected:
    ScalingPanel() {
        document().setModel(Side::A, "lambert");
        pages().setCurrentWidget(&page());
    }

    ScalingPage& page() { return *pages().findChild<ScalingPage*>(); }

    /// Returns the action of the menu View > Look with the text.
    QAction& lookAction(const QString& text) {
        const QList<QAction*> all = window().findChildren<QAction*>();
        return **std::ranges::find(all, text, &QAction::text);
    }

    QToolButton& startButton() {
        const QList<QToolButton*> all = page().findChildren<QToolButton*>();
        return **std::ranges::find(all, "Measure", &QToolButton::text);
    }

    bool measureSmall() {
        ScalingSweep::Options options;
        options.edges = {16, 32, 64};
        options.lights = {1, 2, 4};
        options.objects = {1, 2, 4};
        options.edge = 32;
        options.rounds = 2;
        page().measure(options);
        return QTest::qWaitFor([this] { return !page().isMeasuring(); }, waitMs);
    }
};

TEST_F(ScalingPanel, Measured_HasALawForEachAxis) {
    ASSERT_TRUE(measureSmall());
    ASSERT_EQ(page().curves().size(), 3u) << page().state().toStdString();
    for (GrowthPlot* plot : page().findChildren<GrowthPlot*>()) {
        EXPECT_FALSE(plot->law().isEmpty());
    }
}

TEST_F(ScalingPanel, Laws_AreWrittenAsTheFieldsWriteNumbers) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    ScalingCurve curve{ScalingCurve::Axis::Lights,
                       {{1, {2.5, 2.5, 2.5}}, {4, {4, 4, 4}}, {64, {34, 34, 34}}},
                       std::nullopt};
    curve.law = growthLaw(curve.samples);
    GrowthPlot plot(curve.axis);
    plot.setCurve(curve, false);
    QLocale::setDefault(before);
    EXPECT_EQ(plot.law(), "linear: 2 ms + 0.5 ms per light, R² 1.000");
}

TEST_F(ScalingPanel, WhileAnotherPageMeasures_WaitsAndSaysWhy) {
    document().setModel(Side::A, "burning");
    pages().setCurrentWidget(&dock());
    settle();
    start();
    ASSERT_TRUE(dock().isMeasuring());
    pages().setCurrentWidget(&page());
    EXPECT_FALSE(startButton().isEnabled());
    EXPECT_TRUE(startButton().toolTip().contains("This Material"));
    EXPECT_TRUE(page().state().contains("This Material")) << page().state().toStdString();
    page().measure({});
    EXPECT_FALSE(page().isMeasuring());
    ASSERT_TRUE(waitForEnd());
    EXPECT_TRUE(startButton().isEnabled());
    EXPECT_EQ(page().state(), "Nothing is measured yet.");
}

TEST_F(ScalingPanel, OtherLook_PaintsThePlotsInIt) {
    const auto paper = [this] {
        return page().findChild<GrowthPlot*>()->grab().toImage().pixelColor(2, 2).lightness();
    };
    lookAction("&Dark").trigger();
    settle();
    EXPECT_LT(paper(), 100);
    lookAction("&Light").trigger();
    settle();
    EXPECT_GT(paper(), 200);
}

TEST_F(ScalingPanel, SceneThatIsBack_HasItsNumbersAgain) {
    ASSERT_TRUE(measureSmall());
    const std::vector<ScalingCurve> first = page().curves();
    document().setBlock(pathOf(kinds::fog), "exponential");
    settle();
    ASSERT_TRUE(measureSmall());
    EXPECT_FALSE(page().isStale());
    EXPECT_FALSE(page().curves() == first);
    document().undoStack().undo();
    settle();
    EXPECT_FALSE(page().isStale());
    EXPECT_TRUE(page().curves() == first);
}

TEST_F(ScalingPanel, SavedDocument_KeepsItsNumbers) {
    ASSERT_TRUE(measureSmall());
    ASSERT_TRUE(window().documentFiles().saveScene(home("saved.patina-scene.json")));
    settle();
    EXPECT_FALSE(page().isStale());
    EXPECT_EQ(page().curves().size(), 3u);
}

TEST_F(ScalingPanel, OtherDocument_HasNoneOfItsNumbers) {
    ASSERT_TRUE(window().documentFiles().saveScene(home("one.patina-scene.json")));
    ASSERT_TRUE(measureSmall());
    window().documentFiles().startFrom(Scene(document().scene()));
    document().setBlock(pathOf(kinds::fog), "exponential");
    settle();
    EXPECT_TRUE(page().curves().empty());
    ASSERT_TRUE(window().documentFiles().openScene(home("one.patina-scene.json")));
    settle();
    EXPECT_EQ(page().curves().size(), 3u);
}

TEST_F(ScalingPanel, ChangedScene_PutsItOutOfDate) {
    ASSERT_TRUE(measureSmall());
    EXPECT_FALSE(page().isStale());
    document().setBlock(pathOf(kinds::fog), "exponential");
    settle();
    EXPECT_TRUE(page().isStale());
}

} // namespace
} // namespace patina::tests::accuracy_pages_test
