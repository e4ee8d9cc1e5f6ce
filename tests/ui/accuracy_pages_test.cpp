// SPDX-License-Identifier: GPL-3.0-or-later
// The pages beside the chart: all models, and how the time grows.
#include "accuracy/cost_text.h"
#include "accuracy/growth_plot.h"
#include "accuracy/model_list.h"
#include "accuracy/models_page.h"
#include "accuracy/scaling_page.h"
#include "ui/accuracy_fixture.h"

namespace patina::tests {
namespace {

TEST(CostText, Shares_AreWrittenWithoutExponents) {
    EXPECT_EQ(shareText(0.5e-6), "0.00005 %");
    EXPECT_EQ(shareText(1.2e-7), "0.000012 %");
    EXPECT_EQ(shareText(0.99e-8), "under 0.00001 %");
    EXPECT_EQ(shareText(0.031), "3.1 %");
    EXPECT_EQ(shareText(0.17), "17 %");
}

class ModelsPanel : public AccuracyPanel {
  protected:
    ModelsPanel() { pages().setCurrentWidget(&page()); }

    ModelsPage& page() { return *pages().findChild<ModelsPage*>(); }
    ModelList& models() { return *page().findChild<ModelList*>(); }

    /// The first models only: they take long to compile.
    void measureSome() {
        CostSweep::Options options;
        options.size = {16, 16};
        options.pairs.fewest = 3;
        options.pairs.most = 3;
        page().measure(options);
        ASSERT_TRUE(QTest::qWaitFor([this] { return page().costs().size() >= 2; }, waitMs));
        for (QToolButton* button : page().findChildren<QToolButton*>()) {
            if (button->text() == "Stop") {
                button->click();
            }
        }
        ASSERT_TRUE(QTest::qWaitFor([this] { return !page().isMeasuring(); }, waitMs));
    }
};

TEST_F(ModelsPanel, Stopped_KeepsWhatIsMeasured) {
    measureSome();
    EXPECT_TRUE(page().state().startsWith("Stopped")) << page().state().toStdString();
    EXPECT_EQ(models().topLevelItemCount(), static_cast<int>(page().costs().size()));
}

TEST_F(ModelsPanel, OtherScene_PutsItOutOfDate) {
    measureSome();
    document().setModel(Side::A, page().costs().front().model);
    settle();
    EXPECT_FALSE(page().isStale()); // every model was measured with its defaults
    document().setFog("exponential");
    settle();
    EXPECT_TRUE(page().isStale());
}

TEST_F(ModelsPanel, LightLost_IsWrittenAsTheLanguageHasIt) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    models().setCosts({{"matte", "Matte", {}, std::nullopt, 0.255}}, false);
    const QString text = models().topLevelItem(0)->text(models().columnCount() - 1);
    QLocale::setDefault(before);
    EXPECT_EQ(text, "25,5 %");
}

TEST_F(ModelsPanel, SceneThatIsBack_HasItsNumbersAgain) {
    measureSome();
    const std::string first = page().costs().front().model;
    document().setFog("exponential");
    settle();
    measureSome();
    EXPECT_FALSE(page().isStale());
    document().undoStack().undo();
    settle();
    EXPECT_FALSE(page().isStale()) << first;
    EXPECT_EQ(models().topLevelItemCount(), static_cast<int>(page().costs().size()));
}

TEST_F(ModelsPanel, Enter_GivesTheObjectThatModel) {
    measureSome();
    models().setCurrentItem(models().topLevelItem(1));
    const QString model = models().currentItem()->data(0, Qt::UserRole).toString();
    QTest::keyClick(&models(), Qt::Key_Return);
    EXPECT_EQ(document().material(Side::A)->model.id, model.toStdString());
}

TEST_F(ModelsPanel, ExportedTable_HasALineForEveryModel) {
    measureSome();
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

TEST_F(ScalingPanel, Laws_AreWrittenAsTheLanguageHasThem) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    ScalingCurve curve{ScalingCurve::Axis::Lights,
                       {{1, {2.5, 2.5, 2.5}}, {4, {4, 4, 4}}, {64, {34, 34, 34}}},
                       std::nullopt};
    curve.law = growthLaw(curve.samples);
    GrowthPlot plot(curve.axis);
    plot.setCurve(curve, false);
    QLocale::setDefault(before);
    EXPECT_EQ(plot.law(), "linear: 2 ms + 0,5 ms per light, R² 1,000");
}

TEST_F(ScalingPanel, SceneThatIsBack_HasItsNumbersAgain) {
    ASSERT_TRUE(measureSmall());
    const std::vector<ScalingCurve> first = page().curves();
    document().setFog("exponential");
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
    ASSERT_TRUE(document().saveScene(home("saved.patina-scene.json")));
    settle();
    EXPECT_FALSE(page().isStale());
    EXPECT_EQ(page().curves().size(), 3u);
}

TEST_F(ScalingPanel, OtherDocument_HasNoneOfItsNumbers) {
    ASSERT_TRUE(document().saveScene(home("one.patina-scene.json")));
    ASSERT_TRUE(measureSmall());
    document().startFrom(Scene(document().scene()));
    document().setFog("exponential");
    settle();
    EXPECT_TRUE(page().curves().empty());
    ASSERT_TRUE(document().openScene(home("one.patina-scene.json")));
    settle();
    EXPECT_EQ(page().curves().size(), 3u);
}

TEST_F(ScalingPanel, ChangedScene_PutsItOutOfDate) {
    ASSERT_TRUE(measureSmall());
    EXPECT_FALSE(page().isStale());
    document().setFog("exponential");
    settle();
    EXPECT_TRUE(page().isStale());
}

} // namespace
} // namespace patina::tests
