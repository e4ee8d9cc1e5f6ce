// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QPushButton>
#include <QTest>

#include "core/color.h"
#include "parameters/color_picker.h"
#include "parameters/color_swatch.h"
#include "ui/window_fixture.h"

namespace patina::tests::eyedropper_test {
namespace {

/// The first colour of the parameters dock, with its eyedropper picking.
class EyedropperTest : public WindowFixture {
  protected:
    ColorSwatch& swatch() { return *window().dock("parameters")->findChild<ColorSwatch*>(); }

    void startPicking() {
        swatch().click();
        auto* picker = window().dock("parameters")->findChild<ColorPicker*>();
        picker->findChild<QPushButton*>()->click();
    }

    /// What the grabbing swatch gets while the pointer is somewhere on the screen.
    void send(QEvent::Type type, QPoint global, Qt::MouseButton button = Qt::NoButton) {
        QMouseEvent event(type, swatch().mapFromGlobal(global), global, button, button,
                          Qt::NoModifier);
        QApplication::sendEvent(&swatch(), &event);
    }

    /// An empty corner of the view, where the background is seen.
    QPoint corner() { return view().mapToGlobal(QPoint(5, 5)); }

    glm::dvec3 color() {
        const BlockPath path = document().selection().currentPath(kinds::models);
        for (const Parameter& parameter : document().block(path)->parameters) {
            if (parameter.type == ParameterType::Color) {
                return std::get<glm::dvec3>(document().value(path, parameter));
            }
        }
        return {};
    }
};

constexpr double halfFloat = 1e-3; // the picture is stored in half floats: 11 bits

TEST_F(EyedropperTest, ClickOnTheView_TakesItsLinearLight) {
    const glm::dvec3 background(0.25, 0.5, 0.125);
    document().setValue(document().selection().currentPath(settings::scene), "background",
                        background);
    document().setValue(document().selection().currentPath(settings::scene), "exposure", 1.0);
    startPicking();
    send(QEvent::MouseMove, corner());
    send(QEvent::MouseButtonRelease, corner(), Qt::LeftButton);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(color()[i], background[i], halfFloat);
    }
}

TEST_F(EyedropperTest, Picking_IsOneStep) {
    startPicking();
    send(QEvent::MouseMove, view().mapToGlobal(view().rect().center()));
    send(QEvent::MouseMove, corner());
    send(QEvent::MouseButtonRelease, corner(), Qt::LeftButton);
    EXPECT_EQ(document().undoStack().count(), 1);
}

TEST_F(EyedropperTest, Escape_GivesUpWithoutAStep) {
    const glm::dvec3 before = color();
    startPicking();
    send(QEvent::MouseMove, corner());
    EXPECT_NE(color(), before);
    QTest::keyClick(&swatch(), Qt::Key_Escape);
    EXPECT_EQ(color(), before);
    EXPECT_EQ(document().undoStack().count(), 0);
}

TEST_F(EyedropperTest, AnyOtherWidget_GivesTheColourItShows) {
    startPicking();
    const QPoint place = window().statusBar()->mapToGlobal(QPoint(1, 1));
    send(QEvent::MouseMove, place);
    const QColor shown =
        window().grab(QRect(window().mapFromGlobal(place), QSize(1, 1))).toImage().pixelColor(0, 0);
    const glm::dvec3 encoded(shown.redF(), shown.greenF(), shown.blueF());
    const glm::dvec3 expected = srgbDecoded(encoded);
    EXPECT_EQ(color(), std::get<glm::dvec3>(roundedToFloat(Value(expected))));
}

TEST_F(EyedropperTest, AfterPicking_ThePickerIsBackAndTheMouseIsFree) {
    startPicking();
    EXPECT_EQ(QWidget::mouseGrabber(), &swatch());
    send(QEvent::MouseMove, corner());
    send(QEvent::MouseButtonRelease, corner(), Qt::LeftButton);
    EXPECT_NE(QWidget::mouseGrabber(), &swatch());
    EXPECT_TRUE(window().dock("parameters")->findChild<ColorPicker*>()->isVisible());
}

} // namespace
} // namespace patina::tests::eyedropper_test
