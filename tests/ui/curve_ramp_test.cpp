// SPDX-License-Identifier: GPL-3.0-or-later
// Curves and ramps edited with the mouse and the keyboard, as a hand does it.
#include <QAbstractButton>
#include <QComboBox>
#include <QPushButton>

#include "catalog/curve.h"
#include "catalog/ramp.h"
#include "parameters/color_picker.h"
#include "parameters/handle_area.h"
#include "parameters/preview_button.h"
#include "ui/form_fixture.h"

namespace patina::tests::curve_ramp_test {
namespace {

const char* const drawnModel = R"({
  "id": "drawn", "version": 1, "label": "Drawn", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.",
  "parameters": [
    {"id": "response", "label": "Response", "type": "curve",
     "default": {"points": [[0, 0], [1, 1]]}, "doc": "How dark it gets."},
    {"id": "tones", "label": "Tones", "type": "ramp",
     "default": {"stops": [{"at": 0.25, "color": [0, 0, 0]}, {"at": 0.75, "color": [1, 1, 1]}]},
     "doc": "Its colours."}
  ],
  "claims": ["finite"]
})";

const char* const drawnShader = "// SPDX-License-"
                                "Identifier: MIT-0\n"
                                "#include \"lib/directions.glsl\"\n"
                                "vec3 drawn(Directions d, Drawn p) {\n"
                                "    return drawnTones(drawnResponse(d.nl, p), p);\n}\n";

/// The form of a model with a curve and a ramp, with one of the two popups open.
class Popup : public Form {
  protected:
    Popup() {
        fixture.blocks.add("models", "drawn", drawnModel, drawnShader);
        document.setCatalog(fixture.blocks.catalog());
        document.setModel(Side::A, "drawn");
        before_ = fixture.steps();
    }
    ~Popup() override {
        if (area_) {
            area_->window()->close();
        }
    }

    void open(const std::string& id) {
        auto* button = row(id).findChild<PreviewButton*>();
        QTest::mouseClick(button, Qt::LeftButton);
        area_ = row(id).findChild<HandleArea*>();
        ASSERT_NE(area_, nullptr);
        ASSERT_TRUE(QTest::qWaitForWindowExposed(area_->window()));
    }

    int steps() { return fixture.steps() - before_; }
    CurvePoints points() { return curvePoints(fixture.value("response")); }
    Ramp ramp() { return rampOf(fixture.value("tones")); }

    QPoint pixel(double x, double y = 0.0) const {
        return area_->pixelOf(Handle{x, y, glm::dvec3(0.0)}).toPoint();
    }

    void press(QPoint from) { QTest::mousePress(area_, Qt::LeftButton, {}, from); }
    void moveTo(QPoint to) const {
        QMouseEvent event(QEvent::MouseMove, to, area_->mapToGlobal(to), Qt::NoButton,
                          Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(area_, &event);
    }
    void release(QPoint at) { QTest::mouseRelease(area_, Qt::LeftButton, {}, at); }

    void drag(QPoint from, QPoint to) {
        press(from);
        for (int i = 1; i <= 6; ++i) {
            moveTo(from + (to - from) * i / 6);
        }
        release(to);
    }

    template <class Widget>
    Widget* part(const char* name) const {
        return area_->window()->findChild<Widget*>(name);
    }

    void typeInto(NumberBox* box, const QString& text) {
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, text);
        QTest::keyClick(box, Qt::Key_Return);
    }

    HandleArea* area_ = nullptr;
    int before_ = 0;
};

using CurvePopupTest = Popup;
using RampPopupTest = Popup;

constexpr double aPixel = 0.006;

TEST_F(CurvePopupTest, Click_AddsAPointThere) {
    open("response");
    drag(pixel(0.5, 0.8), pixel(0.5, 0.8));
    ASSERT_EQ(points().size(), 3u);
    EXPECT_NEAR(points()[1].x, 0.5, aPixel);
    EXPECT_NEAR(points()[1].y, 0.8, aPixel);
    EXPECT_EQ(steps(), 1);
}

TEST_F(CurvePopupTest, DragOfAPoint_IsOneStep) {
    open("response");
    drag(pixel(0.0, 0.0), pixel(0.25, 0.5));
    EXPECT_NEAR(points()[0].x, 0.25, aPixel);
    EXPECT_NEAR(points()[0].y, 0.5, aPixel);
    EXPECT_EQ(steps(), 1);
    document.undoStack().undo();
    EXPECT_EQ(points()[0], glm::dvec2(0.0));
    EXPECT_EQ(area_->handles()[0].x, 0.0);
}

TEST_F(CurvePopupTest, PointDraggedPastAnother_SwapsWithItInOneStepAndStaysChosen) {
    open("response");
    drag(pixel(0.5, 0.5), pixel(0.5, 0.5));
    drag(pixel(0.0, 0.0), pixel(0.75, 0.25));
    ASSERT_EQ(points().size(), 3u);
    EXPECT_NEAR(points()[0].x, 0.5, aPixel);
    EXPECT_NEAR(points()[0].y, 0.5, aPixel);
    EXPECT_NEAR(points()[1].x, 0.75, aPixel);
    EXPECT_NEAR(points()[1].y, 0.25, aPixel);
    EXPECT_EQ(area_->chosen(), 1u);
    EXPECT_EQ(steps(), 2);
    document.undoStack().undo();
    EXPECT_EQ(points()[0], glm::dvec2(0.0));
}

TEST_F(CurvePopupTest, PointDraggedPastAnotherAndBack_IsWhereItWas) {
    open("response");
    drag(pixel(0.4, 0.5), pixel(0.4, 0.5));
    drag(pixel(0.6, 0.2), pixel(0.6, 0.2));
    const CurvePoints before = points();
    press(pixel(0.4, 0.5));
    moveTo(pixel(0.8, 0.9));
    ASSERT_EQ(points()[1], before[2]);
    moveTo(pixel(0.4, 0.5));
    release(pixel(0.4, 0.5));
    EXPECT_EQ(points(), before);
    EXPECT_EQ(area_->chosen(), 1u);
}

TEST_F(CurvePopupTest, PointDraggedOntoTheLastOne_StopsBeforeIt) {
    open("response");
    drag(pixel(0.5, 0.5), pixel(0.5, 0.5));
    drag(pixel(0.5, 0.5), pixel(1.0, 0.2));
    ASSERT_EQ(points().size(), 3u);
    EXPECT_NEAR(points()[1].x, 1.0 - minCurveGap, 1e-6);
    EXPECT_EQ(points()[2].x, 1.0);
}

TEST_F(CurvePopupTest, PointDraggedOut_IsRemovedAndComesBackInside) {
    open("response");
    drag(pixel(0.5, 0.8), pixel(0.5, 0.8));
    press(pixel(0.5, 0.8));
    moveTo(pixel(0.5, 0.8) + QPoint(0, -400));
    EXPECT_EQ(points().size(), 2u);
    moveTo(pixel(0.5, 0.6));
    EXPECT_EQ(points().size(), 3u);
    moveTo(pixel(0.5, 0.8) + QPoint(0, -400));
    release(pixel(0.5, 0.8) + QPoint(0, -400));
    EXPECT_EQ(points().size(), 2u);
    EXPECT_EQ(steps(), 2);
}

TEST_F(CurvePopupTest, LastTwoPoints_CannotBeRemoved) {
    open("response");
    drag(pixel(1.0, 1.0), pixel(1.0, 1.0) + QPoint(500, 0));
    QTest::keyClick(area_, Qt::Key_Delete);
    EXPECT_EQ(points().size(), 2u);
}

TEST_F(CurvePopupTest, EscapeDuringADrag_LeavesNoStep) {
    open("response");
    press(pixel(0.0, 0.0));
    moveTo(pixel(0.3, 0.9));
    QTest::keyClick(area_, Qt::Key_Escape);
    EXPECT_EQ(points()[0], glm::dvec2(0.0));
    EXPECT_EQ(steps(), 0);
    EXPECT_TRUE(area_->isVisible());
}

TEST_F(CurvePopupTest, EscapeAfterASwap_BringsTheOrderBack) {
    open("response");
    drag(pixel(0.5, 0.5), pixel(0.5, 0.5));
    const CurvePoints before = points();
    press(pixel(0.0, 0.0));
    moveTo(pixel(0.75, 0.25));
    ASSERT_NEAR(points()[0].x, 0.5, aPixel);
    QTest::keyClick(area_, Qt::Key_Escape);
    EXPECT_EQ(points(), before);
    EXPECT_EQ(steps(), 1);
}

TEST_F(CurvePopupTest, Keys_ChooseMoveAndRemove) {
    open("response");
    drag(pixel(0.5, 0.8), pixel(0.5, 0.8));
    const glm::dvec2 added = points()[1];
    for (int i = 0; i < 5; ++i) {
        QTest::keyClick(area_, Qt::Key_Right);
        QTest::keyClick(area_, Qt::Key_Down);
    }
    EXPECT_NEAR(points()[1].x, added.x + 0.05, 1e-6);
    EXPECT_NEAR(points()[1].y, added.y - 0.05, 1e-6);
    QTest::keyClick(area_, Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_NEAR(points()[1].x, added.x + 0.051, 1e-6);
    QTest::qWait(500); // the keys rest
    EXPECT_EQ(steps(), 2);
    QTest::keyClick(area_, Qt::Key_PageDown);
    EXPECT_EQ(area_->chosen(), 2u);
    QTest::keyClick(area_, Qt::Key_PageUp);
    QTest::keyClick(area_, Qt::Key_Delete);
    EXPECT_EQ(points().size(), 2u);
}

TEST_F(CurvePopupTest, TypedNumbers_AreExact) {
    open("response");
    drag(pixel(0.5, 0.8), pixel(0.5, 0.8));
    typeInto(part<NumberBox>("pointX"), "0.375");
    typeInto(part<NumberBox>("pointY"), "1/8");
    EXPECT_EQ(points()[1], glm::dvec2(0.375, 0.125));
    EXPECT_EQ(steps(), 3);
}

TEST_F(CurvePopupTest, Preset_IsOneStep) {
    open("response");
    QTest::mouseClick(part<QAbstractButton>("steps"), Qt::LeftButton);
    EXPECT_EQ(roundedToFloat(fixture.value("response")),
              roundedToFloat(curveValue(curvePresets()[2].points)));
    QTest::mouseClick(part<QAbstractButton>("linear"), Qt::LeftButton);
    EXPECT_TRUE(isLinear(points()));
    EXPECT_EQ(steps(), 2);
}

TEST_F(CurvePopupTest, SixteenPoints_AreTheMost) {
    open("response");
    for (int i = 1; i < 20; ++i) {
        drag(pixel(i / 20.0, 0.9), pixel(i / 20.0, 0.9));
    }
    EXPECT_EQ(points().size(), maxCurvePoints);
}

TEST_F(RampPopupTest, Click_AddsAStopOfTheColourThere) {
    open("tones");
    drag(pixel(0.5), pixel(0.5));
    ASSERT_EQ(ramp().stops.size(), 3u);
    EXPECT_NEAR(ramp().stops[1].at, 0.5, aPixel);
    EXPECT_NEAR(ramp().stops[1].color.x, 0.5, 2.0 * aPixel);
    EXPECT_EQ(steps(), 1);
}

TEST_F(RampPopupTest, ClickIntoTheColours_AddsAStopToo) {
    open("tones");
    const QPoint above(pixel(0.5).x(), 8);
    drag(above, above);
    EXPECT_EQ(ramp().stops.size(), 3u);
}

TEST_F(RampPopupTest, DragOfAStop_IsOneStepAndKeepsItsColour) {
    open("tones");
    drag(pixel(0.75), pixel(0.9));
    EXPECT_NEAR(ramp().stops[1].at, 0.9, aPixel);
    EXPECT_EQ(ramp().stops[1].color, glm::dvec3(1.0));
    EXPECT_EQ(steps(), 1);
}

TEST_F(RampPopupTest, StopDraggedPastAnother_TakesItsColourAlongInOneStep) {
    open("tones");
    drag(pixel(0.25), pixel(0.9));
    ASSERT_EQ(ramp().stops.size(), 2u);
    EXPECT_EQ(ramp().stops[0].at, 0.75);
    EXPECT_EQ(ramp().stops[0].color, glm::dvec3(1.0));
    EXPECT_NEAR(ramp().stops[1].at, 0.9, aPixel);
    EXPECT_EQ(ramp().stops[1].color, glm::dvec3(0.0));
    EXPECT_EQ(area_->chosen(), 1u);
    EXPECT_NEAR(part<NumberBox>("stopPlace")->value(), 0.9, aPixel);
    EXPECT_EQ(steps(), 1);
}

TEST_F(RampPopupTest, StopDraggedOntoAnother_KeepsADistance) {
    open("tones");
    press(pixel(0.25));
    for (int x = pixel(0.74).x(); x <= pixel(0.76).x(); ++x) {
        moveTo(QPoint(x, pixel(0.25).y()));
        ASSERT_EQ(ramp().stops.size(), 2u);
        EXPECT_GE(ramp().stops[1].at - ramp().stops[0].at, minRampGap - 1e-6);
    }
    release(pixel(0.76));
    EXPECT_EQ(area_->chosen(), 1u);
    EXPECT_EQ(ramp().stops[0].at, 0.75);
}

TEST_F(RampPopupTest, EscapeAfterASwap_BringsTheOrderBack) {
    open("tones");
    press(pixel(0.75));
    moveTo(pixel(0.1));
    ASSERT_EQ(ramp().stops[1].at, 0.25);
    QTest::keyClick(area_, Qt::Key_Escape);
    EXPECT_EQ(ramp().stops[0].at, 0.25);
    EXPECT_EQ(ramp().stops[1].at, 0.75);
    EXPECT_EQ(ramp().stops[1].color, glm::dvec3(1.0));
    EXPECT_EQ(steps(), 0);
}

TEST_F(RampPopupTest, StopDraggedOff_IsRemovedInOneStep) {
    open("tones");
    drag(pixel(0.25), pixel(0.25) + QPoint(0, 90));
    ASSERT_EQ(ramp().stops.size(), 1u);
    EXPECT_EQ(steps(), 1);
    drag(pixel(0.75), pixel(0.75) + QPoint(0, 90));
    EXPECT_EQ(ramp().stops.size(), 1u);
}

TEST_F(RampPopupTest, DoubleClick_OpensTheColourOfTheStop) {
    open("tones");
    QTest::mouseClick(area_, Qt::LeftButton, {}, pixel(0.75));
    QTest::mouseDClick(area_, Qt::LeftButton, {}, pixel(0.75));
    auto* picker = area_->window()->findChild<ColorPicker*>();
    ASSERT_NE(picker, nullptr);
    ASSERT_TRUE(picker->isVisible());
    const int before = steps();
    Q_EMIT picker->edited(glm::dvec3(0.25, 0.5, 0.75));
    EXPECT_EQ(ramp().stops[1].color, glm::dvec3(0.25, 0.5, 0.75));
    EXPECT_EQ(steps(), before + 1);
    picker->hide();
    EXPECT_TRUE(area_->isVisible());
}

TEST_F(RampPopupTest, ColourOfAStop_IsTakenFromTheScreenInOneStep) {
    open("tones");
    QWidget* popup = area_->window();
    QTest::mouseClick(area_, Qt::LeftButton, {}, pixel(0.75));
    QTest::mouseDClick(area_, Qt::LeftButton, {}, pixel(0.75));
    const int before = steps();
    auto* picker = popup->findChild<ColorPicker*>();
    picker->findChild<QPushButton*>()->click();
    EXPECT_FALSE(popup->isVisible());

    QWidget* grabbing = popup->parentWidget();
    QWidget painted(grabbing->window());
    painted.setStyleSheet("background: #ff8000");
    painted.setGeometry(0, 0, 20, 20);
    painted.show();
    const QPoint there = painted.mapToGlobal(QPoint(10, 10));
    QMouseEvent move(QEvent::MouseMove, grabbing->mapFromGlobal(there), there, Qt::NoButton,
                     Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(grabbing, &move);
    EXPECT_NEAR(ramp().stops[1].color.x, 1.0, 1e-6);
    EXPECT_NEAR(ramp().stops[1].color.z, 0.0, 1e-6);
    QTest::keyClick(grabbing, Qt::Key_Return);
    EXPECT_EQ(steps(), before + 1);
    EXPECT_TRUE(popup->isVisible());
    EXPECT_TRUE(picker->isVisible());
    picker->hide();
}

TEST_F(RampPopupTest, Interpolation_IsOneStep) {
    open("tones");
    auto* box = part<QComboBox>("interpolation");
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Down);
    QTest::keyClick(box, Qt::Key_Down);
    EXPECT_EQ(ramp().interpolation, RampInterpolation::Constant);
    EXPECT_EQ(steps(), 2);
}

TEST_F(RampPopupTest, TypedPlace_IsExact) {
    open("tones");
    drag(pixel(0.25), pixel(0.25));
    typeInto(part<NumberBox>("stopPlace"), "0.125");
    EXPECT_EQ(ramp().stops[0].at, 0.125);
}

TEST_F(RampPopupTest, Undo_ShowsTheStopsAgain) {
    open("tones");
    drag(pixel(0.75), pixel(0.9));
    document.undoStack().undo();
    EXPECT_EQ(area_->handles()[1].x, 0.75);
}

} // namespace
} // namespace patina::tests::curve_ramp_test
