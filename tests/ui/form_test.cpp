// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QToolButton>

#include "parameters/color_fields.h"
#include "parameters/color_picker.h"
#include "parameters/color_swatch.h"
#include "parameters/hex_box.h"
#include "parameters/number_format.h"
#include "parameters/parameter_section.h"
#include "parameters/row_mark.h"
#include "parameters/warning_mark.h"
#include "ui/form_fixture.h"

namespace patina::tests::form_test {

TEST_F(Form, FirstModel_HasARowForEachParameter) {
    EXPECT_EQ(form->rows().size(), document.block(fixture.model())->parameters.size());
}

TEST(ShownUnit, RaisesExponentsAndNoOtherDigits) {
    EXPECT_EQ(shownUnit("1/m2"), "1/m\u00b2");
    EXPECT_EQ(shownUnit("m3"), "m\u00b3");
    EXPECT_EQ(shownUnit("kg/m3 K2"), "kg/m\u00b3 K\u00b2");
    EXPECT_EQ(shownUnit("px/512"), "px/512");
    EXPECT_EQ(shownUnit("px/32"), "px/32");
    EXPECT_EQ(shownUnit("m25"), "m25");
    EXPECT_EQ(shownUnit("deg"), "\u00b0");
}

TEST_F(Form, Backspace_ResetsUndoably) {
    document.setValue(fixture.model(), "roughness", 0.75);
    QTest::keyClick(slider("roughness"), Qt::Key_Backspace);
    EXPECT_EQ(fixture.number("roughness"), 0.5);
    document.undoStack().undo();
    EXPECT_EQ(fixture.number("roughness"), 0.75);
}

TEST_F(Form, BackspaceOnAChoice_ResetsIt) {
    document.setValue(fixture.model(), "mode", std::string("fancy"));
    QTest::keyClick(row("mode").findChild<QComboBox*>(), Qt::Key_Backspace);
    EXPECT_EQ(fixture.value("mode"), Value(std::string("plain")));
}

TEST_F(Form, DoubleClickOnTheLabel_Resets) {
    document.setValue(fixture.model(), "roughness", 0.75);
    QTest::mouseDClick(row("roughness").label(), Qt::LeftButton);
    EXPECT_EQ(fixture.number("roughness"), 0.5);
}

TEST_F(Form, ChangedValue_HasAMarkThatResets) {
    auto* mark = row("roughness").findChild<RowMark*>("reset");
    EXPECT_FALSE(mark->isVisible());
    document.setValue(fixture.model(), "roughness", 0.75);
    EXPECT_TRUE(mark->isVisible());
    QTest::mouseClick(mark, Qt::LeftButton);
    EXPECT_EQ(fixture.number("roughness"), 0.5);
    EXPECT_FALSE(mark->isVisible());
}

TEST_F(Form, AsNarrowAsItCanBe_ShowsItsResetMarks) {
    document.setValue(fixture.model(), "roughness", 0.75);
    ASSERT_LT(form->minimumSizeHint().width(), 300);
    form->resize(form->minimumSizeHint().width(), form->height());
    QTest::qWait(50); // a layout that was put off
    const auto* mark = row("roughness").findChild<RowMark*>("reset");
    const QRect place(mark->mapTo(form, QPoint()), mark->size());
    EXPECT_TRUE(form->rect().contains(place)) << place.right() << " of " << form->width();
}

TEST_F(Form, Widened_HasItsLabelsAsWideAsBefore) {
    const int before = row("roughness").label()->width();
    form->resize(form->minimumSizeHint().width(), form->height());
    QTest::qWait(50); // a layout that was put off
    EXPECT_LT(row("roughness").label()->width(), before);
    form->resize(420, form->height());
    QTest::qWait(50);
    EXPECT_EQ(row("roughness").label()->width(), before);
}

TEST_F(Form, RowThatDoesNotCount_IsFoldedAndCanBeOpened) {
    EXPECT_TRUE(row("strength").isFolded());
    EXPECT_TRUE(row("strength").isVisible());
    EXPECT_FALSE(slider("strength")->isVisible());
    QTest::mouseClick(row("strength").findChild<QToolButton*>("fold"), Qt::LeftButton);
    EXPECT_TRUE(slider("strength")->isVisible());
}

TEST_F(Form, ConditionMet_UnfoldsTheRow) {
    document.setValue(fixture.model(), "mode", std::string("fancy"));
    EXPECT_FALSE(row("strength").isFolded());
    EXPECT_TRUE(slider("strength")->isVisible());
    document.undoStack().undo();
    EXPECT_TRUE(row("strength").isFolded());
}

TEST_F(Form, RowThatUnfolds_LeavesLabelsAsWideAsTheyWere) {
    form->resize(form->minimumSizeHint().width() + 1, form->height());
    QTest::qWait(50); // a layout that was put off
    const int before = row("roughness").label()->width();
    document.setValue(fixture.model(), "mode", std::string("fancy"));
    QTest::qWait(50);
    EXPECT_EQ(row("roughness").label()->width(), before);
}

TEST_F(Form, FoldedRow_SaysWhen) {
    EXPECT_TRUE(
        row("strength").findChild<QToolButton*>("fold")->toolTip().contains("Mode is Fancy"));
}

TEST_F(Form, AdvancedParameters_StartFolded) {
    EXPECT_FALSE(row("direction").isVisible());
}

TEST_F(Form, SectionHeader_OpensByKeyboard) {
    for (auto* section : form->findChildren<ParameterSection*>()) {
        if (section->isFolded()) {
            QTest::keyClick(section->header(), Qt::Key_Space);
        }
    }
    EXPECT_TRUE(row("direction").isVisible());
}

TEST_F(Form, ModelSwap_ShowsTheOtherRows) {
    document.setModel(Side::A, "second");
    EXPECT_EQ(form->rows().size(), 2u);
    EXPECT_TRUE(row("gloss").isVisible());
}

TEST_F(Form, ModelSwap_KeepsRowsOfSharedParameters) {
    const ParameterRow* before = form->row("diffuse.color");
    document.setModel(Side::A, "second");
    EXPECT_EQ(form->row("diffuse.color"), before);
}

TEST_F(Form, ModelSwapAndBack_ShowsTheValuesAgain) {
    type("roughness", "0.75");
    document.setModel(Side::A, "second");
    document.setModel(Side::A, "first");
    EXPECT_EQ(slider("roughness")->value(), 0.75);
}

TEST_F(Form, ModelSwap_TakesLessThanTwentyMilliseconds) {
    document.setModel(Side::A, "second"); // warm
    constexpr int swaps = 10;
    const std::clock_t start = std::clock();
    for (int i = 0; i < swaps; ++i) {
        document.setModel(Side::A, i % 2 == 0 ? "first" : "second");
    }
    const double milliseconds =
        1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / swaps;
    RecordProperty("milliseconds", std::to_string(milliseconds));
    EXPECT_LT(milliseconds, 20.0);
}

TEST_F(Form, Choice_SetsTheValue) {
    auto* choice = row("mode").findChild<QComboBox*>();
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_Down);
    EXPECT_EQ(fixture.value("mode"), Value(std::string("fancy")));
    EXPECT_EQ(fixture.steps(), 1);
}

TEST_F(Form, WheelOverAChoiceWithoutFocus_ChangesNothing) {
    slider("roughness")->setFocus();
    wheel(row("mode").findChild<QComboBox*>(), -1);
    EXPECT_EQ(fixture.steps(), 0);
}

TEST_F(Form, CheckBox_SetsTheValue) {
    QTest::keyClick(row("twoSided").findChild<QCheckBox*>(), Qt::Key_Space);
    EXPECT_EQ(fixture.value("twoSided"), Value(true));
    EXPECT_EQ(fixture.steps(), 1);
}

TEST_F(Form, VectorComponent_SetsTheVector) {
    auto* y = row("direction").findChildren<NumberBox*>().at(1);
    Q_EMIT y->typed(0.25);
    EXPECT_EQ(fixture.value("direction"), Value(glm::dvec3(0.0, 0.25, 0.0)));
}

QStringList namesOf(const ParameterRow& row) {
    QStringList names;
    for (const auto* label : row.editor()->findChildren<ScrubLabel*>()) {
        names.append(label->text());
    }
    return names;
}

TEST_F(Form, VectorWithoutNames_ShowsXYZ) {
    EXPECT_EQ(namesOf(row("direction")), (QStringList{"x", "y", "z"}));
}

TEST_F(Form, VectorPerChannel_ShowsTheNamesOfItsDescriptor) {
    fixture.blocks.add("models", "metal", R"({
  "id": "metal", "version": 1, "label": "Metal",
  "parameters": [{"id": "eta", "label": "Index", "type": "vec3", "components": ["R", "G", "B"],
                  "default": [1, 1, 1], "min": 0, "max": 10}]
})",
                       "vec3 metal(Directions d, Metal p) {\n    return p.eta;\n}\n");
    document.setCatalog(fixture.blocks.catalog());
    document.setModel(Side::A, "metal");
    EXPECT_EQ(namesOf(row("eta")), (QStringList{"R", "G", "B"}));
}

TEST_F(Form, ColorOutsideWhatIsReal_Warns) {
    auto* mark = row("diffuse.color").findChild<WarningMark*>();
    EXPECT_FALSE(mark->isVisible());
    document.setValue(fixture.model(), "diffuse.color", glm::dvec3(1.0));
    EXPECT_TRUE(mark->isVisible());
    EXPECT_TRUE(mark->toolTip().contains("Nothing real"));
}

TEST_F(Form, TypedHex_IsTakenAsSrgb) {
    auto* hex = row("diffuse.color").findChild<HexBox*>();
    hex->setFocus();
    hex->selectAll();
    QTest::keyClicks(hex, "#bc8060");
    QTest::keyClick(hex, Qt::Key_Return);
    const auto color = std::get<glm::dvec3>(fixture.value("diffuse.color"));
    EXPECT_NEAR(color.x, 0.5029, 1e-4); // IEC 61966-2-1 of 188/255
}

TEST_F(Form, DragInThePicker_IsOneStep) {
    auto* swatch = row("diffuse.color").findChild<ColorSwatch*>();
    QTest::mouseClick(swatch, Qt::LeftButton);
    auto* field = row("diffuse.color").findChild<SaturationField*>();
    ASSERT_NE(field, nullptr);
    QTest::mousePress(field, Qt::LeftButton, {}, {10, 10});
    for (int i = 0; i < 20; ++i) {
        QTest::mouseMove(field, {10 + 4 * i, 10 + 2 * i});
    }
    QTest::mouseRelease(field, Qt::LeftButton, {}, {90, 50});
    EXPECT_EQ(fixture.steps(), 1);
}

TEST_F(Form, PickerShowsGrey_KeepsTheHue) {
    auto* swatch = row("diffuse.color").findChild<ColorSwatch*>();
    document.setValue(fixture.model(), "diffuse.color", glm::dvec3(0.1, 0.1, 0.8));
    QTest::mouseClick(swatch, Qt::LeftButton);
    auto* strip = row("diffuse.color").findChild<HueStrip*>();
    const double hue = strip->point().x();
    document.setValue(fixture.model(), "diffuse.color", glm::dvec3(0.5));
    EXPECT_EQ(strip->point().x(), hue);
}

TEST_F(Form, Undo_IsShown) {
    drag(slider("roughness"), 0.5, 0.9);
    document.undoStack().undo();
    EXPECT_EQ(slider("roughness")->value(), 0.5);
    document.undoStack().redo();
    EXPECT_GT(slider("roughness")->value(), 0.8);
}

TEST_F(Form, ActiveSide_IsWhatTheFormEdits) {
    fixture.comparison.setComparing(true);
    document.selection().setSide(Side::B);
    type("roughness", "0.75");
    EXPECT_EQ(document.material(Side::A)->model.parameters.at("roughness"), Value(0.5));
    EXPECT_EQ(document.material(Side::B)->model.parameters.at("roughness"), Value(0.75));
}

TEST_F(Form, EverythingThatTakesFocus_HasAnAccessibleName) {
    for (const QWidget* widget : form->findChildren<QWidget*>()) {
        if (!(widget->focusPolicy() & Qt::TabFocus) || widget->window() != &window) {
            continue;
        }
        QAccessibleInterface* interface =
            QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
        ASSERT_NE(interface, nullptr);
        EXPECT_FALSE(interface->text(QAccessible::Name).isEmpty())
            << widget->metaObject()->className();
    }
}

TEST_F(Form, Slider_TellsItsValueAndRange) {
    QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(slider("roughness"));
    EXPECT_EQ(interface->role(), QAccessible::Slider);
    ASSERT_NE(interface->valueInterface(), nullptr);
    EXPECT_EQ(interface->valueInterface()->currentValue().toDouble(), 0.5);
    EXPECT_EQ(interface->valueInterface()->maximumValue().toDouble(), 1.0);
}

TEST_F(Form, Label_IsBuddyOfItsEditor) {
    EXPECT_EQ(row("roughness").label()->buddy(), slider("roughness"));
}

TEST_F(Form, Tab_GoesFromSliderToItsBox) {
    slider("roughness")->setFocus();
    QTest::keyClick(&window, Qt::Key_Tab);
    EXPECT_EQ(QApplication::focusWidget(), box("roughness"));
}

TEST_F(Form, TabAfterASwapAndBack_GoesDownTheForm) {
    document.setModel(Side::A, "second");
    document.setModel(Side::A, "first");
    box("roughness")->setFocus();
    QTest::keyClick(&window, Qt::Key_Tab);
    EXPECT_EQ(QApplication::focusWidget(), slider("exponent"));
}

TEST_F(Form, LargerFont_ClipsNoLabel) {
    QFont large = window.font();
    large.setPointSizeF(large.pointSizeF() * 2.0);
    window.setFont(large);
    window.resize(900, 1400);
    form->setGeometry(0, 0, 900, 1400);
    QApplication::processEvents();
    for (const ParameterRow* shown : form->rows()) {
        const QLabel* label = shown->label();
        EXPECT_GE(label->height(), label->heightForWidth(label->width()))
            << label->text().toStdString();
    }
}

TEST_F(Form, ModelOfTwoFiles_HasAWorkingForm) {
    fixture.blocks.add("models", "mine", R"({
        "id": "mine", "version": 1, "label": "Mine", "summary": "A user's own.",
        "applications": "Tests.", "source": "None", "doc": "A user's own.",
        "parameters": [{"id": "sheen", "label": "Sheen", "type": "float", "default": 0.5,
                        "min": 0, "max": 1, "step": 0.01, "doc": "How much it shines."}],
        "claims": ["finite"]})",
                       "vec3 mine(Directions d, Mine p) {\n    return vec3(p.sheen * d.nl);\n}\n");
    document.setCatalog(fixture.blocks.catalog());
    document.setModel(Side::A, "mine");
    ASSERT_NE(form->row("sheen"), nullptr);
    QApplication::processEvents(); // the new row finds its place
    drag(slider("sheen"), 0.5, 0.9);
    EXPECT_GT(fixture.number("sheen"), 0.8);
}

TEST_F(Form, UnknownModel_SaysThatValuesAreKept) {
    Material material = *document.material(Side::A);
    material.model.id = "nowhere";
    document.replaceMaterial(Side::A, material, "Preset");
    EXPECT_TRUE(form->rows().empty());
    bool isSaid = false;
    for (const QLabel* label : form->findChildren<QLabel*>()) {
        isSaid = isSaid || (label->isVisible() && label->text().contains("nowhere"));
    }
    EXPECT_TRUE(isSaid);
}

} // namespace patina::tests::form_test
