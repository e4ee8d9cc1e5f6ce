// SPDX-License-Identifier: GPL-3.0-or-later
// A value that is dragged across what makes an effect needless.
#include <algorithm>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>

#include <QDockWidget>
#include <QTest>

#include "docks/picture_grid.h"
#include "document/scene_edits.h"
#include "parameters/parameter_row.h"
#include "ui/window_fixture.h"

namespace patina::tests::frozen_effects_test {
namespace {

struct Dragged {
    std::string name;
    std::string_view kind;
    std::string parameterId;
    Value without; ///< leaves the effect out
    Value with;
    std::string effect; ///< how the report calls it, or the start of that

    friend std::ostream& operator<<(std::ostream& out, const Dragged& dragged) {
        return out << dragged.name;
    }
};

class FrozenEffectss : public WindowFixture, public testing::WithParamInterface<Dragged> {
  protected:
    FrozenEffectss() {
        document().setBlock(pathOf(kinds::fog), "exponential");
        while (document().scene().lights.size() > 1) {
            removeLight(document(), 1);
        }
        set(GetParam().without);
        newFrames();
    }

    BlockPath path() { return document().selection().currentPath(GetParam().kind); }
    void set(const Value& value) { document().setValue(path(), GetParam().parameterId, value); }
    int press() {
        const int token =
            document().interaction().begin(ParameterTarget{path(), GetParam().parameterId});
        newFrames();
        return token;
    }

    /// Programs compiled when the view shows this value.
    int compiledFor(const Value& value) {
        set(value);
        EXPECT_EQ(newFrames(), 1);
        return view().frames().report().compiled;
    }

    bool isInTheShader() {
        const std::vector<std::string>& effects = view().frames().report().effects;
        return std::any_of(effects.begin(), effects.end(), [](const std::string& effect) {
            return effect.starts_with(GetParam().effect);
        });
    }
};

TEST_P(FrozenEffectss, PressWithoutWarning_WaitsForPrograms) {
    const int before = view().frames().waitCount();
    press();
    EXPECT_EQ(view().frames().waitCount(), before + 1); // or the next test could not fail
}

TEST_P(FrozenEffectss, PressAfterPrewarming_WaitsForNothing) {
    Q_EMIT document().valueApproached({path(), GetParam().parameterId});
    EXPECT_EQ(newFrames(), 0);
    const int before = view().frames().waitCount();
    press();
    EXPECT_EQ(view().frames().waitCount(), before);
    EXPECT_TRUE(isInTheShader());
    EXPECT_EQ(view().frames().report().compiled, 0);
}

TEST_P(FrozenEffectss, Prewarming_LeavesTheReport) {
    const std::vector<std::string> before = view().frames().report().effects;
    Q_EMIT document().valueApproached({path(), GetParam().parameterId});
    newFrames();
    EXPECT_EQ(view().frames().report().effects, before);
}

TEST_P(FrozenEffectss, DragAcrossZero_CompilesNothing) {
    press();
    EXPECT_EQ(compiledFor(GetParam().with), 0);
    EXPECT_EQ(compiledFor(GetParam().without), 0);
}

TEST_P(FrozenEffectss, PressAndDrag_HaveTheEffectInTheShader) {
    press();
    EXPECT_TRUE(isInTheShader());
    compiledFor(GetParam().with);
    compiledFor(GetParam().without);
    EXPECT_TRUE(isInTheShader());
}

TEST_P(FrozenEffectss, DragThatEndsAtZero_LeavesTheEffectOut) {
    const int token = press();
    compiledFor(GetParam().with);
    compiledFor(GetParam().without);
    document().interaction().end(token);
    newFrames();
    EXPECT_FALSE(isInTheShader());
}

INSTANTIATE_TEST_SUITE_P(
    Values, FrozenEffectss,
    testing::Values(Dragged{"Intensity", kinds::lights, "intensity", 0.0, 2.0, "lights/"},
                    Dragged{"Opacity", settings::material, "opacity", 1.0, 0.5, "opacity"},
                    Dragged{"Ambient", settings::scene, "ambient", glm::dvec3(0.0), glm::dvec3(0.5),
                            "ambient"},
                    Dragged{"Density", kinds::fog, "density", 0.0, 0.5, "fog/"}),
    [](const auto& tested) { return tested.param.name; });

class HeldValue : public WindowFixture {};

TEST_F(HeldValue, OrdinaryValue_IsNotHeld) {
    document().interaction().begin(
        ParameterTarget{document().selection().currentPath(settings::scene), "background"});
    EXPECT_EQ(window().effects().scene(Side::A), nullptr);
    EXPECT_EQ(newFrames(), 0);
}

/// What is prewarmed when the pointer comes to a row.
class Prewarming : public WindowFixture {
  protected:
    ParameterRow& row(const std::string& id, const QString& dock) {
        window().dock(dock)->show();
        window().dock(dock)->raise(); // docks are filled when they are first seen
        QApplication::processEvents();
        for (auto* row : window().findChildren<ParameterRow*>()) {
            if (row->parameter().id == id) {
                return *row;
            }
        }
        throw std::runtime_error("no row " + id);
    }
    /// How many states are asked for; waits for `wanted` of them.
    int prewarmedAfter(const std::function<void()>& event, int wanted = 0) {
        int count = 0;
        const auto connection = QObject::connect(&window().effects(), &ProgramEffects::prewarmed,
                                                 [&count] { ++count; });
        event();
        QTest::qWait(restMs);
        (void)QTest::qWaitFor([&] { return count >= wanted; }, longestMs);
        QObject::disconnect(connection);
        return count;
    }
    void hover(ParameterRow& row) {
        QEnterEvent event({1, 1}, {1, 1}, row.mapToGlobal(QPointF(1, 1)));
        QApplication::sendEvent(&row, &event);
    }

    static constexpr int restMs = 200;
    static constexpr int longestMs = 20000;
};

TEST_F(Prewarming, PointerThatRestsOnARow_Asks) {
    EXPECT_GT(prewarmedAfter([this] { hover(row("opacity", "opacity")); }, 1), 0);
}

TEST_F(Prewarming, PointerThatPassesARow_AsksNothing) {
    ParameterRow& passed = row("opacity", "opacity");
    EXPECT_EQ(prewarmedAfter([&] {
                  hover(passed);
                  QEvent leave(QEvent::Leave);
                  QApplication::sendEvent(&passed, &leave);
              }),
              0);
}

TEST_F(Prewarming, RowOfAnOrdinaryValue_AsksNothing) {
    EXPECT_EQ(prewarmedAfter([this] { hover(row("background", "scene")); }), 0);
}

/// Without any the picture is shown by a program that does not multiply.
TEST_F(Prewarming, RowOfTheExposure_Asks) {
    EXPECT_GT(prewarmedAfter([this] { hover(row("exposure", "scene")); }, 1), 0);
}

/// A model is made ready before it is clicked, so that the swap itself compiles nothing.
TEST_F(Prewarming, PointerThatRestsOnAModel_HasItsProgramsMade) {
    auto* grid = window().dock("models")->findChild<PictureGrid*>();
    const std::string current = document().material(Side::A)->model.id;
    const bool isFirst = grid->keyOf(grid->item(0)).toStdString() == current;
    QListWidgetItem* other = grid->item(isFirst ? 1 : 0);
    const int waits = view().frames().waitCount();
    const QPoint place = grid->visualItemRect(other).center();
    const int asked = prewarmedAfter([&] { QTest::mouseMove(grid->viewport(), place); }, 1);
    ASSERT_EQ(asked, 1);
    newFrames();
    QTest::mouseClick(grid->viewport(), Qt::LeftButton, Qt::NoModifier, place);
    newFrames();
    EXPECT_EQ(document().material(Side::A)->model.id, grid->keyOf(other).toStdString());
    EXPECT_EQ(view().frames().report().compiled, 0);
    EXPECT_EQ(view().frames().waitCount(), waits);
}

TEST_F(HeldValue, AnotherValueThatChangesMeanwhile_GetsItsEffect) {
    const BlockPath scene = document().selection().currentPath(settings::scene);
    document().setValue(scene, "ambient", glm::dvec3(0.0));
    document().interaction().begin(
        ParameterTarget{document().selection().currentPath(settings::material), "opacity"});
    document().setValue(scene, "ambient", glm::dvec3(0.5));
    newFrames();
    const std::vector<std::string>& effects = view().frames().report().effects;
    EXPECT_NE(std::find(effects.begin(), effects.end(), "ambient"), effects.end());
}

} // namespace
} // namespace patina::tests::frozen_effects_test
