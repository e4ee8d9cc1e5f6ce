// SPDX-License-Identifier: GPL-3.0-or-later
// The list of effects: why each is in, what it costs, and the switches of the views.
#include <algorithm>
#include <ctime>
#include <memory>

#include <QDockWidget>
#include <QLabel>
#include <QProgressBar>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "docks/effects_dock.h"
#include "document/scene_edits.h"
#include "ui/window_fixture.h"

namespace patina::tests::effects_dock_test {
namespace {

constexpr int waitMs = 120000;

class EffectsPanel : public WindowFixture {
  protected:
    EffectsPanel() {
        window().dock("effects")->show();
        document().setBlock(pathOf(kinds::fog), "exponential");
        settle();
    }

    EffectsDock& dock() { return *window().dock("effects")->findChild<EffectsDock*>(); }
    QTreeWidget& list() { return *dock().findChild<QTreeWidget*>(); }
    QString total() { return dock().findChild<QLabel*>("total")->text(); }

    /// The row of an effect whose name begins so; null where there is none.
    QTreeWidgetItem* row(const QString& effect) {
        for (QTreeWidgetItemIterator it(&list()); *it; ++it) {
            if ((*it)->data(0, Qt::UserRole).toString().startsWith(effect)) {
                return *it;
            }
        }
        return nullptr;
    }

    void press(const QString& text) {
        for (QToolButton* button : dock().findChildren<QToolButton*>()) {
            if (button->text() == text) {
                button->click();
            }
        }
    }

    /// Waits for the row: the list is filled when the window has time.
    void switchOff(const QString& effect) {
        ASSERT_TRUE(QTest::qWaitFor([&] { return row(effect) != nullptr; }, waitMs))
            << effect.toStdString();
        row(effect)->setCheckState(0, Qt::Unchecked);
        settle();
        newFrames();
    }

    bool isInTheShader(const std::string& effect) {
        for (const std::string& each : view().frames().report().effects) {
            if (each.starts_with(effect)) {
                return true;
            }
        }
        return false;
    }

    /// Measures small frames: the measurement itself is not tested here.
    bool measure() {
        EffectCostMeter::Options options;
        options.size = {64, 64};
        dock().measure(options);
        return QTest::qWaitFor([this] { return !dock().isMeasuring(); }, waitMs);
    }
};

TEST_F(EffectsPanel, List_HasTheEffectsAndWhy) {
    ASSERT_NE(row("models/"), nullptr);
    ASSERT_NE(row("lights/"), nullptr);
    ASSERT_NE(row("fog/"), nullptr);
    EXPECT_TRUE(row("lights/")->text(3).contains("Key")) << row("lights/")->text(3).toStdString();
    EXPECT_EQ(row("lights/")->parent(), row("models/"));
}

TEST_F(EffectsPanel, List_HasWhatIsNotIn) {
    document().setBlock(pathOf(kinds::fog), "");
    settle();
    ASSERT_NE(row("fog"), nullptr);
    EXPECT_EQ(row("fog")->text(3), "The scene has no fog.");
    EXPECT_FALSE(row("fog")->flags() & Qt::ItemIsUserCheckable);
}

/// The model calls it: without one of the material's it takes a default.
TEST_F(EffectsPanel, FilledSlot_SaysWhyItHasNoSwitch) {
    document().setModel(Side::A, "cook-torrance");
    settle();
    ASSERT_NE(row("fresnel/"), nullptr);
    EXPECT_FALSE(row("fresnel/")->flags() & Qt::ItemIsUserCheckable);
    const QString model = row("models/")->text(0);
    EXPECT_TRUE(row("fresnel/")->text(3).endsWith("It goes only with " + model + "."))
        << row("fresnel/")->text(3).toStdString();
}

TEST_F(EffectsPanel, MaterialWithoutImages_HasALabelForThem) {
    ASSERT_NE(row("texture"), nullptr);
    EXPECT_EQ(row("texture")->text(0), "not in: Images");
}

/// The panel and the status line use the same name.
TEST_F(EffectsPanel, Image_IsCalledByWhatItChanges) {
    document().setModel(Side::A, "phong");
    document().setTexture(document().selection().currentPath(kinds::models), "diffuse.color",
                          textureUse("diffuse.color", "/gone.png"));
    settle();
    newFrames();
    settle();
    ASSERT_NE(row("texture/"), nullptr);
    const QString label = row("texture/")->text(0);
    EXPECT_TRUE(label.startsWith("Image of ")) << label.toStdString();
    EXPECT_FALSE(label.contains("diffuse.color"));
    const auto saysIt = [this] { return row("texture/")->text(3).contains("placeholder"); };
    EXPECT_TRUE(QTest::qWaitFor(saysIt, waitMs)) << row("texture/")->text(3).toStdString();
    // The line follows the frames a few times a second, and the last of them always.
    const auto* line = window().findChild<QLabel*>("statusEffects");
    EXPECT_TRUE(QTest::qWaitFor([&] { return line->text().contains(label); }, waitMs))
        << line->text().toStdString();
    EXPECT_FALSE(line->text().contains('/')) << line->text().toStdString();
}

TEST_F(EffectsPanel, Shadows_AreNamedUnderTheirLight) {
    document().setBlock(pathOf(kinds::shadows, 0), "hard");
    settle();
    ASSERT_NE(row("shadows/hard"), nullptr);
    EXPECT_EQ(row("shadows/hard")->text(0), "Hard shadows");
    EXPECT_EQ(row("shadows/hard")->parent(), row("lights/"));
}

TEST_F(EffectsPanel, SwitchedOffShadows_AreNotInTheViewsShader) {
    document().setBlock(pathOf(kinds::shadows, 0), "hard");
    newFrames();
    ASSERT_TRUE(isInTheShader("shadows/"));
    settle();
    switchOff("shadows/");
    EXPECT_FALSE(isInTheShader("shadows/"));
    EXPECT_TRUE(isInTheShader("lights/"));
}

/// Milliseconds that this thread has worked.
double workedMs() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

/// Other threads draw the frames: the window's own has next to nothing to do between two turns, by
/// its own clock, which does not depend on what else the machine does.
TEST_F(EffectsPanel, WhileMeasuring_TheWindowAnswers) {
    document().setBlock(pathOf(kinds::shadows, 0), "soft");
    settle();
    newFrames();
    dock().measure();
    double longest = 0.0;
    double before = workedMs();
    QTimer tick;
    QObject::connect(&tick, &QTimer::timeout, [&] {
        longest = std::max(longest, workedMs() - before);
        before = workedMs();
    });
    tick.start(5);
    QTest::qWait(2000);
    press("Cancel");
    ASSERT_TRUE(QTest::qWaitFor([this] { return !dock().isMeasuring(); }, waitMs));
    EXPECT_GT(longest, 0.0);
    EXPECT_LT(longest, 100.0);
}

TEST_F(EffectsPanel, SwitchedOffEffect_IsNotInTheViewsShader) {
    newFrames();
    ASSERT_TRUE(isInTheShader("fog/"));
    switchOff("fog/");
    EXPECT_FALSE(isInTheShader("fog/"));
}

TEST_F(EffectsPanel, Switch_IsNoEdit) {
    const int steps = document().undoStack().count();
    const Scene before = document().scene();
    switchOff("fog/");
    EXPECT_EQ(document().undoStack().count(), steps);
    EXPECT_EQ(document().scene(), before);
}

TEST_F(EffectsPanel, Export_HasWhatIsSwitchedOff) {
    newFrames();
    const Image before = view().capture().picture(true);
    switchOff("lights/");
    EXPECT_EQ(view().capture().picture(true).pixels, before.pixels);
}

TEST_F(EffectsPanel, SwitchedOffEffect_IsSaidInTheStatusLine) {
    auto* note = window().findChild<QToolButton*>("switchedOff");
    EXPECT_FALSE(note->isVisible());
    switchOff("fog/");
    EXPECT_TRUE(note->isVisible());
    EXPECT_EQ(note->text(), "1 effect off");
}

TEST_F(EffectsPanel, AllOn_ShowsEverythingAgain) {
    switchOff("fog/");
    press("All on");
    settle();
    newFrames();
    EXPECT_TRUE(isInTheShader("fog/"));
    EXPECT_EQ(row("fog/")->checkState(0), Qt::Checked);
}

TEST_F(EffectsPanel, AnotherDocument_HasEverythingOnAndNoCosts) {
    ASSERT_TRUE(measure());
    switchOff("fog/");
    Scene other = document().scene();
    other.ambient = glm::dvec3(0.3);
    window().documentFiles().startFrom(other);
    settle();
    newFrames();
    EXPECT_TRUE(isInTheShader("fog/"));
    EXPECT_EQ(row("fog/")->checkState(0), Qt::Checked);
    EXPECT_FALSE(window().findChild<QToolButton*>("switchedOff")->isVisible());
    EXPECT_EQ(row("fog/")->text(1), "");
    EXPECT_EQ(total(), "Costs are not measured yet.");
}

TEST_F(EffectsPanel, ValueDraggedWhileAnotherEffectIsOff_IsShown) {
    switchOff("fog/");
    document().setValue(document().selection().currentPath(settings::scene), "ambient",
                        glm::dvec3(0.7));
    EXPECT_EQ(newFrames(), 1);
    EXPECT_FALSE(isInTheShader("fog/"));
}

/// The panel with costs, which are measured once for all tests that only look at them.
class MeasuredEffects : public testing::Test {
  protected:
    static void SetUpTestSuite() { shared() = std::make_unique<Panel>(); }
    static void TearDownTestSuite() { shared().reset(); }
    void SetUp() override { ASSERT_TRUE(shared()->isMeasured); }

    QTreeWidgetItem* row(const QString& effect) { return shared()->row(effect); }
    QString total() { return shared()->total(); }

  private:
    class Panel : public EffectsPanel {
      public:
        using EffectsPanel::row;
        using EffectsPanel::total;
        const bool isMeasured = measure();

      private:
        void TestBody() override {}
    };

    static std::unique_ptr<Panel>& shared() {
        static std::unique_ptr<Panel> made;
        return made;
    }
};

TEST_F(MeasuredEffects, ShowCostsAndTheTotal) {
    EXPECT_FALSE(row("models/")->text(1).isEmpty());
    EXPECT_TRUE(total().contains("the rest")) << total().toStdString();
    EXPECT_TRUE(total().contains("pixels")) << total().toStdString();
}

TEST_F(MeasuredEffects, ShowWhatIsPredictedForOtherCards) {
    constexpr int cycles = 4;
    EXPECT_GT(row("fog/")->text(cycles).toDouble(), 0.0) << row("fog/")->text(cycles).toStdString();
    EXPECT_TRUE(row("fog/")->toolTip(cycles).contains("Predicted"));
    EXPECT_EQ(row("fresnel/")->text(cycles), "in Cook-Torrance") << "it goes only with its model";
}

TEST_F(EffectsPanel, CostsOfTooFewFrames_AreMarked) {
    dock().measure();
    const auto* progress = dock().findChild<QProgressBar*>();
    ASSERT_TRUE(QTest::qWaitFor(
        [progress] { return 100 * progress->value() >= 15 * progress->maximum(); }, waitMs));
    press("Cancel");
    ASSERT_TRUE(QTest::qWaitFor([this] { return !dock().isMeasuring(); }, waitMs));
    EXPECT_TRUE(row("models/")->text(1).endsWith("!")) << row("models/")->text(1).toStdString();
    EXPECT_TRUE(row("models/")->toolTip(1).contains("too few")) << total().toStdString();
}

TEST_F(EffectsPanel, CancelledMeasurement_SaysThatItStopped) {
    dock().measure();
    press("Cancel");
    ASSERT_TRUE(QTest::qWaitFor([this] { return !dock().isMeasuring(); }, waitMs));
    EXPECT_TRUE(total().startsWith("Stopped")) << total().toStdString();
}

TEST_F(EffectsPanel, ChangedScene_PutsTheCostsOutOfDate) {
    dock().measure();
    press("Cancel");
    ASSERT_TRUE(QTest::qWaitFor([this] { return !dock().isMeasuring(); }, waitMs));
    document().setValue(document().selection().currentPath(settings::scene), "ambient",
                        glm::dvec3(0.7));
    settle();
    EXPECT_TRUE(total().startsWith("Out of date")) << total().toStdString();
}

TEST_F(EffectsPanel, BlocksThatAreReadAgainAsTheyWere_LeaveTheCostsFresh) {
    dock().measure();
    press("Cancel");
    ASSERT_TRUE(QTest::qWaitFor([this] { return !dock().isMeasuring(); }, waitMs));
    document().setCatalog(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())));
    settle();
    EXPECT_TRUE(total().startsWith("Stopped")) << total().toStdString();
}

TEST_F(EffectsPanel, CostsOfAnotherObject_AreNotCalledThoseOfAnotherScene) {
    addObject(document(), document().scene().objects.front());
    document().selection().setObject(0);
    dock().measure();
    press("Cancel");
    ASSERT_TRUE(QTest::qWaitFor([this] { return !dock().isMeasuring(); }, waitMs));
    document().selection().setObject(1);
    settle();
    EXPECT_EQ(total(), "Out of date: the costs were measured of another object.");
}

TEST_F(EffectsPanel, Keyboard_SwitchesTheCurrentRow) {
    list().setFocus();
    list().setCurrentItem(row("fog/"));
    QTest::keyClick(&list(), Qt::Key_Space);
    settle();
    newFrames();
    EXPECT_FALSE(isInTheShader("fog/"));
}

} // namespace
} // namespace patina::tests::effects_dock_test
