// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLocale>
#include <QShortcut>

#include "ui/form_fixture.h"

namespace patina::tests::slider_test {

using Slider = Form;
using Number = Form;
using Label = Form;

/// Goes from 0 to 1 in steps of a hundredth.
SliderRange range01() {
    Parameter parameter;
    parameter.min = parameter.softMin = 0.0;
    parameter.max = parameter.softMax = 1.0;
    parameter.step = 0.01;
    return SliderRange(parameter);
}

TEST(SliderRange, StepFromAValueThatWasKeptAsAFloat_ShowsNoneOfItsRounding) {
    Parameter parameter;
    parameter.min = -10000.0;
    parameter.max = 10000.0;
    parameter.step = 0.001;
    const SliderRange range(parameter);
    EXPECT_EQ(range.stepped(double(0.3f), -1.0), 0.299);
    EXPECT_EQ(range.stepped(double(100.1f), 1.0), 100.101);
    EXPECT_EQ(range.stepped(1234.56789, 1.0), 1234.56889);
}

TEST(SliderRange, LogSliderWidenedBothWays_StaysLogarithmic) {
    Parameter parameter;
    parameter.min = 0.0;
    parameter.softMin = 1.0;
    parameter.softMax = 1000.0;
    parameter.max = 1e6;
    parameter.scale = Scale::Log;
    SliderRange range(parameter);
    range.widenFor(0.5);
    range.widenFor(1e6);
    EXPECT_EQ(range.lower(), 0.0);
    EXPECT_EQ(range.upper(), 1e6);
    EXPECT_GT(range.positionOf(64.0) - range.positionOf(20.0), 0.05);
}

TEST(NumberBox, TextForZero_StandsThereUnlessItIsEdited) {
    NumberBox box(2, "m");
    box.setZeroText("automatic");
    box.setValue(0.0);
    EXPECT_EQ(box.text(), "automatic");
    box.setValue(1.5);
    EXPECT_EQ(box.text(), "1.5");
}

TEST_F(Slider, Drag_IsOneStep) {
    drag(slider("roughness"), 0.5, 0.8);
    EXPECT_EQ(fixture.steps(), 1);
    EXPECT_GT(fixture.number("roughness"), 0.7);
}

TEST_F(Slider, UndoOfADrag_ShowsTheStartAgain) {
    drag(slider("roughness"), 0.5, 0.8);
    document.undoStack().undo();
    EXPECT_EQ(slider("roughness")->value(), 0.5);
    EXPECT_EQ(box("roughness")->text(), "0.5");
}

TEST_F(Slider, TwoDrags_AreTwoSteps) {
    drag(slider("roughness"), 0.5, 0.8);
    drag(slider("roughness"), 0.8, 0.3);
    EXPECT_EQ(fixture.steps(), 2);
}

TEST_F(Slider, EscapeDuringADrag_LeavesNoStep) {
    press(slider("roughness"), 0.5);
    move(slider("roughness"), 0.5, 0.9);
    EXPECT_NE(fixture.number("roughness"), 0.5);
    QTest::keyClick(slider("roughness"), Qt::Key_Escape);
    EXPECT_EQ(fixture.number("roughness"), 0.5);
    EXPECT_EQ(fixture.steps(), 0);
}

TEST_F(Slider, MoveAfterEscape_ChangesNothing) {
    press(slider("roughness"), 0.5);
    move(slider("roughness"), 0.5, 0.9);
    QTest::keyClick(slider("roughness"), Qt::Key_Escape);
    move(slider("roughness"), 0.9, 0.1);
    EXPECT_EQ(fixture.number("roughness"), 0.5);
}

TEST_F(Slider, ShiftDrag_IsTenTimesFiner) {
    drag(slider("roughness"), 0.5, 0.9, Qt::ShiftModifier);
    EXPECT_NEAR(fixture.number("roughness"), 0.54, 0.01);
}

TEST_F(Slider, ControlDrag_SnapsToSteps) {
    drag(slider("tilt"), 0.4, 0.715, Qt::ControlModifier);
    const double tilt = fixture.number("tilt");
    EXPECT_EQ(tilt, std::round(tilt));
}

TEST_F(Slider, ControlDragOverStepsFinerThanPixels_SnapsToRoundNumbers) {
    drag(slider("roughness"), 0.5, 0.7312, Qt::ControlModifier); // 0.01 is about a pixel
    const double twentieths = 20.0 * fixture.number("roughness");
    EXPECT_NEAR(twentieths, std::round(twentieths), 1e-5);
}

TEST_F(Slider, ControlDragOnALogScale_SnapsToNumbersAsRoundAsTheyAreLarge) {
    drag(slider("exponent"), 0.5, 0.9, Qt::ControlModifier);
    const double tens = 0.1 * fixture.number("exponent");
    EXPECT_GT(tens, 10.0);
    EXPECT_EQ(tens, std::round(tens));
}

TEST_F(Slider, ControlDragFromPixelToPixel_StaysAndThenGoesOn) {
    const double there = range01().snappedValueAt(0.5, 6.0 / 150.0);
    EXPECT_EQ(range01().snappedValueAt(0.5 + 2.0 / 150.0, 6.0 / 150.0), there);
    EXPECT_NE(range01().snappedValueAt(0.5 + 8.0 / 150.0, 6.0 / 150.0), there);
}

TEST_F(Slider, SnappingWhereStepsAreLong_IsToSingleSteps) {
    EXPECT_DOUBLE_EQ(range01().snappedValueAt(0.137, 0.001), 0.14);
}

TEST_F(Slider, SnappingAtItsEnds_ReachesThem) {
    EXPECT_EQ(range01().snappedValueAt(0.0, 0.04), 0.0);
    EXPECT_EQ(range01().snappedValueAt(1.0, 0.04), 1.0);
}

TEST_F(Slider, PlainDrag_GivesShortNumbers) {
    drag(slider("roughness"), 0.5, 0.7312);
    EXPECT_LE(box("roughness")->text().size(), 5); // "0.735", not "0.7353846"
}

TEST_F(Slider, LogScale_HasTheGeometricMeanInTheMiddle) {
    press(slider("exponent"), 0.5);
    QTest::mouseRelease(slider("exponent"), Qt::LeftButton, {}, at(*slider("exponent"), 0.5));
    EXPECT_NEAR(fixture.number("exponent"), std::sqrt(1000.0), 2.0);
}

TEST_F(Slider, ArrowKey_IsOneStepOfTheDescriptor) {
    slider("roughness")->setFocus();
    QTest::keyClick(slider("roughness"), Qt::Key_Right);
    EXPECT_FLOAT_EQ(static_cast<float>(fixture.number("roughness")), 0.51f);
}

TEST_F(Slider, PageDown_IsTenSteps) {
    QTest::keyClick(slider("roughness"), Qt::Key_PageDown);
    EXPECT_FLOAT_EQ(static_cast<float>(fixture.number("roughness")), 0.4f);
}

TEST_F(Slider, HomeAndEnd_AreTheSoftEnds) {
    QTest::keyClick(slider("roughness"), Qt::Key_End);
    EXPECT_EQ(fixture.number("roughness"), 1.0);
    QTest::keyClick(slider("roughness"), Qt::Key_Home);
    EXPECT_EQ(fixture.number("roughness"), 0.0);
}

TEST_F(Slider, HeldKey_IsOneStep) {
    for (int i = 0; i < 5; ++i) {
        QTest::keyClick(slider("roughness"), Qt::Key_Right);
    }
    EXPECT_EQ(fixture.steps(), 1);
}

TEST_F(Slider, WheelWithoutFocus_ChangesNothing) {
    box("exponent")->setFocus();
    wheel(slider("roughness"), 3);
    wheel(box("roughness"), 3);
    EXPECT_EQ(fixture.number("roughness"), 0.5);
}

TEST_F(Slider, WheelWithFocus_Steps) {
    slider("roughness")->setFocus();
    wheel(slider("roughness"), 3);
    EXPECT_FLOAT_EQ(static_cast<float>(fixture.number("roughness")), 0.53f);
}

TEST_F(Slider, IntParameter_StaysWhole) {
    drag(slider("samples"), 0.2, 0.77);
    EXPECT_TRUE(std::holds_alternative<int>(fixture.value("samples")));
}

TEST_F(Slider, Drag_CostsLessThanHalfAMillisecondATick) {
    press(slider("roughness"), 0.0);
    constexpr int ticks = 400;
    const std::clock_t start = std::clock();
    for (int i = 0; i < ticks; ++i) {
        document.setValue(fixture.model(), "roughness", (i % 2) * 0.25 + i * 1e-4);
    }
    const double milliseconds =
        1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / ticks;
    QTest::mouseRelease(slider("roughness"), Qt::LeftButton);
    EXPECT_EQ(box("roughness")->text(), "0.29"); // the form did follow
    RecordProperty("milliseconds", std::to_string(milliseconds));
    EXPECT_LT(milliseconds, 0.5);
}

TEST_F(Slider, ItsKeys_WinOverShortcutsOfTheWindow) {
    bool isTriggered = false;
    auto* shortcut = new QShortcut(QKeySequence(Qt::Key_Home), &window);
    QObject::connect(shortcut, &QShortcut::activated, [&] { isTriggered = true; });
    slider("roughness")->setFocus();
    QTest::keyClick(slider("roughness"), Qt::Key_Home);
    EXPECT_FALSE(isTriggered);
    EXPECT_EQ(fixture.number("roughness"), 0.0);
}

TEST_F(Slider, RowThatGoesWhileKeysRest_EndsTheInteraction) {
    QTest::keyClick(slider("roughness"), Qt::Key_Right);
    EXPECT_TRUE(document.interaction().isGoingOn());
    document.setModel(Side::A, "second");
    EXPECT_FALSE(document.interaction().isGoingOn());
}

/// Drags a row's label sideways in small moves.
void scrub(QWidget* label, int pixels, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const QPoint start(4, label->height() / 2);
    QTest::mousePress(label, Qt::LeftButton, modifiers, start);
    constexpr int moves = 6;
    for (int i = 1; i <= moves; ++i) {
        const QPoint place = start + QPoint(pixels * i / moves, 0);
        QMouseEvent move(QEvent::MouseMove, place, label->mapToGlobal(place), Qt::NoButton,
                         Qt::LeftButton, modifiers);
        QApplication::sendEvent(label, &move);
    }
}

void release(QWidget* label) {
    QTest::mouseRelease(label, Qt::LeftButton);
}

TEST_F(Label, DraggedSideways_ChangesTheNumberInOneStep) {
    scrub(row("roughness").label(), 60);
    release(row("roughness").label());
    EXPECT_NEAR(fixture.number("roughness"), 0.7, 0.005); // 60 of the 300 pixels of the range
    EXPECT_EQ(fixture.steps(), 1);
}

TEST_F(Label, DraggedWithShift_IsTenTimesFiner) {
    scrub(row("roughness").label(), 60, Qt::ShiftModifier);
    release(row("roughness").label());
    EXPECT_NEAR(fixture.number("roughness"), 0.52, 0.001);
}

TEST_F(Label, DraggedWithControl_SnapsToSteps) {
    scrub(row("tilt").label(), 37, Qt::ControlModifier);
    release(row("tilt").label());
    EXPECT_EQ(fixture.number("tilt"), std::round(fixture.number("tilt")));
}

TEST_F(Label, DraggedPastTheSlidersEnd_GoesOnAndWidensIt) {
    scrub(row("roughness").label(), 600);
    release(row("roughness").label());
    EXPECT_NEAR(fixture.number("roughness"), 2.5, 0.01);
    EXPECT_GE(slider("roughness")->range().upper(), 2.5);
}

TEST_F(Label, DraggedFarPastTheHardRange_StopsAtIt) {
    scrub(row("roughness").label(), 60000);
    release(row("roughness").label());
    EXPECT_EQ(fixture.number("roughness"), 10.0);
}

TEST_F(Label, EscapeDuringADrag_LeavesNoStep) {
    scrub(row("roughness").label(), 60);
    EXPECT_NE(fixture.number("roughness"), 0.5);
    QTest::keyClick(row("roughness").label(), Qt::Key_Escape);
    EXPECT_EQ(fixture.number("roughness"), 0.5);
    EXPECT_EQ(fixture.steps(), 0);
    release(row("roughness").label());
}

TEST_F(Label, EscapeAfterADragPastTheSlidersEnd_GivesTheSliderItsRangeBack) {
    document.setValue(fixture.model(), "roughness", 0.75);
    scrub(row("roughness").label(), 600);
    ASSERT_GT(slider("roughness")->range().upper(), 1.0);
    QTest::keyClick(row("roughness").label(), Qt::Key_Escape);
    EXPECT_EQ(slider("roughness")->range().upper(), 1.0);
    release(row("roughness").label());
}

TEST_F(Label, Clicked_ChangesNothing) {
    QTest::mouseClick(row("roughness").label(), Qt::LeftButton);
    EXPECT_EQ(fixture.steps(), 0);
}

TEST_F(Label, OfAWholeNumber_StaysWhole) {
    scrub(row("samples").label(), 41);
    release(row("samples").label());
    EXPECT_TRUE(std::holds_alternative<int>(fixture.value("samples")));
}

TEST_F(Label, OfAChoice_IsNoHandle) {
    EXPECT_NE(row("mode").label()->cursor().shape(), Qt::SizeHorCursor);
}

TEST_F(Number, UndoInAnUntouchedBox_IsTheDocuments) {
    document.setValue(fixture.model(), "roughness", 0.75);
    auto* shortcut = new QShortcut(QKeySequence::Undo, &window);
    QObject::connect(shortcut, &QShortcut::activated, [&] { document.undoStack().undo(); });
    box("roughness")->setFocus();
    QTest::keyClick(box("roughness"), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(fixture.number("roughness"), 0.5);
}

TEST_F(Number, TypedBeyondTheSoftRange_WidensTheSlider) {
    type("roughness", "4");
    EXPECT_EQ(fixture.number("roughness"), 4.0);
    EXPECT_GT(slider("roughness")->range().upper(), 4.0);
    EXPECT_TRUE(slider("roughness")->range().isWidenedAbove());
}

TEST_F(Number, Reset_NarrowsTheSliderAgain) {
    type("roughness", "4");
    QTest::keyClick(slider("roughness"), Qt::Key_Backspace);
    EXPECT_EQ(slider("roughness")->range().upper(), 1.0);
}

TEST_F(Number, UndoOfAValueBeyondTheSoftRange_GivesTheSliderItsRangeBack) {
    document.setValue(fixture.model(), "roughness", 0.75);
    type("roughness", "4");
    ASSERT_GT(slider("roughness")->range().upper(), 4.0);
    document.undoStack().undo();
    EXPECT_EQ(slider("roughness")->range().upper(), 1.0);
}

TEST_F(Number, TypedIntoAWidenedSlider_LeavesItsRange) {
    type("roughness", "4");
    const double upper = slider("roughness")->range().upper();
    type("roughness", "0.75");
    EXPECT_EQ(slider("roughness")->range().upper(), upper);
}

TEST_F(Number, OfAnotherMaterialInsideTheSoftRange_NarrowsTheSlider) {
    type("roughness", "4");
    Material other = *document.material(Side::A);
    other.model.parameters["roughness"] = 0.25;
    document.replaceMaterial(Side::A, other, "Preset");
    EXPECT_EQ(slider("roughness")->range().upper(), 1.0);
}

TEST_F(Number, TypedBeyondTheHardRange_StopsAtIt) {
    type("roughness", "1e9");
    EXPECT_EQ(fixture.number("roughness"), 10.0);
    EXPECT_EQ(box("roughness")->text(), "10");
}

TEST_F(Number, CommaInAGermanLocale_IsADecimalMark) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    type("roughness", "0,25");
    QLocale::setDefault(before);
    EXPECT_EQ(fixture.number("roughness"), 0.25);
}

TEST_F(Number, PointInAGermanLocale_IsADecimalMark) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    type("roughness", "0.25");
    QLocale::setDefault(before);
    EXPECT_EQ(fixture.number("roughness"), 0.25);
}

TEST_F(Number, Quotient_IsComputed) {
    type("roughness", "1/4");
    EXPECT_EQ(fixture.number("roughness"), 0.25);
}

TEST_F(Number, Unit_IsConverted) {
    type("tilt", "0.5rad");
    EXPECT_NEAR(fixture.number("tilt"), 28.6479, 1e-4);
}

TEST_F(Number, Nonsense_ChangesNothing) {
    for (const char* text : {"nan", "inf", "1/0", "abc", "1e999", "", "0.5.5"}) {
        type("roughness", text);
    }
    EXPECT_EQ(fixture.steps(), 0);
    EXPECT_EQ(box("roughness")->text(), "0.5");
}

TEST_F(Number, ManyDigits_AreKeptThoughFewAreShown) {
    type("roughness", "0.123456789");
    slider("roughness")->setFocus();
    EXPECT_EQ(box("roughness")->text(), "0.123");
    EXPECT_EQ(static_cast<float>(fixture.number("roughness")), 0.123456789f);
}

TEST_F(Number, PassingThrough_DoesNotRound) {
    document.setValue(fixture.model(), "roughness", 0.123456789);
    box("roughness")->setFocus();
    slider("exponent")->setFocus();
    EXPECT_EQ(fixture.steps(), 1);
    EXPECT_EQ(static_cast<float>(fixture.number("roughness")), 0.123456789f);
}

TEST_F(Number, Escape_TakesTypingBack) {
    box("roughness")->setFocus();
    QTest::keyClicks(box("roughness"), "0.9");
    QTest::keyClick(box("roughness"), Qt::Key_Escape);
    QTest::keyClick(box("roughness"), Qt::Key_Return);
    EXPECT_EQ(fixture.steps(), 0);
}

TEST_F(Number, LeavingTheBox_TakesWhatWasTyped) {
    box("roughness")->setFocus();
    box("roughness")->selectAll();
    QTest::keyClicks(box("roughness"), "0.9");
    slider("exponent")->setFocus();
    EXPECT_FLOAT_EQ(static_cast<float>(fixture.number("roughness")), 0.9f);
}

} // namespace patina::tests::slider_test
